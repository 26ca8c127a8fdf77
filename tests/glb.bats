# glb.bats - grid2mesh -o FILE.glb: a surface, or a stream as morph targets, in glTF 2.

load helper

setup_file() {
	load helper
	mkmesh -n 500 face -o "$tmp/a.off"
	mkmesh -n 500 face nose=0.5 smile=0.5 -o "$tmp/b.off"
	mesh2rect -q -n 24 --uv="$tmp/uv.ply" "$tmp/a.off" -o "$tmp/phi"
	grid2lh "$tmp/phi" -o "$tmp/a"
	mesh2rect -q -n 24 "$tmp/b.off" | grid2lh -o "$tmp/b"
	lhinterp -q -n 4 "$tmp/a" "$tmp/b" | lh2grid -q -o "$tmp/morph"
	mkdir "$tmp/frame"
	grid2mesh "$tmp/morph" -o "$tmp/frame/%d.off"
	grid2mesh "$tmp/morph" --seconds=6 -o "$tmp/morph.glb"
}

@test "the first frame is the mesh, as our own reader sees it" {
	below "$(error_of "$tmp/frame/1.off" "$tmp/morph.glb" max_rel)" 1e-6
	grid2mesh --on "$tmp/uv.ply" "$tmp/phi" -o "$tmp/on.glb"
	below "$(error_of "$tmp/a.off" "$tmp/on.glb" max_rel)" 1e-6
}

@test "targets, weights and times give every frame" {
	PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 - "$tmp/morph.glb" "$tmp/frame" <<-'EOF'
		import json, struct, sys
		import numpy as np
		b = open(sys.argv[1], "rb").read()
		assert b[:4] == b"glTF" and struct.unpack("<II", b[4:12]) == (2, len(b))
		n = struct.unpack("<I", b[12:16])[0]
		j, data = json.loads(b[20:20+n]), b[28+n:]
		def get(k):
		    a = j["accessors"][k]; v = j["bufferViews"][a["bufferView"]]
		    w = {"SCALAR": 1, "VEC3": 3}[a["type"]]
		    x = np.frombuffer(data, {5126: "<f4", 5125: "<u4"}[a["componentType"]], a["count"]*w, v["byteOffset"])
		    if "min" in a:
		        assert np.allclose(x.reshape(-1, w).min(0), a["min"]) and np.allclose(x.reshape(-1, w).max(0), a["max"])
		    return x.reshape(-1, w)
		p = j["meshes"][0]["primitives"][0]
		s = j["animations"][0]["samplers"][0]
		t, w = get(s["input"]).ravel(), get(s["output"]).reshape(4, 3)
		assert np.allclose(t, [0, 2, 4, 6]) and (w == np.eye(4)[:, 1:]).all()
		base, normal = get(p["attributes"]["POSITION"]), get(p["attributes"]["NORMAL"])
		assert abs(np.linalg.norm(normal, axis=1) - 1).max() < 1e-5
		for k in range(4):
		    lines = open("%s/%d.off" % (sys.argv[2], k + 1)).read().split("\n")
		    at = next(i for i, l in enumerate(lines) if l.split()[:1] == ["625"])
		    x = np.array([l.split() for l in lines[at+1:at+626]], float)
		    y = base + sum(w[k, l]*get(p["targets"][l]["POSITION"]) for l in range(3))
		    assert abs(x - y).max() < 1e-5*abs(x).max()
		    m = normal + sum(w[k, l]*get(p["targets"][l]["NORMAL"]) for l in range(3))
		    assert abs(np.linalg.norm(m, axis=1) - 1).max() < 1e-5
	EOF
}

@test "a stream with lambda and H: the place is the surface of every frame, coloured by the first" {
	grid2lh "$tmp/morph" -o "$tmp/morph.lh"
	grid2mesh --with=H "$tmp/morph.lh" -o "$tmp/h.glb"
	below "$(error_of "$tmp/frame/1.off" "$tmp/h.glb" max_rel)" 1e-6
	grep -aq '"COLOR_0":1' "$tmp/h.glb"
	[ "$(grep -ao '"targets":.*"weights":\[[0,]*\]' "$tmp/h.glb" | grep -o POSITION | wc -l)" = 3 ]
}

@test "colours of a channel; equal bytes; what does not fit is refused" {
	grid2mesh --with=H "$tmp/a" -o "$tmp/c.glb"
	grep -aq '"COLOR_0":1' "$tmp/c.glb"
	grid2mesh --with=H "$tmp/a" -o "$tmp/d.glb"
	cmp "$tmp/c.glb" "$tmp/d.glb"
	try 2 'colours of one channel' /dev/null grid2mesh --with=H,lambda "$tmp/a" -o "$tmp/no.glb"
	{ cat "$tmp/morph"; mesh2rect -q -n 16 "$tmp/a.off"; } >"$tmp/mixed"
	try 1 'frame 5 has 289 vertices, the first 625' /dev/null grid2mesh "$tmp/mixed" -o "$tmp/no.glb"
	head -c 30000 "$tmp/morph" >"$tmp/cut"
	try 1 'ends' /dev/null grid2mesh "$tmp/cut" -o "$tmp/no.glb"
	[ ! -e "$tmp/no.glb" ]
}

@test "gltf-validator finds no error and no warning" {
	command -v node >/dev/null || skip "no node"
	(cd "$tmp" && node -e 'require("gltf-validator")' 2>/dev/null) || skip "no gltf-validator"
	grid2mesh --with=H "$tmp/a" -o "$tmp/c.glb"
	for f in morph c; do
		(cd "$tmp" && node -e 'const v = require("gltf-validator"), fs = require("fs");
			v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1]))).then(r =>
				process.exit(r.issues.numErrors + r.issues.numWarnings))' "$f.glb")
	done
}
