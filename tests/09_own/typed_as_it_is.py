#!/usr/bin/env python3
"""typed_as_it_is.py ROOT CXX: what chapter 09's plan says one may type as it is compiles and reads a scene.

Its generator is that of tests/plain/09_own/main.cpp.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

ROOT, CXX = pathlib.Path(sys.argv[1]), sys.argv[2]

plan = re.search(r"\n## A plan\n.*?\n## ", (ROOT / "docs/09-own.md").read_text(), re.S)[0]
generator, reader = (textwrap.dedent(block) for block in re.findall(r" *```cpp\n(.*?) *```\n", plan, re.S))
plain = (ROOT / "tests/plain/09_own/main.cpp").read_text()
for line in generator.splitlines():
    if line not in plain.splitlines():
        sys.exit(f"tests/plain/09_own/main.cpp does not have this line of the text: {line}")

headers = "".join(f"#include <{name}>\n" for name in re.findall(r"`<(\w+)>`", plan))
vector = re.search(r"struct Vec \{.*?\};\n", (ROOT / "solutions/00_toolchain/first.cpp").read_text(), re.S)[0]
said = """
    std::cout << files[1] << ' ' << seed << ' ' << width << ' ' << height << ' ' << samples << ' ' << depth
              << ' ' << below.y << ' ' << above.x << ' ' << (Random(seed, 1, 2).uniform() < 1) << '\\n';
}
"""
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "own.cpp").write_text(headers + vector + generator + reader.rstrip().removesuffix("}") + said)
    subprocess.run([CXX, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-o", folder / "own", folder / "own.cpp"],
                   check=True)
    (folder / "scene.txt").write_text("# a sky\n\n  picture 8 6 4 2 # small\nsky 1 0.9 1  0.25 1 1\n")
    words = ["--threads", "3", folder / "scene.txt", "--list", "a.ppm", "--seed", "7"]
    printed = subprocess.run([folder / "own", *words], check=True, capture_output=True, text=True).stdout
if printed != "a.ppm 7 8 6 4 2 0.9 0.25 1\n":
    sys.exit(f"these lines read {printed}")
