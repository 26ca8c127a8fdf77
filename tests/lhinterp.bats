# lhinterp.bats - lhinterp: times, rules, weights, cap, landmarks, alignment, scale, history, and the note on quarter turns.

load helper

setup_file() {
	load helper
	mkmesh -n 900 face -o "$tmp/a.off"
	mkmesh -n 700 face smile=0.8 nose=0.6 -o "$tmp/b.off"
	mesh2rect -q -n 24x20 "$tmp/a.off" -o "$tmp/a.phi"
	mesh2rect -q -n 24x20 --like="$tmp/a.phi" "$tmp/b.off" -o "$tmp/b.phi"
	grid2lh --no-place "$tmp/a.phi" -o "$tmp/a"
	grid2lh --no-place --residual "$tmp/a.phi" -o "$tmp/a.all"
	grid2lh --no-place "$tmp/b.phi" -o "$tmp/b"
	grid2lh --no-place --residual "$tmp/b.phi" -o "$tmp/b.all"
	printf '0.3 0.5\n1 1.1 # a comment\n\n2.2, 2\n3\t2.9\r\n' >"$tmp/marks"
}

# python SCRIPT ARGS..: runs SCRIPT with lhg and numpy as np.  read(f) is the list of grids of a file;
# whole(g, name) a channel as [nv][nu], NaN where it has no sample; ring(g) the outermost nodes of the
# band, [n][3], counterclockwise from node (0,0).
python() {
	/usr/bin/python3 -c "import sys; sys.path.insert(0, 'scripts'); import lhg, numpy as np
def read(f): return list(lhg.read(f))
def whole(g, name):
    f = np.full((g.nv, g.nu), np.nan); c = g.channels[name]; f[g.mask(c)] = c.data; return f
def ring(g):
    x = np.stack([whole(g, 'band.' + c) for c in 'xyz'], -1)
    return np.concatenate([x[0, :-1], x[:-1, -1], x[-1, :0:-1], x[:0:-1, 0]])
$1" "${@:2}"
}

# equal A B: checks that the last grids of A and B have equal channels, bit for bit.
equal() {
	python 'a, b = (read(f)[-1] for f in sys.argv[1:3])
assert a.T == b.T and list(a.channels) == list(b.channels)
for c in a.channels: assert a[c].tobytes() == b[c].tobytes(), c' "$1" "$2"
}

@test "t = 0 and t = 1 are A and B bit for bit, with landmarks and without" {
	for o in '' --ease "--landmarks=$tmp/marks"; do
		lhinterp -q -t 1,0 $o "$tmp/a" "$tmp/b" -o "$tmp/ends"
		equal "$tmp/a" "$tmp/ends"
		lhinterp -q -n 4 $o "$tmp/a" "$tmp/b" -o "$tmp/frames"
		equal "$tmp/b" "$tmp/frames"
	done
	lhinterp -q -t 0 --align --landmarks="$tmp/marks" "$tmp/a" "$tmp/b" -o "$tmp/zero"
	equal "$tmp/a" "$tmp/zero"
	# including the sign of zero
	python 'g = read(sys.argv[1])[0]; g["H"][...] = -0.0; lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/b" "$tmp/minus"
	lhinterp -q -t 1 "$tmp/a" "$tmp/minus" -o "$tmp/one"
	equal "$tmp/minus" "$tmp/one"
}

@test "-t takes a list and keeps its order; -n is the list of equal steps; --ease is t^2 (3 - 2t)" {
	lhinterp -q -t 0.75,0,0.25 "$tmp/a" "$tmp/b" -o "$tmp/list"
	python 'g = read(sys.argv[1])
assert [(x.meta["t"], x.frame, x.frames) for x in g] == [("0.75", 1, 3), ("0", 2, 3), ("0.25", 3, 3)]' "$tmp/list"
	lhinterp -q -n 5 "$tmp/a" "$tmp/b" -o "$tmp/n"
	lhinterp -q -t 0,0.25,0.5,0.75,1 "$tmp/a" "$tmp/b" -o "$tmp/t"
	python 'for a, b in zip(*map(read, sys.argv[1:])):
    assert all(a[c].tobytes() == b[c].tobytes() for c in a.channels) and a.meta == b.meta' "$tmp/n" "$tmp/t"
	lhinterp -q -n 5 --ease "$tmp/a" "$tmp/b" -o "$tmp/ease"
	python 'got = [float(g.meta["t"]) for g in read(sys.argv[1])]
assert np.allclose(got, [t*t*(3 - 2*t) for t in (0, 0.25, 0.5, 0.75, 1)], rtol=0, atol=1e-9), got' "$tmp/ease"
	lhinterp -q -t 0.15625 "$tmp/a" "$tmp/b" -o "$tmp/u"
	lhinterp -q -t 0.25 -e "$tmp/a" "$tmp/b" -o "$tmp/v"
	equal "$tmp/u" "$tmp/v"
	try 2 'at=: need a number in \[0,1\]'    /dev/null lhinterp -t 0.5, a b
	try 2 'at=1.01: need a number in \[0,1\]' /dev/null lhinterp -t 0,1.01 a b
	try 2 'at=nan: need a number in \[0,1\]' /dev/null lhinterp -t nan a b
}

