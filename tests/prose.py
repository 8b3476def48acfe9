#!/usr/bin/env python3
"""prose.py [FILE...]: checks the spelling and the wording of the texts that a learner reads.

Reads the Markdown pages, the known mistakes, the questions, the course's titles and captions and the companion's
help, or the files that you name: of C++ headers it reads the comments. Leaves out code, formulas, the targets of
links, HTML comments and names such as CMake.

- Spelling: American, by hunspell's en_US and by tests/words.txt, the terms and names of this course.
- Phrases that the texts do not use, such as "shall"; repeated words.
- Sentences in a row that begin with So, But, And or Then, instead of being joined.
- Lines over 125 columns, except for tables, images, code and HTML comments.
- Lines of a paragraph that Markdown takes for a list.
- In the chapters that go idea by idea: more than 350 words in a row, outside of the folds, without a figure, a picture
  or code.
- Without FILE: more words in the core's texts than CORE_WORDS allows, outside of the folds and of code.

Each finding is one line: file:line: what is wrong, and what would be right. Ends with 1 if there is one, or if
hunspell or its dictionary is missing.
"""

import doctest
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FILES = ["README.md", "CONTRIBUTING.md", "docs/**/*.md", "tests/mistakes/**/*.md", "chapters/*/start/*.md",
         "chapters/*/questions.json", "course.json", "companion/commands/commands.inc", "exercises/**/*.hpp",
         "solutions/**/*.hpp", "chapters/**/rt/*.hpp"]
WORD_LIST = ROOT / "tests" / "words.txt"
HUNSPELL = ["hunspell", "-d", "en_US", "-i", "utf-8", "-a"]
COLUMNS = 125
IDEA_BY_IDEA = re.compile(r"(?:0[2-7]|1[0-4])-\w+\.md")  # the chapters' texts
WORDS_IN_A_ROW = 350
CORE_WORDS = {"0?-*.md": 32_000, "11-*.md": 6_500}  # of the texts in docs/, at most so many in all
HIDDEN = "¤"  # stands for each character that is left out: lines and columns stay

# What is not prose in the pages, in the order in which it is hidden.
CODE = re.compile(r"^( *)```.*?^\1```"  # fenced
                  r"|(?<=\n\n) {7}.*(?:\n+ {7}.*)*"  # indented, in an item of a hint
                  r"|^(?:caught by|also fails|(?:only if|unless) the answer has|compare says|data race in): [^\n]*"  # of a mistake
                  r"|<!--.*?-->", re.M | re.S)
MARKUP = re.compile(r"(`+)[^`].*?\1|\$\$.*?\$\$|\$[^$]+\$|(?<=\])\([^)]*\)|<?https?://[^\s>]+>?|</?[a-z][^<>]*>", re.S)

# A word of its own, not a part of first.cpp, sqrt(2) or std::vector.
WORD = re.compile(r"(?<![\w./:¤])(?<! -)[^\W\d_]{2,}(?:['’](?:[a-rt-z]|s\w)\w*)?(?![\w(/+¤])(?![.:]\w)")

# What the texts do not say, and what they say instead. A space may be the end of a line.
SAID = {
    r"shall": "must' or 'will",
    r"on the average": "on average",
    r"some (hundred|thousand|million)s?(?! of)": "several",
    r"some (milliseconds|seconds|minutes|hours|days)": "a few",
    r"by lot": "at random",
    r"other ones": "others",
    r"of which the": "whose",
    r"(came|comes) as:": "actual:",
    r"what came": "the actual value",
    r"as many as there are": "all of them",
    r"which one that is": "which one",
    r"no end after": "timed out after",
    r"functions of school": "functions that you know from school",
    r"towards": "toward",
    r"for ever": "forever",
    r"any more(?=[.,;:)])": "anymore",
    r"right within|exact (to|within)": "accurate to",
    r"(sines?|cosines?|angles?|index|indices) behind": "of refraction' or 'on the other side",
    r"there or not": "present or absent",
    r"for a time of": "for",
    r"by the clock": "in seconds",
    r"be it": "even if it is",
    r"(your|our) \d\d\.\d|\d\d\.\d['’]s": "the name of what it does",
}
PHRASES = [(re.compile(rf"\b(?:{said})(?!\w)".replace(" ", r"\s+"), re.I), better) for said, better in SAID.items()]
START = r"(?:\A|(?<=[.!?:;]\s)|(?<=\n\n)|(?<=[-#|>\"(] )|(?<=\d\. ))"
PHRASES += [
    (re.compile(START + r"Who\b[^.!?]*[.!](?=\s)"), "If you …' or 'Whoever …"),
    (re.compile(START + r"(Were|Had|Should) (it|you|they|the|a|there)\b[^.!?]*[.!](?=\s)"), "If …"),
    (re.compile(r"\b(?!that\b|had\b)([^\W\d_]+)(?: | ?\n *)\1\b", re.I), "one of the two"),
]


def hide(pattern, text):
    return pattern.sub(lambda found: re.sub(r"[^\n]", HIDDEN, found[0]), text)


