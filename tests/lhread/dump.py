"""dump.py FILE OUT: all that scripts/lhg.py reads from FILE, as text and little-endian samples."""
import sys

sys.path.insert(0, 'scripts')
import lhg

with open(sys.argv[2], 'wb') as out:
    def line(*words):
        out.write((' '.join(map(str, words)) + '\n').encode())

    for g in lhg.read(sys.argv[1]):
        line(g.nu, g.nv, '%.17g' % g.T, g.frame, g.frames)
        for name, c in g.channels.items():
            line(name, c.unit, c.support, c.step)
            out.write(c.data.astype('<f8').tobytes())
        for key, value in g.meta.items():
            line('meta', key, value)
        for step in g.history:
            line('history', step)
