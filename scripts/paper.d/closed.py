"""closed.py GRID.lhg LH.lhg OUT.lhg - the grid x y z of a pillow as a sum of spherical harmonics of x, y and z, up to the degree
whose bending energy, the integral of H^2, is nearest to that of the stream LH.lhg (lambda, H on the same chart).
Prints the degree and both energies.  The low-pass of the field's habit (SPHARM), on the sphere of our map."""
import math
import os
import subprocess
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
import lhg

MOST = 64


def sphere(g):
    """The unit sphere at the nodes, and its area element: doc/mathematics.md 3.9, by theta functions."""
    u = (np.arange(g.nu) + 0.5)/g.nu
    v = (np.arange(g.nv) + 0.5)*g.T/g.nv
    far = v > g.T/2
    x = 2*np.pi*(u[None] - 0.25 + 1j*np.where(far, g.T - v, v)[:, None])
    t1, t4, sign = 0, 1, 1
    for n in range(40):
        t1 = t1 + sign*(np.exp(-4*np.pi*g.T*(n + 0.5)**2 + 1j*(2*n + 1)*x) - np.exp(-4*np.pi*g.T*(n + 0.5)**2 - 1j*(2*n + 1)*x))/1j
        if n:
            t4 = t4 + sign*(np.exp(-4*np.pi*g.T*n*n + 2j*n*x) + np.exp(-4*np.pi*g.T*n*n - 2j*n*x))
        sign = -sign
    z = t1/t4
    z[far] = 1/np.conj(z[far])
    d = 1 + abs(z)**2
    p = np.stack([2*z.real/d, 2*z.imag/d, (1 - abs(z)**2)/d])
    du = (np.roll(p, -1, 2) - np.roll(p, 1, 2))*g.nu/2
    return p, (du**2).sum(0)*g.T/(g.nu*g.nv)


def harmonics(p, degree):
    """The real spherical harmonics of each degree up to `degree`, orthonormal, as lists."""
    c, angle = p[2], np.arctan2(p[1], p[0])
    s = np.sqrt(np.maximum(1 - c*c, 0))
    rows = [[] for _ in range(degree + 1)]
    top = np.full_like(c, math.sqrt(1/(4*math.pi)))
    for m in range(degree + 1):
        if m:
            top = top*s*math.sqrt((2*m + 1)/(2*m))
        last, here = np.zeros_like(c), top
        for n in range(m, degree + 1):
            for w in (np.cos(m*angle), np.sin(m*angle))[:1 + (m > 0)]:
                rows[n].append(here*w*(math.sqrt(2) if m else 1))
            a = math.sqrt((4*(n + 1)**2 - 1)/((n + 1)**2 - m*m))
            b = math.sqrt((n*n - m*m)/(4*n*n - 1)) if n > m else 0
            last, here = here, a*(c*here - b*last)
    return rows


def bending(g):
    """Of lambda and H: the integral of H^2 over the area."""
    return ((g['lambda']*g['H'])**2).sum()*g.T/(g.nu*g.nv)


def main(grid, filtered, out):
    g = next(iter(lhg.read(grid)))
    goal = bending(next(iter(lhg.read(filtered))))
    p, area = sphere(g)
    x = np.stack([g[k] for k in 'xyz'])
    sums = [np.zeros_like(x)]
    for row in harmonics(p, MOST):
        part = np.zeros_like(x)
        for y in row:
            part += (x*(y*area)).sum((1, 2))[:, None, None]*y
        sums.append(sums[-1] + part)

    def write(degree):
        for k, f in zip('xyz', sums[degree + 1]):
            g.channels[k].data = f
        lhg.write(out, [g])
        lh = subprocess.run(['grid2lh', '-q', '--no-place', '--no-lattice', out], check=True, capture_output=True).stdout
        with open(out + '.lh', 'wb') as f:
            f.write(lh)
        return bending(next(iter(lhg.read(out + '.lh'))))

    low, high = 1, MOST                 # bending grows with the degree
    while high - low > 1:
        middle = (low + high)//2
        low, high = (middle, high) if write(middle) < goal else (low, middle)
    best = min((low, high), key=lambda n: abs(math.log(write(n)/goal)))
    print('%d %.6g %.6g' % (best, write(best), goal))
    os.remove(out + '.lh')


main(*sys.argv[1:])
