#!/usr/bin/env python3
"""contributing.py BUILD: checks that what CONTRIBUTING.md has one type can be typed, without running it.

Each line of a code block is a command. Each alternative of a ctest pattern selects a test of this build, which has
all tests; exercises, targets, presets, stages, commands and files exist.
"""

import doctest
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "CONTRIBUTING.md"


def commands_of(page):
    """
    >>> commands_of("`ctest -N`\\n```sh\\n# two\\n./a 'b c'  # one\\n\\nd >e\\n```\\n```cpp\\nf();\\n```\\n")
    [['./a', 'b c'], ['d', '>e']]
    """
    blocks = re.findall(r"^```sh\n(.*?)^```$", page, re.M | re.S)
    return [words for block in blocks for line in block.splitlines() if (words := shlex.split(line, comments=True))]


def in_prose(page):
    """What ctest and cmake are called with outside of code blocks, where nobody checks it.

    >>> in_prose("run `ctest -R a` or `ctest`\\n```sh\\nctest -R b\\n```\\n")
    ['ctest -R a']
    """
    return re.findall(r"`((?:ctest|cmake) [^`]*)`", re.sub(r"^```.*?^```$", "", page, flags=re.M | re.S))


def after(words, option):
    """The words after an option, up to the next one.

    >>> after(["cmake", "--target", "a", "b", "-j", "2"], "--target"), after(["ctest"], "-R")
    (['a', 'b'], [])
    """
    rest = words[words.index(option) + 1:] if option in words else []
    return rest[:next((i for i, word in enumerate(rest) if word.startswith("-")), len(rest))]


def output_of(*command):
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout


class Checker:
    def __init__(self, build):
        self.presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
        self.targets = set(re.findall(r"^(?:\.\.\. )?([\w.]+)", output_of("cmake", "--build", build, "--target", "help"),
                                      re.M))
        self.tests = re.findall(r"Test\s+#\d+: (\S+)", output_of("ctest", "--test-dir", build, "-N", "-LE", "exercise"))
        # A test that this machine lacks a tool for.
        for file in (ROOT / "tests").rglob("CMakeLists.txt"):
            self.tests += re.findall(r"add_test\(NAME ([\w.]+)\s", file.read_text(encoding="utf-8"))
        self.ids = set(re.findall(r'"id": "(\d\d\.\d)"', (ROOT / "course.json").read_text(encoding="utf-8")))

    def ctest(self, words):
        preset = [one for one in self.presets["testPresets"] if one["name"] in after(words, "--preset")]
        if not preset:
            return "--preset does not name a test preset of CMakePresets.json"
        if preset[0].get("execution", {}).get("noTestsAction") != "error":
            return "this preset succeeds without tests"
        patterns = [one for given in after(words, "-R") for one in re.split(r"(?<!\\)[|]", given)]
        unknown = [pattern for pattern in patterns if not any(re.search(pattern, test) for test in self.tests)]
        return f"no test has a name like '{unknown[0]}'" if unknown else None

    def cmake(self, words):
        known = {one["name"] for one in self.presets["configurePresets"]}
        unknown = [name for name in after(words, "--preset") if name not in known]
        unknown += [name for name in after(words, "--target") if name not in self.targets]
        return f"there is no preset or target {unknown[0]}" if unknown else None

    def course(self, words):
        declared = (ROOT / "companion/commands/commands.inc").read_text(encoding="utf-8")
        known = re.findall(r"^(?:COMMAND|SCRIPT)\((\w+)", declared, re.M)
        if words[1] not in known and "_".join(words[1:3]) not in known:
            return "there is no such command"
        options = re.findall(r"--[\w-]+", declared)
        for word in words[2:]:
            if word.startswith("--") and word not in options:
                return f"there is no option {word}"
            # An exercise, or the one after the last of its chapter, which is made here.
            before = f"{word[:-1]}{int(word[-1]) - 1}" if re.fullmatch(r"\d\d\.\d", word) else None
            if before and not self.ids & {word, before}:
                return f"there is no exercise {word}"
        return None

    def ci(self, words):
        functions = re.findall(r"^(\w+)\(\)", (ROOT / ".ci/run").read_text(encoding="utf-8"), re.M)
        unknown = [word for word in words[1:] if not word.startswith("-") and word not in functions]
        return f"there is no stage {unknown[0]}" if unknown else None

    def wrong_with(self, words):
        """What is wrong with a command; None if nothing is."""
        program = words[0]
        special = {"ctest": self.ctest, "cmake": self.cmake, "./course": self.course, ".ci/run": self.ci}
        if program in special:
            return special[program](words)
        if program.startswith("build/bin/"):
            return None if pathlib.Path(program).name in self.targets else "there is no such target"
        # A file of the course, perhaps after its interpreter.
        files = words[1:2] if program in ("python3", "node", "sh") else words[:1]
        files += [word for word in words[1:] if re.match(r"(chapters|docs|tests)/", word)]
        lacking = [file for file in files if not (ROOT / file).exists()]
        if lacking:
            return f"there is no file {lacking[0]}"
        return None if files[0] != program or os.access(ROOT / program, os.X_OK) else f"{program} cannot be run"


def main():
    wrong = doctest.testmod()[0]
    page = PAGE.read_text(encoding="utf-8")
    checker = Checker(sys.argv[1])
    commands = commands_of(page)
    for command in in_prose(page):
        print(f"{PAGE.name}: `{command}` belongs in a code block, whose commands are checked")
        wrong += 1
    for words in commands:
        if trouble := checker.wrong_with(words):
            print(f"{PAGE.name}: {shlex.join(words)}: {trouble}")
            wrong += 1
    print(f"{len(commands)} commands, of which {sum(words[0] == 'ctest' for words in commands)} call ctest")
    return 1 if wrong or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
