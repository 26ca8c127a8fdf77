# Outputs: whole or not there, full disks, closed pipes, signals.

load helper

setup_file() {
	load helper
	mkmesh -n 200 cap -o "$tmp/cap.off"
	mesh2rect -n 16 "$tmp/cap.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
}

@test "-o FILE holds what stdout would" {
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
	lhinterp -n 3 "$tmp/lh" "$tmp/lh" >"$tmp/three"
	head -c $(($(wc -c <"$tmp/three") - 100)) "$tmp/three" >"$tmp/cut"
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

@test "-o where nothing can be written is an error of one line" {
	try 1 'No such file or directory' "$tmp/cap.off" mesh2rect -n 8 -o "$tmp/nodir/x"
	try 1 'Is a directory'            "$tmp/cap.off" mesh2rect -n 8 -o "$tmp"
	try 1 'No space left on device'   "$tmp/cap.off" mesh2rect -n 8 -o /dev/full
}

@test "a full disk behind stdout is an error of every command" {
	local c
	for c in "mesh2rect -n 8 $tmp/cap.off" "grid2lh $tmp/phi" "lhfft -K 1 $tmp/lh" "lh2grid $tmp/lh" \
	    "grid2mesh $tmp/phi" "lhinterp -t 0.5 $tmp/lh $tmp/lh" "lhinfo $tmp/lh" \
	    "lhdiff $tmp/phi $tmp/phi" "mkmesh -n 100 cap" "mkmesh --help" "lhfft --version"; do
		code=0
		$c >/dev/full 2>"$tmp/err" || code=$?
		[ $code = 1 ] || { echo "$c: exit $code"; return 1; }
		grep -q ': stdout: .*No space left on device' "$tmp/err" || { echo "$c"; return 1; }
	done
}

@test "a closed pipe ends a stage quietly" {
	run bash -c 'mesh2rect -n 256 '"$tmp/cap.off"' 2>'"$tmp/err"' | head -c 100 >/dev/null; echo ${PIPESTATUS[0]}'
	[ "$output" = 141 ]
	[ ! -s "$tmp/err" ]
}

@test "SIGTERM leaves no temporary file" {
	mkdir "$tmp/h"
	lhinterp -n 1000 "$tmp/lh" "$tmp/lh" | lh2grid -o "$tmp/h/x" &
	pid=$!
	for i in $(seq 100); do
		[ -n "$(ls -A "$tmp/h")" ] && break
		sleep 0.1
	done
	[ -n "$(ls -A "$tmp/h")" ]
	kill $pid
	wait $pid || true
	[ -z "$(ls -A "$tmp/h")" ]
}

@test "numbered files of a stream are whole, from 1" {
	lhinterp -n 3 "$tmp/lh" "$tmp/lh" | lh2grid | grid2mesh -o "$tmp/frame-%03d.ply"
	[ "$(echo "$tmp"/frame-*)" = "$tmp/frame-001.ply $tmp/frame-002.ply $tmp/frame-003.ply" ]
	mesh2rect -n 4 "$tmp/frame-002.ply" >/dev/null
}
