# fields.bats - channels of a grid on the vertices of a mesh: grid2mesh --with, and the files that hold them.

load helper

setup_file() {
	load helper
	mkmesh -n 4000 torus -o "$tmp/torus.off"
	mesh2rect -n 64 --uv="$tmp/uv.ply" "$tmp/torus.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >"$tmp/square.off"
}

# py CODE: runs CODE in Python, in the folder of the files, with numpy as np and lhg.
py() {
	PYTHONPATH=$PWD/scripts PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "import os, struct, numpy as np, lhg
os.chdir('$tmp')
def ply(name):
    b = open(name, 'rb').read()
    i = b.index(b'end_header\n') + 11
    head = b[:i].decode().split('\n')
    n = int([w for w in head if w.startswith('element vertex')][0].split()[2])
    face = [k for k, w in enumerate(head) if w.startswith('element face')][0]
    kind = {'double': '<f8', 'int': '<i4', 'uchar': 'u1'}
    t = [(w.split()[2], kind[w.split()[1]]) for w in head[:face] if w.startswith('property')]
    return np.frombuffer(b, t, n, i)
$1"
}

@test "lambda and H of a torus at its own vertices are those of the formula" {
	grid2mesh --on "$tmp/uv.ply" --with=lambda,H "$tmp/lh" -o "$tmp/x.ply"
	py '
v = ply("x.ply")
R, r = 2, .8                  # mkmesh torus: H = -(1/r + cos t/(R + r cos t))/2
rho = np.hypot(v["x"], v["y"])
H = -(1/r + (rho - R)/r/rho)/2
u, w = v["s"], v["t"]
inner = (u > .05) & (u < .95) & (w > .05*w.max()) & (w < .95*w.max())
assert inner.sum() > 2000
e = abs(v["H"] - H)[inner]
assert e.max() < .03, (e.max(), np.median(e))
assert (v["lambda"] > 0).all()'
}

@test "--flip-sign negates H alone" {
	grid2mesh --on "$tmp/uv.ply" --with=lambda,H "$tmp/lh" -o "$tmp/a.ply"
	grid2mesh --on "$tmp/uv.ply" --with=lambda,H --flip-sign "$tmp/lh" -o "$tmp/b.ply"
	py '
a, b = ply("a.ply"), ply("b.ply")
assert (a["H"] == -b["H"]).all() and (a["lambda"] == b["lambda"]).all() and (a["x"] == b["x"]).all()'
}

@test "without --on the fields are those of the nodes, bit for bit" {
	grid2mesh --with=H,lambda "$tmp/lh" -o "$tmp/nodes.ply"
	py '
g, v = next(lhg.read("lh")), ply("nodes.ply")
assert (v["H"] == g["H"].ravel()).all() and (v["lambda"] == g["lambda"].ravel()).all()
assert list(v.dtype.names) == ["x", "y", "z", "H", "lambda"]'
}

@test "surfaces are written as VTP, GIFTI and FreeSurfer, and read again" {
	local e
	for e in vtp surf.gii pial; do
		grid2mesh "$tmp/phi" -o "$tmp/y.$e"
		below "$(error_of "$tmp/phi" "$tmp/y.$e" max_rel)" 1e-6
		lhdiff --json "$tmp/phi" "$tmp/y.$e" | grep -q '"vertices_b": 4225' || lhdiff "$tmp/phi" "$tmp/y.$e" >/dev/null
	done
	grid2mesh --on "$tmp/uv.ply" --with=lambda,H "$tmp/lh" -o "$tmp/y.vtp"
	below "$(error_of "$tmp/torus.off" "$tmp/y.vtp" max_rel)" 1e-12
	grep -q 'DataArray type="Float64" Name="H" NumberOfComponents="1"' "$tmp/y.vtp"
}

@test "facts of the coordinates go into GIFTI and FreeSurfer files" {
	sed 's/^comment lhgrid T/comment lhgrid fact space NIFTI_XFORM_SCANNER_ANAT\ncomment lhgrid fact c_ras 1 -2 3.5\n&/' "$tmp/uv.ply" >"$tmp/facts.ply"
	mesh2rect -n 16 "$tmp/facts.ply" -o "$tmp/facts.lhg" 2>/dev/null
	grid2mesh "$tmp/facts.lhg" -o "$tmp/facts.surf.gii"
	grep -q 'NIFTI_XFORM_SCANNER_ANAT' "$tmp/facts.surf.gii"
	mesh2rect -n 16 "$tmp/facts.surf.gii" 2>/dev/null | lhinfo | grep -q '  meta c_ras 1 -2 3.5'
}

