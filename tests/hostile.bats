# hostile.bats - with hostile input a command gives a correct result or one line with the reason, and
# never hangs.

load helper

setup_file() {
	load helper
	mkmesh -n 60 cap -o "$tmp/cap.off"
	mesh2rect -n 16 "$tmp/cap.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/lh"
	export OMP_NUM_THREADS=1
}

# soon COMMAND...: runs COMMAND and stops it after a minute.
soon() {
	timeout 60 "$@"
}

# told PATTERN FILE COMMAND...: checks that COMMAND... FILE exits with 1, writes nothing to stdout, and
# one line to stderr that matches PATTERN.
told() {
	local pattern=$1 code=0
	shift
	ASAN_OPTIONS=detect_leaks=0 soon "${@:2}" "$1" >"$tmp/out" 2>"$tmp/err" || code=$?
	[ $code = 1 ] || complain "${*:2}: exit $code"
	[ ! -s "$tmp/out" ] || complain "${*:2}: output"
	[ "$(wc -l <"$tmp/err")" = 1 ] || complain "${*:2}: not one line"
	grep -Eq "$pattern" "$tmp/err" || complain "${*:2}: does not match $pattern"
}

hostile() {
	/usr/bin/python3 tests/hostile.py "$@"
}

# mesh NAME VERTICES.. : FACES..: writes an OFF file to $tmp/NAME.
mesh() {
	/usr/bin/python3 - "$@" >"$tmp/$1" <<-'END'
		import sys
		v, f = ' '.join(sys.argv[2:]).split(':')
		v, f = v.split(), f.split()
		print('OFF\n%d %d 0' % (len(v), len(f)))
		print('\n'.join(x.replace(',', ' ') for x in v))
		print('\n'.join('%d %s' % (x.count(',') + 1, x.replace(',', ' ')) for x in f))
	END
}

scaled() {
	awk -v s="$1" 'NR > 2 && NF == 3 { printf "%.17g %.17g %.17g\n", s*$1, s*$2, s*$3; next } { print }' "$tmp/cap.off"
}

@test "scale: 1e-59 to 1e59 gives the same surface, above 1e60 and below 1e-60 one line" {
	local s
	for s in 1e-59 1e-30 1e30 1e59; do
		scaled $s >"$tmp/s.off"
		soon mesh2rect -n 16 "$tmp/s.off" -o "$tmp/s.phi"
		soon grid2lh "$tmp/s.phi" | soon lhfft -K 0 | soon lh2grid -o "$tmp/s.psi"
		below "$(error_of "$tmp/s.phi" "$tmp/s.psi" max_rel)" 0.03
		soon grid2lh "$tmp/s.phi" | soon lh2grid --method=frame -o "$tmp/s.psi"
		below "$(error_of "$tmp/s.phi" "$tmp/s.psi" max_rel)" 0.3
		soon grid2mesh "$tmp/s.psi" -o "$tmp/s.ply"
		below "$(soon lhdiff "$tmp/s.psi" "$tmp/s.ply" | awk '$1 == "hausdorff_rel" { print $2 }')" 1e-2
	done
	for s in 1e61 1e100 1e300 1e307; do
		scaled $s >"$tmp/s.off"
		told 'a coordinate of size [0-9.e+]*, more than 1e\+60' "$tmp/s.off" mesh2rect -n 4
		told 'a coordinate of size' "$tmp/s.off" lhdiff "$tmp/cap.off"
	done
	for s in 1e-61 1e-100 1e-300 1e-320; do
		scaled $s >"$tmp/s.off"
		told 'surface is [0-9.e-]* wide, less than 1e-60' "$tmp/s.off" mesh2rect -n 4
		told 'surface is [0-9.e-]* wide, less than 1e-60' "$tmp/s.off" lhdiff "$tmp/cap.off"
	done
	for s in 1e61 1e300; do
		hostile "$tmp/phi" "$tmp/bad" "
for c in 'xyz': g[c][:] *= $s"
		told 'more than 1e\+60' "$tmp/bad" grid2lh
		told 'more than 1e\+60' "$tmp/bad" lhdiff "$tmp/phi"
	done
}

