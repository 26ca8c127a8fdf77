# morphs.sh - Figures 10 to 13: one surface becomes another; the distance of its frames from the
# first.

# morph NAME A B VIEW FIGURE: computes the frames from role A to role B twice, as in the paper and with lhwarp, and
# draws six of both in FIGURE, as seen from the view of role VIEW.  The distance of each frame of the paper's morph
# from A goes to $w/NAME.hausdorff.
morph() {
	m=$1 a=$2 b=$3
	pair "$m-start" "$(mesh "$a")" "$rows" $(chart "$a")
	pair "$m-there" "$(mesh "$b")" "$rows" $(turned "$b") --like="$w/$m-start.lhg"
	python paper.d/meet.py "$w/$m-start.lhg" "$w/$m-there.lhg" "$w/$m-end.lhg"
	run grid2lh -q "$w/$m-end.lhg" -o "$w/$m-end-lh.lhg"
	run lhinterp -q --rule=linear -n "$frames" "$w/$m-start-lh.lhg" "$w/$m-end-lh.lhg" -o "$w/$m-lh.lhg"
	timed "$m" lh2grid -q --keyframes=7 "$w/$m-lh.lhg" -o "$w/$m.lhg"
	echo "| $(title "$a") to $(title "$b") | $(cat "$w/$m.seconds") |" >>"$out/times.md"
	diffs "$m-start" "$m" --hausdorff-error=2e-4
	column "$m" hausdorff_rel 100 >"$w/$m.hausdorff"
	column "$m" self_intersections_b >"$w/$m.self"
	run lhdiff --no-hausdorff --no-self-intersections "$w/$m-end.lhg" "$w/$m.lhg" -o "$w/$m-end.diffs"
	other_morph "$a" "$b"
	morph_rows "$1" "$4" "$5"
	morph_said "$@"
}

# other_morph A B: the same morph with B on the chart of A, if lhwarp finds a map, and with --cap if not.  $how says
# which.  The energy halfway, over the number of nodes, of the paper's morph and of this one goes to $w/$m.misfits.
other_morph() {
	pair "$m-fine" "$(mesh "$2")" $((2*rows)) $(turned "$2") --like="$w/$m-start.lhg"
	if lhwarp -q --scale "$w/$m-start.lhg" "$w/$m-fine.lhg" -o "$w/$m-warped.lhg" 2>"$said"; then
		how='lhwarp, then the blend by the metric' cap=
		run grid2lh -q --residual "$w/$m-start.lhg" -o "$w/$m-other-a.lhg"
		run grid2lh -q --residual "$w/$m-warped.lhg" -o "$w/$m-other-b.lhg"
	else
		grep -q 'in no way clearly better' "$said" || die "$(tail -n 1 "$said")"
		how='the blend by the metric, with `--cap`, as the two are too unlike for `lhwarp`' cap=--cap
		cp "$w/$m-start-lh.lhg" "$w/$m-other-a.lhg"
		cp "$w/$m-end-lh.lhg" "$w/$m-other-b.lhg"
	fi
	run lhinterp -q $cap -n "$frames" "$w/$m-other-a.lhg" "$w/$m-other-b.lhg" -o "$w/$m-other-lh.lhg"
	run lh2grid -q "$w/$m-other-lh.lhg" -o "$w/$m-other.lhg"
	for series in "$m" "$m-other"; do
		run lhinfo "$w/$series.lhg" -o "$w/$series.info"
		awk -v n="$(((frames + 1)/2))" '$2 == "misfit" && ++k == n { print $3 }' "$w/$series.info"
	done | xargs >"$w/$m.misfits"
}

# morph_rows NAME VIEW FIGURE: six frames of both morphs, one row each.
morph_rows() {
	name=$1 seen=$2 into=$3
	set --
	for series in "$name" "$name-other"; do
		chosen=''
		for i in 0 1 2 3 4 5; do
			frame=$((1 + (i*(frames - 1) + 2)/5))
			chosen=$chosen${chosen:+,}$frame
			set -- "$@" "$w/$series-$frame.png" "($(echo abcdef | cut -c$((i + 1)))) frame $frame" '' ''
		done
		render --size=$side --pick="$chosen" $(view "$seen") "$w/$series-%d.png" "$w/$series.lhg"
	done
	figure "$into" $side 6 "$@"
}

# largest_fall FILE: prints how much the distance falls at most from one frame to the next; 0 if it only rises.
largest_fall() {
	awk '{ for (i = 2; i <= NF; i++) if ($(i-1) - $i > most) most = $(i-1) - $i } END { print most + 0 }' "$1"
}

