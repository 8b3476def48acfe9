#!/usr/bin/env python3
"""Checks that the figures quoted in the texts are those of the studies' tables.

    tests/figures.py           says which figures differ
    tests/figures.py --write   puts the tables' numbers in their place, with as many digits; the words around
                               them stay, so read those again

A figure has its key in a comment right before it, which never begins a line:

    an error of <!--= accuracy/equal time/sobol/600 -->0.0087

A key is a chapter's number, `accuracy` or `instructions` (see tests/08_effects/costs), then a study, a variant, an x,
a precision: as many of them as it takes to name one row of the table. Each may be short: words of it, or their
beginnings, in order. Case and punctuation do not matter. Without a precision, double is meant; without `cost`, the
error. "0.0091 / 5 ms" are error and cost.

A comment above a table says what all its figures have in common. The first cell of a line and the heading of a column
say the rest, as a key does, or with commas between the parts; if they say otherwise than the comment, they hold:

    <!--= 04/edge -->
    | samples | independent | Sobol, float |
    |---|---|---|
    | 16 | 0.0936 | 0.0389 |

A heading or first cell in other words has a key of its own: "each worker <!--= one a worker -->"; the key "-" means
that a column is not checked. Cells without a digit are not checked either.
"""

import csv
import doctest
import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MARK = re.compile(r"<!--=\s*(.*?)\s*-->", re.S)
SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"
TIMES_10 = r"\s*(?:\\cdot|·|×)\s*10"
NUMBER = re.compile(r"([-−]?)(\d+(?:,\d{3})*(?:\.\d+)?)"
                    rf"(?:(e|{TIMES_10}\^\{{?|{TIMES_10}(?=[{SUPERSCRIPTS}]))([-+]?\d+|[{SUPERSCRIPTS}]+))?")
FIELDS = ("study", "variant", "x", "precision")


class Wrong(Exception):
    pass


# ---- What a key names ------------------------------------------------------------------------

def plain(text):
    """
    >>> plain(" **textbook** formula, $10^{-7}$ or `10⁷` ")
    'textbook formula, 10^-7 or 10^7'
    """
    text = re.sub(f"[{SUPERSCRIPTS}]+", lambda m: "^" + from_superscripts(m[0]), text)
    return re.sub(r"[*`${}]", "", text).strip()


def from_superscripts(text):
    return text.translate(str.maketrans(SUPERSCRIPTS, "0123456789-"))


def number(text):
    """
    >>> number("10,000"), number("10^7"), number("1e+07"), number("8-wide")
    (10000.0, 10000000.0, 10000000.0, None)
    """
    text = re.sub(r"^10\^", "1e", text.replace(",", ""))
    return float(text) if re.fullmatch(r"-?\d+(\.\d+)?(e[-+]?\d+)?", text) else None


def words(text):
    """
    >>> words("Schlick, n = 1.5"), words("fetch_add")
    (['schlick', 'n', '1.5'], ['fetch', 'add'])
    """
    return re.findall(r"\d+(?:\.\d+)?|[^\W\d_]+", text.casefold())


@functools.cache
def fit(part, name):
    """2 if a part of a key is this name, 1 if its words begin words of the name, in order.

    >>> [fit(part, "Sobol in twin halves") for part in ("sobol in twin halves", "sob twin", "twin sob")]
    [2, 1, 0]
    >>> fit("16", "tiles of 16"), fit("1", "tiles of 16"), fit("10,000", "1e4"), fit("1e-4", "1e4")
    (1, 0, 2, 0)
    """
    if number(name) is not None:
        return 2 * (number(part) == number(name))
    said, named = words(part), words(name)
    if said == named:
        return 2
    rest = iter(named)
    begins = all(any(word == one or not one[0].isdigit() and word.startswith(one) for word in rest) for one in said)
    return int(begins and said != [])


def narrowed(rows, part):
    """The rows that a part of a key fits best."""
    fits = [max(fit(part, row[field]) for field in FIELDS) for row in rows]
    best = max(fits, default=0)
    return [row for row, one in zip(rows, fits) if one == best > 0]


def choice(rows):
    """What a key may say to tell these rows apart."""
    names = {field: list(dict.fromkeys(row[field] for row in rows)) for field in FIELDS}
    several = [f"{field}: {' | '.join(found)}" for field, found in names.items() if len(found) > 1]
    return "; ".join(several[:1] if len(names["study"]) > 1 else several)


def chosen(rows, part):
    found = narrowed(rows, part)
    if not found:
        raise Wrong(f"'{part}' is unknown; there are {choice(rows)}")
    return found