@test "what has no place is refused" {
	try 2 'OFF has no place for channels' /dev/null grid2mesh --with=H "$tmp/lh"
	try 2 'need --with' /dev/null grid2mesh "$tmp/lh" -o "$tmp/no.curv"
	try 2 'needs --with' /dev/null grid2mesh --flip-sign "$tmp/lh"
	try 2 'holds one channel' /dev/null grid2mesh --with=H,lambda "$tmp/lh" -o "$tmp/no.curv"
	try 1 'no channel colour' /dev/null grid2mesh --with=colour "$tmp/lh" -o "$tmp/no.ply"
	try 1 'band.x' /dev/null grid2mesh --with=band.x "$tmp/lh" -o "$tmp/no.ply"
	[ ! -e "$tmp/no.curv" ] && [ ! -e "$tmp/no.ply" ]
}

@test "numbers of the mesh become channels and come back to the vertices" {
	grid2mesh --on "$tmp/uv.ply" --with=H "$tmp/lh" -o "$tmp/torus.curv"
	grid2mesh --on "$tmp/uv.ply" --with=lambda "$tmp/lh" -o "$tmp/lh.depth.shape.gii"
	for chart in rectangle sock; do
		mesh2rect -q --chart=$chart -n 64 --uv="$tmp/w.ply" --with="$tmp/torus.curv,$tmp/lh.depth.shape.gii" \
			"$tmp/torus.off" -o "$tmp/with"
		grid2mesh --on "$tmp/w.ply" --with=torus,lambda "$tmp/with" -o "$tmp/back.ply"
		grid2mesh --on "$tmp/uv.ply" --with=H,lambda "$tmp/lh" -o "$tmp/want.ply"
		py '
a, b = ply("back.ply"), ply("want.ply")
for x, y in ("torus", "H"), ("lambda", "lambda"):
    e = abs(a[x] - b[y])
    assert np.median(e) < 2e-3*np.ptp(b[y]), (x, np.median(e), np.ptp(b[y]))'
	done
	grid2lh "$tmp/with" 2>/dev/null | lhinfo | grep -q 'channel torus'
	mesh2rect -q --surface=facets -n 32 --with="$tmp/torus.curv" "$tmp/torus.off" | lhinfo | grep -q 'channel torus'
	mkmesh -n 50 cap -o "$tmp/cap.off"
	try 1 'numbers, the mesh has .* vertices' /dev/null mesh2rect --with="$tmp/torus.curv" "$tmp/cap.off"
	try 1 'neither a FreeSurfer' /dev/null mesh2rect --with="$tmp/cap.off" "$tmp/cap.off"
	try 1 'a second channel torus' /dev/null mesh2rect --with="$tmp/torus.curv,$tmp/torus.curv" "$tmp/torus.off"
	head -c 3000 "$tmp/torus.curv" >"$tmp/cut.curv"
	try 1 'values' /dev/null mesh2rect --with="$tmp/cut.curv" "$tmp/torus.off"
	{ cat "$tmp/torus.curv"; printf 'more'; } >"$tmp/more.curv"
	try 1 '4 bytes follow the last of [0-9]* values' /dev/null mesh2rect --with="$tmp/more.curv" "$tmp/torus.off"
}

