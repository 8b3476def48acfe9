#!/usr/bin/env python3
"""windows_learner.py ROOT BUILD: a learner at Windows, under wine. ROOT is a copy of the course, BUILD its programs for
Windows. Writes answers, right and wrong, and reads what the companion says about them. cmake, sh and g++ are those of
Linux: see linux_program.cpp."""

import os
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

ROOT, BUILD = (Path(path).resolve() for path in sys.argv[1:3])
WINE = Path(__file__).resolve().parent / "wine.sh"
TOOLS = BUILD / "tools"
STUB = ROOT / "exercises/03_sphere/rt/quadratic.hpp"
ANSWER = (ROOT / "solutions/03_sphere/rt/quadratic.hpp").read_text()
SHIPPED = STUB.read_text()
BEGIN = "roots_from_discriminant(Real a, Real b, Real c, Real discriminant) {\n"


def prepare():
    """Programs that the companion calls by their names."""
    TOOLS.mkdir(exist_ok=True)
    for name in ("cmake", "sh", "g++"):
        shutil.copy(BUILD / "bin/linux_program.exe", TOOLS / f"{name}.exe")
    os.environ["WINEPATH"] = f"Z:{TOOLS}"
    # As a learner's build names the compiler.
    commands = BUILD / "compile_commands.json"
    text = commands.read_text()
    commands.write_text(text.replace("/usr/bin/x86_64-w64-mingw32-g++-posix", "g++"))


class Learner(unittest.TestCase):
    def tearDown(self):
        STUB.write_text(SHIPPED)

    def course(self, *words, code=None):
        """What the companion prints."""
        done = subprocess.run([WINE, BUILD / "bin/course.exe", *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, timeout=600, cwd=ROOT)
        said = done.stdout.decode()
        print(f"--- {' '.join(words)}: {done.returncode}\n{said}", flush=True)
        if code is not None:
            self.assertEqual(done.returncode, code, said)
        return said

    def check(self, text, *expected, code):
        """What `check 03.1` says of this file."""
        STUB.write_text(text)
        said = self.course("check", "03.1", code=code)
        for part in expected:
            self.assertIn(part, said)

    def crash(self, line, *expected):
        """Of an answer that begins with this line."""
        self.assertIn(BEGIN, ANSWER)
        self.check(ANSWER.replace(BEGIN, BEGIN + line + "\n", 1), *expected, code=1)

    def test_1_stub(self):
        self.course("list", code=0)
        self.check(SHIPPED, "to be written", code=3)

    def test_2_right(self):
        self.check(ANSWER, "03.1", "done", code=0)

    def test_3_wrong(self):
        self.check(ANSWER.replace(", b)) / 2;", ", b));"),
            "failing", "the 2 in the denominator is forgotten", code=1)

    def test_4_star(self):
        self.check(ANSWER.replace("a == 0 ? one : q / a", "q / a"), "star", code=0)

    def test_5_does_not_compile(self):
        self.check(ANSWER.replace("return {};", "return {}", 1), "exercises/03_sphere/rt/quadratic.hpp:", "expected", code=1)

    def test_6_crashes(self):
        self.crash("    Real* volatile p = nullptr;\n    *p = a;", "null pointer")
        self.crash("    volatile int zero = 0;\n    if (7 / zero) return {};", "divided an integer by 0")
        self.crash("    volatile bool again = true;\n    if (again) return roots_from_discriminant(a + 1, b, c, discriminant);",
                   "stack overflowed")
        self.crash("    std::optional<Roots> none;\n    return *none;", "aborted")

    def test_7_endless(self):
        self.crash("    for (volatile int i = 0;;) i = i + 1;", "without finishing")

    def test_8_watch(self):
        watch = subprocess.Popen([WINE, BUILD / "bin/course.exe", "watch", "03"], stdin=subprocess.PIPE,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=ROOT)
        os.set_blocking(watch.stdout.fileno(), False)
        said = ""

        def wait_for(words):
            nonlocal said
            end = time.monotonic() + 120
            while words not in said:
                self.assertLess(time.monotonic(), end, f"expected '{words}', actual:\n{said}")
                said += (watch.stdout.read() or b"").decode()
                time.sleep(0.1)
            said = ""

        wait_for("save a file to check it")
        STUB.write_text(ANSWER.replace("discriminant >= 0", "discriminant > 0"))
        wait_for("failing")
        STUB.write_text(ANSWER)
        wait_for("done")
        watch.kill()
        watch.wait()
        watch.stdout.close()
        watch.stdin.close()

    def test_9_own_judge(self):
        own = BUILD / "own"
        shutil.rmtree(own, ignore_errors=True)
        shutil.copytree(BUILD / "own_start", own)
        for file in (ROOT / "solutions/09_own").iterdir():
            shutil.copy(file, own)
        for rung in ("1", "3", "6"):
            self.course("own", "judge", f"{own}", "--rung", rung, "--seed", "1", code=0)
        for part in ("hard", "broken"):
            self.course("own", "judge", f"{own}", "--part", part, "--seed", "1", code=0)


if __name__ == "__main__":
    prepare()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
