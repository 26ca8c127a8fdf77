# cli.bats - the command line of every command: help, version, mistakes, wrong and missing input.

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

@test "--help: no line of more than 80 columns, and an example whose commands and options exist" {
	local c words word option
	for c in $commands; do
		$c --help >"$tmp/help"
		run ! grep -nE '^.{81}' "$tmp/help"
		[ "$(grep -c '^Example: ' "$tmp/help")" = 1 ]
		sed -n 's/^Example: //p' "$tmp/help" | tr '|' '\n' >"$tmp/example"
		grep -Eq "^ *$c " "$tmp/example"
		while read -r word words; do
			[[ " $commands " == *" $word "* ]]
			for option in $words; do
				[[ $option != --* ]] || $word --help | grep -q -- "${option%%=*}"
			done
		done <"$tmp/example"
	done
}

@test "-j: at most so many threads; the same bytes, and no trace in the history" {
	grid2lh -j 1 "$tmp/phi" | cmp - "$tmp/lh"
	grid2lh --threads=3 "$tmp/phi" | cmp - "$tmp/lh"
	[ "$(OMP_NUM_THREADS=1 OMP_DISPLAY_ENV=false sh -c 'grid2lh -j 2 "$1" | lhinfo' - "$tmp/phi" | grep -c -- '-j\|threads')" = 0 ]
	for c in $commands; do
		try 2 'threads=0: need a whole number in \[1,' /dev/null $c -j 0
		try 2 'option --threads needs a value' /dev/null $c -j
		try 2 'option --threads needs a value' /dev/null $c --threads
	done
}

@test "--progress: on stderr alone; json is one object on each line; never and -q are silent" {
	lh2grid --progress=always "$tmp/three.lh" 2>"$tmp/always" | cmp - "$tmp/three.phi"
	grep -q '^lh2grid: frame 1 of 3, 17 x 17 nodes$' "$tmp/always"
	run ! grep -q $'[\r\e]' "$tmp/always"
	lh2grid --progress=json "$tmp/three.lh" 2>"$tmp/json" | cmp - "$tmp/three.phi"
	[ -s "$tmp/json" ]
	python3 -c 'import json, sys
for line in open(sys.argv[1]):
	o = json.loads(line)
	assert o["program"] == "lh2grid" and o["doing"] and o["seconds"] >= 0 and "left" in o' "$tmp/json"
	for o in --progress=never --progress=auto '-q --progress=always'; do
		lh2grid $o "$tmp/three.lh" 2>"$tmp/err" | cmp - "$tmp/three.phi"
		[ ! -s "$tmp/err" ]
	done
	try 2 'progress=maybe: need auto, always, never or json' /dev/null lh2grid --progress=maybe
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
	try 2 'curvature=gauss: need normal or magnitude' /dev/null grid2lh --mean-curvature=gauss
	try 2 'need a number in \[0,'               /dev/null lhfft -K -1
	try 2 'need a number in \[0,'               /dev/null lhfft -K 2x
	try 2 'need a number in \[0,'               /dev/null lhfft -K nan
	try 2 'need exactly'                        /dev/null lhfft
	try 2 'need exactly'                        /dev/null lhfft -K 2 --keep=3
	try 2 'need exactly'                        /dev/null lhfft --raw --keep=3
	try 2 'need a whole number in \[1,'         /dev/null lhfft --keep=0
	try 2 'need exactly'                        /dev/null lhfft --K-H=1 --keep=3
	try 2 'need exactly'                        /dev/null lhfft --raw
	try 2 'bound=: need a number in \[0,'       /dev/null lhfft -K 1,,2
	try 2 'bound=: need a number in \[0,'       /dev/null lhfft -K 1,
	try 2 'bound=-2: need a number in \[0,'     /dev/null lhfft -K 1,-2
	try 2 'K-H=x: need a number in \[0,'        /dev/null lhfft -K 1 --K-H=x
	try 2 'more than 256 scales'                /dev/null lhfft -K "$(seq -s, 257)"
	try 2 'energy=1.5: need a number in \[0,1\]' /dev/null lhfft --energy=0.5,1.5
	try 2 'need exactly'                        /dev/null lhfft --raw --energy=0.5
	try 2 'low-pass=-1: need a number in \[0,'  /dev/null lhfft --low-pass=-1
	try 2 'need exactly'                        /dev/null lhfft --low-pass=1 --energy=0.5
	try 2 'the grid is written there' /dev/null lhfft -K 1 --spectrum=-
	try 2 'the grid is written there' /dev/null lhfft --spectrum="$tmp/x" -K 1 -o "$tmp/x"
	try 2 'need exactly'                        /dev/null lhfft --spectrum="$tmp/x"
	try 2 'basis=fft: need dct or dft'          /dev/null lhfft -K 1 --basis=fft
	try 2 'need a number in \[0,1\]'            /dev/null lhinterp -t 1.5 a b
	try 2 'need either'                         /dev/null lhinterp a b
	try 2 'need either'                         /dev/null lhinterp -t 0.5 -n 3 a b
	try 2 'need a whole number in \[2,'         /dev/null lhinterp -n 1 a b
	try 2 'need a name that ends in .off' /dev/null grid2mesh -o "$tmp/x.xyz"
	try 2 'need one %d'                         /dev/null grid2mesh -o "$tmp/%s.off"
	try 2 'need one %d'                         /dev/null grid2mesh -o "$tmp/%d%d.off"
	try 2 'need one %d'                         /dev/null lh2png -o "$tmp/%d%d.png"
}

