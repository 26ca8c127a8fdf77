load helper

setup_file() {
	mkmesh -n 900 face | mesh2rect -q -n 24 -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	grid2lh --no-place "$tmp/phi" -o "$tmp/bare"
}

# compare A B SCALE: all channels of B are those of A times the power of SCALE of their unit.
compare() {
	/usr/bin/python3 - "$@" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg
		import numpy as np
		s = float(sys.argv[3])
		power = {'1': 0, 'length': 1, '1/length': -1}
		for a, b in zip(lhg.read(sys.argv[1]), lhg.read(sys.argv[2]), strict=True):
		    assert list(a.channels) == list(b.channels), (a.channels, b.channels)
		    for n, c in a.channels.items():
		        x = c.data*s**power[c.unit]
		        assert np.allclose(x, b[n], rtol=0, atol=1e-9*abs(x).max()), n
	END
}

meta() { lhinfo "$1" | awk -v k="$2" '$1 == "meta" && $2 == k { print $3 }'; }

@test "a length in the unit of the mesh, or in percent of the square root of the area" {
	lhfft --scale=7% "$tmp/lh" -o "$tmp/percent"
	L=$(meta "$tmp/percent" scale)
	area=$(meta "$tmp/phi" area)
	below "$(awk -v l="$L" -v a="$area" 'BEGIN { r = l/sqrt(a)/.07; print (r > 1 ? r : 1/r) }')" 1.02
	lhfft --scale=0.5 "$tmp/lh" -o "$tmp/length"
	[ "$(meta "$tmp/length" scale)" = 0.5 ]
	# log lambda is filtered at s = .005 of sqrt(area), whatever TAU: L = 2 pi s
	lhfft --relief=2% "$tmp/lh" -o "$tmp/relief"
	below "$(awk -v l="$(meta "$tmp/relief" scale)" -v a="$area" 'BEGIN { r = l/sqrt(a)/.0314159; print (r > 1 ? r : 1/r) }')" 1.02
}

@test "a surface 8 times as large, at a scale 8 times as large, is filtered alike" {
	/usr/bin/python3 - "$tmp/lh" "$tmp/large" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg
		power = {'1': 0, 'length': 1, '1/length': -1}
		g = next(iter(lhg.read(sys.argv[1])))
		for c in g.channels.values():
		    c.data = c.data*8.0**power[c.unit]
		lhg.write(sys.argv[2], [g])
	END
	for o in scale=0.25,0.5:scale=2,4 relief=0.01:relief=0.08 scale=3%:scale=3% relief=1%:relief=1%; do
		lhfft "--${o%:*}" "$tmp/lh" -o "$tmp/1"
		lhfft "--${o#*:}" "$tmp/large" -o "$tmp/8"
		compare "$tmp/1" "$tmp/8" 8
	done
}

@test "several scales are those of several runs" {
	lhfft --scale=0.3,5% "$tmp/lh" -o "$tmp/two"
	for o in 0.3 5%; do lhfft --scale=$o "$tmp/lh" -o "$tmp/$o"; done
	/usr/bin/python3 - "$tmp/two" "$tmp/0.3" "$tmp/5%" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg
		import numpy as np
		two = list(lhg.read(sys.argv[1]))
		for a, f in zip(two, sys.argv[2:], strict=True):
		    b = next(iter(lhg.read(f)))
		    assert all(np.array_equal(a[n], b[n]) for n in a.channels)
		    assert a.meta == b.meta, (a.meta, b.meta)
	END
}

@test "the border of lambda and of the place stays; a scale of nothing changes nothing" {
	lhfft --scale=20% "$tmp/lh" -o "$tmp/coarse"
	lhfft --scale=0.05% "$tmp/lh" -o "$tmp/fine"
	/usr/bin/python3 - "$tmp/lh" "$tmp/coarse" "$tmp/fine" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg
		import numpy as np
		g, coarse, fine = (next(iter(lhg.read(f))) for f in sys.argv[1:])
		size = np.ptp(g['place.x'])
		for n in 'lambda', 'place.x', 'place.y', 'place.z':
		    for side in np.s_[0, :], np.s_[-1, :], np.s_[:, 0], np.s_[:, -1]:
		        assert np.allclose(g[n][side], coarse[n][side], rtol=1e-14, atol=0), n
		for n in 'lambda', 'H', 'place.x', 'place.y', 'place.z':
		    scale = abs(g[n]).max()
		    assert abs(g[n] - fine[n]).max() < 1e-4*scale, n
		    assert abs(g[n] - coarse[n]).max() > 1e-3*scale, n
	END
}

