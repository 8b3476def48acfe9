#!/usr/bin/env python3
"""No dead ends: what the learner writes runs in the final scene.

  dead_ends.py make ROOT FOLDER    copies the solution's files into FOLDER/rt, where each function that
                                   an exercise asks for ends as its stub would if the environment
                                   variable COURSE_STUB names that exercise
  dead_ends.py run ROOT PROGRAM [NN.k]
                                   renders the final scene, tiny, with each exercise (or this one)
                                   in turn as its stub: PROGRAM must end with 3 and name it.
                                   unused.json lists the exercises that cannot be noticed there,
                                   and why. The material of 05.6 has a scene of its own: `compare`
                                   puts the learner's final scene beside ours, and another material
                                   is no mistake.
"""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys

SCENE = ["--quiet", "--width", "48", "--height", "27", "--spp", "4", "--depth", "12", "--threads", "2"]
SCENE_FILES = {"05.6": "own.json"}  # in place of the final scene


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
    folders = [*sorted((root / kind).iterdir()), *sorted((root / "chapters").iterdir()), root / "common"]
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
            source = source[:begin] + head + stub.encode() + source[brace + 1:]
        source = source.replace(b"#pragma once", b"#pragma once\n#include <rt/is_stub.hpp>", 1)
        copy = folder / "rt" / path.name
        copy.parent.mkdir(parents=True, exist_ok=True)
        if not copy.exists() or copy.read_bytes() != source:
            copy.write_bytes(source)


def run(root, program, only=None):
    unused = json.loads((root / "tests/dead_ends/unused.json").read_text())
    wrong = 0
    for _, exercise, _ in exercises(root):
        if only not in (None, exercise):
            continue
        file = SCENE_FILES.get(exercise)
        scene = [root / "chapters/08_effects/scenes" / file] if file else []
        command = [program.absolute(), *scene, *SCENE, "--out", "dead_ends.png"]
        done = subprocess.run(command, capture_output=True, text=True,
                              env={**os.environ, "COURSE_STUB": exercise}, timeout=60, check=False)
        # A destructor that throws ends the program at once: 00.4 is called by one.
        runs = (done.returncode in (3, -signal.SIGABRT) and
                f"{exercise} is still to be written" in done.stderr)
        if runs == (exercise not in unused) and (runs or done.returncode == 0):
            print(exercise, "runs" if runs else "is not needed: " + unused[exercise])
            continue
        wrong += 1
        if runs:
            print(exercise, "runs after all: take it off tests/dead_ends/unused.json")
        else:
            print(f"{exercise}: as its stub, expected exit code 3 and its name, actual: exit code "
                  f"{done.returncode}, {done.stderr.strip() or 'no word'}; if no picture needs it, "
                  "tests/dead_ends/unused.json says why it is there")
    known = {exercise for _, exercise, _ in exercises(root)}
    for exercise in unused.keys() - known:
        wrong += 1
        print(f"tests/dead_ends/unused.json names {exercise}, which course.json does not know")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    if len(sys.argv) not in {"make": [4], "run": [4, 5]}.get(sys.argv[1] if sys.argv[1:] else "", []):
        sys.exit(__doc__)
    {"make": make, "run": run}[sys.argv[1]](pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), *sys.argv[4:])
