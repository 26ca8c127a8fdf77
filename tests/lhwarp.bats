# lhwarp.bats - lhwarp: a map that brings corresponding places together, landmarks, quarter turns, refusals.

load helper

setup_file() {
	load helper
	mkmesh -n 3000 face -o "$tmp/a.off"
	mkmesh -n 2000 face smile=0.8 nose=0.6 -o "$tmp/b.off"
	mesh2rect -q -n 64x56 --uv="$tmp/a-uv.ply" "$tmp/a.off" -o "$tmp/a"
	mesh2rect -q -n 96x84 --uv="$tmp/b-uv.ply" --like="$tmp/a" "$tmp/b.off" -o "$tmp/b"
	mesh2rect -q -n 24 --chart=sock "$tmp/a.off" -o "$tmp/sock"
}

# python SCRIPT ARGS..: runs SCRIPT with lhg and numpy as np; one(f) is the grid of a file.
python() {
	/usr/bin/python3 -c "import sys; sys.path.insert(0, 'scripts'); import lhg, numpy as np
def one(f): return list(lhg.read(f))[0]
$1" "${@:2}"
}

@test "B known to be A under a map: positions meet after lhwarp" {
	# B: A's surface sampled at other places of its chart, so that the inverse map gives A back
	python '
a = one(sys.argv[1]); v, u = np.meshgrid(np.linspace(0, 1, 113), np.linspace(0, 1, 129), indexing="ij")
x = u + .05*np.sin(np.pi*u)*np.cos(np.pi*v); y = v - .03*np.sin(np.pi*v)*(1 + np.cos(2*np.pi*u))
b = lhg.Grid(129, 113, a.T)
for c in "xyz":
    f = a[c]; s = x*(a.nu - 1); t = y*(a.nv - 1); i = np.minimum(s.astype(int), a.nu - 2); j = np.minimum(t.astype(int), a.nv - 2); s -= i; t -= j
    b.channels[c] = lhg.Channel((1-t)*((1-s)*f[j, i] + s*f[j, i+1]) + t*((1-s)*f[j+1, i] + s*f[j+1, i+1]), "length")
lhg.write(sys.argv[2], [b])' "$tmp/a" "$tmp/known"
	lhwarp -v "$tmp/a" "$tmp/known" -o "$tmp/back" 2>"$tmp/err"
	python '
a, b, k = map(one, sys.argv[1:4]); assert (b.nu, b.nv, b.T) == (a.nu, a.nv, a.T)
P = np.stack([a[c] for c in "xyz"]); Q = np.stack([b[c] for c in "xyz"]); R = np.stack([k[c] for c in "xyz"])[:, ::2, ::2]
far = np.sqrt(((P - Q)**2).sum(0)).mean(); was = np.sqrt(((P - R)**2).sum(0)).mean()
assert far < .4*was, (far, was)
before, after = map(float, b.meta["warp-normals"].split()); assert after < .1*before
mean, most = map(float, b.meta["warped"].split()); assert 0 < mean < most < .6' "$tmp/a" "$tmp/back" "$tmp/known"
	grep -q 'turned by 0, 1, 2, 3 quarters' "$tmp/err"
	grep -q '|mu| mean' "$tmp/err"
}

