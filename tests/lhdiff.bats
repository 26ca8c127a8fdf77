# lhdiff.bats - distances of surfaces and of streams of them.

load helper

setup_file() {
	load helper
	mkmesh -n 300 cap | mesh2rect -n 16 -o "$tmp/cap"
	mkmesh -n 300 torus | mesh2rect -n 16 -o "$tmp/torus"
	mkmesh -n 300 cap | mesh2rect -n 12 -o "$tmp/small"
	# the cap, moved along x by 0, 1, 2, 3: a set of frames whose distances are known
	/usr/bin/python3 - "$tmp/cap" "$tmp/moved" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg
		frames = [next(iter(lhg.read(sys.argv[1]))) for i in range(4)]
		for i, g in enumerate(frames):
		    g['x'][...] += i
		    g.frame, g.frames = i + 1, 4
		lhg.write(open(sys.argv[2], 'wb'), frames)
	END
}

# column FILE NAME: prints one column of a table, one value a line.
column() {
	awk -F '\t' -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i } NR > 1 { print $k }' "$1"
}

@test "one surface against a stream: a line for each frame, with the known distances" {
	lhdiff "$tmp/cap" "$tmp/moved" >"$tmp/table"
	[ "$(head -1 "$tmp/table" | tr '\t' ' ')" = "frame area_a area_b max mean max_rel mean_rel hausdorff hausdorff_error hausdorff_rel self_intersections_a self_intersections_b" ]
	[ "$(column "$tmp/table" frame | xargs)" = "1 2 3 4" ]
	paste <(column "$tmp/table" max) <(column "$tmp/table" mean) <(column "$tmp/table" max_rel) \
	    <(column "$tmp/table" area_a) | awk '{ d = NR - 1; e = 1e-7
		if (!(($1 - d)^2 < e^2 && ($2 - d)^2 < e^2 && ($3 - d/sqrt($4))^2 < e^2)) exit 1 }'
	[ "$(column "$tmp/table" hausdorff | head -1)" = 0 ]
	[ "$(column "$tmp/table" self_intersections_a | xargs)" = "0 0 0 0" ]
	[ "$(column "$tmp/table" hausdorff | sort -g | xargs)" = "$(column "$tmp/table" hausdorff | xargs)" ]
}

@test "each line of a table has the values of the frame alone" {
	lhdiff "$tmp/torus" "$tmp/moved" >"$tmp/table"
	grid2mesh -o "$tmp/f%d.off" "$tmp/moved"
	for i in 1 4; do
		lhdiff "$tmp/torus" "$tmp/f$i.off" | awk '{ print $2 }' >"$tmp/alone"
		sed -n "$((i + 1))p" "$tmp/table" | cut -f 2- | tr '\t' '\n' | cmp - "$tmp/alone"
	done
}

@test "stream against stream is compared frame by frame, from files, pipes and sets of one" {
	lhdiff "$tmp/moved" "$tmp/moved" >"$tmp/same"
	[ "$(column "$tmp/same" max | xargs)" = "0 0 0 0" ]
	cat "$tmp/cap" "$tmp/torus" "$tmp/cap" "$tmp/torus" >"$tmp/sets"
	lhdiff "$tmp/moved" "$tmp/sets" >"$tmp/a"
	lhdiff "$tmp/moved" - <"$tmp/sets" | cmp - "$tmp/a"
	paste <(column "$tmp/a" max) <(column "$tmp/a" max_rel) <(column "$tmp/a" area_a) <(column "$tmp/a" area_b) |
		sed -n 2p | awk '{ exit !($3 != $4 && ($1/sqrt($3) - $2)^2 < 1e-12) }'
	lhdiff "$tmp/torus" "$tmp/torus" | awk '$1 == "area_a" { print $2 }' >"$tmp/area"
	column "$tmp/a" area_b | sed -n 2p | cmp - "$tmp/area"
}

@test "--json: an object on each line; values that were not requested are left out" {
	lhdiff --json --no-hausdorff "$tmp/cap" "$tmp/moved" >"$tmp/lines"
	/usr/bin/python3 - "$tmp/lines" <<-'END'
		import json, sys
		rows = [json.loads(line) for line in open(sys.argv[1])]
		assert [r['frame'] for r in rows] == [1, 2, 3, 4], rows
		assert all(abs(r['max'] - i) < 1e-12 and 'hausdorff' not in r for i, r in enumerate(rows)), rows
	END
	lhdiff --no-hausdorff --no-self-intersections "$tmp/cap" "$tmp/moved" | head -1 | tr '\t' ' ' |
		cmp - <(echo "frame area_a area_b max mean max_rel mean_rel")
	[ "$(lhdiff --json "$tmp/cap" "$tmp/cap" | grep -c frame)" = 0 ]
}

