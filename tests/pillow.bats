# pillow.bats - the pillow: the programs from grid2lh on, on closed surfaces that are known.

load helper

setup_file() {
	load helper
	mkpillow=$BUILD/tests/mkpillow
	"$mkpillow" sphere 96 72 .6 >"$tmp/sphere"
	"$mkpillow" egg 96 72 .6 >"$tmp/egg"            # not conformal
	"$mkpillow" pear 96 72 .6 >"$tmp/pear"          # conformal, without symmetry
	for s in sphere egg pear; do
		grid2lh "$tmp/$s" -o "$tmp/$s.lh"
		grid2lh --residual --no-place "$tmp/$s" -o "$tmp/$s.res"
	done
	mkmesh -n 900 face | mesh2rect -q -n 96x72 | grid2lh -q -o "$tmp/flat"
}

# python SCRIPT ARGS..: runs SCRIPT with lhg, numpy as np, and grid(f), the one grid of a file.
python() {
	PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "import sys; sys.path.insert(0, 'scripts'); import lhg, numpy as np
def grid(f): return next(lhg.read(f))
$1" "${@:2}"
}

# turned IN OUT K: lays the pillow onto itself: by half its width if K is odd, with exchanged folds from 2 on.
turned() {
	python 'g, k = grid(sys.argv[1]), int(sys.argv[3])
for c in g.channels:
    f = g[c]
    f = np.roll(f, g.nu//2, 1) if k & 1 else f
    f = f[::-1, ::-1] if k & 2 else f
    g[c][...] = -f if k & 2 and c in ("tau1", "tau2") else f.copy()
lhg.write(sys.argv[2], [g])' "$@"
}

@test "a closed surface has no band, and H of the sphere is -1" {
	lhinfo "$tmp/sphere.lh" | head -1 | grep -q ': 96 x 72 nodes of a pillow, T 0.6'
	run -1 grep -aq '^channel band' "$tmp/sphere.lh"
	python 'g = grid(sys.argv[1]); l, H = g["lambda"], g["H"]
assert abs((l*l).sum()*g.T/(g.nu*g.nv)/(4*np.pi) - 1) < 2e-3
assert abs(np.median(H) + 1) < 1e-3
l, H = g["lambda"]**2, g["lambda"]**2*H        # the integral of H is that of a sphere, too
assert abs(H.sum()/l.sum() + 1) < 1e-3' "$tmp/sphere.lh"
}

@test "the surface comes back from lambda and H: with and without its place, its start" {
	for s in sphere pear; do
		lh2grid "$tmp/$s.lh" -o "$tmp/back"
		below "$(error_of "$tmp/$s" "$tmp/back" mean_rel)" 5e-4
		lh2grid --no-place "$tmp/$s.lh" -o "$tmp/back"
		below "$(error_of "$tmp/$s" "$tmp/back" mean_rel)" 5e-4
	done
	for s in sphere egg pear; do
		lh2grid --boundary=free "$tmp/$s.res" -o "$tmp/back"    # there is none
		below "$(error_of "$tmp/$s" "$tmp/back" max_rel)" 1e-8
	done
}

# Without a start the surface lies where its round sphere was, so it is moved onto the other by lhinterp.
@test "from the round sphere the same surface, up to a motion" {
	lh2grid --no-place --tolerance=1e-9 "$tmp/pear.lh" | grid2lh -o "$tmp/with"
	lh2grid --no-place --no-start --tolerance=1e-9 "$tmp/pear.lh" | grid2lh -o "$tmp/without"
	lhinterp -q --align -t 0,1 "$tmp/with" "$tmp/without" -o "$tmp/both"
	python 'a, b = lhg.read(sys.argv[1])
for c in "xyz": assert abs(a["start." + c] - b["start." + c]).max() < 1e-6' "$tmp/both"
}

@test "its mesh is closed, oriented outwards, and the same in every format" {
	for s in sphere egg pear; do
		grid2mesh "$tmp/$s" -o "$tmp/$s.off"
		try 0 '' /dev/null mesh2disk --check "$tmp/$s.off"
		grep -q '^result: a closed surface, 6912 vertices, 13820 faces$' "$tmp/out"     # V - E + F = 2
		/usr/bin/python3 - "$tmp/$s.off" <<-'EOF'
			import sys, numpy as np
			w = open(sys.argv[1]).read().split()[1:]
			n = int(w[0])
			x = np.array(w[3:3 + 3*n], float).reshape(-1, 3)
			t = np.array(w[3 + 3*n:], int).reshape(-1, 4)[:, 1:]
			a, b, c = x[t[:, 0]], x[t[:, 1]], x[t[:, 2]]
			assert (a*np.cross(b, c)).sum() > 0
		EOF
	done
	for f in obj ply vtp surf.gii pial; do
		grid2mesh "$tmp/pear" -o "$tmp/mesh.$f"
		try 0 '' /dev/null lhdiff --no-hausdorff --no-self-intersections "$tmp/pear.off" "$tmp/mesh.$f"
		below "$(awk '$1 == "max_rel" { print $2 }' "$tmp/out")" 1e-7
	done
	try 0 '' /dev/null lhdiff "$tmp/pear" "$tmp/pear.off"
	[ "$(awk '/self_intersections/ { n += $2 } END { print n }' "$tmp/out")" = 0 ]
}

@test "filters: all is kept, or only what is smooth" {
	lhfft -K 0 "$tmp/pear.lh" --no-history -o "$tmp/same"
	python 'a, b = map(grid, sys.argv[1:])
assert (a["lambda"] == b["lambda"]).all() and (a["H"] == b["H"]).all()' "$tmp/pear.lh" "$tmp/same"
	for how in -K1 --scale=10% --relief=1% --keep=200 --energy=.999 --low-pass=6; do
		lhfft $how "$tmp/pear.lh" | lh2grid -o "$tmp/smooth"
		below "$(error_of "$tmp/pear" "$tmp/smooth" mean_rel)" 0.01
		[ "$(lhdiff --no-hausdorff "$tmp/pear" "$tmp/smooth" | awk '$1 == "self_intersections_b" { print $2 }')" = 0 ]
	done
	lhfft -K 1 --spectrum="$tmp/table" "$tmp/pear.lh" -o "$tmp/smooth"
	[ "$(grep -vc '^#' "$tmp/table")" -ge 6912 ]
}

# H of the filter is smooth there; the least energy has it, too, but a spike costs hardly any energy.
@test "after --scale no spike of H is left beside a cone" {
	lhfft --scale=10% "$tmp/pear.lh" -o "$tmp/scaled"
	lh2grid "$tmp/scaled" | grid2lh -q --no-place -o "$tmp/is"
	python 'a, b = map(grid, sys.argv[1:]); l, H = a["lambda"], a["H"]
u, v = (np.arange(a.nu) + .5)/a.nu, (np.arange(a.nv) + .5)*a.T/a.nv
near = np.min([np.hypot(u - x, v[:, None] - y) for x in (0, .5, 1) for y in (0, a.T)], 0) < 6/a.nu
worst = abs(b["H"] - H)[near].max()/((l*H)**2).sum()**.5*(l**2).sum()**.5
assert worst < .1, worst' "$tmp/scaled" "$tmp/is"
}

# A scale, other than a filter of coefficients, depends on the surface alone.
@test "another choice of cones: the same scale" {
	$BUILD/tests/mkpillow pear 96 96 .8 >"$tmp/high"
	for s in pear high; do
		grid2lh -q "$tmp/$s" | lhfft --scale=80% | lh2grid | grid2mesh -o "$tmp/scale-$s.off"
	done
	hausdorff=$(lhdiff --no-self-intersections "$tmp/scale-pear.off" "$tmp/scale-high.off" 2>/dev/null |
		awk '$1 == "hausdorff_rel" { print $2 }')
	below "$hausdorff" 0.003
}

@test "morphs: the ends are met, B is moved onto A, its cones are compared" {
	lhinterp -q -t 0,1 "$tmp/pear.lh" "$tmp/sphere.lh" | lh2grid -o "$tmp/ends"
	lhinterp -q --scale --align -n 3 "$tmp/pear.lh" "$tmp/egg.lh" | lh2grid -o "$tmp/morph"
	grid2mesh "$tmp/morph" -o "$tmp/frame-%d.off"
	try 0 '' /dev/null mesh2disk --check "$tmp/frame-2.off"
	for k in 1 2 3; do
		turned "$tmp/pear.lh" "$tmp/other" $k
		order=$(echo 2,1,4,3 3,4,1,2 4,3,2,1 | cut -d' ' -f$k)
		try 0 "other fits .*pear.lh better with its cones in the order $order " /dev/null \
			lhinterp -t 0 "$tmp/pear.lh" "$tmp/other"
		turned "$tmp/pear.res" "$tmp/other" $k
		try 0 "other is laid on with its cones in the order $order: " /dev/null \
			lhinterp --align -t 1 "$tmp/pear.res" "$tmp/other" -o "$tmp/onto"
		python 'a, b = map(grid, sys.argv[1:])
assert max(abs(a[c] - b[c]).max() for c in a.channels) < 1e-12' "$tmp/pear.res" "$tmp/onto"
	done
	python 'g = grid(sys.argv[1])
R = np.array([[0, -.6, .8], [1, 0, 0], [0, .8, .6]])
for n in "start.", "place.":
    x = R @ np.stack([g[n + c].ravel() for c in "xyz"]) + [[5], [-2], [1]]
    for k, c in enumerate("xyz"): g[n + c][...] = x[k].reshape(g.nv, g.nu)
lhg.write(sys.argv[2], [g])' "$tmp/pear.lh" "$tmp/moved"
	try 0 '' /dev/null lhinterp --align -t 1 "$tmp/pear.lh" "$tmp/moved" -o "$tmp/onto"
	python 'a, b = map(grid, sys.argv[1:])
assert max(abs(a["start." + c] - b["start." + c]).max() for c in "xyz") < 1e-12' "$tmp/pear.lh" "$tmp/onto"
}

@test "each frame of a morph may start from the one before, or from key frames" {
	lhinterp -q --scale --align -n 5 "$tmp/pear.lh" "$tmp/sphere.lh" -o "$tmp/lh"
	lh2grid "$tmp/lh" -o "$tmp/alone"
	for how in --follow --keyframes=2; do
		lh2grid $how "$tmp/lh" -o "$tmp/there"
		lhdiff --no-hausdorff --no-self-intersections "$tmp/alone" "$tmp/there" | awk -F '\t' '
			NR == 1 { for (i = 1; i <= NF; i++) if ($i == "max_rel") c = i; next }
			{ bad += !($c < 1e-3) } END { exit NR != 6 || bad }'
	done
}

@test "pictures and pages take it" {
	try 0 '' /dev/null lh2png "$tmp/pear.lh" -o "$tmp/pear.png"
	three_js
	try 0 '' /dev/null env LHGRID_THREE="$tmp/three" grid2html "$tmp/pear" -o "$tmp/pear.html"
}

@test "a skull: from lambda and H alone, from the round sphere, and its scales" {
	[ -d "$meshes/formats" ] || skip "no meshes in $meshes"
	mesh2rect -q -n 128 "$meshes/formats/finch_skull_binary.stl" -o "$tmp/skull"
	grid2lh "$tmp/skull" -o "$tmp/skull.lh"
	lh2grid --no-place "$tmp/skull.lh" -o "$tmp/back"
	below "$(error_of "$tmp/skull" "$tmp/back" mean_rel)" 2e-4
	lh2grid --no-place --no-start "$tmp/skull.lh" -o "$tmp/round"
	misfit=$(lhinfo "$tmp/back" | sed -n 's/^  meta misfit //p')    # .04; of other minima 1 and more
	below "$(lhinfo "$tmp/round" | sed -n 's/^  meta misfit //p')" "$(awk -v m="$misfit" 'BEGIN { print 1.1*m }')"
	for how in --scale=1% --scale=4% -K1; do
		lhfft $how "$tmp/skull.lh" | lh2grid -o "$tmp/smooth"
		[ "$(lhdiff --no-hausdorff "$tmp/skull" "$tmp/smooth" | awk '$1 == "self_intersections_b" { print $2 }')" = 0 ]
	done
}

@test "what a closed surface has not is said" {
	grid2lh --no-lattice "$tmp/pear" -o "$tmp/nostart"
	python 'a, b = grid(sys.argv[1]), grid(sys.argv[1]); b["start.y"][3, 5] = 1e70
a.frames = b.frames = b.frame = 2
lhg.write(sys.argv[2], [a, b])' "$tmp/pear.lh" "$tmp/far"
	code=0
	lh2grid --follow "$tmp/far" >"$tmp/out" 2>"$tmp/err" || code=$?
	[ $code = 1 ] && grep -q 'channel start.y is 1e+70 wide' "$tmp/err"
	try 1 'on a pillow, .*flat on a rectangle: mesh2rect --chart=pillow' /dev/null lhinterp -t .5 "$tmp/pear.lh" "$tmp/flat"
	try 1 'a pillow has no boundary for --landmarks' /dev/null lhinterp -l /dev/null -t .5 "$tmp/pear.lh" "$tmp/pear.lh"
	try 1 'run grid2lh without --no-lattice' /dev/null lhinterp --align -t .5 "$tmp/nostart" "$tmp/nostart"
	try 1 'frame method is for the rectangle, not for the pillow' /dev/null lh2grid --method=frame "$tmp/pear.lh"
	try 1 'a pillow .*--basis=dct' /dev/null lhfft --paper -K 1 "$tmp/pear.lh"
	for T in 1e-4 300; do
		python 'g = grid(sys.argv[1]); g.T = float(sys.argv[2]); lhg.write(sys.argv[3], [g])' "$tmp/pear.lh" $T "$tmp/bad"
		try 1 'height T is .*, not in' /dev/null lh2grid "$tmp/bad"
		try 1 'height T is .*, not in' /dev/null lhfft -K 1 "$tmp/bad"
		python 'g = grid(sys.argv[1]); g.T = float(sys.argv[2]); lhg.write(sys.argv[3], [g])' "$tmp/pear" $T "$tmp/bad"
		try 1 'height T is .*, not in' /dev/null grid2lh "$tmp/bad"
	done
}