# In polar coordinates (r,t) of the unit square, the surface is the plane region of all points (r,3t).  Its
# corner is reentrant, 270 degrees, and the harmonic function with the same border values is (x,-y) there:
# turned over.  That is what a strong filter alone would leave; on the finer grid it turns over cells far beyond the
# block that is kept at first.
@test "no filter turns the cells at a reentrant corner over" {
	for n in 32 128; do
		mkmesh -n 900 rectangle a=1 b=1 | mesh2rect -q --corners=0,1,2,3 -n $n -o "$tmp/square"
		/usr/bin/python3 - "$tmp/square" "$tmp/bent" <<-'END'
			import sys
			sys.path.insert(0, 'scripts')
			import lhg
			import numpy as np
			g = next(iter(lhg.read(sys.argv[1])))
			r, t = np.hypot(g['x'], g['y']), np.arctan2(g['y'], g['x'])
			g.channels['x'].data, g.channels['y'].data = r*np.cos(3*t), r*np.sin(3*t)
			lhg.write(sys.argv[2], [g])
		END
		grid2lh "$tmp/bent" -o "$tmp/bentlh"
		for o in scale=20% scale=40% scale=80% relief=5%; do
			lhfft "--$o" "$tmp/bentlh" -o "$tmp/filtered"
			/usr/bin/python3 - "$tmp/bentlh" "$tmp/filtered" <<-'END'
				import sys
				sys.path.insert(0, 'scripts')
				import lhg
				import numpy as np
				before, after = (next(iter(lhg.read(f))) for f in sys.argv[1:])
				x, y = after['place.x'], after['place.y']
				across = lambda f: (f[1:, 1:] - f[:-1, :-1], f[1:, :-1] - f[:-1, 1:])
				(a, b), (c, d) = across(x), across(y)
				assert (a*d - b*c > 0).all(), np.argwhere(a*d - b*c <= 0)
				for n in 'lambda', 'place.x', 'place.y':
				    size = abs(before[n]).max()
				    assert abs(after[n] - before[n])[:2, :2].max() < 1e-9*size, n
				assert abs(after['place.x'] - before['place.x']).max() > 1e-3*abs(before['place.x']).max()
			END
		done
	done
}

@test "the place belongs to --scale and --relief: other filters and morphs leave it out" {
	lhfft --scale=4% "$tmp/lh" -o "$tmp/s"
	lhinfo "$tmp/s" | grep -q 'channel place.x'
	lhfft -K 0 "$tmp/s" | lhinfo | grep -q 'meta scale'
	for c in "lhfft -K 1 $tmp/s" "lhfft -K 0,1 $tmp/s" "lhinterp -q -n 2 $tmp/s $tmp/s"; do
		$c | lhinfo >"$tmp/out"
		[ "$(grep -Ec 'channel place|meta (scale|relief)' "$tmp/out")" = 0 ]
	done
	[ -z "$(lhinfo "$tmp/bare" | grep 'channel place')" ]
}

@test "without the place: a note, lambda and H as with it; --relief needs it" {
	try 0 'no channels place.x' "$tmp/bare" lhfft --scale=4%
	cp "$tmp/out" "$tmp/without"
	lhfft --scale=4% "$tmp/lh" | lhfft -K 0 | /usr/bin/python3 -c '
import sys
sys.path.insert(0, "scripts")
import lhg
g = next(iter(lhg.read(sys.stdin.buffer)))
for c in "xyz":
    del g.channels["place." + c]
lhg.write(sys.stdout.buffer, [g])' >"$tmp/with"
	compare "$tmp/with" "$tmp/without" 1
	try 1 'no channel place.x: run grid2lh first' "$tmp/bare" lhfft --relief=1%
}

