# mesh2disk.bats - what people really have goes in: files with known faults, made here and real.

load helper

setup_file() {
	load helper
	mkmesh -n 300 face -o "$tmp/face.off"
	mkmesh -n 300 face -o "$tmp/face.stl"
}

# faces FILE FIRST LAST: prints an OFF file without these faces, counted from 0.
without_faces() {
	awk -v a="$2" -v b="$3" 'NR == 2 { nv = $1; print $1, $2 - (b - a + 1), 0; next }
		NR > 2 + nv { f = NR - 3 - nv; if (f >= a && f <= b) next } { print }' "$1"
}

# head_of FILE: prints the header of a PLY.
head_of() { sed -n '1,/^end_header/p' "$1" | tr -d '\0'; }

@test "a disk goes through unchanged, and again byte by byte" {
	try 0 '' "$tmp/face.off" mesh2disk
	mv "$tmp/out" "$tmp/once.ply"
	try 0 '' "$tmp/once.ply" mesh2disk
	cmp "$tmp/once.ply" "$tmp/out"
	try 0 '' "$tmp/face.off" mesh2disk -o "$tmp/same.off"
	cmp "$tmp/face.off" "$tmp/same.off"
	head_of "$tmp/once.ply" | grep -q '^property int source$'
	head_of "$tmp/once.ply" | grep -q '^property uchar filled$'
}

@test "what the file says of its coordinates goes along" {
	mesh2disk "$tmp/face.off" | LC_ALL=C sed '/^format/a comment lhgrid fact space tkras' >"$tmp/fact.ply"
	try 0 '' "$tmp/fact.ply" mesh2disk
	[ "$(mesh2rect -q -n 8 --max-loss=1 "$tmp/out" | lhinfo | grep -c 'meta space tkras$')" = 1 ]
}

@test "each change is one note, and a comment in the output" {
	without_faces "$tmp/face.off" 300 300 >"$tmp/hole.off"
	try 0 'stdin: 1 hole filled by 1 face and 0 vertices, flat, the longest [0-9.]+ round$' "$tmp/hole.off" mesh2disk
	head_of "$tmp/out" | grep -q '^comment mesh2disk: 1 hole filled'
	mv "$tmp/out" "$tmp/filled.ply"
	try 0 '' "$tmp/filled.ply" mesh2rect -n 4
	try 0 '' "$tmp/hole.off" mesh2disk -q
	try 0 'welded to others at the same place' "$tmp/face.stl" mesh2disk
	mesh2disk "$tmp/hole.off" -o "$tmp/filled.off" 2>"$tmp/err"
	grep -q 'OFF has no place for source and filled, PLY does$' "$tmp/err"
}

@test "mesh2rect refuses and names the remedy" {
	without_faces "$tmp/face.off" 300 300 >"$tmp/hole.off"
	try 1 '2 boundary loops, .*mesh2disk fills all but the longest' "$tmp/hole.off" mesh2rect
	printf 'OFF\n6 2 0\n0 0 0\n3 0 0\n0 1 0\n5 5 5\n6 5 5\n5 6 5\n3 0 1 2\n3 3 4 5\n' >"$tmp/two.off"
	try 1 '2 components, a disk is one; mesh2disk keeps the largest, 75 % of the area' "$tmp/two.off" mesh2rect
	try 0 '1 of 2 components kept; the others have 25 % of the area' "$tmp/two.off" mesh2disk
	printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' >"$tmp/tetra.off"
	try 1 'closed surface: no boundary.*; mesh2disk --open=auto cuts it open' "$tmp/tetra.off" mesh2rect --chart=sock
	try 1 'has a boundary, .*: --chart=sock or rectangle, or mesh2disk --holes=all closes it' "$tmp/face.off" \
		mesh2rect --chart=pillow
	try 0 'the surface is closed and stays so, .*; --open=auto' "$tmp/tetra.off" mesh2disk
}

