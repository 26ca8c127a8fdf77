# grid2html.bats - a page of surfaces: what is in it, and in a browser what it does.

load helper

# What the page is made to do: a drag with the mouse from (200,200) to (320,210), and turns of the wheel.
drag="const c = renderer.domElement, e = (t, x, y) => [c, document].forEach(o => o.dispatchEvent(
	new MouseEvent(t, { clientX: x, clientY: y, button: 0 })));
	e('mousedown', 200, 200); e('mousemove', 320, 210); e('mouseup', 320, 210);"
wheel="for (let i = 0; i < 8; i++) renderer.domElement.dispatchEvent(new WheelEvent('wheel', { deltaY: -100 }));"

setup_file() {
	load helper
	mkmesh -n 500 face -o "$tmp/a.off"
	mkmesh -n 500 face nose=0.5 smile=0.5 -o "$tmp/b.off"
	mesh2rect -q -n 24 "$tmp/a.off" | grid2lh -o "$tmp/a"
	mesh2rect -q -n 24 "$tmp/b.off" | grid2lh -o "$tmp/b"
	lhinterp -q -n 4 "$tmp/a" "$tmp/b" -o "$tmp/lh"
	lh2grid -q "$tmp/lh" -o "$tmp/morph"
	mesh2rect -q --chart=sock -n 24 "$tmp/a.off" -o "$tmp/sock"
}

# three: skips the test if three.js is not installed.
three() {
	[ -e /usr/share/javascript/three/three.min.js ] || skip "no libjs-three"
}

@test "the page holds the surfaces and channels, and no address of a network" {
	three
	grid2html --colours="$tmp/lh" -c H --beside="$tmp/morph" --distance "$tmp/morph" -o "$tmp/page.html"
	PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=scripts /usr/bin/python3 - "$tmp/page.html" "$tmp/morph" "$tmp/lh" <<-'EOF'
		import base64, json, re, sys
		import numpy as np, lhg
		page = open(sys.argv[1], encoding="utf-8").read()
		d = json.loads(re.search(r"const DATA=(.*);\n", page).group(1))
		frames, lh = list(lhg.read(sys.argv[2])), list(lhg.read(sys.argv[3]))
		assert d["channel"] == "H" and len(d["surfaces"]) == 2
		s = d["surfaces"][0]
		assert s["frames"] == 4 and s["vertices"] == 625
		get = lambda t, kind: np.frombuffer(base64.b64decode(t), kind)
		xyz = get(s["xyz"], "<f4").reshape(4, 625, 3)
		f = {f["name"]: f for f in s["fields"]}
		for k in range(4):
		    want = np.stack([frames[k][c].ravel() for c in "xyz"], -1)
		    assert (xyz[k] == want.astype("f4")).all()
		    assert (get(f["H"]["values"], "<f4").reshape(4, -1)[k] == lh[k]["H"].ravel().astype("f4")).all()
		assert f["H"]["diverging"] == 1 and f["H"]["low"] == -f["H"]["high"]
		assert f["lambda"]["diverging"] == 0 and f["lambda"]["low"] > 0
		assert (get(f["distance"]["values"], "<f4") == 0).all()
		assert get(s["tri"], "<i4").max() == 624
		own = page[:page.index("<script>")] + page[page.index("const DATA"):]
		assert "http" not in own and "src=" not in own
	EOF
	grid2html --colours="$tmp/lh" -c H --beside="$tmp/morph" --distance "$tmp/morph" | cmp - "$tmp/page.html"
}

@test "a sock, a place, and what cannot be shown" {
	three
	grid2html "$tmp/sock" | grep -q '"vertices":'
	grid2html "$tmp/a" | grep -q '"name":"lambda"'          # of grid2lh: the place, and its lambda and H
	try 1 'no channel colour' /dev/null grid2html -c colour "$tmp/morph"
	try 1 'on a sock, .* is on a rectangle' /dev/null grid2html --colours="$tmp/sock" "$tmp/morph"
	try 1 'no distance between them' /dev/null grid2html --beside="$tmp/sock" --distance "$tmp/morph"
	try 2 'needs --beside' /dev/null grid2html --distance "$tmp/morph"
	try 1 'install libjs-three' /dev/null grid2html --three="$tmp" "$tmp/morph"
}