@test "--paper is four options" {
	lhfft --no-history -K 30 --paper "$tmp/lh" -o "$tmp/paper"
	lhfft -q --no-history -K 30 --raw --basis=dft --no-log-lambda --no-bending "$tmp/lh" | cmp - "$tmp/paper"
}

@test "lengths out of range" {
	for o in scale=0 scale=-1 scale=% scale=3mm relief=nan; do
		try 2 'need a number in' /dev/null lhfft "--$o"
	done
	try 2 'need exactly' /dev/null lhfft --scale=2 --relief=1
	try 2 'need exactly' /dev/null lhfft --scale=2 -K 1
	try 2 'need exactly' /dev/null lhfft --scale=2 --K-H=1
	try 2 'are for filters that drop coefficients' /dev/null lhfft --scale=2 --basis=dft
	try 1 'stdin: --scale is 1e\+06, need 0.0001 .. 10000 times the square root' "$tmp/lh" lhfft --scale=1e6
	try 1 'stdin: --relief is .*, need 0.0001' "$tmp/lh" lhfft --relief=1e-9%
}

@test "lh2grid keeps to the place that --scale has filtered, and to no other" {
	lhfft --no-history --scale=12% "$tmp/lh" -o "$tmp/s"
	lh2grid "$tmp/s" -o "$tmp/held"
	lh2grid --no-place "$tmp/s" -o "$tmp/loose"
	[ -z "$(lhinfo "$tmp/held" | grep 'channel place')" ]
	below "$(error_of "$tmp/phi" "$tmp/held" mean_rel)" "$(error_of "$tmp/phi" "$tmp/loose" mean_rel)"
	lh2grid -q "$tmp/lh" -o "$tmp/1"
	lh2grid "$tmp/bare" -o "$tmp/2"
	[ "$(error_of "$tmp/1" "$tmp/2" max)" = 0 ]
	try 1 "the metadatum scale is 'x', not a positive number" <(/usr/bin/python3 -c '
import sys
sys.path.insert(0, "scripts")
import lhg
g = next(iter(lhg.read(sys.argv[1])))
g.meta["scale"] = "x"
lhg.write(sys.stdout.buffer, [g])' "$tmp/s") lh2grid
}

# move FROM TO HOW: FROM as it is seen from elsewhere, or with its nodes in another order; HOW done twice
# gives FROM back.
move() {
	/usr/bin/python3 - "$@" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg
		import numpy as np
		g = next(iter(lhg.read(sys.argv[1])))
		how = sys.argv[3]
		tall = how == 'transposed'
		out = lhg.Grid(*((g.nv, g.nu, 1/g.T) if tall else (g.nu, g.nv, g.T)))
		turn = {'x': ('y', 1), 'y': ('x', 1), 'z': ('z', -1)} if how == 'turned' else {c: (c, 1) for c in 'xyz'}
		for c in 'xyz':
		    f = g[turn[c][0]]*turn[c][1]
		    f = f[:, ::-1] if how == 'mirrored' else f.T if tall else f
		    out.channels[c] = lhg.Channel(np.ascontiguousarray(f), 'length')
		lhg.write(sys.argv[2], [out])
	END
}

@test "a surface turned, mirrored or transposed is filtered alike" {
	mkmesh -n 900 tooth | mesh2rect -q -n 24x20 -o "$tmp/tooth"
	move "$tmp/tooth" "$tmp/as.is" none
	for o in --scale=12% --relief=1%; do
		grid2lh -q "$tmp/as.is" | lhfft -q $o | lh2grid -q -o "$tmp/want"
		below 1e-3 "$(error_of "$tmp/tooth" "$tmp/want" max_rel)"
		for how in turned mirrored transposed; do
			move "$tmp/tooth" "$tmp/$how" $how
			grid2lh -q "$tmp/$how" | lhfft -q $o | lh2grid -q -o "$tmp/got"
			move "$tmp/got" "$tmp/back" $how
			below "$(error_of "$tmp/want" "$tmp/back" max_rel)" 1e-5
		done
	done
}