@test "control bytes of an option or an operand do not reach the terminal" {
	for c in $commands; do
		try 2 'option --x\?\[2Jy' /dev/null $c $'--x\e[2Jy'
		run ! grep -q $'\e' "$tmp/err"
	done
	try 2 'operand t\?o is one too many' /dev/null grid2lh one $'t\no'
	# U+009B begins an escape sequence too, both as UTF-8 and as a single byte
	try 2 'operand \?\?2J\?2J is one too many' /dev/null grid2lh one $'\xc2\x9b2J\x9b2J'
	try 2 $'operand caf\xc3\xa9-\xc3\xbc-\xe2\x88\x82 is one too many' /dev/null grid2lh one $'caf\xc3\xa9-\xc3\xbc-\xe2\x88\x82'
	cp "$tmp/lh" "$tmp/"$'caf\xc3\xa9 \xc2\x9b\x9b\e'
	lhinfo "$tmp/"$'caf\xc3\xa9 \xc2\x9b\x9b\e' | head -1 | grep -qF $'caf\xc3\xa9 ????: '
}

@test "operands too many or too few exit 2" {
	for c in mesh2disk mesh2rect grid2lh lh2grid grid2mesh lh2png grid2html; do
		try 2 'operand two is one too many' /dev/null $c one two
	done
	try 2 'operand two is one too many' /dev/null lhfft -K 1 one two
	try 2 '1 operand missing'           /dev/null lhinterp -t 0 one
	try 2 '1 operand missing'           /dev/null lhwarp one
	try 2 '2 operands missing'          /dev/null lhdiff
	try 2 '.'                           /dev/null mkmesh
	try 2 '.'                           /dev/null mkmesh nosuchkind
}

