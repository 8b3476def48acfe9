#!/usr/bin/env python3
"""Makes the pictures of the texts again.

    tests/pictures.py BUILD [NAME...]   makes docs/images/NAME.png, or all of them
    tests/pictures.py --compare BUILD [NAME...]
                                        says which committed picture is not what its command draws now, by a few samples
                                        in each pixel; with --first, only README's and the core chapters' first ones;
                                        with --exactly, by all of its samples
    tests/pictures.py --noise BUILD [NAME...]
                                        says how noisy a picture is; below 2.5 of 255, few people see it
    tests/pictures.py --check           says which committed picture has no command, which is wider than it is shown, and
                                        which drawing has no colors for dark pages or letters that are too small on a phone

The first two need these targets of a build with COURSE_ALL_TESTS=ON: solution_programs, float_programs, renderer_solution,
brick_wall, lake and mistake_tool. Most pictures take less than a minute; those of chapters 08 and 11 compile for longer.

Each picture is a line of RECIPES below: a program and its options, sometimes of a program with a known mistake, and
what is done with the pixels. What is not made here is made by the commands in OTHERS. The texts' figures,
docs/images/*.svg, are written by hand, but for a few stills of live figures. Most pictures of mistakes and
scenes have 256 colors at most; a chapter's own picture has all of them, since a test compares it with what the program
draws. As many samples are taken as bring --noise below 2.5, unless the noise is what a picture shows.
"""

import doctest
import functools
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
IMAGES, PLOTS = ROOT / "docs/images", ROOT / "docs/plots"
PAGE = 800  # pixels: the width of a page's text. A picture in a table has half of it
PHONE = 350  # pixels: the same on a phone of 390

OTHERS = {
    r"docs/plots/.*\.svg": "./course study --docs",
    r"docs/images/(00-memory|10-packs|11-points|13-schedule)\.svg": "node book/live/still.mjs FIGURE",
    r"docs/images/.*\.svg": "written by hand",
    r"docs/images/00-first-\d\.png": "python3 tests/00_toolchain/first_steps.py . --draw",
    r"docs/images/\d\d-tracer-.*\.png": "python3 tests/tracer_steps.py --draw",
    r"chapters/08_effects/scenes/planet\.png": "python3 chapters/08_effects/scenes/planet.py",
    r"tests/08_effects/fuzz/seeds/tiny\.png": "an input of a test, not a picture",
}
# What one sees first; and what has more than 256 colors, as a soft gradient needs, and a part that is shown enlarged, whose
# squares dots of two colors would break up.
FIRST = re.compile(r"0[0-57-9]_|final|overview")  # that of 06 needs all its samples, which takes long
ALL_COLORS = re.compile(r"\d\d_|final|overview|show|00-memory|0[02]-mistake|04-right|06-scene|08-haze|"
                        r"14-(dusk|even|rough)|11-(samplers|tent|errors|denoised)|accuracy|hard-quad")
# To be hung up; shown as wide as the window.
LARGE = {"final"}

# ---- Pixels --------------------------------------------------------------------------------------------------------


class Picture:
    """Rows of bytes: red, green, blue, red, ..."""

    def __init__(self, width, rows):
        self.width, self.height, self.rows = width, len(rows), rows

    def part(self, left, top, width, height):
        return Picture(width, [row[3 * left:3 * (left + width)] for row in self.rows[top:top + height]])

    def enlarged(self, times):
        rows = [b"".join(row[i:i + 3] * times for i in range(0, len(row), 3)) for row in self.rows]
        return Picture(times * self.width, [row for row in rows for _ in range(times)])

    def shrunk(self, width, height=None):
        """Each new pixel is the mean of the area that it covers."""
        height = height or round(self.height * width / self.width)

        def shares(many, few):
            for i in range(few):
                begin, end = i * many / few, (i + 1) * many / few
                first, last = int(begin), min(many, int(end - 1e-9) + 1)
                yield [(k, (min(k + 1, end) - max(k, begin)) * few / many) for k in range(first, last)]

        down = []
        for weights in shares(self.height, height):
            row = [0.0] * (3 * self.width)
            for k, weight in weights:
                row = [a + weight * b for a, b in zip(row, self.rows[k])]
            down.append(row)
        across = list(shares(self.width, width))
        return Picture(width, [bytes(int(sum(w * row[3 * k + c] for k, w in weights) + 0.5)
                                     for weights in across for c in range(3)) for row in down])


def beside(left, right, gap=0):
    white = b"\xff" * (3 * gap)
    return Picture(left.width + gap + right.width, [a + white + b for a, b in zip(left.rows, right.rows)])


def above(top, bottom):
    return Picture(top.width, top.rows + bottom.rows)


def difference(a, b, times):
    return Picture(a.width, [bytes(min(255, times * abs(p - q)) for p, q in zip(*rows))
                             for rows in zip(a.rows, b.rows)])


@functools.cache
def strokes():
    """The lines of each letter, as points; a capital reaches from row 0 to row 16."""
    code = (ROOT / "common/app/lettering.hpp").read_text()
    found = {" ": ""}
    for name, first in (("capitals", "A"), ("small", "a"), ("digits", "0")):
        body = re.search(name + r"\[\] = \{(.*?)\};", code, re.S)[1]
        found |= {chr(ord(first) + i): text for i, text in enumerate(re.findall(r'"(.*?)"', body))}
    found |= dict(re.findall(r"case '(.)':\s*return \"(.*?)\";", code))
    return {letter: [[(int(x), ord(y) - ord("a")) for x, y in re.findall(r"(\d)([a-u])", line)]
                     for line in text.split()] for letter, text in found.items()}


