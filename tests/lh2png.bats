# lh2png.bats - pictures: pixels, colour bars and names, for fields whose values are known.

load helper

setup_file() {
	load helper
	# Channels of 9 x 5 nodes: a constant, both signs, one sign, a border and a lattice.
	/usr/bin/python3 - "$tmp" <<-'END'
		import sys
		sys.path.insert(0, 'scripts')
		import lhg, numpy as np
		def grid(T=0.5, frame=1, frames=1, **channels):
		    g = lhg.Grid(9, 5, T)
		    for name, f in channels.items():
		        g.channels[name] = lhg.Channel(np.array(f, float), '1/length' if name == 'H' else 'length')
		    g.frame, g.frames = frame, frames
		    return g
		i, j = np.meshgrid(np.arange(9), np.arange(5))
		u, v = i/8, j/8
		to = lambda name, *grids: lhg.write(sys.argv[1] + '/' + name, list(grids))
		to('ramp', grid(lambda_=0*u, up=1 + j, right=i, signed=u - 0.25, c=0*u + 3))
		to('lh', grid(**{'lambda': 10**(2*u), 'H': u - 2}))
		to('zero', grid(z=0*u))
		to('set', *[grid(T=0.5, frame=k, frames=3, z=u*k) for k in (1, 2, 3)])
		to('long', grid(T=1e6, z=u))
		to('large', grid(z=1.7e308*(2*u - 1)))
		to('spike', grid(z=(i == 3)*(j == 2)*7.0))
		g = grid(z=u)
		to('unitless', g)
		g.meta['unit'] = 'mm'
		g.channels['edge'] = lhg.Channel(np.ones(9*5 - 5*1), '1', 'border', 2)
		g.channels['few'] = lhg.Channel(np.arange(5*3.0), '1', 'lattice', 2)
		to('parts', g)
	END
}

# pixels FILE CODE: runs CODE with p, the pixels of FILE, as whole numbers.
pixels() {
	/usr/bin/python3 - "$1" "$2" <<-'END'
		import sys, textwrap
		sys.path.insert(0, 'tests')
		sys.dont_write_bytecode = True
		import png, numpy as np
		p = png.read(sys.argv[1]).astype(int)
		exec(textwrap.dedent(sys.argv[2]))
	END
}

@test "a constant has one colour, the middle of the map, and one number" {
	lh2png --bare -c c "$tmp/ramp" -o "$tmp/c.png"
	pixels "$tmp/c.png" 'assert p.shape == (145, 261, 3), p.shape; assert (p == [0x21, 0x91, 0x8c]).all(), p[0,0]'
	lh2png --bare -c z --map=diverging "$tmp/zero" -o "$tmp/c.png"
	pixels "$tmp/c.png" 'assert (p == 221).all()'
}

@test "u goes right, v goes up, each node is a rectangle of equal pixels" {
	lh2png --bare --range=0,8 -c right "$tmp/ramp" --size=9 -o "$tmp/r.png"
	pixels "$tmp/r.png" '
		assert p.shape == (5, 9, 3) and (p == p[0]).all()
		assert list(p[0,0]) == [0x44, 0x01, 0x54] and list(p[0,8]) == [0xfd, 0xe7, 0x25], p[0]
		assert (np.diff(p[0,:,1]) > 0).all()'
	lh2png --bare -c up --range=0%,100% "$tmp/ramp" --size=27 -o "$tmp/u.png"
	pixels "$tmp/u.png" '
		assert p.shape == (15, 27, 3) and (p == p[:, :1]).all()
		assert (p[0::3] == p[1::3]).all() and (p[0::3] == p[2::3]).all()
		assert list(p[0,0]) == [0xfd, 0xe7, 0x25] and list(p[14,0]) == [0x44, 0x01, 0x54]
		assert (np.diff(p[::3,0,1]) < 0).all()'
}

@test "a channel of both signs, and H: blue below 0, light grey at 0, red above, as far on both sides" {
	lh2png --bare -c signed --range=0%,100% --size=9 "$tmp/ramp" -o "$tmp/s.png"
	pixels "$tmp/s.png" '
		assert list(p[0,2]) == [221, 221, 221] and list(p[0,8]) == [180, 4, 38]
		assert p[0,0,2] > p[0,0,0] and p[0,4,0] > p[0,4,2], p[0]
		assert p[0,0,2] < 255 and list(p[0,0]) != [59, 76, 192]'
	lh2png --bare -c H --range=-3,1 --size=9 "$tmp/lh" -o "$tmp/h.png"
	pixels "$tmp/h.png" 'assert (p[:,:,2] > p[:,:,0]).all()'
	lh2png --bare -c H --map=viridis --size=9 "$tmp/lh" -o "$tmp/h.png"
	pixels "$tmp/h.png" 'assert list(p[0,8]) == [0xfd, 0xe7, 0x25]'
}

