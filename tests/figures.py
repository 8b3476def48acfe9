#!/usr/bin/env python3
"""Checks that the figures quoted in the texts are those of the studies' tables.

A comment before a Markdown table says which study its figures come from:

    <!-- figures: docs/studies/04_normals_aa.csv study="Error budget" text="what it is" -->

Each figure of the table must be that of a row of the study, rounded as it is shown. The first cell of
its line and the heading of its column say which row: each is a variant, a precision or a number, which
is an x. A heading "error" or "cost" says which of the two the column has; without such a heading it is
the error, and a cell "0.02 / 5 ms" has both. The comment must say whatever neither of them says:
variant="...", precision="double", x="100", value="cost". A heading or a first cell that the study does
not know is explained by names="lists of 8, float=batches+8+float|one by one=single rays". One of these
may also be a study, where the comment has none. A cell without a digit, and the columns that text="..."
names (several with | between them), are not checked.

A figure in a sentence has its comment right before it, and never at the start of a line:

    an error of <!-- figure: docs/studies/04_normals_aa.csv study="Samples" variant="independent" x="1"
    precision="double" -->0.24
"""

import csv
import doctest
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
MARK = re.compile(r'<!--\s*(figures?):\s*(\S+)((?:\s+\w+="[^"]*")*)\s*-->')
NUMBER = re.compile(r"([-−]?\d+(?:,\d{3})*(?:\.\d+)?)(?:e([-+]?\d+)|\s*(?:\\cdot|·|×)\s*10\^(-?\d+))?")


class Wrong(Exception):
    pass


