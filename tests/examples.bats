# examples.bats - the examples, "make install" and the make rules of the README work.

load helper

@test "examples" {
	local e
	for e in examples/*.sh; do
		sh "$e" "$tmp/demo" >"$tmp/said"
		grep -q '^wrote ' "$tmp/said"
	done
	mesh2rect -q -n 8 "$tmp/demo/smooth.ply" >/dev/null
	mkmesh -q -n 500 tooth -o "$tmp/tooth.off"
	sh examples/smooth.sh "$tmp/own" "$tmp/tooth.off"
	[ "$(awk '/^element vertex/ { print $3; exit }' "$tmp/own/smooth.ply")" = "$(awk 'NR == 2 { print $1 }' "$tmp/tooth.off")" ]
	[ -s "$tmp/demo/frame-10.off" ]
}

@test "make install puts every command where it is told to" {
	make -s install PREFIX=/usr DESTDIR="$tmp/root"
	for c in $commands; do
		[ -x "$tmp/root/usr/bin/$c" ]
	done
	make -s uninstall PREFIX=/usr DESTDIR="$tmp/root"
	[ -z "$(ls "$tmp/root/usr/bin")" ]
}

@test "the make rules of the README smooth a folder of meshes, and redo only what changed" {
	mkdir -p "$tmp/folder/scans"
	sed -n '/^    MESHES :=/,/^Without/s/^    //p' README.md >"$tmp/folder/Makefile"
	for kind in cap torus; do
		mkmesh -n 500 $kind -o "$tmp/folder/scans/$kind.ply"
	done
	make -s -C "$tmp/folder" -j2
	mesh2rect -n 8 "$tmp/folder/smooth/torus.ply" >/dev/null
	touch "$tmp/folder/scans/cap.ply"
	make -C "$tmp/folder" >"$tmp/said"
	run ! grep -q torus "$tmp/said"
	grep -q 'cap' "$tmp/said"
}

@test "the README names every command" {
	for c in $commands; do
		grep -q "$c" README.md
	done
}