@test "between A and A, pairs of equal landmarks change nothing" {
	printf '%s\n' '0.2 0.2' '1.7 1.7' '3 3' >"$tmp/same"
	lhinterp -q -t 0.5 --landmarks="$tmp/same" "$tmp/a" "$tmp/a" -o "$tmp/half"
	python 'a, h = (read(f)[0] for f in sys.argv[1:])
for c in a.channels: assert abs(a[c] - h[c]).max() < 1e-9*abs(a[c]).max(), c' "$tmp/a" "$tmp/half"
}

@test "the two places of a landmark pair are joined at every t; lambda and H stay" {
	# each place is at a node: on A, on B, and, interpolated, at t = 0.25 and 0.5
	printf '%s\n' '0.33333333333333333 0.66666666666666667' '1.2 1.4' '2.25 2.5833333333333333' '3.2 3' >"$tmp/nodes"
	lhinterp -q -t 0.25,0.5 --rule=linear --landmarks="$tmp/nodes" "$tmp/a" "$tmp/b" -o "$tmp/marked"
	lhinterp -q -t 0.25,0.5 --rule=linear "$tmp/a" "$tmp/b" -o "$tmp/plain"
	python 'a, b = (read(f)[0] for f in sys.argv[1:3])
nu, nv = a.nu, a.nv
def at(g, r):
    s = int(r); k = (r - s)*((nv if s % 2 else nu) - 1)
    assert abs(k - round(k)) < 1e-9
    return ring(g)[[0, nu - 1, nu + nv - 2, 2*nu + nv - 3][s] + round(k)]
for m, p in zip(read(sys.argv[3]), read(sys.argv[4])):
    t = float(m.meta["t"]); size = np.ptp(ring(a))
    for i, j in (1/3, 2/3), (1.2, 1.4), (2.25, 2.25 + 1/3), (3.2, 3):
        want = (1 - t)*at(a, i) + t*at(b, j)
        assert abs(at(m, (1 - t)*i + t*j) - want).max() < 1e-9*size, (t, i)
        assert abs(at(p, (1 - t)*i + t*j) - want).max() > 1e-3*size
    for c in "lambda", "H": assert m[c].tobytes() == p[c].tobytes()
    # the inner rings and the lattice move by the Coons patch of the displacement of the border
    u, v = np.meshgrid(np.arange(nu)/(nu - 1), np.arange(nv)/(nv - 1))
    for c in "xyz":
        d = whole(m, "band." + c) - whole(p, "band." + c)
        l, r, o, t1 = d[:, :1], d[:, -1:], d[:1], d[-1:]
        f = ((1-u)*l + u*r + (1-v)*o + v*t1 - (1-u)*(1-v)*d[0, 0] - u*(1-v)*d[0, -1]
            - (1-u)*v*d[-1, 0] - u*v*d[-1, -1])
        for n in "band.", "start.":
            e = whole(m, n + c) - whole(p, n + c) - f
            assert np.nanmax(abs(e)) < 1e-12*size, (n, c)
' "$tmp/a" "$tmp/b" "$tmp/marked" "$tmp/plain"
	lhinterp -q -t 0.5 --landmarks="$tmp/marks" "$tmp/a" "$tmp/b" -o "$tmp/marked"
	lh2grid "$tmp/marked" >/dev/null
	lh2grid --no-start "$tmp/marked" >/dev/null
}

