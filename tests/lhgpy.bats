# lhgpy.bats - scripts/lhg.py, written from format/LHG.md, and the C code agree.

setup() {
	BUILD=${BUILD:-build}
	sample=$BUILD/tests/lhgsample
	lhg=scripts/lhg.py
	dir=$BATS_TEST_TMPDIR
	$sample >"$dir/c.lhg"
	export PYTHONPATH=scripts PYTHONDONTWRITEBYTECODE=1
	export OPENBLAS_NUM_THREADS=1   # numpy starts in half the time
}

# py CODE: runs CODE in Python, with io, sys, lhg and numpy as np; sys.argv[1] is the path of the
# sample that the C code wrote.
py() {
	/usr/bin/python3 -c "import io, sys, lhg, numpy as np
$1" "$dir/c.lhg"
}

# refused FILE MESSAGE: checks that lhg.py FILE exits with 1 and one line that contains MESSAGE.
refused() {
	run --separate-stderr $lhg "$1"
	[ "$status" -eq 1 ]
	[ "${#stderr_lines[@]}" -eq 1 ]
	[[ "$stderr" == "lhg.py: $1: "*"$2"* ]]
}

bats_require_minimum_version 1.5.0

@test "what C writes, Python reads" {
	py '
a, b = lhg.read(sys.argv[1])
for m, g in (1, a), (2, b):
    assert (g.nu, g.nv, g.T, g.frame, g.frames) == (5, 4, 0.1 + 0.2, m, 2)
    assert list(g.channels) == ["x", "band.H", "start.x"]
    assert g["x"].shape == (4, 5) and g["x"][1, 2] == (7*7 - 7)/8 + m
    for c, (name, ch) in enumerate(g.channels.items()):
        k = np.arange(ch.data.size)
        assert (ch.data.ravel() == (k*k - 7)/8 + 100*c + m).all()
        assert ch.data.size == g.mask(ch).sum()
    assert [(c.unit, c.support, c.step) for c in g.channels.values()] == [
        ("length", "grid", 0), ("1/length", "border", 1), ("length", "lattice", 2)]
    assert g.meta == {"unit": "mm", "title": "Fl\u00e4che  2"}
    assert g.history == ["mkmesh --n=20", "mesh2rect -"]
'
}

@test "what Python writes is byte for byte what C writes" {
	py '
def grid(m):
    g = lhg.Grid(5, 4, 0.1 + 0.2, m, 2)
    for c, (name, unit, support, step) in enumerate((("x", "length", "grid", 0),
            ("band.H", "1/length", "border", 1), ("start.x", "length", "lattice", 2))):
        k = np.arange(lhg.count(g, support, step))
        f = (k*k - 7)/8 + 100*c + m
        g.channels[name] = lhg.Channel(f.reshape(4, 5) if support == "grid" else f, unit, support, step)
    g.meta = {"unit": "mm", "title": "Fl\u00e4che  2"}
    g.history = ["mkmesh --n=20", "mesh2rect -"]
    return g
lhg.write(sys.argv[1] + ".py", (grid(1), grid(2)))
'
	cmp "$dir/c.lhg" "$dir/c.lhg.py"
	$sample check <"$dir/c.lhg.py"
}

@test "Python reads and writes several sets, byte for byte" {
	cat "$dir/c.lhg" "$dir/c.lhg" >"$dir/two"
	py '
out = io.BytesIO()
lhg.write(out, lhg.read(sys.argv[1].replace("c.lhg", "two")))
assert out.getvalue() == 2*open(sys.argv[1], "rb").read()
'
	run ! $sample check <"$dir/two"
}

@test "Python and C write heights with the same digits" {
	py '
g = next(lhg.read(sys.argv[1]))
g.frames = 1
for g.T in 1, 0.7, 1e-5, 0.1, 3e20:
    lhg.write("%s.%g" % (sys.argv[1], g.T), [g])
'
	for T in 1 0.7 1e-05 0.1 3e+20; do
		run ! $sample check <"$dir/c.lhg.$T"
		[[ "$output" == *"is not the sample's" ]]       # so the C reader accepted the height
	done
}

@test "Python refuses every truncation" {
	py '
s = open(sys.argv[1], "rb").read()
assert len(s) % 64 == 0 and list(lhg.read(io.BytesIO(s)))
for n in (n for k in range(0, len(s) + 1, 64) for n in (k-1, k, k+1) if 0 <= n < len(s)):
    try:
        list(lhg.read(io.BytesIO(s[:n])))
    except lhg.Error as e:
        assert str(e) and "\n" not in str(e)
    else:
        sys.exit("cut at %d passed" % n)
'
}

