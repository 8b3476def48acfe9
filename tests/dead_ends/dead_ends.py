#!/usr/bin/env python3
"""No dead ends: what the learner writes runs in the final scene.

  dead_ends.py make ROOT FOLDER    copies the solution's files into FOLDER/rt, where each function that
                                   an exercise asks for ends as its stub would if the environment
                                   variable COURSE_STUB names that exercise, and gives a wrong answer if
                                   COURSE_WRONG does: nothing, none, false or 0
  dead_ends.py run ROOT PROGRAM [NN.k]
                                   renders the final scene, tiny, with each exercise (or this one) in turn
                                   as its stub: PROGRAM must end with 3 and name it. Then it renders it with
                                   each wrong answer: one pixel in twenty must change, and one in three
                                   for the tests of sphere and box and for the search, or PROGRAM must
                                   end with an error. unused.json lists the exercises that no picture
                                   needs there, and unseen.json those whose wrong answer it hides, with
                                   the reason, which the text also gives. The material of 05.6 has a
                                   scene of its own: `compare` puts the learner's final scene beside
                                   ours, and another material is no mistake.
"""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys

SCENE = ["--quiet", "--width", "48", "--height", "27", "--spp", "4", "--depth", "12", "--threads", "2"]
FINE = [*SCENE[:5], "--spp", "256", *SCENE[7:]]  # another seed changes one pixel in a hundred
SCENE_FILES = {"05.6": "own.json"}  # in place of the final scene
ONE_IN_THREE = {"03.2", "07.1", "07.4"}
# What is not of the form {}: hit_box finds an empty interval, and a generator has no value of its own.
NOTHING = {"hit_box": "{within.max, within.min}", "sample_rng": "Rng{0, 0}"}


def exercises(root):
    for chapter in json.loads((root / "course.json").read_text())["chapters"]:
        if not chapter["core"]:  # nothing of an elective is in the final scene
            continue
        for exercise in chapter.get("exercises", []):
            yield chapter["name"], exercise["id"], exercise["files"]