@test "meshes of one, two, flat, thin and faraway triangles" {
	local c
	mesh one   0,0,0 1,0,0 0,1,0 : 0,1,2
	mesh two   0,0,0 1,0,0 1,1,0 0,1,0 : 0,1,2 0,2,3
	mesh quad  0,0,0 1,0,0 1,1,.3 0,1,0 : 0,1,2,3
	mesh tiny  0,0,5e-324 1,0,1e-310 1,1,-4e-320 0,1,0 : 0,1,2 0,2,3
	mesh far   1e8,0,0 1e8,1,0 1e8,1,1 1e8,0,1 : 0,1,2 0,2,3
	mesh thin  0,0,0 1,0,0 1,1e-7,0 0,1e-7,0 : 0,1,2 0,2,3
	mesh line  0,0,0 1,0,0 2,0,0 3,0,0 : 0,1,2 0,2,3
	mesh point 1,1,1 1,1,1 1,1,1 : 0,1,2
	mesh nan   0,0,0 1,0,0 1,1,nan 0,1,0 : 0,1,2 0,2,3
	mesh inf   0,0,0 1,0,0 1,1,-inf 0,1,0 : 0,1,2 0,2,3
	mesh over  0,0,0 1,0,0 1,1,1e999 0,1,0 : 0,1,2 0,2,3
	mesh spike 0,0,0 1,0,0 1e50,1,0 0,1,0 : 0,1,2 0,2,3
	for c in '' '--surface=facets --split=0 --tolerance=1 --polish=0'; do
		soon mesh2rect -n 8 $c "$tmp/one" -o "$tmp/m.phi"
		for m in two quad tiny far thin; do
			soon mesh2rect -n 8 $c "$tmp/$m" -o "$tmp/m.phi"
			soon grid2lh "$tmp/m.phi" | soon lh2grid -o "$tmp/m.psi"
			[ -n "$c" ] || below "$(error_of "$tmp/m.phi" "$tmp/m.psi" max_rel)" 0.03
		done
		told 'no area|wide' "$tmp/line" mesh2rect -n 4 $c
		told 'no area|three|vertices' "$tmp/point" mesh2rect -n 4 $c
		told 'no area' "$tmp/spike" mesh2rect -n 4 $c
		for m in nan inf over; do
			told 'vertex 2 has a coordinate that is not finite' "$tmp/$m" mesh2rect -n 4 $c
		done
	done
}

@test "grids of 2 x 2 nodes and more" {
	local s c
	for s in 2,2 3,3 9,2 3,9 4,4,3 6,7,3 7,7; do
		hostile "$tmp/phi" "$tmp/g" "g = size($s)"
		for c in lhinfo grid2mesh 'lh2png -c all' 'lhfft -K 0' 'lhfft -K 0 --basis=dft' 'lhfft --low-pass=0' \
		    "lhfft --keep=1 --no-log-lambda --spectrum=$tmp/table" "lhinterp -n 3 $tmp/g"; do
			try 0 '' /dev/null soon $c "$tmp/g"
		done
		below "$(soon lhdiff "$tmp/g" "$tmp/g" | awk '$1 == "hausdorff_rel" { print $2 }')" 1e-6
		soon lh2grid "$tmp/g" -o "$tmp/back"            # nearly flat: lambda = 1 and H = 0 are right to 1 %
		below "$(error_of "$tmp/g" "$tmp/back" max_rel)" 0.01
		case $s in
		*,*,3)  for c in --no-start --method=frame; do
				soon lh2grid $c "$tmp/g" -o "$tmp/back"
				below "$(error_of "$tmp/g" "$tmp/back" max_rel)" 0.05
			done ;;
		*)      told 'channel band.x has 1 rings, need 3' "$tmp/g" lh2grid --no-start
			told 'channel band.x has 1 rings, need 3' "$tmp/g" lh2grid --method=frame ;;
		esac
		case $s in
		2,*|3,*|9,2) told 'nodes, need at least 4 x 4' "$tmp/g" grid2lh ;;
		*) soon grid2lh "$tmp/g" >/dev/null ;;
		esac
	done
}