# shot FILE SCRIPT: the page in a browser, after SCRIPT, as a picture.
shot() {
	cp "$tmp/page.html" "$tmp/shot.html"
	echo "<script>window.addEventListener('load', function() { $2 });</script>" >>"$tmp/shot.html"
	HOME=$tmp timeout 100 chromium --headless --no-sandbox --disable-gpu --use-gl=angle --use-angle=swiftshader \
		--enable-unsafe-swiftshader --hide-scrollbars --window-size=600,400 --virtual-time-budget=3000 \
		--screenshot="$tmp/$1" "file://$tmp/shot.html" >/dev/null 2>&1
}

@test "in a browser it is not blank, turns under the mouse, and follows the slider and the colours" {
	three
	command -v chromium >/dev/null || skip "no chromium"
	grid2html --colours="$tmp/lh" -c H "$tmp/morph" -o "$tmp/page.html"
	shot start.png ''
	shot turned.png "$drag"
	shot near.png "$wheel"
	shot last.png "const s = document.getElementById('frame'); s.value = 3; s.dispatchEvent(new Event('input'));"
	shot lambda.png "const s = document.getElementById('field'); s.value = 'lambda'; s.dispatchEvent(new Event('change'));"
	awk 'NR > 2 && NF == 3 { $1 = $1/1000 + 50; $2 /= 1000; $3 /= 1000 } { print }' "$tmp/a.off" >"$tmp/moved.off"
	mesh2rect -q -n 24 "$tmp/moved.off" -o "$tmp/moved"
	grid2html --beside="$tmp/moved" "$tmp/morph" -o "$tmp/page.html"
	shot two.png ''
	shot two-turned.png "$drag"
	/usr/bin/python3 - "$tmp" <<-'EOF'
		import struct, sys, zlib
		import numpy as np
		def read(path):
		    b = open(path, "rb").read(); at, data = 8, b""
		    while at < len(b):
		        n, kind = struct.unpack(">I4s", b[at:at+8])
		        if kind == b"IHDR": w, h, depth, colour = struct.unpack(">IIBB", b[at+8:at+18])
		        if kind == b"IDAT": data += b[at+8:at+8+n]
		        at += 12 + n
		    c = {2: 3, 6: 4}[colour]
		    raw = np.frombuffer(zlib.decompress(data), np.uint8).reshape(h, w*c + 1).astype(int)
		    out = np.zeros((h, w*c), int)
		    for y in range(h):
		        up = out[y-1] if y else np.zeros(w*c, int)
		        f, line = raw[y, 0], raw[y, 1:]
		        if f == 2: out[y] = line + up & 255; continue
		        for x in range(w*c):
		            l, ul = (out[y, x-c], up[x-c]) if x >= c else (0, 0)
		            p = l + up[x] - ul
		            pick = min((abs(p-l), 0, l), (abs(p-up[x]), 1, up[x]), (abs(p-ul), 2, ul))[2]
		            out[y, x] = line[x] + {0: 0, 1: l, 3: (l + up[x])//2, 4: pick}[f] & 255
		    return out.reshape(h, w, c)[:340, :, :3]
		a, turned, near, last, other, two, both = (read("%s/%s.png" % (sys.argv[1], n)) for n in
		    ("start", "turned", "near", "last", "lambda", "two", "two-turned"))
		body = lambda p: (p.min(2) < 250)
		assert .05 < body(a).mean() < .9, body(a).mean()                # a surface on white
		changed = lambda p, q: (abs(p - q).max(2) > 24).mean()
		assert changed(a, turned) > .03 and changed(a, last) > .01 and changed(a, other) > .03
		assert (body(a) == body(other)).mean() > .99                    # the same outline in other colours
		assert body(near).mean() > 1.3*body(a).mean()
		half = lambda p: (p[30:, :300], p[30:, 300:])                   # below the names
		for p in two, both:
		    l, r = half(p)
		    assert body(l).mean() > .05 and (body(l) == body(r)).mean() > .98      # though one lies elsewhere, in metres
		assert all(changed(p, q) > .03 for p, q in zip(half(two), half(both)))
	EOF
}
