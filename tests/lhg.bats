# lhg.bats - the commands and scripts/lhg.py read the sample files of tests/lhg.  The unit test
# test_lhgcorpus reads them by the library.

load helper

setup() {
	export PYTHONPATH=scripts PYTHONDONTWRITEBYTECODE=1
}

@test "every bad sample is refused with exit 1 and the line that names its defect" {
	local name why f code err n=0
	export ASAN_OPTIONS=detect_leaks=0      # a command that dies by exit() does not free its memory
	while IFS=$'\t' read -r name why; do
		f=tests/lhg/bad/$name.lhg code=0
		lhinfo "$f" >"$tmp/out" 2>"$tmp/err" || code=$?
		mapfile -t err <"$tmp/err"
		[ $code = 1 ] && [ ! -s "$tmp/out" ] && [ ${#err[@]} = 1 ] &&
			[ "${err%: of a mesh, run*}" = "lhinfo: $f: $why" ] || complain "$name: exit $code"
		n=$((n + 1))
	done < <("$BUILD/tests/test_lhgcorpus" list)
	[ $n = "$(ls tests/lhg/bad | wc -l)" ]
}

@test "every good sample is read, and samples that commands wrote go on through the pipeline" {
	local f
	for f in tests/lhg/good/*.lhg; do
		lhinfo "$f" >"$tmp/out"
		[ -s "$tmp/out" ]
	done
	grid2lh tests/lhg/good/v1-mesh2rect.lhg | lhfft -K 1 >/dev/null
	lh2grid tests/lhg/good/v1-grid2lh.lhg | grid2mesh >/dev/null
	lhinterp -t 0.5 tests/lhg/good/v1-grid2lh.lhg tests/lhg/good/v1-lhfft.lhg >/dev/null
	lh2grid tests/lhg/good/v1-lhinterp.lhg | grid2mesh -o "$tmp/%d.off"
	grid2mesh tests/lhg/good/v1-lh2grid.lhg -o "$tmp/%d.off"
}

@test "Python reads the good samples, writes the same bytes, and refuses the bad ones" {
	/usr/bin/python3 -c '
import glob, io, lhg, sys
for name in glob.glob("tests/lhg/good/*.lhg"):
    out = io.BytesIO()
    lhg.write(out, lhg.read(name))
    if out.getvalue() != open(name, "rb").read():
        sys.exit(name + ": not the same bytes")
for name in glob.glob("tests/lhg/bad/*.lhg"):
    try:
        list(lhg.read(name))
    except lhg.Error as e:
        assert str(e) and "\n" not in str(e), name
    else:
        sys.exit(name + ": read")
'
}