def prose(path, text):
    """The text with all else hidden.

    >>> prose("a.md", "See `$HOME`, $x+1$ and\\n[it](a.md).<!--\\n-->\\n")
    'See ¤¤¤¤¤¤¤, ¤¤¤¤¤ and\\n[it]¤¤¤¤¤¤.¤¤¤¤\\n¤¤¤\\n'
    >>> prose("a.json", '{"ask": "Which colour?", "picture": "colour.png"}')
    '¤¤¤¤¤¤¤¤"Which colour?"¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤'
    >>> prose("a.hpp", "int colour;  // A color, in `rgb`.\\n")
    '¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤¤A color, in ¤¤¤¤¤.\\n'
    """
    if path.endswith(".md"):
        text = hide(CODE, text)
    elif path.endswith((".json", ".inc")):  # its strings, except for names and paths
        if path.endswith(".json"):
            json.loads(text)
        strings = re.compile(r'"(?:[^"\\\n]|\\.)*"|.')
        text = strings.sub(lambda found: found[0] if " " in found[0].strip() else HIDDEN * len(found[0]), text)
    elif path.endswith(".hpp"):
        text = re.sub(r"^(.*?// ?|.*)(.*)$", lambda found: HIDDEN * len(found[1]) + found[2], text, flags=re.M)
    return hide(MARKUP, text)


def phrases(text):
    """The phrases that a text should not have: where, and what would be right.

    >>> for bad in ("It shall be.", "right on\\nthe average", "some hundred rays", "some milliseconds", "chosen by lot",
    ...             "the other ones", "of which the first", "it came as: 3", "what came", "as many as there are",
    ...             "Who calls it needs it. ", "So. Who asks\\nwaits.\\n", "Were it so, it would. ", "say the the",
    ...             "say the\\n  the", "which one that is", "and be it one", "no end after 20 s", "functions of school",
    ...             "no more, any more.",
    ...             "right within 2", "the cosine behind", "there or not", "for a time of 0", "by the clock",
    ...             "your 08.6", "in 03.3's loop"):
    ...     assert len(list(phrases(bad))) == 1, bad
    >>> for good in ("Who calls it? ", "the one who calls", "the one on the left", "some hundreds of rays",
    ...              "the ¤¤¤ the", "It had had one."):
    ...     assert not list(phrases(good)), good
    """
    for pattern, better in PHRASES:
        for found in pattern.finditer(text):
            yield found.start(), f"'{' '.join(found[0].split())}': write '{better}'"


SENTENCE = re.compile(r"(?:\A|(?<=[.!?:])\s+(?=[A-Z¤*$\"(]))")
LINKS = (2, "So But And Then".split()), (3, "So But And Then This It".split())


def chains(text):
    """Two sentences in a row that begin with So, But, And or Then, and three that begin with these, This or It.

    >>> list(chains("Why. But how?\\nSo it is."))
    [(5, '2 sentences in a row begin with But, So: join them')]
    >>> list(chains("So it is. This is it. It is. Is it?"))
    [(0, '3 sentences in a row begin with So, This, It: join them')]
    >>> list(chains("So it is.\\n\\nBut why?\\n- And now?\\n- Then. Why so? So."))
    []
    """
    for block in re.finditer(r".+(?:\n(?! *(?:[-|>#]|\d+\. )).+)*", text):
        starts = [found.end() for found in SENTENCE.finditer(block[0])]
        words = [re.match(r"\w*", block[0][start:])[0] for start in starts]
        for count, links in LINKS:
            for i, start in enumerate(starts[:len(starts) - count + 1]):
                row = words[i:i + count]
                if all(word in links for word in row):
                    yield block.start() + start, f"{count} sentences in a row begin with {', '.join(row)}: join them"


def long_lines(text):
    """The lines that are too long, except for tables, images and code.

    >>> line = "A line that does not end. " * 5
    >>> list(long_lines("\\n" + line)), list(long_lines("| " + line)), list(long_lines("![" + line))
    ([(1, '130 columns: break the line before 125')], [], [])
    """
    for line in re.finditer(r".+", text):
        if len(line[0]) > COLUMNS and not re.match(r" *\||.*!\[|[ ¤]*$", line[0]):
            yield line.start(), f"{len(line[0])} columns: break the line before {COLUMNS}"


def lists_by_chance(text):
    """
    >>> list(lists_by_chance("White is\\n1. In all, u\\n\\n- one\\n  and\\n- two:\\n\\nFirst:\\n- one"))
    [(9, "a list begins with '1. ': break the line elsewhere")]
    """
    for line in re.finditer(r"^(?![-+*] |\d+\. |[ |#<]|¤+\n).*[^:\n]\n(([-+*]|1\.) )", text, re.M):
        yield line.start(1), f"a list begins with '{line[1]}': break the line elsewhere"


def core_words(text):
    """How many words a text has outside of the folds and of code.

    >>> core_words("# One `two`\\n```\\ncode\\n```\\n<details>\\nstars\\n```\\ncode\\n```\\n</details>\\n$x$ five\\n")
    5
    """
    return len(re.sub(r"<details>.*?</details>|```.*?```", "", text, flags=re.S).split())