# largest_step FILE: prints where the distance changes most from one frame to the next.  The change
# is far above the mean if the solver jumps to another surface of nearly the same lambda and H.
largest_step() {
	awk '{ for (i = 2; i <= NF; i++) { d = $i - $(i-1); if (d < 0) d = -d; if (d > most) { most = d; at = i } }
	       printf "The largest step of the distance is %.3g %%, to frame %d, the mean step %.3g %%.", most, at, ($NF - $1)/(NF - 1) }' "$1"
}

# morph_said NAME A B VIEW FIGURE: adds the figure and the text of a morph to the report.
morph_said() {
	start=$(column "$1" max_rel 100 | cut -d' ' -f1)
	end=$(column "$1-end" max_rel 100 | awk '{ print $NF }')
	shown "$5" "Figure ${5#figure}: $(title "$2") to $(title "$3"), $frames frames; above (21), (22), below $how"
	say "Misfit per node halfway: $(awk '{ printf "%.3g above, %.3g below", $1, $2 }' "$w/$1.misfits")." ''
	say "| \`lhdiff\` over sqrt(area) | largest, % |" '|---|---|' \
		"| t = 0 against A | $(short "$start") |" "| t = 1 against B | $(short "$end") |" ''
	say "Frames with faces that cross: $(frames_with "$1"). $(largest_step "$w/$1.hausdorff")" ''
	fall=$(largest_fall "$w/$1.hausdorff")
	[ "$fall" = 0 ] || say "The distance falls between two frames, by $(short "$fall") % of sqrt(area) at most." ''
	at=$(awk -v x="$fall" 'BEGIN { if (!(x < 1)) print x }')
	promise "${at:+by $at %}" "$(title "$2") to $(title "$3"): the Hausdorff distance from the start rises, or falls between two frames by less than 1 % of sqrt(area)"
	wrong=$(awk -v a="$start" -v b="$end" 'BEGIN { if (!(a < 1.83 && b < 1.83)) print "to 1.83 %" }')
	promise "$wrong" "$(title "$2") to $(title "$3"): t = 0 and t = 1 give the ends back, to $(short "$start") and $(short "$end") % of sqrt(area) at most"
}

say '## Figures 10 to 13: morphs' '' "Grids of $((rows + 1)) x $((rows + 1)) nodes, $frames frames; B scaled to the area of A and moved rigidly onto it." '' \
	"    mesh2rect -n $rows --like=A.lhg B -o B.lhg" \
	"    lhinterp --rule=linear -n $frames A.lhg B.lhg | lh2grid --keyframes=7 -o MORPH.lhg; lhdiff --hausdorff-error=2e-4 A.lhg MORPH.lhg" ''
printf '\n%s\n\n%s\n%s\n' "Seconds of lh2grid, $frames frames, $((rows + 1)) x $((rows + 1)) nodes" '| morph | lh2grid |' '|---|---|' >>"$out/times.md"
# The real morph of faces ends at the mask.  mkmesh has no mask, so its morph ends at the woman's face.
lady=mask
[ $real = yes ] || lady=woman
morph faces man "$lady" man figure10
morph teeth molar lemur molar figure11
morph statue man buddha statue figure12

for name in faces teeth statue; do
	tr ' ' '\n' <"$w/$name.hausdorff" | sed '/^$/d' >"$w/$name.curve"
done
cat >"$w/figure13.gp" <<END
set terminal pngcairo size 860,460 font 'DejaVu Sans,11'
set output '$out/figure13.png'
set xlabel 'frame'; set ylabel 'Hausdorff distance from the start, % of sqrt(area)'
set grid; set key top left; set xrange [1:$frames]; set yrange [0:*]
plot '$w/faces.curve' using (\$0+1):1 with linespoints pt 7 ps 0.6 lw 2 lc rgb '#1b6ca8' title '(a) faces', \
	'$w/teeth.curve' using (\$0+1):1 with linespoints pt 7 ps 0.6 lw 2 lc rgb '#2e933c' title '(b) teeth', \
	'$w/statue.curve' using (\$0+1):1 with linespoints pt 7 ps 0.6 lw 2 lc rgb '#d1495b' title '(c) face to Buddha'
END
run gnuplot "$w/figure13.gp"
shown figure13 'Figure 13: Hausdorff distance from the start, `lhdiff`, `hausdorff_rel`'