@test "colours of a PLY become channels, also of what mesh2disk made of it, and come back as bytes" {
	py '
v, f = [], []
for j in range(41):                     # a bowl, with a hole beside its middle
    for i in range(41):
        x, y = i/20 - 1, j/20 - 1
        v.append((x, y, .5*(x*x + y*y)))
for j in range(40):
    for i in range(40):
        if not (22 <= i < 27 and 18 <= j < 23):
            a = 41*j + i
            f += [(3, a, a + 1, a + 42), (3, a, a + 42, a + 41)]
v = np.array(v)
keep = np.zeros(len(v), bool)
keep[[k for t in f for k in t[1:]]] = True
new = np.cumsum(keep) - 1
with open("bowl.ply", "w") as o:
    o.write("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty double quality\n"
        "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (keep.sum(), len(f)))
    for x, y, z in v[keep]:
        o.write("%.9g %.9g %.9g 0 %d %d 7 %.9g\n" % (x, y, z, round(127 + 100*x), round(127 + 100*y), x - y))
    for t in f:
        o.write("3 %d %d %d\n" % tuple(new[list(t[1:])]))'
	mesh2disk -q "$tmp/bowl.ply" -o "$tmp/bowl-disk.ply"
	mesh2rect -q -n 64 --with="$tmp/bowl.ply" --uv="$tmp/bowl-uv.ply" "$tmp/bowl-disk.ply" |
		grid2mesh --on "$tmp/bowl-uv.ply" --with=red,green,blue,quality -o "$tmp/bowl-back.ply"
	head -c 1000 "$tmp/bowl-back.ply" | grep -a -q "^property uchar blue"
	py '
p = ply("bowl-back.ply")
far = np.hypot(p["x"] - .23, p["y"] - .03) > .25
assert 1000 < far.sum() < len(far)
for name, x in ("red", 127 + 100*p["x"]), ("green", 127 + 100*p["y"]), ("blue", 7 + 0*p["x"]):
    e = abs(p[name].astype(float) - x)
    assert e[far].max() < 2 and e.max() < 40, (name, e[far].max(), e.max())
assert abs(p["quality"] - p["x"] + p["y"])[far].max() < .01'
	mkmesh -n 50 cap -o "$tmp/plain.ply"
	try 1 'no numbers at the vertices' /dev/null mesh2rect --with="$tmp/plain.ply" "$tmp/plain.ply"
}

@test "filters change lambda and H and leave numbers of the mesh bit by bit, along the pipeline" {
	local f
	grid2mesh --on "$tmp/uv.ply" --with=H "$tmp/lh" -o "$tmp/torus.curv"
	mesh2rect -q -n 64 --with="$tmp/torus.curv" --uv="$tmp/w.ply" "$tmp/torus.off" | grid2lh 2>/dev/null >"$tmp/carried"
	mesh2rect -q -n 64 "$tmp/torus.off" | grid2lh 2>/dev/null >"$tmp/alone"
	for f in --scale=5%,20% --relief=1% -K\ 3 --low-pass=4,9 --keep=50 --energy=.9 --paper\ -K\ .5; do
		# shellcheck disable=SC2086      # two words
		lhfft -q $f "$tmp/carried" -o "$tmp/filtered"
		# shellcheck disable=SC2086
		lhfft -q $f "$tmp/alone" -o "$tmp/filtered-alone"
		py '
first, n = next(lhg.read("carried")), 0
for g, a in zip(lhg.read("filtered"), lhg.read("filtered-alone"), strict=True):
    n += 1
    assert set(g.channels) == set(a.channels) | {"torus"}
    assert (g["torus"] == first["torus"]).all()
    assert np.ptp(g["torus"]) > .1
    assert all((g[c] == a[c]).all() for c in a.channels)
    assert (g["H"] != first["H"]).any() and (g["lambda"] != first["lambda"]).any()
assert n == 1 + ("," in "'"$f"'")'
	done
	lhfft -q --scale=10% "$tmp/carried" | lh2grid -q 2>/dev/null >"$tmp/smooth"
	grid2mesh --on "$tmp/w.ply" --with=torus "$tmp/smooth" -o "$tmp/smooth.ply"
	grid2mesh --on "$tmp/uv.ply" --with=H "$tmp/lh" -o "$tmp/want.ply"
	py '
a, b = ply("smooth.ply"), ply("want.ply")
e = abs(a["torus"] - b["H"])
assert np.median(e) < 2e-3*np.ptp(b["H"])
assert abs(a["z"] - b["z"]).max() > 1e-3'
}

# bowl NAME ALONE FACES: writes a bowl with a hole, and ALONE vertices of no face before the others, as NAME.ply with the
# number q = x at its vertices, and x as NAME.curv, which says that the mesh has FACES faces (none: the true number).
bowl() {
	py '
n, alone = 15, '$2'
ij = [(i, j) for j in range(n) for i in range(n) if not (5 < i < 10 and 5 < j < 10)]
at = {p: alone + k for k, p in enumerate(ij)}
v = [(9, 9, 9, 9)]*alone + [(i/7 - 1, j/7 - 1, .3*((i/7 - 1)**2 + (j/7 - 1)**2), i/7 - 1) for i, j in ij]
c = [[at[p] for p in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))] for i, j in ij
    if i < n - 1 and j < n - 1 and not (5 <= i < 10 and 5 <= j < 10)]
t = np.zeros(2*len(c), "u1, 3<i4")
t["f0"] = 3
t["f1"] = [k for a, b, c, d in c for k in ((a, b, c), (a, c, d))]
open("'$1'.ply", "wb").write(("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
    "property double z\nproperty double q\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n" %
    (len(v), len(t))).encode() + np.array(v).tobytes() + t.tobytes())
open("'$1'.curv", "wb").write(b"\xff\xff\xff" + struct.pack(">3i", len(v), '${3:-len(t)}', 1) + np.array(v)[:, 3].astype(">f4").tobytes())'
}

# holds_x CHANNEL: checks that the channel of x.lhg is x, but for the filled hole.
holds_x() {
	py '
g = next(lhg.read("x.lhg"))
e = abs(g["'$1'"] - g["x"])
assert np.median(e) < 1e-3 and np.percentile(e, 75) < .02, (np.median(e), np.percentile(e, 75))'
}

