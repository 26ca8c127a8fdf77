# pillowmesh.bats - mesh2rect on closed surfaces: onto the pillow and back, its options and its messages.

load helper

setup_file() {
	load helper
	for k in sphere ellipsoid bumpy; do
		mkmesh -n 3000 $k -o "$tmp/$k.off"
		mesh2rect -n 96 --uv="$tmp/$k-uv.ply" "$tmp/$k.off" -o "$tmp/$k" 2>"$tmp/$k.err"
		grid2lh "$tmp/$k" -o "$tmp/$k.lh"
	done
}

# datum FILE KEY: prints a metadatum.
datum() {
	lhinfo "$1" | sed -n "s/^  meta $2 //p"
}

# python SCRIPT ARGS..: runs SCRIPT with lhg, numpy as np, and grid(f), the one grid of a file.
python() {
	PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "import sys; sys.path.insert(0, 'scripts'); import lhg, numpy as np
def grid(f): return next(lhg.read(f))
$1" "${@:2}"
}

@test "a closed surface goes onto the pillow by itself, of about as many nodes as the rectangle" {
	for k in sphere ellipsoid bumpy; do
		[ ! -s "$tmp/$k.err" ]
		lhinfo "$tmp/$k" | head -1 | grep -q 'nodes of a pillow'
		read -r nu nv < <(sed -n 's/^size //p;/^end/q' "$tmp/$k")
		[ $((nu*nv)) -gt 8500 ] && [ $((nu*nv)) -lt 10500 ] # about 97 x 97
		[ "$(datum "$tmp/$k" cones | tr , '\n' | sort -u | wc -l)" = 4 ]
		below "$(datum "$tmp/$k" chi2)" 1.4
		below "$(datum "$tmp/$k" farthest)" 0.003
		run -1 grep -aq '^meta corners' "$tmp/$k"
	done
	mesh2rect --chart=pillow -n 96 "$tmp/bumpy.off" --no-history | cmp - <(mesh2rect -n 96 --chart=auto "$tmp/bumpy.off" --no-history)
}

# phi of the ellipsoid is (aX, bY, cZ): its H is known from its place.
@test "H of sphere and ellipsoid, and the grid is conformal" {
	python 'g = grid(sys.argv[1])
assert np.abs(g["H"] + 1).mean() < 4e-3, np.abs(g["H"] + 1).mean()' "$tmp/sphere.lh"
	python 'g, p = grid(sys.argv[1]), grid(sys.argv[2]); a = np.array([1.5, 1, .7])[:, None, None]
x = np.array([p[c] for c in "xyz"]); h = ((x/a**2)**2).sum(0)**-.5
H = h**3*((x*x).sum(0) - (a*a).sum())/(2*(a**2).prod())
assert np.median(np.abs(g["H"]/H - 1)) < 5e-3, np.median(np.abs(g["H"]/H - 1))' "$tmp/ellipsoid.lh" "$tmp/ellipsoid"
	for k in sphere ellipsoid bumpy; do
		grid2lh -v "$tmp/$k" 2>&1 >/dev/null | sed -n 's/.*median \([^,]*\), mean.*/\1/p' >"$tmp/mu"
		below "$(cat "$tmp/mu")" 5e-4
	done
}

@test "the polish is of use, and --split, too" {
	mu() { mesh2rect "$@" "$tmp/ellipsoid.off" | grid2lh -v 2>&1 >/dev/null | sed -n 's/.*median \([^,]*\), mean.*/\1/p'; }
	below "$(mu -n 64 --polish=0 --split=0)" 2e-3
	below "$(mu -n 64 --polish=0)" 7e-4
	below "$(mu -n 64 --split=0)" 7e-4
	below "$(mu -n 64)" 4e-4
}

