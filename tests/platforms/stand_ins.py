#!/usr/bin/env python3
"""stand_ins.py BUILD: what the companion needs in a build for Windows that was made on Linux. BUILD/tools gets the
programs that it calls by their names; they are those of Linux: see linux_program.cpp. compile_commands.json is written
as CMake writes it on Windows, where backslashes stand in names."""

import json
import re
import shutil
import sys
from pathlib import Path

BUILD = Path(sys.argv[1])
TOOLS = BUILD / "tools"
TOOLS.mkdir(exist_ok=True)
for name in ("cmake", "sh", "g++", "x86_64-w64-mingw32-g++-posix", "bash"):
    shutil.copy(BUILD / "bin/linux_program.exe", TOOLS / f"{name}.exe")

COMPILER = re.compile(r"^(\S*ccache )?\S+-g\+\+-posix")
FILES = re.compile(r" -o .* -c .*$")
commands = json.loads((BUILD / "compile_commands.json").read_text())
for one in commands:
    line = COMPILER.sub("g++", one["command"])
    one["command"] = FILES.sub(lambda match: match.group().replace("/", "\\"), line)
(BUILD / "compile_commands.json").write_text(json.dumps(commands, indent=0, ensure_ascii=False))
