#!/usr/bin/python3
"""noise.py A.lhg PERCENT OUT - moves the nodes of A along their normals by noise of PERCENT of sqrt(area),
in the root mean square, and removes it in several ways, each at the best of its parameters.

Prints a line for each way: way, parameter, mean angle between the normals and those of A in degrees,
bending energy over that of A.  Writes A, the noisy surface and the best of each way to OUT.lhg."""
import sys

import numpy as np

import surface
import ways

WIDTH = 1.0             # of the Gaussian that correlates the noise, in steps
FADE = 8                # steps from the border over which it sets in
LEAST = 0.01            # of --relief, percent


def smooth(f):
    """f with a Gaussian of WIDTH, mirrored at the border."""
    reach = np.arange(-4, 5)
    w = np.exp(-0.5*(reach/WIDTH)**2)
    for axis in (0, 1):
        padded = np.pad(f, [(4, 4) if a == axis else (0, 0) for a in (0, 1)], mode='symmetric')
        f = np.apply_along_axis(np.convolve, axis, padded, w/w.sum(), 'valid')
    return f


def noisy(p, T, root, percent):
    nv, nu = p.shape[:2]
    f = smooth(np.random.default_rng(1).standard_normal((nv, nu)))
    rows, columns = (np.minimum(np.arange(n), np.arange(n)[::-1]) for n in (nv, nu))
    fade = np.minimum(1, np.minimum.outer(rows, columns)/FADE)
    _, area, normal = surface.curvature(p, T)
    less = np.minimum(1, np.sqrt(area/np.median(area)))  # on small cells
    out = p.copy()
    out[1:-1, 1:-1] += ((percent/100*root/f.std()*f*fade)[1:-1, 1:-1]*less)[..., None]*normal
    return out


class Clean:
    def __init__(self, path):
        (self.p,), self.T = surface.read(path)
        _, self.area, self.normal = surface.curvature(self.p, self.T)
        self.bent = surface.bending(self.p, self.T)

    def degrees(self, p):
        turn = np.arccos(np.clip((surface.curvature(p, self.T)[2]*self.normal).sum(-1), -1, 1))
        return np.degrees((turn*self.area).sum()/self.area.sum())

    def line(self, way, parameter, p):
        print('%s %.3g %.3f %.3f' % (way, parameter, self.degrees(p), surface.bending(p, self.T)/self.bent), flush=True)


def best(smoothed, degrees, x, factor):
    """From x up, as long as the angle is not far above the least so far."""
    least = np.inf, x, None
    while True:
        p = smoothed(x)
        angle = degrees(p)
        least = min(least, (angle, x, p), key=lambda b: b[0])
        if angle > 1.15*least[0]:
            return least[1:]
        x *= factor


def main(path, percent, out):
    clean = Clean(path)
    rough = noisy(clean.p, clean.T, surface.root_area(clean.p), percent)
    surface.write(out + '-noisy.lhg', [rough], clean.T)
    ways.run('grid2lh', '-q', out + '-noisy.lhg', '-o', out + '-noisy-lh.lhg')
    w = ways.Ways(out + '-noisy.lhg', out + '-noisy-lh.lhg', out)
    clean.line('noisy', 0, rough)
    shown = [clean.p, rough]
    for way, smoothed, start, factor in (
            ('bound', lambda x: w.fitted('-K', '%.10g' % x), 0.1, 2**.5), ('cotangent', w.cotangent, percent**2*1e-4, 2**.5),
            ('positions', w.positions, 1, 2**.25), ('scale', lambda L: w.fitted('--scale=%.10g%%' % L), 1, 2**.25),
            ('relief', lambda tau: w.fitted('--relief=%.10g%%' % tau), max(LEAST, percent/4), 2**.25)):
        parameter, p = best(smoothed, clean.degrees, start, factor)
        clean.line(way, parameter, p)
        shown.append(p)
    surface.write(out + '.lhg', shown, clean.T)


try:
    main(sys.argv[1], float(sys.argv[2]), sys.argv[3])
except ways.Failed as e:
    sys.exit('noise.py: %s' % e)
