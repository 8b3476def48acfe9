#!/usr/bin/env python3
"""Writes a scene: evening.py FOLDER. A room with a round window over a lake, after sunset, two lanterns, and a golden
knot. Needs nothing but Python."""
import json
import math
import shutil
import struct
import sys
from pathlib import Path


def sky(up, turn):
    """The light from a direction: `up` is the sine of its height, `turn` the angle from where the sun has set."""
    glow = math.exp(-((turn / 0.6) ** 2))
    height = max(0.0, up)
    bands = [(0.0, (1.5, 0.62, 0.20)), (0.07, (1.35, 0.42, 0.26)), (0.19, (0.62, 0.26, 0.42)),
             (0.38, (0.17, 0.19, 0.50)), (1.0, (0.05, 0.14, 0.30))]
    for (low, below), (high, above) in zip(bands, bands[1:]):
        if height <= high:
            part = (height - low) / (high - low)
            break
    color = [a + part * (b - a) for a, b in zip(below, above)]
    opposite = math.exp(-(((math.pi - abs(turn)) / 0.7) ** 2) - (height / 0.5) ** 2)
    mixed = [(0.05 + 0.95 * glow) * c + opposite * d for c, d in zip(color, (0.62, 0.80, 1.2))]
    sun = math.exp(-((turn / 0.16) ** 2) - (up / 0.05) ** 2)  # the last light, in haze
    return [c + sun * s for c, s in zip(mixed, (2.4, 1.1, 0.25))]


def write_sky(file, width=1024, height=512):
    """As a PFM file: three floats a pixel, the lowest row first."""
    data = bytearray(f"PF\n{width} {height}\n-1.0\n".encode())
    for row in reversed(range(height)):
        up = math.cos(math.pi * (row + 0.5) / height)
        for column in range(width):
            turn = 2 * math.pi * ((column + 0.5) / width - 0.5)
            data += struct.pack("<3f", *(sky(up, turn) if up > 0 else (0.02, 0.03, 0.05)))
    file.write_bytes(data)


def write_mesh(file, points, faces):
    lines = ["v %.4f %.4f %.4f" % point for point in points]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    file.write_text("\n".join(lines) + "\n")


def wall_with_window(radius, center, half_width, height, thickness, count=96):
    """A wall from the floor to `height`, with a round hole: its front, the rim of the hole, and its back."""
    cx, cy = center
    rings = []
    for z in (0, -thickness):
        circle, edge = [], []
        for i in range(count):
            a = 2 * math.pi * i / count
            dx, dy = math.cos(a), math.sin(a)
            circle.append((cx + radius * dx, cy + radius * dy, z))
            # Where the ray from the middle of the hole meets the edge of the wall.
            reach = min(((half_width if dx > 0 else -half_width) - cx) / dx if abs(dx) > 1e-9 else math.inf,
                        ((height if dy > 0 else 0) - cy) / dy if abs(dy) > 1e-9 else math.inf)
            edge.append((cx + reach * dx, cy + reach * dy, z))
        rings += [circle, edge]
    points = [point for ring in rings for point in ring]
    faces = []
    for i in range(count):
        j = (i + 1) % count
        faces += [(i, j, count + j, count + i), (2 * count + i, 2 * count + j, j, i),
                  (3 * count + i, 3 * count + j, 2 * count + j, 2 * count + i)]
    # The corners of the wall, which no ray meets exactly.
    for x in (-half_width, half_width):
        for y in (0, height):
            corner = len(points)
            points.append((x, y, 0))
            near = sorted(range(count, 2 * count), key=lambda k: math.dist(points[k], (x, y, 0)))
            across = next(k for k in near if abs(points[k][1] - y) < 1e-6)
            along = next(k for k in near if abs(points[k][0] - x) < 1e-6)
            faces.append((corner, across, along))
    return points, faces


def knot(around=240, across=20, thick=0.34):
    """A trefoil knot, a tube around a curve."""
    def curve(t):
        out = (2 + math.cos(3 * t)) / 2
        return out * math.cos(2 * t), out * math.sin(2 * t), math.sin(3 * t) / 1.6

    def unit(v):
        length = math.sqrt(sum(x * x for x in v))
        return tuple(x / length for x in v)

    def cross(a, b):
        return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]

    points, faces = [], []
    for i in range(around):
        t = 2 * math.pi * i / around
        at, ahead = curve(t), curve(t + 1e-4)
        along = unit([b - a for a, b in zip(at, ahead)])
        # From the axis outward, and square to the curve.
        side = unit(cross(along, cross((at[0], at[1], 0.3 * at[2]), along)))
        other = cross(along, side)
        for k in range(across):
            a = 2 * math.pi * k / across
            points.append(tuple(p + thick * (math.cos(a) * s + math.sin(a) * o) for p, s, o in zip(at, side, other)))
    for i in range(around):
        for k in range(across):
            i2, k2 = (i + 1) % around, (k + 1) % across
            faces.append((i * across + k, i2 * across + k, i2 * across + k2, i * across + k2))
    return points, faces


