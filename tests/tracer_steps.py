#!/usr/bin/env python3
"""tracer_steps.py [--draw]: types the learner's tracer as the texts of chapters 02 to 08 say, step by step.

A chapter begins with our answer to the graft before it. The text's blocks of ```diff change that program, one after the
other, up to the section of the graft, in which the program is our answer to it. Checks that each step compiles, and
that it draws the picture that the text shows next, images/NN-tracer-NAME.png, of the scene exercises/tracer/my.txt.
With --draw, it writes these pictures.
"""

import doctest
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import pictures

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENE = ROOT / "exercises/tracer/my.txt"
LINE = ["g++", "-std=c++20", "-O2", "-pthread", "-Wall", "-Wextra", "-Wshadow"]

# Parts of a picture that are shown enlarged: left, top, width, height, and how many times.
PARTS = {"04-tracer-stairs": (110, 130, 66, 44, 6), "04-tracer-edges": (110, 130, 66, 44, 6)}


def applied(source, block, where):
    """A block of ```diff: its lines without those with + are in the source, exactly once.

    >>> applied("a\\nb\\nc\\n", " a\\n-b\\n+d\\n", "")
    'a\\nd\\nc\\n'
    """
    lines = block.splitlines(keepends=True)
    before = "".join(line[1:] or "\n" for line in lines if line[0] != "+")
    after = "".join(line[1:] or "\n" for line in lines if line[0] != "-")
    if source.count(before) != 1:
        sys.exit(f"{where}: these lines are {source.count(before)} times in the program so far:\n{before}")
    return source.replace(before, after)


def steps(path):
    """For each step of a text: the pictures that show it, and the program."""
    number = path.name[:2]
    text = path.read_text(encoding="utf-8")
    source = (ROOT / f"solutions/tracer/{int(number) - 1:02}.cpp").read_text()
    names, changed = [], False
    for diff, graft, picture in re.findall(r"\n```diff\n(.*?)```\n|\n(## Graft:)|\]\(images/(\d\d-tracer-[\w-]+)\.png\)",
                                           text, re.S):
        if picture:
            names.append(picture)
            continue
        if names or (graft and changed):  # several blocks in a row are one step
            yield names, source
            names, changed = [], False
        if diff:
            source, changed = applied(source, diff, path.relative_to(ROOT)), True
        else:
            source = (ROOT / f"solutions/tracer/{number}.cpp").read_text()
    if names:
        yield names, source


def drawn(source, number, folder):
    """The picture that the program draws with our headers; the one of graft 02 prints it, and reads no scene."""
    (folder / "tracer.cpp").write_text(source)
    chapters = sorted((ROOT / "solutions").glob("0[0-8]_*"), reverse=True)
    folders = [ROOT / kind / chapter.name for chapter in chapters if chapter.name[:2] <= number
               for kind in ("solutions", "chapters")] + [ROOT / "common"]
    said = subprocess.run([*LINE, *(f"-I{one}" for one in folders), "tracer.cpp", "-o", "tracer"], cwd=folder, check=True,
                          capture_output=True, text=True).stderr
    # What a step leaves unused, the next one uses.
    for warning in re.findall(r"warning: (?!variable .* set but not used).*", said):
        sys.exit(f"chapter {number}: {warning}")
    out = folder / "picture.ppm"
    reads_scene = "read_scene" in source
    with open(folder / "printed.ppm", "wb") as printed:
        subprocess.run(["./tracer", *([SCENE, out] if reads_scene else [])], cwd=folder, check=True, stdout=printed)
    return pictures.read_ppm(out if reads_scene else folder / "printed.ppm")


def main(draw):
    if not shutil.which("g++"):
        return 77
    if doctest.testmod()[0]:
        return 1
    count = shown = faults = 0
    for path in sorted((ROOT / "docs").glob("0[2-8]-*.md")):
        for names, source in steps(path):
            count += 1
            with tempfile.TemporaryDirectory() as name:
                picture = drawn(source, path.name[:2], pathlib.Path(name))
            for image in names:
                shown += 1
                part = PARTS.get(image)
                mine = picture.part(*part[:4]).enlarged(part[4]) if part else picture
                file = ROOT / f"docs/images/{image}.png"
                if draw:
                    pictures.write_png(file, mine, few_colors=False)
                if pictures.read_png(file).rows != mine.rows:
                    faults += 1
                    print(f"{path.relative_to(ROOT)}: images/{image}.png is not what the tracer draws at this step; "
                          "tests/tracer_steps.py --draw draws it")
    print(f"{count} steps, {shown} pictures, {faults} faults")
    return 1 if faults or not count or not shown else 0


if __name__ == "__main__":
    sys.exit(main("--draw" in sys.argv[1:]))
