#!/usr/bin/python3
"""apart.py A.lhg B.lhg OUT.lhg - writes a grid whose channel distance holds, at every node, the
distance of the node of A from that of B."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
import lhg

a, b = (next(lhg.read(path)) for path in sys.argv[1:3])
out = lhg.Grid(a.nu, a.nv, a.T)
out.channels['distance'] = lhg.Channel(np.sqrt(sum((a[k] - b[k])**2 for k in 'xyz')), 'length')
lhg.write(sys.argv[3], [out])
