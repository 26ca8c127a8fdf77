#!/usr/bin/python3
"""meet.py A.lhg B.lhg OUT.lhg - scales B to the area of A and moves it rigidly onto A."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
import lhg


def points(g):
    return np.stack([g[k] for k in 'xyz'], -1)


def area(p):
    one, two = p[1:, 1:] - p[:-1, :-1], p[1:, :-1] - p[:-1, 1:]
    return np.linalg.norm(np.cross(one, two), axis=-1).sum()/2


def align(a, b):
    """b moved rigidly onto a, by least squares over the nodes."""
    to = a.mean((0, 1))
    a, b = a - to, b - b.mean((0, 1))
    u, _, v = np.linalg.svd(b.reshape(-1, 3).T @ a.reshape(-1, 3))
    u[:, 2] *= np.sign(np.linalg.det(u @ v))
    return b @ u @ v + to


a, b = (next(lhg.read(path)) for path in sys.argv[1:3])
pa, pb = points(a), points(b)
moved = align(pa, pb*np.sqrt(area(pa)/area(pb)))
for i, k in enumerate('xyz'):
    b.channels[k].data = np.ascontiguousarray(moved[..., i])
lhg.write(sys.argv[3], [b])
