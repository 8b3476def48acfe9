#!/usr/bin/env python3
"""first_steps.py ROOT [--draw]: types the program of exercise 00.1 as its text says, step by step.

Checks that every step compiles, that it draws the picture that the text shows beside it, and that the
last one is the solution. With --draw it writes these pictures, docs/images/00-first-N.png.
"""
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "tests"))
from tracer_steps import applied
LINE = "g++ -std=c++20 -O2 first.cpp -o first && ./first > first.ppm"


def steps(text):
    section = re.search(r"\n### 00\.1 .*?(?=\n## )", text, re.S)[0]
    source = ""
    for number, step in enumerate(re.split(r"\n\*\*Step \d", section)[1:], 1):
        for language, block in re.findall(r"\n```(cpp|diff)\n(.*?)```\n", step, re.S):
            source = block if language == "cpp" else applied(source, block, "00.1")
        picture = re.search(r"\]\((images/[^)]*)\)", step)[1]
        yield number, source, picture


def rows_of(ppm):
    words = ppm.split()
    width, height = int(words[1]), int(words[2])
    values = bytes(map(int, words[4:]))
    assert words[0] == "P3" and len(values) == 3 * width * height
    return width, height, [values[i:i + 3 * width] for i in range(0, len(values), 3 * width)]


def png(width, height, rows):
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) +
            chunk(b"IEND", b""))


def pixels_of(data):
    """Of a PNG that png() made, all that its compression holds."""
    at, pixels = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            pixels += data[at + 8:at + 8 + length]
        at += length + 12
    return zlib.decompress(pixels)


def main():
    text = (ROOT / "docs/00-toolchain.md").read_text()
    if not shutil.which("g++"):
        sys.exit(77)
    assert LINE in text, "the text compiles by another line"
    for number, source, picture in steps(text):
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            (place / "first.cpp").write_text(source)
            warned = subprocess.run(LINE.replace("-O2", "-O2 -Wall -Wextra"), shell=True, cwd=place,
                                    check=True, capture_output=True, text=True).stderr
            assert not warned, f"step {number}: {warned}"
            drawn = png(*rows_of((place / "first.ppm").read_text()))
        path = ROOT / "docs" / picture
        if "--draw" in sys.argv:
            path.write_bytes(drawn)
        assert pixels_of(path.read_bytes()) == pixels_of(drawn), f"step {number} draws another picture"
    assert number == 5, f"the text has {number} steps"
    solution = (ROOT / "solutions/00_toolchain/first.cpp").read_text()
    assert source == solution, "the last step is not the solution"
    print("5 steps, each draws its picture")


main()
