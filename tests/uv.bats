# uv.bats - (u,v) on the vertices of meshes: mesh2rect --uv and --flip, grid2mesh --on and --detail.

load helper

setup_file() {
	load helper
	mkmesh -n 800 torus -o "$tmp/torus.off"
	mkmesh -n 300 cap -o "$tmp/cap.off"
	mesh2rect -n 64 --uv="$tmp/uv.obj" "$tmp/torus.off" -o "$tmp/phi"
	mesh2rect -n 64 --uv="$tmp/uv.ply" "$tmp/torus.off" >/dev/null
	grep -v '# lhgrid' "$tmp/uv.obj" >"$tmp/bare.obj"       # neither T nor offsets
	grid2lh "$tmp/phi" -o "$tmp/phi.lh"
	# two quads, a triangle and a vertex of no face, in a file as a person would write it
	cat >"$tmp/quads.obj" <<-EOF
		v 9 9 9
		v 0 0 0
		v 1 0 0
		v 2 0 .1
		v 0 1 0
		v 1 1 0.2
		v 2 1 .1
		v 3 .5 0
		f 2 3 6 5
		f 3 4 7 6
		f 4 8 7
	EOF
}

# numbers FILE WORD: prints the rest of each line that begins with WORD.
numbers() {
	sed -n "s/^$2 //p" "$1"
}

# apart A B: prints the largest distance between corresponding vertices of two OBJ files.
apart() {
	paste -d ' ' <(numbers "$1" v) <(numbers "$2" v) |
		awk '{ d = sqrt(($1-$4)^2 + ($2-$5)^2 + ($3-$6)^2); if (d > m) m = d } END { print m + 0 }'
}

@test "--uv writes the mesh as it was read, with T and the (u,v) of every vertex" {
	[ "$(numbers "$tmp/uv.obj" v)" = "$(awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2' "$tmp/torus.off")" ]
	[ "$(numbers "$tmp/uv.obj" f | sed 's:/[0-9]*::g')" = \
		"$(awk 'NR == 2 { n = $1 } NR > n + 2 && NR > 2 { print $2 + 1, $3 + 1, $4 + 1 }' "$tmp/torus.off")" ]
	numbers "$tmp/uv.obj" f | tr ' /' '\n ' | awk '$1 != $2 { exit 1 }'
	[ "$(numbers "$tmp/uv.obj" vt | wc -l)" = "$(numbers "$tmp/uv.obj" v | wc -l)" ]
	T=$(numbers "$tmp/uv.obj" '# lhgrid T')
	numbers "$tmp/uv.obj" vt | awk -v T="$T" '!($1 >= 0 && $1 <= 1 && $2 >= 0 && $2 <= T) { exit 1 }'
	[ "$(numbers "$tmp/uv.obj" vt | sed -n '1p;2p;3p;4p' | tr '\n' ,)" = "0 0,1 0,1 $T,0 $T," ]
	lhinfo "$tmp/phi" | grep -q "T ${T:0:9}"
}

@test "without offsets --on gives the surface back on the vertices and faces of its mesh" {
	for n in 16 64; do
		mesh2rect -n $n --uv="$tmp/n.obj" "$tmp/torus.off" | grid2mesh --on="$tmp/n.obj" --detail=drop -o "$tmp/back$n.obj"
		cmp <(numbers "$tmp/n.obj" f) <(numbers "$tmp/back$n.obj" f)
	done
	below "$(apart "$tmp/uv.obj" "$tmp/back64.obj")" 0.01
	below "$(apart "$tmp/uv.obj" "$tmp/back64.obj")" "$(apart "$tmp/uv.obj" "$tmp/back16.obj")"
}

@test "--on is the same through OBJ, PLY, gzip, stdin; OFF holds the same vertices and faces" {
	grid2mesh --on="$tmp/uv.obj" "$tmp/phi" -o "$tmp/a.obj"
	grid2mesh --on="$tmp/uv.ply" "$tmp/phi" -o "$tmp/b.obj"
	gzip -c "$tmp/uv.ply" >"$tmp/uv.ply.gz"
	grid2mesh --on="$tmp/uv.ply.gz" -o "$tmp/c.obj" <"$tmp/phi"
	grid2mesh --on=- "$tmp/phi" -o "$tmp/d.obj" <"$tmp/uv.obj"
	cmp "$tmp/a.obj" "$tmp/b.obj"
	cmp "$tmp/a.obj" "$tmp/c.obj"
	cmp "$tmp/a.obj" "$tmp/d.obj"
	grid2mesh --on="$tmp/a.obj" "$tmp/phi" | cmp - <(grid2mesh --on="$tmp/uv.obj" "$tmp/phi")
	grid2mesh --on="$tmp/uv.obj" "$tmp/phi" | sed 1,2d | grep -v '^3 [0-9]* [0-9]* [0-9]*$' | cmp - <(numbers "$tmp/a.obj" v)
	mesh2rect -n 8 "$tmp/a.obj" >/dev/null
}