@test "landmarks as points become the nearest places; equal numbers give equal bytes" {
	python 'a, b = (ring(read(f)[0]) for f in sys.argv[1:])
for k in (3, 20, 40, 70): print("%.17g %.17g %.17g" % tuple(a[k]), "%.17g,%.17g,%.17g" % tuple(b[k + 2]))' "$tmp/a" "$tmp/b" >"$tmp/points"
	python 'g = read(sys.argv[1])[0]
def r(k):
    n = [0, g.nu - 1, g.nu + g.nv - 2, 2*g.nu + g.nv - 3, 2*g.nu + 2*g.nv - 4]
    s = max(i for i in range(4) if n[i] <= k); return s + (k - n[s])/(n[s + 1] - n[s])
for k in (3, 20, 40, 70): print(repr(r(k)), repr(r(k + 2)))' "$tmp/a" >"$tmp/places"
	lhinterp -q -t 0.5 --landmarks="$tmp/points" "$tmp/a" "$tmp/b" -o "$tmp/1"
	lhinterp -q -t 0.5 --landmarks="$tmp/places" "$tmp/a" "$tmp/b" -o "$tmp/2"
	python 'a, b = (read(f)[0] for f in sys.argv[1:])
for c in a.channels: assert abs(a[c] - b[c]).max() < 1e-9*abs(a[c]).max(), c' "$tmp/1" "$tmp/2"
	echo "1e3 0 0 $(head -1 "$tmp/points" | cut -d ' ' -f 4-)" >"$tmp/far"
	try 0 'far: line 1: the point is .* from the boundary of A' /dev/null lhinterp -t 0.5 --landmarks="$tmp/far" "$tmp/a" "$tmp/b"
}

@test "wrong landmark files are refused with the number of the line" {
	bad() {
		printf "$1" >"$tmp/bad"
		try 1 "bad: $2" /dev/null lhinterp -t 0.5 --landmarks="$tmp/bad" "$tmp/a" "$tmp/b"
	}
	bad ''                          'no landmarks'
	bad '# nothing\n\n'             'no landmarks'
	bad '0 0\n1\n'                  'line 2: 1 number, need two places or two points'
	bad '0 0 1\n'                   'line 1: 3 numbers, need two'
	bad '0 0 1 1 1 1 1\n'           'line 1: more than 6 numbers, need two'
	bad '0 0\n# x\n1 one\n'         'line 3: one is not a number'
	bad '0 nan\n'                   'line 1: nan is not a number'
	bad '0 0x1\n'                   'line 1: 0x1 is not a number'
	bad '0 0\n4 1\n'                'line 2: place 4 is not in \[0,4\)'
	bad '0 -0.1\n'                  'line 1: place -0.1 is not in'
	bad '0 0\n2 1\n1 2\n'           'line 3: place 1 on A does not lie between 2 and 0, counterclockwise'
	bad '0 0\n1 3\n2 2\n'           'line 3: place 2 on B does not lie between 3 and 0'
	bad '0 0\n1 1\n1 2\n'           'line 3: place 1 on A'
	bad '2 1\n3 2\n2.5 3\n'         'line 3: place 2.5 on A'
	printf '0 0\0\n1 1\n' >"$tmp/bad"
	try 1 'bad: not a text file' /dev/null lhinterp -t 0.5 --landmarks="$tmp/bad" "$tmp/a" "$tmp/b"
	try 1 'nosuch: No such file'    /dev/null lhinterp -t 0.5 --landmarks="$tmp/nosuch" "$tmp/a" "$tmp/b"
	python 'g = read(sys.argv[1])[0]
for c in "xyz": del g.channels["band." + c]
lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/a" "$tmp/bandless"
	try 0 '' /dev/null lhinterp -t 0.5 "$tmp/bandless" "$tmp/bandless"
	try 1 'bandless: no channel band.x' /dev/null lhinterp -t 0.5 --landmarks="$tmp/marks" "$tmp/bandless" "$tmp/bandless"
	try 1 'bandless: no channel band.x' /dev/null lhinterp -t 0.5 --align "$tmp/bandless" "$tmp/bandless"
}

@test "--align moves a moved copy back, only in its positions; without it B stays" {
	python 'g = read(sys.argv[1])[0]
R = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]])
for n in "band.", "start.":
    x = R @ np.stack([g[n + c] for c in "xyz"]) + np.array([[5], [-7], [11]])
    for k, c in enumerate("xyz"): g[n + c][...] = x[k]
lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/a.all" "$tmp/away"
	lhinterp -t 1 "$tmp/a.all" "$tmp/away" -o "$tmp/stays"
	equal "$tmp/away" "$tmp/stays"
	lhinterp -t 0,0.5,1 --align "$tmp/a.all" "$tmp/away" -o "$tmp/back"
	python 'a = read(sys.argv[1])[0]
for g in read(sys.argv[2]):
    for c in a.channels: assert abs(a[c] - g[c]).max() < 1e-12*abs(a[c]).max(), c' "$tmp/a.all" "$tmp/back"
	# a mirror image is not turned into its original
	python 'g = read(sys.argv[1])[0]
for n in "band.x", "start.x": g[n][...] *= -1
lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/a" "$tmp/mirror"
	lhinterp -q -t 1 --align "$tmp/a" "$tmp/mirror" -o "$tmp/still"
	python 'a, m = (ring(read(f)[0]) for f in sys.argv[1:])
