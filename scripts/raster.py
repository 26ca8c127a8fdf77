"""raster.py - draws triangles as pixels with numpy, and writes pixels as PNG."""
import struct
import zlib

import numpy as np

CHUNK = 1 << 21                                 # candidate pixels at a time


class Raster:
    """The visible surface in a picture of h rows and w columns, lowest row first.  For each pixel,
    tri is the index of the triangle nearest to the eye (-1: none), and bary the barycentric
    coordinates of the pixel in it."""

    def __init__(self, xyz, tri, w, h):
        """xyz in pixels, z towards the eye."""
        self.tri = np.full(w*h, -1)
        self.bary = np.zeros((w*h, 3))
        self.faces = tri
        self.shape = h, w
        self._depth = np.full(w*h, -np.inf)
        p, z = xyz[tri][:, :, :2], xyz[tri][:, :, 2]
        low = np.maximum(np.ceil(p.min(1)), 0).astype(int)
        span = np.minimum(np.floor(p.max(1)), [w - 1, h - 1]).astype(int) - low + 1
        self._det = cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
        seen = np.flatnonzero((span > 0).all(1) & (self._det != 0))
        parts = np.cumsum(span[seen].prod(1))//CHUNK
        for part in np.unique(parts):
            self._fill(p, z, low, span, seen[parts == part])
        self.hit = self.tri >= 0

    def _fill(self, p, z, low, span, some):
        n = span[some].prod(1)
        t = np.repeat(some, n)
        k = np.arange(n.sum()) - np.repeat(np.cumsum(n) - n, n)
        at = low[t] + np.stack([k % span[t, 0], k//span[t, 0]], 1)
        b = cross(at - p[t, 0], p[t, 2] - p[t, 0])/self._det[t]
        c = cross(p[t, 1] - p[t, 0], at - p[t, 0])/self._det[t]
        bary = np.stack([1 - b - c, b, c], 1)
        near = (bary*z[t]).sum(1)
        pixel = at[:, 1]*self.shape[1] + at[:, 0]
        keep = np.flatnonzero((bary >= -1e-9).all(1) & (near > self._depth[pixel]))
        keep = keep[np.argsort(near[keep], kind='stable')]         # the nearest is written last
        self._depth[pixel[keep]] = near[keep]
        self.tri[pixel[keep]] = t[keep]
        self.bary[pixel[keep]] = bary[keep]

    def mix(self, value):
        """Values of the vertices, interpolated at each hit pixel, that is where there is a triangle."""
        corners = value[self.faces[self.tri[self.hit]]]
        weight = self.bary[self.hit]
        return np.einsum('pk,pk...->p...', weight, corners)

    def edge_distance(self, xyz):
        """The distance, in pixels, from each hit pixel to the nearest edge of its triangle."""
        t = self.tri[self.hit]
        p = xyz[self.faces[t]]
        sides = [np.linalg.norm((p[:, (k + 2) % 3] - p[:, (k + 1) % 3])[:, :2], axis=1) for k in range(3)]
        return np.abs(self.bary[self.hit]*self._det[t][:, None]/np.stack(sides, 1)).min(1)

    def picture(self, colour):
        """The picture with these rgb colours at the hit pixels and white elsewhere, top row first."""
        image = np.ones(self.tri.shape + (3,))
        image[self.hit] = colour
        return image.reshape(self.shape + (3,))[::-1]


def cross(a, b):
    return a[:, 0]*b[:, 1] - a[:, 1]*b[:, 0]


def shrink(image, samples):
    """Means over blocks of samples x samples pixels."""
    h, w = image.shape[0]//samples, image.shape[1]//samples
    return image.reshape(h, samples, w, samples, 3).mean((1, 3))


def palette(colours, n):
    """Chooses a palette of at most n colours for colours[m][3] by median cut.  Returns the palette,
    and for each of the m colours its index in the palette."""
    white = (colours == 255).all(1)              # white, the background, is kept exactly
    boxes = [np.flatnonzero(b) for b in (white, ~white) if b.any()]
    while len(boxes) < n:
        widths = [np.ptp(colours[b].astype(int), axis=0).max()*len(b)**0.5 for b in boxes]
        if max(widths) == 0:
            break
        box = boxes.pop(int(np.argmax(widths)))
        side = colours[box, np.ptp(colours[box].astype(int), axis=0).argmax()]
        low = side < max(np.median(side), side.min() + 1)
        boxes += [box[low], box[~low]]
    table, number = np.zeros((len(boxes), 3), np.uint8), np.zeros(len(colours), np.uint8)
    for k, box in enumerate(boxes):
        table[k], number[box] = np.round(colours[box].mean(0)), k
    return table, number


def png(path, image, colours=0):
    """Writes image, [h][w][3] in 0..1, to path.  If colours, 0 or 2..256, is not 0, the file gets a
    palette of at most so many colours."""
    pixels = np.round(255*np.clip(image, 0, 1)).astype(np.uint8)
    h, w = pixels.shape[:2]
    table = b''

    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))

    if colours:
        distinct, which = np.unique(pixels.reshape(-1, 3), axis=0, return_inverse=True)
        entries, number = palette(distinct, colours)
        pixels = number[which.ravel()].reshape(h, w)
        table = chunk(b'PLTE', entries.tobytes())
    raw = b''.join(b'\0' + row.tobytes() for row in pixels)
    head = struct.pack('>IIBBBBB', w, h, 8, 3 if colours else 2, 0, 0, 0)
    with open(path, 'wb') as f:
        f.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + table + chunk(b'IDAT', zlib.compress(raw, 9 if colours else 6)) + chunk(b'IEND', b''))