@test "--range: values beyond have the colours of the ends; --log: equal ratios are equally far" {
	lh2png --bare -c right --range=2,6 --size=9 "$tmp/ramp" -o "$tmp/r.png"
	pixels "$tmp/r.png" 'assert (p[0,:3] == p[0,0]).all() and (p[0,6:] == p[0,8]).all() and (p[0,3] != p[0,2]).any()'
	lh2png --bare -c lambda --log --range=1,100 --size=9 "$tmp/lh" -o "$tmp/log.png"
	lh2png --bare -c right --range=0,8 --size=9 "$tmp/ramp" | cmp - "$tmp/log.png"
	try 0 'channel z: colours from 0 to 7, values from 0 to 7$' "$tmp/spike" lh2png -v -c z
	try 0 'channel right: colours from 0 to 4, values from 0 to 8$' "$tmp/ramp" lh2png -v -c right --range=0%,50%
	try 0 'channel right: colours from 4 to 6, values' "$tmp/ramp" lh2png -v -c right --range=50%,6
}

@test "a name above the map; beside it a bar from LOW at the foot to HIGH at the head, with numbers" {
	lh2png -c right --range=0,8 "$tmp/ramp" -o "$tmp/bar.png"
	pixels "$tmp/bar.png" '
		ink = (p == 0).all(2)
		name, map, bar, numbers = ink[:21, :200], p[21:166, 8:269], p[21:166, 277:291], ink[:, 291:]
		assert name.sum() > 30 and not ink[21:166, 8:291].any()
		assert list(map[0,0]) == [0x44, 0x01, 0x54] and list(map[0,-1]) == [0xfd, 0xe7, 0x25]
		assert (bar == bar[:, :1]).all() and list(bar[-1,0]) == [0x44, 0x01, 0x54] and list(bar[0,0]) == [0xfd, 0xe7, 0x25]
		assert (np.diff(bar[:,0,1]) <= 0).all()
		marks = np.flatnonzero(numbers[:, :4].all(1))
		assert list(marks) == [21, 57, 93, 129, 165], marks
		lines = numbers[:, 8:].any(1)
		assert (np.diff(lines.astype(int)) == 1).sum() == 5'
	# two names, and two numbers, give two pictures
	lh2png -c up --range=0,8 "$tmp/ramp" -o "$tmp/up.png"
	pixels "$tmp/up.png" "
		q = png.read('$tmp/bar.png').astype(int)
		assert p.shape == q.shape and (p[:21, :200] != q[:21, :200]).any() and (p[:, 277:] == q[:, 277:]).all()"
	lh2png -c right --range=0,9 "$tmp/ramp" | cmp -s - "$tmp/bar.png" && return 1
	# "z (mm)" is shorter than "z (length)"
	lh2png -c z "$tmp/parts" -o "$tmp/mm.png"
	lh2png -c z "$tmp/unitless" -o "$tmp/length.png"
	for f in mm length; do
		pixels "$tmp/$f.png" 'print(np.flatnonzero((p[:15] == 0).all(2).any(0)).max())'
	done | xargs | { read -r a b; [ $((b - a)) = 24 ]; }
}

@test "a border is grey inside; a lattice has the value of the nearest of its nodes" {
	lh2png --bare -c edge --size=9 "$tmp/parts" -o "$tmp/e.png"
	pixels "$tmp/e.png" '
		grey = (p == 128).all(2)
		assert grey[2, 2:7].all() and grey.sum() == 5'
	lh2png --bare -c few --size=9 --range=0,14 "$tmp/parts" -o "$tmp/f.png"
	pixels "$tmp/f.png" '
		first = [0, 1, 3, 5, 7]
		assert (p[:, first[1:]] == p[:, [2, 4, 6, 8]]).all() and (p[:, 0] != p[:, 1]).any()
		assert len({tuple(c) for row in p for c in row}) == 15'
}

