# equal.sh - Figures 6 and 7 once more: lhfft --scale beside -K, cotangent smoothing and filtered
# positions, at equal bending energy; and noise, removed in these ways and by --relief.

if [ $real = yes ]; then
	compared="$kinds flatcuts hemisphere bunny" pictured='man cortex buddha molar bunny'
else
	compared='man cortex molar' pictured=man
fi
# s = L/(2 pi) in percent of sqrt(area): .5, 1, 2 on 256 cells, in proportion to the cells on others
spread=$(awk -v n="$cells" 'BEGIN { f = 256/n; printf "%.4g,%.4g,%.4g", .5*f, f, 2*f }')

# equal ROLE: makes $w/ROLE.equal, the measures that equal.py prints, and $w/ROLE-equal-S.lhg.
equal() {
	[ -e "$w/$1-lh.lhg" ] || pair "$1" "$(mesh "$1")" "$cells" $(chart "$1")
	python paper.d/equal.py "$w/$1.lhg" "$w/$1-lh.lhg" "$spread" "$w/$1-equal" >"$w/$1.equal"
}

# ratios ROLE: prints lines "ROLE S NAME VALUE": measures of --scale, and its ratios to the other ways.
ratios() {
	awk -v role="$1" '
		function ratio(name, a, b) { print role, s[i], name, (a > 0 && b > 0 ? a/b : "-") }
		$2 == "scale" { s[++n] = $1; print role, $1, "bending", 100*$4; print role, $1, "largest", $6
		                print role, $1, "crossings", $9; print role, $1, "folded", $10; print role, $1, "solves", $11 }
		{ mean[$1,$2] = $5; rough[$1,$2] = $7; inner[$1,$2] = $8 }
		END { for (i = 1; i <= n; i++) {
			print role, s[i], "mean", mean[s[i],"scale"]
			ratio("far-cotangent", mean[s[i],"scale"], mean[s[i],"cotangent"])
			ratio("rough-cotangent", rough[s[i],"scale"], rough[s[i],"cotangent"])
			ratio("inner-cotangent", inner[s[i],"scale"], inner[s[i],"cotangent"])
			ratio("inner-positions", inner[s[i],"scale"], inner[s[i],"positions"])
			ratio("far-positions", mean[s[i],"scale"], mean[s[i],"positions"])
			ratio("rough-positions", rough[s[i],"scale"], rough[s[i],"positions"])
			ratio("bound-cotangent", mean[s[i],"bound"], mean[s[i],"cotangent"])
			ratio("bound-rough", rough[s[i],"bound"], rough[s[i],"cotangent"]) } }' "$w/$1.equal"
}

# columns_of ROLE NAME...: prints the numbers of these names, s after s, as cells of a table.
columns_of() {
	of=$1
	shift
	for name; do
		awk -v role="$of" -v name="$name" '$1 == role && $3 == name { printf $4 == "-" ? " | -" : " | %.3g", $4 }' "$w/equal.ratios"
	done
}

# ratio_table HEADING NAME...: adds a table of these to the report, a row for each surface.
ratio_table() {
	say "| s, % | $1 |" "|---|$(for name in $(seq $((3*($# - 1)))); do printf -- '---|'; done)"
	shift
	for role in $compared; do
		say "| $(title "$role")$(columns_of "$role" "$@") |"
	done
	say ''
}

# above NAME MOST: prints the surfaces where NAME is above MOST, or undefined, and how much it is.
above() {
	awk -v name="$1" -v most="$2" '$3 == name && !($4 != "-" && $4 <= most) {
		printf "%s%s at %s %%: %s", sep, $1, $2, $4; sep = ", " }' "$w/equal.ratios"
}

# middle NAME: prints the median.
middle() {
	awk -v name="$1" '$3 == name && $4 != "-" { print $4 }' "$w/equal.ratios" | sort -g |
		awk '{ a[NR] = $1 } END { printf "%.3g", (a[int((NR + 1)/2)] + a[int(NR/2 + 1)])/2 }'
}

# within NAME MOST MEDIAN TEXT: adds the promise that NAME is at most MOST everywhere and at most MEDIAN
# in the median.
within() {
	wrong=$(above "$1" "$2")
	awk -v x="$(middle "$1")" -v m="$3" 'BEGIN { exit !(x <= m) }' || wrong="$wrong${wrong:+, }median $(middle "$1")"
	promise "$wrong" "$4"
}

# beside ROLE: makes figure equal-ROLE, a row for each s.
beside() {
	of=$1 k=0
	render --size=$side $(view "$of") "$w/$of-equal-0-%d.png" "$w/$of.lhg"
	set --
	for s in $(echo "$spread" | tr , ' '); do
		k=$((k + 1))
		render --size=$side $(view "$of") "$w/$of-equal-$k-%d.png" "$w/$of.lhg" "$w/$of-equal-$s.lhg"
		set -- "$@" "$w/$of-equal-$k-1.png" 'original' '' '' \
			"$w/$of-equal-$k-2.png" "--scale=$(parameter scale)%" '' '' "$w/$of-equal-$k-3.png" "-K $(parameter bound)" '' '' \
			"$w/$of-equal-$k-4.png" "cotangent$(far cotangent)" '' '' "$w/$of-equal-$k-5.png" "positions$(far positions)" '' ''
	done
	figure "equal-$of" $side 5 "$@"
	shown "equal-$of" "$(title "$of"): the surface, and four of the same bending energy; s = $spread % of sqrt(area)"
}

