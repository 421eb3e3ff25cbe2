"""Draws fmu/model.png, the icon that importers show: a wheel on its rail, seen from behind. Standard library alone."""

import struct
import zlib
from pathlib import Path

SIZE, SAMPLES = 128, 4
STEEL, RAIL, EDGE = (62, 92, 138), (120, 124, 130), (200, 60, 50)

# Outlines in units of the picture, down positive: wheel disc with tread and flange, rail with head, web and foot, the patch between them.
WHEEL = [(0.16, 0.06), (0.34, 0.06), (0.34, 0.40), (0.80, 0.42), (0.80, 0.555), (0.34, 0.580), (0.31, 0.62), (0.27, 0.69),
         (0.21, 0.70), (0.16, 0.66)]
HEAD = [(0.36, 0.61), (0.41, 0.583), (0.56, 0.570), (0.71, 0.583), (0.76, 0.61), (0.745, 0.72), (0.60, 0.76), (0.60, 0.88),
        (0.78, 0.93), (0.78, 0.96), (0.34, 0.96), (0.34, 0.93), (0.52, 0.88), (0.52, 0.76), (0.375, 0.72)]
PATCH = [(0.50, 0.556), (0.62, 0.556), (0.62, 0.584), (0.50, 0.584)]


def inside(outline, x, y):
    """Whether a point lies in a polygon, by the number of its edges that a ray crosses."""
    crossed = False
    for (ax, ay), (bx, by) in zip(outline, outline[1:] + outline[:1]):
        if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
            crossed = not crossed
    return crossed


def pixel(column, row):
    """Mean colour and cover of the samples of a pixel."""
    sums, covered = [0, 0, 0], 0
    for sample in range(SAMPLES * SAMPLES):
        x = (column + (sample % SAMPLES + 0.5) / SAMPLES) / SIZE
        y = (row + (sample // SAMPLES + 0.5) / SAMPLES) / SIZE
        for outline, colour in ((PATCH, EDGE), (WHEEL, STEEL), (HEAD, RAIL)):
            if inside(outline, x, y):
                sums = [s + c for s, c in zip(sums, colour)]
                covered += 1
                break
    if not covered:
        return bytes(4)
    return bytes([s // covered for s in sums] + [255 * covered // (SAMPLES * SAMPLES)])


def chunk(name, content):
    body = name + content
    return struct.pack(">I", len(content)) + body + struct.pack(">I", zlib.crc32(body))


rows = b"".join(b"\0" + b"".join(pixel(column, row) for column in range(SIZE)) for row in range(SIZE))
header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 6, 0, 0, 0)
picture = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
Path(__file__).with_name("model.png").write_bytes(picture)