def find(rows, key, common=()):
    """The row that a key names. What is common holds only as far as the key does not say otherwise.

    >>> rows = [{"study": "s", "variant": v, "precision": p, "x": x}
    ...         for v in ("a", "a b") for p in ("double", "float") for x in ("1", "1e+07")]
    >>> find(rows, ["a", "1"]) == rows[0], find(rows, ["b"], ["float", "10^7"]) == rows[7]
    (True, True)
    >>> find(rows, ["a", "float", "2"])
    Traceback (most recent call last):
    Wrong: '2' is unknown; there are x: 1 | 1e+07
    >>> find(rows, ["b"])
    Traceback (most recent call last):
    Wrong: 'b' names several rows: say one of x: 1 | 1e+07
    """
    for part in key:
        rows = chosen(rows, part)
    for part in common:
        rows = narrowed(rows, part) or rows
    rows = [row for row in rows if row["precision"] == "double"] or rows
    if len(rows) > 1:
        raise Wrong(f"'{'/'.join([*key, *common])}' names several rows: say one of {choice(rows)}")
    return rows[0]


@functools.cache
def table(name):
    for file in [*sorted((ROOT / "docs/studies").glob("*.csv")), ROOT / "tests/08_effects/costs/instructions.csv"]:
        if name in (file.stem, file.stem.partition("_")[0]):
            with open(file, newline="", encoding="utf-8") as lines:
                return list(csv.DictReader(lines))
    raise Wrong(f"'{name}' is neither a chapter with a table in docs/studies nor 'accuracy' nor 'instructions'")


def parts_of(key):
    """The parts of a key but for its quantity, and that.

    >>> parts_of("04/edge/16/cost"), parts_of("04/edge")
    ((['04', 'edge', '16'], 'cost'), (['04', 'edge'], None))
    """
    parts = [plain(part) for part in key.split("/")]
    quantities = [part for part in parts if part in ("error", "cost")]
    return [part for part in parts if part not in quantities], quantities[0] if quantities else None


# ---- Numbers as a text shows them ------------------------------------------------------------

def shown(text):
    """The first number, and half a unit of the last place that it shows.

    >>> shown("0"), shown("0.0252"), shown("$7.3\\cdot10^{-12}$"), shown("7·10⁻³ %"), shown("−16,384")
    ((0.0, 0), (0.0252, 5e-05), (7.3e-12, 5e-14), (0.007, 0.0005), (-16384.0, 0.5))
    """
    sign, digits, _, exponent = NUMBER.search(text).groups()
    digits, exponent = digits.replace(",", ""), int(from_superscripts(exponent or "0"))
    places = len(digits.partition(".")[2])
    half = 0 if digits == "0" else float(f"5e{exponent - places - 1}")  # a plain 0 means exactly that
    return float(f"{'-' if sign else ''}{digits}e{exponent}"), half


def same(text, value):
    """
    >>> same("0.0252", 0.0252272), same("0.0253", 0.0252272), same("7.3e-12", 7.25773e-12)
    (True, False, True)
    """
    one, half = shown(text)
    return abs(one - value) <= half * (1 + 1e-9)


def rewritten(text, value):
    """The number for another value, with as many digits, and its exponent as it is written here.

    >>> [rewritten(text, 0.012345) for text in ("0.021", "300", "0", "5·10⁻⁴", "7.0\\cdot10^{-12", "2e-05")]
    ['0.012', '0.0123', '0.01', '1·10⁻²', '1.2\\\\cdot10^{-2', '1e-2']
    >>> rewritten("19,620", 20834.5), rewritten("98", 1034.2), rewritten("0.440", -0.5), rewritten("2·10⁻³", 0)
    ('20,834', '1034', '−0.500', '0')
    """
    _, digits, base, exponent = NUMBER.fullmatch(text).groups()
    count = max(1, len(re.sub(r"\D", "", digits).lstrip("0")))
    mantissa, power = f"{abs(value):.{count - 1}e}".split("e")
    sign = "−" if value < 0 else ""
    if value == 0:
        return "0"
    if base:
        power = str(int(power))
        if exponent[-1] in SUPERSCRIPTS:
            power = power.translate(str.maketrans("0123456789-", SUPERSCRIPTS))
        return sign + mantissa + base + power
    places = max(0, count - 1 - int(power))
    return sign + f"{abs(value):{',' if ',' in digits else ''}.{places}f}"


# ---- The figures of a text -------------------------------------------------------------------

def figures_at(text, start, end, row, quantity):
    """The numbers between these places, one or error and cost, each with its row and quantity."""
    first = NUMBER.search(text, start, end)
    if not first:
        raise Wrong("a number should follow")
    numbers, quantities = [first], [quantity or ("error" if row["error_name"] else "cost")]
    between = re.compile(r"[ \w%$]* / (?=\d)").match(text, first.end(), end)
    if between and not quantity:
        numbers, quantities = [first, NUMBER.match(text, between.end(), end)], ["error", "cost"]
    for one in quantities:
        if not row[f"{one}_name"] or not float(row[one]) < float("inf"):
            raise Wrong(f"the table has no {one} of {', '.join(row[field] for field in FIELDS)}")
    return [(*both, row) for both in zip(numbers, quantities)]


