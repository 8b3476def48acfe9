#!/usr/bin/env python3
"""follow.py BUILD: what `./course run NN --follow` records of the light, by programs with our answers.

- The light of a sample is that of a picture with this sample alone, so nothing is recorded that the picture lacks.
- Known mistakes can be seen in the words.
- A path that never ends is given up.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(sys.argv[1])
RECORDER = ROOT / "companion/follow/recorder"
folder = tempfile.TemporaryDirectory()
PLACE = pathlib.Path(folder.name)


def followed(program, mistake=""):
    """A chapter's program with our answers, or with a mistake in them, made to record."""
    file = PLACE / (program + mistake)
    names = f"{RECORDER}+{mistake}" if mistake else RECORDER
    subprocess.run([BUILD / "bin/mistake_tool", "program", names, f"{program}_solution", file], check=True)
    return file


def trail(program, x, y, *options):
    file = PLACE / "trail.txt"
    file.unlink(missing_ok=True)
    subprocess.run([program, "--quiet", "--out", PLACE / "unfinished.ppm", *options], check=True,
                   env={**os.environ, "COURSE_FOLLOW": f"{x} {y} 0", "COURSE_TRAIL": str(file)})
    return file


def words(program, x, y, *options):
    return subprocess.run([BUILD / "bin/mistake_tool", "trail", trail(program, x, y, *options)], check=True,
                          stdout=subprocess.PIPE, text=True).stdout


def light(program, x, y, *options):
    """The light that is recorded, as the bytes of a picture."""
    line = next(line for line in trail(program, x, y, *options).read_text().splitlines() if line.startswith("light"))
    linear = [min(1, float(number)) for number in line.split("\t")[2].split()]
    return [int(255 * (12.92 * c if c <= 0.0031308 else 1.055 * c**(1 / 2.4) - 0.055) + 0.5) for c in linear]


def in_picture(program, x, y, *options):
    file = PLACE / "picture.ppm"
    subprocess.run([BUILD / f"bin/{program}_solution", "--quiet", "--out", file, *options], check=True)
    data = file.read_bytes()
    width, height = map(int, data.split(None, 3)[1:3])
    at = 3 * (y * width + x)
    return list(data[len(data) - 3 * width * height:][at:at + 3])


def expect(text, *parts):
    for part in parts:
        assert part in text, f"{part!r} is not in\n{text}"


glass = followed("05_metal_glass")
for x, y in ((345, 300), (480, 290), (400, 150), (130, 60), (650, 260)):
    drawn, told = in_picture("05_metal_glass", x, y, "--spp", "1"), light(glass, x, y, "--spp", "1")
    assert drawn == told, f"pixel {x},{y} is {drawn} in the picture, and {told} was recorded"
expect(words(glass, 345, 300),
       "from outside, at 12.7 degrees from the normal\n",
       "goes on along (-0.1731, -0.2082, -0.9627), at 8.4 degrees from the normal, through the surface\n")
expect(words(followed("05_metal_glass", "05.3_ratio_upside_down"), 345, 300),
       "from outside, at 12.7 degrees from the normal\n",
       "goes on along (-0.02372, -0.323, -0.9461), at 19.3 degrees from the normal, through the surface\n")

stays = followed("04_normals_aa", "04.6_stays_on_surface")
expect(words(stays, 500, 300),
       "   2 from point 1 itself along",
       "meets sphere 0, of radius 1000 around (0, -1000, 0), at t = 0\n     from inside")
expect(words(stays, 500, 300, "--depth", "1000"), "More than 200 segments: stopped here.\n")
