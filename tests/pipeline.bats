# pipeline.bats - the pipeline gives surfaces back, morphs reach their ends, filters do what lhfft
# --help says, and a change of the unit of length changes only the unit.

load helper

setup_file() {
	load helper
	for kind in cap torus enneper face; do
		mkmesh -n 3000 $kind -o "$tmp/$kind.off"
	done
	mesh2rect -n 64 "$tmp/cap.off" -o "$tmp/cap.phi"
	grid2lh "$tmp/cap.phi" -o "$tmp/cap.lh"
	mesh2rect -n 64 "$tmp/torus.off" -o "$tmp/torus.phi"
	grid2lh "$tmp/torus.phi" -o "$tmp/torus.lh"
}

@test "K = 0 gives every synthetic surface back" {
	# Max and mean distance over sqrt(area).  The last four surfaces turn much within a cell of
	# so coarse a grid, so their bounds are larger; with -n 256 their error is several times
	# smaller.
	while read -r kind max mean; do
		mkmesh -n 10000 "$kind" | mesh2rect -n 64 -o "$tmp/phi"
		grid2lh "$tmp/phi" | lhfft -K 0 | lh2grid -o "$tmp/psi"
		below "$(error_of "$tmp/phi" "$tmp/psi" max_rel)" "$max"
		below "$(error_of "$tmp/phi" "$tmp/psi" mean_rel)" "$mean"
	done <<-END
		cap      0.0005 0.0002
		mercator 0.0002 0.00005
		cylinder 0.0002 0.0001
		catenoid 0.0003 0.0002
		torus    0.0002 0.00005
		enneper  0.0005 0.0002
		moebius  0.0002 0.00005
		spiral   0.03   0.001
		face     0.01   0.0005
		tooth    0.01   0.0005
		cortex   0.03   0.005
	END
}

@test "the map finds the modulus of surfaces whose modulus is known" {
	local T
	# the modulus of the rectangle is b/a; tests/test_rectmap.c checks the other surfaces
	mkmesh -n 2000 rectangle a=1 b=0.7 | mesh2rect -n 8 -c 0,1,2,3 -o "$tmp/r"
	T=$(sed -n 's/^height //p;/^end/q' "$tmp/r")
	below "$(awk -v t="$T" 'BEGIN { d = t - 0.7; print d < 0 ? -d : d }')" 1e-9
}

@test "corners on a smooth boundary do not spoil H" {
	local file
	for file in "$tmp/cap.off" "$tmp/face.off"; do
		mesh2rect -n 128 "$file" | grid2lh -o "$tmp/lh"
		/usr/bin/python3 - "$tmp/lh" <<-'END'
			import sys
			sys.path.insert(0, 'scripts')
			import lhg
			H = next(iter(lhg.read(sys.argv[1])))['H']
			assert abs(H).max() < 20*(H[8:-8, 8:-8]**2).mean()**0.5, abs(H).max()
		END
	done
}

# A blend has no place to start from, the ends have.
@test "t = 0 and t = 1 are the ends of a morph, to the last bit" {
	lhinterp -t 0 "$tmp/cap.lh" "$tmp/torus.lh" >"$tmp/zero"
	lhinterp -t 1 "$tmp/cap.lh" "$tmp/torus.lh" >"$tmp/one"
	cmp <(lh2grid "$tmp/zero" | grid2mesh) <(lh2grid --no-place "$tmp/cap.lh" | grid2mesh)
	cmp <(lh2grid "$tmp/one" | grid2mesh) <(lh2grid --no-place "$tmp/torus.lh" | grid2mesh)
}

@test "a morph goes from one end to the other" {
	lhinterp -n 5 "$tmp/cap.lh" "$tmp/torus.lh" | lh2grid | grid2mesh -o "$tmp/m%d.off"
	local last=-1 i d
	for i in 1 2 3 4 5; do
		d=$(error_of "$tmp/m1.off" "$tmp/m$i.off" mean_rel)
		below "$last" "$d"
		last=$d
	done
}

# same A B [CHANNEL..]: succeeds if the channels [lambda H] of the last grids of A and B are equal to
# the last bit.
same() {
	/usr/bin/python3 - "$@" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg
		a, b = (list(lhg.read(f))[-1] for f in sys.argv[1:3])
		sys.exit(any(a[c].tobytes() != b[c].tobytes() for c in sys.argv[3:] or ('lambda', 'H')))
	END
}

