# lhread.bats - scripts/lhwrite.m; scripts/lhread.m and lhread.R read what scripts/lhg.py reads, to the last bit, and refuse
# what is damaged.  Each is tried where octave-cli or Rscript is there.

load helper

setup_file() {
	load helper
	cp tests/lhg/good/v1-smallest.lhg "$tmp/small"
	# the smallest stream cut at many places, and with one bit changed at many
	/usr/bin/python3 - "$tmp/small" "$tmp" <<-'END'
		import sys
		s = open(sys.argv[1], 'rb').read()
		for k in range(0, len(s), 3):
		    open('%s/cut-%d' % (sys.argv[2], k), 'wb').write(s[:k])
		    open('%s/bit-%d' % (sys.argv[2], k), 'wb').write(s[:k] + bytes([s[k] ^ 1 << k % 8]) + s[k+1:])
	END
	mkmesh -n 300 cap | mesh2rect -q -n 40 | grid2lh --residual -o "$tmp/larger"
}

octave() { octave-cli --norc --no-history "$@"; }
r()      { Rscript --vanilla "$@"; }

# agree END COMMAND: what COMMAND reads by scripts/lhread.END is what Python reads.
agree() {
	local f
	for f in tests/lhg/good/*.lhg "$tmp/larger"; do
		PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 tests/lhread/dump.py "$f" "$tmp/want"
		$2 "tests/lhread/dump.$1" "scripts/lhread.$1" "$f" "$tmp/got" 2>"$tmp/err"
		[ ! -s "$tmp/err" ] || { cat "$tmp/err"; false; }
		cmp "$tmp/want" "$tmp/got" || { echo "$f"; false; }
	done
}

# refuse END COMMAND FILE..: every FILE is refused, with one line each.
refuse() {
	local end=$1 command=$2
	shift 2
	$command "tests/lhread/verdicts.$end" "scripts/lhread.$end" "$@" >"$tmp/verdicts" 2>"$tmp/err"
	[ ! -s "$tmp/err" ] || { cat "$tmp/err"; false; }
	[ "$(wc -l <"$tmp/verdicts")" = $# ]
	[ "$(grep -c '^refused lhread: .' "$tmp/verdicts")" = $# ] ||
		{ paste <(printf '%s\n' "$@") "$tmp/verdicts" | grep -v 'refused lhread: '; false; }
}

@test "Octave reads what Python reads" {
	command -v octave-cli >/dev/null || skip "no octave-cli"
	agree m octave
}

@test "Octave refuses what is damaged" {
	command -v octave-cli >/dev/null || skip "no octave-cli"
	refuse m octave tests/lhg/bad/*.lhg "$tmp"/cut-* "$tmp"/bit-*
}

@test "Octave writes what it has read, byte by byte" {
	command -v octave-cli >/dev/null || skip "no octave-cli"
	mkdir "$tmp/copies"
	octave tests/lhread/copies.m scripts "$tmp/copies" tests/lhg/good/*.lhg "$tmp/larger" 2>"$tmp/err"
	[ ! -s "$tmp/err" ] || { cat "$tmp/err"; false; }
	for f in tests/lhg/good/*.lhg "$tmp/larger"; do
		cmp "$f" "$tmp/copies/${f##*/}"
	done
}

@test "lhwrite.m refuses what is no .lhg stream in one line, and leaves no file" {
	command -v octave-cli >/dev/null || skip "no octave-cli"
	mkdir "$tmp/refused"
	mkmesh -n 200 cap | mesh2rect -q -n 8 >"$tmp/phi"
	echo before >"$tmp/refused/to"
	octave tests/lhread/refusals.m scripts "$tmp/phi" "$tmp/refused/to" >"$tmp/said" 2>"$tmp/err"
	[ ! -s "$tmp/err" ] || { cat "$tmp/err"; false; }
	[ "$(grep -c ': lhwrite: .' "$tmp/said")" = 15 ] || { cat "$tmp/said"; false; }
	grep -qx 'defaults: 2 of 2, 0 meta' "$tmp/said"
	[ "$(wc -l <"$tmp/said")" = 16 ]
	[ "$(ls "$tmp/refused")" = to ]
	lhinfo "$tmp/refused/to" >/dev/null
}

@test "R reads what Python reads" {
	command -v Rscript >/dev/null || skip "no Rscript"
	agree R r
}

@test "R refuses what is damaged" {
	command -v Rscript >/dev/null || skip "no Rscript"
	refuse R r tests/lhg/bad/*.lhg "$tmp"/cut-* "$tmp"/bit-*
}
