# table.sh - Table 1: the error of the reconstruction from lambda, H and the boundary (K = 0).

# papers ROLE: prints max, mean, and max over sqrt(area) from Table 1 of the paper.
papers() {
	case $1 in
	man)    echo '3.0033 | 1.0771 | 1.67 %' ;;
	woman)  echo '2.5706 | 0.7239 | 1.50 %' ;;
	cortex) echo '2.2157 | 0.5967 | 1.14 %' ;;
	molar)  echo '0.1189 | 0.0329 | 0.98 %' ;;
	buddha) echo '8.7897 | 2.1967 | 1.83 %' ;;
	*)      echo '- | - | -' ;;
	esac
}

table_row() {
	pair "$1" "$(mesh "$1")" "$cells" $(chart "$1")
	timed "$1.filter" lhfft -q -K 0 "$w/$1-lh.lhg" -o "$w/$1-k.lhg"
	timed "$1.back" lh2grid -q "$w/$1-k.lhg" -o "$w/$1-back.lhg"
	run lhdiff --no-hausdorff --no-self-intersections "$w/$1.lhg" "$w/$1-back.lhg" -o "$w/$1.diff"
	max=$(number "$w/$1.diff" max_rel) mean=$(number "$w/$1.diff" mean_rel)
	say "| $(title "$1"), \`$(basename "$(mesh "$1")")\` | $(short "$(number "$w/$1.diff" max)") |\
 $(short "$(number "$w/$1.diff" mean)") | $(short "$max" 100) % | $(short "$mean" 100) % | $(papers "$1") |"
	echo "| $(title "$1") | $(cat "$w/$1.map.seconds") | $(cat "$w/$1.lh.seconds") |" \
		"$(cat "$w/$1.filter.seconds") | $(cat "$w/$1.back.seconds") |" >>"$out/times.md"
	awk -v x="$max" 'BEGIN { exit !(x < 0.0183) }' || {
		beyond="$beyond $1"
		worse="$worse${worse:+, }$(title "$1")"
	}
}

say '## Table 1: the surface from (lambda, H), K = 0' '' \
	"Grids of $((cells + 1)) x $((cells + 1)) nodes. max and mean are distances between corresponding nodes in the" \
	'unit of each mesh; the last two of ours and the last of the paper are over the square root of the area. Measured by' '' \
	"    mesh2rect -n $cells MESH -o A.lhg; grid2lh A.lhg | lhfft -K 0 | lh2grid -o B.lhg; lhdiff A.lhg B.lhg" '' \
	"What took how long: times.md." ''
say '| surface | max | mean | max % | mean % | paper: max | mean | max % |'
say '|---|---|---|---|---|---|---|---|'
printf '%s\n\n%s\n%s\n' "Seconds a stage, $((cells + 1)) x $((cells + 1)) nodes" \
	'| surface | mesh2rect | grid2lh | lhfft | lh2grid |' '|---|---|---|---|---|' >"$out/times.md"
worse='' beyond=''
for role in $kinds; do
	table_row "$role"
done
say ''
promise "$worse" "K = 0 gives the surface back to at most the paper's largest error, 1.83 % of sqrt(area) (Table 1)"

# where ROLE: adds a picture of the error on the surface to the report.
where() {
	python paper.d/apart.py "$w/$1.lhg" "$w/$1-back.lhg" "$w/$1-apart.lhg"
	render --size=$side $(view "$1") --paint="$w/$1-apart.lhg:distance" --top=0.2 \
		"$w/$1-apart.png" "$w/$1.lhg" >"$w/$1-apart.ends"
	figure "error-$1" $side 1 "$w/$1-apart.png" "distance to the surface given back, $(title "$1")" \
		0 "$(cut -d' ' -f2 "$w/$1-apart.ends")"
	shown "error-$1" "Where the error of $(title "$1") sits (scripts/paper.d/apart.py)"
}

for role in $beyond; do
	where "$role"
done
