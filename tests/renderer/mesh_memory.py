#!/usr/bin/env python3
"""mesh_memory.py RENDERER FOREST_PY: the memory that meshes take at most, while they are read and drawn.

A triangle takes up to 350 bytes, as docs/scene-files.md says, and 10,000 trees of 100,000 triangles take less than 1 GB.
"""

import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

RENDERER, FOREST = sys.argv[1:]


def peak(folder, scene):
    """The most memory, in bytes, of the program that draws a small picture of a scene."""
    # The largest of all children so far: so scenes are drawn from the smallest to the largest.
    subprocess.run([RENDERER, scene, "--width", "40", "--height", "22", "--spp", "1", "--quiet", "--out", "small.png"],
                   cwd=folder, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024


def write_grid(folder, side):
    """A smooth surface of 2 * side * side triangles."""
    lines = ["v %d %.4f %d" % (x, math.sin(0.7 * x) * math.cos(0.9 * z), z)
             for z in range(side + 1) for x in range(side + 1)]
    for z in range(side):
        for x in range(side):
            at = z * (side + 1) + x + 1
            lines += ["f %d %d %d" % (at, at + side + 1, at + 1), "f %d %d %d" % (at + 1, at + side + 1, at + side + 2)]
    (folder / "grid.obj").write_text("\n".join(lines) + "\n")
    (folder / "grid.json").write_text(json.dumps({
        "camera": {"look_from": [side / 2, side, 2 * side], "look_at": [side / 2, 0, side / 2]},
        "materials": {"m": {"type": "matte", "color": "#cc8866"}},
        "meshes": [{"file": "grid.obj", "material": "m", "smooth": True, "size": 1.5}]}))
    return 2 * side * side


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    few = write_grid(folder, 300)
    before = peak(folder, "grid.json")
    subprocess.run([sys.executable, FOREST, str(folder / "forest")], check=True)
    forest = peak(folder / "forest", "forest.json")
    print(f"the forest: {forest / 1e6:.0f} MB")
    # More than the copied points are kept up to 2 million triangles.
    many = write_grid(folder, 1010)
    each = (peak(folder, "grid.json") - before) / (many - few)
    print(f"a triangle: {each:.0f} bytes")
    if not forest < 1e9:
        sys.exit("the forest takes more than 1 GB")
    if not each <= 350:
        sys.exit("a triangle takes more than 350 bytes")
