# properties.bats - the properties of the vertices of a PLY go along, from mesh2disk to grid2mesh.

load helper

# py CODE: python with numpy, and the functions of properties.py, in $tmp
py() { (here=$PWD/tests; cd "$tmp" && PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "from properties import *
$1"); }

setup_file() {
	load helper
	/usr/bin/python3 -c 'import numpy' 2>/dev/null || skip "numpy is not installed"
	py '
write("big.ply", "binary_big_endian")
write("little.ply", "binary_little_endian", nan=True)
write("ascii.ply", "ascii")
for form in "ascii", "binary_little_endian":
    write(form + "-lists.ply", form, lists=True)
    write(form + "-disk.ply", form, hole=False)'
}

@test "mesh2disk keeps every number of a vertex, with its type, and gives new vertices those of their neighbours" {
	for form in big little ascii; do
		mesh2disk -q "$tmp/$form.ply" -o "$tmp/disk.ply"
		py "check_disk('$form.ply', 'disk.ply')"
		mesh2disk -q "$tmp/disk.ply" -o "$tmp/again.ply"
		mesh2disk -q "$tmp/again.ply" -o "$tmp/third.ply"
		cmp "$tmp/again.ply" "$tmp/third.ply"
		py 'assert all(x.tobytes() == y.tobytes() for x, y in zip(read("disk.ply")[:2], read("again.ply")[:2]))'
	done
	mesh2disk -q "$tmp/big.ply" -o "$tmp/a.ply"
	mesh2disk -q "$tmp/ascii.ply" -o "$tmp/b.ply"
	cmp "$tmp/a.ply" "$tmp/b.ply"
}

@test "a disk with properties goes through, and again byte by byte, without a note" {
	for form in ascii binary_little_endian; do
		try 0 '' "$tmp/$form-disk.ply" mesh2disk
		mv "$tmp/out" "$tmp/once.ply"
		try 0 '' "$tmp/once.ply" mesh2disk
		cmp "$tmp/once.ply" "$tmp/out"
	done
}

@test "lists, and numbers of faces, are left out in one note" {
	for form in ascii binary_little_endian; do
		mesh2disk "$tmp/$form-lists.ply" -o "$tmp/lists.ply" 2>"$tmp/err"
		[ "$(grep -c 'left out: list weights at vertices, flags at faces$' "$tmp/err")" = 1 ]
		mesh2disk -q "$tmp/ascii.ply" -o "$tmp/disk.ply"
		cmp "$tmp/lists.ply" "$tmp/disk.ply"
	done
	mesh2disk "$tmp/ascii.ply" -o "$tmp/disk.off" 2>"$tmp/err"
	grep -q 'OFF has no place for the 17 properties of the vertices, PLY does$' "$tmp/err"
}

@test "names that mean something else, and names said twice, are left out" {
	printf '%s\n' ply 'format ascii 1.0' 'element vertex 3' 'property float x' 'property float y' 'property float z' \
		'property float uv' 'property float offset' 'property int k' 'property int k' 'property uchar byte' \
		"property float $(printf 'n%.0s' {1..64})" 'element face 1' 'property list uchar int vertex_indices' end_header \
		'0 0 0 5 6 7 8 2.5 1' '1 0 0 5 6 7 8 300 1' '0 1 0 5 6 -7 8 3 1' '3 0 1 2' >"$tmp/odd.ply"
	try 0 'left out: uv at vertices, offset at vertices, k at vertices, nnn.* at vertices$' "$tmp/odd.ply" mesh2disk
	grep -aq '^property int k$' "$tmp/out"
	grep -aq '^property double byte$' "$tmp/out"    # no byte can hold 2.5
	mv "$tmp/out" "$tmp/odd-disk.ply"
	py 'v = read("odd-disk.ply")[0]
assert v["byte"].tolist() == [2.5, 300, 3] and v["k"].tolist() == [7, 7, -7]'
}

@test "mesh2rect --uv and grid2mesh --on carry them, but for normals and texture coordinates" {
	mesh2disk -q "$tmp/little.ply" -o "$tmp/disk.ply"
	try 0 '' "$tmp/disk.ply" mesh2rect -n 16 --uv="$tmp/uv.ply"
	mv "$tmp/out" "$tmp/grid"
	py 'check_same("disk.ply", "uv.ply", 1)'
	mesh2rect -q -n 16 "$tmp/disk.ply" | lhinfo | grep -c channel >"$tmp/count"
	[ "$(cat "$tmp/count")" = 3 ]
	grid2mesh -q --on="$tmp/uv.ply" "$tmp/grid" -o "$tmp/back.ply"
	py 'check_same("disk.ply", "back.ply", 0)'
	grid2mesh -q --on="$tmp/uv.ply" --filled=keep "$tmp/grid" -o "$tmp/back.ply"
	py 'check_same("disk.ply", "back.ply", 1)'
	grid2mesh -q --on="$tmp/uv.ply" "$tmp/grid" -o "$tmp/back.glb"
	grid2mesh -q --on="$tmp/uv.ply" "$tmp/grid" -o "$tmp/back.vtp"
	grep -q 'Name="quality"' "$tmp/back.vtp"
	mesh2rect -q -n 16 --with="$tmp/big.ply" --uv="$tmp/uv.ply" "$tmp/disk.ply" | lhinfo >"$tmp/info"
	grep -q 'channel quality' "$tmp/info"
	py 'check_same("disk.ply", "uv.ply", 1)' 2>"$tmp/err" && return 1       # those of --with are written, as doubles
	grep -q AssertionError "$tmp/err"
	head -c 2000 "$tmp/uv.ply" | grep -aq '^property double quality$'
}

@test "a channel of the grid takes the place of a property of its name" {
	mesh2disk -q "$tmp/big.ply" | sed -b 's/^property float quality$/property float lambda/' >"$tmp/disk.ply"
	mesh2rect -q -n 16 --uv="$tmp/uv.ply" "$tmp/disk.ply" | grid2lh -q -o "$tmp/lh"
	grid2mesh -q --on="$tmp/uv.ply" --with=lambda "$tmp/lh" -o "$tmp/back.ply"
	[ "$(grep -ac '^property .* lambda$' "$tmp/back.ply")" = 1 ]
	grep -aq '^property double lambda$' "$tmp/back.ply"
	py 'assert (read("back.ply")[0]["lambda"] > 0).all()'
}
