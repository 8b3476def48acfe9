#!/usr/bin/env python3
"""How long a learner waits for a verdict: in a fresh clone, in seconds, with the processor time beside it.

    verdict_times.py                in a new copy of this folder, which is removed at the end
    verdict_times.py --in FOLDER    in this copy of the course, whose exercises it overwrites
    verdict_times.py ... NN.k ...   these exercises instead of ten from all chapters

For each exercise: its first check, with all that must be built; then, five times, a comment is saved in a right
answer, and `./course check` runs on a terminal until the verdict's line stands there, and until it has ended. The
table has the medians. Then wrong answers, each with a known mistake: how long until the mistake is named, the first
time and when the mistakes of this exercise are known.
"""

import argparse
import json
import os
import pty
import re
import resource
import select
import shutil
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXERCISES = ["00.1", "01.4", "02.4", "03.2", "04.7", "05.5", "06.3", "07.4", "08.4", "13.2"]
WRONG = ["03.1_unsorted", "05.3_ratio_upside_down", "08.4_weights_swapped"]


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Typed:
    """A command on a terminal, and when it said what. Its input is empty, so that it builds nothing in the
    background."""

    def __init__(self, course, *words):
        here, there = pty.openpty()
        before, start = processor_seconds(), time.monotonic()
        process = subprocess.Popen([course / "course", *words], cwd=course, stdin=subprocess.DEVNULL, stdout=there,
                                   stderr=there)
        os.close(there)
        self.said, self.times, text = [], [], ""
        while True:
            try:
                if not select.select([here], [], [], 600)[0]:
                    raise SystemExit(f"course {' '.join(words)}: no word for ten minutes")
                text += os.read(here, 65536).decode(errors="replace")
            except OSError:  # the terminal has closed
                break
            *lines, text = re.split(r"[\r\n]+", re.sub(r"\033\[[0-9]*[a-zA-Z]", "", text))
            self.said += lines
            self.times += [time.monotonic() - start] * len(lines)
        process.wait()
        self.seconds, self.processor = time.monotonic() - start, processor_seconds() - before
        os.close(here)

    def seconds_until(self, pattern):
        for line, seconds in zip(self.said, self.times):
            if re.search(pattern, line):
                return seconds
        raise SystemExit(f"expected {pattern!r}, actual:\n" + "\n".join(self.said))


class Copy:
    def __init__(self, folder):
        self.folder = folder
        self.facts = {exercise["id"]: (chapter["name"], exercise["files"])
                      for chapter in json.loads((folder / "course.json").read_text())["chapters"]
                      for exercise in chapter.get("exercises", [])}

    def put_answers(self, exercise):
        """Right answers to all exercises of this one's chapter."""
        chapter = self.facts[exercise][0]
        for name, files in self.facts.values():
            for file in files if name == chapter else []:
                shutil.copy(self.folder / "solutions" / chapter / file, self.folder / "exercises" / chapter / file)

    def save(self, exercise):
        """A change that makes the compiler compile the answer again."""
        chapter, files = self.facts[exercise]
        with (self.folder / "exercises" / chapter / files[0]).open("a") as file:
            file.write(f"// {time.monotonic_ns()}\n")

    def make(self, mistake):
        exercise = mistake.split("_")[0]
        chapter = self.facts[exercise][0]
        text = (self.folder / f"tests/mistakes/{chapter}/{exercise}.md").read_text()
        section = re.search(rf"^## {re.escape(mistake)}\n.*?(?=^## |\Z)", text, re.M | re.S)[0]
        for file, edits in re.findall(r"^```diff (\S+)\n(.*?)^```", section, re.M | re.S):
            path = self.folder / "exercises" / chapter / file
            code = path.read_text()
            for edit in re.split(r"^@@\n", edits, flags=re.M):
                lines = edit.splitlines(keepends=True)
                before = "".join(line[1:] for line in lines if line[0] != "+")
                if code.count(before) != 1:
                    raise SystemExit(f"{mistake}: its edit does not fit {path}")
                code = code.replace(before, "".join(line[1:] for line in lines if line[0] != "-"))
            path.write_text(code)
        return exercise, re.search("^title: (.*)$", section, re.M)[1]


def show_first_steps(course):
    print("in a new copy                   seconds  processor")
    for what, words in (("./course", []), ("./course prepare", ["prepare"])):
        typed = Typed(course.folder, *words)
        print(f"{what:30} {typed.seconds:8.1f} {typed.processor:10.1f}", flush=True)
    first = re.search(r"Next: (\d\d\.\d)", "\n".join(Typed(course.folder).said))[1]
    course.put_answers(first)
    typed = Typed(course.folder, "check", first)
    print(f"{'the first check, ' + first:30} {typed.seconds:8.1f} {typed.processor:10.1f}\n", flush=True)


def show_right_answers(course, exercises, repeats=5):
    print("a right answer   first check  processor     to verdict  to prompt  processor")
    verdicts = []
    for exercise in exercises:
        course.put_answers(exercise)
        first = Typed(course.folder, "check", exercise)
        rows = []
        for _ in range(repeats):
            course.save(exercise)
            typed = Typed(course.folder, "check", exercise)
            rows.append((typed.seconds_until(rf"^  [+*] {exercise} "), typed.seconds, typed.processor))
        verdict, prompt, processor = (statistics.median(column) for column in zip(*rows))
        verdicts.append(verdict)
        print(f"{exercise:14} {first.seconds:13.2f} {first.processor:10.2f} {verdict:14.2f} {prompt:10.2f} "
              f"{processor:10.2f}", flush=True)
    print(f"the slowest verdict: {max(verdicts):.2f} s, their median: {statistics.median(verdicts):.2f} s\n")


def show_wrong_answers(course, mistakes):
    print("a wrong answer                          to verdict    to name  to prompt  processor")
    for mistake in mistakes:
        course.put_answers(mistake.split("_")[0])
        exercise, title = course.make(mistake)
        known = course.folder / "build/signatures" / f"{exercise}.json"
        Typed(course.folder, "check", exercise)  # all but the mistakes is built
        known.unlink(missing_ok=True)
        for when in ("first", "known"):
            course.save(exercise)
            typed = Typed(course.folder, "check", exercise)
            print(f"{mistake + ', ' + when:38} {typed.seconds_until(rf'^  x {exercise} '):11.2f} "
                  f"{typed.seconds_until('(This looks|or|and) like: ' + re.escape(title)):10.2f} {typed.seconds:10.2f} "
                  f"{typed.processor:10.2f}", flush=True)
        course.put_answers(exercise)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--in", dest="folder", type=Path)
    options.add_argument("exercises", nargs="*", default=EXERCISES)
    given = options.parse_args()
    with tempfile.TemporaryDirectory(prefix="course-") as scratch:
        folder = given.folder
        if not folder:
            folder = Path(scratch) / "course"
            files = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                                   check=True, stdout=subprocess.PIPE, text=True).stdout
            for file in filter(None, files.split("\0")):
                if (ROOT / file).is_file():
                    (folder / file).parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy2(ROOT / file, folder / file)
        course = Copy(folder.resolve())
        if not (folder / "build").exists():
            show_first_steps(course)
        show_right_answers(course, [one for one in given.exercises if one in course.facts])
        show_wrong_answers(course, WRONG)


if __name__ == "__main__":
    main()
