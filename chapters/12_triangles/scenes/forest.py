#!/usr/bin/env python3
"""Writes a scene with a forest: forest.py FOLDER. Each of the 10,000 trees is the same mesh of 100,000
triangles, placed again; the ground is a mesh of its own. Needs nothing but Python."""
import json
import math
import random
import sys
from pathlib import Path

TREES, TRIANGLES = 10_000, 100_000


def spruce(lot):
    """A spruce of height 1: triangles on twigs on branches around a trunk, as the lines of an OBJ file."""
    lines, count = [], 0

    def add(*corners):
        nonlocal count
        lines.extend("v %.5f %.5f %.5f" % corner for corner in corners)
        lines.append("f -3 -2 -1")
        count += 1

    for i in range(12):  # the trunk
        a, b = (2 * math.pi * k / 12 for k in (i, i + 1))
        add((0.012 * math.cos(b), -0.03, 0.012 * math.sin(b)), (0.012 * math.cos(a), -0.03, 0.012 * math.sin(a)),
            (0, 1, 0))
    while count < TRIANGLES:
        height = 0.06 + 0.94 * (1 - math.sqrt(lot.random()))  # more of them below, where branches are longer
        whorl = round(height * 46) / 46  # branches grow in rings
        longest = 0.19 * (1 - whorl) ** 0.8 * (0.85 + 0.3 * ((whorl * 977) % 1))
        branch = lot.randrange(9) + 4.7 * whorl * 46
        along = math.sqrt(lot.random())
        turn = 2 * math.pi * branch / 9 + (lot.random() - 0.5) * 0.5 * along
        out = longest * along + 0.004
        drop = 0.30 * out - 0.9 * out * out / max(longest, 0.01) * 0.35
        x, y, z = out * math.cos(turn), whorl + 0.10 - drop - 0.09, out * math.sin(turn)
        aim = turn + (lot.random() - 0.5) * 2.2
        size = 0.006 + 0.010 * lot.random()
        dx, dy, dz = size * math.cos(aim), size * (lot.random() - 0.75), size * math.sin(aim)
        wx, wz = -0.18 * dz, 0.18 * dx
        add((x - wx, y, z - wz), (x + wx, y + 0.001, z + wz), (x + 2 * dx, y + dy, z + 2 * dz))
    return lines


def ground(x, z):
    """The height of the ground: ridges that rise behind each other."""
    far = max(0, -z)
    return (9 * math.sin(0.021 * x + 0.9) * math.sin(0.017 * z + 0.4) + 2.2 * math.sin(0.07 * x + 0.05 * z)
            + 0.00085 * far * far * (0.7 + 0.3 * math.sin(0.016 * x + 2)) - 0.11 * far + 16 * math.exp(-((z + 150) / 26) ** 2))


def main():
    if len(sys.argv) != 2:
        sys.exit("forest.py: name the folder for the scene, such as out/forest")
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    lot = random.Random(12)
    (folder / "spruce.obj").write_text("\n".join(spruce(lot)) + "\n")

    steps = 200
    lines = []
    for i in range(steps + 1):
        for k in range(steps + 1):
            x, z = 400 * (k / steps - 0.5), 40 - 380 * i / steps
            lines.append("v %.3f %.3f %.3f" % (x, ground(x, z), z))
    for i in range(steps):
        for k in range(steps):
            first = i * (steps + 1) + k + 1
            lines.append("f %d %d %d %d" % (first, first + 1, first + steps + 2, first + steps + 1))
    (folder / "ground.obj").write_text("\n".join(lines) + "\n")

    meshes = [{"file": "ground.obj", "material": "moss", "smooth": True}]
    while len(meshes) < TREES + 1:
        depth = 12 + 330 * math.sqrt(lot.random())
        x, z = (lot.random() - 0.5) * (16 + 1.25 * depth), 18 - depth
        size = (5 + 6 * lot.random() ** 2) * (0.7 if lot.random() < 0.25 else 1)
        meshes.append({"file": "spruce.obj", "center": [round(x, 3), round(ground(x, z), 3), round(z, 3)],
                       "size": round(size, 3), "rotate_deg": [0, lot.randrange(360), 0],
                       "material": lot.choice(["green", "green", "dark", "blue", "blue"] if lot.random() > 0.06 else ["larch"])})
    scene = {
        "about": "A forest of 10,000 trees of 100,000 triangles each, stored once",
        "camera": {"look_from": [0, 17, 30], "look_at": [0, 7, -60], "vfov_deg": 38},
        "sky": {"below": [1.1, 0.86, 0.66], "above": [0.55, 0.72, 1.0]},
        "haze": {"density": 0.0042, "color": [0.93, 0.70, 0.52]},
        "materials": {
            "green": {"type": "matte", "color": "#3f7a30"}, "dark": {"type": "matte", "color": "#245a3c"},
            "blue": {"type": "matte", "color": "#2a6a68"}, "larch": {"type": "matte", "color": "#e59a10"},
            "moss": {"type": "matte", "color": "#5a5f3c"},
            "sun": {"type": "light", "color": "#ffb46a", "strength": 26}},
        "spheres": [{"center": [-150, 110, -190], "radius": 34, "material": "sun"}],
        "meshes": meshes,
        "render": {"width": 800, "height": 450, "spp": 16, "depth": 5},
    }
    (folder / "forest.json").write_text(json.dumps(scene, separators=(",", ":")))


if __name__ == "__main__":
    main()
