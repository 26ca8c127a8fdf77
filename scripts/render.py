#!/usr/bin/python3
"""render.py - draws shaded pictures of surfaces side by side.

usage: render.py [OPTIONS] OUT.png SURFACE...

SURFACE is a mesh (OFF, or OBJ with or without (u,v), as mesh2rect --uv writes it) or a stream
of grids x y z (.lhg); each grid gives a picture of its own.  With %d in OUT, each picture is
written to a file of its own.  The projection is parallel, the light comes from above left, and
both sides of a triangle are shaded alike.  Equal input gives equal pictures.
  --from=X,Y,Z   the direction of the eye [0,0,1]
  --up=X,Y,Z     what is up [0,1,0]
  --size=WxH     pixels of one picture [320x320]
  --each         draw every surface at its own scale, not at that of the first
  --pick=N,N..   draw only the surfaces with these numbers, counted from 1
  --chart        draw (u,v) instead of the positions
  --edges        draw the edges
  --colours=N    at most N colours, 2..256, for a smaller file
  --circles=N    draw N circles across the width of (u,v)
  --paint=LH.lhg:CHANNEL   colour surface N by a channel of grid N of LH.lhg, or of its last grid if
                 there is no grid N; a colour bar is drawn below, and the values at its two ends
                 are printed
  --log          colour by the logarithm of the values
  --top=X        percent of the inner nodes beyond each end of the bar [1]; if the values have both
                 signs, beyond both ends together [5]
"""
import itertools
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import lhg
import raster

SAMPLES = 2                                     # samples per pixel, in each direction
BAR = 14                                        # height of the bar, pixels
CLAY = np.array([0.93, 0.90, 0.85])
HEAT = ['440154', '472d7b', '3b528b', '2c728e', '21918c', '28ae80', '5ec962', 'addc30', 'fde725']
SIGNED = ['2b4fb8', '6f92e6', 'b3cdfb', 'f2f2f2', 'f6b79b', 'e06a53', 'a8102a']
LIGHT = np.array([-0.35, 0.45, 0.82])


class Surface:
    """Positions, triangles, and, if known, (u,v) and the grid."""

    def __init__(self, xyz, tri, uv=None, grid=None):
        self.xyz, self.tri, self.uv, self.grid = xyz, tri, uv, grid

    def normals(self, xyz):
        a, b, c = (xyz[self.tri[:, k]] for k in range(3))
        flat = np.cross(b - a, c - a)
        n = np.zeros_like(xyz)
        for k in range(3):
            np.add.at(n, self.tri[:, k], flat)
        return n/np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)


def load_off(path):
    words = open(path).read().split()
    nv, nf = int(words[1]), int(words[2])
    xyz = np.array(words[4:4 + 3*nv], float).reshape(-1, 3)
    return Surface(xyz, np.array(words[4 + 3*nv:4 + 3*nv + 4*nf], int).reshape(-1, 4)[:, 1:])


def load_obj(path):
    rows = {'v': [], 'vt': [], 'f': []}
    for line in open(path):
        words = line.split()
        if words and words[0] in rows:
            rows[words[0]].append([w.split('/')[0] for w in words[1:4]])
    uv = np.array(rows['vt'], float)[:, :2] if len(rows['vt']) == len(rows['v']) else None
    return Surface(np.array(rows['v'], float), np.array(rows['f'], int) - 1, uv)


def of_grid(g):
    """Splits each cell along its shorter diagonal, as grid2mesh does."""
    xyz = np.stack([g[k].ravel() for k in 'xyz'], 1)
    p = np.arange(g.nu*g.nv).reshape(g.nv, g.nu)
    a, b, c, d = (q.ravel() for q in (p[:-1, :-1], p[:-1, 1:], p[1:, 1:], p[1:, :-1]))
    ac = (np.linalg.norm(xyz[a] - xyz[c], axis=1) <= np.linalg.norm(xyz[b] - xyz[d], axis=1))[:, None]
    one = np.where(ac, np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    two = np.where(ac, np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    v, u = np.meshgrid(np.linspace(0, g.T, g.nv), np.linspace(0, 1, g.nu), indexing='ij')
    return Surface(xyz, np.concatenate([one, two]), np.stack([u.ravel(), v.ravel()], 1), g)


def load(path):
    if path.endswith('.lhg'):
        return [of_grid(g) for g in lhg.read(path)]
    return [load_obj(path) if path.endswith('.obj') else load_off(path)]


def axes(towards, up):
    z = towards/np.linalg.norm(towards)
    x = np.cross(up, z)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z])