@test "--check reports all faults at once, as text and as JSON" {
	without_faces "$tmp/face.off" 300 300 | awk 'NR == 2 { nv = $1; print $1 + 4, $2 + 3, 0; next } { print }
		NR == 2 + nv { print "9 9 9\n9 9 8\n9 8 9\n7 7 7" }
		END { print "3 0 0 1\n3", nv, nv + 1, nv + 2; print }' >"$tmp/three.off"
	try 0 '' "$tmp/three.off" mesh2disk --check
	grep -Eq '^vertices of no face +1 ' "$tmp/out"
	grep -Eq '^faces without corners +1 ' "$tmp/out"
	grep -Eq '^faces said twice +1 ' "$tmp/out"
	grep -Eq '^components +2 ' "$tmp/out"
	grep -Eq '^boundary loops +2 ' "$tmp/out"
	grep -Eq '^holes filled +1 ' "$tmp/out"
	grep -Eq '^result: a disk, ' "$tmp/out"
	try 0 '' "$tmp/three.off" mesh2disk --check --json
	python3 - "$tmp/out" <<-'END'
		import json, sys
		r = json.load(open(sys.argv[1]))
		assert r['unused_vertices'] == 1 and r['faces_without_corners'] == 1 and r['faces_twice'] == 1
		assert len(r['components']) == 2 and len(r['loops']) == 2 and r['holes_filled'] == 1
		assert r['result'] == 'disk' and r['result_vertices'] == r['vertices'] - 4
	END
	printf 'OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n' >"$tmp/a\"b.off"
	mesh2disk --check "$tmp/a\"b.off" | grep -q '^result: refused: no face has area$'
	mesh2disk --check --json "$tmp/a\"b.off" >"$tmp/out"
	python3 - "$tmp/out" <<-'END'
		import json, sys
		r = json.load(open(sys.argv[1]))
		assert r['file'].endswith('a"b.off') and r['result'] == 'refused' and r['reason'] == 'no face has area'
	END
	try 2 '--json needs --check' "$tmp/face.off" mesh2disk --json
}

@test "the result comes back to the original mesh: filled faces go, vertices have their numbers" {
	mkmesh -n 2000 cap -o "$tmp/cap.off"
	awk 'NR == 2 { nv = $1 }                        # a hole of all faces near the middle
		NR > 2 && NR <= nv + 2 { near[NR-3] = $1*$1 + $2*$2 < 0.03 }
		NR > nv + 2 && near[$2] + near[$3] + near[$4] { next } { line[++n] = $0 }
		END { line[2] = nv " " n - 2 - nv " 0"; for (i = 1; i <= n; i++) print line[i] }' "$tmp/cap.off" >"$tmp/hole.off"
	mesh2disk -q "$tmp/hole.off" -o "$tmp/disk.ply"
	[ "$(mesh2disk --check --json "$tmp/hole.off" | grep -o '"holes_filled": [0-9]*')" = '"holes_filled": 1' ]
	mesh2rect -q -n 32 --uv="$tmp/uv.ply" "$tmp/disk.ply" -o "$tmp/phi"
	head_of "$tmp/uv.ply" | grep -q '^property int source$'
	head_of "$tmp/uv.ply" | grep -q '^property uchar filled$'
	try 0 'faces that fill holes left out' "$tmp/phi" grid2mesh --on="$tmp/uv.ply" -o "$tmp/back.off"
	mesh2disk -q --holes=keep "$tmp/hole.off" -o "$tmp/clean.off"   # as it was, without unused vertices
	[ "$(sed -n 2p "$tmp/back.off")" = "$(sed -n 2p "$tmp/clean.off")" ]
	below "$(error_of "$tmp/back.off" "$tmp/clean.off" max_rel)" 1e-6
	try 0 '' "$tmp/phi" grid2mesh --on="$tmp/uv.ply" --filled=keep -o "$tmp/kept.ply"
	[ "$(head_of "$tmp/kept.ply" | grep element)" = "$(head_of "$tmp/disk.ply" | grep element)" ]
	head_of "$tmp/kept.ply" | grep -q '^property int source$'
	try 0 'faces that fill holes left out' "$tmp/phi" grid2mesh --on="$tmp/uv.ply" --detail=drop -o "$tmp/back.off"
	try 0 'x.obj: only PLY marks the faces' "$tmp/disk.ply" mesh2rect -n 8 --uv="$tmp/x.obj" -o "$tmp/phi"
	try 2 '--filled needs --on' "$tmp/phi" grid2mesh --filled=keep
	try 2 'filled=no: need drop or keep' "$tmp/phi" grid2mesh --filled=no
}

