#!/usr/bin/env python3
"""The core alone: answers in the plain form that the texts show first pass every core.

For each chapter, compiles each exercise's answer with the plain headers of tests/plain in place of
the solutions', in both precisions, and runs the core of its test cases. Then twice more, with some of
the chapter's exercises as in the solutions, as for a learner who has taken some stars; an answer that
includes the same plain headers as before is not tried again. An exercise without a plain header there
or an edit here has no simpler form than the solution.

With the plain headers of all chapters so far, a chapter's program draws a small picture, no line of
its certificate fails but those of stars, and our answer to its graft passes. `course compare` calls
its picture right: it is the solution's, or it becomes the solution's picture with the solution's code
for the exercises whose stars are open. In that case it becomes so with each plain answer of a core chapter
alone, too.

core_path.py BUILD [NN_topic...]     Needs the programs check.NN.k, plain.NN.k, tracer.NN, NN_topic_solution,
                                     mistake_tool, graft_mistakes and compare_programs of the build.
"""

import concurrent.futures
import functools
import json
import os
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PLAIN = ROOT / "tests" / "plain"

# Solutions that become plain by another line.
EDITS = {
    "00_toolchain/rt/canvas.hpp": [
        ("Canvas(Canvas&& other) noexcept", "Canvas(Canvas&& other)"),
        ("operator=(Canvas other) noexcept", "operator=(Canvas other)"), (
        "        // Checked before any memory is allocated: if a constructor throws, no destructor runs.\n"
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
    "08_effects/rt/effects_of.hpp": [
        ("        if (const auto* emitter = std::get_if<Emitter>(&material))\n"
         "            if (emitter->radiance != Color{}) effects.lights = true;\n",
         "        if (std::get_if<Emitter>(&material)) effects.lights = true;\n"),
        ("scene.camera.shutter > 0 && ", ""), ("scene.fog && scene.fog->density > 0", "scene.fog.has_value()")],
    "13_cluster/rt/saved_tiles.hpp": [(
        '    if (!file) throw std::runtime_error("a finished tile cannot be written");\n', "")],
    "13_cluster/rt/tile_messages.hpp": [(
        "        std::erase_if(messages_, [](Message& message) {\n"
        "            int is_sent = 0;\n"
        "            MPI_Test(&message.request, &is_sent, MPI_STATUS_IGNORE);\n"
        "            return is_sent != 0;\n"
        "        });\n", "")],
    "13_cluster/rt/turned_view.hpp": [
        ("    if (frame % frames == 0) return view;\n", ""), ("Real>(frame % frames)", "Real>(frame)")],
}

SMALL = ["--quiet", "--width", "96", "--height", "54"]
# These take half a minute to compile. The headers of 06 and 07 are in their programs.
SLOW = {"tracer.06", "tracer.07"}
# Here each plain answer alone would take minutes in all: all together must do.
LONG = {"06_threads", "07_bvh", "08_effects"}
# Open stars change these pictures: a comparison with the solution's would take half a minute to see that.
CHANGED = {"08_effects_solution", "11_samples_solution", "12_triangles_solution", "14_light_solution"}


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


@functools.cache
def compile_commands(build):
    return json.loads((build / "compile_commands.json").read_text())


def plain_headers_of(build, overlay, exercise):
    """Which of the overlay's headers an exercise's answer includes, directly or not; the compiler says it."""
    included = set()
    for command in compile_commands(build):
        if f"/answer.{exercise}.dir/" not in command["command"]:
            continue
        words = shlex.split(command["command"])
        at = words.index("-o")
        del words[at:at + 2]
        first = next(i for i, word in enumerate(words) if word.startswith("-I"))
        # Those of the standard library are not looked for, which would take most of the time.
        said = subprocess.run([*words[:first], f"-I{overlay}", *words[first:], "-MM", "-MG", "-nostdinc", "-nostdinc++"],
                              cwd=command["directory"], check=True, capture_output=True, text=True).stdout
        included.update(shlex.split(said.replace("\\\n", " ")))
    return frozenset(str(file.relative_to(overlay)) for file in overlay.rglob("*.hpp") if str(file) in included)


def check(build, folder, overlay, exercise, precision, is_built):
    """Runs the core of an exercise's test cases; returns what failed, or nothing, and whether stars are open, which is
    asked of the plain answers in double alone. These may be the build's."""
    target = "answer." + exercise + (".float" if precision == "float" else "")
    place = build / "answers/plain/double" if is_built else folder / target
    library = place / f"libanswer.{exercise}.so"
    if not is_built:
        place.mkdir(parents=True)
        made = place / f"{folder.name} {target}"  # mistake_tool works in a folder of this name
        built = subprocess.run([build / "bin/mistake_tool", "program", overlay, target, made],
                               capture_output=True, text=True)
        if built.returncode:
            return built.stdout + built.stderr, False
        made.rename(library)
    program = build / "check" / target.replace("answer.", "check.")

    def run(which):
        return subprocess.run([program, which], capture_output=True, text=True, timeout=300,
                              env=dict(os.environ, LD_LIBRARY_PATH=str(place), COURSE_ANSWER=str(place)))

    core = run("~[hard]")
    is_open = precision == "double" and overlay.name.endswith("_plain") and run("[hard]").returncode != 0
    if not is_built:
        shutil.rmtree(place)
    if core.returncode or "No tests ran" in core.stdout:
        return core.stdout[-3000:] + core.stderr[-2000:], False
    return "", is_open


def differs(build, program, target):
    """What `course compare` says of the program's picture where it is not the solution's."""
    run = subprocess.run([build / "bin/compare_programs", "differ", program, build / "bin" / target],
                         capture_output=True, text=True)
    return "" if run.returncode == 1 and run.stdout.startswith("THE SAME") else run.stdout + run.stderr


def run_program(build, folder, overlay, target, may_differ=()):
    """Compiles a program of the build with plain headers and runs it; returns what failed, or nothing, and whether its
    picture is not the solution's. It may be another where these of the headers are."""
    is_other = False
    folder.mkdir(parents=True)
    if target.startswith("tracer."):
        graft = subprocess.run([build / "bin/graft_mistakes", target[len("tracer."):], overlay],
                               capture_output=True, text=True)
        return graft.stdout + graft.stderr if graft.returncode else "", False
    program = folder / f"{overlay.name} {target}"  # mistake_tool works in a folder of this name
    built = subprocess.run([build / "bin/mistake_tool", "program", overlay, target, program],
                           capture_output=True, text=True)
    if built.returncode:
        return built.stdout + built.stderr, False
    if target.endswith("_solution") and not target.startswith("certify."):
        has_stars = any((overlay / name).exists() for name in may_differ)
        wrong = "another picture" if has_stars and target in CHANGED else differs(build, program, target)
        is_other = bool(wrong)
        if wrong and has_stars:
            rest = folder / f"{overlay.name}_without_open_stars"
            shutil.copytree(overlay, rest)
            for name in may_differ:
                (rest / name).unlink(missing_ok=True)
            is_solution = not any(path.is_file() for path in rest.rglob("*"))
            wrong = "" if is_solution else run_program(build, folder / "rest", rest, target)[0]
        if wrong:
            return wrong, is_other
    words = ["--no-timing"] if target.startswith("certify.") else SMALL + ["--out", folder / "picture.ppm"]
    run = subprocess.run([program, *words], capture_output=True, text=True, timeout=300, cwd=folder)
    said = run.stdout + run.stderr
    if target.startswith("certify."):  # the line of a star, such as 01.4*, may fail
        return said if "holds\t" not in said or re.search(r"FAILS\t[\d.]+\t", said) else "", False
    return said[-2000:] if run.returncode else "", is_other


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    chapters = [c for c in json.loads((ROOT / "course.json").read_text())["chapters"]
                if not sys.argv[2:] or c["name"] in sys.argv[2:]]
    files_of = {e["id"]: e["files"] for c in chapters for e in c.get("exercises", [])}
    may_differ = {f for c in chapters for e in c.get("exercises", []) if e.get("several_answers") for f in e["files"]}
    below = build / "core_path"
    shutil.rmtree(below, ignore_errors=True)
    jobs = []
    for chapter in chapters:
        files = plain_files(chapter["name"])
        exercises = [e for e in chapter.get("exercises", []) if e["files"][0].startswith("rt/")]
        if not files:
            continue
        ids = [e["id"] for e in exercises]
        plain_headers = {}  # those that an exercise's answer includes
        begun = set()  # exercises, with those of them that are plain
        rng = random.Random(chapter["name"])
        half = len(exercises) // 2
        for way, solved in ("plain", []), ("stars", rng.sample(exercises, half)), (
                "other_stars", rng.sample(exercises, half)):
            overlay = below / f"{chapter['name']}_{way}"
            overlay.mkdir(parents=True)
            chosen = {name: text for name, text in files.items() if not any(name in e["files"] for e in solved)}
            for name, text in chosen.items():
                (overlay / name).parent.mkdir(parents=True, exist_ok=True)
                (overlay / name).write_text(text)
            if way == "plain":
                with concurrent.futures.ThreadPoolExecutor(2) as pool:
                    plain_headers = dict(zip(ids, pool.map(functools.partial(plain_headers_of, build, overlay), ids)))
            for exercise in [e["id"] for e in exercises if e not in solved]:
                headers = exercise, plain_headers[exercise].intersection(chosen)
                if headers in begun:
                    continue
                begun.add(headers)
                is_built = (way == "plain" and (build / f"answers/plain/double/libanswer.{exercise}.so").exists() and
                            not any(f"{chapter['name']}/{name}" in EDITS for name in headers[1]))
                folder = below / f"{way}_{chapter['name']}"
                jobs.append((folder, overlay, exercise, "double", is_built))
                if way == "plain" and chapter["uses_real"]:
                    jobs.append((folder, overlay, exercise, "float", False))
    failed = 0
    programs, alone_programs = [], []
    together = below / "together"  # the plain answers of all chapters so far
    together.mkdir(parents=True)
    for chapter in [c for c in chapters if (PLAIN / c["name"]).exists()]:
        for name, text in plain_files(chapter["name"]).items():
            (together / name).parent.mkdir(parents=True, exist_ok=True)
            (together / name).write_text(text)
        overlay = below / f"{chapter['name']}_so_far"
        shutil.copytree(together, overlay)
        number = chapter["name"][:2]
        for name in plain_files(chapter["name"]):
            alone = below / f"{chapter['name']}_{pathlib.Path(name).stem}_alone"
            (alone / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(together / name, alone / name)
            target = f"{chapter['name']}_solution"
            if chapter["core"] and chapter["name"] not in LONG and (build / "link" / f"{target}.txt").exists():
                alone_programs.append((below / "pictures" / alone.name, alone, target))
        for target in f"{chapter['name']}_solution", f"certify.{chapter['name']}_solution", f"tracer.{number}":
            if (build / "link" / f"{target}.txt").exists() and target not in SLOW:
                programs.append((below / target, overlay, target))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for job, (wrong, is_open) in zip(jobs, pool.map(lambda job: check(build, *job), jobs)):
            if is_open:
                may_differ.update(files_of[job[2]])
            if wrong:
                failed += 1
                print(f"FAILS: {job[2]} in {job[3]}, {job[0].name}:\n{wrong}")

        def try_programs(jobs):
            """Returns the targets whose pictures are not the solution's."""
            nonlocal failed
            others = set()
            for job, (wrong, is_other) in zip(jobs, pool.map(lambda job: run_program(build, *job, may_differ), jobs)):
                if wrong:
                    failed += 1
                    print(f"FAILS: {job[2]} with the plain answers {job[1].name}:\n{wrong}")
                if is_other:
                    others.add(job[2])
            return others

        others = try_programs(programs)
        alone_programs = [job for job in alone_programs if job[2] in others]
        try_programs(alone_programs)
    shutil.rmtree(below, ignore_errors=True)
    print(f"core_path: {len(jobs)} cores, {len(programs + alone_programs)} programs, {failed} fail")
    return 1 if failed or not jobs else 0


if __name__ == "__main__":
    sys.exit(main())