@test "different numbers of vertices: no max and mean, noted once" {
	try 0 '169 and 289 vertices: no max and mean' /dev/null lhdiff --no-hausdorff "$tmp/small" "$tmp/moved"
	[ "$(column "$tmp/out" max | xargs)" = "- - - -" ]
	[ "$(column "$tmp/out" area_b | grep -c '^[0-9]')" = 4 ]
}

@test "different numbers of frames, and errors in a later frame, are refused" {
	cat "$tmp/cap" "$tmp/cap" "$tmp/cap" >"$tmp/three"
	cat "$tmp/three" "$tmp/cap" "$tmp/cap" >"$tmp/five"
	lhinterp -n 3 <(grid2lh "$tmp/cap") <(grid2lh "$tmp/cap") | lh2grid -o "$tmp/set"
	try 1 'three has 3 grids, .*moved has more' /dev/null lhdiff "$tmp/three" "$tmp/moved"
	try 1 'moved has 4 grids, stdin has more'   "$tmp/five" lhdiff "$tmp/moved" -
	try 1 'cap has 1 grid, .*moved has more'    /dev/null lhdiff "$tmp/moved" "$tmp/cap"
	try 1 'moved has 4 grids, .*set has 3'      /dev/null lhdiff "$tmp/moved" "$tmp/set"
	try 2 'both A and B are stdin'              /dev/null lhdiff - -
	cat "$tmp/cap" <(grid2lh "$tmp/cap") >"$tmp/mixed"
	try 1 'mixed: no channel x'                 /dev/null lhdiff "$tmp/cap" "$tmp/mixed"
	head -c $(($(wc -c <"$tmp/moved") - 100)) "$tmp/moved" >"$tmp/cut"
	try 1 'cut: frame 4 of 4'                   /dev/null lhdiff "$tmp/cap" "$tmp/cut"
	/usr/bin/python3 - "$tmp/moved" "$tmp/flat" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg
		frames = list(lhg.read(sys.argv[1]))
		frames[2]['x'][...] = frames[2]['y'][...] = 0
		lhg.write(open(sys.argv[2], 'wb'), frames)
	END
	try 1 'flat: grid 3: surface has no area'   /dev/null lhdiff "$tmp/cap" "$tmp/flat"
}

@test "a mesh that is no disk is noted and compared: no area, a hole, three faces at an edge" {
	grid2mesh "$tmp/cap" -o "$tmp/cap.off"
	awk 'NR == 2 { $2++ } { print } END { print "3 0 1 1" }' "$tmp/cap.off" >"$tmp/twice.off"
	sed '3s/.*/0 0 0/; 4s/.*/0 0 0/' "$tmp/cap.off" >"$tmp/flat.off"
	awk 'NR == 2 { $2-- } NR != 500' "$tmp/cap.off" >"$tmp/hole.off"
	awk 'NR == 2 { $2++ } { print } END { print "3 18 19 100" }' "$tmp/cap.off" >"$tmp/three.off"
	no_disk() {
		lhdiff --no-hausdorff "$tmp/cap.off" "$tmp/$1.off" >"$tmp/out" 2>"$tmp/err"
		grep -q "not a disk, compared as it is: $2" "$tmp/err"
		grep -q '^max ' "$tmp/out"
	}
	no_disk twice 'face 512 has vertex 1 twice'
	grep -q '1 face is left out' "$tmp/err"
	grep -q '^self_intersections_b 0' "$tmp/out"
	no_disk flat 'face 0 has no area'
	no_disk hole '2 boundary loops'
	grep -q '^max 0$' "$tmp/out"
	no_disk three 'edge 18-19 belongs to 3 faces'
	grep -q 'three.off: not a manifold: self-intersections are not counted' "$tmp/err"
	[ "$(grep -c self_intersections "$tmp/out")" = 1 ]
	printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n' >"$tmp/line.off"
	try 1 'line.off: no face has area' /dev/null lhdiff "$tmp/cap.off" "$tmp/line.off"
}
