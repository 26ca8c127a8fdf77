#!/usr/bin/python3
"""readers.py DUMP FILE.. - compares each mesh file, as DUMP (tests/meshdump.c) reads it, with an independent
reader: nibabel for GIFTI and FreeSurfer, meshio for others; for formats that neither reads (Hoppe M, FreeSurfer
ASCII, OBJ, legacy VTK, OFF BINARY, PLY of strips) a few lines of numpy.  Prints a line for each file; exit 1 if one differs.
Exit 77 if nibabel or meshio is not installed."""
import os
import subprocess
import sys

try:
    import meshio
    import nibabel
    import numpy as np
except ImportError as error:
    print(error)
    sys.exit(77)


def dumped(dump, path):
    out = subprocess.run([dump, path], stdout=subprocess.PIPE, check=True).stdout
    head, _, data = out.partition(b"\n")
    nv, nf, nc = map(int, head.split())
    xyz = np.frombuffer(data, "f8", 3*nv).reshape(nv, 3)
    first = np.frombuffer(data, "i4", nf + 1, 24*nv)
    idx = np.frombuffer(data, "i4", nc, 24*nv + 4*(nf + 1))
    return xyz, [tuple(idx[a:b]) for a, b in zip(first[:-1], first[1:])]


def gifti(path):
    image = nibabel.load(path)
    return [image.agg_data(intent) for intent in ("NIFTI_INTENT_POINTSET", "NIFTI_INTENT_TRIANGLE")]


def hoppe(path):
    rows = [line.split() for line in open(path)]
    vertices = [r for r in rows if r and r[0] == "Vertex"]
    number = {r[1]: i for i, r in enumerate(vertices)}
    return ([[float(x) for x in r[2:5]] for r in vertices],
            [[number[i] for i in r[2:5]] for r in rows if r and r[0] == "Face"])


def fsascii(path):
    a = np.array(" ".join(open(path).read().split("\n")[1:]).split(), float)
    nv = int(a[0])
    rows = a[2:].reshape(-1, 4)
    return rows[:nv, :3], rows[nv:, :3].astype(int)


def offbinary(path):
    data = open(path, "rb").read().split(b"\n", 1)[1]
    nv, nf, _ = np.frombuffer(data, "<i4", 3)
    return (np.frombuffer(data, "<f4", 3*nv, 12).reshape(-1, 3),
            np.frombuffer(data, "<i4", 4*nf, 12 + 12*nv).reshape(-1, 4)[:, 1:])


def obj(path):
    rows = [line.split() for line in open(path)]
    return ([[float(x) for x in r[1:4]] for r in rows if r and r[0] == "v"],
            [[int(c.split("/")[0]) - 1 for c in r[1:]] for r in rows if r and r[0] == "f"])


def strips(path):
    """One list of one tristrips record at the end of a little-endian PLY, strips divided by -1."""
    data = open(path, "rb").read()
    head, _, data = data.partition(b"end_header\n")
    nv = int(head.split(b"element vertex")[1].split()[0])
    each = 4*head.split(b"element vertex")[1].split(b"element")[0].count(b"property float")
    vertices = np.frombuffer(data, np.dtype(("<f4", each//4)), nv)[:, :3]
    faces = []
    for strip in " ".join(map(str, np.frombuffer(data[nv*each + 4:], "<i4"))).split("-1"):
        v = list(map(int, strip.split()))
        for i in range(len(v) - 2):
            t = (v[i], v[i+1], v[i+2]) if i % 2 == 0 else (v[i+1], v[i], v[i+2])
            if len(set(t)) == 3:
                faces.append(t)
    return vertices, faces


def vtk(path):
    """Legacy ASCII POLYDATA with triangles only."""
    words = open(path).read().split()
    i, j = words.index("POINTS"), words.index("POLYGONS")
    points = np.array(words[i + 3:i + 3 + 3*int(words[i + 1])], "f4").reshape(-1, 3)
    return points, np.array(words[j + 3:j + 3 + int(words[j + 2])], int).reshape(-1, 4)[:, 1:]


def general(path):
    mesh = meshio.read(path)
    return mesh.points, [row for block in mesh.cells if block.dim == 2 for row in block.data]


def by_name(path):
    name = os.path.basename(path)
    if ".gii" in name:
        return gifti(path)
    if name.endswith(".m"):
        return hoppe(path)
    if name.endswith(".asc"):
        return fsascii(path)
    if name.startswith("lh."):
        return nibabel.freesurfer.read_geometry(path)
    if open(path, "rb").read(10) == b"OFF BINARY":
        return offbinary(path)
    if name.endswith(".vtk"):
        return vtk(path)
    if name.endswith(".obj"):
        return obj(path)
    if "strips" in name:
        return strips(path)
    return general(path)


def equal(path, mine, other):
    xyz, faces = mine
    points, cells = np.asarray(other[0]), other[1]
    if len(points) and points.shape[1] == 2:
        points = np.c_[points, 0*points[:, 0]]
    if path.endswith(".stl"):       # meshio welds
        return faces and np.array_equal(xyz[np.ravel(faces)], points[np.ravel(cells)])
    if points.dtype == np.float32:  # decimals, which meshio rounds to float
        xyz = xyz.astype("f4")
    return np.array_equal(xyz, points) and faces == [tuple(map(int, c)) for c in cells]


bad = 0
for path in sys.argv[2:]:
    mine = dumped(sys.argv[1], path)
    other = by_name(path)
    same = equal(path, mine, other)
    bad += not same
    print(f"{os.path.basename(path)}: {len(mine[0])} vertices, {len(mine[1])} faces:",
          "equal" if same else f"DIFFERS, {len(other[0])} vertices, {len(other[1])} faces")
sys.exit(bad > 0)
