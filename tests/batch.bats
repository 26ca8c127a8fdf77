# batch.bats - many meshes: batch.mk, lhbatch here and on Slurm, Snakefile; failures, reports, resuming.

load helper
load slurm

setup() {
	! sanitized || skip "make and the shell have no sanitizers; the programs are tested with them elsewhere"
	PATH=$PWD/scripts:$PATH
	unset MAKEFLAGS MFLAGS MAKELEVEL        # of the make that runs the tests
	here=$PWD
	folder=$tmp/$BATS_TEST_NUMBER
	mkdir -p "$folder/scans"
	cd "$folder"
}

# meshes N: N small meshes, the third of which is cut off; and the Makefile.
meshes() {
	for i in $(seq "$1"); do mkmesh -n 150 --seed=$i cap -o scans/cap$i.ply; done
	mkmesh -n 150 --seed=3 cap -o whole.ply
	head -c 2000 whole.ply >scans/cap3.ply
	printf 'MESHES = $(wildcard scans/*.ply)\nMESH2RECT = -n %d\ninclude $(shell lhbatch --mk)\n' "${2:-16}" >Makefile
}

# field MESH NAME: a field of report.tsv.
field() {
	awk -F'\t' -v mesh="$1" -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
	    $1 == mesh { print $at[name] }' report.tsv
}

@test "a batch: a row for each mesh, one failed with its message, the others as by hand; a rerun does what is left" {
	meshes 5
	run -1 lhbatch -j 2
	[[ $output == *'4 ok, 1 failed, 0 missing'* ]]
	[ "$(wc -l <report.tsv)" = 6 ]
	[ "$(wc -l <failed.tsv)" = 2 ]
	grep -q $'^scans/cap3.ply\tfailed\t.*\tmesh2rect: scans/cap3.ply: header announces' failed.tsv
	[ ! -e smooth/cap3.ply ]
	mesh2rect -q -n 16 --uv=uv.ply scans/cap1.ply | grid2lh -o lh
	lhfft --scale=2% lh | lh2grid | grid2mesh --on=uv.ply -o by-hand.ply
	cmp by-hand.ply smooth/cap1.ply
	[ "$(field scans/cap1.ply status)" = ok ]
	[ "$(mesh2rect -q -n 16 scans/cap1.ply | lhinfo | sed -n 's/^  meta certificate //p')" = "$(field scans/cap1.ply certificate)" ]
	[ "$(mesh2rect -q -n 16 scans/cap1.ply | lhinfo | sed -n 's/^  meta kept //p')" = "$(field scans/cap1.ply kept)" ]
	[ "$(lh2grid -q lh | lhinfo | sed -n 's/^  meta deviation //p')" = "$(field scans/cap1.ply error)" ]
	below "$(field scans/cap1.ply seconds)" 600
	[ "$(make -s pending)" = smooth/cap3.ply ]
	cp -p smooth/cap1.ply before
	cp whole.ply scans/cap3.ply
	run -0 lhbatch
	[ "$(wc -l <failed.tsv)" = 1 ]
	[ ! smooth/cap1.ply -nt before ]
	# a mesh that becomes bad has no result any more
	cat /dev/null >scans/cap1.ply
	run -1 lhbatch
	[ ! -e smooth/cap1.ply ]
	grep -q $'^scans/cap1.ply\tfailed\t.*empty input' failed.tsv
	[ "$(ls -A smooth | grep -c lhone)" = 0 ]
}

@test "a batch that is killed leaves no result that is not complete, and goes on where it was" {
	meshes 4 64
	cp whole.ply scans/cap3.ply
	cp -r scans Makefile "$tmp"
	(cd "$tmp" && lhbatch -j 2 && rm -rf whole && mv smooth whole)
	for i in 1 2 3 4 5 6; do
		setsid lhbatch -j 2 >/dev/null 2>&1 3>&- &
		sleep 0.$((i*2))
		kill -9 -- -$! || :
		wait $! || :
		for f in smooth/*.ply; do
			[ ! -e "$f" ] || cmp "$f" "$tmp/whole/${f##*/}"
		done
	done
	lhbatch -j 2
	for f in "$tmp"/whole/*.ply; do cmp "$f" "smooth/${f##*/}"; done
	[ "$(grep -c $'\tok\t' report.tsv)" = 4 ]
	make -s tidy
	[ "$(ls -A smooth | grep -c lhone)" = 0 ]
}

