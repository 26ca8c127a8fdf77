# output.bats - output is complete or absent, also with full disks, closed pipes and signals.

load helper

setup_file() {
	load helper
	three_js
	mkmesh -n 200 cap -o "$tmp/cap.off"
	mesh2rect -n 16 "$tmp/cap.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
}

@test "-o FILE writes the same bytes as stdout" {
	mkdir "$tmp/d"
	cd "$tmp/d"
	mesh2rect -n 16 "$tmp/cap.off" >a
	mesh2rect -n 16 -o b "$tmp/cap.off"
	mesh2rect -n 16 -o - "$tmp/cap.off" >c
	cmp a b
	cmp a c
	[ "$(ls -A | wc -l)" = 3 ]
}

@test "a stage that fails leaves an old FILE as it was and no other file" {
	mkdir "$tmp/e"
	echo old >"$tmp/e/file.off"
	try 1 'no channel x' "$tmp/lh" grid2mesh -o "$tmp/e/file.off"
	head -c 2000 "$tmp/phi" >"$tmp/cut"
	try 1 'stdin: ' "$tmp/cut" grid2lh -o "$tmp/e/file.off"
	try 1 'No such file' /dev/null mesh2rect "$tmp/nosuch" -o "$tmp/e/file.off"
	[ "$(cat "$tmp/e/file.off")" = old ]
	[ "$(ls -A "$tmp/e")" = file.off ]
}

@test "a stream that breaks after its first frame leaves no FILE" {
	lhinterp -n 3 "$tmp/lh" "$tmp/lh" >"$tmp/frames"
	head -c $(($(wc -c <"$tmp/frames") - 100)) "$tmp/frames" >"$tmp/cut"
	mkdir "$tmp/f"
	try 1 'frame 3 of 3' "$tmp/cut" lh2grid -o "$tmp/f/x"
	[ -z "$(ls -A "$tmp/f")" ]
}

@test "-o through a symbolic link replaces the file, not the link" {
	mkdir "$tmp/g"
	echo old >"$tmp/g/real"
	ln -s real "$tmp/g/link"
	mesh2rect -n 8 "$tmp/cap.off" -o "$tmp/g/link"
	[ -L "$tmp/g/link" ]
	cmp "$tmp/g/real" <(mesh2rect -n 8 "$tmp/cap.off")
}

@test "-o through a dangling link, also a relative one of another folder, makes the file it names" {
	mkdir "$tmp/k" "$tmp/k/far"
	ln -s far/real "$tmp/k/link"
	ln -s ../k/link "$tmp/k/second"
	mkmesh -n 60 cap -o "$tmp/k/second.off"
	ln -s ../absent.off "$tmp/k/far/back.off"
	mkmesh -n 60 cap -o "$tmp/k/far/back.off"
	[ -L "$tmp/k/far/back.off" ]
	cmp "$tmp/k/absent.off" "$tmp/k/second.off"
	mesh2rect -n 8 "$tmp/cap.off" -o "$tmp/k/second"
	[ -L "$tmp/k/second" ]
	[ -L "$tmp/k/link" ]
	[ ! -L "$tmp/k/far/real" ]
	lhinfo "$tmp/k/far/real" >/dev/null
	ln -s loop "$tmp/k/loop"
	try 1 'Too many levels' /dev/null grid2lh "$tmp/phi" -o "$tmp/k/loop"
}

@test "a replaced file keeps its mode, owner and group; a new one follows umask" {
	local f
	mkdir "$tmp/m"
	cd "$tmp/m"
	lhinterp -n 2 "$tmp/lh" "$tmp/lh" | lh2grid -o "$tmp/pair.phi"
	for f in o uv.ply table frame-1.off; do
		echo old >$f
		chmod 600 $f
	done
	if [ "$(id -u)" = 0 ]; then
		chown 1234:2345 o
		chmod 2640 o
	fi
	umask 027
	mesh2rect -n 16 --uv=uv.ply "$tmp/cap.off" -o o
	lhfft -K 1 --spectrum=table "$tmp/lh" >/dev/null
	grid2mesh "$tmp/pair.phi" -o frame-%d.off
	mkmesh -n 60 cap -o fresh.off
	[ "$(stat -c %a uv.ply table frame-1.off frame-2.off fresh.off | xargs)" = '600 600 600 640 640' ]
	if [ "$(id -u)" = 0 ]; then
		[ "$(stat -c %a:%u:%g o)" = 640:1234:2345 ]
	else
		[ "$(stat -c %a o)" = 600 ]
	fi
}

