# spiral.sh - Figures 8 and 9: a spiral becomes part of a Moebius strip.

# crossing STREAM: writes the number of pairs of crossing faces of each frame to $w/STREAM.self.
crossing() {
	diffs "$1" "$1" --no-hausdorff
	column "$1" self_intersections_a >"$w/$1.self"
}

count_with() { awk '{ for (i = 1; i <= NF; i++) n += ($i > 0) } END { print n + 0 }' "$w/$1.self"; }

strip=$((cells/2))x$((cells/8))
pair spiral "$(mesh spiral)" $strip $(chart spiral)
pair moebius-there "$(mesh moebius)" $strip $(chart moebius)
python paper.d/meet.py "$w/spiral.lhg" "$w/moebius-there.lhg" "$w/moebius.lhg"
run grid2lh -q "$w/moebius.lhg" -o "$w/moebius-lh.lhg"
run lhinterp -q --rule=linear -n "$frames" "$w/spiral-lh.lhg" "$w/moebius-lh.lhg" -o "$w/strip-lh.lhg"
# Held, the surfaces in the middle cross themselves and fit badly: their last steps creep, and move
# the surface by more than lh2grid accepts at its usual tolerance.
run lh2grid -q --tolerance=2e-4 "$w/strip-lh.lhg" -o "$w/held.lhg"
run lh2grid -q --boundary=free --follow --steps=2000 "$w/strip-lh.lhg" -o "$w/strip.lhg"
run lhdiff --no-hausdorff --no-self-intersections "$w/moebius.lhg" "$w/strip.lhg" -o "$w/strip-end.diffs"
python paper.d/linear.py "$w/held.lhg" "$w/straight.lhg"
crossing strip
crossing held
crossing straight

half=$((frames/2)) next=$((frames/2 + 1))
render --size=$side --each --pick=1,$half,$next,"$frames" $(view spiral) "$w/straight-%d.png" "$w/straight.lhg"
render --size=$side --each --pick=$half,$next $(view spiral) "$w/strip-%d.png" "$w/strip.lhg"
figure figure8 $side 3 \
	"$w/straight-1.png" '(a) spiral' '' '' "$w/straight-$half.png" "(c) linear, frame $half" '' '' \
	"$w/straight-$next.png" "(d) linear, frame $next" '' '' \
	"$w/straight-$frames.png" '(b) part of a Moebius strip' '' '' \
	"$w/strip-$half.png" "(e) {/Symbol l} and H, frame $half" '' '' \
	"$w/strip-$next.png" "(f) {/Symbol l} and H, frame $next" '' ''

tr ' ' '\n' <"$w/straight.self" >"$w/straight.curve"
tr ' ' '\n' <"$w/strip.self" >"$w/strip.curve"
tr ' ' '\n' <"$w/held.self" >"$w/held.curve"
cat >"$w/figure9.gp" <<END
set terminal pngcairo size 860,420 font 'DejaVu Sans,11'
set output '$out/figure9.png'
set xlabel 'frame'; set ylabel 'pairs of faces that cross'
set grid; set key top right; set xrange [1:$frames]
plot '$w/straight.curve' using (\$0+1):1 with linespoints pt 7 ps 0.7 lw 2 lc rgb '#d1495b' title 'positions, linear', \
	'$w/held.curve' using (\$0+1):1 with linespoints pt 7 ps 0.7 lw 2 lc rgb '#2e933c' title '{/Symbol l} and H, boundary curve linear', \
	'$w/strip.curve' using (\$0+1):1 with linespoints pt 7 ps 0.7 lw 2 lc rgb '#1b6ca8' title '{/Symbol l} and H, boundary free'
END
run gnuplot "$w/figure9.gp"

say '## Figures 8 and 9: spiral to part of a Moebius strip' '' \
	"Grids of $strip cells, $frames frames; the Moebius part scaled to the area of the spiral and moved rigidly onto it." '' \
	"    lhinterp --rule=linear -n $frames A.lhg B.lhg | lh2grid --boundary=free --follow --steps=2000 -o MORPH.lhg" \
	'    lhdiff --no-hausdorff MORPH.lhg MORPH.lhg' '' \
	'against straight lines from its first to its last grid, `scripts/paper.d/linear.py`.'
shown figure8 'Figure 8: the ends, and two frames by linear positions and by lambda and H'
shown figure9 'Figure 9: pairs of faces that cross'
say "Frames with faces that cross: linear $(frames_with straight) (the paper: 29-35); by lambda and H $(frames_with strip) (the paper: none);" \
	"by lambda and H within the straight lines between the two boundary curves, (20): $(frames_with held)." '' \
	'Where those lines run through the strip, every surface has crossings, so the boundary is computed' \
	'too. lambda and H do not determine such a strip: it can bend while keeping both. So the last frame,' \
	'with lambda and H of the Moebius part, is another strip; its mean distance from that part is' \
	"$(short "$(column strip-end mean_rel 100 | awk '{ print $NF }')") % of sqrt(area)." ''
wrong=
[ "$(count_with strip)" = 0 ] || wrong="$(count_with strip) of $frames frames; linear positions: $(count_with straight)"
promise "$wrong" "spiral to Moebius part: no frame with faces that cross by (lambda, H)"