@test "with offsets every vertex comes back: on its grid exactly, after K = 0 to the error of the fit" {
	for e in obj ply; do
		mesh2rect -n 16 --uv="$tmp/o.$e" "$tmp/torus.off" -o "$tmp/o"
		for d in keep smooth; do
			grid2mesh -q --on="$tmp/o.$e" --detail=$d "$tmp/o" -o "$tmp/oback.obj"
			below "$(apart "$tmp/uv.obj" "$tmp/oback.obj")" 1e-13
		done
	done
	grid2lh --residual "$tmp/o" | lhfft -K 0 | lh2grid | grid2mesh --on="$tmp/o.ply" -o "$tmp/oback.obj"
	below "$(apart "$tmp/uv.obj" "$tmp/oback.obj")" 1e-5
	grid2mesh --on="$tmp/oback.obj" "$tmp/o" -o "$tmp/again.obj"
	below "$(apart "$tmp/uv.obj" "$tmp/again.obj")" 1e-13
}

@test "a finger that the grid loses comes back" {
	[ -d "$meshes" ] || skip "no folder $meshes"
	mesh2rect -n 64 --uv="$tmp/finger.obj" "$meshes/wild/c06b_finger_8.off" -o "$tmp/finger"
	grid2mesh --on="$tmp/finger.obj" "$tmp/finger" -o "$tmp/fingerback.obj"
	below "$(apart "$tmp/finger.obj" "$tmp/fingerback.obj")" 1e-12
	grid2mesh --on="$tmp/finger.obj" --detail=drop "$tmp/finger" -o "$tmp/fingerback.obj"
	below 1 "$(apart "$tmp/finger.obj" "$tmp/fingerback.obj")"
}

@test "offsets fade against the waves that lhfft keeps, more the coarser it is" {
	mesh2rect -n 16 --uv="$tmp/s.ply" "$tmp/torus.off" | grid2lh | lhfft --low-pass=4 -o "$tmp/s.lh"
	lhinfo "$tmp/s.lh" | grep -Eq 'waves (3\.[5-9]|4)'
	lh2grid "$tmp/s.lh" -o "$tmp/s"
	for d in keep drop smooth; do
		grid2mesh --on="$tmp/s.ply" --detail=$d "$tmp/s" -o "$tmp/s-$d.obj"
	done
	cmp "$tmp/s-keep.obj" <(grid2mesh --on="$tmp/s.ply" "$tmp/s" -o "$tmp/x.obj"; cat "$tmp/x.obj")
	[ "$(grep -c offset "$tmp/s-drop.obj")" = 0 ]
	below 0 "$(apart "$tmp/s-drop.obj" "$tmp/s-smooth.obj")"
	below "$(apart "$tmp/s-drop.obj" "$tmp/s-smooth.obj")" "$(apart "$tmp/s-drop.obj" "$tmp/s-keep.obj")"
	# each of several scales has its own number of waves; after two filters the smaller number holds
	lhfft --low-pass=6,2,6 "$tmp/s.lh" -o "$tmp/three"
	lhinfo "$tmp/three" | awk '$1 == "meta" && $2 == "waves" { n[++k] = $3 } END { exit !(k == 3 && n[1] == n[3] && n[2] < n[1]) }'
	[ "$(lhfft --low-pass=2 "$tmp/s.lh" | lhfft --low-pass=3 | lhinfo | grep waves)" = "$(lhfft --low-pass=2 "$tmp/s.lh" | lhinfo | grep waves)" ]
	lhfft -K 0 "$tmp/phi.lh" 2>/dev/null | lhinfo | grep -c waves && return 1
	try 0 'no metadatum waves' "$tmp/phi" grid2mesh --on="$tmp/uv.ply" --detail=smooth
	try 0 'bare.obj: no offsets, so --detail changes nothing' "$tmp/phi" grid2mesh --on="$tmp/bare.obj" --detail=keep
	try 0 '' "$tmp/phi" grid2mesh --on="$tmp/bare.obj"
	try 2 '--detail needs --on' "$tmp/phi" grid2mesh --detail=drop
	try 2 'detail' "$tmp/phi" grid2mesh --on="$tmp/uv.ply" --detail=some
	sed 's/^# lhgrid offset [^ ]*/# lhgrid offset 1e308/' "$tmp/uv.obj" >"$tmp/huge.obj"
	try 1 'huge.obj: vertex [0-9]+ has an offset that is too large' <(grid2lh "$tmp/phi" | lhfft -q -K 0 | lh2grid) grid2mesh --on="$tmp/huge.obj"
	sed '0,/^# lhgrid offset/{/^# lhgrid offset/d}' "$tmp/uv.obj" >"$tmp/fewer.obj"
	try 1 'fewer.obj: 781 offsets for 782 vertices' "$tmp/phi" grid2mesh --on="$tmp/fewer.obj"
}