@test "a missing file, a directory, empty input and input of another kind exit 1" {
	local c
	for c in mesh2disk mesh2rect grid2lh 'lhfft -K 1' lh2grid grid2mesh lhinfo lh2png grid2html; do
		try 1 'nosuch: No such file'             /dev/null $c "$tmp/nosuch"
		try 1 'Is a directory'                   /dev/null $c "$tmp"
		try 1 'stdin: empty input'               /dev/null $c
	done
	for c in grid2lh 'lhfft -K 1' lh2grid grid2mesh lhinfo lh2png grid2html; do
		try 1 'stdin: input is not an lhg stream: of a mesh, run mesh2rect first$' "$tmp/cap.off" $c
	done
	try 1 'stdin: .*lhg'                             "$tmp/phi" mesh2rect
	try 1 'stdin: no channel x: run lh2grid first$'  "$tmp/lh" grid2lh
	try 1 'stdin: no channel x: run lh2grid first$'  "$tmp/lh" grid2mesh
	try 1 'stdin: no channel lambda: run grid2lh first$' "$tmp/phi" lhfft -K 1
	try 1 'stdin: no channel lambda: run grid2lh first$' "$tmp/phi" lh2grid
	try 1 'no channel lambda: run grid2lh first$'                        /dev/null lhinterp -t 0 "$tmp/phi" "$tmp/phi"
	try 1 'has 17 x 17 nodes, .* has 17 x 21'        /dev/null lhinterp -t 0 "$tmp/lh" "$tmp/other.lh"
	try 1 'has a channel start.x, .* has none'       /dev/null lhinterp -t 0 "$tmp/lh" "$tmp/nostart.lh"
	try 1 'has a channel start.x, .* has none'       /dev/null lhinterp -t 0 "$tmp/nostart.lh" "$tmp/lh"
	try 1 'holds several grids'                      /dev/null lhinterp -t 0 "$tmp/three.lh" "$tmp/lh"
	try 1 'stdin: holds several grids, need one'     "$tmp/three.lh" lhfft -K 1,2
	try 1 'stdin: holds several grids, need one'     "$tmp/three.lh" lhfft -K 1 --spectrum="$tmp/table"
	try 1 'stdin: holds several grids, need one'     <(cat "$tmp/lh" "$tmp/lh") lhfft -K 1 --spectrum="$tmp/table"
	try 1 'No such file or directory'                "$tmp/lh" lhfft -K 1 --spectrum="$tmp/nosuch/table"
	[ ! -e "$tmp/table" ]
	try 1 'holds several grids'                      "$tmp/three.phi" grid2mesh
	try 1 'holds several grids'                      "$tmp/three.phi" grid2mesh -o "$tmp/one.off"
	[ ! -e "$tmp/one.off" ]
}

@test "corners: by number, by point, by file, and what is wrong with them" {
	# the points are vertices 0 1 2 3 of the cap, which lie at -135, -45, 45 and 135 degrees
	points=$(awk 'NR > 2 && NR <= 6 { printf "%s%.4f,%.4f,%.4f", (NR > 3 ? ";" : ""), $1, $2, $3 }' "$tmp/cap.off")
	printf '0 1\n2,3\n' >"$tmp/corners"
	echo "$points" | tr ';,' '\n ' >"$tmp/points"
	try 0 '' "$tmp/cap.off" mesh2rect -n 8 -c 0,1,2,3
	grid2mesh "$tmp/out" >"$tmp/by-number"
	for c in "$tmp/corners" "$points" "$(echo "$points" | tr ';' '\n')" "$tmp/points" ./$(basename "$tmp/points"); do
		(cd "$tmp" && mesh2rect -n 8 --corners="$c" "$tmp/cap.off") | grid2mesh | cmp "$tmp/by-number"
	done
	try 0 '' "$tmp/cap.off" mesh2rect -n 8 -c auto
	try 1 'corner 199 is not a vertex of the boundary'  "$tmp/cap.off" mesh2rect -c 0,1,2,199
	try 1 'corner 200 is not a vertex of the boundary'  "$tmp/cap.off" mesh2rect -c 0,1,2,200
	try 1 'corner 1.5 is not the number of a vertex'    "$tmp/cap.off" mesh2rect -c 0,1,2,1.5
	try 1 'corner -1 is not the number of a vertex'     "$tmp/cap.off" mesh2rect -c 0,1,2,-1
	try 1 'corners 3,2,1,0 do not go round the boundary once'  "$tmp/cap.off" mesh2rect -c 3,2,1,0
	try 1 'corners 0,0,1,2 do not go round the boundary once'  "$tmp/cap.off" mesh2rect -c 0,0,1,2
	try 1 'corners .*, nearest to the points, do not go round' "$tmp/cap.off" mesh2rect -c '9,0,0;9,0,0;0,9,0;0,-9,0'
	for c in 0,1,2 0,1,2,3,4 '0,,1,2,3' '0,1,2,3;' '1,2,3;4,5,6;7,8,9' '1,2,3,4;5,6,7;8,9,10;11,12' \
	    '1,2,3,4,5,6,7,8,9,10,11,12' '1,2,3;4,5,6;7,8,9;1e999,0,0' '1,2,3;;4,5,6;7,8,9;1,2,3' 0,1,2-3,4; do
		try 2 'need four vertex numbers or four points' "$tmp/cap.off" mesh2rect -c "$c"
	done
	try 1 'nosuch: No such file'                        "$tmp/cap.off" mesh2rect -c "$tmp/nosuch"
	for c in '1 2 3 four' '1 2 3' '' '0x1 2 3 4'; do
		echo "$c" >"$tmp/corners"
		try 1 'not four vertex numbers'             "$tmp/cap.off" mesh2rect -c "$tmp/corners"
	done
	printf '1 2 3\n4 5 6 7\n8 9\n10 11 12\n' >"$tmp/corners"
	try 1 'not four points'                             "$tmp/cap.off" mesh2rect -c "$tmp/corners"
}

