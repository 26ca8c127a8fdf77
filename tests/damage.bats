# damage.bats - every command refuses streams that are cut at any length or changed at any byte.
# One command is started for each cut or change, so only one bit of each byte is changed here;
# tests/test_lhg.c makes all 255 changes of each byte.  Under sanitizers, where a command starts ten
# times slower, only every 13th byte is tried.

load helper

setup_file() {
	load helper
	three_js
	mkmesh -n 60 cap -o "$tmp/cap.ply"
	mesh2rect -n 4 "$tmp/cap.ply" -o "$tmp/phi"
	grid2lh --no-lattice "$tmp/phi" -o "$tmp/lh"
	lhinterp -n 2 "$tmp/lh" "$tmp/lh" -o "$tmp/two.lh"
	export ASAN_OPTIONS=detect_leaks=0
}

damage() {
	local step=1
	case $BUILD in */*) step=13 ;; esac
	"$BUILD/tests/damage" "$1" $step "${@:2}"
}

@test "grid2lh"   { damage cut "$tmp/phi" grid2lh;    damage change "$tmp/phi" grid2lh; }
@test "grid2mesh" { damage cut "$tmp/phi" grid2mesh;  damage change "$tmp/phi" grid2mesh; }
@test "lhfft"     { damage cut "$tmp/lh" lhfft -K 1;  damage change "$tmp/lh" lhfft -K 1; }
@test "lh2grid"   { damage cut "$tmp/lh" lh2grid;     damage change "$tmp/lh" lh2grid; }
@test "lhwarp"    { damage cut "$tmp/phi" lhwarp --force "$tmp/phi" -; }
@test "lhinterp"  { damage cut "$tmp/lh" lhinterp -t 0 - "$tmp/lh"; }
@test "lh2png"    { damage cut "$tmp/lh" lh2png --bare --size=1; damage change "$tmp/lh" lh2png --bare --size=1; }
@test "grid2html" {
	damage cut "$tmp/phi" grid2html --three="$tmp/three"
	damage change "$tmp/phi" grid2html --three="$tmp/three"
}
@test "lhinfo"    { damage cut "$tmp/lh" lhinfo;      damage change "$tmp/lh" lhinfo; }
@test "lhdiff"    { damage cut "$tmp/phi" lhdiff "$tmp/phi" -; damage change "$tmp/phi" lhdiff "$tmp/phi" -; }
@test "mesh2rect" { damage cut "$tmp/cap.ply" mesh2rect -n 4; }

@test "bytes after the end, a frame missing, doubled or alone" {
	local n=$(($(wc -c <"$tmp/two.lh")/2))
	head -c $n "$tmp/two.lh" >"$tmp/1"
	tail -c $n "$tmp/two.lh" >"$tmp/2"
	cat "$tmp/1" "$tmp/1" >"$tmp/doubled"
	cat "$tmp/2" "$tmp/1" >"$tmp/swapped"
	{ cat "$tmp/lh"; echo; } >"$tmp/extra"
	try 1 '.' "$tmp/2" lhinfo
	try 1 '.' "$tmp/swapped" lhinfo
	try 1 '.' "$tmp/extra" lhinfo
	# frame 1 is good, so lhfft may already have written it when frame 2 is refused
	lhfft -K 0 <"$tmp/1" >/dev/null 2>&1 && return 1
	lhfft -K 0 <"$tmp/doubled" >/dev/null 2>&1 && return 1
	lhfft -K 0 <"$tmp/two.lh" >/dev/null
}
