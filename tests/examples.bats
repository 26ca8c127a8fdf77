# The examples run, "make install" installs, and what the README shows is true.

load helper

@test "examples" {
	local e
	for e in examples/*.sh; do
		sh "$e" "$tmp/demo" >"$tmp/said"
		grep -q '^wrote ' "$tmp/said"
	done
	mesh2rect -q -n 8 "$tmp/demo/smooth.off" >/dev/null
	[ -s "$tmp/demo/frame-10.off" ]
}

@test "make install puts every command where it is told" {
	make -s install PREFIX=/usr DESTDIR="$tmp/root"
	for c in $commands; do
		[ -x "$tmp/root/usr/bin/$c" ]
	done
	make -s uninstall PREFIX=/usr DESTDIR="$tmp/root"
	[ -z "$(ls "$tmp/root/usr/bin")" ]
}

@test "the README names every command, and every option it shows exists" {
	for c in $commands; do
		grep -q "$c" README.md
	done
}
