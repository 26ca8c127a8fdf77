# common.sh - functions shared by the parts of scripts/paper.

export PYTHONDONTWRITEBYTECODE=1

die() {
	echo "paper: $*" >&2
	exit 1
}

need() {
	for command; do
		command -v "$command" >/dev/null || die "$command: not found"
	done
}

# run COMMAND...: runs COMMAND, its stderr to $said; if it fails, dies with the last line there.
said=$w/said
run() {
	"$@" 2>"$said" || die "$(tail -n 1 "$said")"
}

# timed NAME COMMAND...: like run, and writes the seconds that COMMAND took to $w/NAME.seconds.
timed() {
	t=$w/$1.seconds
	shift
	run /usr/bin/time -q -o "$t" -f %e "$@"
}

python() { script=$1; shift; run /usr/bin/python3 "$here/$script" "$@"; }
render() { python render.py "$@"; }

# diffs A STREAM [OPTION]: writes to $w/STREAM.diffs lhdiff's table of the grids of $w/STREAM.lhg
# against $w/A.lhg.
diffs() {
	run lhdiff ${3:+"$3"} "$w/$1.lhg" "$w/$2.lhg" -o "$w/$2.diffs"
}

# column STREAM NAME [FACTOR]: prints column NAME of that table, times FACTOR, on one line.
column() {
	awk -F '\t' -v name="$2" -v f="${3:-1}" '
		NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; if (!c) exit 1; next }
		{ printf "%.6g ", f*$c }' "$w/$1.diffs" || die "lhdiff has no column $2"
}

# frames_with STREAM: prints the numbers of the frames with crossing faces as ranges, from
# $w/STREAM.self, which has the number of crossings of each frame.
frames_with() {
	awk '{ for (i = 1; i <= NF + 1; i++)
		if (i <= NF && $i > 0) { if (!from) from = i }
		else if (from) { printf "%s%d%s", sep, from, (i - 1 > from ? "-" (i - 1) : ""); sep = ", "; from = 0 } }
		END { if (!sep) printf "none" }' "$w/$1.self"
}

# pair NAME MESH CELLS [MESH2RECT OPTIONS]: makes the grid $w/NAME.lhg of MESH, and its lambda and
# H, $w/NAME-lh.lhg.
pair() {
	grid=$1 from=$2 n=$3
	shift 3
	timed "$grid.map" mesh2rect -q -n "$n" "$@" "$from" -o "$w/$grid.lhg"
	timed "$grid.lh" grid2lh -q "$w/$grid.lhg" -o "$w/$grid-lh.lhg"
}

# back LH GRID: reconstructs the surfaces $w/GRID.lhg of a stream of lambda and H, $w/LH.lhg.
back() {
	run lh2grid -q "$w/$1.lhg" -o "$w/$2.lhg"
}

# number FILE NAME: prints the number NAME from FILE, an output of lhdiff.
number() {
	awk -v n="$2" '$1 == n { print $2; found = 1 } END { exit !found }' "$1" || die "lhdiff prints no $2"
}

# short X [FACTOR]: prints X, times FACTOR, to three significant digits.
short() { awk -v x="$1" -v f="${2:-1}" 'BEGIN { printf "%.3g", f*x }'; }

# rising NUMBER...: prints the index of the first number that is not above the one before it;
# nothing if they all rise.
rising() {
	awk 'BEGIN { for (i = 2; i < ARGC; i++) if (!(ARGV[i] + 0 > ARGV[i-1] + 0)) { print i; exit } }' "$@"
}

# promise FAILURE TEXT: adds a line to the report's list of promises.  The promise TEXT holds if
# FAILURE is empty; otherwise FAILURE says where it does not.
promise() {
	if [ -z "$1" ]; then mark=holds; else mark='**VIOLATED**'; fi
	printf -- '- %s: %s%s\n' "$mark" "$2" "${1:+; not: $1}" >>"$w/promises.md"
}

say() { printf '%s\n' "$@" >>"$w/body.md"; }

# shown PICTURE TEXT: adds a picture and its caption to the report.
shown() {
	say '' "![$2]($1.png)" '' "$2" ''
}

# figure NAME WIDTHxHEIGHT COLUMNS [PANEL TITLE LEFT RIGHT]...: makes $out/NAME.png of panels in rows.
# PANEL is a PNG file of WIDTHxHEIGHT; TITLE is written above it; LEFT and RIGHT are the numbers at
# the ends of its colour bar, or empty.
figure() {
	picture=$1 wide=${2%x*} high=${2#*x} columns=$3
	shift 3
	tall=$(((($#/4) + columns - 1)/columns*(high + 34)))
	{
		echo "set terminal pngcairo size $((wide*columns)),$tall font 'DejaVu Sans,11'"
		echo "set output '$out/$picture.png'"
		echo "unset key; unset tics; unset border; set margins 0,0,0,0"
		echo "set xrange [0:$((wide*columns))]; set yrange [0:$tall]"
		panels "$@"
	} >"$w/$picture.gp"
	run gnuplot "$w/$picture.gp"
}

panels() {
	x=0 y=$tall plot=plot
	images=
	while [ $# -ge 4 ]; do
		[ $x -lt $((wide*columns)) ] || { x=0; y=$((y - high - 34)); }
		echo "set label '$2' at $((x + wide/2)),$((y - 18)) center front"
		[ -z "$3" ] || {
			echo "set label '$3' at $((x + wide/5 - 6)),$((y - high - 27)) right front font ',9'"
			echo "set label '$4' at $((x + wide - wide/5 + 6)),$((y - high - 27)) left front font ',9'"
		}
		images="$images${images:+, }'$1' binary filetype=png origin=($x,$((y - high - 34))) with rgbimage"
		x=$((x + wide))
		shift 4
	done
	echo "plot $images"
}

# summary: writes the report; if this fails, there is no report.
summary() {
	{
		echo '# The paper on our surfaces'
		echo
		echo "Written by scripts/paper; \`work/\` has every stream and mesh the numbers were taken from."
		echo
		cat "$w/promises.md"
		echo
		cat "$w/body.md"
	} >"$w/report.md"
	mv "$w/report.md" "$out/report.md"
}
