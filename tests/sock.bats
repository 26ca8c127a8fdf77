# sock.bats - the sock: the whole pipeline on it, its options and its messages.

load helper

setup_file() {
	load helper
	mkmesh -n 3000 cap -o "$tmp/cap.off"            # the unit sphere as far as 60 degrees: H = -1
	mesh2rect --chart=sock -n 96 --uv="$tmp/uv.ply" "$tmp/cap.off" -o "$tmp/phi" 2>"$tmp/phi.err"
	grid2lh --residual "$tmp/phi" -o "$tmp/res"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	mesh2rect -n 96 "$tmp/cap.off" | grid2lh -o "$tmp/flat"
}

# datum FILE KEY: prints a metadatum.
datum() {
	lhinfo "$1" | sed -n "s/^  meta $2 //p"
}

@test "a sock is version 2 of lhg, has its chart in line 5, and rows at the boundary" {
	[ ! -s "$tmp/phi.err" ]                         # no triangle is turned over
	[ "$(head -1 "$tmp/phi")" = 'lhg 2' ]
	[ "$(sed -n 5p "$tmp/phi")" = 'chart sock' ]
	lhinfo "$tmp/phi" | head -1 | grep -q 'nodes of a sock'
	read -r nu nv < <(sed -n 's/^size //p;/^end/q' "$tmp/lh")
	[ $((nu*nv)) -gt 8500 ] && [ $((nu*nv)) -lt 10500 ]     # about 97 x 97
	grep -aq '^channel band.x length border 3$' "$tmp/lh"
	lhinfo "$tmp/lh" | grep 'band.x' | grep -q " $((3*nu)) samples"
}

@test "H of a sphere, and the surface back from lambda and H" {
	lhinfo --json "$tmp/lh" | /usr/bin/python3 -c '
import json, sys
H = next(c for c in json.load(sys.stdin)["channels"] if c["name"] == "H")
assert abs(H["mean"] + 1) < .01, H["mean"]'
	lh2grid "$tmp/lh" -o "$tmp/back"
	below "$(error_of "$tmp/phi" "$tmp/back" mean_rel)" 3e-4
	lh2grid --no-place "$tmp/lh" -o "$tmp/back"
	below "$(error_of "$tmp/phi" "$tmp/back" mean_rel)" 3e-4
	lh2grid --no-place --no-start "$tmp/lh" -o "$tmp/back"
	below "$(error_of "$tmp/phi" "$tmp/back" mean_rel)" 3e-4
	lh2grid --boundary=free "$tmp/lh" -o "$tmp/back"
	below "$(error_of "$tmp/phi" "$tmp/back" mean_rel)" 2e-3
	lh2grid --no-place "$tmp/res" -o "$tmp/back"
	below "$(error_of "$tmp/phi" "$tmp/back" max_rel)" 1e-8
}

@test "the mesh of a sock is a disk, and the mesh that went in comes back" {
	grid2mesh "$tmp/phi" -o "$tmp/sock.off"
	try 0 '' /dev/null mesh2disk --check "$tmp/sock.off"
	grid2mesh --on "$tmp/uv.ply" "$tmp/phi" -o "$tmp/on.off"
	below "$(error_of "$tmp/cap.off" "$tmp/on.off" max_rel)" 1e-9
	lhfft --scale=5% "$tmp/lh" | lh2grid | grid2mesh --on "$tmp/uv.ply" -o "$tmp/on.off"
	below "$(error_of "$tmp/cap.off" "$tmp/on.off" max_rel)" 0.02
}