@test "Python refuses every changed byte" {
	py '
s = open(sys.argv[1], "rb").read()
for n in range(len(s)):
    for x in 1, 0x20, 0x80, 0xff:
        try:
            list(lhg.read(io.BytesIO(s[:n] + bytes([s[n] ^ x]) + s[n+1:])))
        except lhg.Error:
            continue
        sys.exit("byte %d ^ %d passed" % (n, x))
'
}

@test "Python refuses frames dropped, doubled or swapped, and other bytes after the end" {
	py '
s = open(sys.argv[1], "rb").read()
a, b = s[:len(s)//2], s[len(s)//2:]
for bad in (b, a, a + a, b + a, a + a + b, a + b + b, s + b, s + a, s + b"\n", s + b"lhg", s + b"lhg 1\n"):
    try:
        list(lhg.read(io.BytesIO(bad)))
    except lhg.Error:
        continue
    sys.exit("passed: %d bytes" % len(bad))
'
}

@test "Python refuses to write what is not allowed" {
	py '
def bad(change):
    g = next(lhg.read(sys.argv[1]))
    g.frames = 1
    change(g)
    try:
        lhg.write(io.BytesIO(), [g])
    except lhg.Error:
        return
    sys.exit("written")
bad(lambda g: g["x"].__setitem__((1, 1), np.nan))
bad(lambda g: setattr(g, "T", np.inf))
bad(lambda g: setattr(g, "nu", 1))
bad(lambda g: setattr(g, "frame", 2))
bad(lambda g: setattr(g, "frames", 2))
bad(lambda g: g.channels.clear())
bad(lambda g: g.meta.update({"a b": "c"}))
bad(lambda g: g.meta.update({"a": "c\nhistory d"}))
bad(lambda g: g.history.append(" x"))
bad(lambda g: g.history.append("x" * 4000))
bad(lambda g: g.history.extend(["x" * 3900] * 17))
bad(lambda g: setattr(g.channels["band.H"], "step", 5))
bad(lambda g: setattr(g.channels["band.H"], "unit", "a b"))
'
}

@test "the command prints a summary" {
	run $lhg "$dir/c.lhg"
	[ "$status" -eq 0 ]
	[ "${lines[0]}" = "size 5 4  height 0.30000000000000004  frame 1 of 2" ]
	[[ "$output" == *"band.H  1/length  border 1  14 samples"* ]]
	$lhg - <"$dir/c.lhg" >/dev/null
}

@test "to_npy: an array for each channel, stacked over the grids of a stream, complete or not at all" {
	PATH=$PWD/$BUILD/bin:$PATH
	mkmesh -n 200 cap | mesh2rect -q -n 9x8 | grid2lh -o "$dir/lh"
	lhinterp -q -n 3 "$dir/lh" "$dir/lh" -o "$dir/three"
	$lhg --npy="$dir/npy" "$dir/lh"
	/usr/bin/python3 -B -c '
import os, sys
sys.path.insert(0, "scripts")
import lhg, numpy as np
d = sys.argv[1] + "/"
g, = lhg.read(d + "lh")
assert sorted(os.listdir(d + "npy")) == sorted(n + ".npy" for n in g.channels)
for n in g.channels:
    assert np.array_equal(np.load(d + "npy/" + n + ".npy"), g[n])
paths = lhg.to_npy(d + "three", d + "npy")
assert paths[0] == d + "npy/lambda.npy"
a = np.load(paths[0])
assert a.shape == (3, 9, 10) and np.array_equal(a[1], list(lhg.read(d + "three"))[1]["lambda"])
lhg.to_npy(open(d + "lh", "rb"), d + "npy")
' "$dir"
	mesh2rect -q -n 9x8 <(mkmesh -n 200 cap) | cat "$dir/lh" - >"$dir/mixed"
	cp -r "$dir/npy" "$dir/before"
	run --separate-stderr $lhg --npy="$dir/npy" "$dir/mixed"
	[ "$status" = 1 ]
	[[ $stderr == *'frame 1 of 1 has other channels than the first grid' ]]
	head -c 900 "$dir/lh" >"$dir/cut"
	run -1 $lhg --npy="$dir/npy" "$dir/cut"
	diff -r "$dir/npy" "$dir/before"
}

@test "the command names what is wrong" {
	head -c 900 "$dir/c.lhg" >"$dir/cut"
	: >"$dir/empty"
	echo >>"$dir/c.lhg"
	refused "$dir/c.lhg" 'bytes follow the end mark'
	refused "$dir/cut" 'input ends in'
	refused "$dir/empty" 'empty input'
	refused $lhg 'not an lhg stream'
	refused "$dir/none" 'No such file'
}
