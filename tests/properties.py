"""properties.py - PLY files with properties of all types at their vertices, for properties.bats, and a reader of PLY
that shares nothing with the one under test."""
import numpy as np

TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4",
         "double": "f8"}
N = 30


def read(path):
    """The vertices as a structured array, the faces as rows, and the header."""
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + 11
    header = data[:end].decode().splitlines()
    counts, names, kind, lists = {}, {}, None, {}
    order = ">" if "format binary_big_endian 1.0" in header else "<"
    for line in header:
        w = line.split()
        if w[0] == "element":
            kind = w[1]
            counts[kind], names[kind] = int(w[2]), []
        elif w[0] == "property" and w[1] == "list":
            lists[kind] = True
        elif w[0] == "property":
            names[kind].append((w[2], order + TYPES[w[1]]))
    if "format ascii 1.0" in header:
        rows = data[end:].decode().splitlines()
        v = np.array([tuple(r.split()[:len(names["vertex"])]) for r in rows[:counts["vertex"]]], names["vertex"])
        f = np.array([[int(x) for x in r.split()[1:4]] for r in rows[counts["vertex"]:]])
        return v, f, header
    assert "vertex" not in lists
    v = np.frombuffer(data, names["vertex"], counts["vertex"], end)
    face = np.dtype([("n", "u1"), ("v", order + "i4", 3)] + names["face"])
    f = np.frombuffer(data, face, counts["face"], end + v.nbytes)
    assert (f["n"] == 3).all() and end + v.nbytes + f.nbytes == len(data)
    return v, f["v"], header


PROPERTIES = [("nx", "float"), ("ny", "float"), ("nz", "float"), ("red", "uchar"), ("green", "uchar"), ("blue", "uchar"),
              ("alpha", "uchar"), ("quality", "float"), ("confidence", "double"), ("label", "int"), ("sub", "short"),
              ("small", "char"), ("us", "ushort"), ("ui", "uint"), ("s", "float"), ("t", "float"),
              ("scalar_Original_cloud_index_of_the_scan", "float")]


def surface(hole):
    """A sheet, with a hole or without, and with the hole a second component."""
    i, j = np.meshgrid(np.arange(N), np.arange(N), indexing="ij")
    x, y = i/(N - 1)*2 - 1, j/(N - 1)*2 - 1
    p = np.stack([x, y, .3*np.cos(x)*np.sin(y)], -1).reshape(-1, 3)
    f = []
    for a in range(N - 1):
        for b in range(N - 1):
            if not hole or not (10 <= a < 16 and 12 <= b < 19):
                k = a*N + b
                f += [(k, k + N, k + N + 1), (k, k + N + 1, k + 1)]
    if hole:
        p = np.vstack([p, [[9, 9, 9], [10, 9, 9], [9, 10, 9]]])
        f.append((N*N, N*N + 1, N*N + 2))
    return p, f


def write(path, form, hole=True, lists=False, nan=False):
    """The same surface and numbers in each form: ascii, binary_little_endian, binary_big_endian."""
    rng = np.random.default_rng(3)
    p, faces = surface(hole)
    order = ">" if form == "binary_big_endian" else "<"
    names = [("x", "float"), ("y", "float"), ("z", "float")] + PROPERTIES
    v = np.zeros(len(p), [(k, order + TYPES[t]) for k, t in names])
    v["x"], v["y"], v["z"] = p.T
    for k, t in PROPERTIES:
        if TYPES[t][0] == "f":
            v[k] = rng.normal(size=len(p))
        else:
            v[k] = rng.integers(np.iinfo(TYPES[t]).min, np.iinfo(TYPES[t]).max, len(p), dtype="i8", endpoint=True)
    normal = rng.normal(size=(3, len(p))) + [[0], [0], [4]]
    v["nx"], v["ny"], v["nz"] = normal/np.linalg.norm(normal, axis=0)
    if nan:
        v["confidence"][10*N + 12] = np.nan     # a corner of the hole
    with open(path, "wb") as o:
        o.write(b"ply\nformat %s 1.0\ncomment made here\nelement vertex %d\n" % (form.encode(), len(p)))
        for k, t in names:
            o.write(b"property %s %s\n" % (t.encode(), k.encode()))
        if lists:
            o.write(b"property list uchar float weights\n")
        o.write(b"element face %d\nproperty list uchar int vertex_indices\n" % len(faces))
        o.write(b"property int flags\nend_header\n" if lists else b"end_header\n")
        for r in v:
            if form == "ascii":
                o.write(" ".join(repr(x) for x in r.item()).encode() + (b" 2 .5 1\n" if lists else b"\n"))
            else:
                o.write(r.tobytes() + (b"\2" + np.array([.5, 1], order + "f4").tobytes() if lists else b""))
        for t in faces:
            if form == "ascii":
                o.write(b"3 %d %d %d" % t + (b" 7\n" if lists else b"\n"))
            else:
                o.write(b"\3" + np.array(t, order + "i4").tobytes() + (np.array(7, order + "i4").tobytes() if lists else b""))