@test "wrong options exit 2" {
	try 2 'weld=-1: need a number in \[0,'        /dev/null mesh2disk --weld=-1
	try 2 'need a whole number in \[1,'           /dev/null mesh2disk --components=0
	try 2 'holes=some: need all, fill or keep'    /dev/null mesh2disk --holes=some
	try 2 'need a number in \[0,1\]'              /dev/null mesh2disk --max-hole=2
	try 2 'fill=C3: need flat, C1 or C2'          /dev/null mesh2disk --fill=C3
	try 2 'handles=x: need refuse or cut'         /dev/null mesh2disk --handles=x
	try 2 'open=1,2: need none, auto or X,Y,Z'    /dev/null mesh2disk --open=1,2
	try 2 'open=1,2,3,4: need none, auto or'      /dev/null mesh2disk --open=1,2,3,4
	try 2 'need a name that ends in'              /dev/null mesh2disk -o "$tmp/x.xyz"
}

@test "holes: --max-hole, --holes=keep and all" {
	without_faces "$tmp/face.off" 300 300 >"$tmp/hole.off"
	try 0 'no disk: more than one boundary loop' "$tmp/hole.off" mesh2disk --holes=keep
	try 0 'no disk: more than one boundary loop' "$tmp/hole.off" mesh2disk --max-hole=0.001
	mesh2disk -q --holes=all "$tmp/hole.off" -o "$tmp/closed.ply"
	try 0 'the surface is closed' "$tmp/closed.ply" mesh2disk
}

@test "points without faces: refused, or joined" {
	mkmesh -n 400 cap -o "$tmp/cap.off"
	awk 'NR == 2 { n = $1; $2 = 0 } NR <= n + 2' "$tmp/cap.off" >"$tmp/points.off"
	try 1 'points without faces: --points makes faces of them' "$tmp/points.off" mesh2disk
	mesh2disk --points "$tmp/points.off" -o "$tmp/cap.ply" 2>"$tmp/err"
	grep -Eq 'points joined by [0-9]+ faces, of radius 0\.[0-9]+ or less$' "$tmp/err"
	mesh2rect -q -n 16 "$tmp/cap.ply" -o "$tmp/x"
	mesh2rect -q -n 16 "$tmp/cap.off" -o "$tmp/y"
	below "$(lhdiff --no-self-intersections "$tmp/cap.ply" "$tmp/cap.off" 2>/dev/null | awk '$1 == "hausdorff_rel" { print $2 }')" 0.02
	try 0 'has faces: --points does nothing' "$tmp/cap.off" mesh2disk --points
	printf 'OFF\n2 0 0\n0 0 0\n1 0 0\n' >"$tmp/points.off"
	try 1 'cannot be joined to a surface' "$tmp/points.off" mesh2disk --points
}

@test "real files with faults: mended, or refused with the reason" {
	[ -d "$meshes/bad" ] || skip "no test meshes: set LHGRID_MESHES"
	local b="$meshes/bad" f
	for f in two_loops_face.obj components_face_scan.obj pinched_vertex_face.off nonmanifold_edges.obj \
	    soup_duplicated_vertices.off orientation_half_flipped.obj zero_area_bad_index.off nan_coordinates.off \
	    unreferenced_vertices.ply quads_wrapped_lines.off; do
		mesh2disk -q "$b/$f" -o "$tmp/real.ply"
		mesh2rect -q -n 8 --polish=0 "$tmp/real.ply" -o "$tmp/real.lhg"
		mesh2disk -q "$tmp/real.ply" -o "$tmp/again.ply"
		cmp <(sed '1,/^end_header/d' "$tmp/real.ply") <(sed '1,/^end_header/d' "$tmp/again.ply")
	done
	try 0 'closed and stays so'   "$b/closed_bunny.off"    mesh2disk
	mesh2disk -q --open=auto "$b/closed_bunny.off" | mesh2rect -q -n 8 --polish=0 -o "$tmp/real.lhg"
	try 1 '2 handles: --handles=cut cuts and closes them' "$b/genus2_one_loop.off" mesh2disk
	mesh2disk -q --handles=cut "$b/genus2_one_loop.off" -o "$tmp/real.ply"
	mesh2disk --check "$tmp/real.ply" | grep -q '^result: a disk'
	try 1 'surface is one-sided'  "$b/moebius_quads.obj"   mesh2disk
	try 1 'file ends in face'     "$b/truncated.ply"       mesh2disk
}

