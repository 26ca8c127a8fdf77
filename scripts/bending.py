#!/usr/bin/env python3
"""bending.py LH.lhg - prints the bending energy of each grid of a stream of lambda and H, one number
a line: the integral of H^2 over the area, without the outermost ring of nodes."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import lhg


def bending(grid):
    inner = (slice(1, -1), slice(1, -1))
    density = (grid["lambda"][inner] * grid["H"][inner]) ** 2
    return density.sum() * grid.T / ((grid.nu - 1) * (grid.nv - 1))


for grid in lhg.read(sys.argv[1]):
    print("%.6g" % bending(grid))