def near(v, f):
    """For each vertex that was made here, in layers from the others: the vertices of its faces that are in a layer
    before its own, as often as they are."""
    known = v["source"] >= 0
    layer = np.where(known, 0, -1)
    at = [[] for _ in v]
    for t in f:
        for a in t:
            at[a] += [b for b in t if b != a]
    done = 0
    while (layer < 0).any():
        found = [a for a in np.flatnonzero(layer < 0) if any(layer[b] == done for b in at[a])]
        assert found
        done += 1
        layer[found] = done
    return [(a, [b for b in at[a] if layer[b] < layer[a]]) for d in range(1, done + 1) for a in np.flatnonzero(layer == d)]


def check_disk(before, after):
    """Checks what mesh2disk made of a file of write()."""
    a, _, _ = read(before)
    b, f, header = read(after)
    assert not [x for x in header if "weights" in x or "flags" in x]
    for k, t in PROPERTIES:
        assert "property %s %s" % (t, k) in header, k
    old = b["source"] >= 0
    assert 10 < (~old).sum() < 100 and old.sum() == len(b) - (~old).sum()
    for k in ["x", "y", "z"] + [k for k, _ in PROPERTIES]:
        assert np.array_equal(b[k][old], a[k][b["source"][old]], equal_nan=a[k].dtype.kind == "f"), k
    xyz = np.stack([b["x"], b["y"], b["z"]], -1)
    value = {k: b[k].astype("f8") for k, _ in PROPERTIES}
    way, origin = np.zeros(len(b)), np.arange(len(b))
    for p, around in near(b, f):
        far = [way[q] + np.linalg.norm(xyz[p] - xyz[q]) for q in around]
        way[p], origin[p] = min(far), origin[around[int(np.argmin(far))]]
        for k, t in PROPERTIES:
            if TYPES[t][0] != "f" and k not in ("red", "green", "blue", "alpha"):
                assert b[k][p] == b[k][origin[p]], (k, p)
                continue
            x = [value[k][q] for q in around if np.isfinite(value[k][q])]
            value[k][p] = np.mean(x)
            if k in ("nx", "ny", "nz"):
                continue
            if t == "uchar":
                assert abs(value[k][p] - b[k][p]) <= .5 + 1e-9, (k, p)
            else:
                assert abs(value[k][p] - b[k][p]) < 1e-6, (k, p)
    normal = np.stack([b["nx"], b["ny"], b["nz"]]).astype("f8")
    mean = np.stack([value["nx"], value["ny"], value["nz"]])
    assert abs(np.linalg.norm(normal, axis=0) - 1).max() < 1e-6
    assert abs(mean/np.linalg.norm(mean, axis=0) - normal).max() < 1e-6


def check_same(before, after, filled):
    """Checks that the vertices of `after` have the properties of those of `before` with the same source; filled: also
    those that fill holes."""
    a, _, _ = read(before)
    b, _, header = read(after)
    a = a if filled else a[a["source"] >= 0]
    assert len(a) == len(b) and np.array_equal(a["source"], b["source"])
    for k, t in PROPERTIES:
        if k in ("nx", "ny", "nz", "s", "t"):
            assert "property float " + k not in header, k
            continue
        assert "property %s %s" % (t, k) in header, k
        assert np.array_equal(a[k], b[k], equal_nan=a[k].dtype.kind == "f"), k
