"""ways.py - the ways to smooth a gridded surface that equal.py and noise.py compare."""
import re
import subprocess

import numpy as np

import surface

PRECISE = 1e-9          # residual of conjugate gradients
PLACE = ('place.x', 'place.y', 'place.z')


class Failed(Exception):
    """A command failed; its last line on stderr."""


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Failed((done.stderr.strip().splitlines() or [command[0] + ' failed'])[-1])
    return done.stdout + done.stderr


class Ways:
    """The surface of the file `path`, whose lambda and H are in the file `lh`; `work` begins the names of
    files of intermediate results."""

    def __init__(self, path, lh, work):
        self.path, self.lh, self.work, self.solves = path, lh, work, '-'
        (self.p,), self.T = surface.read(path)
        self.lambda2 = next(iter(surface.lhg.read(lh)))['lambda'][1:-1, 1:-1, None]**2
        self.root = surface.root_area(self.p)

    def fitted(self, *option):
        """The surface of lhfft OPTION and lh2grid."""
        run('lhfft', '-q', *option, self.lh, '-o', self.work + '-lh.lhg')
        said = run('lh2grid', '-v', self.work + '-lh.lhg', '-o', self.work + '-back.lhg')
        self.solves = re.findall(r': ([0-9.]+) vector Poisson', said)[-1]
        return surface.read(self.work + '-back.lhg')[0][0]

    def positions(self, percent):
        """The place of lhfft --scale."""
        run('lhfft', '-q', '--scale=%.10g%%' % percent, self.lh, '-o', self.work + '-lh.lhg')
        return surface.read(self.work + '-lh.lhg', PLACE)[0][0]

    def cotangent(self, t):
        """One implicit step of the heat flow of x, y, z, (M + t K) x~ = M x, t in sqrt(area) squared; the
        border is held.  K has the cotangent weights of the grid, which is conformal: those of five
        points.  Conjugate gradients, scaled by the diagonal."""
        h, k = surface.steps(self.p, self.T)
        u, v = t*self.root**2/h**2, t*self.root**2/k**2
        x = self.p.copy()
        r = u*(x[1:-1, 2:] + x[1:-1, :-2] - 2*x[1:-1, 1:-1]) + v*(x[2:, 1:-1] + x[:-2, 1:-1] - 2*x[1:-1, 1:-1])
        diagonal, d = self.lambda2 + 2*(u + v), np.zeros_like(x)
        z = r/diagonal
        rz = first = (r*z).sum()
        d[1:-1, 1:-1] = z
        while rz > PRECISE**2*first:
            inner = d[1:-1, 1:-1]
            q = diagonal*inner - u*(d[1:-1, 2:] + d[1:-1, :-2]) - v*(d[2:, 1:-1] + d[:-2, 1:-1])
            a = rz/(inner*q).sum()
            x[1:-1, 1:-1] += a*inner
            r -= a*q
            z = r/diagonal
            rz, last = (r*z).sum(), rz
            d[1:-1, 1:-1] = z + rz/last*inner
        return x
