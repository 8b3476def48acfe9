#!/usr/bin/env python3
"""Writes dusk.hdr, the sky when the sun is 3 degrees above the horizon: light that air, haze and ozone scatter once.

    python3 chapters/14_light/scenes/dusk.py

The numbers of the air are those of Bruneton and Neyret, "Precomputed atmospheric scattering", EGSR 2008, and of ozone
those of Bruneton's revision of it in 2017. Lengths are in kilometers.
"""

import math
import pathlib

WIDTH, HEIGHT = 512, 256
GROUND, TOP = 6360.0, 6460.0
AIR, HAZE, OZONE = (5.8e-3, 13.5e-3, 33.1e-3), 4.0e-3, (0.65e-3, 1.881e-3, 0.085e-3)
FORWARD = 0.8  # how much haze scatters ahead
SUN_HEIGHT, SUN_RADIUS = math.radians(3), math.radians(0.2667)
BRIGHTNESS = 60.0  # of the sun's light, before the air
STEPS = 40


def amounts(height):
    """How much air, haze and ozone there is at this height, each 1 where it is densest."""
    return math.exp(-height / 8), math.exp(-height / 1.2), max(0.0, 1 - abs(height - 25) / 15)


def way_out(radius, cosine):
    """The distance from a point at this radius to the top of the air."""
    across = radius * radius * (1 - cosine * cosine)
    return -radius * cosine + math.sqrt(max(0.0, TOP * TOP - across))


def transmitted(radius, cosine):
    """The share of light that comes through the air to a point, for each channel; 0 through the ground."""
    if cosine < 0 and radius * radius * (1 - cosine * cosine) < GROUND * GROUND:
        return 0.0, 0.0, 0.0
    step = way_out(radius, cosine) / STEPS
    sums = [0.0, 0.0, 0.0]
    for i in range(STEPS):
        along = (i + 0.5) * step
        height = math.sqrt(radius * radius + along * along + 2 * radius * along * cosine) - GROUND
        sums = [total + part * step for total, part in zip(sums, amounts(height))]
    return tuple(math.exp(-(a * sums[0] + 1.1 * HAZE * sums[1] + o * sums[2])) for a, o in zip(AIR, OZONE))


def sunlight_table():
    """What is left of the sun's light at heights (the square root of a share of 100 km) and cosines of its angle."""
    return [
        [transmitted(GROUND + 100 * (i / 63) ** 2 + 0.001, -0.2 + 0.5 * k / 511) for k in range(512)] for i in range(64)
    ]


def look_up(table, radius, cosine):
    row = min(63, round(63 * math.sqrt(max(0.0, radius - GROUND) / 100)))
    return table[row][max(0, min(511, round((cosine + 0.2) / 0.5 * 511)))]


def sky(table, direction, sun):
    x, y, z = direction
    toward_sun = x * sun[0] + y * sun[1] + z * sun[2]
    by_air = 3 / (16 * math.pi) * (1 + toward_sun * toward_sun)
    g = FORWARD
    by_haze = (3 / (8 * math.pi) * (1 - g * g) * (1 + toward_sun * toward_sun)
               / ((2 + g * g) * (1 + g * g - 2 * g * toward_sun) ** 1.5))
    radius = GROUND + 0.05
    end = way_out(radius, y)
    depth, light, before = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], 0.0
    for i in range(STEPS):  # short steps near the eye, where the air is dense
        after = end * ((i + 1) / STEPS) ** 2
        step, along = after - before, (before + after) / 2
        before = after
        there = math.sqrt(radius * radius + along * along + 2 * radius * along * y)
        air, haze, ozone = amounts(there - GROUND)
        sun_angle = (radius * sun[1] + along * toward_sun) / there
        sunlight = look_up(table, there, sun_angle)
        for c in range(3):
            thick = (AIR[c] * air + 1.1 * HAZE * haze + OZONE[c] * ozone) * step
            seen = math.exp(-depth[c] - thick / 2)
            light[c] += seen * sunlight[c] * (AIR[c] * air * by_air + HAZE * haze * by_haze) * step
            depth[c] += thick
    return [BRIGHTNESS * channel for channel in light]


def pixels():
    """The rows of the picture, each a list of colors. The sun is in the middle."""
    table = sunlight_table()
    sun = (0.0, math.sin(SUN_HEIGHT), -math.cos(SUN_HEIGHT))
    rows = []
    for row in range(HEIGHT // 2):
        angle = math.pi * (row + 0.5) / HEIGHT
        half = []
        for column in range(WIDTH // 2):  # the other half is its mirror image
            turn = 2 * math.pi * ((column + 0.5) / WIDTH - 0.5)
            direction = (math.sin(angle) * math.sin(turn), math.cos(angle), -math.sin(angle) * math.cos(turn))
            half.append(sky(table, direction, sun))
        rows.append(half + half[::-1])
    # The sun's disk, spread over the two pixels in which it lies.
    row = int((math.pi / 2 - SUN_HEIGHT) / math.pi * HEIGHT)
    size = 2 * math.pi / WIDTH * math.pi / HEIGHT * math.cos(SUN_HEIGHT)
    share = 2 * math.pi * (1 - math.cos(SUN_RADIUS)) / (2 * size)
    radiance = BRIGHTNESS / (2 * math.pi * (1 - math.cos(SUN_RADIUS)))
    disk = [share * radiance * left for left in transmitted(GROUND + 0.05, sun[1])]
    for column in (WIDTH // 2 - 1, WIDTH // 2):
        rows[row][column] = [a + b for a, b in zip(rows[row][column], disk)]
    # The ground, lit by the sky: a tenth of the light that falls on it.
    fallen = [0.0, 0.0, 0.0]
    for row, colors in enumerate(rows):
        angle = math.pi * (row + 0.5) / HEIGHT
        weight = math.cos(angle) * math.sin(angle) * 2 * math.pi / WIDTH * math.pi / HEIGHT
        for color in colors:
            fallen = [total + weight * channel for total, channel in zip(fallen, color)]
    ground = [0.1 * channel / math.pi for channel in fallen]
    return rows + [[ground] * WIDTH] * (HEIGHT - len(rows))


def shared_exponent(color):
    """A color as four bytes: three channels and their exponent."""
    largest = max(color)
    if largest < 1e-32:
        return 0, 0, 0, 0
    exponent = math.frexp(largest)[1]
    return *(int(channel * 2.0 ** (8 - exponent)) for channel in color), exponent + 128


def runs(row):
    """The bytes of one channel of a row: runs of equal bytes, and bytes as they are."""
    out, plain, i = bytearray(), bytearray(), 0
    while i < len(row):
        length = 1
        while length < 127 and i + length < len(row) and row[i + length] == row[i]:
            length += 1
        if length > 2 or i + length == len(row) and length > 1:
            out += (bytes([len(plain)]) + plain if plain else b"") + bytes([128 + length, row[i]])
            plain = bytearray()
        else:
            length = 1
            plain.append(row[i])
            if len(plain) == 128:
                out += bytes([128]) + plain
                plain = bytearray()
        i += length
    return out + (bytes([len(plain)]) + plain if plain else b"")


def main():
    out = bytearray(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {HEIGHT} +X {WIDTH}\n".encode())
    for row in pixels():
        stored = [shared_exponent(color) for color in row]
        out += bytes([2, 2, WIDTH >> 8, WIDTH & 255])
        for channel in range(4):
            out += runs([pixel[channel] for pixel in stored])
    pathlib.Path(__file__).with_name("dusk.hdr").write_bytes(out)


if __name__ == "__main__":
    main()
