#!/usr/bin/env python3
"""No dead ends: what the learner writes runs in the final scene.

  dead_ends.py make ROOT FOLDER    copies the solution's files into FOLDER/rt, where each function that
                                   an exercise asks for ends as its stub would if the environment
                                   variable COURSE_STUB names that exercise
  dead_ends.py run ROOT PROGRAM    renders the final scene, tiny, with each exercise in turn as its
                                   stub: PROGRAM must end with 3 and name it. unused.json lists the
                                   exercises that cannot be noticed there, and why. The material of
                                   05.6 has a scene of its own: `compare` puts the learner's final
                                   scene beside ours, and another material is no mistake.
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


def without_comments(source):
    return re.sub(r"//[^\n]*", "", source)


def stub_signatures(source, exercise):
    """The name and the parameters, "dot(Vec3 a, Vec3 b)", of each function that is to be written."""
    source = without_comments(source)
    for todo in re.finditer(r'rt::todo\("%s"' % re.escape(exercise), source):
        close = source.rindex(")", 0, source.rindex("{", 0, todo.start()))
        opened, depth = close, 1
        while depth > 0:
            opened -= 1
            depth += {")": 1, "(": -1}.get(source[opened], 0)
        name = re.search(r"(\w+|operator\W{1,3})\s*$", source[:opened]).group(1)
        yield name + source[opened:close + 1]


def pattern_of(signature):
    """Finds the same signature, however its lines are broken and its parameters named, up to the
    body's brace."""
    tokens = re.findall(r"\w+|[^\w\s]", signature)
    parts = [r"(?:\w+|/\*\w+\*/)?" if re.match(r"\w", token) and after in ",)" else re.escape(token)
             for token, after in zip(tokens, tokens[1:] + ["{"])]
    member = r"\w+\{[^{}]*\}"
    return re.compile(r"\b" + r"\s*".join(parts) +
                      rf"(?:[^;{{}}]*?[^:]:\s*{member}(?:,\s*{member})*\s*|[^;{{}}]*)\{{")


def instrumented(source, stub, exercise, file):
    for signature in dict.fromkeys(stub_signatures(stub, exercise)):
        found = list(pattern_of(signature).finditer(source))
        if len(found) != 1:
            sys.exit(f"{file}: {signature} of {exercise}: expected one definition in the solution, "
                     f"actual: {len(found)}")
        end = found[0].end()
        line = source.rfind("\n", 0, found[0].start()) + 1
        head = source[line:end].replace("constexpr ", "inline ").replace(" noexcept", "")
        source = (source[:line] + head +
                  f' if (course::is_stub("{exercise}")) rt::todo("{exercise}");' + source[end:])
    return source


def make(root, folder):
    (folder / "rt").mkdir(parents=True, exist_ok=True)
    for chapter, exercise, files in exercises(root):
        for file in files:
            if not file.startswith("rt/") or not file.endswith(".hpp"):
                continue
            made = folder / file
            source = (root / "solutions" / chapter / file).read_text()
            source = source.replace("#pragma once", "#pragma once\n#include <rt/is_stub.hpp>", 1)
            source = instrumented(source, (root / "exercises" / chapter / file).read_text(), exercise,
                                  f"solutions/{chapter}/{file}")
            if not made.exists() or made.read_text() != source:
                made.write_text(source)


def run(root, program):
    unused = json.loads((root / "tests/dead_ends/unused.json").read_text())
    wrong = 0
    for _, exercise, _ in exercises(root):
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
    if len(sys.argv) != 4 or sys.argv[1] not in ("make", "run"):
        sys.exit(__doc__)
    {"make": make, "run": run}[sys.argv[1]](pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]))
