#!/usr/bin/python3
"""equal.py A.lhg LH.lhg S,S.. OUT - compares four ways to smooth a surface at equal bending energy.

A.lhg is the surface, LH.lhg what grid2lh makes of it.  For each S, in percent of sqrt(area), it is
smoothed by lhfft --scale=2 pi S and lh2grid.  Then the parameter of each of the other ways is searched
for which the bending energy is the same:

    bound      lhfft -K and lh2grid
    cotangent  one implicit step of the heat flow of x, y, z
    positions  x, y, z filtered as --scale does

Prints a line for S and way: S, way, its parameter, bending energy over that of A, mean and largest
distance from A in percent of sqrt(area), integral of |grad H|^2 over that of A, without 2 and without 8
rings of nodes beside the border, pairs of faces that cross less those of A, folded cells near the
corners, Poisson solves of lh2grid.  The surfaces go to OUT-S.lhg in this order; a way that does not
reach the bending energy has no line, and A in its place."""
import re
import sys

import numpy as np

import surface
import ways

CLOSE, ENOUGH = 1e-3, 1e-2      # of the bending energy that smoothing takes away: wanted, accepted
TRIES, AFAR = 14, 6             # of a search; until values on both sides must be known


class Case(ways.Ways):
    """What is measured of its surfaces."""

    def __init__(self, path, lh, work):
        super().__init__(path, lh, work)
        self.bent, self.rough = surface.bending(self.p, self.T), self.roughness(self.p)
        self.foot, self.area = surface.Foot(self.p), surface.curvature(self.p, self.T)[1]
        self.crossed = self.crossings(path)

    def bending(self, p):
        return surface.bending(p, self.T)/self.bent

    def roughness(self, p):
        return np.array([surface.roughness(p, self.T, rings) for rings in (surface.RINGS, surface.WIDE)])

    def crossings(self, path):
        out = ways.run('lhdiff', '--no-hausdorff', path, path)
        return int(re.search(r'^self_intersections_a (\d+)', out, re.M)[1])

    def line(self, s, way, parameter, p):
        surface.write(self.work + '-one.lhg', [p], self.T)
        apart = self.foot.distance(p)[1:-1, 1:-1]/self.root*100
        print('%g %s %.4g %.4f %.5f %.4f %.4g %.4g %d %d %s' % (
            s, way, parameter, self.bending(p), (apart*self.area).sum()/self.area.sum(), apart.max(),
            *(self.roughness(p)/self.rough), self.crossings(self.work + '-one.lhg') - self.crossed,
            surface.folded(p), self.solves), flush=True)


def search(smooth, bending, target, x):
    """The x where the bending energy of smooth(x) falls to the target, and smooth(x); None if it does
    not.  Factors of 2, then false position in logarithms (Illinois).  Where lh2grid refuses lambda and H,
    x goes halfway to the best so far."""
    ends, side, best = {}, None, (np.inf, None, None)
    for tried in range(TRIES):
        if tried >= AFAR and len(ends) < 2:
            break
        try:
            p = smooth(x)
        except ways.Failed:
            if not best[1]:
                raise
            x = np.sqrt(x*best[1])
            continue
        f = np.log(bending(p)/target)
        best = min(best, (abs(f), x, p), key=lambda b: b[0])
        if best[0] < CLOSE*(1 - target):
            break
        if side == (f > 0) and len(ends) == 2:
            ends[not side][1] /= 2
        side = bool(f > 0)
        ends[side] = [np.log(x), f]
        if len(ends) == 2:
            (low, a), (high, b) = ends[True], ends[False]
            x = np.exp((low*b - high*a)/(b - a))
        else:
            x = x*2 if side else x/2
    return best[1:] if best[0] < ENOUGH*(1 - target) else None


def compare(case, s, out):
    L = 2*np.pi*s
    shown = [case.fitted('--scale=%.10g%%' % L)]
    case.line(s, 'scale', L, shown[0])
    case.solves = '-'
    target = case.bending(shown[0])
    others = (('bound', lambda x: case.fitted('-K', '%.10g' % x), 1), ('cotangent', case.cotangent, (s/100)**2/4),
            ('positions', case.positions, L))
    for way, smooth, start in others:
        found = search(smooth, case.bending, target, start)
        if found:
            case.line(s, way, *found)
        case.solves = '-'
        shown.append(found[1] if found else case.p)
    surface.write('%s-%g.lhg' % (out, s), shown, case.T)


def main(path, lh, scales, out):
    case = Case(path, lh, out)
    for s in scales.split(','):
        compare(case, float(s), out)


try:
    main(*sys.argv[1:])
except ways.Failed as e:
    sys.exit('equal.py: %s' % e)
