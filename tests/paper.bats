# paper.bats - the report of scripts/paper is complete or absent.  For speed the tests use surfaces of
# mkmesh and small grids.

load helper

@test "paper writes its report and every picture that the report shows, and nothing else" {
	case $BUILD in */*) skip "the commands have their own tests under sanitizers" ;; esac
	local picture
	OMP_NUM_THREADS=1 LHGRID_MESHES=$tmp/none TMPDIR=$tmp/none scripts/paper "$tmp/paper" 32 6 100
	for picture in $(sed -n 's/^!\[.*\](\(.*\))$/\1/p' "$tmp/paper/report.md"); do
		[ "$(head -c 8 "$tmp/paper/$picture" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ]
		echo "$picture" >>"$tmp/pictures"
	done
	[ "$(grep -c ^figure "$tmp/pictures")" -ge 13 ]
	[ "$(ls "$tmp/paper" | grep -vFf "$tmp/pictures" | tr '\n' ' ')" = "report.md times.md work " ]
	# Four tables have six numbers in each row, and seven such rows: the scales K and six surfaces.
	# Ten promises are listed; those tested below hold also on these surfaces and small grids.
	[ "$(grep -cE '^\| [A-Za-z ()0-9]*( \| [0-9.e+-]+){6} \|$' "$tmp/paper/report.md")" = 28 ]
	[ "$(grep -cE '^- (holds|\*\*VIOLATED\*\*): ' "$tmp/paper/report.md")" = 10 ]
	[ "$(grep -c '^- holds: .*: t = 0 and t = 1 give the ends back' "$tmp/paper/report.md")" = 3 ]
	grep -q '^- holds: human face (man) to .*: the Hausdorff distance from the start rises' "$tmp/paper/report.md"
}

@test "paper stops at the first failure with one line and no report" {
	mkdir -p "$tmp/bare/good"
	code=0
	LHGRID_MESHES=$tmp/bare scripts/paper "$tmp/not" 32 6 100 >"$tmp/out" 2>"$tmp/err" || code=$?
	[ $code = 1 ]
	[ "$(wc -l <"$tmp/err")" = 1 ]
	grep -q '^paper: mesh2rect: .*face_man_scan_6k.off: No such file' "$tmp/err"
	[ ! -s "$tmp/out" ]
	[ ! -e "$tmp/not/report.md" ]
}
