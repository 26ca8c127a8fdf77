#!/usr/bin/python3
# lhg.py - read and write .lhg streams with numpy.  MIT license, copyright 2026 the lhgrid authors.
"""Read and write .lhg streams as format/LHG.md defines them; sections cited below are those of LHG.md.

    for g in lhg.read("face.lhg"):              # a path or a binary file object
        print(g.nu, g.nv, g.T, g["x"].shape)    # the array of channel x, [nv][nu]
    lhg.write("copy.lhg", lhg.read("face.lhg"))

    lhg.to_npy("face.lhg", "face")              # face/lambda.npy, face/H.npy, ...

    lhg.py FILE                                 # a summary; - is stdin
    lhg.py --npy=FOLDER FILE                    # to_npy
"""
import math
import os
import re
import struct
import sys
import zlib

import numpy as np

ALIGN = 64
MAXHEAD, MAXLINE = 65536, 4000
MAXN, MAXFRAMES, MAXCHAN = 32768, 1000000, 64
MAGICS = b"lhg 1\n", b"lhg 2\n"        # section 2: the rectangle, other charts
CHARTS = "rectangle", "sock", "pillow"
END = b"\nlhg end\x89\r\n\x1a\n" + bytes(50) + b"\n"            # section 4

COUNT = r"(0|[1-9][0-9]{0,9})"
NAME = r"([A-Za-z0-9._+-]{1,31})"
UNIT = r"([A-Za-z0-9._+/^*-]{1,31})"
KEY = r"([A-Za-z0-9._+-]{1,63})"
TEXT = r"([^ \x00-\x1f\x7f-\x9f](?:[^\x00-\x1f\x7f-\x9f]*[^ \x00-\x1f\x7f-\x9f])?)"


class Error(Exception):
    """What is wrong, and where: one line without control characters."""


class Channel:
    """Samples of one field: data[nv][nu] for support "grid", else data[n], row after row."""

    def __init__(self, data, unit="1", support="grid", step=0):
        self.data, self.unit, self.support, self.step = data, unit, support, step


class Grid:
    """nu x nv nodes over [0,1] x [0,T] of a chart of CHARTS; channels: name -> Channel, meta: key -> value,
    history: list of str, all in the order of the file."""

    def __init__(self, nu, nv, T, frame=1, frames=1, chart="rectangle"):
        self.chart, self.nu, self.nv, self.T, self.frame, self.frames = chart, nu, nv, T, frame, frames
        self.channels, self.meta, self.history = {}, {}, []

    def __getitem__(self, name):
        return self.channels[name].data

    def mask(self, channel):
        """A boolean array [nv][nu], true at the nodes where the channel has a sample: section 2.2."""
        j, i = np.mgrid[:self.nv, :self.nu]
        s = channel.step
        if channel.support == "grid":
            return np.ones((self.nv, self.nu), bool)
        if channel.support == "border" and self.chart == "sock":
            return j >= self.nv - s
        if channel.support == "border":
            return (i < s) | (j < s) | (i >= self.nu - s) | (j >= self.nv - s)
        return (i % s == 0) & (j % s == 0)


