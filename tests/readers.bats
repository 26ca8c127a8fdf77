# readers.bats - mesh formats: equal to what independent readers read; what a file says of its coordinates.

load helper

@test "sample files are read as nibabel, meshio and numpy read them" {
	[ -d "$meshes/formats" ] || skip "no folder $meshes/formats"
	local f status=0
	for f in "$meshes"/formats/*; do
		case $f in *.mat) continue ;; esac
		set -- "$@" "$f"
	done
	/usr/bin/python3 tests/readers.py "$BUILD/tests/meshdump" "$@" >"$tmp/out" || status=$?
	cat "$tmp/out"
	[ $status != 77 ] || skip "$(cat "$tmp/out")"
	[ $status = 0 ]
}

# freesurfer FILE: writes the mesh FILE.off as a FreeSurfer surface with a volume geometry.
freesurfer() {
	python3 -c '
import struct, sys
words = open(sys.argv[1]).read().split()
nv, nf = int(words[1]), int(words[2])
xyz = list(map(float, words[4:4 + 3*nv]))
faces = [int(w) for i, w in enumerate(words[4 + 3*nv:]) if i % 4]
sys.stdout.buffer.write(b"\xff\xff\xfeby a test\n\n" + struct.pack(">2i", nv, nf) + struct.pack(f">{3*nv}f", *xyz) +
	struct.pack(f">{3*nf}i", *faces) + struct.pack(">3i", 2, 0, 20) + b"valid = 1\nfilename = T1.mgz\nvolume = 256 256 256\n"
	b"voxelsize = 1 1 1\nxras = -1 0 0\nyras = 0 0 -1\nzras = 0 1 0\ncras = 5.5 -17.25 18\n")' "$1"
}

@test "space, c_ras and unit of a FreeSurfer surface go into the grid, along the pipeline, into PLY and OBJ and back" {
	local f
	mkmesh -n 300 rectangle >"$tmp/a.off"
	freesurfer "$tmp/a.off" >"$tmp/lh.a"
	mesh2rect -q -n 16 "$tmp/lh.a" | grid2lh | lhfft -K 1 >"$tmp/lh"
	lhinfo "$tmp/lh" >"$tmp/info"
	grep -q 'space .*tkras' "$tmp/info"
	grep -q 'c_ras .*5.5 -17.25 18' "$tmp/info"
	grep -q 'unit .*mm' "$tmp/info"
	grep -q 'source .*FreeSurfer' "$tmp/info"
	grep -q 'fs.xras .*-1 0 0' "$tmp/info"
	lh2grid "$tmp/lh" -o "$tmp/phi"
	for f in ply obj; do            # and out again, and in again
		grid2mesh "$tmp/phi" -o "$tmp/b.$f"
		grep -aq 'lhgrid fact c_ras 5.5 -17.25 18$' "$tmp/b.$f"
		mesh2rect -q -n 16 "$tmp/b.$f" | lhinfo >"$tmp/again"
		grep -q 'c_ras .*5.5 -17.25 18' "$tmp/again"
		grep -q 'fs.xras .*-1 0 0' "$tmp/again"
	done
	mesh2rect -q -n 16 --uv="$tmp/uv.obj" "$tmp/lh.a" >"$tmp/grid"
	grid2mesh --on="$tmp/uv.obj" "$tmp/grid" -o "$tmp/on.obj"
	grep -q 'lhgrid fact space tkras$' "$tmp/uv.obj"
	[ "$(grep -c 'lhgrid fact space tkras$' "$tmp/on.obj")" = 1 ]
	gzip -c "$tmp/lh.a" | mesh2rect -q -n 16 | cmp - <(mesh2rect -q -n 16 <"$tmp/lh.a")
}

@test "a comment of a mesh file sets no other metadata than these" {
	mkmesh -n 100 rectangle -o "$tmp/c.obj"
	{ echo '# lhgrid fact vertices 7'; echo '# lhgrid fact space scanner'; echo '# lhgrid fact fs.X y'; cat "$tmp/c.obj"; } >"$tmp/d.obj"
	mesh2rect -q -n 8 "$tmp/d.obj" | lhinfo >"$tmp/info"
	grep -q 'space .*scanner' "$tmp/info"
	run ! grep -Eq 'vertices +7$|fs.X' "$tmp/info"
}