@test "the surface comes back from lambda and H, and the mesh that went in, too" {
	for k in ellipsoid bumpy; do
		lh2grid --no-place "$tmp/$k.lh" -o "$tmp/back"
		below "$(error_of "$tmp/$k" "$tmp/back" mean_rel)" 5e-4
		grid2mesh --on "$tmp/$k-uv.ply" "$tmp/$k" -o "$tmp/on.off"
		below "$(error_of "$tmp/$k.off" "$tmp/on.off" max_rel)" 1e-9
		lhfft --scale=5% "$tmp/$k.lh" | lh2grid | grid2mesh --on "$tmp/$k-uv.ply" -o "$tmp/on.off"
		below "$(error_of "$tmp/$k.off" "$tmp/on.off" max_rel)" 0.02
	done
}

@test "faces across the folds have texture coordinates of their own in OBJ; --on knows the chart" {
	mesh2rect -n 32 --uv="$tmp/uv.obj" "$tmp/bumpy.off" -o "$tmp/coarse"
	/usr/bin/python3 - "$tmp/uv.obj" <<-'EOF'
		import sys
		vt, area = [], 0
		for line in open(sys.argv[1]):
		    w = line.split()
		    if line.startswith("# lhgrid T"):
		        T = float(w[3])
		    if w[0] == "vt":
		        vt.append((float(w[1]), float(w[2])))
		    if w[0] == "f":
		        (a, b), (c, d), (e, f) = (vt[int(x.split("/")[1]) - 1] for x in w[1:])
		        area += ((c - a)*(f - b) - (e - a)*(d - b))/2
		        assert (c - a)*(f - b) > (e - a)*(d - b)
		assert .95 < area/T < 1, area/T                 # but for the faces that hold a cone
	EOF
	grid2mesh --on="$tmp/uv.obj" "$tmp/coarse" -o "$tmp/on.obj"
	cmp <(grep ^vt "$tmp/uv.obj") <(grep ^vt "$tmp/on.obj")
	below "$(error_of "$tmp/bumpy.off" "$tmp/on.obj" max_rel)" 1e-9
}

@test "--with: a field of the vertices is sampled on the pillow" {
	awk 'NR == 1 || NR == 2' "$tmp/bumpy.off" >/dev/null
	grid2mesh --on "$tmp/bumpy-uv.ply" --with=H "$tmp/bumpy.lh" -o "$tmp/H.shape.gii" || skip "no channel to write"
	mesh2rect -n 96 --with="$tmp/H.shape.gii" "$tmp/bumpy.off" -o "$tmp/with"
	python 'g, h = grid(sys.argv[1]), grid(sys.argv[2])
name = [c for c in g.channels if c not in "xyz"][0]
assert np.abs(g[name] - h["H"]).mean() < .01, np.abs(g[name] - h["H"]).mean()' "$tmp/with" "$tmp/bumpy.lh"
}