def count(grid, support, step):
    """The number of samples of a support, section 2.2."""
    nu, nv = grid.nu, grid.nv
    if support == "grid":
        return nu * nv
    if grid.chart == "sock":
        return nu * min(step, nv)
    if support == "border":
        return nu * nv - max(nu - 2 * step, 0) * max(nv - 2 * step, 0)
    return ((nu - 1) // step + 1) * ((nv - 1) // step + 1)


def spell(T):
    """T as the header must spell it, section 2: the fewest digits from 15 to 17 that give T again."""
    for digits in (15, 16, 17):
        text = "%.*g" % (digits, T)
        if float(text) == T:
            break
    return text


def check(grid):
    """The limits of section 2 that the syntax of a line does not enforce."""
    if not (2 <= grid.nu <= MAXN and 2 <= grid.nv <= MAXN):
        raise Error("size is not 2 to %d nodes each way" % MAXN)
    if grid.chart not in CHARTS:
        raise Error("the chart is not known")
    if grid.chart != "rectangle" and grid.nu % 2:
        raise Error("a %s has an even number of nodes along u" % grid.chart)
    if not (grid.T > 0 and math.isfinite(grid.T)):
        raise Error("height is not a positive number")
    if not 1 <= grid.frame <= grid.frames <= MAXFRAMES:
        raise Error("frame and number of frames are not 1 <= k <= n <= %d" % MAXFRAMES)
    if not 1 <= len(grid.channels) <= MAXCHAN:
        raise Error("number of channels is not 1 to %d" % MAXCHAN)
    for name, c in grid.channels.items():
        if (c.support, grid.chart) in (("lattice", "sock"), ("lattice", "pillow"), ("border", "pillow")):
            raise Error("channel %s: a %s has no %s" % (name, grid.chart, c.support))
        if c.support != "grid" and not 1 <= c.step <= max(grid.nu, grid.nv) - 1:
            raise Error("the step of channel %s does not suit the grid" % name)


class Order:
    """Which frame may come next, and the CRC of the one before, which its line 4 repeats: section 5."""

    def __init__(self):
        self.frame = self.frames = self.crc = 0

    def inside(self):
        return self.frame < self.frames

    def due(self):
        return self.crc if self.inside() else 0

    def check(self, grid):
        want = (self.frame + 1, self.frames) if self.inside() else (1, grid.frames)
        if (grid.frame, grid.frames) != want:
            raise Error("frame %d of %d comes where frame %d of %d is due" % (grid.frame, grid.frames, *want))

    def passed(self, grid, crc):
        self.frame, self.frames, self.crc = grid.frame, grid.frames, crc


# ---- read ---------------------------------------------------------------------------

def take(file, n, what):
    """Reads n bytes in blocks, so that memory is allocated only for bytes that exist."""
    out = bytearray()
    while len(out) < n:
        more = file.read(min(n - len(out), 1 << 20))
        if not more:
            raise Error("input ends in " + what)
        out += more
    return bytes(out)


def read_magic(file, empty):
    """Reads line 1 of a header.  Returns b"" at the end of the input.  empty: no grid came before."""
    magic = file.read(1)
    while magic and len(magic) < len(MAGICS[0]):
        more = file.read(len(MAGICS[0]) - len(magic))
        if not more:
            break
        magic += more
    if magic and magic not in MAGICS:
        raise Error("input is not an lhg stream" if empty else "bytes follow the end mark")
    return magic


def read_head(file, magic):
    """Reads a header from line 2 on and checks its CRC.  Returns the whole header and the CRC."""
    head, line = bytearray(magic), b""
    while not line.startswith(b"end"):
        line = file.readline(MAXHEAD - len(head))
        head += line
        if not line.endswith(b"\n"):
            raise Error("header has no end" if len(head) == MAXHEAD else "input ends in the header")
    crc = zlib.crc32(head[:-9])
    if head[-9:] != b"%08x\n" % crc:
        raise Error("header CRC is wrong")
    return bytes(head), crc


def parse_head(head):
    """The grid, without samples, and the CRC of line 4."""
    body = head[:head.rindex(b"\nend") + 1]
    spaces = len(head) - len(body) - len("end") - 9
    if len(head) % ALIGN or not 1 <= spaces <= ALIGN or head[len(body):-9] != b"end" + b" " * spaces:
        raise Error("header has a wrong end")
    try:
        text = body.decode("utf-8")
    except UnicodeDecodeError:
        raise Error("header is not UTF-8") from None
    lines = text.split("\n")[:-1]
    at = 0

    def match(pattern):
        nonlocal at
        m = at < len(lines) and len(lines[at].encode()) <= MAXLINE and re.fullmatch(pattern, lines[at])
        at += bool(m)
        return m and m.groups()

    def need(pattern):
        m = match(pattern)
        if not m:
            raise Error("header line %d is malformed" % (at + 1))
        return m

    version, = need("lhg ([12])")
    nu, nv = need("size %s %s" % (COUNT, COUNT))
    T, = need(r"height ([0-9.e+-]{1,39})")
    frame, frames, crc = need("frame %s %s ([0-9a-f]{8})" % (COUNT, COUNT))
    try:
        chart, = need("chart (sock|pillow)") if version == "2" else ("rectangle",)
        grid = Grid(int(nu), int(nv), float(T), int(frame), int(frames), chart)
    except ValueError:
        raise Error("header line 3 is malformed") from None
    if not grid.T > 0 or spell(grid.T) != T:
        raise Error("header line 3 is not in its only spelling")
    while m := match("channel %s %s (?:(grid)|(border|lattice) %s)" % (NAME, UNIT, COUNT)):
        if m[0] in grid.channels:
            raise Error("channel %s is there twice" % m[0])
        grid.channels[m[0]] = Channel(None, m[1], m[2] or m[3], int(m[4] or 0))
    while m := match("meta %s %s" % (KEY, TEXT)):
        if m[0] in grid.meta:
            raise Error("meta key %s is there twice" % m[0])
        grid.meta[m[0]] = m[1]
    while m := match("history " + TEXT):
        grid.history.append(m[0])
    if at < len(lines):
        raise Error("header line %d is malformed" % (at + 1))
    check(grid)
    return grid, int(crc, 16)


def read_channel(file, grid, name, crc):
    """Reads the samples of a channel, section 3.  Takes and returns the running CRC of the grid."""
    c = grid.channels[name]
    n = count(grid, c.support, c.step)
    data = take(file, 8 * n, "channel " + name)
    tail = take(file, ALIGN - 8 * n % ALIGN, "channel " + name)
    crc = zlib.crc32(data, crc)
    if tail[:4] != struct.pack("<I", crc):
        raise Error("channel %s: CRC is wrong" % name)
    if any(tail[4:]):
        raise Error("channel %s: padding is not zero" % name)
    c.data = np.frombuffer(data, "<f8").astype(float)
    if not np.isfinite(c.data).all():
        raise Error("channel %s is not finite" % name)
    if c.support == "grid":
        c.data = c.data.reshape(grid.nv, grid.nu)
    return crc


def read_grids(file):
    order, ahead, empty = Order(), b"", True
    while magic := ahead or read_magic(file, empty):
        head, crc = read_head(file, magic)
        grid, repeated = parse_head(head)
        order.check(grid)
        if repeated != order.due():
            raise Error("frame %d of %d does not belong to the grid before" % (grid.frame, grid.frames))
        for name in grid.channels:
            crc = read_channel(file, grid, name, crc)
        if take(file, ALIGN, "the end mark") != END:
            raise Error("end mark is wrong")
        order.passed(grid, crc)
        empty = False
        ahead = b"" if order.inside() else read_magic(file, empty)
        yield grid
        if not order.inside() and not ahead:
            return
    if empty:
        raise Error("empty input")
    raise Error("input ends after frame %d of %d" % (order.frame, order.frames))


def read(file):
    """Yields the grids of a path or a binary file one by one.  Raises Error or OSError."""
    if hasattr(file, "read"):
        yield from read_grids(file)
    else:
        with open(file, "rb") as f:
            yield from read_grids(f)


# ---- write --------------------------------------------------------------------------

def put_head(grid, due):
    """The header of a grid, and the CRC that ends it.  due: the CRC that line 4 repeats, or 0."""
    plain = grid.chart == "rectangle"
    lines = ["lhg 1" if plain else "lhg 2", "size %d %d" % (grid.nu, grid.nv), "height " + spell(grid.T),
             "frame %d %d %08x" % (grid.frame, grid.frames, due)] + ([] if plain else ["chart " + grid.chart])
    for name, c in grid.channels.items():
        step = "" if c.support == "grid" else " %d" % c.step
        lines.append("channel %s %s %s%s" % (name, c.unit, c.support, step))
    lines += ["meta %s %s" % m for m in grid.meta.items()]
    lines += ["history " + h for h in grid.history]
    try:
        head = "".join(line + "\n" for line in lines).encode() + b"end"
    except UnicodeEncodeError:
        raise Error("header is not UTF-8") from None
    head += b" " * (ALIGN - (len(head) + 9) % ALIGN)
    if len(head) + 9 > MAXHEAD:
        raise Error("header is longer than %d bytes" % MAXHEAD)
    crc = zlib.crc32(head)
    head += b"%08x\n" % crc
    again, _ = parse_head(head)         # refuses what a reader would refuse
    if (list(again.channels), again.meta, again.history) != (list(grid.channels), grid.meta, grid.history):
        raise Error("a line break in a name or text")
    return head, crc


def put_samples(grid, name):
    c = grid.channels[name]
    data = np.asarray(c.data, "<f8")
    n = count(grid, c.support, c.step)
    if data.shape != ((grid.nv, grid.nu) if c.support == "grid" else (n,)):
        raise Error("channel %s: the shape of the array is not that of its support" % name)
    if not np.isfinite(data).all():
        raise Error("channel %s is not finite" % name)
    return data.tobytes()


def put_grid(grid, due):
    """All bytes of a grid, and the CRC after its last channel."""
    check(grid)
    head, crc = put_head(grid, due)
    out = [head]
    for name in grid.channels:
        data = put_samples(grid, name)
        crc = zlib.crc32(data, crc)
        out += [data, struct.pack("<I", crc), bytes(ALIGN - len(data) % ALIGN - 4)]
    return b"".join(out + [END]), crc


def write_grids(file, grids):
    order = Order()
    for grid in grids:
        order.check(grid)
        out, crc = put_grid(grid, order.due())
        file.write(out)
        order.passed(grid, crc)
    if order.inside() or not order.frames:
        raise Error("grids end after frame %d of %d" % (order.frame, order.frames))
    file.flush()


def write(file, grids):
    """Writes grids, such as read yields, to a path or a binary file.  Raises Error or OSError."""
    if hasattr(file, "write"):
        write_grids(file, grids)
    else:
        with open(file, "wb") as f:
            write_grids(f, grids)


# ---- numpy's own files --------------------------------------------------------------

def to_npy(file, folder):
    """Writes folder/NAME.npy for each channel of a stream: the array of the channel, [nv][nu] or [n]; of a
    stream of several grids, which must have equal channels, one array for all, [grid][nv][nu] or
    [grid][n].  Chart, metadata and history stay behind.  Makes the folder.  Returns the paths; raises Error
    or OSError, and then has changed no file."""
    grids = list(read(file))
    first = grids[0]
    for g in grids:
        if [(n, c.data.shape) for n, c in g.channels.items()] != [(n, c.data.shape) for n, c in first.channels.items()]:
            raise Error("frame %d of %d has other channels than the first grid" % (g.frame, g.frames))
    os.makedirs(folder, exist_ok=True)
    paths = []
    try:
        for name in first.channels:
            data = first[name] if len(grids) == 1 else np.stack([g[name] for g in grids])
            paths.append(os.path.join(folder, name + ".npy"))
            with open(paths[-1] + ".part", "wb") as f:
                np.save(f, np.ascontiguousarray(data, "<f8"), allow_pickle=False)
        for path in paths:
            os.replace(path + ".part", path)
    finally:
        for path in paths:
            if os.path.exists(path + ".part"):
                os.remove(path + ".part")
    return paths


# ---- command ------------------------------------------------------------------------

def summary(grid):
    chart = "" if grid.chart == "rectangle" else "  chart " + grid.chart
    yield "size %d %d  height %s  frame %d of %d%s" % (
        grid.nu, grid.nv, spell(grid.T), grid.frame, grid.frames, chart)
    for name, c in grid.channels.items():
        step = "" if c.support == "grid" else " %d" % c.step
        yield "  %s  %s  %s%s  %d samples  %g .. %g" % (
            name, c.unit, c.support, step, c.data.size, c.data.min(), c.data.max())
    for m in grid.meta.items():
        yield "  %s: %s" % m
    for step in grid.history:
        yield "  | " + step


def main(argv):
    folder = argv.pop(1)[6:] if len(argv) == 3 and argv[1].startswith("--npy=") else None
    if len(argv) != 2 or argv[1] in ("-h", "--help"):
        print("usage: lhg.py [--npy=FOLDER] FILE", file=sys.stdout if len(argv) == 2 else sys.stderr)
        return 0 if len(argv) == 2 else 2
    name = "stdin" if argv[1] == "-" else argv[1]
    file = sys.stdin.buffer if argv[1] == "-" else argv[1]
    sys.stdout.reconfigure(errors="backslashreplace")
    try:
        if folder is not None:
            to_npy(file, folder)
            return 0
        for grid in read(file):
            for line in summary(grid):
                print(line)
        sys.stdout.flush()
    except (Error, OSError) as e:
        print("lhg.py: %s: %s" % (name, getattr(e, "strerror", None) or e), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