# Each face is drawn in one piece: together they have the area T of the sock, and none is turned over.
@test "faces across seam and fold have texture coordinates of their own in OBJ; --on knows the chart" {
	mesh2rect --chart=sock -n 32 --uv="$tmp/uv.obj" "$tmp/cap.off" -o "$tmp/coarse"
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
		assert abs(area/T - 1) < 1e-6, area/T
	EOF
	grid2mesh --on="$tmp/uv.obj" "$tmp/coarse" -o "$tmp/on.obj"
	cmp <(grep ^vt "$tmp/uv.obj") <(grep ^vt "$tmp/on.obj")
	cmp <(grep ^f "$tmp/uv.obj") <(grep ^f "$tmp/on.obj")
	mesh2rect -n 16 --uv="$tmp/flat.obj" "$tmp/cap.off" -o "$tmp/rect"
	grep -q 'lhgrid chart' "$tmp/flat.obj" && return 1
	for mesh in uv.obj uv.ply; do
		try 1 'on a sock, .*rect is on a rectangle: mesh2rect --chart=rectangle' /dev/null \
			grid2mesh --on="$tmp/$mesh" "$tmp/rect" -o "$tmp/none.off"
		try 1 'on a sock' /dev/null grid2mesh --on="$tmp/$mesh" --with=lambda "$tmp/flat" -o "$tmp/none.shape.gii"
	done
	try 1 'on a rectangle, .*phi is on a sock: mesh2rect --chart=sock' /dev/null \
		grid2mesh --on="$tmp/flat.obj" "$tmp/phi"
	[ ! -e "$tmp/none.off" ]
}

@test "filters: all is kept, or only what is smooth" {
	lhfft -K 0 "$tmp/lh" --no-history -o "$tmp/same"
	PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 - "$tmp/lh" "$tmp/same" <<-'EOF'
		import sys
		sys.path.insert(0, "scripts")
		import lhg
		a, b = (next(lhg.read(f)) for f in sys.argv[1:])
		assert (a["lambda"] == b["lambda"]).all() and (a["H"] == b["H"]).all()
	EOF
	for how in -K1 --scale=10% --relief=1% --keep=200 --energy=.9 --low-pass=8; do
		lhfft $how "$tmp/lh" | lh2grid -o "$tmp/smooth"
		below "$(error_of "$tmp/phi" "$tmp/smooth" mean_rel)" 0.02
	done
	try 1 'a sock is not periodic along v' /dev/null lhfft --paper -K 1 "$tmp/lh"
	try 1 'a sock is not periodic along v' /dev/null lhfft -K 1 --basis=dft --spectrum="$tmp/table" "$tmp/lh"
	[ ! -e "$tmp/table" ]
}

@test "morphs: the ends are met, charts are not mixed, --like finds which cone is which" {
	lhinterp -t 0,1 "$tmp/lh" "$tmp/lh" | lh2grid -o "$tmp/ends"
	below "$(lhdiff --no-hausdorff "$tmp/phi" "$tmp/ends" | awk 'NR == 3 { print $7 }')" 3e-4
	try 1 'flat on a rectangle: mesh2rect --chart=sock' /dev/null lhinterp -t .5 "$tmp/lh" "$tmp/flat"
	read -r a b < <(datum "$tmp/phi" cones | tr , ' ')
	try 0 '' /dev/null mesh2rect --chart=sock --cones="$b,$a" --like="$tmp/phi" "$tmp/cap.off" -o "$tmp/like"
	[ "$(datum "$tmp/like" cones)" = "$a,$b" ]
	below "$(datum "$tmp/like" like)" 1e-9
	below "$(error_of "$tmp/phi" "$tmp/like" max_rel)" 1e-9
	try 1 'needs a sock' /dev/null mesh2rect --chart=sock --like="$tmp/flat" "$tmp/cap.off"
}

@test "each frame of a morph may start from the one before, or from key frames" {
	lhinterp -n 5 "$tmp/lh" "$tmp/lh" -o "$tmp/still"
	lh2grid "$tmp/still" -o "$tmp/alone"
	for how in --follow --keyframes=2; do
		lh2grid $how "$tmp/still" -o "$tmp/there"
		lhdiff --no-hausdorff --no-self-intersections "$tmp/alone" "$tmp/there" | awk -F '\t' '
			NR == 1 { for (i = 1; i <= NF; i++) if ($i == "max_rel") c = i; next }
			{ bad += !($c < 1e-4) } END { exit NR != 6 || bad }'
	done
}

