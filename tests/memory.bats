# memory.bats - a command that gets no memory exits with 1 and one line, and writes nothing to stdout.
# A problem too large for the machine is refused before the work begins.  A sample of the allocations
# fails, each in a run of its own; with SOAK=1 each of the first 2000 fails, and a sample of the rest.

load helper

setup_file() {
	load helper
	three_js
	export OMP_NUM_THREADS=1
	for e in off obj ply stl; do
		mkmesh -n 60 cap -o "$tmp/cap.$e"
	done
	gzip -k "$tmp/cap.ply"
	mesh2rect -n 8 --uv="$tmp/uv.ply" "$tmp/cap.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	grid2lh --residual "$tmp/phi" -o "$tmp/all"
	mkmesh -n 8 rectangle -o "$tmp/flat.off"
	export ASAN_OPTIONS=detect_leaks=0
}

# In a coverage build the counters allocate through the same functions, so they too would be refused.
setup() {
	case $BUILD in *coverage) skip "coverage counters cannot be refused memory" ;; esac
}

# short_of SHARE COMMAND...: refuses memory to COMMAND at one allocation after the other, as
# tests/faults.c describes; 12 is ENOMEM.
short_of() {
	timeout 600 "$BUILD/tests/faults" refused memory 12 "$1" "$BUILD/faulty/$2" "${@:3}" </dev/null
}

share=4

@test "mkmesh"    { short_of $share mkmesh -n 60 cap; short_of $share mkmesh --help; short_of $share mkmesh --list; }
@test "mesh2disk" {
	printf 'OFF\n9 8 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n2 1 0\n2 2 0\n1 2 0\n0 0 0\n' >"$tmp/ring.off"
	printf '3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 8 4\n3 3 4 7\n' >>"$tmp/ring.off"
	short_of $share mesh2disk -q "$tmp/ring.off"    # notes may come before the error
	short_of $share mesh2disk --check "$tmp/ring.off"
	printf 'OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n1 1 .1\n' >"$tmp/points.off"
	short_of 2 mesh2disk -q --points "$tmp/points.off"
	short_of $share mesh2disk -q --holes=all --open=auto "$tmp/ring.off"
}
@test "grid2lh"   { short_of $share grid2lh "$tmp/phi"; short_of $share grid2lh --residual "$tmp/phi"; }
@test "lhfft"     { short_of $share lhfft -K 1 "$tmp/lh"; short_of $share lhfft -K 1 --basis=dft --spectrum="$tmp/table" "$tmp/lh"; }
@test "lhwarp"    { short_of $share lhwarp -q --force "$tmp/phi" "$tmp/phi"; }
@test "lhinterp"  { short_of $share lhinterp -t 0.5 "$tmp/lh" "$tmp/lh"; short_of $share lhinterp --cap -w 1 "$tmp/lh" "$tmp/lh" "$tmp/lh"; }
@test "lhinfo"    { short_of $share lhinfo "$tmp/lh"; short_of $share lhinfo --json "$tmp/lh"; }
@test "lh2png"    { short_of $share lh2png "$tmp/lh"; short_of $share lh2png -c all "$tmp/lh"; }
@test "grid2html" {
	short_of $share grid2html --three="$tmp/three" --colours="$tmp/lh" --beside="$tmp/phi" --distance "$tmp/phi"
}
@test "grid2mesh" { short_of $share grid2mesh "$tmp/phi"; short_of $share grid2mesh --on="$tmp/uv.ply" "$tmp/phi"; }
@test "grid2mesh, glTF" { touch "$tmp/x.glb"; short_of $share grid2mesh --with=H "$tmp/lh" -o "$tmp/x.glb"; }

@test "lh2grid" {
	short_of $share lh2grid "$tmp/all"
	short_of $share lh2grid --no-start "$tmp/lh"
	short_of $share lh2grid --keyframes=2 "$tmp/lh"
	short_of $share lh2grid --method=frame "$tmp/lh"
}

@test "lhdiff" {
	short_of $share lhdiff "$tmp/phi" "$tmp/phi"
	short_of 2 lhdiff -q "$tmp/cap.stl" "$tmp/phi"
}

@test "mesh2rect" {
	for e in off obj ply ply.gz stl; do
		short_of 2 mesh2rect -q -n 8 --split=0 --tolerance=1 --polish=0 --surface=facets "$tmp/cap.$e"
	done
	touch "$tmp/x.obj"              # a new file takes one allocation more than an old one
	short_of $share mesh2rect -n 4 --polish=1 --uv="$tmp/x.obj" "$tmp/flat.off"
	short_of 2 mesh2rect -n 4 "$tmp/flat.off"
}

@test "too little memory is reported, with the amount needed, before the work begins" {
	try 1 'cap.off: no memory: the grid needs about [0-9]{12} bytes, there are [0-9]+$' /dev/null \
	    mesh2rect -n 32767 "$tmp/cap.off"
	case $BUILD in */*) skip "sanitizers want more address space than a limit leaves" ;; esac
	/usr/bin/python3 tests/hostile.py "$tmp/phi" "$tmp/large" 'g = size(600, 600, 3)'
	(ulimit -v 1500000 && try 1 'large: no memory: the frame method needs about 1958400000 bytes, there are 1536000000$' \
	    /dev/null lh2grid --method=frame "$tmp/large")
	/usr/bin/python3 tests/hostile.py "$tmp/lh" "$tmp/large" 'g = size(300, 300, 3)'
	(ulimit -v 1000000 && try 1 'large: no memory: the detail of key frames needs about 1468800000 bytes, there are 1024000000$' \
	    /dev/null lh2grid --keyframes=1000 "$tmp/large")
	/usr/bin/python3 tests/hostile.py "$tmp/lh" "$tmp/large" 'g = size(1400, 1400, 3)'
	(ulimit -v 840000 && try 1 'large: no memory: the surface method needs about 1003520000 bytes, there are 860160000$' \
	    /dev/null lh2grid --follow "$tmp/large")
	(ulimit -v 1500000 && try 1 'cap.off: no memory: the map needs about 5996544000 bytes, there are 1536000000$' \
	    /dev/null mesh2rect -n 4 --split=8 --max-vertices=100000000 "$tmp/cap.off")
	(ulimit -v 1500000 && try 0 '' /dev/null mesh2rect -n 8 "$tmp/cap.off")
	(ulimit -v 1500000 && try 0 'cap.off: the map may need up to 2500000000 bytes, there are 1536000000$' \
	    /dev/null mesh2rect -n 8 --max-vertices=1000000 "$tmp/cap.off")
}
