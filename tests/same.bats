# same.bats - every command gives equal bytes for equal input: run after run, for any number of
# threads, in any folder and locale.  A command is run 3 times, with SOAK set 16 times.

load helper

setup_file() {
	load helper
	three_js
	cd "$tmp"
	mkmesh -n 3000 face -o face.off
	mesh2rect -n 96 --uv=uv.ply face.off -o phi     # so many nodes that sums use several threads
	grid2lh --residual phi -o lh
	mesh2rect -n 24 face.off | grid2lh -o small.lh
	mkmesh -n 2000 face smile=0.8 | mesh2rect -q -n 96 --like=phi -o other
	awk 'NR == 2 { nv = $1; print $1, $2 - 40, 0; next } NR < nv + 1000 || NR >= nv + 1040' face.off >hole.off
	mkdir there
	cp hole.off face.off uv.ply phi other lh small.lh there
}

# same COMMAND...: checks that stdout and stderr of COMMAND do not depend on threads, folder or locale.
same() {
	local n
	cd "$tmp"
	OMP_NUM_THREADS=1 "$@" >"$tmp/first" 2>"$tmp/words"
	again() { "$@" >"$tmp/now" 2>"$tmp/said" && cmp "$tmp/first" "$tmp/now" && cmp "$tmp/words" "$tmp/said"; }
	for n in ${SOAK:+1 2 3 4 8} 8; do
		OMP_NUM_THREADS=$n OPENBLAS_NUM_THREADS=$n again "$@"
	done
	(cd there && LC_ALL=de_DE.UTF-8 again "$@")
	[ -z "$SOAK" ] || for n in 1 2 3 4; do
		again "$@"
		(cd there && env -i PATH="$PATH" LC_ALL=tr_TR.UTF-8 TZ=Asia/Tokyo USER=other HOME=/ "$@") | cmp "$tmp/first"
	done
}

@test "mkmesh"    { same mkmesh -n 4000 cortex; same mkmesh -n 100 torus --seed=3; same mkmesh --help; }
@test "mesh2disk" { same mesh2disk hole.off; same mesh2disk --check --json hole.off; same mesh2disk --holes=all --open=auto hole.off; }
@test "mesh2rect" { same mesh2rect -n 96 face.off; same mesh2rect -v -n 24 --surface=facets --split=2 face.off; }
@test "grid2lh"   { same grid2lh --residual phi; same grid2lh -v phi; }
@test "lhfft"     { same lhfft -v -K 0.5,2 lh; same lhfft --energy=0.9 --basis=dft lh; }
@test "lhwarp"    { same lhwarp -v phi other; }
@test "lhinterp"  { same lhinterp -n 3 lh lh; }
@test "lh2grid"   { same lh2grid lh; same lh2grid --no-start --ideal small.lh; same lh2grid --method=frame small.lh; }
@test "grid2mesh" { same grid2mesh phi; same grid2mesh --on uv.ply phi; }
@test "a sock" {
	same mesh2rect --chart=sock -n 48 face.off
	mesh2rect -q --chart=sock -n 48 face.off | grid2lh -o "$tmp/sock.lh"
	cp "$tmp/sock.lh" there
	same lhfft --scale=5% sock.lh
	same lh2grid --no-place sock.lh
}
@test "lh2png"    { same lh2png -v phi; same lh2png -c all lh; }
@test "grid2html" { same grid2html --three="$tmp/three" --colours=lh --beside=phi --distance phi; }
@test "lhinfo"    { same lhinfo phi lh; same lhinfo --json lh; }
@test "lhdiff"    { same lhdiff --no-self-intersections phi face.off; same lhdiff --json phi phi; }

@test "files have the same bytes as stdout: --uv, --spectrum, every mesh format" {
	local e
	cd "$tmp"
	for e in off obj ply stl; do
		OMP_NUM_THREADS=1 grid2mesh phi -o "a.$e"
		(cd there && LC_ALL=de_DE.UTF-8 OMP_NUM_THREADS=4 grid2mesh phi -o "../b.$e")
		cmp "a.$e" "b.$e"
	done
	lhfft -K 1 --spectrum=a.table lh >/dev/null
	LC_ALL=de_DE.UTF-8 lhfft -K 1 --spectrum=b.table lh >/dev/null
	cmp a.table b.table
}

@test "numbers have a decimal point in a locale of decimal commas, in files and in options" {
	cd "$tmp"
	export LC_ALL=de_DE.UTF-8
	[ "$(printf %.1f 0,5 2>/dev/null)" = 0,5 ] || skip "no locale de_DE.UTF-8"
	lhinterp -t 0.5 small.lh small.lh -o half
	lhinfo half | grep -q '^  meta t 0.5$'
	try 2 'need a number in \[0,1\]' /dev/null lhinterp -t 0,5 small.lh small.lh
	try 2 'a=0,5: need a number' /dev/null mkmesh rectangle a=0,5
	mkmesh -n 50 rectangle a=1 b=0.7 | grep -q '[0-9],[0-9]' && return 1
	mesh2rect -n 4 --corners='0.1,0.2,0;1,0,0;1,0.7,0;0,0.7,0' <(mkmesh -n 50 rectangle a=1 b=0.7) >/dev/null
}

# OpenBLAS has loops for each kind of processor, and takes those that it is told.
@test "on another processor the results are the same up to rounding" {
	pipeline() {
		mesh2rect -q -n 96 face.off | tee "$1.phi" | grid2lh | lhfft --scale=2% | lh2grid -q --no-history -o "$1.smooth"
		lhwarp -q "$1.phi" other | grid2lh --residual -o "$1.b"
		grid2lh --residual "$1.phi" | lhinterp -q -t 0.5 - "$1.b" | lh2grid -q --no-history -o "$1.morph"
	}
	cd "$tmp"
	pipeline here
	for kind in Nehalem Prescott; do
		OPENBLAS_CORETYPE=$kind pipeline there
		below "$(error_of here.smooth there.smooth max_rel)" 1e-10
		below "$(error_of here.morph there.morph max_rel)" 1e-10
	done
}
