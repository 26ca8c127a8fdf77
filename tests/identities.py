#!/usr/bin/python3
"""identities.py - checks the equations of doc/mathematics.md 2 and 7.1 on surfaces in isothermal
coordinates.

Derivatives are those of power series in (u,v), so they are exact up to rounding.  Prints every
equation that does not hold; then exits with 1.  Also prints the ratios of (10) and (15), as they are
printed in the paper, to the right values."""
import math
import sys

DEGREE = 5


class Series:
    """A function of (u,v) near a point: the sum of c[i,j] u^i v^j over i + j <= DEGREE."""
    def __init__(self, c):
        self.c = {k: x for k, x in c.items() if x != 0}

    def __add__(self, b):
        b = b if isinstance(b, Series) else Series({(0, 0): b})
        return Series({k: self.c.get(k, 0) + b.c.get(k, 0) for k in self.c.keys() | b.c.keys()})

    def __mul__(self, b):
        if not isinstance(b, Series):
            return Series({k: x*b for k, x in self.c.items()})
        c = {}
        for (i, j), x in self.c.items():
            for (k, l), y in b.c.items():
                if i + j + k + l <= DEGREE:
                    c[i+k, j+l] = c.get((i+k, j+l), 0) + x*y
        return Series(c)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return self*-1

    def __sub__(self, b):
        return self + -b

    def __rsub__(self, b):
        return b + -self

    def __truediv__(self, b):
        return self*(b**-1 if isinstance(b, Series) else 1/b)

    def compose(self, taylor):
        """f(self), where taylor(x, k) is the k-th Taylor coefficient of f at x."""
        x = self.at()
        d, power, out = self - x, Series({(0, 0): 1}), Series({})
        for k in range(DEGREE + 1):
            out, power = out + power*taylor(x, k), power*d
        return out

    def __pow__(self, p):
        return self.compose(lambda x, k: x**(p - k)*math.prod(p - i for i in range(k))/math.factorial(k))

    def at(self):
        return self.c.get((0, 0), 0)

    def real(self):
        return Series({k: complex(x).real for k, x in self.c.items()})

    def imag(self):
        return Series({k: complex(x).imag for k, x in self.c.items()})

    def d(self, axis):
        return Series({(i - (axis == 0), j - (axis == 1)): x*(j if axis else i)
                       for (i, j), x in self.c.items() if (j if axis else i)})


def sin(s, shift=0):
    return s.compose(lambda x, k: math.sin(x + (k + shift)*math.pi/2)/math.factorial(k))


def cos(s):
    return sin(s, 1)


def exp(s):
    return s.compose(lambda x, k: math.exp(x)/math.factorial(k))


def log(s):
    return s.compose(lambda x, k: math.log(x) if k == 0 else -(-1/x)**k/k)


def catenoid(x, y):
    a, b = exp(y), exp(-y)
    return [(a + b)/2*cos(x), (a + b)/2*sin(x), y]


def enneper(x, y):
    return [x - x*x*x/3 + x*y*y, -y + y*y*y/3 - y*x*x, x*x - y*y]


def torus(x, y, R=3, r=1):
    c = math.sqrt(R*R - r*r)/r
    t = sin(y*(c/2))/cos(y*(c/2))*math.sqrt((R + r)/(R - r))       # the tangent of half the angle
    cosine, sine = (1 - t*t)/(1 + t*t), 2*t/(1 + t*t)
    return [(R + r*cosine)*cos(x), (R + r*cosine)*sin(x), r*sine]


def sphere(x, y):
    d = 1 + x*x + y*y
    return [2*x/d, 2*y/d, (x*x + y*y - 1)/d]


def dot(a, b):
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2]


def cross(a, b):
    return [a[k-2]*b[k-1] - a[k-1]*b[k-2] for k in range(3)]


def d(f, axis):
    return [x.d(axis) for x in f] if isinstance(f, list) else f.d(axis)


def dz(f, sign=-1):
    return (d(f, 0) + d(f, 1)*(1j*sign))/2


def laplacian(f):
    return d(d(f, 0), 0) + d(d(f, 1), 1)


def minus(f, *terms):
    """The vector f minus the sum of factor*vector over the terms (factor, vector)."""
    return [f[k] - sum(a*x[k] for a, x in terms) for k in range(3)]


def check(name, surface):
    z = Series({(0, 0): 0.31 + 0.17j, (1, 0): 1, (0, 1): 1j})
    z = z + z*z*0.2                                 # so that L - N and M are not 0
    phi = surface(z.real(), z.imag())
    p, q = d(phi, 0), d(phi, 1)
    E, F, G = dot(p, p), dot(p, q), dot(q, q)
    l2 = (E + G)/2                                                          # (25)
    lam, normal = l2**0.5, cross(p, q)
    n = [x*dot(normal, normal)**-0.5 for x in normal]                       # (29)
    L, M, N = dot(d(p, 0), n), dot(d(p, 1), n), dot(d(q, 1), n)             # (12)
    Delta = [laplacian(x) for x in phi]
    H, K, mu = dot(Delta, n)/(2*l2), (L*N - M*M)/(l2*l2), (L - N - M*2j)/4
    D, a, b = (L - N)/2, d(log(l2)/2, 0), d(log(l2)/2, 1)
    phi_z = [dz(x) for x in phi]
    phi_zbar = [dz(x, 1) for x in phi]
    inner = 2*dz(lam)*dz(H) + lam*dz(dz(H))
    zero = {
        'conformal (6)': [E - G, F],
        'H (9)': [H - (L + N)/(2*l2), dot(Delta, Delta) - 4*l2*l2*H*H],
        'K (10)': [K + laplacian(log(l2)/2)/l2],
        'Gauss': [mu.real()*mu.real() + mu.imag()*mu.imag() - l2*l2*(H*H - K)/4],
        'frame (13)': minus([dz(x) for x in phi_z], (2*dz(lam)/lam, phi_z), (mu, n))
        + minus([dz(x) for x in phi_zbar], (l2*H/2, n))
        + minus([dz(x) for x in n], (-H, phi_z), (-2*mu/l2, phi_zbar)),
        'Codazzi (14)': [dz(mu, 1) - l2*dz(H)/2],
        'Codazzi (15)': [laplacian(mu) - 2*lam*inner],
        'real (14)': [d(D, 0) + d(M, 1) - l2*d(H, 0), d(D, 1) - d(M, 0) + l2*d(H, 1)],
        'real (13)': minus(d(p, 0), (a, p), (-b, q), (L, n)) + minus(d(p, 1), (b, p), (a, q), (M, n))
        + minus(d(q, 1), (-a, p), (b, q), (N, n)) + minus(d(n, 0), (-L/l2, p), (-M/l2, q))
        + minus(d(n, 1), (-M/l2, p), (-N/l2, q)),
        'position (31)': minus(p, (1, phi_z), (1, phi_zbar)) + minus(q, (1j, phi_z), (-1j, phi_zbar)),
    }
    bad = 0
    for what, values in zero.items():
        for x in values:
            if not abs(x.at()) < 1e-10:
                print('%s: %s is off by %.3g' % (name, what, abs(x.at())))
                bad = 1
    print('%s: printed (10) over K: %.6f' % (name, (-laplacian(log(l2)/2)/(2*l2)).at()/K.at()))
    if abs(inner.at()) > 1e-6:
        print('%s: printed (15) over Delta mu: %.6f' % (name, ((lam*inner/2).at()/laplacian(mu).at()).real))
    return bad


sys.exit(any([check(f.__name__, f) for f in (catenoid, enneper, torus, sphere)]))
