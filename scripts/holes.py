#!/usr/bin/python3
"""holes.py - how near the patches of mesh2disk are to the surface that was there

usage: scripts/holes.py [--sizes=0.02,0.05,0.10] MESH...

Cuts holes into each mesh: the faces round a vertex in the order of their distance, until they have that share
of the area.  The vertex is the one farthest, along edges, from the boundary.  mesh2disk fills the
hole in three ways.  For each the table has the mean distance of the fill from the faces that were
cut out (over points on the fill's faces, weighted by area), over the radius sqrt(area/pi) of the
hole; and whether the vertices outside kept their bits.  The last lines are geometric means.
Programs that are not in PATH are looked for in build/bin."""
import heapq
import os
import subprocess
import sys
import tempfile

import numpy as np

os.environ['PATH'] += ':' + os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'build', 'bin')
FILLS = 'flat', 'C1', 'C2'


def read(path):
    """The vertices, the faces and, if there are any, source and filled of a PLY of mesh2disk."""
    data = open(path, 'rb').read()
    at = data.index(b'end_header\n') + 11
    head = data[:at].decode().split('\n')
    nv, nf = [int(line.split()[2]) for line in head if line.startswith('element')]
    vertex = np.dtype([('x', '<f8', 3), ('source', '<i4')])
    face = np.dtype([('n', 'u1'), ('v', '<i4', 3), ('filled', 'u1')])
    v = np.frombuffer(data, vertex, nv, at)
    f = np.frombuffer(data, face, nf, at + nv*vertex.itemsize)
    return v['x'], f['v'], v['source'], f['filled'] != 0


def write(path, x, f):
    with open(path, 'w') as out:
        out.write('OFF\n%d %d 0\n' % (len(x), len(f)))
        out.writelines('%.17g %.17g %.17g\n' % tuple(p) for p in x)
        out.writelines('3 %d %d %d\n' % tuple(t) for t in f)


def areas(x, f):
    return np.linalg.norm(np.cross(x[f[:, 1]] - x[f[:, 0]], x[f[:, 2]] - x[f[:, 0]]), axis=1)/2


def distances(x, f, start):
    """Along edges from the vertices of start."""
    edge = np.unique(np.sort(np.concatenate([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]]), axis=1), axis=0)
    near = [[] for _ in x]
    for a, b in edge:
        length = np.linalg.norm(x[a] - x[b])
        near[a].append((b, length))
        near[b].append((a, length))
    d = np.full(len(x), np.inf)
    d[start] = 0
    heap = [(0., v) for v in start]
    while heap:
        at, v = heapq.heappop(heap)
        if at > d[v]:
            continue
        for w, length in near[v]:
            if at + length < d[w]:
                d[w] = at + length
                heapq.heappush(heap, (d[w], w))
    return d


def boundary(f):
    edge, n = np.unique(np.sort(np.concatenate([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]]), axis=1), axis=0,
                        return_counts=True)
    return np.unique(edge[n == 1])


def cut(x, f, d, share):
    """Marks the faces nearest to the vertex with d = 0 that have this share of the area."""
    far = d[f].max(axis=1)
    order = np.argsort(far, kind='stable')
    a = areas(x, f)
    limit = far[order[np.searchsorted(np.cumsum(a[order]), share*a.sum())]]
    return far <= limit


def to_triangles(p, x, f):
    """The distance of each point of p from the nearest triangle [C. Ericson, Real-Time Collision Detection, 5.1.5]."""
    a, b, c = x[f[:, 0]], x[f[:, 1]], x[f[:, 2]]
    ab, ac = b - a, c - a
    n = np.cross(ab, ac)
    nn = np.maximum((n*n).sum(1), 1e-300)
    best = np.empty(len(p))
    for i, q in enumerate(p):
        ap = q - a
        v = (np.cross(ap, ac)*n).sum(1)/nn
        w = (np.cross(ab, ap)*n).sum(1)/nn
        plane = np.abs((ap*n).sum(1))/np.sqrt(nn)
        d = np.where((v >= 0) & (w >= 0) & (v + w <= 1), plane, np.inf)
        for s, e in ((a, ab), (b, c - b), (c, -ac)):
            t = np.clip(((q - s)*e).sum(1)/np.maximum((e*e).sum(1), 1e-300), 0, 1)
            d = np.minimum(d, np.linalg.norm(q - s - t[:, None]*e, axis=1))
        best[i] = d.min()
    return best


def error(x, f, truth_x, truth_f):
    """The mean distance of the faces f from the truth: at the middles of the four parts of each face."""
    a, b, c = x[f[:, 0]], x[f[:, 1]], x[f[:, 2]]
    points = np.concatenate([(a + b + c)/3, (4*a + b + c)/6, (a + 4*b + c)/6, (a + b + 4*c)/6])
    weight = np.tile(areas(x, f), 4)
    return (to_triangles(points, truth_x, truth_f)*weight).sum()/weight.sum()


def mend(path, out, fill):
    subprocess.run(['mesh2disk', '-q', '--fill=' + fill, path, '-o', out], check=True)
    return read(out)


def main():
    sizes, meshes = [0.02, 0.05, 0.10], []
    for arg in sys.argv[1:]:
        if arg.startswith('--sizes='):
            sizes = [float(s) for s in arg[8:].split(',')]
        elif arg.startswith('-'):
            sys.exit(__doc__)
        else:
            meshes.append(arg)
    if not meshes:
        sys.exit(__doc__)
    ratios = []
    print('%-28s %5s %6s   %s   outside' % ('mesh', 'share', 'faces', '   '.join('%7s' % s for s in FILLS)))
    with tempfile.TemporaryDirectory() as tmp:
        for mesh in meshes:
            x, f, _, _ = mend(mesh, tmp + '/whole.ply', 'flat')
            centre = distances(x, f, boundary(f)).argmax()
            d = distances(x, f, [centre])
            for share in sizes:
                gone = cut(x, f, d, share)
                write(tmp + '/hole.off', x, f[~gone])
                radius = np.sqrt(areas(x, f[gone]).sum()/np.pi)
                found, same = [], True
                for fill in FILLS:
                    y, g, source, filled = mend(tmp + '/hole.off', tmp + '/filled.ply', fill)
                    found.append(error(y, g[filled], x, f[gone])/radius)
                    same &= (y[source >= 0].tobytes() == x[source[source >= 0]].tobytes())
                ratios.append(found)
                print('%-28s %5.2f %6d   %s   %s' % (os.path.basename(mesh), share, gone.sum(),
                      '   '.join('%7.4f' % e for e in found), 'equal bits' if same else 'MOVED'), flush=True)
    flat, c1, c2 = np.log(np.array(ratios)).mean(axis=0)
    print('geometric mean: C2 over flat %.2f, C2 over C1 %.2f' % (np.exp(c2 - flat), np.exp(c2 - c1)))


main()
