#!/usr/bin/env python3
"""The core alone: answers in the plain form that the texts show first pass every core.

For each chapter, compiles each exercise's answer with the plain headers of tests/plain in place of
the solutions', in both precisions, and runs the core of its test cases. Then again with some of the
chapter's exercises as in the solutions, as for a learner who has taken some stars. An exercise
without a plain header there or an edit here has no simpler form than the solution.

core_path.py BUILD [NN_topic...]     Needs the programs check.NN.k and mistake_tool of the build.
"""

import concurrent.futures
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PLAIN = ROOT / "tests" / "plain"

# Solutions that become plain by another line.
EDITS = {
    "00_toolchain/rt/canvas.hpp": [(
        "        // Before any memory is allocated: an object whose constructor throws is never destroyed.\n"
        "        if (width < 1 || height < 1)\n"
        '            throw std::invalid_argument("a canvas needs at least 1x1 pixels");\n', "")],
    "03_sphere/rt/ppm.hpp": [(
        '        if (!is_finite(c)) throw std::logic_error("a pixel\'s color is not finite: this is a bug");\n',
        "")],
    "06_threads/rt/render_tiles.hpp": [(
        "    return pixels / tile_size + (pixels % tile_size != 0);",
        "    return (pixels + tile_size - 1) / tile_size;")],
    "06_threads/rt/sample_rng.hpp": [
        ("#include <rt/color_sum.hpp>", "#include <rt/color.hpp>"),
        ("    ColorSum sum;", "    Color sum;"), ("sum.add(draw(sample, random))", "sum += draw(sample, random)"),
        ("return sum.mean(samples)", "return sum / static_cast<Real>(samples)")],
    "07_bvh/rt/build.hpp": [(
        "level < most_levels ? split(order, boxes) : split_in_half(order, boxes)", "split(order, boxes)")],
}


def plain_files(chapter):
    """The plain answers of a chapter: text by name, such as rt/cross.hpp."""
    files = {str(f.relative_to(PLAIN / chapter)): f.read_text() for f in (PLAIN / chapter).rglob("*.hpp")}
    for name, edits in EDITS.items():
        if not name.startswith(chapter + "/"):
            continue
        text = (ROOT / "solutions" / name).read_text()
        for before, after in edits:
            if text.count(before) != 1:
                sys.exit(f"core_path: {name}: not once: {before}")
            text = text.replace(before, after)
        files[name.split("/", 1)[1]] = text
    return files


def check(build, folder, overlay, exercise, precision):
    """Runs the core of an exercise's test cases; returns what failed, or nothing."""
    target = "answer." + exercise + (".float" if precision == "float" else "")
    place = folder / target
    place.mkdir(parents=True)
    library = place / f"libanswer.{exercise}.so"
    made = place / f"{folder.name} {target}"  # mistake_tool works in a folder of this name
    built = subprocess.run([build / "bin/mistake_tool", "program", overlay, target, made],
                           capture_output=True, text=True)
    if built.returncode:
        return built.stdout + built.stderr
    made.rename(library)
    program = build / "check" / target.replace("answer.", "check.")
    run = subprocess.run([program, "~[hard]"], capture_output=True, text=True, timeout=300,
                         env=dict(os.environ, LD_LIBRARY_PATH=str(place), COURSE_ANSWER=str(place)))
    shutil.rmtree(place)
    if run.returncode or "No tests ran" in run.stdout:
        return run.stdout[-3000:] + run.stderr[-2000:]
    return ""


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    chapters = [c for c in json.loads((ROOT / "course.json").read_text())["chapters"]
                if not sys.argv[2:] or c["name"] in sys.argv[2:]]
    below = build / "core_path"
    shutil.rmtree(below, ignore_errors=True)
    jobs = []
    for chapter in chapters:
        files = plain_files(chapter["name"])
        exercises = [e for e in chapter["exercises"]
                     if (ROOT / "tests" / chapter["name"] / e["id"] / "answer.cpp").exists()]
        if not files:
            continue
        rng = random.Random(chapter["name"])
        stars = rng.sample(exercises, len(exercises) // 2)
        for way, solved in ("plain", []), ("some_stars", stars):
            overlay = below / f"{chapter['name']}_{way}"
            overlay.mkdir(parents=True)
            for name, text in files.items():
                if any(name in e["files"] for e in solved):
                    continue
                (overlay / name).parent.mkdir(parents=True, exist_ok=True)
                (overlay / name).write_text(text)
            for precision in ("double", "float") if way == "plain" and chapter["uses_real"] else ("double",):
                jobs += [(below / f"{way}_{chapter['name']}", overlay, e["id"], precision)
                         for e in exercises if e not in solved]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for job, wrong in zip(jobs, pool.map(lambda job: check(build, *job), jobs)):
            if wrong:
                failed += 1
                print(f"FAILS: {job[2]} in {job[3]}, {job[0].name}:\n{wrong}")
    shutil.rmtree(below, ignore_errors=True)
    print(f"core_path: {len(jobs)} cores, {failed} fail")
    return 1 if failed or not jobs else 0


sys.exit(main())
