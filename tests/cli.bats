# The command line: help, version, mistakes, wrong and missing input, for every command.

load helper

setup_file() {
	load helper
	mkmesh -n 200 cap -o "$tmp/cap.off"
	mesh2rect -n 16 "$tmp/cap.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	lhinterp -n 3 "$tmp/lh" "$tmp/lh" -o "$tmp/three.lh"
	lh2grid "$tmp/three.lh" -o "$tmp/three.phi"
	mesh2rect -n 16x20 "$tmp/cap.off" | grid2lh -o "$tmp/other.lh"
	grid2lh --no-lattice "$tmp/phi" -o "$tmp/nostart.lh"
}

@test "--help prints the usage to stdout, --version one line, both exit 0" {
	for c in $commands; do
		try 0 '' /dev/null $c --help
		grep -q "^usage: $c" "$tmp/out"
		try 0 '' /dev/null $c -h
		try 0 '' /dev/null $c --version
		[ "$(wc -l <"$tmp/out")" = 1 ]
		grep -Eq "^$c \(lhgrid\) [0-9.]+$" "$tmp/out"
	done
}

@test "unknown options, missing values and bad numbers exit 2" {
	for c in $commands; do
		try 2 'unknown or ambiguous option --frobnicate' /dev/null $c --frobnicate
		try 2 'unknown option -Z' /dev/null $c -Z
		try 2 'option -o needs a value|option --output needs a value' /dev/null $c -o
	done
	try 2 'need a whole number in \[4,32767\]'  /dev/null mesh2rect -n 3
	try 2 'need a whole number in \[4,32767\]'  /dev/null mesh2rect -n 99999999999999999999
	try 2 'need a whole number in \[4,32767\]'  /dev/null mesh2rect -n 16x
	try 2 'need a whole number in \[4,32767\]'  /dev/null mesh2rect -n 16x16x16
	try 2 'need a whole number in \[2,4096\]'   /dev/null grid2lh --lattice=1
	try 2 'not one of its words'                /dev/null grid2lh --mean-curvature=gauss
	try 2 'need a number in \[0,'               /dev/null lhfft -K -1
	try 2 'need a number in \[0,'               /dev/null lhfft -K 2x
	try 2 'need a number in \[0,'               /dev/null lhfft -K nan
	try 2 'say one of'                          /dev/null lhfft
	try 2 'say one of'                          /dev/null lhfft -K 2 --keep=3
	try 2 'need a whole number in \[1,'         /dev/null lhfft --keep=0
	try 2 'need a number in \[0,1\]'            /dev/null lhinterp -t 1.5 a b
	try 2 'say one of'                          /dev/null lhinterp a b
	try 2 'say one of'                          /dev/null lhinterp -t 0.5 -n 3 a b
	try 2 'need a whole number in \[2,'         /dev/null lhinterp -n 1 a b
	try 2 'need an end of .off'                 /dev/null grid2mesh -o "$tmp/x.xyz"
	try 2 'need one %d'                         /dev/null grid2mesh -o "$tmp/%s.off"
	try 2 'need one %d'                         /dev/null grid2mesh -o "$tmp/%d%d.off"
}

@test "operands too many or too few exit 2" {
	for c in mesh2rect grid2lh lh2grid grid2mesh; do
		try 2 'operand two is one too many' /dev/null $c one two
	done
	try 2 'operand two is one too many' /dev/null lhfft -K 1 one two
	try 2 '1 operand missing'           /dev/null lhinterp -t 0 one
	try 2 '2 operands missing'          /dev/null lhdiff
	try 2 '.'                           /dev/null mkmesh
	try 2 '.'                           /dev/null mkmesh nosuchkind
}

