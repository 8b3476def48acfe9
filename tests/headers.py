#!/usr/bin/env python3
"""headers.py COMPILER [FOLDERS OF MPI]

Compiles each header alone: it must include what it uses of the course. Reading the standard library
would take most of the time, so it is compiled once for all headers; a missing standard header is not
noticed. clang++ is asked where there is one: it takes a third of g++'s time. A header that another file
includes before anything else needs no check of its own.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# These are not made to be compiled alone, and why.
BODIES = {
    "chapters/00_toolchain/sums_body.hpp": "included in a namespace, once for each instruction set",
    "chapters/10_batches/lanes_body.hpp": "included in a namespace, once for each width",
    "chapters/10_batches/narrow_lanes.hpp": "for a file that names its namespaces",
    "common/app/windows/held.hpp": "includes a header that only Windows has",
    "common/app/windows/processor_time.hpp": "includes a header that only Windows has",
    "chapters/00_toolchain/by_hand/parts/shade.hpp": "an example, compiled by a script of its own",
}
BODIES |= {
    str(header.relative_to(ROOT)): "stands before a program's headers, and is compiled with a program"
    for header in ROOT.glob("companion/*/recorder/rt/*.hpp")
}
FIRST = re.compile(r"\A(?:#pragma once\n|//.*\n|\n)*#include ([<\"])(.*)[>\"]")


def first_include(file, text):
    """What a file includes first."""
    found = FIRST.match(text)
    if not found:
        return None
    return found[2] if found[1] == "<" else str(file.parent / found[2])


def include_order(header):
    """The include folders of a header's chapter; see cmake/Course.cmake."""
    room, chapter = header.parts[:2]
    if room == "companion":
        return [ROOT, ROOT / "common"]
    if room == "common":
        return [(ROOT / header).parent, ROOT / "common"]
    if chapter == "renderer":
        chapter = "14_z"  # above chapter 14
    up_to = [f for kind in ("chapters", "solutions") for f in sorted((ROOT / kind).iterdir()) if f.name <= chapter]
    if chapter == "13_cluster":
        up_to.append(ROOT / "chapters/renderer")
    kinds = [rt.parent for folder in up_to for rt in sorted(folder.glob("*/rt"))]
    return [(ROOT / header).parent, *up_to, *kinds, ROOT / "common"]


def main():
    compiler = shutil.which("clang++") or sys.argv[1]
    mpi = sys.argv[2:]  # without it, chapter 13 is left out
    flags = ["-std=c++20", "-O0", *(f"-isystem{folder}" for folder in mpi)]
    if "clang" in pathlib.Path(compiler).name:  # the standard library's templates are instantiated once, not each time
        flags.append("-fpch-instantiate-templates")
    files = {
        file.relative_to(ROOT): file.read_text()
        for room in ("common", "companion", "solutions", "chapters")
        for file in sorted((ROOT / room).rglob("*.[ch]pp"))
    }
    headers = [f for f in files if f.suffix == ".hpp" and str(f) not in BODIES and (mpi or "13_cluster" not in f.parts)]
    standard = sorted(set(re.findall(r"^#include <([a-z_]+)>", "".join(files.values()), re.M)))
    standard.remove("execution")  # another library, which may be missing
    begun = {place for file, text in files.items() if (place := first_include(file, text))}
    checked = [h for h in headers if not begun & {str(h), "/".join(h.parts[-2:])}]

    with tempfile.TemporaryDirectory() as place:
        first = pathlib.Path(place) / "standard.hpp"
        first.write_text("".join(f"#include <{name}>\n" for name in standard))
        command = [compiler, *flags, "-x", "c++-header", first, "-o", f"{first}.gch"]
        subprocess.run(command, check=True)

        def wrong(header):
            include = [f"-I{folder}" for folder in include_order(header)]
            command = [compiler, *flags, *include, "-include", first, "-fsyntax-only"]
            command += ["-x", "c++", "-"]
            text = f'#include "{ROOT / header}"\n'
            done = subprocess.run(command, input=text, capture_output=True, text=True)
            return f"{header} does not compile alone:\n{done.stderr}" if done.returncode else ""

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
            found = [text for text in workers.map(wrong, checked) if text]
    print("\n".join(found) or f"{len(headers)} headers compile alone; {len(checked)} were tried")
    return bool(found) or len(headers) < 100


sys.exit(main())
