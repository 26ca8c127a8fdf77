# loss.bats - how much of its mesh a grid loses: what mesh2rect measures, notes and refuses.

load helper

setup_file() {
	load helper
	mkmesh -n 2000 cap -o "$tmp/cap.off"
	rod 15 >"$tmp/rod.off"
	rod 100 >"$tmp/long.off"
}

# rod N: prints a mesh: a disk of radius 1 from whose middle a rod of radius .2 and length .04 N rises,
# closed by a tip.
rod() {
	/usr/bin/python3 - "$1" <<-'END'
		import math, sys
		m, n = 40, int(sys.argv[1])
		rings = [(1 - .1*i, 0) for i in range(8)] + [(.2, .04*i) for i in range(1, n + 1)] + [(.1, .04*n + .05)]
		v = [(r*math.cos(2*math.pi*i/m), r*math.sin(2*math.pi*i/m), z) for r, z in rings for i in range(m)]
		f = []
		for k in range(len(rings) - 1):
		    for i in range(m):
		        a, b = k*m + i, k*m + (i + 1) % m
		        f += [(a, b, b + m), (a, b + m, a + m)]
		last = (len(rings) - 1)*m
		f += [(last + i, last + (i + 1) % m, len(v)) for i in range(m)]
		v.append((0, 0, .04*n + .07))
		print('OFF\n%d %d 0' % (len(v), len(f)))
		for p in v:
		    print('%.17g %.17g %.17g' % p)
		for t in f:
		    print('3 %d %d %d' % t)
	END
}

meta() {
	lhinfo --json "$1" | /usr/bin/python3 -c 'import json, sys; print(json.load(sys.stdin)["meta"][sys.argv[1]])' "$2"
}

@test "an independent program computes the same area, kept and farthest" {
	mesh2rect -q -n 20x30 "$tmp/rod.off" -o "$tmp/rod"
	/usr/bin/python3 - "$tmp/rod" "$tmp/rod.off" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg, numpy as np
		g = next(iter(lhg.read(sys.argv[1])))
		X = np.stack([np.array(g[c]) for c in 'xyz'], -1)
		a, b, c, d = (s.reshape(-1, 3) for s in (X[:-1, :-1], X[:-1, 1:], X[1:, 1:], X[1:, :-1]))
		length = lambda x: np.linalg.norm(x, axis=-1)
		bd = (length(b - d) < length(a - c))[:, None]
		T = np.concatenate([np.stack([a, b, np.where(bd, d, c)], 1), np.stack([np.where(bd, b, a), c, d], 1)])
		area = lambda t: length(np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])).sum()/2
		w = open(sys.argv[2]).read().split()
		nv = int(w[1])
		x = np.array(w[4:4 + 3*nv], float).reshape(-1, 3)
		A = area(x[np.array(w[4 + 3*nv:], int).reshape(-1, 4)[:, 1:]])

		def segment(p, a, e):
		    s = np.clip(((p - a)*e).sum(-1)/(e*e).sum(-1), 0, 1)
		    return length(p - a - s[:, None]*e)

		def distance(p):
		    far = [segment(p, T[:, k], T[:, (k + 1) % 3] - T[:, k]) for k in range(3)]
		    n = np.cross(T[:, 1] - T[:, 0], T[:, 2] - T[:, 0])
		    inside = [(np.cross(T[:, (k + 1) % 3] - T[:, k], p - T[:, k])*n).sum(-1) > 0 for k in range(3)]
		    flat = np.where(np.all(inside, 0), abs(((p - T[:, 0])*n).sum(-1))/length(n), np.inf)
		    return min(np.min(far), flat.min())

		want = {'area': A, 'kept': area(T)/A, 'farthest': max(map(distance, x))/A**.5}
		for key, value in want.items():
		    assert abs(float(g.meta[key]) - value) < 1e-5*value, (key, g.meta[key], value)
	END
}

@test "a loss above 1 % is noted with its place and what helps; -q is silent" {
	try 0 '' "$tmp/cap.off" mesh2rect -n 128
	try 0 'the grid holds [89][0-9.]* % of the area; the vertex at \(.* [.0-9]*\) is .* away: --chart=sock \(chi\^2 [0-9.]*, on the rectangle [0-9.]*\), more cells \(-n auto\), other corners' \
	    "$tmp/rod.off" mesh2rect -n 32 --max-loss=1
	try 0 '' "$tmp/rod.off" mesh2rect -q -n 32 --max-loss=1
}

@test "--max-loss refuses, and leaves no --uv" {
	try 1 'the grid holds only .*: --max-loss=0.05' "$tmp/rod.off" mesh2rect -n 32 --max-loss=.05 --uv="$tmp/rod.ply"
	[ ! -e "$tmp/rod.ply" ]
	try 1 'the grid holds only [0-4][0-9.]* % .*: --max-loss=0.5' "$tmp/long.off" mesh2rect -n 32
	try 2 'max-loss' /dev/null mesh2rect --max-loss=2
	cmp <(mesh2rect -q -n 8 --no-history "$tmp/rod.off") <(mesh2rect -q -n 8 --no-history --max-loss=1 "$tmp/rod.off")
}

@test "-n auto takes the fewest cells that keep 99 %, at most --max-cells" {
	mesh2rect -n auto "$tmp/cap.off" -o "$tmp/cap"
	[ "$(sed -n 's/^size //p' "$tmp/cap" | head -1)" = "33 33" ]
	mesh2rect -q -n auto --max-cells=512 "$tmp/rod.off" -o "$tmp/rod"
	n=$(sed -n 's/^size \([0-9]*\) .*/\1/p' "$tmp/rod" | head -1)
	n=$((n - 1))
	[ $n -gt 64 ]
	below .99 "$(meta "$tmp/rod" kept)"
	cmp <(mesh2rect -q --no-history -n $n "$tmp/rod.off") <(mesh2rect -q --no-history -n auto --max-cells=512 "$tmp/rod.off")
	[ $((n % 3)) = 0 ] && fewer=$((n*2/3)) || fewer=$((n*3/4))
	below "$(mesh2rect -q --max-loss=1 -n $fewer "$tmp/rod.off" | sed -n 's/^meta kept //p')" .99
	try 0 'the grid holds' "$tmp/rod.off" mesh2rect -n auto --max-cells=40 --max-loss=1
	[ "$(sed -n 's/^size //p' "$tmp/out" | head -1)" = "41 41" ]
	try 2 'max-cells' /dev/null mesh2rect -n auto --max-cells=3
}

@test "the same for any number of threads" {
	OMP_NUM_THREADS=1 mesh2rect -q -n auto --max-cells=64 --max-loss=1 "$tmp/rod.off" -o "$tmp/one"
	OMP_NUM_THREADS=3 mesh2rect -q -n auto --max-cells=64 --max-loss=1 "$tmp/rod.off" | cmp "$tmp/one"
}
