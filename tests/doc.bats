# doc.bats - everything that the pages and comments cite exists (scripts/citations).

load helper

@test "every file, function, section and equation that is cited exists" {
	run -0 scripts/citations
	[ -z "$output" ]
}

# Each false citation below is written in two parts, because scripts/citations reads this file too.
@test "a citation of something that does not exist is found" {
	local copy=$tmp/copy page=doc/mathematics d=DESI
	mkdir "$copy"
	cp -r lib cmd format tests scripts doc examples ./*.md "$copy"
	cd "$copy"
	echo "see \`lib/grid/""none.c\` and \`lib/grid/lambdah.c: ""none\`" >>$page.md
	echo "see [there](mathematics.md#""none)" >>$page.md
	echo "/* $page.md 6.""99 */" >>lib/surface/misfit.h
	printf '/* %s.md 6.2,\n * 7.%s */\n' "$page" 98 >>lib/surface/fit.h
	echo "/* ${d}GN section 2 */" >>lib/base/chart.h
	echo "/* ../shared/STY""LE.md */" >>cmd/lhfft.c
	sed -i 's/(27)//' lib/grid/*.[ch] lib/base/*.[ch]
	sed -i '/^| (32) |/d' README.md
	run -1 scripts/citations
	for what in "cites lib/grid/none.c" "function none of lib/grid/lambdah.c" "links to #none" \
	    "misfit.h: cites section 6.99" "fit.h: cites section 7.98" "chart.h: cites ${d}GN" \
	    "lhfft.c: cites ../shared/STY""LE.md" "for equation (27)" "README.md: has no row for equation (32)"; do
		grep -qF -- "$what" <<<"$output" || { echo "not found: $what"; false; }
	done
}

@test "the equations of doc/mathematics.md hold; the printed (10) and (15) are off by 2 and 4" {
	run -0 /usr/bin/python3 tests/identities.py
	[ "$(grep -c 'printed (10) over K: 0.500000' <<<"$output")" = 4 ]
	grep -q 'torus: printed (15) over Delta mu: 0.250000' <<<"$output"
	[ "${#lines[@]}" = 5 ]
	sed 's/- 2\*lam\*inner/- lam*inner/' tests/identities.py >"$tmp/identities.py"
	run -1 /usr/bin/python3 "$tmp/identities.py"
	grep -q 'torus: Codazzi (15) is off' <<<"$output"
}

# bash's set -e does not see the failure of a command behind "!"; "run !" does.
@test "no line of a .bats file is a check with ! that cannot fail" {
	run grep -nE '^[[:space:]]+! [^|]*($|\|[^|])' tests/*.bats
	[ -z "$output" ]
}
