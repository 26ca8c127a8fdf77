# keyframes.bats - lh2grid --keyframes: frames between two key frames start from the detail of
# both.

load helper

setup_file() {
	export tmp="$BATS_FILE_TMPDIR"
	mkmesh -n 4000 face | mesh2rect -q -n 80 | grid2lh -o "$tmp/a"
	lhfft -q -K 0.3 "$tmp/a" -o "$tmp/b"
	lhinterp -q -n 8 "$tmp/a" "$tmp/b" -o "$tmp/morph"
	lh2grid -v "$tmp/morph" -o "$tmp/alone" 2>"$tmp/alone.said"
	lh2grid -v --keyframes=3 "$tmp/morph" -o "$tmp/keys" 2>"$tmp/keys.said"
}

# solves FILE: prints the number of Poisson solves of all frames, as lh2grid -v reported them in FILE.
solves() {
	awk '/vector Poisson/ { for (i = 2; i <= NF; i++) if ($i == "vector") s += $(i-1) } END { print s }' "$1"
}

# apart NAME: prints column NAME of lhdiff alone keys, one line for each frame.
apart() {
	lhdiff --no-hausdorff --no-self-intersections "$tmp/alone" "$tmp/keys" | awk -F '\t' -v n="$1" '
		NR == 1 { for (i = 1; i <= NF; i++) if ($i == n) c = i; next } { print $c }'
}

@test "all frames are in order, key frames the same as alone, the others near, for fewer solves" {
	[ "$(lhinfo "$tmp/keys" | grep -o 'frame [0-9]* of 8' | tr '\n' ' ')" = "$(seq -f 'frame %g of 8' 1 8 | tr '\n' ' ')" ]
	apart max_rel | awk '{ bad += (NR%3 == 1 || NR == 8) ? $1 != 0 : $1 == 0 || $1 > 0.01 } END { exit NR != 8 || bad }'
	apart mean_rel | awk '$1 > 1e-3 { bad = 1 } END { exit bad }'
	below "$(solves "$tmp/keys.said")" "$(awk "BEGIN { print 0.7*$(solves "$tmp/alone.said") }")"
}

@test "one frame, a stream that ends before its second key, and frames of two sizes" {
	lh2grid -k 4 "$tmp/a" | lh2grid_bytes >"$tmp/one"
	lh2grid "$tmp/a" | lh2grid_bytes | cmp - "$tmp/one"
	mesh2rect -q -n 24 <(mkmesh -n 500 cap) | grid2lh -o "$tmp/cap"
	mesh2rect -q -n 20 <(mkmesh -n 500 cap) | grid2lh -o "$tmp/other"
	cat "$tmp/cap" "$tmp/other" "$tmp/cap" | lh2grid -k 2 | lh2grid_bytes >"$tmp/mixed"
	cat "$tmp/cap" "$tmp/other" "$tmp/cap" | lh2grid | lh2grid_bytes | cmp - "$tmp/mixed"
}

# Prints the bytes of the samples of x, y and z of a stream, without its headers.
lh2grid_bytes() {
	/usr/bin/python3 -c 'import sys; sys.path.insert(0, "scripts"); import lhg
for g in lhg.read(sys.stdin.buffer):
    for c in "xyz": sys.stdout.buffer.write(g[c].tobytes())'
}

@test "if a frame fails there is one line, and a stream that the next stage refuses" {
	lhfft -q -K 2 "$tmp/a" -o "$tmp/k"
	lhinterp -q -n 4 "$tmp/a" "$tmp/k" >"$tmp/hard"
	try 1 'no convergence in 1 steps' "$tmp/hard" lh2grid -k 2 --steps=1
	head -c 100000 "$tmp/morph" >"$tmp/cut"
	try 1 'stdin: .* ends' "$tmp/cut" lh2grid -k 3
}

@test "values and options that --keyframes excludes are refused" {
	try 2 'keyframes' "$tmp/a" lh2grid --keyframes=1
	try 2 'keyframes' "$tmp/a" lh2grid --keyframes=many
	try 2 'keyframes and --follow exclude' "$tmp/a" lh2grid -k 3 --follow
	try 2 'keyframes and --boundary=free exclude' "$tmp/a" lh2grid -k 3 --boundary=free
	try 2 'keyframes is for the surface method' "$tmp/a" lh2grid -k 3 --method=frame
}
