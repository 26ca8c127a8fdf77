"""png.py - reads the PNG files that lh2png writes, without a library.  For tests."""
import struct
import zlib

import numpy as np


def chunks(data):
    """The (name, bytes) of every chunk; checks signature, lengths and CRCs."""
    assert data[:8] == b'\x89PNG\r\n\x1a\n', 'no PNG'
    found, at = [], 8
    while at < len(data):
        n, name = struct.unpack('>I4s', data[at:at + 8])
        body, crc = data[at + 8:at + 8 + n], data[at + 8 + n:at + 12 + n]
        assert crc == struct.pack('>I', zlib.crc32(name + body)), name
        found.append((name.decode(), body))
        at += 12 + n
    assert found[0][0] == 'IHDR' and found[-1] == ('IEND', b''), found
    return found


def paeth(a, b, c):
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]


def unfilter(kind, line, above):
    out = bytearray(line)
    for k in range(len(out)):
        a, b, c = out[k - 3] if k > 2 else 0, above[k], above[k - 3] if k > 2 else 0
        out[k] = (out[k] + (0, a, b, (a + b)//2, paeth(a, b, c))[kind]) & 255
    return out


def read(path):
    """The pixels [h][w][3] of an 8-bit RGB picture, row 0 at the top."""
    parts = chunks(open(path, 'rb').read())
    w, h, depth, kind, *rest = struct.unpack('>IIBBBBB', parts[0][1])
    assert (depth, kind, rest) == (8, 2, [0, 0, 0])
    raw = zlib.decompress(b''.join(body for name, body in parts if name == 'IDAT'))
    assert len(raw) == h*(1 + 3*w)
    rows, above = [], bytes(3*w)
    for k in range(0, len(raw), 1 + 3*w):
        above = unfilter(raw[k], raw[k + 1:k + 1 + 3*w], above)
        rows.append(np.frombuffer(bytes(above), np.uint8).reshape(w, 3))
    return np.array(rows)
