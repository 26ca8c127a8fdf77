# pipes.bats - if a stage of a pipeline fails, is killed or is cut off anywhere, the last stage fails
# too, even without pipefail, and no output looks complete.

load helper

setup_file() {
	load helper
	export ASAN_OPTIONS=detect_leaks=0 OMP_NUM_THREADS=1
	mkmesh -n 100 cap -o "$tmp/cap.off"
	mesh2rect -n 8 "$tmp/cap.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	lhinterp -n 2 "$tmp/lh" "$tmp/lh" -o "$tmp/two"
}

stages=('mesh2rect -n 8 cap.off' grid2lh 'lhfft -K 1' lh2grid grid2mesh)

# broken PIPELINE: checks that PIPELINE exits with 1, writes a reason to stderr and nothing to stdout.
broken() {
	local code=0
	(cd "$tmp" && sh -c "$1" >out 2>err) || code=$?
	[ $code = 1 ] || { echo "$1: exit $code"; cat "$tmp/err"; return 1; }
	[ ! -s "$tmp/out" ] || { echo "$1: output"; return 1; }
	[ -s "$tmp/err" ] || { echo "$1: no word"; return 1; }
}

# joined FROM TO: prints the stages FROM to TO, joined by pipes.
joined() {
	local i text=
	for i in $(seq "$1" "$2"); do
		text="$text${text:+ | }${stages[$i]}"
	done
	echo "$text"
}

@test "a stage that is cut off after any number of bytes" {
	local i n size
	for i in 0 1 2 3; do
		(cd "$tmp" && sh -c "$(joined 0 $i)" >part)
		size=$(wc -c <"$tmp/part")
		for n in 0 1 64 $((size/2)) $((size - 64)) $((size - 1)); do
			broken "head -c $n part | $(joined $((i + 1)) 4)"
		done
		broken "{ cat part; echo; } | $(joined $((i + 1)) 4)"
	done
}

@test "a stage that is killed at any of its writes" {
	# the stage is killed at its n-th write
	local i n
	for i in 0 1 2 3; do
		for n in 1 2 3 5; do
			(cd "$tmp" && FAULT="write $n kill" sh -c "$OLDPWD/$BUILD/faulty/${stages[$i]}" <"$tmp/$(input $i)" >part 2>err) && break
			broken "cat part | $(joined $((i + 1)) 4)"
		done
		[ "$n" -gt 1 ]
	done
}

# input I: prints the file that stage I reads.
input() {
	local of=(cap.off phi lh lh phi)
	echo "${of[$1]}"
}

@test "a stage that fails before, between and after the frames of a stream" {
	local c size n
	size=$(wc -c <"$tmp/two")
	for c in 'lhfft -K 1' 'lh2grid | grid2lh' 'lhfft -K 0 | lh2grid | grid2lh | lhinfo'; do
		for n in 100 $((size/2 - 1)) $((size/2)) $((size/2 + 1)) $((size - 1)); do
			code=0
			(cd "$tmp" && sh -c "head -c $n two | $c >out 2>err") || code=$?
			[ $code = 1 ] || { echo "$c, $n: exit $code"; return 1; }
			lhinfo "$tmp/out" >/dev/null 2>&1 && { echo "$c, $n: complete"; return 1; }
		done
	done
	# where grid2mesh writes a file for each frame, the files that exist are complete
	mkdir "$tmp/frames"
	head -c $((size - 1)) "$tmp/two" | lh2grid 2>/dev/null | grid2mesh -o "$tmp/frames/%d.off" 2>/dev/null && return 1
	[ "$(ls -A "$tmp/frames")" = 1.off ]
	lh2grid "$tmp/two" | grid2mesh -o "$tmp/whole-%d.off"
	cmp "$tmp/whole-1.off" "$tmp/frames/1.off"
}

@test "a stage that does not exist, fails at once or is killed at once" {
	local i text k
	for k in 'false' 'nosuchcommand' 'sh -c "kill -9 \$\$"' 'sh -c "cat >/dev/null; kill -9 \$\$"' 'lhfft'; do
		for i in 0 1 2 3; do
			text=$k
			[ $i = 0 ] || text="$(joined 0 $((i - 1))) | $k"
			broken "$text | $(joined $((i + 1)) 4)"
		done
	done
	broken "mesh2rect nosuch | $(joined 1 4)"
	broken "mesh2rect -n 8 cap.off | $(joined 2 4)"
}

@test "a stream of two sets makes all later stages fail if the second is damaged or cut, or its stage is killed" {
	local size=$(wc -c <"$tmp/phi") i n
	mesh2rect -n 8 "$tmp/cap.off" | cat "$tmp/phi" - >"$tmp/sets"
	grid2lh "$tmp/sets" | lhfft -K 1 | lh2grid --keyframes=2 | lhinfo >/dev/null
	grid2lh --no-history "$tmp/sets" | cmp - <(grid2lh --no-history "$tmp/phi"; mesh2rect -n 8 "$tmp/cap.off" | grid2lh --no-history)
	{ cat "$tmp/phi"; head -c 1000 "$tmp/phi"; echo damaged; tail -c +1009 "$tmp/phi"; } >"$tmp/sets.bad"
	for n in 6 7 1000 $((size - 1)); do
		head -c $((size + n)) "$tmp/sets" >"$tmp/cut"
		broken 'grid2lh cut | lhfft -K 1 | lh2grid | lhinfo'
	done
	broken 'grid2lh sets.bad | lhfft -K 1 | lh2grid | lhinfo'
	broken 'grid2lh sets.bad | lhfft -K 1 | lh2grid --keyframes=2 | lhinfo'
	# a stage that is killed after its first set
	lhfft -K 1 < <(cat "$tmp/lh"; head -c 6 "$tmp/lh"; sleep 3) >"$tmp/killed" &
	for i in $(seq 50); do
		[ -s "$tmp/killed" ] && break
		sleep 0.05
	done
	kill -9 $!
	wait $! || true
	[ -s "$tmp/killed" ]
	broken 'lhinfo killed'
}
