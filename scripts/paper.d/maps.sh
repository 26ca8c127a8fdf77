# maps.sh - Figures 1 to 5: the map, lambda and H on the domain and on the surface, and the
# reconstructed surface.

# painted ROLE SURFACE CHANNEL NAME [OPTIONS]: draws the file SURFACE, coloured by CHANNEL of lambda
# and H of ROLE, to $w/NAME.png; the values at the ends of the colour bar go to $w/NAME.ends.
painted() {
	role=$1 surface=$2 channel=$3 name=$4
	shift 4
	render --size=$side --paint="$w/$role-lh.lhg:$channel" "$@" "$w/$name.png" "$surface" >"$w/$name.ends"
}

low()  { cut -d' ' -f1 "$w/$1.ends"; }
high() { cut -d' ' -f2 "$w/$1.ends"; }

# both ROLE: draws the surface and its reconstruction.
both() {
	render --size=$side $(view "$1") "$w/$1-surface.png" "$w/$1.lhg"
	render --size=$side $(view "$1") "$w/$1-again.png" "$w/$1-back.lhg"
}

# maps ROLE: draws all the pictures of one surface.
maps() {
	v=$(view "$1")
	both "$1"
	timed "$1.uv" mesh2rect -q -n 16 $(chart "$1") --uv="$w/$1-uv.obj" "$(mesh "$1")" -o "$w/$1-uv.lhg"
	render --size=$side --edges $v "$w/$1-mesh.png" "$w/$1-uv.obj"
	render --size=$side --edges --chart "$w/$1-chart.png" "$w/$1-uv.obj"
	render --size=$side --circles=32 $v "$w/$1-circles.png" "$w/$1.lhg"
	painted "$1" "$w/$1.lhg" lambda "$1-lambda" --log $v
	painted "$1" "$w/$1.lhg" lambda "$1-lambda-chart" --log --chart
	painted "$1" "$w/$1.lhg" H "$1-H" $v
	painted "$1" "$w/$1.lhg" H "$1-H-chart" --chart
}

# four ROLE NAME: makes figure NAME.  Above: the mesh, lambda, H and the reconstruction; below: the
# mesh, lambda and H on the rectangle, and circles of the rectangle on the surface.
four() {
	figure "$2" $side 4 \
		"$w/$1-mesh.png" '(a) the mesh' '' '' \
		"$w/$1-lambda.png" '(b) conformal factor {/Symbol l}' "$(low "$1-lambda")" "$(high "$1-lambda")" \
		"$w/$1-H.png" '(c) mean curvature H' "$(low "$1-H")" "$(high "$1-H")" \
		"$w/$1-again.png" '(d) the surface from {/Symbol l} and H' '' '' \
		"$w/$1-chart.png" 'the mesh on the rectangle' '' '' \
		"$w/$1-lambda-chart.png" '{/Symbol l} on the rectangle' "$(low "$1-lambda-chart")" "$(high "$1-lambda-chart")" \
		"$w/$1-H-chart.png" 'H on the rectangle' "$(low "$1-H-chart")" "$(high "$1-H-chart")" \
		"$w/$1-circles.png" 'circles of the rectangle on the surface' '' ''
}

for role in man cortex molar; do
	maps $role
done
both woman
both buddha

say '## Figures 1 to 5: conformal factor and mean curvature' '' \
	'Colours of lambda are logarithmic, from its 1st to its 99th percentile; of H from minus to plus the 95th percentile of |H|,' \
	'red where the surface is hollow as seen against its normal. Made by `scripts/render.py --paint=LH.lhg:H A.lhg`.' ''
figure figure1 $side 3 \
	"$w/cortex-mesh.png" '(a) the mesh' '' '' \
	"$w/cortex-chart.png" '(b) its conformal parameterization' '' '' \
	"$w/cortex-circles.png" '(c) circles of the rectangle on the surface' '' '' \
	"$w/cortex-lambda-chart.png" '(d) conformal factor {/Symbol l}' "$(low cortex-lambda-chart)" "$(high cortex-lambda-chart)" \
	"$w/cortex-H-chart.png" '(e) mean curvature H' "$(low cortex-H-chart)" "$(high cortex-H-chart)"
shown figure1 "Figure 1: $(title cortex)"
four man figure2
shown figure2 "Figure 2: $(title man)"
four cortex figure3
shown figure3 "Figure 3: $(title cortex)"
four molar figure4
shown figure4 "Figure 4: $(title molar)"
figure figure5 $side 4 \
	"$w/buddha-surface.png" '(a) Buddha' '' '' "$w/buddha-again.png" '(b) from {/Symbol l} and H' '' '' \
	"$w/woman-surface.png" '(c) another face' '' '' "$w/woman-again.png" '(d) from {/Symbol l} and H' '' ''
shown figure5 "Figure 5: $(title buddha) and $(title woman), before and after"