@test "-c all: one picture of all channels, in rows; a stream gives numbered files" {
	lh2png -c c "$tmp/ramp" -o "$tmp/one.png"
	lh2png -c c,c,c,c,c "$tmp/ramp" -o "$tmp/five.png"
	pixels "$tmp/five.png" "
		q = png.read('$tmp/one.png').astype(int)
		h, w = q.shape[:2]
		assert p.shape == (2*h, 3*w, 3), p.shape
		for k in range(5):
		    assert (p[k//3*h:(k//3 + 1)*h, k%3*w:(k%3 + 1)*w] == q).all(), k
		assert (p[h:, 2*w:] == 255).all()"
	lh2png -c all --bare --size=9 "$tmp/ramp" -o "$tmp/all.png"
	pixels "$tmp/all.png" 'assert p.shape == (10, 27, 3), p.shape'
	mkdir "$tmp/set.d"
	lh2png "$tmp/set" -o "$tmp/set.d/z-%02d.png"
	[ "$(ls "$tmp/set.d" | xargs)" = 'z-01.png z-02.png z-03.png' ]
	pixels "$tmp/set.d/z-03.png" "assert (p != png.read('$tmp/set.d/z-02.png')).any()"
}

@test "the file has no time and no text, and equal input gives equal bytes" {
	lh2png -c all "$tmp/ramp" >"$tmp/a.png"
	/usr/bin/python3 - "$tmp/a.png" <<-'END'
		import sys
		sys.dont_write_bytecode = True
		sys.path.insert(0, 'tests')
		import png
		names = {name for name, body in png.chunks(open(sys.argv[1], 'rb').read())}
		assert names <= {'IHDR', 'sRGB', 'gAMA', 'cHRM', 'IDAT', 'IEND'}, names
	END
	cp "$tmp/ramp" "$tmp/other"
	OMP_NUM_THREADS=4 LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo lh2png -c all "$tmp/other" | cmp - "$tmp/a.png"
}

@test "extreme charts, values and sizes: a picture, or one line" {
	try 0 'cells are more than 16 times as long as wide .T 1e.06.: drawn as squares' "$tmp/long" lh2png --bare --size=9
	pixels "$tmp/out" 'assert p.shape == (5, 9, 3)'
	lh2png --bare --size=9 --range=0%,100% "$tmp/large" -o "$tmp/l.png"
	pixels "$tmp/l.png" 'assert list(p[0,0]) == [59, 76, 192] and list(p[0,4]) == [221, 221, 221] and list(p[0,8]) == [180, 4, 38]'
	try 0 '' "$tmp/large" lh2png
	try 0 '' "$tmp/ramp" lh2png --size=1
	try 1 'a picture of .* pixels is too large: need a smaller --size' "$tmp/ramp" lh2png --size=32768 -c all
}

@test "what cannot be drawn is one line" {
	try 1 'channel H has values down to -2: no --log'       "$tmp/lh"   lh2png --log -c H
	try 0 'channel H has values down to -2: drawn without'  "$tmp/lh"   lh2png --log -c all
	try 1 'no channel lambda: run grid2lh first'             "$tmp/ramp" lh2png -c lambda
	try 1 'no channel nosuch'                               "$tmp/ramp" lh2png -c c,nosuch
	try 2 "'' is not the name of a channel"                 "$tmp/ramp" lh2png -c c,,c
	try 1 'would go from 9 down to'                         "$tmp/lh"   lh2png -c lambda --range=9,0%
	try 2 'need LOW,HIGH'                                   /dev/null   lh2png --range=3,1
	try 2 'need LOW,HIGH'                                   /dev/null   lh2png --range=1
	try 2 'need LOW,HIGH'                                   /dev/null   lh2png --range=1,2,3
	try 2 'need LOW,HIGH'                                   /dev/null   lh2png --range=nan,3
	try 2 'need LOW,HIGH'                                   /dev/null   lh2png --range=0%,101%
	try 2 'with --log LOW must be positive'                 /dev/null   lh2png --range=0,3 --log
	try 2 'a diverging map is centred on 0'                 /dev/null   lh2png --log --map=diverging
	try 2 'map=jet: need viridis or diverging'              /dev/null   lh2png --map=jet
	try 2 'need a whole number in .1,32768.'                /dev/null   lh2png --size=0
	try 1 'holds several grids, one for each file'          "$tmp/set"  lh2png
	try 1 'holds several grids'                             "$tmp/set"  lh2png -o "$tmp/one-only.png"
	[ ! -e "$tmp/one-only.png" ]
	head -c 400 "$tmp/ramp" >"$tmp/cut"
	try 1 'cut: ' /dev/null lh2png "$tmp/cut" -o "$tmp/cut.png"
	[ ! -e "$tmp/cut.png" ]
}

@test "--axes: room for numbers, and a grey line where u is 0.4" {
	lh2png -c H --size=400 "$tmp/lh" -o "$tmp/plain.png"
	lh2png -c H --size=400 --axes "$tmp/lh" -o "$tmp/axes.png"
	# the margins of the map: 34 pixels more at the left; it begins at (42, 21)
	pixels "$tmp/axes.png" '
		q = png.read("'"$tmp/plain.png"'")
		assert p.shape[1] == q.shape[1] + 34 and p.shape[0] > q.shape[0] + 10, (p.shape, q.shape)
		assert (p[30:120, 206] == 110).all() and not (p[30:120, 200] == 110).all()'
	try 2 'axes: --bare leaves out all numbers' /dev/null lh2png --bare --axes
}