def with_words(picture, left, top, text, high=14, color=(60, 60, 60)):
    """The picture with words in it, whose capitals are so many pixels high; they begin on the left, or in the middle of
    the words if `left` is negative."""
    lines, x = [], 0
    for letter in text:
        own = strokes()[letter]
        lines += [[(x + a, b) for a, b in line] for line in own]
        x += max((a for line in own for a, _ in line), default=2) + 5.2
    unit = high / 16
    begin = left if left >= 0 else -left - unit * (x - 5.2) / 2
    rows = [bytearray(row) for row in picture.rows]
    for line in lines:
        for (a, b), (c, d) in zip(line, line[1:]):
            (a, b), (c, d) = ((begin + unit * p, top + unit * q) for p, q in ((a, b), (c, d)))
            for y in range(int(min(b, d)) - 2, int(max(b, d)) + 3):
                for px in range(int(min(a, c)) - 2, int(max(a, c)) + 3):
                    dx, dy, rx, ry = c - a, d - b, px + 0.5 - a, y + 0.5 - b
                    t = min(1, max(0, (rx * dx + ry * dy) / (dx * dx + dy * dy or 1)))
                    cover = min(1, max(0, high / 14 + 0.3 - math.hypot(rx - t * dx, ry - t * dy)))
                    for k in range(3):
                        old, new = rows[y][3 * px + k], color[k]
                        rows[y][3 * px + k] = round(old + cover * (new - old)) if abs(new - old) > 0 else old
    return Picture(picture.width, [bytes(row) for row in rows])


def read_ppm(path):
    data = path.read_bytes()
    magic, width, height, _ = data.split(None, 4)[:4]
    width, height = int(width), int(height)
    if magic == b"P3":
        values = bytes(map(int, data.split()[4:]))
    else:
        values = data[-3 * width * height:]
    return Picture(width, [values[i:i + 3 * width] for i in range(0, len(values), 3 * width)])