class Paint:
    """Maps values to colours; 0 is white if both signs occur."""

    def __init__(self, spec, log, top):
        path, name = spec.rsplit(':', 1)
        self.fields = [g[name] for g in lhg.read(path)]
        self.log = log
        inner = np.concatenate([f[1:-1, 1:-1].ravel() for f in self.fields])
        if inner.min() < 0 < inner.max():
            high = np.quantile(np.abs(inner), 1 - float(top or 5)/100)
            self.ends, self.colours = (-high, high), SIGNED
        else:
            share = float(top or 1)/100
            self.ends, self.colours = tuple(np.quantile(inner, [share, 1 - share])), HEAT

    def colour(self, value):
        low, high = self.ends
        if self.log:
            low, high, value = np.log(low), np.log(high), np.log(np.maximum(value, low))
        at = np.clip((value - low)/(high - low), 0, 1) if high > low else np.zeros_like(value)
        table = np.array([[int(c[k:k + 2], 16)/255 for k in (0, 2, 4)] for c in self.colours])
        place = np.linspace(0, 1, len(table))
        return np.stack([np.interp(at, place, table[:, k]) for k in range(3)], -1)

    def bar(self, image):
        h, w = image.shape[:2]
        ends = [np.log(e) if self.log else e for e in self.ends]
        value = np.linspace(*ends, w*6//10)
        image[h - BAR*SAMPLES:, w//5:w//5 + len(value)] = self.colour(np.exp(value) if self.log else value)


def circles(uv, n):
    """1 on rings about the centres of squares, n of them across the width of (u,v), else 0."""
    r = np.linalg.norm((uv*n) % 1 - 0.5, axis=1)
    return ((r > 0.27) & (r < 0.40)).astype(float)


def base_colour(seen, surface, number, o):
    colour = np.broadcast_to(CLAY, (seen.hit.sum(), 3))
    if o.paint:
        fields = o.paint.fields
        colour = o.paint.colour(seen.mix(fields[min(number, len(fields) - 1)].ravel()))
    if o.circles:
        ring = circles(seen.mix(surface.uv), int(o.circles))[:, None]
        colour = colour*(1 - ring) + np.array([0.16, 0.33, 0.62])*ring
    return colour


def draw(surface, xyz, number, o):
    w, h = (SAMPLES*s for s in o.pixels)
    seen = raster.Raster(xyz, surface.tri, w, h)
    colour = base_colour(seen, surface, number, o)
    if not o.chart:
        n = seen.mix(surface.normals(xyz))
        n *= np.where(n[:, 2:] < 0, -1, 1)/np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)
        light = np.clip(n @ (LIGHT/np.linalg.norm(LIGHT)), 0, 1)[:, None]
        ambient = 0.45 if o.paint else 0.3
        colour = colour*(ambient + (1.04 - ambient)*light)
    if o.edges:
        line = np.clip(1.3 - seen.edge_distance(xyz), 0, 1)[:, None]*0.6
        colour = colour*(1 - line) + np.array([0.15, 0.2, 0.3])*line
    image = seen.picture(colour)
    if o.paint:
        o.paint.bar(image)
    return raster.shrink(image, SAMPLES)


def place(surface, turn, o):
    """Positions in the coordinates of the eye, relative to the centre of their bounding box."""
    if o.chart:
        xyz = np.concatenate([surface.uv, np.zeros((len(surface.uv), 1))], 1)
    else:
        xyz = surface.xyz @ turn.T
    return xyz - (xyz.max(0) + xyz.min(0))/2


class Options:
    def __init__(self, args):
        self.__dict__.update({'from': '0,0,1', 'up': '0,1,0', 'size': '320x320', 'paint': '', 'circles': '', 'top': '', 'pick': '', 'colours': '0',
                              'each': False, 'chart': False, 'edges': False, 'log': False})
        while args and args[0].startswith('--'):
            key, equals, value = args.pop(0)[2:].partition('=')
            if not hasattr(self, key) or isinstance(getattr(self, key), bool) == bool(equals):
                sys.exit(__doc__)
            setattr(self, key, value if equals else True)
        if len(args) < 2:
            sys.exit(__doc__)
        self.out, self.paths = args[0], args[1:]
        self.pixels = [int(s) for s in self.size.split('x')]
        self.paint = self.paint and Paint(self.paint, self.log, self.top)


def main(args):
    o = Options(args)
    turn = axes(*(np.array(getattr(o, k).split(','), float) for k in ('from', 'up')))
    room = np.array(o.pixels) - (BAR + 26 if o.paint else 0)*np.array([0, 1])
    wanted = [int(n) for n in o.pick.split(',')] if o.pick else None
    scale, panels = None, {}
    for number, surface in enumerate(itertools.chain.from_iterable(map(load, o.paths)), 1):
        if wanted and number not in wanted:
            continue
        xyz = place(surface, turn, o)
        if o.each or scale is None:
            scale = (0.94*SAMPLES*room/np.ptp(xyz[:, :2], axis=0)).min()
        middle = SAMPLES*np.array([o.pixels[0]/2, o.pixels[1] - room[1]/2, 0])
        panels[number] = draw(surface, xyz*scale + middle, number - 1, o)
    if '%' in o.out:
        for number, panel in panels.items():
            raster.png(o.out % number, panel, int(o.colours))
    else:
        raster.png(o.out, np.concatenate(list(panels.values()), 1), int(o.colours))
    if o.paint:
        print('%.3g %.3g' % tuple(o.paint.ends))


main(sys.argv[1:])