@test "batch.mk: a stage that is killed, options of commands, two meshes of one name, no mesh" {
	meshes 2
	mkdir bin
	printf '#!/bin/sh\nkill -9 $$\n' >bin/lhfft
	chmod +x bin/lhfft
	PATH=$PWD/bin:$PATH run -1 lhbatch
	[ "$(field scans/cap1.ply message)" = 'lhfft: killed by signal 9' ]
	rm -r bin
	cp whole.ply scans/cap3.ply
	run -0 make -s report MESH2DISK=- LHFFT='--relief=1%' OUT=relief EXT=obj KEEP_LHG=yes
	[ -s relief/cap1.obj ]
	lhinfo relief/cap1.lhg | grep -q 'history grid2lh'
	mkdir more
	cp scans/cap1.ply more/cap1.off
	run -2 make MESHES='scans/cap1.ply more/cap1.off'
	[[ $output == *'two meshes have the same name'* ]]
	run -0 make -s report MESHES=
	[[ $output == '0 ok, 0 failed, 0 missing'* ]]
}

@test "lhbatch: help in 80 columns with an example; mistakes exit 2" {
	lhbatch --help >help
	run ! grep -nE '^.{81}' help
	grep -q '^Example: lhbatch ' help
	[ "$(lhbatch --version)" = "lhbatch (lhgrid) $(mesh2rect --version | cut -d' ' -f3)" ]
	try 2 'jobs=0: need a whole number'     /dev/null lhbatch -j 0
	try 2 'tasks=x: need a whole number'    /dev/null lhbatch --slurm -n x
	try 2 'option .--frob'                  /dev/null lhbatch --frob
	try 2 'operand extra is one too many'   /dev/null lhbatch -f /dev/null extra
	try 1 'nosuch: no such Makefile'        /dev/null lhbatch -f nosuch
	touch Makefile
	slurm_there || try 1 'sbatch is not there' /dev/null lhbatch --slurm
}

@test "Slurm: 20 meshes in 4 tasks, one poisoned, a node killed in the middle: as by make -j2" {
	slurm_there || skip "no Slurm on this machine (slurmctld slurmd slurm-client munge)"
	meshes 20 128
	cp -r scans Makefile "$tmp"
	slurm=$(mktemp -d)              # not in $tmp: munge demands that every folder above is readable
	slurm_up "$slurm" 2
	lhbatch --slurm -n 4 --wait >out 2>err 3>&- &
	batch=$!
	until [ "$(find smooth -name '*.ply' 2>/dev/null | wc -l)" -ge 3 ]; do sleep 0.1; done
	slurm_kill_node "$slurm" n1
	[ "$(find smooth -name '*.ply' | wc -l)" -lt 19 ]
	# Slurm may hold tasks of a lost node back for two minutes
	while kill -0 "$batch" 2>/dev/null; do
		for j in $(squeue -h -o '%i %r' | sed -n 's/ BeginTime$//p'); do
			scontrol update jobid="$j" StartTime=now || :
		done
		sleep 0.5
	done
	code=0
	wait $batch || code=$?
	[ $code = 1 ]
	grep -q '^lhbatch: 20 meshes in 4 tasks' out
	grep -q '^19 ok, 1 failed, 0 missing' out
	[ "$(wc -l <failed.tsv)" = 2 ]
	(cd "$tmp" && make -s -k -j2 2>/dev/null) || true
	[ "$(find smooth -name '*.ply' | wc -l)" = 19 ]
	for f in smooth/*.ply; do cmp "$f" "$tmp/$f"; done
	cp whole.ply scans/cap3.ply
	run -0 lhbatch --slurm --wait
	[[ $output == *'1 meshes in 1 tasks'* ]]
	[[ $output == *'20 ok, 0 failed, 0 missing'* ]]
	run -0 lhbatch --slurm --wait
	[[ $output != *tasks* ]]
}

teardown() {
	[ -z "${slurm:-}" ] || { slurm_down "$slurm"; rm -rf "$slurm"; }
}

@test "Snakefile: the same results and reports as batch.mk" {
	command -v snakemake >/dev/null || skip "no snakemake"
	meshes 4
	run lhbatch
	mv smooth by-make
	run snakemake -q -s "$here/scripts/Snakefile" --cores 2 --keep-going --config meshes='scans/*.ply' mesh2rect='-n 16'
	[ "$status" = 1 ]
	for f in by-make/*.ply; do cmp "$f" "smooth/${f##*/}"; done
	[ ! -e smooth/cap3.ply ]
	snakemake -q -s "$here/scripts/Snakefile" --cores 1 --config meshes='scans/*.ply' -- table
	[ "$(cut -f1,2 report.tsv | grep -c 'ok$')" = 3 ]
	grep -q $'^scans/cap3.ply\tfailed\t' failed.tsv
}