@test "a boundary of three vertices gets a fourth, which --uv does not write" {
	printf 'v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n' >"$tmp/one.obj"
	run --separate-stderr mesh2rect -n 8 --uv="$tmp/uv.obj" -o "$tmp/one.lhg" "$tmp/one.obj"
	[ "$status" -eq 0 ]
	[[ "$stderr" == *'the boundary has three vertices: the middle of its longest edge is added'* ]]
	[ "$(grep -a '^meta corners' "$tmp/one.lhg")" = 'meta corners 0,1,-1,2' ]
	[ "$(grep -c ^vt "$tmp/uv.obj")" -eq 3 ]
}

@test "vertex numbers of corners are those of the file, in options and in the metadata" {
	{ echo "v 9 9 9"; awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2 { print "v", $1, $2, $3 }
		NR > n + 2 && NR > 2 { print "f", $2 + 2, $3 + 2, $4 + 2 }' "$tmp/cap.off"; } >"$tmp/shifted.obj"
	mesh2rect -q -n 8 -c 1,2,3,4 "$tmp/shifted.obj" | lhinfo | grep -E 'corners +1,2,3,4'
	mesh2rect -q -n 8 -c 1,2,3,4 "$tmp/shifted.obj" | grid2mesh >"$tmp/a"
	mesh2rect -n 8 -c 0,1,2,3 "$tmp/cap.off" | grid2mesh | cmp "$tmp/a"
	try 1 'corner 0 is not a vertex of the boundary' "$tmp/shifted.obj" mesh2rect -q -c 0,1,2,3
}

@test "binary data does not go to a terminal" {
	command -v script >/dev/null || skip "no script(1)"
	script -qec "mesh2rect '$tmp/cap.off'" /dev/null >"$tmp/seen" && return 1
	grep -q 'stdout is a terminal' "$tmp/seen"
}

@test "-q suppresses notes, -v says more" {
	{ sed -n '1p' "$tmp/cap.off"; sed -n '2p' "$tmp/cap.off" | awk '{ print $1 + 1, $2, $3 }'
	  awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2' "$tmp/cap.off"; echo 9 9 9
	  awk 'NR == 2 { n = $1 } NR > n + 2' "$tmp/cap.off"; } >"$tmp/extra.off"
	try 0 '1 unreferenced vert' "$tmp/extra.off" mesh2rect -n 8
	try 0 ''                    "$tmp/extra.off" mesh2rect -q -n 8
	try 0 'certificate' "$tmp/cap.off" mesh2rect -v -n 8
	try 0 'Beltrami' "$tmp/phi" grid2lh -v
}

# setting NAME: prints the value of NAME that libgomp uses in a command.
setting() {
	OMP_DISPLAY_ENV=verbose lh2grid --version 2>&1 | sed -n "s/^ *$1 = '\(.*\)'/\1/p"
}

@test "waiting threads soon sleep, unless the environment says otherwise" {
	unset GOMP_SPINCOUNT
	[ "$(setting GOMP_SPINCOUNT)" = 3000 ]
	[ "$(OMP_WAIT_POLICY=active setting GOMP_SPINCOUNT)" != 3000 ]
	[ "$(GOMP_SPINCOUNT=7 setting GOMP_SPINCOUNT)" = 7 ]
	[ "$(env -i "$(command -v lhinfo)" --version)" = "$(lhinfo --version)" ]
}

@test "a command is not executed twice: environment, name and process stay" {
	unset GOMP_SPINCOUNT
	mkfifo "$tmp/hold"
	env -i A=1 HOME=/x USER=u PATH="$PATH" bash -c 'exec -a other lhinfo "$0"' "$tmp/hold" 2>"$tmp/err" &
	exec 9>"$tmp/hold"
	tr '\0' '\n' <"/proc/$!/environ" >"$tmp/environ"
	[ "$(tr '\0' ' ' <"/proc/$!/cmdline")" = "other $tmp/hold " ]
	exec 9>&-
	wait $! || true
	grep -qx A=1 "$tmp/environ"
	run ! grep -E 'GOMP|OPENBLAS|TUNABLES' "$tmp/environ"
}

@test "any number of threads works, also with too little memory for those of BLAS" {
	OMP_NUM_THREADS=100000 grid2lh "$tmp/phi" >"$tmp/many"
	OMP_NUM_THREADS=1 grid2lh "$tmp/phi" | cmp - "$tmp/many"
	OMP_NUM_THREADS=100000 lh2grid "$tmp/many" >/dev/null
	case $BUILD in */*) skip "sanitizers need more address space than a limit leaves" ;; esac
	(unset OPENBLAS_NUM_THREADS; ulimit -v 100000; timeout 60 lh2grid "$tmp/many") | lhinfo >/dev/null
	[ "${PIPESTATUS[0]}" = 0 ]
}

@test "mkmesh lists its kinds and takes parameters by name" {
	[ "$(mkmesh --list | grep -cx -e cap -e torus -e moebius)" = 3 ]
	try 2 'R: need NAME=VALUE'              /dev/null mkmesh -n 60 cap R
	try 2 'legs: no parameter of the kind cap' /dev/null mkmesh -n 60 cap legs=4
	try 2 'x.txt: need a name that ends in .off' /dev/null mkmesh -n 60 cap -o "$tmp/x.txt"
	[ ! -e "$tmp/x.txt" ]
}

@test "mesh2rect --max-vertices bounds the splitting" {
	mkmesh -n 300 cap -o "$tmp/cap.off"
	mesh2rect -q -n 8 --max-vertices=400 "$tmp/cap.off" -o "$tmp/few"
	[ "$(grep -a '^meta solved' "$tmp/few" | cut -d' ' -f3)" -le 500 ]
	[ "$(mesh2rect -q -n 8 "$tmp/cap.off" | grep -a '^meta solved' | cut -d' ' -f3)" -gt 1000 ]
}

@test "mesh2rect notes a --tolerance that is not reached, if it could be missed" {
	mkmesh -n 300 cap -o "$tmp/cap.off"
	try 0 'above --tolerance=0.001: a larger --max-vertices than 400' "$tmp/cap.off" mesh2rect -n 8 --max-vertices=400
	try 0 '' "$tmp/cap.off" mesh2rect -q -n 8 --max-vertices=400
	try 0 '' "$tmp/cap.off" mesh2rect -n 8 --tolerance=1
	try 0 '' "$tmp/cap.off" mesh2rect -n 8 --tolerance=0 --max-vertices=400
}

@test "lhinfo --json escapes quotes, backslashes and bytes that are not UTF-8 in metadata" {
	/usr/bin/python3 - "$tmp/lh.odd" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg, numpy as np
		g = lhg.Grid(5, 4, 1.0)
		g.channels['x'] = lhg.Channel(np.zeros((4, 5)), 'length')
		g.meta['said'] = 'a "b" c\\d \u00e9'
		lhg.write(sys.argv[1], [g])
	END
	lhinfo --json "$tmp/lh.odd" >"$tmp/json"
	/usr/bin/python3 - "$tmp/json" <<-'END'
		import json, sys
		grid, = map(json.loads, open(sys.argv[1], encoding='utf-8'))
		assert grid['meta']['said'] == 'a "b" c\\d \u00e9'
	END
}

@test "the history is text that a shell can run again: quotes, controls, dashes, the version" {
	local odd shell
	mkdir "$tmp/odd"
	cd "$tmp/odd"
	for odd in "it's.off" 'a b' '$HOME`x`\.off' $'new\nline\t\e.off' $'caf\xc3\xa9 \xff\x85\'\\' $'-%d\\c\e!\n\n' $'\n' \
	    '-n.off' '~' '#'; do
		cp "$tmp/cap.off" "./$odd"
		mesh2rect -q -n 8 -- "$odd" >first
		grep -a '^history ' first | cut -c 9- >step
		grep -q '  # lhgrid [0-9.]*$' step
		[ "$(wc -l <step)" = 1 ]
		for shell in bash dash; do
			$shell step | cmp first
		done
		[ "${odd:0:1}" != - ] || grep -q -- ' -- ' step
	done
	mesh2rect -q -n 8 "it's.off" | sed -n 's/^history //p' >step
	echo "mesh2rect --cells=8 'it'\\''s.off'  # lhgrid $(mesh2rect --version | cut -d' ' -f3)" | cmp - step
	# the text of a step that is too long is cut after a word
	lhinterp -q -t "0$(printf ',0.%0500d' $(seq 9))" "$tmp/lh" "$tmp/lh" | sed -n '/^history lhinterp/{p;q}' >step
	grep -q '^history lhinterp ...  # lhgrid [0-9.]*$' step
}

# A step that read its grid from a file has the file's name in its history, which the script leaves out.
same_but_history() {
	/usr/bin/python3 - "$@" <<-END
		import sys
		sys.path.insert(0, '$BATS_TEST_DIRNAME/../scripts')
		import lhg
		a, b = ([(g.T, g.frame, g.meta, {k: c.data.tobytes() for k, c in g.channels.items()}) for g in lhg.read(f)] for f in sys.argv[1:])
		assert a == b and len(a) > 0
	END
}

@test "lhinfo --history is a script that makes the stream again, from any folder of commands and merges" {
	mkdir "$tmp/made"
	cd "$tmp/made"
	cp "$tmp/cap.off" "a b's.off"
	mkmesh -n 200 cap angle=50 -o $'c\nd.off'
	mesh2rect -q -n 8 "a b's.off" -o a
	grid2lh -o a.lh a
	mesh2rect -q -n 8 --like=a $'c\nd.off' | grid2lh -o b.lh
	lhinterp -q -n 3 a.lh b.lh -o morph.lh
	lhinterp -q -t 0.25 --scale a.lh b.lh >merged.lh
	lhinterp -q -t 0.5 merged.lh a.lh >twice.lh
	lhfft -K 1 twice.lh | lh2grid -o twice
	cat a.lh twice >cat
	for file in a.lh morph.lh merged.lh twice cat; do
		lhinfo --history $file >script
		mkdir -p moved
		mv *.lh twice cat moved
		for shell in bash dash; do
			TMPDIR=$tmp/made/moved $shell script 2>/dev/null >again
			same_but_history again moved/$file
		done
		mv moved/* .
	done
	lhinfo --history a.lh >script
	[ "$(wc -l <script)" = 4 ]
	mesh2rect -q -n 8 <"a b's.off" | grid2lh >stdin.lh
	lhinfo --history stdin.lh >script
	sh script <"a b's.off" 2>/dev/null | cmp - stdin.lh     # no file of a grid, so even the history is the same
	grid2lh --no-history a >none
	try 1 'none: no history'                       /dev/null lhinfo --history none
	lhinterp -q -t 0 a.lh none >half
	try 1 'half: an input of a merge has no'       /dev/null lhinfo --history half
	lhinterp -q -t "0$(printf ',0.%0500d' $(seq 9))" a.lh b.lh >cut
	try 1 'cut: a step of the history is cut off'  /dev/null lhinfo --history cut
	cp a.lh mean
	for i in $(seq 150); do lhinterp -q -t 0.5 mean b.lh -o mean; done
	try 1 'mean: the oldest steps'                 /dev/null lhinfo --history mean
	try 2 'not with --json or --stats'             /dev/null lhinfo --history --json mean
}

@test "lhinfo --stats: quantiles and histogram of known numbers, as text and as JSON" {
	/usr/bin/python3 - "$tmp/known" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg, numpy as np
		g = lhg.Grid(101, 10, 1.0)
		x = np.random.default_rng(1).permutation(1010)
		g.channels['x'] = lhg.Channel(x.reshape(10, 101)*1.0, 'length')
		g.channels['same'] = lhg.Channel(np.full((10, 101), 3.0), '1')
		g.channels['far'] = lhg.Channel(np.where(x < 505, -1.7e308, 1.7e308).reshape(10, 101), '1')
		lhg.write(sys.argv[1], [g])
	END
	lhinfo --stats "$tmp/known" >"$tmp/text"
	grep -qx '    1 % 10  median 505  99 % 999' "$tmp/text"
	[ "$(grep -c ' below        0$' "$tmp/text")" = 2 ]
	grep -qx ' *below *10' "$tmp/text"
	grep -qx ' *above *10' "$tmp/text"
	grep -qx ' *3 .. *3 *1010 ########################################' "$tmp/text"
	lhinfo --json --stats "$tmp/known" >"$tmp/json"
	python3 - "$tmp/json" <<-'END'
		import json, sys
		x, same, far = json.load(open(sys.argv[1]))['channels']
		assert (x['p01'], x['median'], x['p99'], x['below'], x['above']) == (10, 505, 999, 10, 10)
		assert sum(x['histogram']) == 990 and max(x['histogram']) - min(x['histogram']) <= 1
		assert same['histogram'][0] == 1010 and sum(same['histogram']) == 1010
		assert far['histogram'][0] == 505 and far['histogram'][-1] == 505
	END
	lhinfo --json "$tmp/known" | run ! grep -q median
}

@test "--no-history leaves this step and the earlier ones out; nothing else changes" {
	for c in "grid2lh $tmp/phi" "lhfft -K 1 $tmp/lh" "lhfft -K 1,2 $tmp/lh" "lh2grid $tmp/lh" "lhinterp -q -n 2 $tmp/lh $tmp/lh" \
	    "mesh2rect -n 8 $tmp/cap.off"; do
		$c | lhinfo >"$tmp/with"
		$c --no-history | lhinfo >"$tmp/without"
		grep -q '^  history ' "$tmp/with"
		grep -v '^  history ' "$tmp/with" | cmp "$tmp/without"
	done
	for c in "grid2mesh $tmp/phi" "lh2png $tmp/phi" "lhinfo $tmp/phi" "lhdiff $tmp/phi $tmp/phi" "mkmesh -n 60 cap"; do
		cmp <($c) <($c --no-history)
	done
}

@test "a running mean of 150 steps keeps a history that fits; equal input gives equal bytes" {
	local i was
	cp "$tmp/lh" "$tmp/mean"
	for i in $(seq 2 150); do
		lhinterp -q -t 0.5 "$tmp/mean" "$tmp/lh" -o "$tmp/next"
		[ $i != 149 ] || cp "$tmp/mean" "$tmp/before"
		mv "$tmp/next" "$tmp/mean"
	done
	lhinterp -q -t 0.5 "$tmp/before" "$tmp/lh" >"$tmp/a"
	lhinterp -q -t 0.5 "$tmp/before" "$tmp/lh" | cmp "$tmp/a"
	lhinfo "$tmp/mean" | sed -n 's/^  history //p' >"$tmp/steps"
	[ "$(wc -c <"$tmp/steps")" -le 16384 ]
	[ "$(wc -c <"$tmp/steps")" -gt 14000 ]
	[ "$(grep -c 'earlier steps' "$tmp/steps")" = 1 ]
	# The first grid has 2 steps.  Each mean adds the 2 steps of the second grid and its own.  The
	# steps counted in the first line and the steps listed below it must add up to all of them.
	head -1 "$tmp/steps" | grep -qE '^# earlier steps: [0-9]+, CRC-32 [0-9a-f]{8}$'
	[ $(($(head -1 "$tmp/steps" | tr -dc '0-9 ,' | cut -d, -f1) + $(wc -l <"$tmp/steps") - 1)) = $((2 + 149*3)) ]
	tail -1 "$tmp/steps" | grep -q '^lhinterp --at=0.5 '
}
