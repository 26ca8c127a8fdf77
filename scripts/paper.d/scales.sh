# scales.sh - Figures 6 and 7: one surface at many scales; bending energy and distances.

scales=0,0.2,0.5,1,2,5

# multi ROLE: makes $w/ROLE-scales.lhg, a surface for each of $scales, and measures it: the bending
# energy in percent of the original's, the distances from the original in percent of sqrt(area),
# the percentage of coefficients kept, and the pairs of crossing faces.
multi() {
	lhfft -v -K $scales "$w/$1-lh.lhg" -o "$w/$1-f.lhg" 2>"$w/$1.kept" || die "$(tail -n 1 "$w/$1.kept")"
	kept "$1" >"$w/$1.share"
	back "$1-f" "$1-scales"
	run grid2lh -q "$w/$1-scales.lhg" -o "$w/$1-again-lh.lhg"
	{ python bending.py "$w/$1-lh.lhg"; python bending.py "$w/$1-again-lh.lhg"; } >"$w/$1.energy"
	awk 'NR == 1 { first = $1; next } { printf "%.4g ", 100*$1/first }' "$w/$1.energy" >"$w/$1.bending"
	diffs "$1" "$1-scales" --no-hausdorff
	column "$1-scales" mean_rel 100 >"$w/$1.mean"
	column "$1-scales" max_rel 100 >"$w/$1.max"
	column "$1-scales" self_intersections_b >"$w/$1.self"
}

# kept ROLE: prints the percentage of the coefficients of both fields that lhfft kept, from its notes.
kept() {
	awk '/ of lambda kept/ { a = $3; n = $5 } / of lambda H kept/ { printf "%.3g ", 100*(a + $3)/(n + $5) }' "$w/$1.kept"
}

# bends ROLE: tests that the bending energy is at most 103 % of the original's and falls from
# K = 0.5 on.
bends() {
	awk '{ for (i = 1; i <= NF; i++) if (!($i <= 103)) bad = 1
	       for (i = 4; i <= NF; i++) if (!($i < $(i-1))) bad = 1 } END { exit bad }' "$w/$1.bending"
}

table_line() { printf '| %s | %s |\n' "$(title "$1")" "$(awk '{ for (i = 1; i <= NF; i++) printf "%s%.3g", (i > 1 ? " | " : ""), $i }' "$2")"; }

# scale_table MEASURE: adds a table of $w/ROLE.MEASURE to the report, one row for each surface.
scale_table() {
	say "| K | $(echo $scales | sed 's/,/ | /g') |" '|---|---|---|---|---|---|---|'
	for role in $kinds; do
		say "$(table_line "$role" "$w/$role.$1")"
	done
	say ''
}

# row ROLE NAME: makes figure NAME of the original and the surface at each scale above 0.
row() {
	render --size=$side $(view "$1") "$w/$1-scale-0-%d.png" "$w/$1.lhg"
	render --size=$side $(view "$1") "$w/$1-scale-%d.png" "$w/$1-scales.lhg"
	into=$2
	set -- "$1" "$w/$1-scale-0-1.png" '(a) original' '' ''
	number=1
	for k in $(echo ${scales#0,} | tr , ' '); do
		number=$((number + 1))
		set -- "$@" "$w/$1-scale-$number.png" "K = $k, $(cut -d' ' -f$number "$w/$1.share") % kept" '' ''
	done
	shift
	figure "$into" $side 3 "$@"
}

# few: makes a figure of the man's face from small shares of its coefficients.
few() {
	nodes=$(((cells + 1)*(cells + 1)))
	set -- "$w/man-scale-0-1.png" 'original' '' ''
	list='' number=0
	for share in 10 3 1 0.3 0.1; do
		number=$((number + 1))
		list=$list${list:+,}$(awk -v s=$share -v n=$nodes 'BEGIN { printf "%d", s*n/100 + 1 }')
		set -- "$@" "$w/man-few-$number.png" "$share % of the coefficients" '' ''
	done
	run lhfft -q --keep="$list" "$w/man-lh.lhg" -o "$w/man-few.lhg"
	back man-few man-few-grids
	render --size=$side $(view man) "$w/man-few-%d.png" "$w/man-few-grids.lhg"
	figure figure6-few $side 3 "$@"
}

hue() { echo 1b6ca8 d1495b 2e933c e6a100 7b4fa3 17becf 8c564b e377c2 4d4d4d | cut -d' ' -f"$1" | sed 's/^/#/'; }

# distance_plot: plots the mean distance from the original against the share of coefficients kept,
# one curve for each surface.
distance_plot() {
	plot='' colour=0
	for role in $kinds; do
		colour=$((colour + 1))
		paste -d' ' "$w/$role.share" "$w/$role.mean" | awk '{ n = NF/2; for (i = 1; i <= n; i++) print $i, $(n + i) }' >"$w/$role.curve"
		plot="$plot${plot:+, }'$w/$role.curve' using 1:2 with linespoints pt 7 ps 0.7 lw 2 lc rgb '$(hue $colour)' title '$(title "$role")'"
	done
	cat >"$w/distance.gp" <<-END
		set terminal pngcairo size 860,520 font 'DejaVu Sans,11'
		set output '$out/distance.png'
		set logscale xy
		set format '%g'
		set xlabel 'coefficients of log {/Symbol l} and {/Symbol l} H kept, %'
		set ylabel 'mean distance to the original, % of sqrt(area)'
		set key outside right
		set grid
		plot $plot
	END
	run gnuplot "$w/distance.gp"
}

bent='' apart='' back=''
for role in $kinds; do
	multi "$role"
	bends "$role" || bent="$bent${bent:+, }$(title "$role")"
	[ -z "$(rising $(cat "$w/$role.mean"))" ] || apart="$apart${apart:+, }$(title "$role")"
	[ -z "$(rising $(cat "$w/$role.max"))" ] || back="$back${back:+, }$(title "$role")"
done
row man figure6
row cortex figure7
row buddha scales-buddha
few
distance_plot

say '## Figures 6 and 7: many scales' '' "Grids of $((cells + 1)) x $((cells + 1)) nodes." '' \
	"    mesh2rect -n $cells MESH -o A.lhg; grid2lh A.lhg | lhfft -K $scales | lh2grid -o B.lhg" ''
shown figure6 "Figure 6: $(title man), lhfft -K"
shown figure7 "Figure 7: $(title cortex), lhfft -K"
shown scales-buddha "$(title buddha), lhfft -K; look at the head, far from the boundary, for dents"
shown figure6-few "At 1 % a face is still a face. A face from few coefficients of either field: lhfft --keep"
say '### Distance to the original' '' 'Mean over the nodes, percent of sqrt(area): `lhdiff A B`, `mean_rel`, B the grids of the stream.' ''
scale_table mean
say 'The largest, `max_rel`:' ''
scale_table max
shown distance 'Mean distance to the original against the share of coefficients kept (`lhfft -v`), K = 0 to 5'
say '### Bending energy' '' 'Percent of the original: `scripts/bending.py` of `grid2lh B.lhg` over that of `grid2lh A.lhg`.' ''
scale_table bending
say 'Pairs of faces that cross, `lhdiff`, `self_intersections_b`:' ''
scale_table self
promise "$bent" "the bending energy is never more than 3 % above the original's and falls from K = 0.5 on"
promise "$apart" "the mean distance to the original grows with K on every surface"
[ -z "$back" ] || say "The largest distance, at one node, does not grow with K on: $back." ''