@test "-o accepts the longest name that the file system accepts" {
	local n
	mkdir "$tmp/n"
	for n in 240 247 248 255; do
		mkmesh -n 60 cap -o "$tmp/n/$(printf "%0$((n - 4))d" 0).off"
	done
	[ "$(ls -A "$tmp/n" | wc -l)" = 4 ]
	try 1 'File name too long' /dev/null mkmesh -n 60 cap -o "$tmp/n/$(printf '%0252d' 0).off"
}

@test "-o to a place that cannot be written is an error of one line" {
	try 1 'No such file or directory' "$tmp/cap.off" mesh2rect -n 8 -o "$tmp/nodir/x"
	try 1 'Is a directory'            "$tmp/cap.off" mesh2rect -n 8 -o "$tmp"
	try 1 'No space left on device'   "$tmp/cap.off" mesh2rect -n 8 -o /dev/full
}

@test "a full disk behind stdout is an error of every command" {
	local c
	for c in "mesh2disk $tmp/cap.off" "mesh2rect -q -n 8 $tmp/cap.off" "grid2lh $tmp/phi" "lhfft -K 1 $tmp/lh" "lh2grid $tmp/lh" \
	    "grid2mesh $tmp/phi" "lhinterp -t 0.5 $tmp/lh $tmp/lh" "lhinfo $tmp/lh" \
	    "lhdiff $tmp/phi $tmp/phi" "lh2png $tmp/phi" "grid2html --three=$tmp/three $tmp/phi" "mkmesh -n 100 cap" "mkmesh --help" "lhfft --version"; do
		code=0
		$c >/dev/full 2>"$tmp/err" || code=$?
		[ $code = 1 ] || { echo "$c: exit $code"; return 1; }
		grep -q ': stdout: .*No space left on device' "$tmp/err" || { echo "$c"; return 1; }
	done
}

@test "a full small file system or a file size limit is an error, and leaves no file" {
	mkdir "$tmp/small"
	if mount -t tmpfs -o size=64k tmpfs "$tmp/small" 2>/dev/null; then
		echo old >"$tmp/small/x"
		code=0
		try 1 'small/x: .*No space left on device' /dev/null mesh2rect -n 128 "$tmp/cap.off" -o "$tmp/small/x" || code=1
		[ "$(cat "$tmp/small/x")$(ls -A "$tmp/small")" = oldx ] || code=1
		umount "$tmp/small"
		[ $code = 0 ]
	fi
	echo old >"$tmp/small/x"
	case $BUILD in *coverage) skip "coverage counters are too large for the limit" ;; esac
	(ulimit -f 64 && try 1 'small/x: .*File too large' /dev/null mesh2rect -n 128 "$tmp/cap.off" -o "$tmp/small/x")
	[ "$(cat "$tmp/small/x")" = old ]
	[ "$(ls -A "$tmp/small")" = x ]
	code=0
	(ulimit -f 64 && mesh2rect -n 128 "$tmp/cap.off" >"$tmp/cut" 2>"$tmp/err") || code=$?
	[ $code = 1 ]
	grep -q '^mesh2rect: stdout: .*File too large$' "$tmp/err"
	try 1 'stdin: ' "$tmp/cut" grid2lh
}

