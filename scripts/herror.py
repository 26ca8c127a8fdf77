#!/usr/bin/python3
"""herror.py - the error of H on the grid of `mkmesh torus` or `mkmesh catenoid`.

usage: herror.py torus|catenoid LH.lhg

Prints the area-weighted root mean square error of H over the inner nodes, without unit: divided
by 1/(2r) for the torus, half the curvature of its tube (r = 0.8), and by 1/a for the catenoid,
the curvature of its waist (a = 1).
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import lhg


def torus_H(v, T, R=2.0, r=0.8, v0=-70.0, v1=120.0):
    root = np.sqrt(R*R - r*r)

    def y_of(deg):
        return 2*r/root*np.arctan(np.tan(np.radians(deg)/2)/np.sqrt((R + r)/(R - r)))

    y = y_of(v0) + (y_of(v1) - y_of(v0))*v/T
    t = 2*np.arctan(np.sqrt((R + r)/(R - r))*np.tan(y*root/(2*r)))
    return -(1/r + np.cos(t)/(R + r*np.cos(t)))/2


kind, path = sys.argv[1:]
g = next(iter(lhg.read(path)))
v = np.linspace(0, g.T, g.nv)[:, None]
truth = torus_H(v, g.T) if kind == 'torus' else np.zeros_like(v)
inner = np.s_[1:-1, 1:-1]
w = (g['lambda']**2)[inner]
error = ((g['H'] - truth)**2)[inner]
print('%.3e' % (np.sqrt((w*error).sum()/w.sum())*(2*0.8 if kind == 'torus' else 1.0)))