@test "numbers that fit the mesh and what mesh2disk made it of are told apart" {
	local added faces f
	bowl probe 0
	mesh2disk -q "$tmp/probe.ply" -o "$tmp/probe-disk.ply"
	added=$(py 'print((ply("probe-disk.ply")["source"] == -1).sum())')
	bowl orig "$added"
	bowl zero "$added" 0
	mesh2disk -q "$tmp/orig.ply" -o "$tmp/disk.ply"
	py '
p, q = ply("orig.ply"), ply("disk.ply")
assert len(p) == len(q) and (q["source"] != np.arange(len(q))).all()'
	faces=$(mesh2disk --check --json "$tmp/disk.ply" | sed -n 's/.*"faces": \([0-9]*\),.*/\1/p')
	py '
q = ply("disk.ply")
open("own.ply", "wb").write(("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
    "property double z\nproperty double q\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n" % len(q)).encode() +
    np.stack([q[k] for k in "xyzx"], -1).tobytes())
open("own.curv", "wb").write(b"\xff\xff\xff" + struct.pack(">3i", len(q), '"$faces"', 1) + q["x"].astype(">f4").tobytes())'
	# The vertices of a PLY tell; a curvature file has the number of faces.
	for f in orig own; do
		try 0 '' /dev/null mesh2rect -q -n 16 --with="$tmp/$f.ply" "$tmp/disk.ply" -o "$tmp/x.lhg"
		holds_x q
		try 0 '' /dev/null mesh2rect -q -n 16 --with="$tmp/$f.curv" "$tmp/disk.ply" -o "$tmp/x.lhg"
		holds_x $f
	done
	try 0 'fit the mesh and what mesh2disk made it of: taken as those of the latter' /dev/null \
		mesh2rect -n 16 --with="$tmp/zero.curv" "$tmp/disk.ply" -o "$tmp/x.lhg"
	holds_x zero
}

@test "nibabel reads the fields and surfaces" {
	/usr/bin/python3 -c 'import nibabel' 2>/dev/null || skip "no nibabel"
	grid2mesh --on "$tmp/uv.ply" --with=lambda,H "$tmp/lh" -o "$tmp/z.ply"
	grid2mesh --on "$tmp/uv.ply" --with=lambda,H "$tmp/lh" -o "$tmp/z.shape.gii"
	grid2mesh --on "$tmp/uv.ply" --with=H "$tmp/lh" -o "$tmp/z.curv"
	grid2mesh --on "$tmp/uv.ply" "$tmp/phi" -o "$tmp/z.surf.gii"
	grid2mesh --on "$tmp/uv.ply" "$tmp/phi" -o "$tmp/z.white"
	py '
import nibabel as nib
v = ply("z.ply")
s = nib.load("z.shape.gii")
assert [d.meta.get("Name") for d in s.darrays] == ["lambda", "H"]
for d in s.darrays:
    assert (d.data == v[d.meta.get("Name")].astype("f4")).all()
assert (nib.freesurfer.read_morph_data("z.curv") == v["H"].astype("f4")).all()
p, t = (d.data for d in nib.load("z.surf.gii").darrays)
q, f = nib.freesurfer.read_geometry("z.white")
x = np.stack([v["x"], v["y"], v["z"]], -1).astype("f4")
assert (p == x).all() and (q == x).all() and (t == f).all()'
}

@test "a cortex of GIFTI to lambda and H at its vertices, in one pipeline" {
	cortex=$meshes/formats/fsaverage5_pial_left.gii
	[ -e "$cortex" ] || skip "no meshes in $meshes"
	/usr/bin/python3 -c 'import nibabel' 2>/dev/null || skip "no nibabel"
	mesh2disk -q --open=auto "$cortex" -o "$tmp/open.ply"
	py '
import nibabel as nib
z = nib.load("'"$cortex"'").darrays[0].data[:, 2]
nib.freesurfer.write_morph_data("lh.height", z)'
	mesh2rect -q --chart=auto --with="$tmp/lh.height" --uv="$tmp/open-uv.ply" "$tmp/open.ply" | grid2lh >"$tmp/cortex"
	grid2mesh --on "$tmp/open-uv.ply" --keep="$cortex" --with=lambda,H,height "$tmp/cortex" -o "$tmp/lh.shape.gii"
	grid2mesh --on "$tmp/open-uv.ply" --with=height "$tmp/cortex" -o "$tmp/height.ply"
	py '
import nibabel as nib
s = nib.load("lh.shape.gii")
H = s.darrays[1].data
z = nib.load("'"$cortex"'").darrays[0].data[:, 2]
assert len(H) == 10242 and np.isfinite(H).all()     # one for each vertex of the file, which was cut
assert np.median(abs(s.darrays[2].data - z)) < .1
p = ply("height.ply")
assert np.median(abs(p["height"] - ply("open-uv.ply")["z"])) < .1
assert .1 < np.median(abs(H)) < .4, np.median(abs(H))      # 1/mm: folds of some millimetres'
}
