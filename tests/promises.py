#!/usr/bin/env python3
"""promises.py BUILD: checks that ctest knows the tests that docs/hard-cases.md names.

The names are those in backticks in the last column of the table of promises, and in the gallery whatever
looks like the name of a test; * stands for any letters. A name that this build lacks, such as one of the
thread sanitizer's, must be that of an add_test in chapters/ or tests/. The known mistakes that the page names
must be in tests/mistakes.
"""

import doctest
import fnmatch
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "hard-cases.md"


def names_of(page):
    """
    >>> names_of("see `checkpoint.03.2`, `t < 1`\\n"
    ...          "<!-- promises -->\\n| a | b | c |\\n|---|---|---|\\n| `no` | x | `a.b`, `*.c` |\\n\\n`no`")
    (['checkpoint.03.2'], ['a.b', '*.c'], [])
    >>> names_of("<!-- promises -->\\n| a | b | c |\\n|---|---|---|\\n| it works | x | surely |\\n")
    ([], [], ['it works'])
    """
    prose, _, table = page.partition("<!-- promises -->\n")
    rows = [line.strip("|").split("|") for line in table.split("\n\n")[0].splitlines()[2:]]
    named = [re.findall(r"`([^`]+)`", row[-1]) for row in rows]
    return (re.findall(r"`((?:checkpoint\.|torture_)[\w.]*)`", prose),
            [name for names in named for name in names],
            [row[0].strip() for row, names in zip(rows, named) if not names])


def main():
    wrong = doctest.testmod()[0]
    listing = subprocess.run(["ctest", "--test-dir", sys.argv[1], "-N"], capture_output=True, text=True, check=True)
    known = re.findall(r"Test\s+#\d+: (\S+)", listing.stdout)
    for file in [*(ROOT / "chapters").glob("*/CMakeLists.txt"), ROOT / "tests" / "CMakeLists.txt"]:
        known += re.findall(r"(?:add_test\(NAME|course_scenes_test\() ?([\w.]+)\s", file.read_text(encoding="utf-8"))
    page = PAGE.read_text(encoding="utf-8")
    in_prose, in_table, untested = names_of(page)
    for promise in untested:
        print(f"the promise '{promise}' names no test")
    missing = [name for name in in_prose + in_table if not fnmatch.filter(known, name)]
    for name in missing:
        print(f"{PAGE.relative_to(ROOT)} names the test '{name}', which does not exist")
    mistakes = "".join(file.read_text(encoding="utf-8") for file in (ROOT / "tests" / "mistakes").rglob("*.md"))
    for name in re.findall(r"`(\d\d\.\d_\w+)`", page):
        if f"## {name}\n" not in mistakes:
            print(f"{PAGE.relative_to(ROOT)} names the mistake '{name}', which does not exist")
            missing.append(name)
    print(f"{len(in_prose)} tests in the gallery, {len(in_table)} in the table of promises")
    return 1 if wrong or untested or missing or not in_prose or not in_table else 0


if __name__ == "__main__":
    sys.exit(main())