@test "a moved, turned and scaled mesh has the same sock" {
	mkmesh -n 3000 face -o "$tmp/face.off"          # no symmetry, so its best cones are those two
	awk 'NR < 3 || NF != 3 { print; next } { printf "%.17g %.17g %.17g\n", 7 - 3*$2, 3*$1 + 5, 3*$3 - 2 }' \
		"$tmp/face.off" >"$tmp/moved.off"
	mesh2rect --chart=sock -n 64 "$tmp/face.off" -o "$tmp/here"
	mesh2rect --chart=sock -n 64 "$tmp/moved.off" -o "$tmp/there"
	PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 - "$tmp/here" "$tmp/there" <<-'EOF'
		import sys
		sys.path.insert(0, "scripts")
		import lhg
		a, b = (next(lhg.read(f)) for f in sys.argv[1:])
		assert a.meta["cones"] == b.meta["cones"]
		assert abs(a.T - b.T) < 1e-9
		assert abs(7 - 3*a["y"] - b["x"]).max() < 1e-6 and abs(3*a["z"] - 2 - b["z"]).max() < 1e-6
	EOF
}

@test "options that do not fit are refused" {
	try 2 'even number of cells' /dev/null mesh2rect --chart=sock -n 31x20 "$tmp/cap.off"
	try 2 'needs --chart=sock' /dev/null mesh2rect --cones=9,10 "$tmp/cap.off"
	try 2 'two vertex numbers or two points' /dev/null mesh2rect --chart=sock --cones=9 "$tmp/cap.off"
	try 1 'cone 0 is a vertex of the boundary' /dev/null mesh2rect --chart=sock --cones=0,900 "$tmp/cap.off"
	mkmesh -n 8 cap -o "$tmp/one.off"
	try 1 'no two inner vertices \(of 1\) .*: --chart=rectangle' "$tmp/one.off" mesh2rect --chart=sock
	mesh2rect -q -n 16 --chart=auto "$tmp/one.off" | head -1 | grep -qx 'lhg 1'
	try 1 'both cones are vertex 900' /dev/null mesh2rect --chart=sock --cones=900,900 "$tmp/cap.off"
	try 1 'not a vertex of a face' /dev/null mesh2rect --chart=sock --cones=900,99999 "$tmp/cap.off"
	try 1 'frame method is for the rectangle' /dev/null lh2grid --method=frame "$tmp/lh"
	mesh2rect --chart=sock -n 40x12 "$tmp/cap.off" | lhinfo | head -1 | grep -q ': 40 x 12 nodes'
}

@test "a sock that is far too low or too high is refused" {
	for T in 1e-4 60; do
		PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 - "$tmp/lh" "$T" "$tmp/bad" <<-'EOF'
			import sys
			sys.path.insert(0, "scripts")
			import lhg
			g = next(lhg.read(sys.argv[1]))
			g.T = float(sys.argv[2])
			lhg.write(sys.argv[3], [g])
		EOF
		try 1 'height T is .*, not in' /dev/null lh2grid "$tmp/bad"
		try 1 'height T is .*, not in' /dev/null lhfft -K 1 "$tmp/bad"
	done
}

@test "--chart=auto: the rectangle for a cap, the sock for a head; without it a note" {
	[ "$(mesh2rect --chart=auto -n 32 "$tmp/cap.off" | head -1)" = 'lhg 1' ]
	[ -d "$meshes/good" ] || skip "no meshes in $meshes"
	[ "$(mesh2rect --chart=auto -n 32 "$meshes/good/head_man_26k.ply" 2>/dev/null | head -1)" = 'lhg 2' ]
	mesh2rect -n 32 "$meshes/good/head_man_26k.ply" 2>&1 >/dev/null | grep -q 'chart=sock'
}

@test "a bunny keeps its ears" {
	[ -d "$meshes/good" ] || skip "no meshes in $meshes"
	mesh2rect --chart=sock -n 192 "$meshes/good/bunny_28k.ply" -o "$tmp/bunny" 2>/dev/null
	below 0.98 "$(datum "$tmp/bunny" kept)"
	[ "$(datum "$tmp/bunny" turned)" = 0 ]
	below "$(datum "$tmp/bunny" chi2)" 6
	grid2lh "$tmp/bunny" | lhfft --scale=3% | lh2grid -o "$tmp/smooth"
	[ "$(lhdiff "$tmp/bunny" "$tmp/smooth" | awk '$1 == "self_intersections_b" { print $2 }')" = 0 ]
}