assert abs(a - m).max() > 0.05*np.ptp(a)
d = lambda x: np.linalg.norm(x[:, None] - x[None], axis=-1)
assert abs(d(m) - d(a)).max() < 1e-9*np.ptp(a)
det = lambda x: np.linalg.det(np.stack([x[10] - x[0], x[30] - x[0], x[50] - x[0]]))
assert det(a)*det(m) < 0' "$tmp/a" "$tmp/still"
}

@test "a quarter turn that would fit better is noted, exit 0; none is noted if B fits" {
	c=$(lhinfo "$tmp/a.phi" | awk '$2 == "corners" { print $3 }')
	turn() { echo "$c" | awk -F , -v k="$1" '{ for (i = 0; i < 4; i++) printf "%s%s", $((i + k)%4 + 1), i < 3 ? "," : "\n" }'; }
	for k in 1 2 3; do
		mesh2rect -q -n 24x20 -c "$(turn $k)" "$tmp/a.off" | grid2lh -o "$tmp/turned"
		order=$(for i in 0 1 2 3; do echo $(((i + 4 - k)%4 + 1)); done | xargs | tr ' ' ,)
		try 0 "better with corners $order .mesh2rect --like" /dev/null lhinterp -t 0.5 "$tmp/a" "$tmp/turned"
		[ -s "$tmp/out" ]
		try 0 '' /dev/null lhinterp -q -t 0.5 "$tmp/a" "$tmp/turned"
	done
	try 0 '' /dev/null lhinterp -t 0.5 "$tmp/a" "$tmp/b"
}

