# lh2grid.bats - lh2grid: the surface method, its options, metadata and messages.

load helper

setup_file() {
	export tmp="$BATS_FILE_TMPDIR"
	mkmesh -n 6000 face | mesh2rect -q -n 90 -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
}

@test "grid2lh --residual gives the surface itself back; --ideal leaves the residual out" {
	grid2lh --residual "$tmp/phi" -o "$tmp/all"
	lh2grid "$tmp/all" -o "$tmp/psi"
	below "$(error_of "$tmp/phi" "$tmp/psi" max_rel)" 1e-7
	lh2grid --ideal "$tmp/all" -o "$tmp/psi"
	below 1e-5 "$(error_of "$tmp/phi" "$tmp/psi" max_rel)"
	[ "$(lhinfo "$tmp/psi" | grep -cE '(nu|tau)[12]')" = 0 ]
}

# meta FILE KEY: prints the value of a metadatum.
meta() {
	lhinfo "$1" | awk -v k="$2" '$0 ~ k { print $NF }'
}

# promise: prints a statement for hostile.py that makes the metadatum residual true of g.
promise() {
	echo "import zlib
g.meta['residual'] = '%08x' % zlib.crc32(b''.join(g[c].astype('<f8').tobytes() for c in ('lambda', 'H', 'nu1', 'nu2', 'tau1', 'tau2')))"
}

@test "exact residual channels: promised by grid2lh, until lambda or H change; a fit that ends elsewhere is refused" {
	grid2lh --residual "$tmp/phi" -o "$tmp/all"
	/usr/bin/python3 tests/hostile.py "$tmp/all" "$tmp/again" "$(promise)"
	[ "$(meta "$tmp/all" residual)" = "$(meta "$tmp/again" residual)" ]
	lhfft -K 0 "$tmp/all" | lh2grid -o "$tmp/psi"
	below "$(meta "$tmp/psi" misfit)" 1e-11
	change="g['H'][40:50,40:50] *= 1.5"
	/usr/bin/python3 tests/hostile.py "$tmp/all" "$tmp/changed" "$change"
	lh2grid "$tmp/changed" -o "$tmp/psi"
	below 1e-11 "$(meta "$tmp/psi" misfit)"
	/usr/bin/python3 tests/hostile.py "$tmp/all" "$tmp/broken" "$change
$(promise)"
	try 1 'ends at another surface than the one of the residual channels: misfit [0-9.e+-]*, not 0; try' "$tmp/broken" lh2grid
	grid2lh --residual --mean-curvature=magnitude "$tmp/phi" -o "$tmp/other"
	[ -z "$(lhinfo "$tmp/other" | grep 'meta residual')" ]
}

@test "the start does not change the result: without one, the same surface to the tolerance" {
	lh2grid "$tmp/lh" -o "$tmp/a"
	lh2grid --no-start "$tmp/lh" -o "$tmp/b"
	grid2lh --no-lattice "$tmp/phi" | lh2grid -o "$tmp/c"
	grid2lh --lattice=20 "$tmp/phi" | lh2grid -o "$tmp/d"
	for x in b c d; do
		below "$(error_of "$tmp/a" "$tmp/$x" max_rel)" 1e-4
	done
}

@test "the surface method is nearer than the frame method" {
	lh2grid "$tmp/lh" -o "$tmp/a"
	lh2grid --method=frame "$tmp/lh" -o "$tmp/b"
	below "$(error_of "$tmp/phi" "$tmp/a" mean_rel)" "$(error_of "$tmp/phi" "$tmp/b" mean_rel)"
}

@test "every frame of a stream of scales is solved, and bending falls from scale to scale" {
	lhfft -K 0,0.5,1,2,5 "$tmp/lh" | lh2grid | grid2lh -o "$tmp/scales"
	/usr/bin/python3 scripts/bending.py "$tmp/scales" >"$tmp/bending"
	[ "$(wc -l <"$tmp/bending")" = 5 ]
	sort -rnc "$tmp/bending"
}

