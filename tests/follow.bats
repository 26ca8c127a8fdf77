# follow.bats - morphs whose boundary turns: lh2grid --boundary=free --follow.

load helper

setup_file() {
	export tmp="$BATS_FILE_TMPDIR"
	mkmesh -n 1500 spiral turns=2 | mesh2rect -q -n 40x10 | grid2lh -o "$tmp/spiral"
	mkmesh -n 1500 moebius R=3 width=2.2 | mesh2rect -q -n 40x10 | grid2lh -o "$tmp/moebius"
	lhinterp -q --align --boundary=free -n 12 "$tmp/spiral" "$tmp/moebius" -o "$tmp/morph"
}

# crossing FILE: prints "N of M" if N of the M frames have crossing faces.
crossing() {
	lhdiff --no-hausdorff "$1" "$1" | awk -F '\t' '
		NR == 1 { for (i = 1; i <= NF; i++) if ($i == "self_intersections_a") c = i; next }
		{ frames++; n += $c > 0 } END { print n + 0, "of", frames }'
}

@test "a spiral unrolls into a Moebius part without a crossing, where its held boundary crosses" {
	lh2grid --boundary=free --follow --steps=2000 --tolerance=1e-4 "$tmp/morph" -o "$tmp/free"
	[ "$(crossing "$tmp/free")" = "0 of 12" ]
	lh2grid "$tmp/morph" -o "$tmp/held"
	[ "$(crossing "$tmp/held")" != "0 of 12" ]
}

@test "--follow changes nothing in a morph that stands still; without starts, later frames get one" {
	lhinterp -q -n 3 "$tmp/spiral" "$tmp/spiral" -o "$tmp/same"
	lh2grid "$tmp/same" -o "$tmp/a"
	lh2grid --follow "$tmp/same" -o "$tmp/b"
	lhdiff --no-hausdorff --no-self-intersections "$tmp/a" "$tmp/b" | awk -F '\t' '
		NR == 1 { for (i = 1; i <= NF; i++) if ($i == "max_rel") c = i; next }
		{ bad += !(NR == 2 ? $c == 0 : $c < 1e-4) } END { exit NR != 4 || bad }'
	mesh2rect -q -n 24 <(mkmesh -n 500 cap) | grid2lh --no-lattice -o "$tmp/bare"
	lhinterp -q -n 3 "$tmp/bare" "$tmp/bare" | lh2grid --follow -v -o "$tmp/c" 2>"$tmp/said"
	[ "$(grep -c 'vector Poisson' "$tmp/said")" = 3 ]
}

@test "a blend whose lambda follows its boundary is noted with a free one" {
	lhinterp -q -t 0.5 "$tmp/spiral" "$tmp/spiral" -o "$tmp/held"
	[ "$(lhinfo "$tmp/held" | grep -c 'meta boundary held')" = 1 ]
	try 0 'follows the length of the boundary: for a free one, lhinterp --boundary=free' /dev/null lh2grid --boundary=free "$tmp/held" -o "$tmp/a"
	lhinterp -q --boundary=free -t 0.5 "$tmp/spiral" "$tmp/spiral" | lh2grid --boundary=free 2>"$tmp/said" >/dev/null
	[ ! -s "$tmp/said" ]
	try 2 'boundary=loose: need held or free' /dev/null lhinterp --boundary=loose -t 0.5 "$tmp/spiral" "$tmp/spiral"
}

@test "options that --follow excludes are refused" {
	try 2 'follow and --no-start' "$tmp/spiral" lh2grid --follow --no-start
	try 2 'follow is for the surface method' "$tmp/spiral" lh2grid --follow --method=frame
}