@test "landmarks by u v, by points and by vertex numbers; --no-normals; --max-mu" {
	python '
a = one(sys.argv[1]); b = one(sys.argv[2])
uv = open(sys.argv[3] + "-uv", "w"); p = open(sys.argv[3] + "-xyz", "w")
for u, v, d, e in ((.3, .3, .04, 0), (.7, .3, 0, .03), (.5, .6, -.03, .02)):
    print(u, v*a.T, u + d, (v + e)*b.T, "# comment", file=uv)
    i = lambda g, u, v: (round(v*(g.nv - 1)), round(u*(g.nu - 1)))
    print(*[a[c][i(a, u, v)] for c in "xyz"], *[b[c][i(b, u + d, v + e)] for c in "xyz"], file=p)' "$tmp/a" "$tmp/b" "$tmp/marks"
	lhwarp -q -l "$tmp/marks-uv" "$tmp/a" "$tmp/b" -o "$tmp/w"
	lhwarp -q --no-normals -l "$tmp/marks-uv" "$tmp/a" "$tmp/b" -o "$tmp/only"
	lhwarp -q --no-normals -l "$tmp/marks-xyz" "$tmp/a" "$tmp/b" -o "$tmp/points"
	lhwarp -q --no-normals --max-mu=0.1 -l "$tmp/marks-uv" "$tmp/a" "$tmp/b" -o "$tmp/stiff"
	python '
w, only, points, stiff = map(one, sys.argv[1:])
for g in (w, only, points):
    before, after = map(float, g.meta["warp-landmarks"].split()); assert before > .03 and after < .01, (before, after)
assert float(stiff.meta["warped"].split()[1]) < .1 < float(only.meta["warped"].split()[1])' \
		"$tmp/w" "$tmp/only" "$tmp/points" "$tmp/stiff"
	# landmarks so far apart that the bound decides, by default 0.6
	python 'T = one(sys.argv[1]).T; print(.4, T/2, .55, T/2); print(.6, T/2, .6, T/2)' "$tmp/a" >"$tmp/far"
	lhwarp -q --no-normals --max-mu=0.9 -l "$tmp/far" "$tmp/a" "$tmp/b" -o "$tmp/free"
	lhwarp -q --no-normals -l "$tmp/far" "$tmp/a" "$tmp/b" -o "$tmp/bound"
	lhwarp -q --no-normals --max-mu=0.5 -l "$tmp/far" "$tmp/a" "$tmp/b" -o "$tmp/low"
	python '
g = list(map(one, sys.argv[1:])); free, bound, low = (float(x.meta["warped"].split()[1]) for x in g)
assert .5 < bound < .6 < free and low < .5, (low, bound, free)
# the bound stiffens the few cells that reach it, not all: the landmarks still meet
far = [float(x.meta["warp-landmarks"].split()[1]) for x in g]; assert far[0] < far[1] < far[2] < .007, far' \
		"$tmp/free" "$tmp/bound" "$tmp/low"
	printf '100 120\n200,210\n' >"$tmp/numbers"
	lhwarp -q --no-normals -l "$tmp/numbers" --uv-a="$tmp/a-uv.ply" --uv-b="$tmp/b-uv.ply" "$tmp/a" "$tmp/b" | lhinfo |
		grep -q 'meta warp-landmarks'
	try 1 'line 1: two vertex numbers need --uv-a' /dev/null lhwarp -l "$tmp/numbers" "$tmp/a" "$tmp/b"
	echo '0 99999' >"$tmp/numbers"
	try 1 'line 1: .*b-uv.ply has no vertex 99999: 0 to' /dev/null lhwarp -l "$tmp/numbers" --uv-a="$tmp/a-uv.ply" \
		--uv-b="$tmp/b-uv.ply" "$tmp/a" "$tmp/b"
}

@test "B's mesh is sampled with --uv-b, other channels are warped, --scale gives A's size" {
	python '
b = one(sys.argv[1]); b.channels["U"] = lhg.Channel(np.tile(np.linspace(0, 1, b.nu), (b.nv, 1)), "1")
for c in "xyz": b.channels[c].data[:] *= 3
lhg.write(sys.argv[2], [b])' "$tmp/b" "$tmp/big"
	lhwarp -q --scale "$tmp/a" "$tmp/big" -o "$tmp/scaled"
	try 0 'big is 2.96 times as large as .*--scale brings .*big to the area of' /dev/null lhwarp "$tmp/a" "$tmp/big"
	try 0 '' /dev/null lhwarp --scale "$tmp/a" "$tmp/big"
	lhwarp -q "$tmp/a" "$tmp/b" -o "$tmp/grid"
	lhwarp -q --uv-b="$tmp/b-uv.ply" "$tmp/a" "$tmp/b" -o "$tmp/mesh"
	python '
a, s, g, m = map(one, sys.argv[1:])
area = lambda g: (lambda P: np.linalg.norm(np.cross(np.diff(P, axis=1)[:-1], np.diff(P, axis=0)[:, :-1]), axis=-1).sum())(np.stack([g[c] for c in "xyz"], -1))
assert abs(area(s)/area(a) - 1) < .02, area(s)/area(a)
U = s["U"]; assert np.abs(U[:, 0]).max() < 1e-12 and np.abs(U[:, -1] - 1).max() < 1e-12 and U.min() > -1e-12
far = max(np.abs(g[c] - m[c]).max() for c in "xyz"); assert 0 < far < .01*area(a)**.5, far' "$tmp/a" "$tmp/scaled" "$tmp/grid" "$tmp/mesh"
}

@test "a grid turned by a quarter is turned back; unlike surfaces are refused without --force" {
	python '
b = one(sys.argv[1]); g = lhg.Grid(b.nv, b.nu, 1/b.T)
for c in "xyz": g.channels[c] = lhg.Channel(np.ascontiguousarray(b[c].T[::-1]), "length")
lhg.write(sys.argv[2], [g])' "$tmp/b" "$tmp/turned"
	try 0 'turned by 3 quarters to fit' /dev/null lhwarp "$tmp/a" "$tmp/turned"
	lhdiff -q "$tmp/out" <(lhwarp -q "$tmp/a" "$tmp/b") >"$tmp/diff"
	python 'rows = dict(l.split()[:2] for l in open(sys.argv[1]).read().splitlines()); assert float(rows["max_rel"]) < 1e-3, rows' "$tmp/diff"
	mkmesh -n 2000 cortex | mesh2rect -q -n 64x56 -o "$tmp/cortex"
	try 1 'in no way clearly better .*--landmarks; or .*lhinterp --scale --align --cap; or --force' /dev/null lhwarp "$tmp/a" "$tmp/cortex"
	lhwarp -q --force "$tmp/a" "$tmp/cortex" | lhinfo | grep -q "meta warped"
}