@test "a missing file, a directory, empty input and another kind of input exit 1" {
	local c
	for c in mesh2rect grid2lh 'lhfft -K 1' lh2grid grid2mesh lhinfo; do
		try 1 'nosuch: No such file'             /dev/null $c "$tmp/nosuch"
		try 1 'Is a directory'                   /dev/null $c "$tmp"
		try 1 'stdin: empty input'               /dev/null $c
	done
	for c in grid2lh 'lhfft -K 1' lh2grid grid2mesh lhinfo; do
		try 1 'stdin: .*not an lhg'              "$tmp/cap.off" $c
	done
	try 1 'stdin: .*lhg'                             "$tmp/phi" mesh2rect
	try 1 'stdin: no channel x'                      "$tmp/lh" grid2lh
	try 1 'stdin: no channel x'                      "$tmp/lh" grid2mesh
	try 1 'stdin: no channel lambda'                 "$tmp/phi" lhfft -K 1
	try 1 'stdin: no channel lambda'                 "$tmp/phi" lh2grid
	try 1 'no channel lambda'                        /dev/null lhinterp -t 0 "$tmp/phi" "$tmp/phi"
	try 1 'has 17 x 17 nodes, .* has 17 x 21'        /dev/null lhinterp -t 0 "$tmp/lh" "$tmp/other.lh"
	try 1 'has a channel start.x, .* has none'       /dev/null lhinterp -t 0 "$tmp/lh" "$tmp/nostart.lh"
	try 1 'has a channel start.x, .* has none'       /dev/null lhinterp -t 0 "$tmp/nostart.lh" "$tmp/lh"
	try 1 'holds several grids'                      /dev/null lhinterp -t 0 "$tmp/three.lh" "$tmp/lh"
	try 1 'holds several grids'                      "$tmp/three.phi" grid2mesh
	try 1 'holds several grids'                      "$tmp/three.phi" grid2mesh -o "$tmp/one.off"
	[ ! -e "$tmp/one.off" ]
}

@test "corners: by number, by file, and what is wrong with them" {
	printf '0 1\n2,3\n' >"$tmp/corners"
	try 0 '' "$tmp/cap.off" mesh2rect -n 8 -c 0,1,2,3
	grid2mesh "$tmp/out" >"$tmp/by-number"
	try 0 '' "$tmp/cap.off" mesh2rect -n 8 --corners="$tmp/corners"
	grid2mesh "$tmp/out" | cmp "$tmp/by-number"
	try 0 '' "$tmp/cap.off" mesh2rect -n 8 -c auto
	try 1 'corner 199 is not a vertex of the boundary'  "$tmp/cap.off" mesh2rect -c 0,1,2,199
	try 1 'do not go round the boundary once'           "$tmp/cap.off" mesh2rect -c 3,2,1,0
	try 1 'do not go round the boundary once'           "$tmp/cap.off" mesh2rect -c 0,0,1,2
	try 1 'No such file'                                "$tmp/cap.off" mesh2rect -c 0,1,2
	echo 1 2 3 four >"$tmp/corners"
	try 1 'not four vertex numbers'                     "$tmp/cap.off" mesh2rect -c "$tmp/corners"
}

@test "binary data does not go to a terminal" {
	command -v script >/dev/null || skip "no script(1)"
	script -qec "mesh2rect '$tmp/cap.off'" /dev/null >"$tmp/seen" && return 1
	grep -q 'stdout is a terminal' "$tmp/seen"
}

@test "-q is silent where a note would stand, -v says more" {
	{ sed -n '1p' "$tmp/cap.off"; sed -n '2p' "$tmp/cap.off" | awk '{ print $1 + 1, $2, $3 }'
	  awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2' "$tmp/cap.off"; echo 9 9 9
	  awk 'NR == 2 { n = $1 } NR > n + 2' "$tmp/cap.off"; } >"$tmp/extra.off"
	try 0 '1 unreferenced vert' "$tmp/extra.off" mesh2rect -n 8
	try 0 ''                    "$tmp/extra.off" mesh2rect -q -n 8
	try 0 'certificate' "$tmp/cap.off" mesh2rect -v -n 8
	try 0 'Beltrami' "$tmp/phi" grid2lh -v
}
