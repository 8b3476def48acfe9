#!/usr/bin/env python3
"""What `./course test --push` tries of known mistakes and mutants, one a line: 03.1, an exercise; 03, the graft of
chapter 03; steps, the file of that name in tests/mistakes/09_own.

These are the ones whose files have changed since the commit in .ci/last_green, on which all were tried and were as they
should be, and a tenth of the others. The hash of the commit at hand draws them, so that each run of a commit tries the same.
Where git does not know the commit in .ci/last_green, as in a shallow clone, all count as changed.

  drawn.py           prints them
  drawn.py --others  prints all others
"""

import hashlib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
GREEN = ROOT / ".ci" / "last_green"


def git(*words):
    """What git prints, or None if it fails."""
    done = subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else None


def changed_files():
    """The files that differ from those of the commit in .ci/last_green, or None if that is not known."""
    since = git("diff", "--name-only", "-z", GREEN.read_text().strip(), "--") if GREEN.exists() else None
    new = git("ls-files", "-z", "--others", "--exclude-standard")
    return None if since is None or new is None else [file for file in (since + new).split("\0") if file]


def has_changed(chapter, exercise, files):
    """Whether one of these files makes its mutants or mistakes, lists them, or tests them.

    >>> a = {"id": "03.1", "files": ["rt/quadratic.hpp"]}
    >>> [has_changed("03_sphere", a, [file]) for file in (
    ...     "solutions/03_sphere/rt/quadratic.hpp", "exercises/03_sphere/rt/quadratic.hpp",
    ...     "tests/plain/03_sphere/rt/quadratic.hpp", "tests/03_sphere/03.1_quadratic.cpp",
    ...     "tests/03_sphere/03.1/answer.cpp", "tests/mutants/03.1.txt", "tests/mutants/mutants.py",
    ...     "tests/mistakes/03_sphere/03.1.md", "tests/support/mistake_tool.cpp")]
    [True, True, True, True, True, True, True, True, True]
    >>> [has_changed("03_sphere", a, [file]) for file in (
    ...     "solutions/03_sphere/rt/hit_sphere.hpp", "tests/03_sphere/03.10_other.cpp", "docs/03-sphere.md")]
    [False, False, False]
    >>> [has_changed(*whole_program("tracer", "03"), [file]) for file in (
    ...     "solutions/tracer/03.cpp", "tests/other_tracers/03.cpp", "tests/other_tracers/03.md",
    ...     "tests/mistakes/tracer/03.md", "companion/own/tracer.cpp", "solutions/tracer/04.cpp")]
    [True, True, True, True, True, False]
    >>> [has_changed(*whole_program("09_own", "steps"), [file]) for file in (
    ...     "solutions/09_own/main.cpp", "tests/mistakes/09_own/steps.md", "tests/mistakes/09_own/hard.md")]
    [True, True, False]
    """
    name = re.escape(exercise["id"])
    if chapter in ("09_own", "tracer"):
        tools = rf"companion/own/.*|tests/support/(graft|own)_mistakes\.cpp|tests/other_tracers/{name}\..*"
    else:
        tools = r"tests/support/mistake_tool\.cpp|tests/mutants/mutants\.py"
    its = re.compile(
        rf"(solutions|exercises|tests/plain)/{chapter}/({'|'.join(map(re.escape, exercise['files']))})"
        rf"|tests/{chapter}/{name}[_/].*|tests/mistakes/{chapter}/{name}\.md|tests/mutants/{name}\.txt|{tools}")
    return any(its.fullmatch(file) for file in files)


def whole_program(folder, name):
    """A graft (folder tracer), or a file of mistakes in programs from an empty folder (09_own), as has_changed takes
    exercises."""
    return folder, {"id": name, "files": [f"{name}.cpp" if folder == "tracer" else "main.cpp"]}


def drawn(exercises, files, commit):
    """The ids of those to try. exercises: pairs of a chapter and an exercise, as in course.json.

    >>> some = [("01_vectors", {"id": f"01.{k}", "files": [f"rt/{k}.hpp"]}) for k in range(1, 21)]
    >>> len(drawn(some, [], "a")), drawn(some, [], "a") == drawn(some, [], "a"), drawn(some, [], "a") == drawn(some, [], "b")
    (2, True, False)
    >>> "01.7" in drawn(some, ["solutions/01_vectors/rt/7.hpp"], "a"), len(drawn(some, None, "a"))
    (True, 20)
    """
    changed = [e["id"] for chapter, e in exercises if files is None or has_changed(chapter, e, files)]
    others = [e["id"] for _, e in exercises if e["id"] not in changed]
    others.sort(key=lambda name: hashlib.sha256(f"{commit} {name}".encode()).hexdigest())
    return changed + others[:-(-len(others) // 10)]


def main():
    course = json.loads((ROOT / "course.json").read_text())
    exercises = [(c["name"], e) for c in course["chapters"] for e in c.get("exercises", [])]
    for folder in ("tracer", "09_own"):
        exercises += [whole_program(folder, file.stem) for file in sorted((ROOT / "tests/mistakes" / folder).glob("*.md"))]
    names = drawn(exercises, changed_files(), git("rev-parse", "HEAD"))
    if sys.argv[1:] == ["--others"]:
        names = [e["id"] for _, e in exercises if e["id"] not in names]
    print(*sorted(names), sep="\n")


if __name__ == "__main__":
    main()
