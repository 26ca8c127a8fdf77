# keep.bats - grid2mesh --on --keep: a person's own file, with its vertices moved and all else as it was.

load helper

setup_file() {
	load helper
	# a textured OBJ of quads, with materials, groups, normals, colours and a comment
	/usr/bin/python3 - "$tmp" <<-'EOF'
		import math, sys
		n, out = 13, []
		out += ["# my model", "mtllib skin.mtl", "o face"]
		for j in range(n):
		    for i in range(n):
		        x, y = i/(n-1), j/(n-1)
		        out.append("v %.6f %.6f %.6f 0.5 0.25 1" % (x, y, .3*math.sin(3*x)*math.cos(2*y)))
		for k in range(n*n):
		    out.append("vt %.4f %.4f" % ((k % n)/(2*n), (k//n)/n + .1))
		for k in range(n*n):
		    out.append("vn 0 0 1")
		for j in range(n-1):
		    out += ["g row%d" % j, "usemtl m%d" % (j % 2), "s 1"]
		    for i in range(n-1):
		        q = [j*n+i+1, j*n+i+2, (j+1)*n+i+2, (j+1)*n+i+1]
		        out.append("f " + " ".join("%d/%d/%d" % (v, v, v) for v in q))
		open(sys.argv[1] + "/model.obj", "w").write("\n".join(out) + "\n")
	EOF
	mesh2rect -q -n 32 --uv="$tmp/uv.ply" "$tmp/model.obj" -o "$tmp/phi"
	grid2lh "$tmp/phi" | lhfft --scale=40% | lh2grid -q -o "$tmp/smooth"
}

@test "an OBJ keeps vt, materials, groups, colours, quads and order; v and vn change" {
	grid2mesh --on "$tmp/uv.ply" --keep="$tmp/model.obj" "$tmp/smooth" -o "$tmp/new.obj"
	diff <(grep -v '^vn\? ' "$tmp/model.obj") <(grep -v '^vn\? ' "$tmp/new.obj")
	[ "$(grep -c '^v .* 0.5 0.25 1$' "$tmp/new.obj")" = 169 ]
	grid2mesh --on "$tmp/uv.ply" "$tmp/smooth" -o "$tmp/plain.off"
	below "$(error_of "$tmp/plain.off" "$tmp/new.obj" max_rel)" 1e-12
	below 1e-3 "$(error_of "$tmp/model.obj" "$tmp/new.obj" max_rel)"
	awk '$1 == "vn" { l = sqrt($2^2 + $3^2 + $4^2); if (l < .999999 || l > 1.000001) exit 1; if ($2^2 > .001) tilted++ }
		END { exit tilted < 50 }' "$tmp/new.obj"
}

@test "at K = 0 the vertices come back, and the file but for its normals" {
	grid2mesh --on "$tmp/uv.ply" --keep="$tmp/model.obj" "$tmp/phi" -o "$tmp/same.obj"
	below "$(error_of "$tmp/model.obj" "$tmp/same.obj" max_rel)" 1e-9
}

@test "a PLY keeps its other properties, ascii and binary of both byte orders" {
	/usr/bin/python3 - "$tmp" <<-'EOF'
		import struct, sys
		d = sys.argv[1]
		v = [list(map(float, l.split()[1:4])) for l in open(d + "/model.obj") if l.startswith("v ")]
		f = [[int(w.split("/")[0]) - 1 for w in l.split()[1:]] for l in open(d + "/model.obj") if l.startswith("f ")]
		def head(form):
		    return ("ply\nformat %s 1.0\ncomment mine\nelement vertex %d\nproperty float quality\nproperty double x\n"
		        "property double y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
		        "property uchar red\nelement face %d\nproperty uchar flag\nproperty list uchar int vertex_indices\n"
		        "end_header\n" % (form, len(v), len(f)))
		for e, form in ("<", "binary_little_endian"), (">", "binary_big_endian"):
		    b = head(form).encode()
		    for k, x in enumerate(v):
		        b += struct.pack(e + "fddffffB", k, *x, 0, 0, 1, k % 256)
		    for q in f:
		        b += struct.pack(e + "BB4i", 7, 4, *q)
		    open("%s/%s.ply" % (d, form), "wb").write(b)
		t = head("ascii")
		for k, x in enumerate(v):
		    t += "%d %.6f %.6f %.6f 0 0 1 %d\n" % (k, *x, k % 256)
		for q in f:
		    t += "7 4 %d %d %d %d\n" % tuple(q)
		open(d + "/ascii.ply", "w").write(t)
	EOF
	for form in ascii binary_little_endian binary_big_endian; do
		grid2mesh --on "$tmp/uv.ply" --keep="$tmp/$form.ply" "$tmp/smooth" -o "$tmp/new.ply"
		below "$(error_of "$tmp/new.obj" "$tmp/new.ply" max_rel)" 1e-6
		/usr/bin/python3 - "$tmp/$form.ply" "$tmp/new.ply" <<-'EOF'
			import struct, sys
			a, b = (open(p, "rb").read() for p in sys.argv[1:])
			i = a.index(b"end_header\n") + 11
			assert a[:i] == b[:i]                           # the header
			if b"ascii" in a[:i]:
			    a, b = a[i:].decode().split("\n"), b[i:].decode().split("\n")
			    assert a[169:] == b[169:]
			    for x, y in zip(a[:169], b):
			        x, y = x.split(), y.split()
			        assert len(y) == 8 and x[0] == y[0] and x[7] == y[7]
			        assert abs(sum(float(n)**2 for n in y[4:7]) - 1) < 1e-6
			else:
			    e = ">" if b"big" in a[:i] else "<"
			    assert len(a) == len(b) and a[i+169*37:] == b[i+169*37:]
			    for k in range(169):
			        x, y = (struct.unpack_from(e + "fddffffB", t, i + 37*k) for t in (a, b))
			        assert x[0] == y[0] and x[7] == y[7] and abs(sum(n*n for n in y[4:7]) - 1) < 1e-6
		EOF
	done
}

@test "files that do not fit are refused" {
	mkmesh -n 50 cap -o "$tmp/other.obj"
	try 1 'the file has .* vertices, the mesh with \(u,v\) has 169' /dev/null \
		grid2mesh --on "$tmp/uv.ply" --keep="$tmp/other.obj" "$tmp/phi" -o "$tmp/no.obj"
	grid2mesh --on "$tmp/uv.ply" "$tmp/phi" -o "$tmp/other.off"
	try 1 'it is no OBJ or PLY' /dev/null grid2mesh --on "$tmp/uv.ply" --keep="$tmp/other.off" "$tmp/phi" -o "$tmp/no.obj"
	try 1 'is no PLY' /dev/null grid2mesh --on "$tmp/uv.ply" --keep="$tmp/model.obj" "$tmp/phi" -o "$tmp/no.ply"
	try 2 'need -o FILE that ends in .obj or .ply' /dev/null \
		grid2mesh --on "$tmp/uv.ply" --keep="$tmp/model.obj" "$tmp/phi" -o "$tmp/no.off"
	try 2 'needs --on' /dev/null grid2mesh --keep="$tmp/model.obj" "$tmp/phi" -o "$tmp/no.obj"
	sed 's/^v 0.000000 /v \\\n0.000000 /' "$tmp/model.obj" >"$tmp/long.obj"
	try 1 'continued by' /dev/null grid2mesh --on "$tmp/uv.ply" --keep="$tmp/long.obj" "$tmp/phi" -o "$tmp/no.obj"
	[ ! -e "$tmp/no.obj" ]
}

@test "the file that mesh2disk mended: welded vertices move together, parts left out stay, and this is noted" {
	# the model cut in two along a row, the vertices there twice, and a triangle apart
	/usr/bin/python3 - "$tmp" <<-'EOF'
		import sys
		d, n = sys.argv[1], 13
		L = open(d + "/model.obj").read().split("\n")
		v = [l for l in L if l.startswith("v ")]
		out = v + v[6*n:7*n] + ["v 5 5 5", "v 6 5 5", "v 5 6 5"] + ["vt 0 0", "usemtl skin"]
		for l in L:
		    if l.startswith("f "):
		        k = [int(w.split("/")[0]) for w in l.split()[1:]]
		        if max(k) > 7*n:
		            k = [i - 6*n + n*n if 6*n < i <= 7*n else i for i in k]
		        out.append("f " + " ".join("%d/1" % i for i in k))
		out.append("f 183/1 184/1 185/1")
		open(d + "/cut.obj", "w").write("\n".join(out) + "\n")
	EOF
	mesh2disk -q "$tmp/cut.obj" -o "$tmp/cut.ply"
	mesh2rect -q -n 32 --uv="$tmp/cut-uv.ply" "$tmp/cut.ply" -o "$tmp/cut.lhg"
	try 0 'cut.obj: 3 of 185 vertices are not in .*cut-uv.ply and stay' "$tmp/cut.lhg" \
	    grid2mesh --on "$tmp/cut-uv.ply" --keep="$tmp/cut.obj" -o "$tmp/back.obj"
	below "$(error_of "$tmp/cut.obj" "$tmp/back.obj" max_rel)" 1e-9
	grid2lh "$tmp/cut.lhg" | lhfft --scale=40% | lh2grid -q |
		grid2mesh -q --on "$tmp/cut-uv.ply" --keep="$tmp/cut.obj" -o "$tmp/cut-smooth.obj"
	diff <(grep -v '^vn\? ' "$tmp/cut.obj") <(grep -v '^vn\? ' "$tmp/cut-smooth.obj")
	cmp <(sed -n '79,91p' "$tmp/cut-smooth.obj") <(sed -n '170,182p' "$tmp/cut-smooth.obj")
	cmp -s <(sed -n '79,91p' "$tmp/cut-smooth.obj") <(sed -n '79,91p' "$tmp/cut.obj") && false
	grep -q '^v 5 6 5' "$tmp/cut-smooth.obj"
}

@test "a real textured head in 43 pieces keeps its texture, and comes back at K = 0" {
	head=$meshes/formats/ict_face_quads_uv.obj
	[ -e "$head" ] || skip "no meshes in $meshes"
	mesh2disk -q --weld=auto "$head" -o "$tmp/head.ply"
	mesh2rect -q -n 64 --uv="$tmp/head-uv.ply" "$tmp/head.ply" -o "$tmp/head"
	grid2mesh -q --on "$tmp/head-uv.ply" --keep="$head" "$tmp/head" -o "$tmp/head.obj"
	diff -q <(grep -v '^vn\? ' "$head") <(grep -v '^vn\? ' "$tmp/head.obj")
	below "$(error_of "$head" "$tmp/head.obj" max_rel)" 1e-9
}