@test "lhfft: K = 0 is the identity; options that name the defaults change nothing" {
	local o
	for o in '' --basis=dft --no-log-lambda '--basis=dft --no-log-lambda' --no-bending --raw; do
		lhfft -K 0 $o "$tmp/torus.lh" -o "$tmp/k"
		same "$tmp/k" "$tmp/torus.lh"
	done
	# If all dropped coefficients are 0, no bit changes, although lhfft filters lambda H and divides
	# by lambda: in floating point (3*0.1)/3 is not 0.1.
	/usr/bin/python3 -c 'import sys; sys.path.insert(0, "scripts"); import lhg, numpy as np
g = lhg.Grid(9, 7, 1.0)
for c, x in ("lambda", 3.0), ("H", 0.1): g.channels[c] = lhg.Channel(np.full((7, 9), x))
lhg.write(sys.argv[1], [g])' "$tmp/even"
	same "$tmp/even" <(lhfft -K 0 "$tmp/even")
	same "$tmp/torus.lh" <(lhfft --energy=1 "$tmp/torus.lh")
	same "$tmp/torus.lh" <(lhfft --low-pass=1000 "$tmp/torus.lh")
	lhfft -K 1 "$tmp/torus.lh" -o "$tmp/k"
	lhfft -K 1 --no-log-lambda --log-lambda --no-bending --bending --basis=dct "$tmp/torus.lh" -o "$tmp/named"
	same "$tmp/k" "$tmp/named"
	for o in --basis=dft --no-log-lambda --no-bending --raw; do
		lhfft -K 1 $o "$tmp/torus.lh" -o "$tmp/not"
		! same "$tmp/k" "$tmp/not" || { echo "$o does nothing"; return 1; }
	done
}

@test "lhfft: bounds for either field" {
	lhfft -K 2 --no-bending "$tmp/torus.lh" -o "$tmp/two"
	lhfft -K 1 --K-H 2 --no-bending "$tmp/torus.lh" -o "$tmp/apart"
	same "$tmp/apart" "$tmp/two" H
	same "$tmp/apart" <(lhfft -K 1 "$tmp/torus.lh") lambda
	lhfft --K-lambda 2 "$tmp/torus.lh" -o "$tmp/apart"
	same "$tmp/apart" "$tmp/two" lambda
	same "$tmp/apart" "$tmp/torus.lh" H
	run ! same "$tmp/apart" "$tmp/torus.lh" lambda
}

@test "lhfft filters lambda H and divides the result by lambda" {
	lhfft --low-pass=0 "$tmp/torus.lh" -o "$tmp/mean"
	/usr/bin/python3 - "$tmp/torus.lh" "$tmp/mean" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg, numpy as np
		a, b = (list(lhg.read(f))[-1] for f in sys.argv[1:3])
		bend = b['lambda']*b['H']
		assert np.ptp(bend) < 1e-9
		factor = b['lambda']/a['lambda']        # log lambda keeps its border, up to the mean of the rest
		assert np.ptp(np.concatenate([factor[0], factor[-1], factor[:, 0], factor[:, -1]])) < 1e-9
		assert np.ptp(factor) > 1e-3
		assert abs(bend.mean() - (a['lambda']*a['H']).mean()) < 1e-9
		assert abs(bend.mean() - b['lambda'].mean()*a['H'].mean()) > 1e-3
	END
}

@test "lhfft: several scales are the frames of one stream" {
	local i=1 K
	lhfft -K 0.5,2,0 "$tmp/torus.lh" -o "$tmp/scales"
	head -c $(($(wc -c <"$tmp/scales")/3)) "$tmp/scales" | sed '/^end/q' >"$tmp/head"
	grep -q '^frame 1 3 ' "$tmp/head"
	grep -q '^meta bound 0.5$' "$tmp/head"
	[ "$(grep -ac '^history lhfft --bound=0.5,2,0' "$tmp/scales")" = 3 ]
	for K in 0.5 2 0; do
		/usr/bin/python3 - "$tmp/scales" $i "$tmp/frame" <<-'END'
			import sys
			sys.path.insert(0, 'scripts')
			import lhg
			g = list(lhg.read(sys.argv[1]))[int(sys.argv[2]) - 1]
			g.frame = g.frames = 1
			lhg.write(open(sys.argv[3], 'wb'), [g])
		END
		same "$tmp/frame" <(lhfft -K $K "$tmp/torus.lh")
		i=$((i + 1))
	done
	lh2grid "$tmp/scales" | grid2mesh -o "$tmp/scale%d.off"
	[ -s "$tmp/scale3.off" ]
}