@test "metadata say how good a fit is: misfit is small for a surface and large after a filter" {
	lhfft -K 0 "$tmp/lh" | lh2grid -o "$tmp/same"
	lhfft -K 2 "$tmp/lh" | lh2grid -o "$tmp/smooth"
	[ "$(meta "$tmp/same" stopped)" = converged ]
	[ "$(meta "$tmp/smooth" stopped)" = converged ]
	below "$(meta "$tmp/same" misfit)" 1
	below 1 "$(meta "$tmp/smooth" misfit)"
	below "$(meta "$tmp/smooth" change)" 5e-5
}

@test "an unfiltered surface starts from its place, on the full grid" {
	mkmesh -n 3000 face | mesh2rect -q -n 150x128 -o "$tmp/face"
	grid2lh --residual "$tmp/face" -o "$tmp/facelh"
	lh2grid -v --ideal "$tmp/facelh" -o "$tmp/place" 2>"$tmp/withplace"
	lh2grid -v --ideal --no-place "$tmp/facelh" -o "$tmp/lattice" 2>"$tmp/without"
	[ "$(grep -c '151 x 129 nodes, step' "$tmp/withplace")" = "$(grep -c 'nodes, step' "$tmp/withplace")" ]
	[ "$(grep -c '151 x 129 nodes, step' "$tmp/without")" -lt "$(grep -c 'nodes, step' "$tmp/without")" ]
	# The same surface: the start enters no equation.
	below "$(error_of "$tmp/place" "$tmp/lattice" mean_rel)" 1e-4
	below 1e-5 "$(error_of "$tmp/face" "$tmp/place" mean_rel)"
	# With residual channels it is the surface itself.
	lh2grid -v "$tmp/facelh" -o "$tmp/exact" 2>"$tmp/said"
	[ "$(grep -c 'nodes, step' "$tmp/said")" = 1 ]
	below "$(error_of "$tmp/face" "$tmp/exact" max_rel)" 1e-12
	# With a frame before it, --follow starts from that.
	cat "$tmp/facelh" "$tmp/facelh" | lh2grid -v --ideal --follow 2>&1 >"$tmp/two" | grep -q '76 x 65 nodes, step'
}

@test "a surface that is not the one of lambda and H is noted, with its distance" {
	mkmesh -n 3000 face | mesh2rect -q -n 64 -o "$tmp/near"
	grid2lh "$tmp/near" | lh2grid -o "$tmp/solved" 2>"$tmp/err"
	[ ! -s "$tmp/err" ]
	[ "$(meta "$tmp/solved" deviation)" = "$(printf %.3g "$(error_of "$tmp/near" "$tmp/solved" max_rel)")" ]
	mkmesh -n 3000 face | mesh2rect -q -n 8 | grid2lh -q -o "$tmp/coarse"
	try 0 'near (.*) the surface is 0.0[0-9]* of sqrt.area. from that of channels place' /dev/null \
	    lh2grid "$tmp/coarse" -o "$tmp/solved"
	lh2grid --no-place "$tmp/coarse" -o "$tmp/solved" 2>"$tmp/err"
	[ ! -s "$tmp/err" ]
	[ -z "$(meta "$tmp/solved" deviation)" ]
}

@test "a fit that creeps is noted, and is not called converged" {
	/usr/bin/python3 tests/hostile.py "$tmp/lh" "$tmp/noisy" "H = g['H']
H[:] += 100*abs(H).mean()*np.random.default_rng(1).normal(size=H.shape)"
	try 0 'the last steps crept: energy .*, moved by .* of sqrt.area. .metadatum stopped.$' /dev/null \
	    lh2grid --no-place "$tmp/noisy" -o "$tmp/crept"
	[ "$(meta "$tmp/crept" stopped)" = crept ]
}