def key_of(rows, cell):
    """What a heading or first cell says, as parts_of does; None if nothing is to be checked.

    >>> rows = [{"study": "s", "variant": "v / sqrt, one", "precision": "double", "x": "4096"}]
    >>> [key_of(rows, cell) for cell in ("`v / sqrt`, one", "4,096", "sqrt, double", "cost", "ratio <!--= - -->")]
    [(['v / sqrt, one'], None), (['4,096'], None), (['sqrt', 'double'], None), ([], 'cost'), None]
    """
    mark, name = MARK.search(cell), plain(cell)
    if mark:
        return None if mark[1] == "-" else parts_of(mark[1])
    if not name or narrowed(rows, name):
        return ([name], None) if name else None
    parts, quantity = parts_of(name.replace(",", "/"))
    for part in parts:
        chosen(rows, part)
    return parts, quantity


def lines_of_table(text, start):
    """Where the cells of each line begin and end.

    >>> text = "| a | b |\\n|---|---|\\n| 1 | 20 |\\n"
    >>> [[text[slice(*cell)] for cell in line] for line in lines_of_table(text, 0)]
    [[' a ', ' b '], ['---', '---'], [' 1 ', ' 20 ']]
    """
    lines = []
    while text.startswith("|", start):
        end = text.find("\n", start) % (len(text) + 1)
        bars = [bar.start() for bar in re.finditer(r"\|", text[start:end])]
        lines.append([(start + left + 1, start + right) for left, right in zip(bars, bars[1:])])
        start = end + 1
    return lines


def figures_of_table(text, start, rows, common, quantity):
    """The figures of the table that begins here, and where keys stand in its headings and first cells."""
    if common:
        rows = chosen(rows, common[0])
    heading, _, *lines = lines_of_table(text, start) + [[]] * 2
    columns = [key_of(rows, text[slice(*cell)]) for cell in heading[1:]]
    figures = []
    for first, *rest in filter(None, lines):
        head = key_of(rows, text[slice(*first)])
        for column, (begin, end) in zip(columns, rest):
            if head and column and re.search(r"\d", text[begin:end]):
                row = find(rows, column[0] + head[0], common[1:])
                figures += figures_at(text, begin, end, row, column[1] or head[1] or quantity)
    if not figures:
        raise Wrong("the table has no figures")
    cells = heading + [line[0] for line in lines if line]
    return figures, {mark.start() for cell in cells for mark in MARK.finditer(text, *cell)}


def figures_of(text, wrong):
    """All figures of a text, as figures_at gives them; wrong(place, why) is told of what cannot be read."""
    figures, read = [], set()
    for mark in MARK.finditer(text):
        if mark.start() in read:
            continue
        try:
            (name, *parts), quantity = parts_of(mark[1])
            table_below = re.compile(r"[ \t]*\n+(?=\|)").match(text, mark.end())
            if table_below:
                more, keys = figures_of_table(text, table_below.end(), table(name), parts, quantity)
                read |= keys
            elif text[:mark.start()].endswith("\n"):
                raise Wrong("text after a comment at the start of a line is not Markdown: put a word before the comment")
            elif not re.compile(r"[$*`]*[-−]?\d").match(text, mark.end()):
                raise Wrong("a number should follow at once")
            else:
                end = text.find("\n", mark.end()) % (len(text) + 1)
                more = figures_at(text, mark.end(), end, find(table(name), parts), quantity)
            figures += more
        except Wrong as error:
            wrong(mark.start(), error)
    if text.count("<!--=") != len(MARK.findall(text)):
        wrong(text.rfind("<!--="), "a comment that begins with '<!--=' does not end before another one begins")
    return figures


def main(write):
    faults, right = doctest.testmod()[0], 0
    for path in sorted([*(ROOT / "docs").rglob("*.md"), ROOT / "README.md"]):
        text, edits = path.read_text(encoding="utf-8"), []

        def wrong(place, why):
            nonlocal faults
            faults += 1
            print(f"{path.relative_to(ROOT)}:{text.count(chr(10), 0, place) + 1}: {why}")

        for found, quantity, row in figures_of(text, wrong):
            value = float(row[quantity])
            if same(found[0], value):
                right += 1
            elif write:
                edits.append((found, rewritten(found[0], value)))
                print(f"{path.relative_to(ROOT)}: {found[0]} is now {edits[-1][1]}")
            else:
                wrong(found.start(), f"the text has {found[0]}, the table {row[quantity]}: the {quantity} of "
                      f"{', '.join(row[field] for field in FIELDS)}")
        for found, new in sorted(edits, key=lambda edit: -edit[0].start()):
            text = text[:found.start()] + new + text[found.end():]
        if edits:
            path.write_text(text, encoding="utf-8")
    print(f"{right} figures of the texts are in the studies' tables" + (f", {faults} faults" if faults else ""))
    return 1 if faults or not right else 0


if __name__ == "__main__":
    sys.exit(main(write="--write" in sys.argv[1:]))