@test "lhfft: --spectrum writes the table that -K and --low-pass select from" {
	local o line H
	lhfft -K 1 "$tmp/torus.lh" -o "$tmp/plain"
	for o in --basis=dct --basis=dft --no-log-lambda --no-bending; do
		lhfft -v -K 1 $o --spectrum="$tmp/table" "$tmp/torus.lh" 2>"$tmp/err" >"$tmp/out"
		H='lambda H'
		[ $o != --no-bending ] || H=H
		head -n 1 "$tmp/table" | grep -q "	$H\$"
		for line in 4 5; do             # of lambda, and of H or lambda H, in percent
			set -- "$([ $line = 4 ] && echo lambda || echo "$H")" $line
			awk -F'\t' -v c=$2 -v dft=$([ $o = --basis=dft ] && echo 1) \
				'NR > 1 && ($1 + $2 == 0 && $1 == 0 || $c > 1) { n += dft && $1 > 0 ? 2 : 1 } END { print n }' \
				"$tmp/table" >"$tmp/count"
			grep -q " $(cat "$tmp/count") of 4225 coefficients of $1 kept" "$tmp/err"
		done
		awk -F'\t' '!($1 ~ /^[0-9]+$/) && NR > 1 || NF != 5 { exit 1 }' "$tmp/table"
		[ $o = --no-log-lambda ] || lhfft -v --low-pass=4 $o "$tmp/torus.lh" 2>&1 >/dev/null |
			grep -q " $(awk -F'\t' -v dft=$([ $o = --basis=dft ] && echo 1) \
				'NR > 1 && $3 <= 4 { n += dft && $1 > 0 ? 2 : 1 } END { print n }' "$tmp/table") of 4225 .* H"
	done
	lhfft -K 1 --spectrum="$tmp/table" "$tmp/torus.lh" | cmp "$tmp/plain"
	[ "$(wc -l <"$tmp/table")" = 4226 ]
	lhfft -K 1,2 --spectrum="$tmp/table2" "$tmp/torus.lh" >/dev/null
	cmp "$tmp/table" "$tmp/table2"
}

@test "lhfft: lambda stays positive, by its logarithm or by a floor that is noted" {
	positive() {
		/usr/bin/python3 -c 'import sys; sys.path.insert(0, "scripts"); import lhg
assert next(iter(lhg.read(sys.argv[1])))["lambda"].min() > 0' "$1"
	}
	/usr/bin/python3 - "$tmp/cap.lh" "$tmp/steep.lh" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg, numpy
		g = next(iter(lhg.read(sys.argv[1])))
		g['lambda'][:] = numpy.exp(-numpy.linspace(0, 3, g.nu)**2)
		lhg.write(open(sys.argv[2], 'wb'), [g])
	END
	try 0 '' "$tmp/steep.lh" lhfft --keep=4
	positive "$tmp/out"
	try 0 'stdin: lambda raised to 0.00012.*, its minimum before filtering, at [1-9][0-9]* of 4225 nodes' \
		"$tmp/steep.lh" lhfft --keep=4 --no-log-lambda
	positive "$tmp/out"
}

@test "smoothing removes the noise and keeps the shape" {
	# energy FILE: prints the bending energy of a grid, the integral of H^2 over the area
	energy() {
		/usr/bin/python3 - "$1" <<-'END'
			import sys
			sys.path.insert(0, 'scripts')
			import lhg
			g = next(iter(lhg.read(sys.argv[1])))
			lam, H = g['lambda'], g['H']
			print(float((lam**2*H**2).sum()*g.T/(g.nu - 1)/(g.nv - 1)))
		END
	}
	mesh2rect -n 64 "$tmp/face.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	lhfft -K 2 "$tmp/lh" | lh2grid -o "$tmp/smooth"
	grid2lh "$tmp/smooth" -o "$tmp/smooth.lh"
	below "$(energy "$tmp/smooth.lh")" "$(energy "$tmp/lh")"
	below "$(error_of "$tmp/phi" "$tmp/smooth" max_rel)" 0.15
}

@test "the unit of length changes nothing but the unit" {
	awk 'NR > 2 && NF == 3 { printf "%.17g %.17g %.17g\n", 1024*$1, 1024*$2, 1024*$3; next } { print }' \
		"$tmp/enneper.off" >"$tmp/large.off"
	mesh2rect -n 32 "$tmp/enneper.off" | grid2lh | lhfft -K 1 | lh2grid | grid2mesh -o "$tmp/a.off"
	mesh2rect -n 32 "$tmp/large.off" | grid2lh | lhfft -K 1 | lh2grid | grid2mesh >"$tmp/b.off"
	awk 'NR > 2 && NF == 3 { printf "%.17g %.17g %.17g\n", $1/1024, $2/1024, $3/1024; next } { print }' \
		"$tmp/b.off" >"$tmp/c.off"
	below "$(error_of "$tmp/a.off" "$tmp/c.off" max_rel)" 1e-9
}

@test "channels and metadata that a stage does not know pass through" {
	/usr/bin/python3 - "$tmp/cap.phi" "$tmp/more.phi" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg, numpy
		g = next(iter(lhg.read(sys.argv[1])))
		g.channels['texture'] = lhg.Channel(numpy.arange(g.nu*g.nv, dtype=float).reshape(g.nv, g.nu))
		g.meta['subject'] = 'number 7'
		lhg.write(open(sys.argv[2], 'wb'), [g])
	END
	grid2lh "$tmp/more.phi" | lhfft -K 0 | lh2grid -o "$tmp/psi"
	sed '/^end/q' "$tmp/psi" >"$tmp/head"
	grep -q '^channel texture ' "$tmp/head"
	grep -q '^meta subject number 7$' "$tmp/head"
	grep -q '^channel lambda ' "$tmp/head" && return 1
	[ "$(grep -c '^history ' "$tmp/head")" = 4 ]
}
