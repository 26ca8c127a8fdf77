# tutorial.bats - the commands of doc/tutorial.md run in order and give the results on the page.

load helper

@test "every command of the tutorial runs, from an installation" {
	local work=$tmp/tutorial root=$tmp/root/usr
	! sanitized || skip "what is installed has no sanitizers"
	mkdir -p "$work"
	(unset MAKEFLAGS MFLAGS MAKELEVEL; make -s BUILD="$BUILD" DESTDIR="$tmp/root" PREFIX=/usr install)
	PATH=$root/bin:${PATH#*:}               # the installed programs, not those of the source folder
	if [ -d "$meshes/good" ]; then
		cp "$meshes/good/face_man_scan_6k.off" "$work/face.off"
		cp "$meshes/good/face_nefertiti_4.6k.off" "$work/other.off"
	else
		mkmesh -q -n 4000 face -o "$work/face.off"
		mkmesh -q -n 4000 face nose=0.5 smile=0.5 -o "$work/other.off"
	fi
	sed -n '/^```make$/,/^```$/{/^```/d;p}' doc/tutorial.md >"$work/Makefile"
	{
		echo "set -e; lhgrid='$root/share/lhgrid'"
		sed -n '/^```sh$/,/^```$/{/^```/d;/^lhgrid=/d;/^PATH=/d;p}' doc/tutorial.md
	} >"$work/steps.sh"
	[ "$(wc -l <"$work/steps.sh")" -ge 25 ]
	cd "$work"
	PYTHONDONTWRITEBYTECODE=1 sh steps.sh >out 2>err || { tail -n 5 err; false; }
	for made in face.png map.png lambda.png H.png fields.png all.png morph.png figure.png smooth.obj scale-4.off smooth/other.off figure.txt; do
		[ -s $made ] || { echo "not made: $made"; false; }
	done
	# The error of step 5 is below the bound that it names, 2 %.
	below "$(error_of face.lhg back.lhg max_rel)" 0.02
	# The picture of step 8 has the five surfaces of the stream.
	[ "$(lhinfo morph.lhg | grep -c 'frame . of 5')" = 5 ]
}

@test "the tutorial shows pictures that exist, and names no folder of one machine" {
	for picture in $(sed -n 's/.*!\[.*\](\([^)]*\)).*/\1/p' doc/tutorial.md); do
		[ -s "doc/$picture" ] || { echo "no picture $picture"; false; }
	done
	run ! grep -nE '/work|/tmp|/home/' doc/tutorial.md
}