@test "of two ways that fit alike, half a turn apart, that is taken which turns B less in space" {
	# ovals that fit a little better after half a turn
	python '
for name, side, ripple in (sys.argv[1], 1, 0), (sys.argv[2], -1, .012):
    y, x = np.meshgrid(np.linspace(-.65, .65, 66), np.linspace(-.5, .5, 65), indexing="ij")
    z = .8*np.exp(-4*x**2 - 1.5*y**2) + .03*np.exp(-60*((x - side*.2)**2 + (y - side*.3)**2)) + ripple*np.cos(25*x)*np.cos(25*y)
    g = lhg.Grid(65, 66, 1.3)
    for c, f in zip("xyz", (x, y, z)): g.channels[c] = lhg.Channel(f, "length")
    lhg.write(name, [g])' "$tmp/oval" "$tmp/other"
	try 0 'nearly as well after half a turn .*by 0 degrees, not 180' /dev/null lhwarp "$tmp/oval" "$tmp/other"
	lhinfo "$tmp/out" | grep -q 'meta warped'
	[ "$(lhinfo "$tmp/out" | grep -c warp-turned)" = 0 ]
}

@test "refusals" {
	try 2 '.no-normals needs --landmarks' /dev/null lhwarp --no-normals "$tmp/a" "$tmp/b"
	try 2 'max-mu=1: need a number in \[0.01,0.99\]' /dev/null lhwarp --max-mu=1 "$tmp/a" "$tmp/b"
	try 1 'is on a sock; lhwarp takes rectangles only: mesh2rect --chart=rectangle' /dev/null lhwarp "$tmp/a" "$tmp/sock"
	try 1 'is on a pillow; lhwarp takes rectangles only: mesh2rect --like' /dev/null lhwarp "$tmp/a" <(mkmesh -n 500 sphere | mesh2rect -q -n 16)
	grid2lh "$tmp/b" -o "$tmp/lh"
	try 1 'no channel x' /dev/null lhwarp "$tmp/a" "$tmp/lh"
	echo 'one two' >"$tmp/bad"
	try 1 'bad: line 1: one is not a number' /dev/null lhwarp -l "$tmp/bad" "$tmp/a" "$tmp/b"
	printf '\n0.1 0.1 1.2 0.1\n' >"$tmp/bad"
	try 1 'bad: line 2: \(1.2,0.1\) is not in \[0,1\] x \[0,' /dev/null lhwarp -l "$tmp/bad" "$tmp/a" "$tmp/b"
	echo '1 2 3' >"$tmp/bad"
	try 1 'bad: line 1: 3 numbers, need' /dev/null lhwarp -l "$tmp/bad" "$tmp/a" "$tmp/b"
	echo '# nothing' >"$tmp/bad"
	try 1 'bad: no landmarks' /dev/null lhwarp -l "$tmp/bad" "$tmp/a" "$tmp/b"
	python 'g = one(sys.argv[1]); g.T *= 1.2; lhg.write(sys.argv[2], [g])' "$tmp/b" "$tmp/high"
	try 1 'any map has .mu. of at least 0.09' /dev/null lhwarp --max-mu=0.05 "$tmp/a" "$tmp/high"
	try 1 'its chart is .* high, that of .* need the mesh that mesh2rect --uv wrote' /dev/null \
		lhwarp --uv-b="$tmp/b-uv.ply" "$tmp/a" "$tmp/high"
}

@test "a warped surface comes back from lh2grid" {
	lhwarp -q "$tmp/a" "$tmp/b" | tee "$tmp/w" | grid2lh --residual | lh2grid -q -o "$tmp/again"
	lhdiff -q "$tmp/w" "$tmp/again" >"$tmp/diff"
	python 'rows = dict(l.split()[:2] for l in open(sys.argv[1]).read().splitlines()); assert float(rows["max_rel"]) < 1e-6, rows' "$tmp/diff"
}

# Where ragged borders do not correspond, the fit alone crosses itself: in frames 2 to 5, at 5 to 13 pairs.
@test "between two scans of a face no frame of a morph crosses itself" {
	[ -d "$meshes/good" ] || skip "no meshes in $meshes"
	mesh2rect -q -n 96 "$meshes/good/face_neutral_1875.obj" -o "$tmp/neutral"
	mesh2rect -q -n 96 --like="$tmp/neutral" "$meshes/good/face_smile_1656.obj" | lhwarp -q --scale "$tmp/neutral" - |
		grid2lh -q --residual -o "$tmp/smile"
	grid2lh -q --residual "$tmp/neutral" | lhinterp -q -n 6 - "$tmp/smile" | lh2grid -q -o "$tmp/morph"
	lhdiff --no-hausdorff "$tmp/neutral" "$tmp/morph" | awk -F '\t' '
		NR == 1 { for (i = 1; i <= NF; i++) if ($i == "self_intersections_b") c = i; next }
		{ frames++; crossing += $c } END { exit !(c && frames == 6 && crossing == 0) }'
}