@test "grids that are no surface, and lambda and H of no surface, are refused" {
	# each line: the file SOURCE; Python code that spoils its grid g; the message; the command
	while IFS=';' read -r source code line command; do
		[ -n "$source" ] || continue
		hostile "$tmp/$source" "$tmp/bad" "$code"
		told "$line" "$tmp/bad" ${command/@/$tmp/}
	done <<-'END'
		phi;for c in 'xyz': g[c][:] = 1;the surface has no extent;grid2lh
		phi;for c in 'xyz': g[c][:] = 1;has no area;lhdiff @phi
		phi;for c in 'yz': g[c][:] = 1;has no area;lhdiff @phi
		phi;g.T = 1e-300;height T is 1e-300, not in;grid2lh
		phi;g.T = 1e300;height T is 1e\+300, not in;grid2lh
		lh;g.T = 5e-324;height T is 4.94066e-324, not in;lh2grid
		lh;g.T = 1e10;height T is 1e\+10, not in;lh2grid
		lh;g.T = 1e10;height T is 1e\+10, not in;lh2grid --method=frame
		lh;g['lambda'][8,8] = 0;lambda is 0 at node \(8,8\), must be positive;lh2grid
		lh;g['lambda'][8,8] = -1;lambda is -1 at node \(8,8\), must be positive;lh2grid --no-start
		lh;g['lambda'][8,8] = 0;lambda is not positive everywhere;lhfft -K 1
		lh;g['lambda'][8,8] = 0;lambda is not positive everywhere;lhfft -K 1 --no-log-lambda
		lh;g['lambda'][8,8] = 5e-324;lambda goes from 4.94e-324;lh2grid
		lh;g['lambda'][8,8] = 1e-300;lambda goes from 1e-300 to;lh2grid --method=frame
		lh;g['lambda'][8,8], g['H'][:] = 1e13, 0;lambda goes from .* to 1e\+13;lh2grid
		lh;g['lambda'][:] = 1e300;H lambda is|lambda goes;lh2grid
		lh;g['lambda'][:], g['H'][:] = 1e300, 0;lambda goes from 1e\+300 to 1e\+300;lh2grid
		lh;g['lambda'][:] = 1e-30;is .* wide, where lambda allows ;lh2grid
		lh;g['lambda'][:] = 1e150;channel lambda has a sample of 1e\+150;lhfft -K 1
		lh;g['H'][8,8] = 1e300;H lambda is .* at node \(8,8\), more than;lh2grid
		lh;g['H'][:] = -1e308;H lambda is;lh2grid --method=frame
		lh;g['H'][8,8] = 1e300;channel H has a sample of 1e\+300;lhfft -K 1
		lh;g['H'][8,8] = 1e300;channel H has a sample of 1e\+300;lhfft --energy=0.5
		lh;g['H'][8,8], g['lambda'][:] = 1e90, 1e50;lambda H is 1e\+140 at node \(8,8\), more than 1e\+100;lhfft -K 1
		lh;g['start.y'][5] = 1e300;channel start.y has a sample of 1e\+300;lh2grid
		lh;g['start.y'][5] = 1e30;channel start.y is 1e\+30 wide, where lambda allows;lh2grid
		lh;g['band.z'][5] = 1e30;channel band.z is 1e\+30 wide, where lambda allows;lh2grid --method=frame
		lh;for c in 'xyz': g['band.' + c][:] = 0;none is found from the band;lh2grid --no-start
		lh;for c in 'xyz': g['band.' + c][:] = 0;band has no tangent plane at node \(1,1\);lh2grid --method=frame
		lh;g.channels['nu1'] = lhg.Channel(g['H']*0);no channel tau1;lh2grid
		lh;g.channels['tau2'] = lhg.Channel(g['H']*0);no channel nu1;lh2grid
		lh;for n in 'nu1', 'nu2', 'tau1', 'tau2': g.channels[n] = lhg.Channel(g['H']*0 + 1e200);channel .* has a sample of 1e\+200;lh2grid
		lh;for c in 'xyz': del g.channels['band.' + c];no channel band.x;lh2grid
		lh;g.channels['start.y'] = g.channels['band.y'];start.y has support border, need lattice;lh2grid
		lh;g.channels['start.y'] = lhg.Channel(g['start.y'].reshape(17, 17)[::4, ::4].ravel(), 'length', 'lattice', 4);lattices of different steps;lh2grid
	END
}

