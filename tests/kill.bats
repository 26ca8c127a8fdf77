# kill.bats - commands are killed at random moments: the FILE of -o is then absent, old or complete.
# This is tried 20 times, with SOAK set 200 times.

load helper

setup_file() {
	load helper
	mkmesh -n 200 cap -o "$tmp/cap.off"
	mesh2rect -n 40 "$tmp/cap.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	lhinterp -n 300 "$tmp/lh" "$tmp/lh" -o "$tmp/whole"
}

# at_random COMMAND...: kills COMMAND by -9 after a random time of up to 1.2 times $took, its run time
# in seconds.
at_random() {
	local pid
	"$@" 2>/dev/null &
	pid=$!
	sleep "$(awk -v r=$RANDOM -v t="$took" 'BEGIN { print 1.2*t*r/32768 }')"
	kill -9 $pid 2>/dev/null || true
	wait $pid 2>/dev/null || true
}

seconds() {
	local began=$EPOCHREALTIME
	"$@" >/dev/null
	awk -v a="$began" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }'
}

@test "kill -9 during -o FILE: FILE is absent or complete, an old FILE is kept" {
	local i=0 there=0 times=${SOAK:+200}
	took=$(seconds lhinterp -n 300 "$tmp/lh" "$tmp/lh" -o "$tmp/x")
	for i in $(seq "${times:-20}"); do
		rm -f "$tmp/x"
		[ $((i%2)) = 0 ] || echo old >"$tmp/x"
		at_random lhinterp -n 300 "$tmp/lh" "$tmp/lh" -o "$tmp/x"
		if [ $((i%2)) = 0 ] && [ ! -e "$tmp/x" ]; then
			continue
		elif [ $((i%2)) = 1 ] && [ "$(head -c 4 "$tmp/x")" = old ]; then
			continue
		fi
		cmp "$tmp/whole" "$tmp/x"
		there=$((there + 1))
	done
	echo "# killed $i times, $there times after the end" >&3
}

@test "two writers of one FILE do not mix" {
	local i pid
	for i in 1 2 3; do
		lhinterp -n 300 "$tmp/lh" "$tmp/lh" -o "$tmp/two" &
		pid=$!
		lhinterp -n 200 "$tmp/lh" "$tmp/lh" -o "$tmp/two"
		wait $pid
		lhinfo "$tmp/two" >/dev/null
	done
}