def read_png(path):
    """Of one that write_png made, or any other with 8 bits a channel, without transparency."""
    data, at, packed, palette = path.read_bytes(), 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", body[:10])
        palette = body if kind == b"PLTE" else palette
        packed += body if kind == b"IDAT" else b""
        at += length + 12
    channels = 3 if color == 2 else 1
    line = (width * channels * bits + 7) // 8
    raw, rows, before = zlib.decompress(packed), [], bytes(line)
    for y in range(height):
        kind, row = raw[y * (line + 1)], bytearray(raw[y * (line + 1) + 1:(y + 1) * (line + 1)])
        for i in range(line):
            left = row[i - channels] if i >= channels else 0
            corner = before[i - channels] if i >= channels else 0
            row[i] = row[i] + predicted(kind, left, before[i], corner) & 255
        rows.append(bytes(row))
        before = row
    if palette:
        each = 8 // bits
        rows = [b"".join(palette[3 * p:3 * p + 3] for p in
                         ((row[x // each] >> (8 - bits * (x % each + 1))) & ((1 << bits) - 1) for x in range(width)))
                for row in rows]
    return Picture(width, rows)


def predicted(kind, left, up, corner):
    """What PNG's filter of this kind subtracts."""
    if kind < 4:
        return (0, left, up, (left + up) // 2)[kind]
    guess = left + up - corner
    a, b, c = abs(guess - left), abs(guess - up), abs(guess - corner)
    return left if a <= b and a <= c else up if b <= c else corner


def palette_of(picture, most=256):
    """Up to `most` colors: the box of colors with the widest spread is halved, again and again, until there are
    enough."""
    count = {}
    for row in picture.rows:
        for i in range(0, len(row), 3):
            count[row[i:i + 3]] = count.get(row[i:i + 3], 0) + 1
    if len(count) <= most:
        return sorted(count)

    def spread(box):
        def variance(c):
            total = sum(count[color] for color in box)
            mean = sum(count[color] * color[c] for color in box) / total
            return sum(count[color] * (color[c] - mean) ** 2 for color in box)
        return max((variance(c), c) for c in range(3))

    boxes = [(spread(list(count)), list(count))]
    while len(boxes) < most:
        (_, axis), box = boxes.pop(max(range(len(boxes)), key=lambda i: boxes[i][0]))
        total = sum(count[color] for color in box)
        middle = sum(count[color] * color[axis] for color in box) / total
        for half in ([c for c in box if c[axis] <= middle], [c for c in box if c[axis] > middle]):
            boxes.append((spread(half), half))
    means = set()
    for _, box in boxes:
        total = sum(count[color] for color in box)
        means.add(bytes(round(sum(count[k] * k[c] for k in box) / total) for c in range(3)))
    return sorted(means)


def dithered(picture, colors):
    """Which of the colors each pixel gets. What it is off by, the pixels beside and below it make up for, so that a soft
    gradient has no steps. Source: Floyd and Steinberg, "An adaptive algorithm for spatial greyscale", 1976."""
    @functools.cache
    def nearest(red, green, blue):
        return min(((red - r) ** 2 + (green - g) ** 2 + (blue - b) ** 2, i) for i, (r, g, b) in enumerate(colors))[1]

    rows, below = [], [0.0] * (3 * picture.width + 6)
    for row in picture.rows:
        here, below = below, [0.0] * len(below)
        step = 3 if len(rows) % 2 == 0 else -3  # every other row from right to left, against patterns
        chosen = bytearray(picture.width)
        for x in range(picture.width)[::step // 3]:
            # If no color makes up for what is missing, it must not add up until one from far away does.
            wanted = [row[k] + min(8, max(-8, here[k + 3])) for k in range(3 * x, 3 * x + 3)]
            chosen[x] = nearest(*map(round, wanted))
            for k, (value, color) in enumerate(zip(wanted, colors[chosen[x]]), 3 * x + 3):
                off = (value - color) / 16
                here[k + step] += 7 * off
                below[k - step] += 3 * off
                below[k] += 5 * off
                below[k + step] += off
        rows.append(bytes(chosen))
    return rows


def write_png(path, picture, few_colors):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    def encoded(rows, color_type, extra=b""):
        channels = 3 if color_type == 2 else 1
        best, before = [], bytes(len(rows[0]))
        for row in rows:
            lefts, corners = bytes(channels) + row[:-channels], bytes(channels) + before[:-channels]
            lines = [bytes(p - predicted(kind, *q) & 255 for p, *q in zip(row, lefts, before, corners))
                     for kind in range(5)]
            kind = min(range(5), key=lambda k: sum(min(p, 256 - p) for p in lines[k]))
            best.append(bytes([kind]) + lines[kind])
            before = row
        packed = min((zlib.compress(data, 9) for data in (b"".join(best), b"".join(b"\0" + row for row in rows))),
                     key=len)
        header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, color_type, 0, 0, 0)
        return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra + chunk(b"IDAT", packed) + chunk(b"IEND", b"")

    if few_colors:
        colors = palette_of(picture)
        path.write_bytes(encoded(dithered(picture, colors), 3, chunk(b"PLTE", b"".join(colors))))
    else:
        path.write_bytes(encoded(picture.rows, 2))


# ---- Programs ------------------------------------------------------------------------------------------------------

build = folder = None
few_samples = None  # in a pixel, where a picture is only compared
seed = ()  # the option, where the same picture is drawn with other random numbers
enough = True  # whether the last picture had all its samples
drawn = {}  # by a program and its options


def draw(program, width, height, *options, mistake=None):
    """What a program of the build draws; with a mistake, or several with a + between them, built with it first."""
    options = [*options, "--quiet", "--width", str(width), "--height", str(height)]
    options += () if re.match("0[0-3]_", pathlib.Path(program).name) else seed
    return run(built(program, mistake), *with_few_samples(program, options))


def at_most(samples):
    """So many of them in a pixel; fewer for a comparison."""
    global enough
    enough = not few_samples
    return few_samples or samples


def with_few_samples(program, options):
    """The options with fewer samples, unless the picture shows how many there are, or colors that are no light."""
    noisy = re.match(r"0[4578]_|1[0234]_|renderer|lake", pathlib.Path(program).name)
    if not few_samples or not noisy or {"--target-error", "--show"} & set(options):
        return options
    at = options.index("--spp") if "--spp" in options else len(options)
    return [*options[:at], "--spp", str(at_most(0)), *options[at + 2:]]


def built(program, mistake=None):
    file = build / "bin" / program
    if mistake:
        file = folder / f"{program} {pathlib.Path(mistake).name}"
        if not file.exists():
            subprocess.run([build / "bin/mistake_tool", "program", mistake, program, file], check=True)
    return file


def run(file, *options):
    if not few_samples or (file, options) not in drawn:
        out = folder / "picture.ppm"
        subprocess.run([file, *options, "--out", out], check=True, cwd=ROOT)
        drawn[file, options] = read_ppm(out)
    return drawn[file, options]


def brick_wall(mistake=None):
    return lambda: run(built("brick_wall", mistake)).enlarged(3)


def chapter(name, width, height, *options):
    return lambda: draw(name + "_solution", width, height, *options)


def own():
    """With 128 samples, as tests/09_own/same_image.sh."""
    scene, out = folder / "many.txt", folder / "picture.ppm"
    many = (build / "own_start/scenes/many.txt").read_text()
    scene.write_text(re.sub(r"^(picture \d+ \d+) \d+", rf"\1 {at_most(128)}", many, flags=re.M))
    subprocess.run([build / "bin/09_own_solution", scene, out, *seed], check=True)
    return read_ppm(out)


def own_mistake(mistake):
    """Three balls, drawn by our answer to chapter 09 with a mistake in it."""
    def picture():
        text = (ROOT / "solutions/09_own/main.cpp").read_text()
        known = (ROOT / "tests/mistakes/09_own/steps.md").read_text()
        section = re.search(rf"^## {mistake}\n(.*?)(?=^## |\Z)", known, re.M | re.S)[1]
        for before, after in re.findall(r"```cpp\n(.*?)```\nwith\n```cpp\n(.*?)```", section, re.S):
            assert text.count(before) == 1, f"{mistake} does not match"
            text = text.replace(before, after)
        source, program, scene, out = (folder / f"{mistake}.{end}" for end in ("cpp", "program", "txt", "ppm"))
        source.write_text(text)
        start = (ROOT / "chapters/09_own/start/scenes/three.txt").read_text()
        scene.write_text(re.sub(r"^picture .*", f"picture 400 225 {at_most(400)} 50", start, flags=re.M))
        subprocess.run(["c++", "-std=c++20", "-O3", "-pthread", source, "-o", program], check=True)
        subprocess.run([program, scene, out, *seed], check=True)
        return read_ppm(out)
    return picture


def of_mistake(name, mistake, width, height, times):
    """A chapter's picture with a mistake, drawn so many times as large."""
    samples = ("--spp", "225") if name == "04_normals_aa" else ()  # its small picture has other parts: none to shrink
    return lambda: draw(name + "_solution", times * width, times * height, *samples, mistake=mistake).shrunk(width, height)


def edited(name, file, before, after, among="solutions"):
    """A folder with a change of a solution that is not among the known mistakes, to be named in place of one; or of a
    plain answer, among "tests/plain"."""
    header, changed = ROOT / among / name / file, folder / f"changed {abs(hash(after))}"
    text = header.read_text()
    assert text.count(before) == 1, f"{header} has changed"
    (changed / file).parent.mkdir(parents=True, exist_ok=True)
    (changed / file).write_text(text.replace(before, after))
    return changed


def edited_program(name, *edit):
    """A chapter's program with such a change."""
    program = folder / f"{name} {abs(hash(edit))}"
    if not program.exists():
        subprocess.run([build / "bin/mistake_tool", "program", edited(name, *edit), name + "_solution", program],
                       check=True)
    return program


def of_edit(name, width, height, *edit):
    """The same for such a change."""
    return lambda: draw(edited_program(name, *edit), 2 * width, 2 * height).shrunk(width, height)


def shown():
    """Four pictures of --show."""
    def of(word):
        return draw("05_metal_glass_solution", 800, 450, "--show", word).shrunk(398)
    gap = Picture(800, 4 * [b"\xff" * 2400])
    top, bottom = beside(of("normal"), of("distance"), 4), beside(of("sphere"), of("bounces"), 4)
    return above(above(top, gap), bottom)


def pot(mistake=lambda: None):
    """Where the spout begins."""
    return lambda: draw("12_triangles_solution", 1200, 675, "--scene", "pot", "--spp", "64",
                        mistake=mistake()).part(700, 130, 380, 330)


def light_through():
    """The plain answer, with a keep_side that keeps nothing."""
    return edited("12_triangles", "rt/smooth_normal.hpp", "    return reflect(direction, flat);\n",
                  "    return direction;\n", "tests/plain")


def clay(scene, *edit):
    """A ball under a lamp."""
    return lambda: draw(edited_program("12_triangles", *edit) if edit else "12_triangles_solution", 1200, 675,
                        "--scene", scene, "--spp", "64").part(308, 45, 585, 585).shrunk(266)


def glaze(mistake=None):
    return lambda: draw("12_triangles_solution", 400, 225, "--at", "1,1.4,0", "--fov", "1.2", "--spp", "169",
                        mistake=mistake)


def turntable():
    frames = [draw("13_cluster_solution", 200, 112, "--spp", "64", "--frame", str(k), "--frames", "4") for k in range(1, 5)]
    return beside(beside(*frames[:2]), beside(*frames[2:]))


def poster():
    """Drawn by eight ranks: which of them draws a tile at the edge is different each time."""
    out = folder / "poster.ppm"
    subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "8", build / "bin/13_cluster_solution",
                    "--threads", "1", "--width", "800", "--height", "450", "--tile", "25", "--tint", "--spp", "256",
                    "--out", out, *seed], check=True)
    return read_ppm(out)


def threads_scene(mistake=None, samples="100"):
    return lambda: draw("06_threads_solution", 480, 270, "--spp", samples, mistake=mistake).part(10, 10, 320, 180)


# Small lights leave white dots in a small picture, and a lens noise.
TIMES = {"lens": 2, **dict.fromkeys(("fog", "galaxy", "lights", "motion", "planets"), 3)}


def effects_scene(scene, mistake=None):
    times = TIMES.get(scene, 1)
    return lambda: draw("08_effects_solution", times * 320, times * 180, f"chapters/08_effects/scenes/{scene}.json",
                        mistake=mistake).shrunk(320)


def hard_case(scene, mistake=None, real=""):
    return lambda: draw("08_effects_solution" + real, 360, 240, f"docs/hard-cases/{scene}.json", "--spp", "64",
                        mistake=mistake)


# The light of each byte: the inverse of sRGB's curve.
LIGHT = [((k / 255 + 0.055) / 1.055) ** 2.4 if k > 10 else k / 255 / 12.92 for k in range(256)]


def without_curve(right):
    """The bytes of a program that writes light as it is, without sRGB's curve."""
    def made():
        picture = right()
        table = bytes(round(255 * light) for light in LIGHT)
        return Picture(picture.width, [bytes(row).translate(table) for row in picture.rows])
    return made


def nan_as_black():
    """Where a program does not refuse a NaN, as those of the course do, it may draw it as black."""
    program = folder / "nan_as_black"
    black = edited("04_normals_aa", "rt/jitter.hpp", "    return sum.mean(samples);\n",
                   "    const Color mean = sum.mean(samples);\n    return is_finite(mean) ? mean : Color{};\n")
    schlick = edited("05_metal_glass", "rt/dielectric.hpp", "glass.index, fresnel_reflectance,",
                     "glass.index, schlick_reflectance,")
    untested = edited("05_metal_glass", "rt/fresnel.hpp", "    if (eta > 1) {\n", "    if (false) {\n")
    names = f"{black}+{schlick}+{untested}+05.3_forgets_total_reflection"
    subprocess.run([build / "bin/mistake_tool", "program", names, "08_effects_solution", program], check=True)
    return draw(program, 360, 240, "docs/hard-cases/bubble.json", "--spp", "64")


def ending(name):
    return lambda: draw("04_normals_aa_solution", 1600, 900, "--depth", "2", "--ending",
                        name).part(638, 452, 360, 240)


def washers():
    parts = [draw("01_vectors_solution", 1280, 720, mistake=m).part(322, 184, 198, 225)
             for m in (None, "01.8_not_normalized")]
    return beside(*parts, gap=4)


def rough_ball():
    return beside(*(draw("05_metal_glass_solution", 960, 540, mistake=m).part(755, 65, 200, 200)
                    for m in (None, "05.2_absorbs_below")))


def schlick():
    return above(*(draw("05_metal_glass_solution", 1200, 675, mistake=m).part(800, 488, 400, 187)
                   for m in (None, "05.4_schlick_inner_cosine")))


def metal_glass(width, height, samples, *box):
    return lambda: draw("05_metal_glass_solution", width, height, "--spp", samples).part(*box)


def bvh_part(*box, mistake=None):
    return lambda: draw("07_bvh_solution", 980, 700, "--spp", "1", mistake=mistake).part(*box)


def waiting(top):
    return lambda: draw("06_threads_solution", 1160, 652).part(14, top, 790, 78)


def furnace():
    both = above(*(draw("08_effects_solution", 700, 140, "docs/hard-cases/furnace.json", mistake=m)
                   for m in (None, "05.2_absorbs_below")))
    for x, words in ((82, "fuzz 0"), (216, "0.1"), (350, "0.3"), (484, "0.6"), (617, "1")):
        both = with_words(both, -x, 116, words)
    return with_words(with_words(both, 16, 14, "folded up"), 16, 244, "absorbed")


def far_sphere(left):
    return lambda: draw("03_sphere_solution", 1280, 720).part(left, 372, 160, 160).enlarged(2)


def equal_time(*options):
    """A part of the cover; docs/accuracy.md says how long it takes."""
    return lambda: draw("renderer_solution", 400, 225, "chapters/08_effects/scenes/cover.json",
                        *options).part(84, 80, 130, 90).enlarged(3)


def bounces():
    """A batch after so many bounces."""
    a, b, c = (draw("10_batches_solution", 960, 540, "--spp", "144", "--depth", depth).part(30, 200, 264, 190)
               for depth in ("2", "3", "16"))
    return beside(beside(a, b, 4), c, 4)


def without_and_with(edit, times, *box):
    """A part of chapter 11's picture, on the left with a change of the solution."""
    return lambda: beside(*(draw(program, 800, 450).part(*box).enlarged(times)
                            for program in (edited_program("11_samples", *edit), "11_samples_solution")), gap=4)


def two_ways(one, other, times, *box):
    """A part of the cover with 16 samples in a pixel, drawn with one option and with another."""
    return lambda: beside(*(draw("renderer_solution", 800, 450, "chapters/08_effects/scenes/cover.json", "--spp", "16",
                                 *option).part(*box).enlarged(times) for option in (one, other)), gap=4)


def counts():
    """The final scene at an error of 0.02, and how many samples its tiles took."""
    return beside(*(draw("renderer_solution", 398, 224, "--target-error", "0.02", *options)
                    for options in ((), ("--show", "samples"))), gap=4)


def written(scene, width, height, *options):
    """A scene that its script writes."""
    def picture():
        subprocess.run([sys.executable, ROOT / f"chapters/{scene}.py", folder], check=True)
        return draw("renderer_solution", width, height, folder / f"{pathlib.Path(scene).name}.json", *options)
    return picture


def race(mistake=None):
    """Two runs of one program, which should be the same."""
    return lambda: difference(*(draw("08_effects_solution", 360, 240, "docs/hard-cases/far.json", "--spp", "64",
                                     "--threads", "4", mistake=mistake) for _ in range(2)), times=4)


RECIPES = {
    "00_toolchain": chapter("00_toolchain", 800, 450),
    "00-memory-map": lambda: draw("00_toolchain_solution", 1600, 900).part(42, 42, 730, 818),
    "01_vectors": chapter("01_vectors", 800, 450),
    "02_camera": chapter("02_camera", 800, 450),
    "03_sphere": chapter("03_sphere", 800, 450),
    "04_normals_aa": chapter("04_normals_aa", 800, 450, "--spp", "500"),
    "05_metal_glass": chapter("05_metal_glass", 800, 450, "--spp", "400"),
    "06_threads": chapter("06_threads", 800, 450, "--spp", "400"),
    "07_bvh": chapter("07_bvh", 784, 560),
    "08_effects": chapter("08_effects", 640, 360),
    "08-haze": lambda: draw("08_effects_solution", 640, 360, "chapters/08_effects/scenes/haze.json"),
    "09_own": own,
    "09-mistake-total_reflection_lost": own_mistake("steps_total_reflection_lost"),
    "10_batches": chapter("10_batches", 640, 360, "--spp", "256"),
    "11_samples": chapter("11_samples", 800, 450),
    "12_triangles": chapter("12_triangles", 800, 450, "--spp", "1024"),
    "13_cluster": chapter("13_cluster", 480, 270),
    "12-triangle": lambda: draw("12_triangles_solution", 400, 225, "--scene", "triangle"),
    "12-facets": lambda: draw("12_triangles_solution", 800, 450, "--scene", "facets", "--spp", "64").shrunk(400),
    "12-pot-through": pot(light_through),
    "12-pot": pot(),
    "12-pot-acne": pot(lambda: "12.4_no_error"),
    "12-terminator-round": clay("sphere"),
    "12-terminator-flat": clay("ball", "rt/smooth_normal.hpp", "    return sum;\n", "    return {};\n"),
    "12-terminator-lifted": clay("ball"),
    "12-nearest-pixel": glaze("12.6_nearest_pixel"),
    "12-mixed-pixels": glaze(),
    "12-forest": written("12_triangles/scenes/forest", 800, 450, "--spp", "16"),
    "12-boat": lambda: draw("renderer_solution", 640, 288, "chapters/12_triangles/scenes/boat.json", "--spp", "100"),
    "14_light": chapter("14_light", 480, 480, "--spp", "225"),
    "14-points": lambda: draw("14_light_solution", 800, 600, "--scene", "points").shrunk(400),
    "14-points-no-root": lambda: draw("14_light_solution", 800, 600, "--scene", "points",
                                      mistake="14.1_no_root").shrunk(400),
    "14-lanterns": lambda: draw("renderer_solution", 640, 360, "chapters/14_light/scenes/lanterns.json", "--spp", "121"),
    "14-plates": lambda: draw("14_light_solution", 600, 400, "--scene", "plates", "--spp", "144"),
    "14-dusk": lambda: draw("renderer_solution", 640, 320, "chapters/14_light/scenes/dusk.json", "--spp", "144"),
    **{f"14-sun-{ways}": lambda ways=ways: draw("14_light_solution", 400, 200, "--scene", "sun", "--ways", ways)
       for ways in ("bounces", "samples")},
    "14-evening": written("14_light/scenes/evening", 640, 400, "--spp", "256", "--sampler", "sobol", "--exposure", "0.3"),
    "14-rough": lambda: draw("renderer_solution", 640, 240, "chapters/14_light/scenes/rough.json", "--spp", "144"),
    **{f"14-plates-{ways}": lambda ways=ways: draw("14_light_solution", 400, 267, "--scene", "plates", "--spp", "16",
                                                   "--ways", ways) for ways in ("samples", "bounces", "balance", "power")},
    **{f"14-streets-{lamps}": lambda lamps=lamps: draw("14_light_solution", 400, 225, "--scene", "streets", "--spp", "16",
                                                       "--depth", "8", "--lamps", lamps) for lamps in ("list", "tree")},
    "14-party": lambda: draw("14_light_solution", 400, 400, "--scene", "party", "--spp", "256"),
    "14-party-evenly": lambda: draw("14_light_solution", 400, 400, "--scene", "party", "--spp", "4",
                                    mistake="14.2_mean"),
    "14-party-by-power": lambda: draw("14_light_solution", 400, 400, "--scene", "party", "--spp", "4"),
    "13-poster": poster,
    "13-turntable": turntable,
    "final": lambda: draw("08_effects_solution", 1280, 720, "--spp", "1024"),
    "overview": lambda: run(built("lake"), *with_few_samples("lake", ["--spp", "256", *seed])),
    "04-ending-sky": ending("sky"),
    "04-ending-black": ending("black"),
    "04-ending-roulette": ending("roulette"),
    "01-mistake-not_normalized": washers,
    "05-mistake-absorbs_below": rough_ball,
    "05-mistake-schlick_inner_cosine": schlick,
    "05-furnace": furnace,
    "06-slices-waiting": waiting(476),
    "06-tiles-waiting": waiting(558),
    "05-mirror": metal_glass(1200, 675, "324", 0, 90, 250, 240),
    "05-strip": metal_glass(800, 450, "64", 0, 325, 800, 125),
    "05-glass": metal_glass(1200, 675, "324", 280, 235, 640, 250),
    "show": shown,
    "06-scene": threads_scene(),
    "07-boxes": lambda: draw("07_bvh_solution", 480, 270, "--show", "boxes"),
    "07-levels": bvh_part(585, 7, 387, 403),
    "07-slices": bvh_part(585, 7, 387, 403, mistake="07.3_always_x"),
    "07-maps": bvh_part(7, 417, 641, 235),
    "07-maps-by-area": bvh_part(331, 417, 641, 235),
    "08-mistake-only_the_last": effects_scene("glass", "08.1_only_the_last"),
    "08-mistake-same_direction": effects_scene("lens", "08.2_same_direction"),
    "08-mistake-radius_for_diameter": effects_scene("lens", "08.2_radius_for_diameter"),
    "08-mistake-counts_twice": effects_scene("lights", "08.4_counts_twice"),
    "08-mistake-area_for_solid_angle": effects_scene("lights", "08.3_area_for_solid_angle"),
    "10-first-bounce": lambda: draw("10_batches_solution", 640, 360, "--spp", "256", "--depth", "1"),
    "10-bounces": bounces,
    "11-errors": lambda: draw("11_samples_solution", 800, 450).part(0, 350, 200, 100).enlarged(2),
    "11-counts": counts,
    "11-samplers": two_ways(("--sampler", "jittered"), ("--sampler", "sobol"), 2, 110, 150, 199, 120),
    "11-tent": two_ways(("--filter", "box", "--sampler", "sobol"), ("--filter", "tent"), 3, 190, 170, 132, 90),
    "11-clamped": without_and_with(("rt/tone_curve.hpp", "    return color / before * tone_curve(before, white);\n",
                                    "    return color;\n"), 1, 200, 0, 398, 260),
    "11-denoised": without_and_with(("rt/denoise.hpp", "    return smooth;\n", "    return picture;\n"),
                                    2, 601, 110, 199, 200),
    "11-mistake-same_points": of_edit("11_samples", 400, 225, "rt/sobol.hpp", "    return reversed_bits(x);\n",
                                      "    return fraction;\n"),
    "11-mistake-distance_only": of_edit("11_samples", 400, 225, "rt/denoise.hpp",
                                        "y * y + color + dot(normal, normal)", "y * y"),
    "hard-quadratic-plain": far_sphere(934),
    "hard-quadratic-stable": far_sphere(1107),
    "hard-acne-plain": hard_case("small", "04.6_stays_on_surface"),
    "hard-acne-stable": hard_case("small"),
    "hard-small-plain": hard_case("small", "04.7_smallest_t"),
    "hard-small-stable": hard_case("small"),
    "hard-far-plain": hard_case("far", "04.1_from_far_origin+04.6_fixed_distance", "_float"),
    "hard-far-stable": hard_case("far", real="_float"),
    "hard-slabs-plain": brick_wall("07.1_nan_wins"),
    "hard-slabs-stable": brick_wall(),
    "hard-normal-plain": hard_case("pebbles", "08.5_normal_not_unit"),
    "hard-normal-stable": hard_case("pebbles"),
    "hard-total-plain": nan_as_black,
    "hard-total-stable": hard_case("bubble"),
    "hard-fuzz-plain": hard_case("rough", "05.2_absorbs_below"),
    "hard-fuzz-stable": hard_case("rough"),
    "hard-star-plain": hard_case("star", "08.3_cancels", "_float"),
    "hard-star-stable": hard_case("star", real="_float"),
    "hard-srgb-plain": without_curve(hard_case("far")),
    "hard-srgb-stable": hard_case("far"),
    "hard-race-plain": race("06.4_shared_generator"),
    "hard-race-stable": race(),
    "accuracy-jittered": equal_time("--spp", "16"),
    "accuracy-together": equal_time("--spp", "36", "--batches", "--sampler", "sobol", "--filter", "tent"),
}
for scene in ("cover", "fog", "galaxy", "glass", "haze", "lens", "lights", "matte", "metal", "motion", "own", "planets",
              "textures"):
    RECIPES["08-scene-" + scene] = effects_scene(scene)
for name, width, height, times, mistakes in (
        ("00_toolchain", 400, 225, 2, "00.2_across_is_down 00.2_whole_numbers 00.3_flips_twice 00.4_splits_off_one "
         "00.5_leads_into_the_old_chain"),
        ("01_vectors", 400, 225, 2, "01.2_forgets_z 01.5_turned_around 01.6_rows_for_columns"),
        ("02_camera", 400, 225, 1, "02.1_upside_down 02.1_corner_as_middle 02.2_degrees 02.2_whole_angle "
         "02.2_half_height 02.3_mirrored 02.3_up_as_v 02.3_not_normalized 02.4_forgets_minus "
         "02.4_row_before_column"),
        ("03_sphere", 400, 225, 1, "03.1_forgets_half 03.2_far_side 03.2_forgets_center 03.2_behind_the_ray "
         "03.2_ignores_interval 03.2_never_inside 03.2_textbook_discriminant 03.2_solver_of_rounded_numbers "
         "03.4_upside_down 03.4_columns_first 03.4_no_srgb 03.4_blue_first"),
        ("04_normals_aa", 360, 202, 1, "04.1_not_unit 04.1_side_swapped 04.2_both_sides 04.2_half_lambert "
         "04.3_no_root 04.3_uniform_hemisphere 04.3_not_turned 04.6_stays_on_surface 04.7_last_attenuation "
         "04.7_sky_of_the_eye"),
        ("05_metal_glass", 400, 225, 2, "05.1_wrong_sign 05.2_darkens 05.2_fuzz_around_normal "
         "05.3_ratio_upside_down 05.3_stays_on_this_side 05.5_never_reflects 05.5_lots_swapped "
         "05.5_always_entering 05.5_outward_normal 05.5_total_reflection_is_lost"),
        ("07_bvh", 400, 286, 2, "07.2_radius_once 07.3_drops_the_middle 07.3_always_x "
         "07.4_only_nearest_child 07.4_farthest_first"),
        ("10_batches", 320, 180, 1, "10.2_first_child_only 10.3_farther"),
        ("11_samples", 400, 225, 2, "11.5_by_channel")):
    for mistake in mistakes.split():
        RECIPES[f"{name[:2]}-mistake-{mistake[5:]}"] = of_mistake(name, mistake, width, height, times)
# What stands beside the mistakes: the same picture, as large, without one.
RECIPES["04-right-spheres"] = of_mistake("04_normals_aa", None, 360, 202, 1)
RECIPES["07-right-galaxy"] = of_mistake("07_bvh", None, 400, 286, 2)
for mistake, samples in (("06.3_forgets_the_rim", "100"), ("06.3_skips_the_first", "100"),
                         ("06.4_neighbors_alike", "16"), ("06.4_ignores_sample", "16")):  # these show their noise
    RECIPES["06-mistake-" + mistake[5:]] = threads_scene(mistake, samples)


# ---- The check -----------------------------------------------------------------------------------------------------

def shown_widths():
    """How wide the texts show each picture, at most."""
    widths = {}
    for text in [*ROOT.glob("docs/**/*.md"), ROOT / "README.md"]:
        for line in text.read_text(encoding="utf-8").splitlines():
            width = PAGE // 2 if line.startswith("|") else PAGE
            for link in re.findall(r"\]\(([^)#\s]*\.png)\)", line):
                file = (text.parent / link).resolve()
                widths[file] = max(width, widths.get(file, 0))
    return widths


def faults_of_drawing(svg):
    """What a drawing lacks: colors for dark pages, or letters that can be read.

    >>> drawing = '<svg viewBox="0 0 800 9"><style>%s</style><text fill="#333" font-size="%s">a</text></svg>'
    >>> faults_of_drawing(drawing % ('@media(prefers-color-scheme:dark){text[fill="#333"]{fill:#ccc}}', 21))
    []
    >>> len(faults_of_drawing(drawing % ("", 20)))
    2
    >>> faults_of_drawing('<svg viewBox="0 0 520 9"><style>.plot{font:13px sans-serif}</style></svg>')
    ['letters of 8.8 pixels on a phone, 9 is the least']
    """
    style = "".join(re.findall(r"<style>@media\(prefers-color-scheme:dark\).*?</style>", svg, re.S))
    named = {f'[{what}="{color}"]' for what, color in re.findall(r' (fill|stroke|stop-color)="(#\w+)"', svg)}
    without = sorted(rule for rule in named if rule not in style)
    faults = [f"{without[0]} has no color for dark pages: node book/dark.mjs"] if without else []
    shown = min(1, PHONE / float(re.search(r'viewBox=.\S+ \S+ (\S+)', svg)[1]))
    least = min(map(float, re.findall(r'font(?:-size)?(?:="|:)([\d.]+)', svg)), default=16)
    return faults + ([f"letters of {least * shown:.1f} pixels on a phone, 9 is the least"] if least * shown < 9 else [])


def check():
    wrong, widths, last = [], shown_widths(), subprocess.run(
        ["git", "ls-files", "*.png", "*.jpg", "*.svg", "*.ppm", "*.webp", "*.gif"], cwd=ROOT, check=True,
        capture_output=True, text=True).stdout.split("\n")
    files = [name for name in last if name and (ROOT / name).exists()]
    for name in files:
        file = ROOT / name
        made = file.parent == IMAGES and file.stem in RECIPES
        if not made and not any(re.fullmatch(pattern, name) for pattern in OTHERS):
            wrong.append(f"{name}: no command makes it; give it a line in tests/pictures.py")
        if file.parent == IMAGES and file.suffix == ".png":
            if file not in widths:
                wrong.append(f"{name}: no text shows it")
            elif file.stem not in LARGE and struct.unpack(">I", file.read_bytes()[16:20])[0] > widths[file]:
                wrong.append(f"{name}: wider than the {widths[file]} pixels that it is shown with")
        if file.parent in (IMAGES, PLOTS) and file.suffix == ".svg":
            wrong += [f"{name}: {why}" for why in faults_of_drawing(file.read_text(encoding="utf-8"))]
    present = {pathlib.Path(name).stem for name in files}
    wrong += [f"docs/images/{name}.png: is made by tests/pictures.py, but not there"
              for name in RECIPES if files and name not in present]
    print("\n".join(wrong) or f"{len(files)} pictures, none wider than it is shown; each has a command, and each drawing "
          "has colors for dark pages")
    return 1 if wrong else 0


# What no two runs draw alike: which rank draws a tile, and what threads do to each other. And what cannot be drawn
# again now: mistake_tool builds no program in float.
NOT_COMPARED = {"13-poster", "hard-race-plain", "hard-far-plain", "hard-star-plain"}
NOISY = {"08-scene-fog", "14-lanterns", "14-plates", "14-plates-samples", "14-plates-bounces", "14-plates-balance",
         "14-plates-power", "14-rough", "14-streets-list", "14-streets-tree", "14-sun-bounces"}
# Which rays this mistake loses depends on the others of their batch, and so on the number of samples.
ALL_SAMPLES = {"10-mistake-first_child_only"}
SQUARE = 16  # pixels


def mean_lights(picture):
    """The mean light of each square, as the color that shows it. Fewer samples make more noise, but they do not change
    the mean of the light."""
    for top in range(0, picture.height - SQUARE + 1, SQUARE):
        sums = [sum(column) / SQUARE ** 2 for column in
                zip(*([LIGHT[k] for k in row] for row in picture.rows[top:top + SQUARE]))]
        for left in range(0, 3 * (picture.width - SQUARE + 1), 3 * SQUARE):
            lights = [sum(sums[left + c:left + 3 * SQUARE:3]) for c in range(3)]
            yield [255 * (1.055 * light ** (1 / 2.4) - 0.055 if light > 0.0031 else 12.92 * light) for light in lights]


def pixels(picture):
    return (row[i:i + 3] for row in picture.rows for i in range(0, len(row), 3))


def compare(names, exactly):
    """Which committed pictures are not what their commands draw: with a few samples, one square in a hundred has
    another color; exactly, one pixel in a thousand."""
    global few_samples, enough
    wrong = 0
    for name in names:
        few_samples, enough = None if exactly or name in ALL_SAMPLES else 16 if name in NOISY else 4, True
        here, there = RECIPES[name](), read_png(IMAGES / f"{name}.png")
        sizes = [f"{picture.width} x {picture.height}" for picture in (here, there)]
        # A palette of 256 colors is off by less than 8, and four samples in a pixel by less than 16.
        allowed = 1 if exactly else 16 if not enough else 4 if ALL_COLORS.match(name) else 8
        parts, few, what = (pixels, 1000, "pixels") if exactly else (mean_lights, 100, f"squares of {SQUARE} pixels")
        off = [max(abs(a - b) for a, b in zip(*both)) for both in zip(parts(here), parts(there))]
        many = sum(each > allowed for each in off)
        if sizes[0] != sizes[1] or many > len(off) / few:
            wrong += 1
            print(f"docs/images/{name}.png is not what its command draws: " +
                  (f"{sizes[1]} pixels, expected {sizes[0]}" if sizes[0] != sizes[1] else
                   f"{many} of {len(off)} {what} differ by more than {allowed} of 255"), flush=True)
    print(f"{len(names) - wrong} of {len(names)} pictures are what their commands draw")
    return 1 if wrong else 0


SMALL = 8  # pixels: the squares that noise is measured in


def blocks(picture):
    """The bytes of each small square, row by row."""
    for top in range(0, picture.height - SMALL + 1, SMALL):
        for left in range(0, 3 * (picture.width - SMALL + 1), 3 * SMALL):
            yield [row[left:left + 3 * SMALL] for row in picture.rows[top:top + SMALL]]


def mean_difference(pairs):
    differences = [abs(a - b) for a, b in pairs]
    return sum(differences) / len(differences)


def noise(names):
    """How much two pictures with other random numbers differ at a pixel, of 255: in the flat half of the squares, and in
    the noisiest tenth. Neighbors differ as much by their noise, but also by what the picture shows."""
    global seed
    for name in names:
        pictures = []
        for seed in ("--seed", "1"), ("--seed", "2"):
            pictures.append(RECIPES[name]())
        squares = sorted(
            (mean_difference((row[i], row[i + 3]) for row in a for i in range(len(row) - 3)),
             mean_difference(both for rows in zip(a, b) for both in zip(*rows)))
            for a, b in zip(*map(blocks, pictures)))
        flat, all_of_them = [n for _, n in squares[:(len(squares) + 1) // 2]], sorted(n for _, n in squares)
        noisiest = all_of_them[-((len(squares) + 9) // 10):]
        print(f"{name}: noise {sum(flat) / len(flat):.2f}, in the noisiest tenth {sum(noisiest) / len(noisiest):.2f}",
              flush=True)
    return 0


def main(words):
    global build, folder
    if words == ["--check"]:
        return check() or doctest.testmod()[0]
    compared = words[:1] == ["--compare"]
    measured = words[:1] == ["--noise"]
    first, exactly = (compared and words[1:2] == [option] for option in ("--first", "--exactly"))
    words = words[measured + compared + first + exactly:]
    if not words or words[0].startswith("-") or set(words[1:]) - set(RECIPES):
        print(__doc__, file=sys.stderr)
        return 2
    build = pathlib.Path(words[0]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if measured:
            return noise(words[1:] or list(RECIPES))
        if compared:
            return compare(words[1:] or [name for name in RECIPES
                                         if FIRST.match(name) or not first and name not in NOT_COMPARED], exactly)
        for each in words[1:] or [name for name in RECIPES if name not in LARGE]:
            few_colors = not ALL_COLORS.match(each)
            write_png(IMAGES / f"{each}.png", RECIPES[each](), few_colors)
            print(f"docs/images/{each}.png: {(IMAGES / f'{each}.png').stat().st_size} bytes", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
