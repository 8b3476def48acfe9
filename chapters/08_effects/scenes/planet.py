#!/usr/bin/env python3
"""Draws planet.png, the map of a planet that does not exist: noise on a sphere, so that the map has
no seam, in a palette of sea, land and ice. Needs nothing but Python."""
import math
import struct
import zlib
from pathlib import Path

WIDTH, HEIGHT = 768, 384
SEA = [(16, 42, 84), (20, 58, 104), (28, 82, 126), (44, 114, 148), (86, 160, 172)]
LAND = [(222, 200, 150), (150, 162, 92), (92, 128, 70), (64, 98, 62), (112, 92, 70), (150, 128, 108)]
ICE, CLOUD = (238, 244, 250), (250, 250, 250)


def lot(x, y, z):
    """A number in [0, 1) for each point of the integer grid."""
    n = (x * 374761393 + y * 668265263 + z * 2147483647) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((n ^ (n >> 16)) & 0xFFFF) / 65536


def smooth(x, y, z):
    """The random numbers of the eight corners around a point, blended."""
    ix, iy, iz = math.floor(x), math.floor(y), math.floor(z)
    fade = [t * t * (3 - 2 * t) for t in (x - ix, y - iy, z - iz)]
    total = 0
    for corner in range(8):
        bits = corner & 1, corner >> 1 & 1, corner >> 2
        share = 1
        for bit, t in zip(bits, fade):
            share *= t if bit else 1 - t
        total += share * lot(ix + bits[0], iy + bits[1], iz + bits[2])
    return total


def noise(p, scale, octaves):
    total, weight, sum_of_weights = 0, 1, 0
    for octave in range(octaves):
        total += weight * smooth(*(c * scale + 17 * octave for c in p))
        sum_of_weights += weight
        scale, weight = 2 * scale, 0.55 * weight
    return total / sum_of_weights


def color(p):
    height = noise(p, 1.9, 6)
    warped = tuple(c + 0.4 * (height - 0.5) for c in p)
    cloud = noise((warped[0], 2.2 * warped[1], warped[2] + 9), 2.6, 5)
    if cloud > 0.615:
        return CLOUD
    if abs(p[1]) + 0.35 * (height - 0.5) > 0.90:
        return ICE
    level = 0.525
    if height < level:
        return SEA[min(4, int((height / level) ** 3 * 5.4))]
    return LAND[min(5, int((height - level) / 0.20 * 6))]


def main():
    names = SEA + LAND + [ICE, CLOUD]
    rows = bytearray()
    for y in range(HEIGHT):
        rows.append(0)
        down = math.pi * (y + 0.5) / HEIGHT
        for x in range(WIDTH):
            around = 2 * math.pi * (x + 0.5) / WIDTH
            p = math.sin(down) * math.cos(around), math.cos(down), math.sin(down) * math.sin(around)
            rows.append(names.index(color(p)))

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 3, 0, 0, 0)
    palette = bytes(channel for entry in names for channel in entry)
    Path(__file__).with_name("planet.png").write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", palette) +
        chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


main()