@test "scripts/verdicts says what became of each file of a folder" {
	mkdir "$tmp/folder"
	cp "$tmp/face.off" "$tmp/folder/a.off"
	without_faces "$tmp/face.off" 300 300 >"$tmp/folder/b.off"
	printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' >"$tmp/folder/c.off"
	printf 'OFF\n3 1 0\n0 0 0\n' >"$tmp/folder/d.off"
	run -0 scripts/verdicts "$tmp/folder"
	[[ ${lines[0]} == "as it is  $tmp/folder/a.off: " ]]
	[[ ${lines[1]} == "mended    $tmp/folder/b.off: 1 hole filled"* ]]
	[[ ${lines[2]} == "as it is  $tmp/folder/c.off: the surface is closed"* ]]
	[[ ${lines[3]} == "refused   $tmp/folder/d.off: header announces 3 vertices"* ]]
	[[ "${lines[*]:4}" == "as it is: 2 mended: 1 refused: 1" ]]
	run -0 scripts/verdicts -o --open=auto "$tmp/folder"
	[[ ${lines[2]} == "as it is  $tmp/folder/c.off: closed surface cut open"* ]]
	run -2 scripts/verdicts
}

@test "small files after public reports of bugs: each becomes a disk" {
	[ -d "$meshes/wild" ] || skip "no test meshes: set LHGRID_MESHES"
	local w="$meshes/wild" f
	for f in b00_clean b07a_dup_face b08b_zero_area_ear b08d_edge_1e-12 b08e_cap_zero_area b09_t_junction \
	    b10a_two_disks_one_vertex b12b_seam_across b15_specks b16a_face_missing b17a_nan_unused c07_nan_used \
	    c08_specks_hole_dup; do
		mesh2disk --check "$w/$f.off" >"$tmp/report"
		grep -q '^result: a disk' "$tmp/report" || { echo "$f"; cat "$tmp/report"; false; }
		mesh2disk -q "$w/$f.off" | mesh2rect -q -n 8 --polish=0 -o "$tmp/x"
	done
	mesh2disk -q "$w/noisy_seam.off" -o "$tmp/seam.off"
	mesh2disk -q "$w/noisy.off" -o "$tmp/none.off"
	cmp "$tmp/seam.off" "$tmp/none.off"
	mesh2rect -n 8 "$w/noisy_seam.off" -o "$tmp/x" 2>"$tmp/err"     # the sock is noted, too
	grep -q '8 boundary vertices lie at the place of others: a cut, or a seam' "$tmp/err"
	try 1 '874 boundary vertices lie within .* --weld=auto welds them' "$w/b03c_stl_noise1e-7.stl" mesh2rect
	mesh2disk -o "$tmp/one.ply" "$w/b03c_stl_noise1e-7.stl" 2>"$tmp/err"
	grep -q '874 boundary vertices within 2.8.*e-06 of others, .* --weld=auto welds them$' "$tmp/err"
	try 0 'first edge between vertices 22 and 35$' "$w/b08d_edge_1e-12.off" mesh2disk
	mesh2disk --check "$w/b08d_edge_1e-12.off" | grep -q '^faces without area .* first short edge 22-35$'
	mesh2disk --weld=auto --check "$w/b03c_stl_noise1e-7.stl" | grep -q '^result: a disk, 205 vertices, 360 faces'
	try 1 'two of them on vertices 128 140 141: said twice' "$w/b07a_dup_face.off" mesh2rect
}
