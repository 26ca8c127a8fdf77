# paper.bats - the report of scripts/paper is complete or absent.  For speed the tests use surfaces of
# mkmesh and small grids.

load helper

@test "paper writes its report and every picture that the report shows, and nothing else" {
	case $BUILD in */*) skip "the commands have their own tests under sanitizers" ;; esac
	local picture
	OMP_NUM_THREADS=1 LHGRID_MESHES=$tmp/none TMPDIR=$tmp/none scripts/paper "$tmp/paper" 32 6 100
	for picture in $(sed -n 's/^!\[.*\](\(.*\))$/\1/p' "$tmp/paper/report.md"); do
		[ "$(head -c 8 "$tmp/paper/$picture" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ]
		echo "$picture" >>"$tmp/pictures"
	done
	[ "$(grep -c ^figure "$tmp/pictures")" -ge 13 ]
	[ "$(ls "$tmp/paper" | grep -vFf "$tmp/pictures" | tr '\n' ' ')" = "report.md times.md work " ]
	# Four tables have six numbers in each of seven rows, the scales K and six surfaces; one in three rows.
	# Seventeen promises are listed; those tested below hold also on these surfaces and small grids.
	[ "$(grep -cE '^\| [A-Za-z ()0-9]*( \| [0-9.e+-]+){6} \|$' "$tmp/paper/report.md")" = 31 ]
	[ "$(grep -cE '^- (holds|\*\*VIOLATED\*\*): ' "$tmp/paper/report.md")" = 17 ]
	[ "$(grep -c '^- holds: .*: t = 0 and t = 1 give the ends back' "$tmp/paper/report.md")" = 3 ]
	grep -q '^- holds: human face (man) to .*: the Hausdorff distance from the start rises' "$tmp/paper/report.md"
}

@test "paper stops at the first failure with one line and no report" {
	mkdir -p "$tmp/bare/good"
	code=0
	LHGRID_MESHES=$tmp/bare scripts/paper "$tmp/not" 32 6 100 >"$tmp/out" 2>"$tmp/err" || code=$?
	[ $code = 1 ]
	[ "$(wc -l <"$tmp/err")" = 1 ]
	grep -q '^paper: mesh2rect: .*face_man_scan_6k.off: No such file' "$tmp/err"
	[ ! -s "$tmp/out" ]
	[ ! -e "$tmp/not/report.md" ]
}

@test "the measures of scripts/paper.d/surface.py are those of known surfaces" {
	/usr/bin/python3 -B - <<-'END'
		import sys
		sys.path.insert(0, 'scripts/paper.d')
		import numpy as np
		import surface
		nu, nv, T = 97, 81, 0.7

		def sphere(r, shift=0):
		    x, y = np.meshgrid(np.linspace(0, 1, nu) + 0.3 + shift, np.linspace(0, T, nv) + 0.2)
		    d = 1 + x*x + y*y
		    return r*np.stack([2*x/d, 2*y/d, 1 - 2/d], -1)

		def near(a, b, share):
		    assert abs(a - b) <= share*abs(b), (a, b)

		p = sphere(3)
		inner = p[surface.RINGS:-surface.RINGS, surface.RINGS:-surface.RINGS]
		H, area, normal = surface.curvature(p, T)
		assert abs(abs(H) - 1/3).max() < 1e-3
		near(surface.bending(p, T), surface.root_area(inner)**2/9, 0.05)
		assert surface.roughness(p, T, 2) < 1e-6
		# the graph of x = u, y = 2 v, z = a sin(4 u): H = -8 a sin(4 u) about, for small a
		u, v = np.meshgrid(np.linspace(0, 1, nu), np.linspace(0, T, nv))
		wave = np.stack([u, 2*v, 1e-3*np.sin(4*u)], -1)
		m = surface.RINGS + 1
		w = 2*T/(nv - 1)/(nu - 1)
		near(surface.bending(wave, T), w*(64e-6*np.sin(4*u)**2)[m:-m, m:-m].sum(), 0.01)
		# nodes that slide along the surface are at no distance from it, a larger sphere is
		foot = surface.Foot(p)
		assert foot.distance(sphere(3, 0.004))[4:-4, 4:-4].max() < 1e-5
		d = foot.distance(sphere(3.01, 0.004))[4:-4, 4:-4]
		assert abs(d - 0.01).max() < 1e-5
		assert surface.folded(p) == 0
		q = p.copy()
		q[1, -2] = 2*q[0, -1] - q[2, -3]
		assert surface.folded(q) > 0
		q = p.copy()
		q[40, 40] = 2*q[42, 42] - q[40, 40]
		assert surface.folded(q) == 0
	END
}