@test "a renumbered mesh has the same vertices in another order" {
	awk 'NR == 2 { n = $1 } NR <= 2 { print; next } NR <= n + 2 { x[NR-3] = $0; if (NR == n + 2) for (i = n - 1; i >= 0; i--) print x[i]; next }
		{ print 3, n-1-$2, n-1-$3, n-1-$4 }' "$tmp/torus.off" >"$tmp/turned.off"
	nv=$(awk 'NR == 2 { print $1 }' "$tmp/torus.off")
	mesh2rect -n 16 -c 0,1,2,3 --uv="$tmp/r1.obj" "$tmp/torus.off" >/dev/null
	mesh2rect -n 16 -c $((nv-1)),$((nv-2)),$((nv-3)),$((nv-4)) --uv="$tmp/r2.obj" "$tmp/turned.off" -o "$tmp/r2"
	grid2mesh --on="$tmp/r2.obj" "$tmp/r2" -o "$tmp/rback.obj"
	paste -d ' ' <(numbers "$tmp/uv.obj" v | tac) <(numbers "$tmp/rback.obj" v) |
		awk '($1-$4)^2 + ($2-$5)^2 + ($3-$6)^2 > 1e-24 { exit 1 }'
	paste -d ' ' <(numbers "$tmp/r1.obj" '# lhgrid offset' | tac) <(numbers "$tmp/r2.obj" '# lhgrid offset') |
		awk '($1-$5)^2 + ($2-$6)^2 + ($3-$7)^2 > 1e-16 { exit 1 }'
}

@test "a flat sheet comes back exactly" {
	mkmesh -n 500 rectangle -o "$tmp/flat.off"
	mesh2rect -n 20x30 -c 0,1,2,3 --uv="$tmp/flat.obj" "$tmp/flat.off" | grid2mesh --on="$tmp/flat.obj" -o "$tmp/flatback.obj"
	below "$(apart "$tmp/flat.obj" "$tmp/flatback.obj")" 1e-9
}

@test "quads stay quads and vertices of no face stay where they are" {
	try 0 '1 unreferenced vertex dropped' /dev/null mesh2rect -n 32 --uv="$tmp/q.obj" "$tmp/quads.obj"
	cp "$tmp/out" "$tmp/q"
	[ "$(numbers "$tmp/q.obj" f | head -1)" = "2/2 3/3 6/6 5/5" ]
	[ "$(numbers "$tmp/q.obj" vt | head -1)" = "-1 -1" ]
	try 0 'q.obj: 1 vertex without \(u,v\) stays in place' "$tmp/q" grid2mesh --on="$tmp/q.obj" -o "$tmp/qb.obj"
	cmp <(numbers "$tmp/q.obj" f) <(numbers "$tmp/qb.obj" f)
	[ "$(numbers "$tmp/qb.obj" v | head -1)" = "9 9 9" ]
	try 0 '' "$tmp/q" grid2mesh -q --on="$tmp/q.obj"
	[ "$(sed -n '11,13p' "$tmp/out" | tr '\n' ,)" = "4 1 2 5 4,4 2 3 6 5,3 3 7 6," ]
}

