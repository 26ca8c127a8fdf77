# closed.sh - closed surfaces on the pillow, which the paper leaves for the future: K = 0, and scales beside spherical
# harmonics at equal bending energy.

# closed NAME MESH: makes the grid and its lambda and H, and a row of the table.
closed() {
	timed "$1.map" mesh2rect -q "$2" -o "$w/$1.lhg"
	run lhinfo "$w/$1.lhg" -o "$w/$1.info"
	run grid2lh -v "$w/$1.lhg" -o "$w/$1-lh.lhg"
	mu=$(sed -n 's/.*median \([^,]*\), mean \([^,]*\),.*/\1, \2/p' "$said")
	run lh2grid -v --no-place "$w/$1-lh.lhg" -o "$w/$1-back.lhg"
	solves=$(sed -n 's/.*: \([0-9.]*\) vector Poisson solves.*/\1/p' "$said" | tail -n 1)
	diffs "$1" "$1-back" --no-hausdorff
	say "| $3 | $(closed_meta "$1" chi2) | $mu | $(short "$(closed_meta "$1" farthest)" 100) | $(short "$(number "$w/$1-back.diffs" max_rel)" 100) | $(short "$(number "$w/$1-back.diffs" mean_rel)" 100) | $solves |"
}

closed_meta() { sed -n "s/^  meta $2 //p" "$w/$1.info"; }

# closed_scales NAME VIEW: the surface at three scales, and spherical harmonics with the bending energy of the last.
closed_scales() {
	n=$1
	shift
	run grid2mesh "$w/$n.lhg" -o "$w/$n-0.off"
	for s in 1 2 4; do
		run lhfft -q --scale=$s% "$w/$n-lh.lhg" -o "$w/$n-s$s-lh.lhg"
		run lh2grid -q "$w/$n-s$s-lh.lhg" -o "$w/$n-s$s.lhg"
		run grid2mesh "$w/$n-s$s.lhg" -o "$w/$n-$s.off"
	done
	run grid2lh -q --no-place --no-lattice "$w/$n-s4.lhg" -o "$w/$n-s4-is.lhg"
	/usr/bin/python3 "$here/paper.d/closed.py" "$w/$n.lhg" "$w/$n-s4-is.lhg" "$w/$n-sh.lhg" >"$w/$n.degree" 2>"$said" ||
		die "$(tail -n 1 "$said")"
	run grid2mesh "$w/$n-sh.lhg" -o "$w/$n-sh.off"
	render --size=$side "$@" "$w/$n-%d.png" "$w/$n-0.off" "$w/$n-1.off" "$w/$n-2.off" "$w/$n-4.off" "$w/$n-sh.off"
	diffs "$n" "$n-s4"
	diffs "$n" "$n-sh"
	say "| $n | $(cut -d' ' -f1 "$w/$n.degree") | $(cut -d' ' -f2,3 "$w/$n.degree" | sed 's/ /, /') | $(short "$(number "$w/$n-sh.diffs" mean_rel)" 100), $(short "$(number "$w/$n-s4.diffs" mean_rel)" 100) | $(number "$w/$n-sh.diffs" self_intersections_b), $(number "$w/$n-s4.diffs" self_intersections_b) |"
}

closed_figure() {
	set --
	for n in skull bunny pial; do
		set -- "$@" "$w/$n-1.png" "$n" '' '' "$w/$n-2.png" '1 %' '' '' "$w/$n-3.png" '2 %' '' '' "$w/$n-4.png" '4 %' '' '' \
		    "$w/$n-5.png" "harmonics to degree $(cut -d' ' -f1 "$w/$n.degree")" '' ''
	done
	figure closed $side 5 "$@"
	shown closed 'Closed surfaces: the grid, its scales of 1, 2 and 4 % of sqrt(area), and spherical harmonics of x, y, z at the bending energy of the last'
}

if [ $real = yes ]; then
	closed=$meshes/../formats
	say '## Closed surfaces' '' 'On the pillow, about 66 000 nodes; distances after a rigid motion, in % of sqrt(area); without place.' '' \
		'| surface | chi^2 | mu median, mean | farthest vertex | K = 0 largest | mean | solves |' '|---|---|---|---|---|---|---|'
	closed skull "$closed/finch_skull_binary.stl" "a finch's skull"
	closed bunny "$meshes/../bad/closed_bunny.off" bunny
	closed pial "$closed/fsaverage5_pial_left.gii" 'cortical hemisphere'
	say '' 'Spherical harmonics of x, y and z at the bending energy of --scale=4%; where two numbers stand, the first is that of the harmonics. To degree 64 they are' \
		'compared, 12 675 numbers; if that does not reach the energy, the degree is 64.' '' \
		'| surface | degree | bending energy | mean distance, % | crossing faces |' '|---|---|---|---|---|'
	closed_scales skull --from=0,-1,0.3 --up=0,0,1
	closed_scales bunny --from=0.4,0.1,1
	closed_scales pial --from=-1,0,0 --up=0,0,1
	closed_figure
fi
