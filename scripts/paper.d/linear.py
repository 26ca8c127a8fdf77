#!/usr/bin/python3
"""linear.py MORPH.lhg OUT.lhg - interpolates the positions of the first and last grid of MORPH
linearly; writes as many grids as MORPH has."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
import lhg


def between(a, b, frames):
    for frame in range(1, frames + 1):
        t = (frame - 1)/(frames - 1)
        g = lhg.Grid(a.nu, a.nv, (1 - t)*a.T + t*b.T, frame, frames, a.chart)
        for k in 'xyz':
            g.channels[k] = lhg.Channel((1 - t)*a[k] + t*b[k], a.channels[k].unit)
        yield g


for grid in lhg.read(sys.argv[1]):
    first = grid if grid.frame == 1 else first
lhg.write(sys.argv[2], between(first, grid, grid.frames))
