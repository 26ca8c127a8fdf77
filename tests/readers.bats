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

# outside FILE.off FOLDER: writes its mesh to the folder as ext.gltf with my%20mesh.bin, ext.gii with ext.dat, and in.gltf and in.gii, which
# have all inside.  Triangles come first in ext.dat.
outside() {
	(cd "$2" && python3 -c '
import base64, json, struct, sys
words = open(sys.argv[1]).read().split()
nv, nf = int(words[1]), int(words[2])
xyz = struct.pack(f"<{3*nv}f", *map(float, words[4:4 + 3*nv]))
tri = struct.pack(f"<{3*nf}i", *(int(w) for i, w in enumerate(words[4 + 3*nv:]) if i % 4))
def gltf(name, uri):
	json.dump({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
		"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
		"accessors": [{"bufferView": 0, "componentType": 5126, "count": nv, "type": "VEC3"},
			{"bufferView": 1, "componentType": 5125, "count": 3*nf, "type": "SCALAR"}],
		"bufferViews": [{"buffer": 0, "byteLength": len(xyz)}, {"buffer": 0, "byteOffset": len(xyz), "byteLength": len(tri)}],
		"buffers": [{"byteLength": len(xyz + tri), "uri": uri}]}, open(name, "w"))
def gifti(name, one, two):
	part = "<DataArray Intent=\"NIFTI_INTENT_{}\" DataType=\"NIFTI_TYPE_{}\" ArrayIndexingOrder=\"RowMajorOrder\" " \
		"Dimensionality=\"2\" Dim0=\"{}\" Dim1=\"3\" Endian=\"LittleEndian\" {}</Data></DataArray>\n"
	open(name, "w").write("<?xml version=\"1.0\"?>\n<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">\n" +
		part.format("POINTSET", "FLOAT32", nv, one) + part.format("TRIANGLE", "INT32", nf, two) + "</GIFTI>\n")
external = "Encoding=\"ExternalFileBinary\" ExternalFileName=\"ext.dat\" ExternalFileOffset=\"{}\"><Data>"
inside = "Encoding=\"Base64Binary\" ExternalFileName=\"\" ExternalFileOffset=\"\"><Data>"
open("my mesh.bin", "wb").write(xyz + tri)
open("ext.dat", "wb").write(tri + xyz + b"and more")
gltf("ext.gltf", "my%20mesh.bin")
gltf("in.gltf", "data:application/octet-stream;base64," + base64.b64encode(xyz + tri).decode())
gifti("ext.gii", external.format(len(tri)), external.format(0))
gifti("in.gii", inside + base64.b64encode(xyz).decode(), inside + base64.b64encode(tri).decode())
' "$1")
}

# grid_of FILE: the grid of a mesh file without the command lines.
grid_of() { mesh2rect -q --no-history -n 16 "$1"; }

@test "buffers of glTF and arrays of GIFTI in files beside the mesh are read, from the folder of the mesh" {
	mkdir -p "$tmp/dir/sub"
	mkmesh -n 300 rectangle >"$tmp/a.off"
	outside "$tmp/a.off" "$tmp/dir"
	cd "$tmp"
	for f in gltf gii; do
		grid_of dir/in.$f >in.lhg
		grid_of dir/ext.$f | cmp in.lhg -
		grid_of "$tmp/dir/ext.$f" | cmp in.lhg -
		(cd dir && grid_of ext.$f | cmp ../in.lhg -)
		(cd dir/sub && grid_of ../ext.$f | cmp ../../in.lhg -)
		gzip -c dir/ext.$f >dir/packed.$f
		grid_of dir/packed.$f | cmp in.lhg -
		mesh2disk -q dir/in.$f -o in.ply
		mesh2disk -q dir/ext.$f -o out.ply
		cmp in.ply out.ply
		lhdiff -q dir/ext.$f dir/in.$f
	done
	if /usr/bin/python3 -c 'import nibabel' 2>/dev/null; then
		/usr/bin/python3 -c '
import nibabel, sys
a, b = (nibabel.load(f) for f in sys.argv[1:])
assert all((x.data == y.data).all() for x, y in zip(a.darrays, b.darrays))' dir/ext.gii dir/in.gii
	fi
}

@test "files beside the mesh that are missing, short, elsewhere or no files are refused in one line" {
	mkdir -p "$tmp/dir"
	mkmesh -n 300 rectangle >"$tmp/a.off"
	outside "$tmp/a.off" "$tmp/dir"
	cd "$tmp/dir"
	try 1 "stdin: buffer 0 is in another file, 'my mesh.bin', which cannot be found from a pipe: give the name" \
		ext.gltf mesh2rect
	try 1 "stdin: array 0 is in another file, 'ext.dat', which cannot be found from a pipe" ext.gii mesh2disk
	sed 's|my%20mesh|../dir/my%20mesh|' ext.gltf >up.gltf
	try 1 "up.gltf: buffer 0 is in '../dir/my mesh.bin', which is read only from the folder of the mesh" /dev/null mesh2rect up.gltf
	sed "s|ext.dat|$tmp/dir/ext.dat|" ext.gii >abs.gii
	try 1 "abs.gii: array 0 is in '/.*', which is read only from the folder of the mesh" /dev/null mesh2rect abs.gii
	truncate -s -9 ext.dat
	try 1 "ext.gii: array 0 is in 'ext.dat' beside the mesh, which has .* bytes from .* on, need " /dev/null mesh2rect ext.gii
	truncate -s 100G ext.dat                # far more than is read
	mesh2rect -q -n 16 ext.gii >/dev/null
	truncate -s 100 'my mesh.bin'
	try 1 "ext.gltf: buffer 0 is in 'my mesh.bin' beside the mesh, which has 100 bytes from 0 on" /dev/null mesh2rect ext.gltf
	rm 'my mesh.bin' ext.dat
	try 1 "ext.gltf: buffer 0 is in 'my mesh.bin' beside the mesh: No such file" /dev/null mesh2rect ext.gltf
	try 1 "ext.gltf: .*No such file" /dev/null lhdiff ext.gltf in.gltf
	mkdir ext.dat
	try 1 "ext.gii: array 0 is in 'ext.dat' beside the mesh: no regular file" /dev/null mesh2rect ext.gii
	mkfifo 'my mesh.bin'
	try 1 "ext.gltf: buffer 0 is in 'my mesh.bin' beside the mesh: no regular file" /dev/null mesh2rect ext.gltf
}