def stretches(text, most=WORDS_IN_A_ROW):
    """Where more words than these stand in a row, without a figure, a picture or code; a formula is one word. The list
    of sources at the end does not count.

    >>> list(stretches("One two\\nthree.\\n", 2))
    [(0, '3 words without a figure, a picture or code: show something before 2')]
    >>> [list(stretches("One $t = 2$\\n" + shown + "\\n\\ntwo three.\\n", 2)) for shown in
    ...  ("![A ball](ball.png)", "<!-- live: 03.roots -->", "```\\ncode with many words\\n```")]
    [[], [], []]
    >>> list(stretches("One two\\n## Where to read on\\nthree", 2))
    []
    >>> list(stretches("One\\n<details>\\n![A ball](ball.png) for the stars\\n</details>\\ntwo three.\\n", 2))
    [(0, '3 words without a figure, a picture or code: show something before 2')]
    """
    text = re.sub(r"<details>.*?</details>", lambda fold: re.sub(r"[^\n]", " ", fold[0]), text, flags=re.S)
    text, start = text.split("\n## Where to read on\n")[0], 0
    for shown in re.finditer(r"^( *)```(?:.|\n)*?^\1```|^.*(?:!\[|<!-- live:).*$|\Z", text, re.M):
        row = re.sub(r"<!--.*?-->", "", text[start:shown.start()], flags=re.S)
        count = len(re.sub(r"\$\$.*?\$\$|\$[^$]+\$", "x", row, flags=re.S).split())
        if count > most:
            yield start, f"{count} words without a figure, a picture or code: show something before {most}"
        start = shown.end()


def words(text):
    """The words whose spelling counts, and where they are. Names with capitals inside are not.

    >>> [word for _, word in words("CMake's first.cpp: the PPM of Sobol’s look-at, sqrt(x), and/or don't.")]
    ['the', 'of', 'Sobol', 'look', 'at', "don't"]
    """
    for found in WORD.finditer(text):
        if found[0][1:].lower() == found[0][1:]:
            yield found.start(), found[0].replace("’", "'")


def misspelled(candidates):
    """The words that the dictionary lacks, each with what it suggests; None where there is no dictionary."""
    try:
        ran = subprocess.run(HUNSPELL, input="".join(f"^{word}\n" for word in candidates), text=True,
                             encoding="utf-8", capture_output=True, check=False)
    except OSError:
        return None
    if ran.returncode or not ran.stdout.startswith("@"):
        return None
    return {found[1]: found[2] or "" for found in re.finditer(r"^[&#] (\S+)[^:\n]*(?:: ([^,\n]*))?", ran.stdout, re.M)}


def listed(findings):
    """The project's own words. They are sorted, without capitals that only a sentence's start would give."""
    own = WORD_LIST.read_text(encoding="utf-8").split()
    for before, word in zip(own, own[1:]):
        if before.lower() >= word.lower():
            line = own.index(word) + 1
            findings.append((WORD_LIST, line, f"'{word}' after '{before}': sort the words, each of them once"))
    return own


def main(named):
    if doctest.testmod()[0]:
        return 1
    findings, uses = [], {}
    every = {path for pattern in FILES for path in ROOT.glob(pattern)}
    for path in sorted({pathlib.Path(name).resolve() for name in named} or every):
        whole = path.read_text(encoding="utf-8")
        text = prose(path.name, whole)
        line = lambda start: text.count("\n", 0, start) + 1
        found = list(phrases(text))
        if path.suffix in (".md", ".txt"):
            found += [*long_lines(text), *chains(text), *lists_by_chance(text)]
        if IDEA_BY_IDEA.fullmatch(path.name) and path.parent == ROOT / "docs":
            found += stretches(whole)
        findings += [(path, line(start), what) for start, what in found]
        for start, word in words(text):
            uses.setdefault(word, []).append((path, line(start)))

    for pattern, most in CORE_WORDS.items() if not named else ():
        count = sum(core_words(path.read_text(encoding="utf-8")) for path in (ROOT / "docs").glob(pattern))
        if not 0 < count <= most:
            findings.append((ROOT / "docs" / pattern, 1, f"{count} words: at most {most} are to be read"))

    own = listed(findings)
    known = {*own, *(word.capitalize() for word in own)}
    wrong = misspelled(word for word in uses if word not in known)
    if wrong is None:
        print("the texts' spelling cannot be checked: install hunspell with its en_US dictionary (on Debian and "
              "Ubuntu the packages hunspell and hunspell-en-us)")
        return 1
    for word, better in wrong.items():
        advice = (f"write '{better}', or" if better else "correct it, or") + " add it to tests/words.txt if it is right"
        findings += [(path, line, f"'{word}': {advice}") for path, line in uses[word]]
    for number, word in enumerate(own, 1):
        if not named and word not in uses and word.capitalize() not in uses:
            findings.append((WORD_LIST, number, f"'{word}' is in no text: take it from the list"))

    for path, line, what in sorted(findings):
        print(f"{path.relative_to(ROOT) if path.is_relative_to(ROOT) else path}:{line}: {what}")
    print(f"{sum(map(len, uses.values()))} words of prose" + (f", {len(findings)} findings" if findings else ", no finding"))
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
