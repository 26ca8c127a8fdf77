#!/usr/bin/python3
"""render.py - shaded pictures of OFF meshes side by side.

usage: render.py [--from=X,Y,Z] [--up=X,Y,Z] [--width=PIXELS] OUT.png MESH.off...

Parallel projection seen from the direction X,Y,Z (default 0,0,1), lit from above left,
both sides of a face alike, all meshes at the scale of the first.  Deterministic.
"""
import struct
import sys
import zlib

import numpy as np

SAMPLES = 2                                     # per pixel and direction


def load(path):
    words = open(path).read().split()
    nv, nf = int(words[1]), int(words[2])
    xyz = np.array(words[4:4 + 3*nv], float).reshape(-1, 3)
    return xyz, np.array(words[4 + 3*nv:4 + 3*nv + 4*nf], int).reshape(-1, 4)[:, 1:]


def axes(towards, up):
    z = towards/np.linalg.norm(towards)
    x = np.cross(up, z)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z])


def vertex_normals(xyz, tri):
    a, b, c = (xyz[tri[:, k]] for k in range(3))
    flat = np.cross(b - a, c - a)
    n = np.zeros_like(xyz)
    for k in range(3):
        np.add.at(n, tri[:, k], flat)
    return n/np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)


def shade(n):
    light = np.array([-0.35, 0.45, 0.82])
    return 0.18 + 0.82*np.clip(np.abs(n @ light), 0, 1)


def draw(xyz, tri, size):
    """Grey picture size x size; xyz already in pixels, z towards the eye."""
    depth, grey = np.full((size, size), -np.inf), np.ones((size, size))
    value = shade(vertex_normals(xyz, tri))
    for t in tri:
        p, s = xyz[t], value[t]
        x0, y0 = np.maximum(np.ceil(p[:, :2].min(0)), 0).astype(int)
        x1, y1 = np.minimum(np.floor(p[:, :2].max(0)), size - 1).astype(int)
        d = (p[1, 0] - p[0, 0])*(p[2, 1] - p[0, 1]) - (p[2, 0] - p[0, 0])*(p[1, 1] - p[0, 1])
        if x1 < x0 or y1 < y0 or d == 0:
            continue
        x, y = np.meshgrid(np.arange(x0, x1 + 1), np.arange(y0, y1 + 1))
        b = ((x - p[0, 0])*(p[2, 1] - p[0, 1]) - (p[2, 0] - p[0, 0])*(y - p[0, 1]))/d
        c = ((p[1, 0] - p[0, 0])*(y - p[0, 1]) - (x - p[0, 0])*(p[1, 1] - p[0, 1]))/d
        a = 1 - b - c
        z = a*p[0, 2] + b*p[1, 2] + c*p[2, 2]
        old = depth[y0:y1 + 1, x0:x1 + 1]
        hit = (a >= -1e-9) & (b >= -1e-9) & (c >= -1e-9) & (z > old)
        old[hit] = z[hit]
        grey[y0:y1 + 1, x0:x1 + 1][hit] = (a*s[0] + b*s[1] + c*s[2])[hit]
    return grey[::-1]


def png(path, grey):
    rows = np.round(255*np.clip(grey, 0, 1)).astype(np.uint8)
    raw = b''.join(b'\0' + r.tobytes() for r in rows)

    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))

    head = struct.pack('>IIBBBBB', rows.shape[1], rows.shape[0], 8, 0, 0, 0, 0)
    with open(path, 'wb') as f:
        f.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', zlib.compress(raw, 9)) + chunk(b'IEND', b''))


def main(args):
    option = {'from': '0,0,1', 'up': '0,1,0', 'width': '320'}
    while args and args[0].startswith('--'):
        key, _, value = args.pop(0)[2:].partition('=')
        if key not in option:
            sys.exit(__doc__)
        option[key] = value
    if len(args) < 2:
        sys.exit(__doc__)
    turn = axes(*(np.array(option[k].split(','), float) for k in ('from', 'up')))
    size, scale, panels = int(option['width'])*SAMPLES, None, []
    for path in args[1:]:
        xyz, tri = load(path)
        xyz = xyz @ turn.T
        xyz -= (xyz.max(0) + xyz.min(0))/2
        scale = scale or 0.94*size/np.ptp(xyz[:, :2], axis=0).max()
        panels.append(draw(xyz*scale + size/2, tri, size))
    grey = np.concatenate(panels, 1)
    png(args[0], grey.reshape(size//SAMPLES, SAMPLES, -1, SAMPLES).mean((1, 3)))


main(sys.argv[1:])