@test "creeping steps go on while ten of them move the surface by more than ten times the tolerance" {
	mkmesh -n 2000 face | mesh2rect -q -n 40 | grid2lh -o "$tmp/small"
	noted=0 refused=0
	for seed in 1 2 3 4 5 6 7 8; do
		/usr/bin/python3 tests/hostile.py "$tmp/small" "$tmp/noisy" "a = g['lambda']
a[:] *= 1.33**np.random.default_rng($seed).normal(size=a.shape)"
		run --separate-stderr lh2grid --steps=400 "$tmp/noisy" -o "$tmp/far"
		by=$(sed -n 's/.*crept.* moved by \([0-9.e-]*\) of sqrt.*/\1/p' <<<"$stderr")
		[ -z "$by" ] || { below "$by" 5.1e-4; noted=$((noted + 1)); }
		[ "$status" = 0 ] || [[ $stderr =~ 'no convergence in 400 steps' ]]
		run --separate-stderr lh2grid --steps=18 "$tmp/noisy" -o "$tmp/far"
		[ "$status" = 0 ] || { [[ $stderr =~ 'no convergence in 18 steps'.*'try fewer cells' ]]; refused=$((refused + 1)); }
	done
	[ "$noted" -gt 0 ] && [ "$refused" -gt 0 ]
}

@test "errors of lh2grid say what is wrong" {
	grid2lh "$tmp/phi" | lhfft -K 2 -o "$tmp/two"
	try 1 'no convergence in 1 steps: energy [0-9.e+]*, change .*, the largest residual at node \([0-9]+,[0-9]+\)' \
	    "$tmp/two" lh2grid --steps=1
	try 2 'method'    "$tmp/lh" lh2grid --method=magic
	try 2 'tolerance' "$tmp/lh" lh2grid --tolerance=0
	try 2 'steps'     "$tmp/lh" lh2grid --steps=0
}

@test "lh2grid -v reports the cost" {
	run lh2grid -v "$tmp/lh" -o "$tmp/a"
	[[ $output =~ 'vector Poisson solves of 91 x 91 nodes' ]]
}

@test "a free boundary: near the held surface, also without a band and at other scales" {
	lh2grid "$tmp/lh" -o "$tmp/a"
	lh2grid --boundary=held "$tmp/lh" -o "$tmp/c"
	below "$(error_of "$tmp/a" "$tmp/c" max_rel)" 1e-300
	lh2grid --boundary=free "$tmp/lh" -o "$tmp/b"
	below "$(error_of "$tmp/a" "$tmp/b" mean_rel)" 0.01
	below 1e-6 "$(error_of "$tmp/a" "$tmp/b" max_rel)"
	lhfft -K 2 "$tmp/lh" | lh2grid --boundary=free | lhinfo >/dev/null
	/usr/bin/python3 -c 'import sys; sys.path.insert(0, "scripts"); import lhg
g = list(lhg.read(sys.argv[1]))
for q in g:
    for c in "xyz": del q.channels["band." + c]
lhg.write(sys.argv[2], g)' "$tmp/lh" "$tmp/adrift"
	lh2grid --boundary=free "$tmp/adrift" -o "$tmp/c"
	below "$(error_of "$tmp/b" "$tmp/c" mean_rel)" 0.05
	try 1 'band' "$tmp/adrift" lh2grid
	try 1 'band' "$tmp/adrift" lh2grid --boundary=free --no-start
	try 2 'boundary' "$tmp/lh" lh2grid --boundary=loose
	try 2 'surface method' "$tmp/lh" lh2grid --boundary=free --method=frame
}

@test "residual channels of a surface are fitted to 0; those of a blend cost no more steps than lambda and H alone" {
	mkmesh -n 900 face | mesh2rect -q -n 32 -o "$tmp/one.phi"
	mkmesh -n 700 face smile=0.8 nose=0.6 | mesh2rect -q -n 32 --like="$tmp/one.phi" | grid2lh --residual --no-place -o "$tmp/other"
	grid2lh --residual --no-place "$tmp/one.phi" -o "$tmp/one"
	lhinterp -q -t 0,0.5 "$tmp/one" "$tmp/other" -o "$tmp/blend"
	lh2grid -v "$tmp/blend" -o "$tmp/back" 2>"$tmp/said"
	lhinfo "$tmp/back" | awk '$2 == "misfit" { print $3 }' >"$tmp/misfit"
	below "$(head -1 "$tmp/misfit")" 1e-12
	run ! below "$(tail -1 "$tmp/misfit")" 1e-3         # near no surface
	lhinfo "$tmp/back" | awk '$2 == "change" { print $3 }' >"$tmp/change"
	below "$(head -1 "$tmp/change")" 1e-8
	run ! below "$(tail -1 "$tmp/change")" 5e-7         # with the fine tolerance, 5e-9
}
