"""surface.py - a gridded surface and what is measured of it, for the other scripts of this folder."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
import lhg

RINGS, WIDE = 2, 8      # rings of nodes beside the border that the integrals of H leave out
CORNER = 10             # cells from a corner where folded cells are counted
FOOT_STEPS = 5          # Gauss-Newton steps to the nearest point


def points(grid, names=('x', 'y', 'z')):
    return np.stack([grid[k] for k in names], -1)


def read(path, names=('x', 'y', 'z')):
    """The positions [nv][nu][3] of each grid of a stream, and T of the last."""
    grids = list(lhg.read(path))
    return [points(g, names) for g in grids], grids[-1].T


def write(path, surfaces, T):
    """Writes surfaces as a stream of grids x y z."""
    grids = []
    for k, p in enumerate(surfaces):
        grids.append(lhg.Grid(p.shape[1], p.shape[0], T, k + 1, len(surfaces)))
        for c, name in enumerate('xyz'):
            grids[-1].channels[name] = lhg.Channel(np.ascontiguousarray(p[..., c]), 'length')
    lhg.write(path, grids)


def steps(p, T):
    return 1/(p.shape[1] - 1), T/(p.shape[0] - 1)


def curvature(p, T):
    """At the inner nodes: H of (8) in any chart, (E N - 2 F M + G L)/(2 (EG - F^2)), the area element,
    and the unit normal."""
    h, k = steps(p, T)
    s, n, w, e, c = p[:-2, 1:-1], p[2:, 1:-1], p[1:-1, :-2], p[1:-1, 2:], p[1:-1, 1:-1]
    pu, pv = (e - w)/(2*h), (n - s)/(2*k)
    puu, pvv = (e - 2*c + w)/h**2, (n - 2*c + s)/k**2
    puv = (p[2:, 2:] - p[2:, :-2] - p[:-2, 2:] + p[:-2, :-2])/(4*h*k)
    normal = np.cross(pu, pv)
    area = np.linalg.norm(normal, axis=-1)
    normal /= np.maximum(area, 1e-300)[..., None]
    E, F, G = ((a*b).sum(-1) for a, b in ((pu, pu), (pu, pv), (pv, pv)))
    L, M, N = ((a*normal).sum(-1) for a in (puu, puv, pvv))
    least = 1e-12*((E + G)/2)**2 + 1e-300               # where pu and pv are parallel
    return (E*N - 2*F*M + G*L)/(2*np.maximum(area**2, least)), area, normal


def bending(p, T):
    """The integral of H^2 over the area."""
    H, area, _ = curvature(p, T)
    inner = slice(RINGS, -RINGS)
    return (H**2*area)[inner, inner].sum()*np.prod(steps(p, T))


def roughness(p, T, rings):
    """The integral of |grad H|^2 over the area, which is that over the rectangle."""
    H = curvature(p, T)[0][rings:-rings, rings:-rings]
    h, k = steps(p, T)
    return h*k*(((np.diff(H, axis=1)/h)**2).sum() + ((np.diff(H, axis=0)/k)**2).sum())


def root_area(p):
    d, e = p[1:, 1:] - p[:-1, :-1], p[1:, :-1] - p[:-1, 1:]
    return np.sqrt(np.linalg.norm(np.cross(d, e), axis=-1).sum()/2)


class Foot:
    """A surface, between its nodes a bicubic of Catmull and Rom."""

    def __init__(self, p):
        q = np.concatenate([2*p[:1] - p[1:2], p, 2*p[-1:] - p[-2:-1]])
        q = np.concatenate([2*q[:, :1] - q[:, 1:2], q, 2*q[:, -1:] - q[:, -2:-1]], 1)
        self.size, self.row, self.nodes = np.array([p.shape[1], p.shape[0]]), q.shape[1], q.reshape(-1, 3)

    def _at(self, uv):
        """Positions and derivatives at places uv[n][2], in steps."""
        cell = np.clip(np.floor(uv).astype(int), 0, self.size - 2)
        w, d = weights(uv - cell)
        at = cell[:, 1]*self.row + cell[:, 0]
        x, xu, xv = np.zeros((3, len(uv), 3))
        for b in range(4):
            f, fu = (sum(a[i][:, :1]*self.nodes[at + b*self.row + i] for i in range(4)) for a in (w, d))
            x += w[b][:, 1:]*f
            xu += w[b][:, 1:]*fu
            xv += d[b][:, 1:]*f
        return x, xu, xv

    def distance(self, p):
        """The distance of each node of p[nv][nu][3] from this surface, near the same node of it."""
        at, to = np.stack(np.meshgrid(*map(np.arange, self.size)), -1).reshape(-1, 2).astype(float), p.reshape(-1, 3)
        least = np.full(len(to), np.inf)
        for _ in range(FOOT_STEPS):
            x, xu, xv = self._at(at)
            off = to - x
            least = np.minimum(least, np.linalg.norm(off, axis=1))
            E, F, G, a, b = ((y*z).sum(1) for y, z in ((xu, xu), (xu, xv), (xv, xv), (off, xu), (off, xv)))
            det = np.maximum(E*G - F*F, 1e-3*E*G + 1e-300)
            step = np.stack([G*a - F*b, E*b - F*a], 1)/det[:, None]
            at = np.clip(at + np.clip(step, -2, 2), 0, self.size - 1)
        return least.reshape(p.shape[:2])


def weights(t):
    """The weights of four nodes at t, 0..1 from the second to the third, and their derivatives."""
    w = ((2 - t)*t - 1)*t/2, ((3*t - 5)*t*t + 2)/2, ((4 - 3*t)*t + 1)*t/2, (t - 1)*t*t/2
    d = ((4 - 3*t)*t - 1)/2, (9*t - 10)*t/2, ((8 - 9*t)*t + 1)/2, (3*t - 2)*t/2
    return w, d


def folded(p):
    """The number of cells near the corners whose normal turns by more than a right angle to that of a
    cell beside them."""
    n = np.cross(p[1:, 1:] - p[:-1, :-1], p[1:, :-1] - p[:-1, 1:])
    bad = np.zeros(n.shape[:2], bool)
    along = ~((n[:, 1:]*n[:, :-1]).sum(-1) > 0)
    across = ~((n[1:]*n[:-1]).sum(-1) > 0)
    bad[:, 1:] |= along
    bad[:, :-1] |= along
    bad[1:] |= across
    bad[:-1] |= across
    near = min(CORNER, min(bad.shape)//3)
    return sum(int(bad[a, b].sum()) for a in (slice(near), slice(-near, None)) for b in (slice(near), slice(-near, None)))