parameter() { awk -v s="$s" -v way="$1" '$1 == s && $2 == way { printf "%.3g", $3 }' "$w/$of.equal"; }

far() { awk -v s="$s" -v way="$1" '$1 == s && $2 == "scale" { d = $5 } $1 == s && $2 == way { printf ", %.2g times as far", $5/d }' "$w/$of.equal"; }

# pairwise A B: two surfaces at a time, each with a file of its own for what its commands say.
pairwise() {
	(said=$w/said-$1; equal "$1") &
	other=$!
	[ -z "$2" ] || (said=$w/said-$2; equal "$2") || { wait $other; exit 1; }
	wait $other || exit 1
}

# shellcheck disable=SC2086  # a list of words
set -- $compared
while [ $# -gt 0 ]; do
	pairwise "$1" "${2:-}"
	shift $(($# > 1 ? 2 : 1))
done
for role in $compared; do
	ratios "$role"
done >"$w/equal.ratios"

say '## Scales at equal bending energy' '' \
	"\`lhfft --scale=L\`, L = 2 pi s, s = $spread percent of sqrt(area), beside three other ways whose parameters are such that" \
	'the bending energy is the same: `lhfft -K`; an implicit step of cotangent smoothing of x, y, z; x, y, z filtered as --scale' \
	'does (scripts/paper.d/equal.py). Distance is that of each node from the original surface; the integral of |grad H|^2 and' \
	'the bending energy leave out the border and two rings of nodes beside it, where all ways keep to the same ragged curve;' 'inner grad H leaves out eight.' ''
for role in $pictured; do
	beside "$role"
done
say "\`--scale\`: bending energy, percent of the original's; mean and largest distance, percent of sqrt(area); pairs of crossing faces" \
	"more than the original's; folded cells near the corners; solves, for each s:" ''
ratio_table 'bending | | | mean | | | largest | | | crossings | | | folded | | | solves | |' bending mean largest crossings folded solves
say "\`--scale\` over cotangent smoothing, mean distance and integral of |grad H|^2:" ''
ratio_table 'distance | | | grad H | | | inner grad H | |' far-cotangent rough-cotangent inner-cotangent
say "\`--scale\` over filtered positions:" ''
ratio_table 'distance | | | grad H | | | inner grad H | |' far-positions rough-positions inner-positions
say "\`-K\` over cotangent smoothing (-: no K gives this bending energy):" ''
ratio_table 'distance | | | grad H | |' bound-cotangent bound-rough
within far-cotangent .8 .55 'at equal bending energy --scale moves the surface at most .8 times as far as cotangent smoothing, .55 in the median'
within rough-cotangent .7 .5 "at equal bending energy its integral of |grad H|^2 is at most .7 of cotangent smoothing's, .5 in the median"
promise "$(above far-positions 1.1)" 'at equal bending energy --scale moves the surface at most 1.1 times as far as filtered positions'
promise "$(above rough-positions 1)" "at equal bending energy its integral of |grad H|^2 is at most that of filtered positions"
promise "$(above crossings 0)" 'after --scale no more faces cross than before'
promise "$(above folded 0)" 'after --scale no cell near a corner is folded'
wrong=$(awk '$3 == "bending" { if ($1 == role && !($4 < last)) printf "%s ", $1; role = $1; last = $4 }' "$w/equal.ratios")
promise "$wrong" 'the bending energy falls from scale to scale'

# noise: the man's face with noise of .03 % of sqrt(area).
python paper.d/noise.py "$w/man.lhg" .03 "$w/noise" >"$w/noise.table"
render --size=$side $(view man) "$w/noise-%d.png" "$w/noise.lhg"
degrees() { awk -v way="$1" '$1 == way { print $3 }' "$w/noise.table"; }
figure noise $side 4 "$w/noise-1.png" 'original' '' '' "$w/noise-2.png" "noise: normals off by $(degrees noisy) degrees" '' '' \
	"$w/noise-3.png" "-K: $(degrees bound)" '' '' "$w/noise-4.png" "cotangent: $(degrees cotangent)" '' '' \
	"$w/noise-5.png" "positions: $(degrees positions)" '' '' "$w/noise-6.png" "--scale: $(degrees scale)" '' '' \
	"$w/noise-7.png" "--relief: $(degrees relief)" '' ''
say '### Noise' '' "Noise of .03 % of sqrt(area) along the normals, removed by each way at the parameter for which the normals are nearest" \
	'to those before (scripts/paper.d/noise.py); the mean angle between them in degrees, and the bending energy over that before.' ''
shown noise "$(title man): noise, removed in five ways"
say '| way | parameter | degrees | bending |' '|---|---|---|---|'
sed 's/ / | /g; s/.*/| & |/' "$w/noise.table" >>"$w/body.md"
say ''
wrong=$(awk '{ angle[$1] = $3; bending[$1] = $4 }
	END { if (!(angle["relief"] <= 1.35)) print angle["relief"], "degrees"; if (!(bending["relief"] >= .85)) print "bending", bending["relief"] }' "$w/noise.table")
[ $real = no ] || promise "$wrong" '--relief leaves normals that are off by at most 1.35 degrees, and .85 of the bending energy'