@test "memory does not grow with the frames" {
	[ -x /usr/bin/time ] || skip "no time(1)"
	case $BUILD in */*) skip "sanitizers keep what is freed" ;; esac
	mkmesh -n 900 face | mesh2rect -q -n 200 | grid2lh -o "$tmp/big"
	peak() { /usr/bin/time -f %M -o "$tmp/kb" lhinterp -q -n "$1" "$tmp/big" "$tmp/big" >/dev/null; tail -1 "$tmp/kb"; }
	below "$(peak 40)" "$(($(peak 3) + 2000))"              # of two, both ends, none is blended
}

@test "a morph of two real faces, corners by --like, aligned: the distance rises with every frame" {
	[ -d "$meshes/good" ] || skip "no meshes"
	mesh2rect -q -n 48 "$meshes/good/face_neutral_1875.obj" -o "$tmp/n.phi"
	mesh2rect -q -n 48 --like="$tmp/n.phi" "$meshes/good/face_smile_1656.obj" | grid2lh -o "$tmp/s"
	grid2lh "$tmp/n.phi" -o "$tmp/n"
	lhinterp -n 3 --align "$tmp/n" "$tmp/s" 2>"$tmp/said" | lh2grid -o "$tmp/m"
	[ ! -s "$tmp/said" ]
	lhdiff --no-hausdorff "$tmp/n.phi" "$tmp/m" | awk 'NR > 1 { print $7 }' >"$tmp/means"
	sort -gc "$tmp/means"
}

@test "very different sizes are noted; --scale gives the same as a scaled mesh" {
	mkmesh -n 300 face -o "$tmp/one.off"
	awk 'NR > 2 && NF == 3 { printf "%.17g %.17g %.17g\n", 64*$1, 64*$2, 64*$3; next } { print }' "$tmp/one.off" >"$tmp/large.off"
	mkmesh -n 250 face nose=0.5 | mesh2rect -q -n 16 | grid2lh --no-place -o "$tmp/other.lhg"
	for m in one large; do
		mesh2rect -q -n 16 "$tmp/$m.off" | grid2lh --no-place --residual -o "$tmp/$m.lhg"
	done
	mesh2rect -q -n 16 "$tmp/one.off" | grid2lh --no-place -o "$tmp/small.lhg"
	lhinterp -t 1 "$tmp/one.lhg" "$tmp/large.lhg" -o "$tmp/o" 2>"$tmp/err"
	grep -q '64 times as large as .*--scale' "$tmp/err"
	lhinterp -t 1 "$tmp/small.lhg" "$tmp/other.lhg" -o "$tmp/o" 2>"$tmp/err"
	run ! grep 'times as large' "$tmp/err"
	lhinterp -t 1 --scale "$tmp/one.lhg" "$tmp/large.lhg" -o "$tmp/scaled" 2>"$tmp/err"
	run ! grep 'times as large' "$tmp/err"
	python 'a, b = (read(f)[0] for f in sys.argv[1:])
assert list(a.channels) == list(b.channels) and "nu1" in a.channels and "band.x" in a.channels
for c in a.channels: assert np.abs(a[c] - b[c]).max() <= 1e-9*np.abs(a[c]).max(), c' "$tmp/one.lhg" "$tmp/scaled"
}

@test "--rule=linear is (1-t) A + t B, bit for bit, in every channel" {
	for r in '' .all; do
		lhinterp -q -t 0.3,0.7 --rule=linear "$tmp/a$r" "$tmp/b$r" -o "$tmp/linear"
		python 'a, b = (read(f)[0] for f in sys.argv[1:3])
for g in read(sys.argv[3]):
    t = float(g.meta["t"])
    assert g.T == (1 - t)*a.T + t*b.T
    for c in a.channels: assert g[c].tobytes() == ((1 - t)*a[c] + t*b[c]).tobytes(), c' "$tmp/a$r" "$tmp/b$r" "$tmp/linear"
	done
}

@test "by default log lambda and lambda^2 H are linear, with residual channels log g and lambda H, up to the length of the border" {
	lhinterp -q -t 0.3 "$tmp/a" "$tmp/b" -o "$tmp/metric"
	lhinterp -q -t 0.3 "$tmp/a.all" "$tmp/b.all" -o "$tmp/metric.all"
	python 'a, b, g, aa, ba, ga = (read(f)[0] for f in sys.argv[1:])
near = lambda x, y: abs(x - y).max() < 1e-11*abs(y).max()
mean = lambda f: 0.7*f(a) + 0.3*f(b)
def lengths(x):  # of the two edges of the border at each of its nodes
    d = np.linalg.norm(np.diff(ring(x), axis=0, append=ring(x)[:1]), axis=1)
    return np.log(d + np.roll(d, 1))
def follows_border(e):  # harmonic inside
    h, k = 1/(g.nu - 1), g.T/(g.nv - 1)
    inner = np.diff(e, 2, axis=1)[1:-1]/h**2 + np.diff(e, 2, axis=0)[:, 1:-1]/k**2
    want = lengths(g) - mean(lengths)
    edge = np.concatenate([e[0], e[1:, -1], e[-1, -2::-1], e[-2:0:-1, 0]])
    assert abs(want).max() > 1e-3 and abs(edge - want).max() < 1e-12
    assert abs(inner).max() < 1e-9*abs(want).max()/h**2
first = mean(lambda x: np.log(x["lambda"]))
follows_border(np.log(g["lambda"]) - first)
assert near(np.exp(first)*g["lambda"]*g["H"], mean(lambda x: x["lambda"]**2*x["H"]))
for c in set(a.channels) - {"lambda", "H"}: assert near(g[c], mean(lambda x: x[c])), c
a, b = aa, ba
def log(x):  # of the matrices of the metric
    l = x["lambda"]**2
    m = np.moveaxis(l*np.array([[1 + x["nu1"], x["nu2"]], [x["nu2"], 1 - x["nu1"]]]), (0, 1), (-2, -1))
    w, q = np.linalg.eigh(m)
    return q @ (np.log(w)[..., None]*np.swapaxes(q, -1, -2))
assert abs(ba["nu2"]).max() > 1e-3
e = log(ga)[..., 0, 0] - mean(log)[..., 0, 0]
assert near(log(ga), mean(log) + e[..., None, None]*np.eye(2))
follows_border(e/2)
assert near(ga["lambda"]*ga["H"], mean(lambda x: x["lambda"]*x["H"]))' "$tmp/a" "$tmp/b" "$tmp/metric" "$tmp/a.all" "$tmp/b.all" "$tmp/metric.all"
	lhinterp -q -t 1,0 --cap "$tmp/a" "$tmp/b" -o "$tmp/ends"
	equal "$tmp/a" "$tmp/ends"
	lhinterp -q -t 0,1 "$tmp/a.all" "$tmp/b.all" -o "$tmp/ends"
	equal "$tmp/b.all" "$tmp/ends"
	python 'g = read(sys.argv[1])[0]; g["lambda"][3, 4] = 0; lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/a" "$tmp/zero"
	try 1 'zero: lambda is 0 at node \(4,3\), must be positive' /dev/null lhinterp -t 0.5 "$tmp/a" "$tmp/zero"
	try 0 '' /dev/null lhinterp -q -t 0.5 --rule=linear "$tmp/a" "$tmp/zero"
	python 'g = read(sys.argv[1])[0]; del g.channels["tau2"]; lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/a.all" "$tmp/some"
	try 1 'some: no channel tau2' /dev/null lhinterp -t 0.5 "$tmp/some" "$tmp/some"
	try 2 'rule=cubic: need metric or linear' /dev/null lhinterp --rule=cubic -t 0.5 "$tmp/a" "$tmp/b"
}

@test "places become the start of a blend with residual channels, and are dropped otherwise" {
	mesh2rect -q -n 70x64 "$tmp/a.off" -o "$tmp/a.large"
	mesh2rect -q -n 70x64 --like="$tmp/a.phi" "$tmp/b.off" -o "$tmp/b.large"
	grid2lh --residual "$tmp/a.large" -o "$tmp/a.place"
	grid2lh --residual "$tmp/b.large" -o "$tmp/b.place"
	grid2lh --residual --no-place "$tmp/b.large" -o "$tmp/b.without"
	grid2lh "$tmp/a.large" -o "$tmp/a.plain"
	lhinterp -q -t 0.25 "$tmp/a.place" "$tmp/b.place" -o "$tmp/m"
	lhinterp -q -t 0.25 "$tmp/a.place" "$tmp/b.without" -o "$tmp/one"
	python 'a, b, m, one, start = (read(f)[0] for f in sys.argv[1:])
for c in "xyz":
    s = m.channels["start." + c]
    assert "place." + c not in m.channels and (s.support, s.step) == ("lattice", 1)
    want = (0.75*a["place." + c] + 0.25*b["place." + c]).ravel()
    assert abs(s.data - want).max() < 1e-14*abs(want).max()
    assert "place." + c not in one.channels
    assert one.channels["start." + c].step == start.channels["start." + c].step > 1
' "$tmp/a.place" "$tmp/b.place" "$tmp/m" "$tmp/one" "$tmp/b.without"
	lhinterp -q -t 0.25 "$tmp/a.plain" "$tmp/a.plain" -o "$tmp/m"
	python 'm, a = (read(f)[0] for f in sys.argv[1:])
assert "place.x" not in m.channels and m.channels["start.x"].step == a.channels["start.x"].step' "$tmp/m" "$tmp/a.plain"
	# from such a start the ends are the surfaces themselves
	lhinterp -q -t 1 "$tmp/a.place" "$tmp/b.place" | lh2grid -q -o "$tmp/end"
	below "$(error_of "$tmp/b.large" "$tmp/end" max_rel)" 1e-10
}

@test "-w is the weighted mean of many; one weight is for all; weights below 0 exaggerate" {
	mkmesh -n 800 face nose=1.3 | mesh2rect -q -n 24x20 --like="$tmp/a.phi" | grid2lh --no-place --residual -o "$tmp/c.all"
	lhinterp -q -w 1,2,5 --rule=linear "$tmp/a.all" "$tmp/b.all" "$tmp/c.all" -o "$tmp/mean"
	lhinterp -q -w 1,2,5 "$tmp/a.all" "$tmp/b.all" "$tmp/c.all" -o "$tmp/metric"
	python 'a, b, c, g, m = (read(f)[0] for f in sys.argv[1:])
assert g.meta["weights"] == "0.125,0.25,0.625" and "t" not in g.meta and g.frames == 1
for n in a.channels: assert abs(g[n] - (a[n] + 2*b[n] + 5*c[n])/8).max() < 1e-14*abs(g[n]).max(), n
s = lambda x: np.log(x["lambda"]) + np.log(1 - x["nu1"]**2 - x["nu2"]**2)/4
e = s(m) - (s(a) + 2*s(b) + 5*s(c))/8
lap = np.diff(e, 2, axis=1)[1:-1]*(g.nu - 1)**2 + np.diff(e, 2, axis=0)[:, 1:-1]*((g.nv - 1)/g.T)**2
assert abs(lap).max() < 1e-9
assert abs(m["lambda"] - g["lambda"]).max() > 1e-4*abs(m["lambda"]).max()' "$tmp/a.all" "$tmp/b.all" "$tmp/c.all" "$tmp/mean" "$tmp/metric"
	lhinterp -q --no-history -w 1 "$tmp/a" "$tmp/b" "$tmp/a" -o "$tmp/one"
	lhinterp -q --no-history -w 3,3,3 "$tmp/a" "$tmp/b" "$tmp/a" -o "$tmp/three"
	cmp "$tmp/one" "$tmp/three"
	lhinterp -q -w 0,7 "$tmp/a" "$tmp/b" -o "$tmp/end"
	equal "$tmp/b" "$tmp/end"
	lhinterp -q -w 7,3 "$tmp/a" "$tmp/b" -o "$tmp/w"
	lhinterp -q -t 0.3 "$tmp/a" "$tmp/b" -o "$tmp/t"
	equal "$tmp/w" "$tmp/t"
	# beyond A, as far again as from the middle to A; a blend with B leads back to A
	lhinterp -q -w 1.5,-0.5 "$tmp/a.all" "$tmp/b.all" -o "$tmp/beyond"
	lhinterp -q -w 2,1 "$tmp/beyond" "$tmp/b.all" -o "$tmp/back"
	python 'a, g = (read(f)[0] for f in sys.argv[1:])
for c in a.channels:  # what follows the border does so on charts of different heights
    bound = 1e-3 if c in ("lambda", "H", "tau1", "tau2") else 1e-11
    assert abs(a[c] - g[c]).max() < bound*abs(a[c]).max(), (c, abs(a[c] - g[c]).max()/abs(a[c]).max())' "$tmp/a.all" "$tmp/back"
	# each grid is checked, scaled and moved
	mkmesh -n 200 cap | mesh2rect -q -n 8 | grid2lh -o "$tmp/small"
	try 1 'small has 9 x 9'                         /dev/null lhinterp -q -w 1 "$tmp/a" "$tmp/b" "$tmp/small"
	try 1 'has a channel nu1, .* has none'          /dev/null lhinterp -q -w 1 "$tmp/a" "$tmp/b" "$tmp/a.all"
	python 'g = read(sys.argv[1])[0]
R = 3*np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]])
for n in "band.", "start.":
    x = R @ np.stack([g[n + c] for c in "xyz"]) + np.array([[5], [-7], [11]])
    for k, c in enumerate("xyz"): g[n + c][...] = x[k]
g["lambda"][:] *= 3; g["H"][:] /= 3
lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/b" "$tmp/away"
	lhinterp -q -w 1,1,2 "$tmp/a" "$tmp/a" "$tmp/b" --align --scale -o "$tmp/here"
	lhinterp -q -w 1,1,2 "$tmp/a" "$tmp/a" "$tmp/away" --align --scale -o "$tmp/there"
	python 'a, b = (read(f)[0] for f in sys.argv[1:])
for c in a.channels: assert abs(a[c] - b[c]).max() < 1e-9*abs(a[c]).max(), c' "$tmp/here" "$tmp/there"
	try 2 '2 weights for 3 grids'                   /dev/null lhinterp -w 1,1 a b c
	try 2 'the sum of the weights is 0, must be positive' /dev/null lhinterp -w 1,-2,1 a b c
	try 2 'the sum of the weights is 1e-07, must be positive, above 1e-06 of' /dev/null lhinterp -w 3,-2.9999999 a b
	python 'import subprocess
for f in sys.argv[1:3]:
    g = read(f)[0]; g["lambda"][:] *= 100; g["H"][:] /= 100; lhg.write(sys.argv[3], [g])
    for o in ("86,-85", "-85,86"):
        r = subprocess.run(["lhinterp", "-q", "-w", o, f, sys.argv[3]], capture_output=True, text=True)
        assert r.returncode == 1 and not r.stdout and "not in 1e-60 .. 1e+60" in r.stderr, r' "$tmp/a" "$tmp/a.all" "$tmp/large"
	try 2 'the sum of the weights is -1'            /dev/null lhinterp -w 1,-2 a b
	try 2 'landmarks is for -t and -n'              /dev/null lhinterp -w 1 --landmarks=x a b
	try 2 'ease is for -t and -n'                   /dev/null lhinterp -w 1 --ease a b
	try 2 'need either'                             /dev/null lhinterp -w 1 -t 0.5 a b
	try 1 'the weights give (lambda|a height T)'    /dev/null lhinterp -q -w 900,-899 --rule=linear "$tmp/a" "$tmp/b"
}

@test "the history of a mean has the steps of all, and lhinfo --history makes it again" {
	local home=$PWD
	cd "$tmp"
	lhinterp -q -w 1,2,1 a b a -o m3
	lhinterp -q -t 0.5 m3 b -o m4
	lhinfo m4 | awk '$1 == "history" { print $2, $3, $4 }' | grep -c '^A: [ABC]: mesh2rect$\|^B: mesh2rect --cells' | grep -qx 4
	lhinfo --history m4 >script
	sh script >again 2>"$tmp/err"
	(cd "$home" && equal "$tmp/m4" "$tmp/again")
	lhinterp --no-history -t 1 a b -o bare
	for w in 'bare a a' 'a bare a' 'a a bare'; do
		lhinterp -q -w 1 $w -o half
		try 1 'half: an input of a merge has no history' /dev/null lhinfo --history half
	done
	lhinterp -q -w 1 $(for i in $(seq 30); do echo a; done) -o many
	lhinfo many | grep -q 'history AD: grid2lh'
	[ "$(lhinfo --history many | grep -c mesh2rect)" = 30 ]
}

@test "K above H^2 is noted and --cap lowers lambda there, lambda^2 H stays; a face gets no note" {
	# a dome that becomes a bowl, with the same lambda
	mkmesh -n 900 cap angle=80 | mesh2rect -q -n 32 | grid2lh --no-place -o "$tmp/dome"
	python 'g = read(sys.argv[1])[0]
g["H"][:] *= -1
for n in "band.", "start.": g[n + "z"][...] *= -1
lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/dome" "$tmp/bowl"
	try 0 'frame 3 asks for K > H\^2, .* an integral of [1-9].* beyond .*--cap' /dev/null lhinterp -n 5 "$tmp/dome" "$tmp/bowl"
	try 0 '' /dev/null lhinterp --cap -n 5 "$tmp/dome" "$tmp/bowl"
	try 0 '' /dev/null lhinterp -n 5 "$tmp/a" "$tmp/b"
	lhinterp --cap -t 0,0.5,1 "$tmp/dome" "$tmp/bowl" -o "$tmp/capped"
	lhinterp -q -t 0.5 "$tmp/dome" "$tmp/bowl" -o "$tmp/plain"
	python 'c, p, d = read(sys.argv[1]), read(sys.argv[2])[0], read(sys.argv[3])[0]
for x in "lambda", "H": assert c[0][x].tobytes() == d[x].tobytes()
q = c[1]["lambda"]/p["lambda"]
assert q.max() <= 1 and q.min() < 0.9
assert (q[[0, -1]] == 1).all() and (q[:, [0, -1]] == 1).all()
assert abs(c[1]["lambda"]**2*c[1]["H"] - p["lambda"]**2*p["H"]).max() < 1e-12
def excess(g):
    l = np.log(g["lambda"]); h, k = 1/(g.nu - 1), g.T/(g.nv - 1)
    K = -(l[1:-1, 2:] - 2*l[1:-1, 1:-1] + l[1:-1, :-2])/h**2 - (l[2:, 1:-1] - 2*l[1:-1, 1:-1] + l[:-2, 1:-1])/k**2
    return np.maximum(K - (g["lambda"]*g["H"])[1:-1, 1:-1]**2, 0)[6:-6, 6:-6].sum()*h*k
assert excess(c[1]) < 0.6*excess(p)' "$tmp/capped" "$tmp/plain" "$tmp/dome"
	try 1 'has residual channels, --cap is for grids without' /dev/null lhinterp --cap -t 0.5 "$tmp/a.all" "$tmp/b.all"
}

@test "a warped grid keeps its mark in blends, and lhinfo, lhfft and grid2lh say what H is" {
	python 'g = read(sys.argv[1])[0]; g.meta["warped"] = sys.argv[3]; lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/b" "$tmp/far" '0.1 0.5'
	python 'g = read(sys.argv[1])[0]; g.meta["warped"] = sys.argv[3]; lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/b" "$tmp/near" '0.2 0.3'
	lhinterp -q -t 0,0.5,1 "$tmp/a" "$tmp/far" -o "$tmp/some"
	lhinterp -q -w 1,1,1 "$tmp/a" "$tmp/near" "$tmp/far" -o "$tmp/both"
	lhinterp -q -w 1,1,0 "$tmp/a" "$tmp/near" "$tmp/far" -o "$tmp/first"
	python 'some, both, first = map(read, sys.argv[1:])
assert [g.meta.get("warped") for g in some] == [None, "0.1 0.5", "0.1 0.5"]
assert both[0].meta["warped"] == "0.1 0.5" and first[0].meta["warped"] == "0.2 0.3"' "$tmp/some" "$tmp/both" "$tmp/first"
	lhinfo "$tmp/far" | grep -qx '  note the grid is warped, so H is (L+N)/(2 lambda^2) and not the mean curvature'
	run ! grep note <(lhinfo "$tmp/b")
	try 0 'far: the grid is warped, so H is .*not the mean curvature' /dev/null lhfft -K 1 "$tmp/far"
	try 0 '' /dev/null lhfft -K 1 "$tmp/b"
	lhinfo "$tmp/b.phi" | grep -q warped && false
	python 'g = read(sys.argv[1])[0]; g.meta["warped"] = "0.1 0.5"; lhg.write(open(sys.argv[2], "wb"), [g])' "$tmp/b.phi" "$tmp/far.phi"
	grid2lh -v "$tmp/far.phi" 2>"$tmp/said" >/dev/null
	grep -q 'far.phi: the grid is warped, so H is' "$tmp/said"
}

@test "a blend of boundaries that is a point is refused, unless the boundary is free" {
	python 'g = read(sys.argv[1])[0]
for c in "xyz": g["band." + c][:] *= -1
lhg.write(sys.argv[2], [g])' "$tmp/a" "$tmp/mirror"
	try 1 'frame 1: the blend of the boundaries is a point: --align' /dev/null lhinterp -q -t 0.5 "$tmp/a" "$tmp/mirror"
	lhinterp -q --boundary=free -n 3 "$tmp/a" "$tmp/mirror" >"$tmp/out"
	lhinterp -q --align -n 3 "$tmp/a" "$tmp/mirror" >"$tmp/out"
}