@test "--cones: three vertices become cones, the fourth follows" {
	mesh2rect -v -n 64 --cones=5,1700,2500 "$tmp/bumpy.off" -o "$tmp/chosen" 2>"$tmp/err"
	[[ $(datum "$tmp/chosen" cones) == 5,1700,2500,* ]]
	grep -q 'cones at or near the vertices 5,1700,2500,[0-9]*, of which the fourth follows' "$tmp/err"
	# The nodes beside them are near these vertices: (0,0), (1/2,0), (1/2,T).
	python 'g = grid(sys.argv[1]); v = [[float(x) for x in l.split()] for l in open(sys.argv[2]).read().split("\n")[2:]]
for n, j, i in ((5, 0, 0), (1700, 0, g.nu//2), (2500, -1, g.nu//2)):
    d = np.linalg.norm([g[c][j, i] for c in "xyz"] - np.array(v[n])); assert d < .05, (n, d)' "$tmp/chosen" "$tmp/bumpy.off"
	mesh2rect -n 64 --cones="$(awk 'NR == 8 || NR == 1703 || NR == 2503 { printf "%s%s,%s,%s", s, $1, $2, $3; s = ";" }' "$tmp/bumpy.off")" \
		"$tmp/bumpy.off" --no-history | cmp - <(mesh2rect -n 64 --cones=5,1700,2500 "$tmp/bumpy.off" --no-history)
	try 2 'three vertex numbers or three points'  /dev/null mesh2rect --cones=1,2 "$tmp/bumpy.off"
	try 1 'two cones are vertex 5'                /dev/null mesh2rect --cones=5,9,5 "$tmp/bumpy.off"
	try 1 'not a vertex of a face'                /dev/null mesh2rect --cones=5,9,99999 "$tmp/bumpy.off"
}

@test "what cannot be is said" {
	mkmesh -n 500 cap -o "$tmp/cap.off"
	try 1 'the surface has a boundary, .*mesh2disk --holes=all closes it' /dev/null mesh2rect --chart=pillow "$tmp/cap.off"
	try 1 'closed surface: no boundary, which --chart=sock needs; mesh2disk --open=auto' /dev/null mesh2rect --chart=sock "$tmp/bumpy.off"
	try 2 'even number of cells'                  /dev/null mesh2rect -n 31x20 "$tmp/bumpy.off"
	try 2 'no boundary, hence no corners'         /dev/null mesh2rect -c 1,2,3,4 "$tmp/bumpy.off"
	# A torus of 12 x 8 quadrilaterals.
	awk 'BEGIN { n = 12; m = 8; print "OFF\n" n*m, n*m, 0; t = 8*atan2(1, 1)
		for (i = 0; i < n; i++) for (j = 0; j < m; j++) { r = 2 + cos(t*j/m); print r*cos(t*i/n), r*sin(t*i/n), sin(t*j/m) }
		for (i = 0; i < n; i++) for (j = 0; j < m; j++)
			print 4, i*m + j, (i+1)%n*m + j, (i+1)%n*m + (j+1)%m, i*m + (j+1)%m }' >"$tmp/torus.off"
	try 1 'a closed surface with 1 handle, .*--handles=cut' /dev/null mesh2rect "$tmp/torus.off"
	# Cones far from the tips of a needle: nearly all nodes would lie in between.
	mkmesh -n 3000 ellipsoid a=20 b=1 c=1 -o "$tmp/needle.off"
	try 1 'the three cones cannot be told apart on the sphere: other --cones' /dev/null mesh2rect -n 32 --cones=5,9,12 "$tmp/needle.off"
	try 1 "so long, or a limb is, that its tip is lost in rounding" /dev/null mesh2rect -n 32 "$tmp/needle.off"
	mkmesh -n 3000 ellipsoid a=3 b=1 c=1 -o "$tmp/needle.off"
	try 1 'chi\^2 .* is above 100'                /dev/null mesh2rect -n 32 --cones=5,900,1600 "$tmp/needle.off"
	mesh2rect -q -n 32 --max-loss=1 --force --cones=5,900,1600 "$tmp/needle.off" -o "$tmp/forced"
	below 100 "$(datum "$tmp/forced" chi2)"
	mkmesh -n 3000 ellipsoid a=4 b=1 c=1 -o "$tmp/needle.off"
	try 0 'chi\^2 .*: parts of the surface get few nodes; three tips' /dev/null mesh2rect -n 32 --cones=5,40,70 "$tmp/needle.off"
}

@test "coarse meshes: a tetrahedron and a cube" {
	printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' >"$tmp/tetra.off"
	mesh2rect -q -n 96 "$tmp/tetra.off" -o "$tmp/tetra"
	below "$(datum "$tmp/tetra" farthest)" 0.05
	printf 'OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n' \
		>"$tmp/cube.off"
	mesh2rect -q -n 96 "$tmp/cube.off" -o "$tmp/cube"
	below "$(datum "$tmp/cube" farthest)" 0.03
}

@test "equal bytes for any number of threads" {
	for j in 2 3; do
		mesh2rect -n 48 -j $j "$tmp/bumpy.off" --no-history | cmp - <(mesh2rect -n 48 -j 1 "$tmp/bumpy.off" --no-history)
	done
}
