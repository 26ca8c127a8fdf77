# helper.bash - functions shared by the tests of commands.  Run from the top of the repository.

bats_require_minimum_version 1.5.0
BUILD=${BUILD:-build}
PATH=$PWD/$BUILD/bin:$PATH
export GOMP_SPINCOUNT=3000
meshes=$(realpath -m "${LHGRID_MESHES:-../shared/meshes}")    # some tests change the folder
commands="mesh2disk mesh2rect grid2lh lhfft lhwarp lhinterp lh2grid grid2mesh lhinfo lhdiff lh2png grid2html mkmesh"
tmp=$BATS_FILE_TMPDIR

# try EXIT PATTERN STDIN COMMAND...
#
# Runs COMMAND with the file STDIN as input and checks that it exits with EXIT.  stderr must be one
# line that begins with "command: " and matches PATTERN, or empty if PATTERN is ''.  stdout must be
# empty if EXIT is not 0; it is left in $tmp/out.  Most tests use coarse grids, so mesh2rect notes how
# much of the mesh the grid loses; this note is ignored unless PATTERN is about it.
try() {
	local want=$1 pattern=$2 input=$3 code=0
	shift 3
	if [ "$want" = 0 ]; then
		"$@" <"$input" >"$tmp/out" 2>"$tmp/err" || code=$?
	else    # a command that dies by exit() does not free its memory
		ASAN_OPTIONS=detect_leaks=0 "$@" <"$input" >"$tmp/out" 2>"$tmp/err" || code=$?
		[ ! -s "$tmp/out" ] || complain "$*: wrote to stdout"
	fi
	[ $code = "$want" ] || complain "$*: exit $code, not $want"
	[[ $pattern == *'grid holds'* ]] || sed -i '/: the grid holds .* lose less$/d' "$tmp/err"
	if [ -z "$pattern" ]; then
		[ ! -s "$tmp/err" ] || complain "$*: not silent"
	else
		[ "$(wc -l <"$tmp/err")" = 1 ] || complain "$*: not one line"
		grep -Eq "^$1: .*$pattern" "$tmp/err" || complain "$*: stderr does not match $pattern"
	fi
}

# three_js: makes the folder $tmp/three for grid2html, with scripts in place of three.js that do nothing.
three_js() {
	mkdir -p "$tmp/three/examples/js/controls"
	echo '// three' >"$tmp/three/three.min.js"
	echo '// controls' >"$tmp/three/examples/js/controls/OrbitControls.js"
}

complain() {
	echo "$1"
	head -c 2000 "$tmp/err"
	return 1
}

# error_of A B NAME: prints the number NAME of lhdiff A B, such as max_rel, the max over sqrt(area).
error_of() {
	lhdiff --no-hausdorff --no-self-intersections "$1" "$2" | awk -v n="$3" '$1 == n { print $2 }'
}

# below X Y: checks that X is a number and less than Y.
below() {
	awk -v x="$1" -v y="$2" 'BEGIN { exit !(x ~ /^[0-9.e+-]+$/ && x + 0 < y + 0) }' ||
		{ echo "$1 is not below $2"; return 1; }
}

# Whether the programs have sanitizers: BUILD is then a folder in another.
sanitized() { case $BUILD in */*) true ;; *) false ;; esac; }
