#!/usr/bin/env python3
"""quoted.py: the texts' grafts show the code of our answers, and no sentence stands in two places.

- The code that a text's graft shows is in our answer to that graft, line by line and in the same order, and the text
  names each header that the answer adds.
- No sentence of a question is also in a text: rewording one would mean finding the other.
- What a text asks the reader to guess has the numbers of one of the chapter's questions.
"""

import doctest
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FEWEST_WORDS = 6  # a shorter sentence may well be in two places


def read(path):
    return path.read_text(encoding="utf-8")


def squeezed(code):
    """
    >>> squeezed("a = {b,  // why\\n     c};")
    'a={b,c};'
    """
    return re.sub(r"\s+", "", re.sub(r"//.*", "", code))


def not_in_order(shown, code):
    """The first piece of the shown code that the code lacks, or has only before the piece above; or none.

    >>> code = "f(a,\\n  b);\\ng();\\nh();"
    >>> [not_in_order(shown, code) for shown in ("f(a, b);\\n...\\nh();", "g();\\n// as before\\n}", "h();\\ng();")]
    [None, '}', 'g();']
    """
    rest = squeezed(code)
    for line in shown.splitlines():
        for piece in filter(squeezed, line.split("...")):
            _, found, rest = rest.partition(squeezed(piece))
            if not found:
                return piece.strip()
    return None


def graft_faults(section, answer, earlier):
    """
    >>> graft_faults("Write `mix(below, above, up)`:\\n```cpp\\nf(b);\\n```", "#include <c>\\nf(a);", "mix(above, below, up);")
    ['mix(below, above, up)', 'f(b);', '<c>']
    """
    blocks = re.findall(r"^ *```cpp\n(.*?)^ *```", section, re.S | re.M)
    inline = re.findall(r"`([^`\n]*\([^`\n]*,[^`\n]*,[^`\n]*\)[^`\n]*)`", re.sub(r"```.*?```", "", section, flags=re.S))
    faults = [code for code in inline if not_in_order(code, answer) and not_in_order(code, earlier)]
    faults += filter(None, (not_in_order(block, answer) for block in blocks))
    headers = [set(re.findall(r"#include (<.*?>)", code)) for code in (answer, earlier)]
    return faults + sorted(header for header in headers[0] - headers[1] if header not in section)


def sentences(text):
    """
    >>> sentences("A tree of `n` nodes\\nis *deep*. Is it?")
    ['a tree of n nodes is deep', 'is it']
    """
    plain = re.sub(r"\s+", " ", re.sub(r"[`*_$\\]", "", text)).casefold()
    return [sentence.rstrip(".?!:; ") for sentence in re.split(r"(?<=[.?!:;])\s", plain)]


def numbers(text):
    """
    >>> sorted(numbers("10,000 tests, 0.2 of 45. Then 1.5, 8"))
    ['0.2', '1.5', '10000', '45', '8']
    """
    return set(re.findall(r"\d+(?:\.\d+)?", re.sub(r"(?<=\d),(?=\d{3})", "", text)))


def guesses(text):
    """What a text asks, and the chapter whose `ask` keeps the guess.

    >>> list(guesses("Times.\\n\\n**Guess first:** of 100 rays,\\nhow many? Read on; `./course ask 03` keeps your guess."))
    [('of 100 rays, how many? Read on;', '03')]
    """
    for paragraph in re.split(r"\n\s*\n", text):
        paragraph = " ".join(paragraph.split())
        yield from re.findall(r"\*\*Guess first:\*\* (.*?) `\./course ask (\d\d)` keeps your guess", paragraph)


def main():
    faults = []
    texts = {path: read(path) for path in sorted((ROOT / "docs").rglob("*.md"))}
    grafts = 0
    for path, text in texts.items():
        section = re.search(r"^## Graft:.*?(?=^## |\Z)", text, re.S | re.M)
        if not section:
            continue
        grafts += 1
        number = path.name[:2]
        answer = read(ROOT / f"solutions/tracer/{number}.cpp")
        before = ROOT / f"solutions/tracer/{int(number) - 1:02}.cpp"
        earlier = read(before) if before.exists() else "#include <cmath>\n#include <iostream>\n"
        faults += [f"{path.relative_to(ROOT)}: solutions/tracer/{number}.cpp has no such code: {fault}"
                   for fault in graft_faults(section[0], answer, earlier)]

    said = {}
    for path, text in texts.items():
        for sentence in sentences(text):
            said.setdefault(sentence, path)
    questions = 0
    asked = {}
    for path in sorted((ROOT / "chapters").glob("*/questions.json")):
        for question in json.loads(read(path))["questions"]:
            questions += 1
            asked.setdefault(path.parent.name[:2], []).append(
                numbers(" ".join([question["ask"], *question.get("choices", [])])))
            words = " ".join([question["ask"], question["nudge"], question["because"]])
            faults += [f"{path.relative_to(ROOT)}: {said[sentence].relative_to(ROOT)} has this sentence, too: {sentence}"
                       for sentence in sentences(words)
                       if sentence in said and len(sentence.split()) >= FEWEST_WORDS]
    for path, text in texts.items():
        faults += [f"{path.relative_to(ROOT)}: no question of chapter {chapter} has the numbers of: {guess}"
                   for guess, chapter in guesses(text)
                   if not any(numbers(guess) <= of_question for of_question in asked[chapter])]
    print(*faults, f"{grafts} grafts, {questions} questions, {len(faults)} faults", sep="\n")
    return 1 if doctest.testmod()[0] or faults or not grafts or not questions else 0


if __name__ == "__main__":
    sys.exit(main())
