# closed.sh - closed surfaces on the pillow, which the paper leaves for the future: K = 0, and scales beside spherical
# harmonics at equal bending energy; and a morph beside the linear blend of the nodes.

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

# closed_morph A B: five frames from the surface A of `closed` to the mesh B on its nodes, with residuals and without, and the linear
# blend of these nodes.
closed_morph() {
	run mesh2rect -q --like="$w/$1.lhg" "$2" -o "$w/like.lhg"
	run lhinfo "$w/like.lhg" -o "$w/like.info"
	run grid2lh -q --residual --no-place "$w/$1.lhg" -o "$w/like-a-lh.lhg"
	run grid2lh -q --residual --no-place "$w/like.lhg" -o "$w/like-b-lh.lhg"
	run lhinterp -q -n 5 "$w/like-a-lh.lhg" "$w/like-b-lh.lhg" -o "$w/like-morph-lh.lhg"
	timed like-morph lh2grid -q "$w/like-morph-lh.lhg" -o "$w/like-morph.lhg"
	run grid2lh -q --no-place "$w/like.lhg" -o "$w/like-lh.lhg"
	run lhinterp -q -n 5 "$w/$1-lh.lhg" "$w/like-lh.lhg" -o "$w/like-plain-lh.lhg"
	back like-plain-lh like-plain
	python paper.d/linear.py "$w/like-morph.lhg" "$w/like-linear.lhg"
	for series in like-morph like-plain like-linear; do
		diffs "$1" "$series" --no-hausdorff
	done
	run lhdiff --no-hausdorff --no-self-intersections "$w/like.lhg" "$w/like-morph.lhg" -o "$w/like-end.diffs"
	end=$(column like-end max_rel 100 | awk '{ print $NF }')
}

# closed_frames FROM UP: draws both rows, seen by these options of render.py.
closed_frames() {
	from=$1 up=$2
	set --
	for series in like-morph like-linear; do
		render --size=$side "$from" "$up" "$w/$series-%d.png" "$w/$series.lhg"
		for k in 1 2 3 4 5; do
			set -- "$@" "$w/$series-$k.png" "t = $(awk -v k=$k 'BEGIN { print (k - 1)/4 }')" '' ''
		done
	done
	figure closedmorph $side 5 "$@"
	shown closedmorph 'One cortical hemisphere (fsaverage5, pial) becomes another (conte69): above lambda, H and residuals, below the linear blend of the nodes'
}

# closed_rows: the area and the crossing faces of the frames.
closed_rows() {
	say '| | t = 0 | 1/4 | 1/2 | 3/4 | 1 |' '|---|---|---|---|---|---|'
	for series in like-morph like-plain like-linear; do
		case $series in *morph) name='lambda, H, residuals' ;; *plain) name='lambda, H' ;; *) name='linear blend' ;; esac
		say "| area, $name | $(column $series area_b .01 | awk '{ for (i = 1; i <= NF; i++) printf "%.1f%s", $i, i < NF ? " | " : "" }') |" \
			"| crossing faces, $name | $(column $series self_intersections_b | xargs | sed 's/ / | /g') |"
	done
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
	say '### A morph between closed surfaces' '' \
		'The second surface gets the nodes, the height and the places of the cones of the first, `mesh2rect --like`. Both stay where they lie, in the spaces of their atlases.' \
		'Areas in cm^2. Folds that do not correspond fade in both blends, more in that of the nodes.' ''
	closed_morph pial "$closed/conte69_32k_lh.gii"
	closed_frames --from=-1,0,0 --up=0,0,1
	say "Equal nodes are $(short "$(sed -n 's/^  meta like //p' "$w/like.info")" 100) % of the size apart after motion and scaling. With residuals the" \
		"frame at t = 1 is B to $(short "$end") % of sqrt(area). The five frames took $(cat "$w/like-morph.seconds") s." ''
	closed_rows
	awk -v e="$end" 'BEGIN { exit !(e < 1e-6) }' && wrong= || wrong="to $end %"
	promise "$wrong" 'a morph between two closed surfaces ends at the second one, to 1e-6 % of sqrt(area)'
fi