@test "stdout, stdin or stderr closed: one line or none, and no other file receives messages" {
	local c
	for c in "mesh2disk $tmp/cap.off" "mesh2rect -q -n 8 $tmp/cap.off" "grid2lh $tmp/phi" "lhfft -K 1 $tmp/lh" "lh2grid $tmp/lh" \
	    "grid2mesh $tmp/phi" "lhinterp -t 0.5 $tmp/lh $tmp/lh" "lhinfo $tmp/lh" \
	    "lhdiff $tmp/phi $tmp/phi" "lh2png $tmp/phi" "grid2html --three=$tmp/three $tmp/phi" "mkmesh -n 100 cap" "mkmesh --help" "lhfft --version"; do
		code=0
		$c >&- 2>"$tmp/err" || code=$?
		[ $code = 1 ] || { echo "$c: exit $code"; return 1; }
		[ "$(wc -l <"$tmp/err")" = 1 ]
		grep -q ': stdout: .*Bad file descriptor$' "$tmp/err" || { echo "$c"; return 1; }
	done
	for c in mesh2disk mesh2rect grid2lh 'lhfft -K 1' lh2grid grid2mesh lhinfo lh2png grid2html; do
		code=0
		$c <&- >"$tmp/out" 2>"$tmp/err" || code=$?
		[ $code = 1 ]
		grep -q ': stdin: .*Bad file descriptor$' "$tmp/err" || { echo "$c"; return 1; }
		[ ! -s "$tmp/out" ]
	done
	lhinterp -n 2 "$tmp/lh" "$tmp/lh" -o "$tmp/pair"
	lh2grid <"$tmp/pair" -o "$tmp/open"
	lh2grid -v <"$tmp/pair" -o "$tmp/closed" 2>&-
	cmp "$tmp/open" "$tmp/closed"
}

@test "a closed pipe ends a stage quietly, and with SIGPIPE ignored in one line" {
	local c
	for c in "mesh2rect -n 128 $tmp/cap.off" "mkmesh -n 20000 cap" "lhinterp -n 50 $tmp/lh $tmp/lh" \
	    "grid2mesh $tmp/large" "grid2lh $tmp/large" "lhinfo $(yes "$tmp/lh" | head -300 | tr '\n' ' ')"; do
		[ -e "$tmp/large" ] || mesh2rect -n 128 "$tmp/cap.off" -o "$tmp/large"
		run bash -c "$c 2>$tmp/err | head -c 100 >/dev/null; echo \${PIPESTATUS[0]}"
		[ "$output" = 141 ] || { echo "$c: $output"; return 1; }
		[ ! -s "$tmp/err" ]
		run bash -c "trap '' PIPE; { $c 2>$tmp/err; echo \$? >$tmp/code; } | head -c 100 >/dev/null"
		[ "$(cat "$tmp/code")" = 1 ] || { echo "$c: $(cat "$tmp/code")"; return 1; }
		[ "$(wc -l <"$tmp/err")" = 1 ]
		grep -q ': stdout: .*Broken pipe$' "$tmp/err"
	done
}

# faults VERDICT CALL ERROR COMMAND...: runs COMMAND again and again, each time with another call of
# CALL that fails, as tests/faults.c describes; VERDICT is refused or ignored.
faults() {
	local verdict=$1 call=$2 error=$3 command=$4
	shift 4
	ASAN_OPTIONS=detect_leaks=0 OMP_NUM_THREADS=1 \
		"$BUILD/tests/faults" "$verdict" "$call" "$error" 20 "$BUILD/faulty/$command" "$@"
}

@test "calls that are interrupted, would block or transfer one byte change no byte of the output" {
	local EINTR=4 EAGAIN=11 call n e
	grid2lh <"$tmp/phi" >"$tmp/same"
	for call in read write; do
		faults ignored $call $EINTR grid2lh <"$tmp/phi"
		faults ignored $call $EAGAIN grid2lh <"$tmp/phi"
		faults ignored $call $EINTR mesh2rect -n 4 <"$tmp/cap.off"
		for n in odd 1+; do
			for e in $([ $n = odd ] && echo $EINTR $EAGAIN) short; do
				FAULT="$call $n $e" "$BUILD/faulty/grid2lh" <"$tmp/phi" | cmp "$tmp/same"
				FAULT="$call $n $e" "$BUILD/faulty/mkmesh" -n 200 cap | cmp "$tmp/cap.off"
			done
		done
	done
	# a real non-blocking pipe with a slow reader
	/usr/bin/python3 - grid2lh "$tmp/phi" >"$tmp/out" <<-'END'
		import os, subprocess, sys, time
		r, w = os.pipe()
		os.set_blocking(w, False)
		p = subprocess.Popen(sys.argv[1:], stdout=w)
		os.close(w)
		while True:
		    b = os.read(r, 3000)
		    if not b:
		        break
		    time.sleep(0.001)
		    sys.stdout.buffer.write(b)
		sys.exit(p.wait())
	END
	grid2lh "$tmp/phi" | cmp "$tmp/out"
}

