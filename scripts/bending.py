#!/usr/bin/env python3
"""bending.py LH.lhg - the bending energy, integral of H^2 over the area, of each grid of a
stream of lambda and H, without the outermost ring; one number a line."""
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