def box(x, y, z):
    """From -x to x, 0 to y, and -z to z."""
    points = [(a, b, c) for a in (-x, x) for b in (0, y) for c in (-z, z)]
    return points, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def lantern(center, size, turn):
    place = {"center": center, "size": size, "rotate_deg": [0, turn, 0]}
    return [{"file": "lantern.obj", **place, "emits": [7.0, 0.85, 0.22]},
            {"file": "frame.obj", **place, "material": "wood"}]


SCENE = {
    "about": "A room over a lake, after sunset: a round window, two lanterns and a golden knot.",
    "camera": {"look_from": [-0.9, 1.55, 9.2], "look_at": [-0.25, 1.62, 0], "vfov_deg": 29},
    "sky": {"image": "evening.pfm", "scale": 1.0, "rotate_deg": -9},
    "materials": {
        "plaster": {"type": "matte", "color": "#b4bccb"},
        "wood": {"type": "matte", "color": "#4a2c1f"},
        "stone": {"type": "matte", "color": "#6f6d94"},
        "floor": {"type": "rough", "color": "#a9b4cc", "roughness": 0.2},
        "lake": {"type": "rough", "color": "#8fb3bd", "roughness": 0.07},
        "hill": {"type": "matte", "color": "#5b4d8c"},
        "far hill": {"type": "matte", "color": "#a58ac0"},
        "gold": {"type": "rough", "color": "#ffc860", "roughness": 0.28},
        "pearl": {"type": "matte", "color": "#e9d8c4"},
        "teal": {"type": "matte", "color": "#2f8f8a"},
    },
    "spheres": [
        {"center": [0, -10000.6, 0], "radius": 10000, "material": "lake"},
        {"center": [-16, -38, -95], "radius": 44, "material": "hill"},
        {"center": [38, -70, -130], "radius": 78, "material": "hill"},
        {"center": [6, -150, -210], "radius": 164, "material": "far hill"},
        {"center": [-2.05, 0.34, 1.5], "radius": 0.34, "material": "pearl"},
        {"center": [-1.32, 0.22, 2.0], "radius": 0.22, "material": "teal"},
    ],
    "meshes": [
        {"file": "wall.obj", "center": [0, 0, -1.2], "material": "plaster"},
        {"file": "floor.obj", "center": [0, -0.2, 3], "material": "floor"},
        {"file": "side.obj", "center": [-4.7, 0, 3], "material": "plaster"},
        {"file": "side.obj", "center": [4.7, 0, 3], "material": "plaster"},
        {"file": "floor.obj", "center": [0, 4.5, 3], "material": "wood"},
        {"file": "pedestal.obj", "center": [0.95, 0, 0.5], "material": "stone"},
        {"file": "knot.obj", "center": [0.95, 1.62, 0.5], "size": 0.52, "rotate_deg": [0, 24, 90], "material": "gold",
         "smooth": True},
        *lantern([-2.5, 2.85, 0.3], 0.7, 15),
        *lantern([3.15, 0.42, 0.2], 0.4, 30),
        {"file": "cord.obj", "center": [-2.5, 3.5, 0.3], "material": "wood"},
    ],
    "render": {"width": 800, "height": 500, "spp": 64, "depth": 7},
}


def main():
    if len(sys.argv) != 2:
        sys.exit("expected a folder: evening.py FOLDER")
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    write_sky(folder / "evening.pfm")
    write_mesh(folder / "wall.obj", *wall_with_window(1.75, (0.95, 2.0), 4.7, 4.5, 0.35))
    write_mesh(folder / "floor.obj", *box(5, 0.2, 4.6))
    write_mesh(folder / "side.obj", *box(0.1, 4.6, 4.6))
    write_mesh(folder / "pedestal.obj", *box(0.55, 0.75, 0.55))
    write_mesh(folder / "cord.obj", *box(0.012, 1.3, 0.012))
    write_mesh(folder / "knot.obj", *knot())
    for name in ("lantern.obj", "frame.obj"):
        shutil.copy(Path(__file__).with_name(name), folder / name)
    (folder / "evening.json").write_text(json.dumps(SCENE, indent=2) + "\n")


if __name__ == "__main__":
    main()