def plain(text):
    """
    >>> plain(" **textbook** formula, $10^{-7}$ or `10⁷` ")
    'textbook formula, 10^-7 or 10^7'
    """
    text = re.sub(r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", lambda m: "^" + m[0].translate(SUPERSCRIPTS), text)
    text = re.sub(r"\^\{([^}]*)\}", r"^\1", text.replace("\u202f", " ").replace("\u00a0", " "))
    return re.sub(r"[*`$]", "", text).strip()


def figure(text):
    """The value of the first number, and half a unit of the last place that it shows.

    >>> figure("0"), figure("0.0252"), figure("$7.3\\\\cdot10^{-12}$"), figure("7·10⁻³ %"), figure("16,384")
    ((0.0, 0), (0.0252, 5e-05), (7.3e-12, 5e-14), (0.007, 0.0005), (16384.0, 0.5))
    """
    found = NUMBER.search(plain(text))
    if not found:
        raise Wrong(f"'{text}' should have a number")
    digits = found[1].replace(",", "").replace("−", "-")
    exponent = int(found[2] or found[3] or 0)
    places = len(digits.partition(".")[2])
    half = 0 if digits == "0" else float(f"5e{exponent - places - 1}")  # a plain 0 means exactly that
    return float(f"{digits}e{exponent}"), half


def same(shown, value):
    """
    >>> same("0.0252", 0.0252272), same("0.0253", 0.0252272), same("7.3e-12", 7.25773e-12)
    (True, False, True)
    """
    number, half = figure(shown)
    return abs(number - value) <= half * (1 + 1e-9)


def number(text):
    return float(text) if re.fullmatch(r"-?\d+(\.\d+)?(e[-+]?\d+)?", text) else None


def key_of(rows, text):
    """What a heading says about a row.

    >>> rows = [{"study": "s", "variant": "a", "precision": "float", "x": "1e+07"}]
    >>> [key_of(rows, text) for text in ("a", "float", "10,000,000", "s", "cost", "b")]
    [('variant', 'a'), ('precision', 'float'), ('x', 10000000.0), ('study', 's'), ('value', 'cost'), None]
    """
    text = plain(text)
    for field in ("variant", "precision", "study"):
        if any(plain(row[field]) == text for row in rows):
            return field, text
    x = number(text.replace(",", ""))
    if x is not None and any(float(row["x"]) == x for row in rows):
        return "x", x
    return ("value", text) if text in ("error", "cost") else None


def keys_of(rows, text, names):
    """The same for what `names` may explain.

    >>> rows = [{"study": "s", "variant": "a", "precision": "float", "x": "8"}]
    >>> keys_of(rows, "eight at once", {"eight at once": ["8", "float"]}), keys_of(rows, "b", {})
    ({'x': 8.0, 'precision': 'float'}, None)
    """
    keys = [key_of(rows, one) for one in names.get(plain(text), [text])]
    return None if None in keys else dict(keys)


def check(rows, keys, shown):
    """Checks that the row with these keys has the figure that is shown."""
    keys = dict(keys)
    fields = [keys.pop("value", "error")]
    if fields == ["error"] and " / " in shown:
        fields, shown = ["error", "cost"], shown.split(" / ")
    else:
        shown = [shown]
    if "x" in keys:
        keys["x"] = float(keys["x"])
    found = [row for row in rows
             if all((float(row[k]) if k == "x" else plain(row[k])) == v for k, v in keys.items())]
    if len(found) != 1:
        raise Wrong(f"{len(found)} rows have {keys}: there should be one")
    for field, text in zip(fields, shown):
        if not same(text, float(found[0][field])):
            raise Wrong(f"{keys}: the text has '{text.strip()}', the table {field} {found[0][field]}")


def study_rows(file, options):
    with open(ROOT / file, newline="", encoding="utf-8") as table:
        rows = [row for row in csv.DictReader(table) if options.get("study") in (None, row["study"])]
    if not rows:
        raise Wrong(f"{file} has no study '{options['study']}'")
    return rows


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def check_table(rows, keys, prose, names, text):
    """Checks the first table of a text; returns how many figures it has."""
    lines = text.lstrip("\n").split("\n")
    table = lines[:next((i for i, line in enumerate(lines) if not line.startswith("|")), len(lines))]
    if len(table) < 3:
        raise Wrong("a table should follow")
    columns = [None]
    for heading in cells(table[0])[1:]:
        columns.append(None if heading in prose else keys_of(rows, heading, names))
        if columns[-1] is None and heading not in prose:
            raise Wrong(f"the heading '{heading}' is no variant, precision or x of the study")
    count = 0
    for line in table[2:]:
        first, *rest = cells(line)
        head = keys_of(rows, first, names)
        if head is None:
            raise Wrong(f"'{first}' is no variant, precision or x of the study")
        for column, shown in zip(columns[1:], rest):
            if column and re.search(r"\d", shown):
                check(rows, {**keys, **head, **column}, shown)
                count += 1
    if not count:
        raise Wrong("the table has no figures")
    return count


def check_text(path):
    """Prints what is wrong in a text; returns how many figures are right and how many marks wrong."""
    text, right, wrong = path.read_text(encoding="utf-8"), 0, 0
    for mark in MARK.finditer(text):
        try:
            keys = {k: plain(" ".join(v.split())) for k, v in re.findall(r'(\w+)="([^"]*)"', mark[3])}
            rows = study_rows(mark[2], keys)
            prose = keys.pop("text", "").split("|")
            names = dict(name.rsplit("=", 1) for name in keys.pop("names", "").split("|") if name)
            names = {name: said.split("+") for name, said in names.items()}
            keys.pop("study", None)
            after = text[mark.end():]
            if mark[1] == "figure" and text[:mark.start()].endswith("\n"):
                raise Wrong("text after a comment at the start of a line is not Markdown: put a word before the comment")
            if mark[1] == "figures":
                right += check_table(rows, keys, prose, names, after)
            else:
                check(rows, keys, re.match(r"\S*(?:\s\d{3}\b)*", after)[0])
                right += 1
        except (Wrong, OSError, KeyError, ValueError) as error:
            line = text.count("\n", 0, mark.start()) + 1
            print(f"{path.relative_to(ROOT)}:{line}: {error}")
            wrong += 1
    if len(re.findall(r"<!--\s*figure", text)) != len(MARK.findall(text)):
        print(f"{path.relative_to(ROOT)}: a comment that starts with 'figure' cannot be read")
        wrong += 1
    return right, wrong


def main():
    wrong = doctest.testmod()[0]
    right = 0
    for path in sorted([*(ROOT / "docs").rglob("*.md"), ROOT / "README.md"]):
        counts = check_text(path)
        right += counts[0]
        wrong += counts[1]
    print(f"{right} figures of the texts are in the studies' tables" + (f", {wrong} faults" if wrong else ""))
    return 1 if wrong or not right else 0


if __name__ == "__main__":
    sys.exit(main())