def functions(root, kind, files):
    """The functions that these headers define: path, what identifies the function, its cursor and its body's."""
    from clang import cindex
    headers = subprocess.run(["clang++", "-print-resource-dir"], capture_output=True, text=True, check=True).stdout
    given = sorted(folder.parent for folder in (root / "chapters").glob("**/rt"))
    folders = [*sorted((root / kind).iterdir()), *given, root / "common"]
    unit = cindex.Index.create().parse(
        "all.cpp", args=["-std=c++20", "-w", "-DRT_REAL=double", "-isystem", headers.strip() + "/include",
                         *(f"-I{folder}" for folder in folders)],
        unsaved_files=[("all.cpp", "".join(f"#include <{file}>\n" for _, file in files))])
    errors = [str(d) for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if errors:
        sys.exit("\n".join(errors))
    paths = {str(root / kind / chapter / file) for chapter, file in files}

    def below(cursor):
        for child in cursor.get_children():
            if cursor == unit.cursor and str(child.location.file) not in paths:
                continue
            bodies = [c for c in child.get_children() if c.kind == cindex.CursorKind.COMPOUND_STMT]
            if bodies:
                yield str(child.location.file), child.get_usr(), child, bodies[-1]
            else:
                yield from below(child)
    return below(unit.cursor)


def wrong_answer(function):
    """What a function returns that finds nothing; None for a constructor."""
    from clang import cindex
    if function.kind == cindex.CursorKind.CONSTRUCTOR:
        return None
    return "" if function.result_type.spelling == "void" else NOTHING.get(function.spelling, "{}")


def make(root, folder):
    root = root.resolve()
    files = [(chapter, file) for chapter, _, files in exercises(root) for file in files if file.endswith(".hpp")]
    written = {}  # which exercise asks for a function
    for path, name, _, body in functions(root, "exercises", files):
        extent = body.extent
        text = pathlib.Path(path).read_bytes()[extent.start.offset:extent.end.offset].decode()
        if todo := re.search(r'rt::todo\("([\d.]+)"', text):
            written[name] = todo[1]
    made = {root / "solutions" / chapter / file: [] for chapter, file in files}
    for path, name, whole, body in functions(root, "solutions", files):
        if name in written:
            made[pathlib.Path(path)].append((whole, body, written.pop(name)))
    if written:
        sys.exit(f"no solution has {', '.join(written)}")
    for path, own in made.items():
        source = path.read_bytes()
        for whole, body, exercise in sorted(own, key=lambda f: -f[1].extent.start.offset):
            begin, brace = whole.extent.start.offset, body.extent.start.offset
            head = source[begin:brace].replace(b"constexpr ", b"inline ").replace(b" noexcept", b"")
            stub = f'{{ if (course::is_stub("{exercise}")) rt::todo("{exercise}");'
            wrong = wrong_answer(whole) if exercise >= "01" else None
            if wrong is not None:
                stub += f' if (course::is_wrong("{exercise}")) return {wrong};'
            source = source[:begin] + head + stub.encode() + source[brace + 1:]
        source = source.replace(b"#pragma once", b"#pragma once\n#include <rt/is_stub.hpp>", 1)
        copy = folder / "rt" / path.name
        copy.parent.mkdir(parents=True, exist_ok=True)
        if not copy.exists() or copy.read_bytes() != source:
            copy.write_bytes(source)


def drawn(program, root, exercise, settings, **environment):
    """Runs the program: what came of it, and the pixels, if there are any."""
    file = SCENE_FILES.get(exercise)
    scene = [root / "chapters/08_effects/scenes" / file] if file else []
    picture = pathlib.Path("dead_ends.ppm")
    picture.unlink(missing_ok=True)
    done = subprocess.run([program.absolute(), *scene, *settings, "--out", picture], capture_output=True, text=True,
                          env={**os.environ, **environment}, timeout=60, check=False)
    if not picture.exists():
        return done, None
    numbers = picture.read_bytes().split(b"\n", 3)[3]
    return done, [numbers[i:i + 3] for i in range(0, len(numbers), 3)]


def changed(pixels, right):
    """The fraction of pixels that a person sees to have changed."""
    return sum(max(abs(a - b) for a, b in zip(*both)) > 16 for both in zip(pixels, right)) / len(right)


def run(root, program, only=None):
    unused = json.loads((root / "tests/dead_ends/unused.json").read_text())
    unseen = json.loads((root / "tests/dead_ends/unseen.json").read_text())
    right = {}
    wrong = 0
    for _, exercise, _ in exercises(root):
        if only not in (None, exercise):
            continue
        done, _ = drawn(program, root, exercise, SCENE, COURSE_STUB=exercise)
        # A destructor that throws ends the program at once: 00.4 is called by one.
        runs = (done.returncode in (3, -signal.SIGABRT) and
                f"{exercise} is still to be written" in done.stderr)
        if runs != (exercise not in unused) or not (runs or done.returncode == 0):
            wrong += 1
            if runs:
                print(exercise, "runs after all: take it off tests/dead_ends/unused.json")
            else:
                print(f"{exercise}: as its stub, expected exit code 3 and its name, actual: exit code "
                      f"{done.returncode}, {done.stderr.strip() or 'no word'}; if no picture needs it, "
                      "tests/dead_ends/unused.json says why it is there")
            continue
        if not runs:
            print(exercise, "is not needed: " + unused[exercise])
            continue
        if exercise < "01":
            print(exercise, "runs")
            continue
        file = SCENE_FILES.get(exercise)
        if file not in right:
            right[file] = drawn(program, root, exercise, FINE)[1]
        done, pixels = drawn(program, root, exercise, FINE, COURSE_WRONG=exercise)
        least = 1 / 3 if exercise in ONE_IN_THREE else 1 / 20
        failed = done.returncode != 0
        share = 1 if failed else changed(pixels, right[file])
        said = (f"ends with an error ({done.returncode})" if failed else
                f"changes {100 * share:.1f} % of the pixels")
        print(f"{exercise} runs; an answer that finds nothing {said}" +
              (": " + unseen[exercise] if exercise in unseen else ""))
        if (share < least) != (exercise in unseen):
            wrong += 1
            print(f"  expected at least {100 * least:.0f} %; if the scene hides it, tests/dead_ends/unseen.json and the "
                  "text say why" if share < least else "  it shows: take it off tests/dead_ends/unseen.json")
    known = {exercise for _, exercise, _ in exercises(root)}
    for exercise in (unused.keys() | unseen.keys()) - known:
        wrong += 1
        print(f"tests/dead_ends/unused.json or unseen.json names {exercise}, which course.json does not know")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    if len(sys.argv) not in {"make": [4], "run": [4, 5]}.get(sys.argv[1] if sys.argv[1:] else "", []):
        sys.exit(__doc__)
    {"make": make, "run": run}[sys.argv[1]](pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), *sys.argv[4:])