@test "every failing read, write, fsync, close, rename is an error, and leaves no file" {
	local EIO=5 ENOSPC=28 call
	mkdir "$tmp/i"
	faults refused read $EIO grid2lh <"$tmp/phi"
	faults refused read $EIO mesh2rect -n 4 <"$tmp/cap.off"
	faults refused read $EIO lhinfo "$tmp/lh"
	faults refused write $ENOSPC grid2lh <"$tmp/phi"
	faults refused write $ENOSPC mkmesh -n 200 cap
	for call in write fsync rename mkstemp fchmod; do
		echo old >"$tmp/i/x"
		for n in $(seq 1 8); do
			code=0
			FAULT="$call $n $EIO" "$BUILD/faulty/grid2lh" "$tmp/phi" -o "$tmp/i/x" 2>"$tmp/err" || code=$?
			[ $code = 0 ] && break
			[ $code = 1 ]
			[ "$(wc -l <"$tmp/err")" = 1 ]
			grep -q 'x: .*Input/output error' "$tmp/err"
			[ "$(cat "$tmp/i/x")" = old ]
			[ "$(ls -A "$tmp/i")" = x ]
		done
		[ "$n" -gt 1 ]                  # at least one run failed, and the last one succeeded
		cmp "$tmp/i/x" "$tmp/lh"
	done
	code=0
	FAULT="close 2 $EIO" "$BUILD/faulty/grid2lh" "$tmp/phi" -o "$tmp/i/y" 2>"$tmp/err" || code=$?
	[ $code = 1 ]
	grep -q 'y: .*Input/output error' "$tmp/err"
	[ ! -e "$tmp/i/y" ]
}

@test "a signal leaves no temporary file" {
	local sig
	lhinterp -n 1000 "$tmp/lh" "$tmp/lh" -o "$tmp/1000"
	mkdir "$tmp/h"
	for sig in INT TERM HUP QUIT; do
		env --default-signal=INT,QUIT lh2grid "$tmp/1000" -o "$tmp/h/x" &
		pid=$!
		for i in $(seq 100); do
			[ -n "$(ls -A "$tmp/h")" ] && break
			sleep 0.05
		done
		[ -n "$(ls -A "$tmp/h")" ]
		kill -$sig $pid
		code=0
		wait $pid || code=$?
		[ $code = $((128 + $(kill -l $sig))) ] || { echo "exit $code after $sig"; false; }
		[ -z "$(ls -A "$tmp/h")" ]
	done
	# the reader of stderr closes the pipe
	run bash -c "lh2grid -v $tmp/1000 -o $tmp/h/x 2>&1 | head -1 >/dev/null; echo \${PIPESTATUS[0]}"
	[ "$output" = 141 ]
	[ -z "$(ls -A "$tmp/h")" ]
}

@test "a signal that is ignored, as under nohup, stays ignored" {
	lhinterp -n 20 "$tmp/lh" "$tmp/lh" -o "$tmp/20"
	mkdir "$tmp/j"
	(trap '' HUP INT; exec lh2grid "$tmp/20" -o "$tmp/j/x") &
	pid=$!
	for i in $(seq 100); do
		[ -n "$(ls -A "$tmp/j")" ] && break
		sleep 0.01
	done
	kill -HUP $pid
	kill -INT $pid
	wait $pid
	[ "$(ls -A "$tmp/j")" = x ]
}

@test "numbered files of a stream are complete, and are numbered from 1" {
	lhinterp -n 3 "$tmp/lh" "$tmp/lh" | lh2grid | grid2mesh -o "$tmp/frame-%03d.ply"
	[ "$(echo "$tmp"/frame-*)" = "$tmp/frame-001.ply $tmp/frame-002.ply $tmp/frame-003.ply" ]
	mesh2rect -n 4 "$tmp/frame-002.ply" >/dev/null
}
