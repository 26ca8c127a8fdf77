# likepillow.bats - mesh2rect --like on closed surfaces: the same nodes on the same places, and morphs.

load helper

setup_file() {
	load helper
	mkmesh -n 3000 bumpy -o "$tmp/bumpy.off"
	mesh2rect -n 96 "$tmp/bumpy.off" -o "$tmp/a"
	mkmesh -n 2500 bumpy amp=0.2 | stretched >"$tmp/other.off"
}

# datum FILE KEY: prints a metadatum.
datum() {
	lhinfo "$1" | sed -n "s/^  meta $2 //p"
}

stretched() { awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2 { print 1.1*$1 + .1*$2, $2, .9*$3; next } { print }'; }

# turned FROM TO: the mesh rotated, translated, 50 times as large, and with its vertices in reverse order.
turned() {
	awk 'NR == 2 { n = $1 } NR <= 2 { print; next }
		NR <= n + 2 { v[NR - 3] = 50*(0.36*$1 + 0.48*$2 - 0.8*$3) + 7 " " 50*(-0.8*$1 + 0.6*$2) " " 50*(0.48*$1 + 0.64*$2 + 0.6*$3)
			if (NR == n + 2) for (i = n - 1; i >= 0; i--) print v[i]; next }
		{ print 3, n - 1 - $2, n - 1 - $3, n - 1 - $4 }' "$1" >"$2"
}

# back FROM TO: a mesh of `turned` moved back, its vertices left in their order.
back() {
	awk 'NR == 2 { n = $1 } NR <= 2 || NR > n + 2 { print; next }
		{ x = ($1 - 7)/50; y = $2/50; z = $3/50; print .36*x - .8*y + .48*z, .48*x + .6*y + .64*z, -.8*x + .6*z }' "$1" >"$2"
}

# python SCRIPT ARGS..: runs SCRIPT with lhg, numpy as np, and grid(f), the one grid of a file.
python() {
	PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "import sys; sys.path.insert(0, 'scripts'); import lhg, numpy as np
def grid(f): return next(lhg.read(f))
$1" "${@:2}"
}

@test "the same surface, moved, in other units and renumbered, comes out on the same nodes" {
	turned "$tmp/bumpy.off" "$tmp/turned.off"
	mesh2rect -q -n 64 --like="$tmp/a" "$tmp/turned.off" -o "$tmp/b"
	grid2mesh "$tmp/a" -o "$tmp/a.off"
	grid2mesh "$tmp/b" -o "$tmp/b.off"
	back "$tmp/b.off" "$tmp/back.off"
	[ "$(sed -n 2p "$tmp/a.off")" = "$(sed -n 2p "$tmp/back.off")" ]
	# Node by node, without a fit.
	paste <(sed 1,2d "$tmp/a.off") <(sed 1,2d "$tmp/back.off") |
		awk 'NF == 6 { d = ($1-$4)^2 + ($2-$5)^2 + ($3-$6)^2; if (d > most) most = d } END { exit !(NR > 0 && most < .005^2) }'
	[ "$(sed -n 's/^height //p;/^end/q' "$tmp/a")" = "$(sed -n 's/^height //p;/^end/q' "$tmp/b")" ]
	below "$(datum "$tmp/b" like)" 2e-3
}

@test "another surface gets the nodes, the height and the places of the first, and is conformal" {
	mesh2rect -q --like="$tmp/a" "$tmp/other.off" -o "$tmp/b"
	[ "$(sed -n 's/^\(size\|height\) //p;/^end/q' "$tmp/a")" = "$(sed -n 's/^\(size\|height\) //p;/^end/q' "$tmp/b")" ]
	below "$(datum "$tmp/b" like)" 0.08
	below "$(datum "$tmp/b" chi2)" 1.5
	grid2lh -v "$tmp/b" 2>&1 >/dev/null | sed -n 's/.*median \([^,]*\), mean.*/\1/p' >"$tmp/mu"
	below "$(cat "$tmp/mu")" 5e-4
	# With cones of its own the nodes would be elsewhere.
	python 'def away(f):
    x = [np.stack([grid(g)[c] for c in "xyz"]) for g in (sys.argv[1], f)]
    return np.linalg.norm(x[0] - x[1], axis=0).mean()
assert away(sys.argv[2]) < .15, away(sys.argv[2])' "$tmp/a" "$tmp/b"
	grid2lh -q "$tmp/a" -o "$tmp/a.lh"              # lambda, H and the start serve as well
	mesh2rect -q --like="$tmp/a.lh" "$tmp/other.off" | grid2mesh | cmp - <(grid2mesh "$tmp/b")
	mesh2rect -q --like=- "$tmp/other.off" <"$tmp/a" | grid2mesh | cmp - <(grid2mesh "$tmp/b")
	for j in 2 3; do
		mesh2rect -q -j $j --like="$tmp/a" "$tmp/other.off" | grid2mesh | cmp - <(grid2mesh "$tmp/b")
	done
}

@test "a morph: ends exact, no frame crosses itself, nodes between those of the ends" {
	mesh2rect -q --like="$tmp/a" "$tmp/other.off" -o "$tmp/b"
	for k in a b; do grid2lh -q --residual --no-place "$tmp/$k" -o "$tmp/$k.res"; done
	lhinterp -q -n 5 "$tmp/a.res" "$tmp/b.res" | lh2grid -o "$tmp/morph"
	grid2mesh "$tmp/morph" -o "$tmp/frame-%d.off"
	below "$(error_of "$tmp/frame-1.off" <(grid2mesh "$tmp/a") max_rel)" 1e-8
	below "$(error_of "$tmp/frame-5.off" <(grid2mesh "$tmp/b") max_rel)" 1e-8
	for k in 1 2 3 4 5; do
		[ "$(lhdiff --no-hausdorff "$tmp/frame-$k.off" "$tmp/frame-$k.off" | awk '$1 == "self_intersections_a" { print $2 }')" = 0 ]
	done
	# Half-way the nodes are near the middle of those of the ends: they correspond.
	paste <(sed 1,2d "$tmp/frame-1.off") <(sed 1,2d "$tmp/frame-3.off") <(sed 1,2d "$tmp/frame-5.off") | awk '
		NF == 9 { n++; sum += ($1/2+$7/2-$4)^2 + ($2/2+$8/2-$5)^2 + ($3/2+$9/2-$6)^2 } END { exit !(n && sum/n < .05^2) }'
}

@test "--cones with --like: the three are taken, and the height of the grid" {
	mesh2rect -q --like="$tmp/a" --cones=5,1700,2500 "$tmp/bumpy.off" -o "$tmp/b"
	[[ $(datum "$tmp/b" cones) == 5,1700,2500,* ]]
	[ "$(sed -n 's/^\(size\|height\) //p;/^end/q' "$tmp/a")" = "$(sed -n 's/^\(size\|height\) //p;/^end/q' "$tmp/b")" ]
}

@test "surfaces that fit in several ways: the mesh is turned least, and it is noted" {
	mkmesh -n 2000 ellipsoid -o "$tmp/egg.off"
	mesh2rect -n 48 "$tmp/egg.off" -o "$tmp/egg"
	try 0 'fit about equally well in another position' /dev/null mesh2rect --like="$tmp/egg" "$tmp/egg.off"
	below "$(error_of "$tmp/egg" "$tmp/out" max_rel)" 0.01
}

@test "charts that do not meet, and grids without positions, are refused by name" {
	mkmesh -n 500 cap -o "$tmp/cap.off"
	mesh2rect -q -n 16 "$tmp/cap.off" -o "$tmp/cap"
	mesh2rect -q -n 16 --chart=sock "$tmp/cap.off" -o "$tmp/sock"
	try 1 'cap: is on a rectangle; --like needs a pillow, as .*bumpy.off is a closed surface' /dev/null mesh2rect --like="$tmp/cap" "$tmp/bumpy.off"
	try 1 'sock: is on a sock; --like needs a pillow' /dev/null mesh2rect --like="$tmp/sock" "$tmp/bumpy.off"
	try 1 'a: is on a pillow, which has no boundary; --like needs a rectangle, as the mesh is open' /dev/null mesh2rect --like="$tmp/a" "$tmp/cap.off"
	try 1 'a: --like with --chart=sock needs a sock, this is a pillow' /dev/null mesh2rect --chart=sock --like="$tmp/a" "$tmp/cap.off"
	try 2 'a closed surface has its normal outside' /dev/null mesh2rect --like-reversed --like="$tmp/a" "$tmp/bumpy.off"
	try 2 'like-reversed needs --like, and a rectangle' /dev/null mesh2rect --chart=pillow --like-reversed --like="$tmp/a" "$tmp/bumpy.off"
	grid2lh -q --no-lattice --no-place "$tmp/a" -o "$tmp/bare"
	try 1 'bare: neither x y z nor start.x start.y start.z for --like' /dev/null mesh2rect --like="$tmp/bare" "$tmp/bumpy.off"
	python 'g = grid(sys.argv[1])
for c in "xyz": g[c][...] = 1
lhg.write(sys.argv[2], [g])' "$tmp/a" "$tmp/point"
	try 1 'no position on the surface of --like' /dev/null mesh2rect --like="$tmp/point" "$tmp/bumpy.off"
	python 'g = lhg.Grid(4, 4, 1.0, chart="pillow")
for c in "xyz": g.channels[c] = lhg.Channel(np.random.default_rng(0).random((4, 4)), "length")
lhg.write(sys.argv[1], [g])' "$tmp/few"
	try 1 'few: 4 x 4 nodes, --like needs at least 6 x 6' /dev/null mesh2rect --like="$tmp/few" "$tmp/bumpy.off"
	python 'g = grid(sys.argv[1]); g.T = 1e-4; lhg.write(sys.argv[2], [g])' "$tmp/a" "$tmp/low"
	try 1 'low: the height T is .*, not in' /dev/null mesh2rect --like="$tmp/low" "$tmp/bumpy.off"
	try 1 'several grids' /dev/null mesh2rect --like=<(cat "$tmp/a" "$tmp/a") "$tmp/bumpy.off"
	mkmesh -n 3000 ellipsoid a=6 b=1 c=1 -o "$tmp/needle.off"
	try 1 'chi.2 .* is above 100: .* too unlike that of --like: --cones, or --force' /dev/null mesh2rect --like="$tmp/a" "$tmp/needle.off"
	try 1 'chi.2 .* is above 100: .*other --cones, or --force' /dev/null mesh2rect --cones=0,1,2 --like="$tmp/a" "$tmp/needle.off"
	mesh2rect --force --max-loss=1 --like="$tmp/a" "$tmp/needle.off" -o "$tmp/needle" 2>"$tmp/err"
	grep -q 'of their size apart: too unlike for corresponding cones' "$tmp/err"
	grep -q ': more cells (of the grid of --like), other --cones' "$tmp/err"
}

@test "two skulls of finches, however the second lies in space" {
	[ -d "$meshes/formats" ] || skip "no meshes in $meshes"
	! sanitized || skip "as above, with meshes that take too long with sanitizers"
	mesh2rect -q -n 96 "$meshes/formats/finch_skull_binary.stl" -o "$tmp/skull"
	mesh2disk -q "$meshes/bad/binary_bird_skull.stl" -o "$tmp/bird.off"
	turned "$tmp/bird.off" "$tmp/bird-turned.off"
	for k in bird bird-turned; do
		mesh2rect -q --like="$tmp/skull" "$tmp/$k.off" -o "$tmp/$k"
		below "$(datum "$tmp/$k" like)" 0.06
	done
	below "$(error_of <(grid2mesh "$tmp/bird" ) <(grid2mesh "$tmp/bird-turned" | back /dev/stdin /dev/stdout) mean_rel)" 1e-3
}
