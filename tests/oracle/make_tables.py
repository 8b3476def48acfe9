#!/usr/bin/env python3
"""Writes the headers of exact values that checkpoints compare with.

    python3 tests/oracle/make_tables.py           writes them
    python3 tests/oracle/make_tables.py --check   fails when one is not what this script makes
"""
import importlib
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
stale = []
for script in sorted(here.glob("[0-9][0-9]_*.py")):
    for name, text in importlib.import_module(script.stem).HEADERS.items():
        path = root / name
        if "--check" not in sys.argv:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            stale.append(name)
if stale:
    sys.exit("not what tests/oracle/make_tables.py makes: " + ", ".join(stale))