@test "every repaired mesh gets its own vertices and faces back" {
	[ -d "$meshes" ] || skip "no folder $meshes"
	for f in quads_wrapped_lines.off soup_duplicated_vertices.off orientation_half_flipped.obj unreferenced_vertices.ply; do
		grid=$tmp/repaired
		mesh2rect -q -n 64 --uv="$tmp/r.obj" "$meshes/bad/$f" -o "$grid"
		grid2mesh -q --on="$tmp/r.obj" "$grid" -o "$tmp/rb.obj"
		cmp <(numbers "$tmp/r.obj" f) <(numbers "$tmp/rb.obj" f)
	done
	cmp <(numbers "$tmp/r.obj" vt | grep -c '^-1 -1$') <(echo 3542)
	cmp <(numbers "$tmp/r.obj" v | wc -l) <(echo 8618)
	mesh2rect -q -n 8 --uv="$tmp/r.obj" "$meshes/bad/orientation_half_flipped.obj" >/dev/null
	cmp <(numbers "$tmp/r.obj" f | sed 's:/[0-9]*::g') <(numbers "$meshes/bad/orientation_half_flipped.obj" f | tr -d '\r')
	mesh2rect -q -n 8 --uv="$tmp/r.obj" "$meshes/bad/quads_wrapped_lines.off" >/dev/null
	[ "$(numbers "$tmp/r.obj" f | awk 'NF == 4' | wc -l)" = 1838 ]
}

@test "frames of a morph have the same faces, and v is scaled to their T" {
	grid2lh "$tmp/phi" -o "$tmp/a.lh"
	mesh2rect -n 64 "$tmp/cap.off" | grid2lh -o "$tmp/b.lh"
	lhinterp -n 3 "$tmp/a.lh" "$tmp/b.lh" | lh2grid -o "$tmp/morph"
	grid2mesh --on="$tmp/uv.obj" "$tmp/morph" -o "$tmp/frame-%d.obj"
	for i in 1 2 3; do
		cmp <(numbers "$tmp/uv.obj" f) <(numbers "$tmp/frame-$i.obj" f)
		T=$(numbers "$tmp/frame-$i.obj" '# lhgrid T')
		[ "$(numbers "$tmp/frame-$i.obj" vt | sed -n 3p)" = "1 $T" ]
		grid2mesh --on="$tmp/uv.ply" "$tmp/morph" -o "$tmp/frame-%d.ply"
		mesh2rect -n 8 "$tmp/frame-$i.ply" >/dev/null
	done
	[ "$(numbers "$tmp/frame-1.obj" '# lhgrid T')" != "$(numbers "$tmp/frame-3.obj" '# lhgrid T')" ]
}

@test "a file without T has v in units of the grid" {
	grep -v '# lhgrid T' "$tmp/uv.obj" | cmp -s "$tmp/uv.obj" - && return 1
	grid2mesh --on=<(grep -v '# lhgrid T' "$tmp/uv.obj") "$tmp/phi" | cmp - <(grid2mesh --on="$tmp/uv.obj" "$tmp/phi")
	grid2mesh --on="$tmp/bare.obj" "$tmp/phi" | cmp - <(grid2mesh --on="$tmp/uv.obj" --detail=drop "$tmp/phi")
	sed 's/^vt .*/vt 0.5 1e9/' "$tmp/bare.obj" >"$tmp/far.obj"
	try 1 'far.obj: vertex 0 has \(u,v\) = \(0.5,1e\+09\), outside \[0,1\] x \[0,' "$tmp/phi" grid2mesh --on="$tmp/far.obj"
}

@test "--flip reverses the normal and nothing else" {
	mesh2rect -n 32 -c 0,1,2,3 "$tmp/cap.off" | grid2lh -o "$tmp/front"
	mesh2rect -n 32 --flip -c 0,3,2,1 "$tmp/cap.off" | grid2lh -o "$tmp/back"
	H=$(lhinfo "$tmp/front" | awk '$2 == "H" { for (i = 1; i < NF; i++) if ($i == "mean") print $(i+1) }')
	mH=$(lhinfo "$tmp/back" | awk '$2 == "H" { for (i = 1; i < NF; i++) if ($i == "mean") print -$(i+1) }')
	awk -v a="$H" -v b="$mH" 'BEGIN { exit !(a < -0.5 && b < -0.5 && (a - b)^2 < 1e-4) }'
	try 1 'do not go round the boundary once' "$tmp/cap.off" mesh2rect --flip -c 0,1,2,3
	mesh2rect -n 32 --flip --uv="$tmp/f.obj" "$tmp/cap.off" | grid2mesh --on="$tmp/f.obj" -o "$tmp/fb.obj"
	below "$(apart "$tmp/f.obj" "$tmp/fb.obj")" 0.02
	[ "$(numbers "$tmp/f.obj" f | sed 's:/[0-9]*::g' | head -1)" = \
		"$(awk 'NR == 2 { n = $1 } NR == n + 3 { print $2 + 1, $3 + 1, $4 + 1 }' "$tmp/cap.off")" ]
}

