# Damaged streams: cut at every length, changed at every byte, for every stage.  A library
# test does all 255 changes of each byte; here each command is started for each place, so
# a sanitizer build, ten times slower to start, takes every 13th.

load helper

setup_file() {
	load helper
	mkmesh -n 60 cap | mesh2rect -n 4 -o "$tmp/phi"
	grid2lh --no-lattice "$tmp/phi" -o "$tmp/lh"
	lhinterp -n 2 "$tmp/lh" "$tmp/lh" -o "$tmp/two.lh"
	export ASAN_OPTIONS=detect_leaks=0
}

step() {
	case $BUILD in */*) echo 13 ;; *) echo 1 ;; esac
}

# refused INPUT COMMAND...: exit 1, one line, no output.
refused() {
	local input=$1 code=0
	shift
	"$@" <"$input" >"$tmp/out" 2>"$tmp/err" || code=$?
	[ $code = 1 ] && [ ! -s "$tmp/out" ] && [ "$(wc -l <"$tmp/err")" = 1 ]
}

cut_everywhere() {
	local input=$1 n
	shift
	for n in $(seq 0 "$(step)" $(($(wc -c <"$input") - 1))); do
		head -c "$n" "$input" >"$tmp/cut"
		refused "$tmp/cut" "$@" || { echo "$1: cut to $n bytes: accepted"; return 1; }
	done
}

# The byte at each place with its lowest bit turned.
change_everywhere() {
	local input=$1 n byte
	shift
	n=0
	for byte in $(od -An -v -tu1 "$input"); do
		if [ $((n%$(step))) = 0 ]; then
			cp "$input" "$tmp/changed"
			printf "\\$(printf %o $((byte ^ 1)))" | dd of="$tmp/changed" bs=1 seek=$n conv=notrunc status=none
			refused "$tmp/changed" "$@" || { echo "$1: byte $n changed: accepted"; return 1; }
		fi
		n=$((n + 1))
	done
}

@test "grid2lh"   { cut_everywhere "$tmp/phi" grid2lh;    change_everywhere "$tmp/phi" grid2lh; }
@test "grid2mesh" { cut_everywhere "$tmp/phi" grid2mesh;  change_everywhere "$tmp/phi" grid2mesh; }
@test "lhfft"     { cut_everywhere "$tmp/lh" lhfft -K 1;  change_everywhere "$tmp/lh" lhfft -K 1; }
@test "lh2grid"   { cut_everywhere "$tmp/lh" lh2grid;     change_everywhere "$tmp/lh" lh2grid; }
@test "lhinterp"  { cut_everywhere "$tmp/lh" lhinterp -t 0 - "$tmp/lh"; }
@test "lhinfo"    { cut_everywhere "$tmp/lh" lhinfo; }

@test "bytes after the end, a frame missing, doubled or alone" {
	local n=$(($(wc -c <"$tmp/two.lh")/2))
	head -c $n "$tmp/two.lh" >"$tmp/1"
	tail -c $n "$tmp/two.lh" >"$tmp/2"
	cat "$tmp/1" "$tmp/1" >"$tmp/doubled"
	cat "$tmp/2" "$tmp/1" >"$tmp/swapped"
	{ cat "$tmp/lh"; echo; } >"$tmp/extra"
	refused "$tmp/2" lhinfo
	refused "$tmp/swapped" lhinfo
	refused "$tmp/extra" lhinfo
	# frame 1 is good and may be on its way when the second fails
	lhfft -K 0 <"$tmp/1" >/dev/null 2>&1 && return 1
	lhfft -K 0 <"$tmp/doubled" >/dev/null 2>&1 && return 1
	lhfft -K 0 <"$tmp/two.lh" >/dev/null
}
