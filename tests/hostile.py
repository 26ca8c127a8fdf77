"""hostile.py SOURCE TARGET CODE: reads the first grid of SOURCE as g, runs CODE, writes g to TARGET.
In CODE, size(nu, nv) returns a grid of that size with x y z and the channels that grid2lh writes."""
import sys

import numpy as np

sys.path.insert(0, "scripts")
import lhg


def support(f, nu, nv, which, step):
    j, i = np.mgrid[:nv, :nu]
    if which == "border":
        return f[np.minimum(np.minimum(i, nu - 1 - i), np.minimum(j, nv - 1 - j)) < step]
    return f[(i % step == 0) & (j % step == 0)]


def size(nu, nv, band=1, T=1.0):
    g = lhg.Grid(nu, nv, T)
    v, u = np.mgrid[:nv, :nu] / np.array([nv - 1, nu - 1]).reshape(2, 1, 1)
    for c, f in zip("xyz", (u, T*v, u*v/8)):
        g.channels[c] = lhg.Channel(f.copy(), "length")
        g.channels["band." + c] = lhg.Channel(support(f, nu, nv, "border", band), "length", "border", band)
        g.channels["start." + c] = lhg.Channel(support(f, nu, nv, "lattice", 1), "length", "lattice", 1)
    g.channels["lambda"] = lhg.Channel(np.ones((nv, nu)), "length")
    g.channels["H"] = lhg.Channel(np.zeros((nv, nu)), "1/length")
    return g


g = next(iter(lhg.read(sys.argv[1])))
exec(sys.argv[3])
with open(sys.argv[2], "wb") as out:
    lhg.write(out, [g])
