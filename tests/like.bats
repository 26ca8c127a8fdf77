# like.bats - mesh2rect --like: corners that correspond to those of another grid.

load helper

setup_file() {
	load helper
	mkmesh -n 800 face -o "$tmp/face.off"
	mesh2rect -n 32 -c '90,30,0;-30,90,0;-90,-30,0;30,-90,0' "$tmp/face.off" -o "$tmp/a" || return 1
}

# corners FILE: prints the corners from the metadata of a grid.
corners() {
	lhinfo "$1" | awk '$1 == "meta" && $2 == "corners" { print $3 }'
}

# turned FROM TO: writes the mesh FROM to TO, rotated, translated, 50 times as large, and with its
# vertices in reverse order.
turned() {
	awk 'NR == 2 { n = $1 } NR <= 2 { print; next }
		NR <= n + 2 { v[NR - 3] = 50*(0.36*$1 + 0.48*$2 - 0.8*$3) + 7 " " 50*(-0.8*$1 + 0.6*$2) " " 50*(0.48*$1 + 0.64*$2 + 0.6*$3)
			if (NR == n + 2) for (i = n - 1; i >= 0; i--) print v[i]; next }
		{ print 3, n - 1 - $2, n - 1 - $3, n - 1 - $4 }' "$1" >"$2"
}

@test "the same mesh moved, in other units and renumbered gets the same corners" {
	turned "$tmp/face.off" "$tmp/turned.off"
	n=$(awk 'NR == 2 { print $1 }' "$tmp/face.off")
	mesh2rect -q -n 32 --like="$tmp/a" "$tmp/turned.off" -o "$tmp/b"
	lhinfo "$tmp/b" | awk '$2 == "like" { exit !($3 < 0.05) }'
	for k in 1 2 3 4; do
		want=$(corners "$tmp/a" | cut -d , -f $k) got=$(corners "$tmp/b" | cut -d , -f $k)
		# the same vertex: no edge of the mesh is shorter than 0.4
		awk -v a="$want" -v b="$((n - 1 - got))" 'NR > 2 && NR - 3 == a { x = $1; y = $2; z = $3 }
			NR - 3 == b { p = $1; q = $2; r = $3 } END { exit !((x-p)^2 + (y-q)^2 + (z-r)^2 < 0.2^2) }' "$tmp/face.off"
	done
}

@test "--like takes either kind of grid; equal options give equal bytes" {
	grid2lh "$tmp/a" -o "$tmp/a.lh"
	mesh2rect -q -n 32 --like="$tmp/a" "$tmp/face.off" | grid2mesh -o "$tmp/1.off"
	mesh2rect -q -n 32 --like="$tmp/a.lh" "$tmp/face.off" | grid2mesh -o "$tmp/2.off"
	mesh2rect -q -n 32 --like=- "$tmp/face.off" <"$tmp/a" | grid2mesh | cmp - "$tmp/1.off"
	cmp "$tmp/1.off" "$tmp/2.off"
}

@test "--like-reversed reverses the normal where that fits better, and only there" {
	# a boundary that differs from its mirror image in any pose: an L shape bent in space
	mkmesh -n 600 lshape | awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2 { $3 += 0.5*$1*$2 + 0.4*$1*$1*$1 } { print }' >"$tmp/l.off"
	awk 'NR == 2 { n = $1 } NR > n + 2 && NR > 2 { print 3, $2, $4, $3; next } { print }' "$tmp/l.off" >"$tmp/inside-out.off"
	mesh2rect -q -n 32 "$tmp/l.off" -o "$tmp/l"
	mesh2rect -q -n 32 --like="$tmp/l" "$tmp/l.off" -o "$tmp/plain"
	mesh2rect -q -n 32 --like="$tmp/l" --like-reversed "$tmp/inside-out.off" -o "$tmp/back"
	cmp <(grid2mesh "$tmp/plain") <(grid2mesh "$tmp/back")
	mesh2rect -q -n 32 --like="$tmp/l" --like-reversed "$tmp/l.off" | grid2mesh | cmp - <(grid2mesh "$tmp/plain")
	mesh2rect -q -n 32 --like="$tmp/l" "$tmp/inside-out.off" -o "$tmp/in"
	below "$(lhinfo "$tmp/plain" | awk '$2 == "like" { print $3 }')" "$(lhinfo "$tmp/in" | awk '$2 == "like" { print $3/2 }')"
}

@test "a round boundary fits in every position: it is not turned, and this is noted" {
	mkmesh -n 300 cap -o "$tmp/cap.off"
	mesh2rect -q -n 16 -c 0,1,2,3 "$tmp/cap.off" -o "$tmp/cap"
	try 0 'fit equally well in two positions' /dev/null mesh2rect -n 16 --like="$tmp/cap" "$tmp/cap.off"
	[ "$(corners "$tmp/out")" = 0,1,2,3 ]
	try 0 '' /dev/null mesh2rect -q -n 16 --like="$tmp/cap" "$tmp/cap.off"
}

@test "input that --like cannot use is refused" {
	try 2 '--corners and --like exclude each other' /dev/null mesh2rect -c auto --like="$tmp/a" "$tmp/face.off"
	try 2 '--like-reversed needs --like' /dev/null mesh2rect --like-reversed "$tmp/face.off"
	try 1 'nosuch: No such file'            /dev/null mesh2rect --like="$tmp/nosuch" "$tmp/face.off"
	try 1 'face.off: .*not an lhg'          /dev/null mesh2rect --like="$tmp/face.off" "$tmp/face.off"
	try 1 'stdin: no channel band.x'        <(lhfft -K 0 <(grid2lh "$tmp/a") | /usr/bin/python3 -c '
import sys
sys.path.insert(0, "scripts")
import lhg
g = next(iter(lhg.read(sys.stdin.buffer)))
for n in list(g.channels):
    if n.startswith("band"): del g.channels[n]
lhg.write(sys.stdout.buffer, [g])') mesh2rect --like=- "$tmp/face.off"
	try 1 'stdin: holds several grids'      <(cat "$tmp/a" "$tmp/a") mesh2rect --like=- "$tmp/face.off"
}

@test "real faces get the quarter turn that a person would choose" {
	[ -d "$meshes/good" ] || skip "no meshes"
	local faces="face_man_scan_6k.off face_neutral_1875.obj face_smile_1656.obj face_nefertiti_4.6k.off"
	# All scans are upright, except that the man's head is turned by 30 degrees.  From the middle of
	# its scan, corner k of A lies in the same direction as corner k of B, to 60 degrees.
	for a in ${faces% face_smile*}; do
		mesh2rect -q -n 24 --split=0 --polish=0 "$meshes/good/$a" -o "$tmp/fa"
		for b in $faces; do
			mesh2rect -q -n 24 --split=0 --polish=0 --like="$tmp/fa" "$meshes/good/$b" -o "$tmp/fb"
			/usr/bin/python3 - "$tmp/fa" "$tmp/fb" <<-'END'
				import sys
				sys.path.insert(0, 'scripts')
				import lhg, numpy as np
				at = []
				for f in sys.argv[1:]:
				    g = next(iter(lhg.read(f)))
				    x, y = (g[c] - (g[c].max() + g[c].min())/2 for c in 'xy')
				    at.append([np.arctan2(y[j, i], x[j, i]) for j, i in ((0, 0), (0, -1), (-1, -1), (-1, 0))])
				off = np.angle(np.exp(1j*(np.array(at[0]) - at[1])))
				assert abs(off).max() < np.radians(60), np.degrees(off)
			END
		done
	done
}