@test "unusual but valid numbers give a correct result" {
	# denormal numbers and -0 are valid; a grid without start channels acts as with --no-start
	hostile "$tmp/lh" "$tmp/odd" "
g['H'][3, 3] = 5e-324
g['H'][4, 4] = -0.0"
	soon lhfft -K 1 "$tmp/odd" | soon lh2grid >"$tmp/out"
	soon lhinterp -t 1 "$tmp/lh" "$tmp/odd" | lhinfo >/dev/null
	hostile "$tmp/lh" "$tmp/odd" "
for c in 'xyz': del g.channels['start.' + c]"
	soon lh2grid "$tmp/odd" -o "$tmp/a"
	soon lh2grid --no-start "$tmp/lh" -o "$tmp/b"
	soon grid2mesh "$tmp/a" >"$tmp/a.off"
	soon grid2mesh "$tmp/b" | cmp "$tmp/a.off"
	hostile "$tmp/phi" "$tmp/big" "g['z'][:] += 1e300"
	told 'more than 1e\+60' "$tmp/big" grid2lh
	soon grid2mesh "$tmp/big" | grep -q ' 1e+300$'
	told 'too large for STL' "$tmp/big" grid2mesh -o "$tmp/x.stl"
}

# endless COMMAND...: checks that COMMAND, fed with endless lines of $words [y], exits with 1 within
# 10 seconds, writes nothing to stdout, and one line to stderr that matches $pattern.
endless() {
	local code=0
	yes "${words:-y}" | timeout 10 "$@" >"$tmp/out" 2>"$tmp/err" || code=${PIPESTATUS[1]}
	[ $code = 1 ] || complain "$*: exit $code"
	[ ! -s "$tmp/out" ] || complain "$*: output"
	[ "$(wc -l <"$tmp/err")" = 1 ] || complain "$*: not one line"
	grep -Eq "$pattern" "$tmp/err" || complain "$*: does not match $pattern"
}

@test "nodes where phi_u is parallel to phi_v are noted, and H is 0 there" {
	# columns 3 to 5 lie on a line; phi_u and phi_v are parallel to it at inner nodes of column 4
	hostile "$tmp/phi" "$tmp/folded" 'g = size(9, 7)
v, u = np.mgrid[:7, 3:6]
for c, a in zip("xyz", (0.3, 0.7, -0.2)): g[c][:, 3:6] = a*(u/8 + 0.37*v/6)'
	try 0 'folded: 5 nodes where phi_u and phi_v are parallel; H is 0 there$' /dev/null grid2lh "$tmp/folded"
	hostile "$tmp/out" "$tmp/same" 'assert (g["H"][1:-1, 4] == 0).all() and (g["H"][1:-1, 3] != 0).all()'
	try 0 '' /dev/null grid2lh -q "$tmp/folded"
}

@test "an endless input that does not begin as a mesh is refused at once" {
	local pattern='not an OFF, OBJ, PLY, STL, .* file'
	endless mesh2rect
	endless lhdiff - "$tmp/cap.off"
	endless lhdiff "$tmp/cap.off" -
	endless grid2mesh --on=- "$tmp/phi"
	pattern='not an lhg stream' endless mesh2rect --like=- "$tmp/cap.off"
	yes | gzip | told "$pattern" - mesh2rect
	told "$pattern" /dev/zero mesh2rect
	told "$pattern" /dev/zero lhdiff "$tmp/cap.off"
}

@test "an endless input that begins as a mesh is refused at the size limit" {
	case $BUILD in */*) skip "a sanitizer needs its own address space" ;; esac
	local pattern='stdin: more than 102400000 bytes: the most that is read is half of the memory|no memory'
	ulimit -v 200000
	words='v 0 0 0' endless mesh2rect
	words='v 0 0 0' endless lhdiff - "$tmp/cap.off"
	words='v 0 0 0' endless grid2mesh --on=- "$tmp/phi"
	(echo OFF; yes 1 2 3) | told "$pattern" - mesh2rect
	told "/dev/zero: (more than|no memory)" "$tmp/cap.off" mesh2rect --corners=/dev/zero
	head -c 300000000 /dev/zero | gzip | told 'gzip data are larger than|no memory|not an OFF' - mesh2rect
	(echo OFF; head -c 300000000 /dev/zero) | gzip | told 'gzip data are larger than 102400000 bytes|no memory' - mesh2rect
}
