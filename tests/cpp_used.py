#!/usr/bin/env python3
"""The C++ that an exercise needs is taught by then.

Collects the keywords, operators, std:: names and members in the core answers of each chapter: those of
tests/plain where ours have more. Each must stand in code in its stub or in a text up to the chapter's,
outside of the folds, which are for the stars.
"""

import json
import pathlib
import re
import sys

import core_path

ROOT = pathlib.Path(__file__).resolve().parents[1]

KEYWORDS = set("""auto bool break case catch class const constexpr continue default delete do double else
    enum explicit false float for if inline int long mutable namespace new noexcept nullptr operator private public
    return sizeof static static_assert static_cast struct switch template this throw true try typename unsigned using
    void volatile while""".split())
OPERATORS = re.compile(r"->|\+\+|--|&&|\|\||<=|>=|==|!=|\+=|-=|\*=|/=|<<|>>|::|[-+*/%?!&|^<>=~]")

# What our answers write where the texts show another way.
SAME_AS = {"std::holds_alternative": "std::get_if", ".has_value": "!", "std::numbers::sqrt2_v": "std::sqrt",
           "unsigned": "int"}


def tokens(code):
    """The tokens of C++ code that a reader must know."""
    code = re.sub(r"//.*|/\*.*?\*/|^\s*#.*", " ", code, flags=re.S if "/*" in code else re.M)
    code = re.sub(r'"(\\.|[^"\\])*"', '""', code)
    found = set(re.findall(r"\bstd::(?:\w+::)*\w+", code))
    found |= {"." + name for name in re.findall(r"(?:(?<![\d.])\.|->)\s*([A-Za-z_]\w*)", code)}
    found |= KEYWORDS & set(re.findall(r"\w+", code))
    found |= set(OPERATORS.findall(re.sub(r"\bstd::|\b\w+::", "", code)))
    return found


def members(text):
    """The words of a text that may name members. A single letter may be anything."""
    return {"." + word for word in re.findall(r"[A-Za-z_]\w+", text)}


def answers(chapter):
    """What the chapter's core answers use and its stubs do not show."""
    used = {}
    plain = core_path.plain_files(chapter["name"])
    for exercise in chapter["exercises"]:
        if exercise["minutes"] == 0:  # all of it is for the stars
            continue
        for name in exercise["files"]:
            file = f"{chapter['name']}/{name}"
            code = plain.get(name) or (ROOT / "solutions" / file).read_text()
            stub = ROOT / "exercises" / file
            given = stub.read_text() if stub.exists() else ""
            for token in tokens(code) - tokens(given) - members(given):
                used.setdefault(token, []).append(exercise["id"])
    return used


def code_of(text):
    """The code in a text: between backticks, and in blocks. Without the folds, which are for the stars."""
    text = re.sub(r"<details>.*?</details>", "", text, flags=re.S)
    return "\n".join(re.findall(r"```\w*\n(.*?)```", text, flags=re.S) + re.findall(r"`([^`\n]+)`", text))


def main():
    course = json.loads((ROOT / "course.json").read_text())
    early = (ROOT / "docs/00-toolchain.md").read_text().split("## From source to program")[0]
    known = tokens(code_of(early)) | members(code_of(early))
    missing = 0
    for chapter in course["chapters"]:
        if "exercises" not in chapter or not chapter["exercises"]:
            continue
        text = (ROOT / chapter["text"]).read_text()
        known |= tokens(code_of(text)) | members(code_of(text))
        used = answers(chapter)
        for token in sorted(t for t in used if t not in known and SAME_AS.get(t) not in known):
            missing += 1
            print(f"{chapter['text']}: {token} is used in {', '.join(used[token])} and not taught")
    print(f"cpp_used: {missing} missing")
    return 1 if missing else 0


sys.exit(main())