@test "errors of --uv and --on" {
	try 2 'need a name that ends in .obj or .ply' "$tmp/cap.off" mesh2rect --uv="$tmp/x.off"
	try 2 'need a name that ends in .obj or .ply' "$tmp/cap.off" mesh2rect --uv=-
	cp "$tmp/uv.ply" "$tmp/same.ply"
	ln -s same.ply "$tmp/link.ply"
	ln "$tmp/same.ply" "$tmp/hard.ply"
	for o in same.ply ./same.ply ../"${tmp##*/}"/same.ply link.ply; do
		try 2 'the grid is written there' "$tmp/cap.off" mesh2rect -n 8 --uv="$tmp/same.ply" -o "$tmp/$o"
		try 2 'the mesh is read from there' /dev/null mesh2rect -n 8 --uv="$tmp/$o" "$tmp/same.ply"
	done
	try 2 'the grid is written there' "$tmp/cap.off" mesh2rect -n 8 --uv="$tmp/new.ply" -o "$tmp/./new.ply"
	cmp "$tmp/uv.ply" "$tmp/same.ply"
	[ ! -e "$tmp/new.ply" ]
	try 0 '' "$tmp/cap.off" mesh2rect -n 8 --uv="$tmp/same.ply" -o "$tmp/hard.ply"
	lhinfo "$tmp/hard.ply" >/dev/null
	mesh2rect -n 8 "$tmp/same.ply" >/dev/null
	try 2 'the grid is read from stdin' "$tmp/phi" grid2mesh --on=-
	try 2 'need a name that ends in .off .obj .ply .pial .white .vtp or .gii' /dev/null grid2mesh --on="$tmp/uv.obj" "$tmp/phi" -o "$tmp/x.stl"
	[ ! -e "$tmp/x.stl" ]
	try 1 'nosuch.obj: No such file'        "$tmp/phi" grid2mesh --on="$tmp/nosuch.obj"
	try 1 'torus.off: only OBJ and PLY carry \(u,v\)' "$tmp/phi" grid2mesh --on="$tmp/torus.off"
	try 1 'quads.obj: face 0 gives no vt for vertex 1' "$tmp/phi" grid2mesh --on="$tmp/quads.obj"
	printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 .1\nvt .5 .1\nf 1/1 2/2 3/3\nf 2/4 4/4 3/3\n' >"$tmp/seam.obj"
	try 1 'seam.obj: vertex 1 has two \(u,v\), the second in face 1: a seam' "$tmp/phi" grid2mesh --on="$tmp/seam.obj"
	try 0 '' /dev/null mesh2rect -n 8 "$tmp/seam.obj"
	try 1 'No such file or directory'       "$tmp/cap.off" mesh2rect -n 8 --uv="$tmp/nodir/x.obj"
}

@test "--uv to the file of stdout, of stdin, or behind a dangling link of -o is refused" {
	cp "$tmp/cap.off" "$tmp/mesh.off" 2>/dev/null || mkmesh -n 200 cap -o "$tmp/mesh.off"
	mesh2rect -q -n 8 --uv="$tmp/base.obj" "$tmp/mesh.off" -o "$tmp/grid"
	cp "$tmp/base.obj" "$tmp/m.obj"
	ln -s none.obj "$tmp/dangling.obj"
	run -2 mesh2rect -q -n 8 --uv="$tmp/dangling.obj" -o "$tmp/none.obj" "$tmp/m.obj"
	run -2 bash -c 'mesh2rect -q -n 8 --uv="$1" "$2" >"$1"' - "$tmp/out.obj" "$tmp/m.obj"
	run -2 bash -c 'mesh2rect -q -n 8 --uv="$1" - <"$1" >/dev/null' - "$tmp/m.obj"
	cmp "$tmp/base.obj" "$tmp/m.obj"
	run -2 bash -c 'grid2lh "$2" | lhfft -q -K 1 --spectrum="$1" >"$1"' - "$tmp/table" "$tmp/grid"
}
