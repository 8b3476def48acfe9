#!/usr/bin/env python3
"""windows_learner.py ROOT: a learner at Windows, under wine. ROOT is a copy of the course with programs for Windows in
ROOT/build. Writes answers, right and wrong, and reads what the companion says about them. cmake, sh, g++ and MSYS2's
bash are those of Linux: see linux_program.cpp."""

import os
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
BUILD = ROOT / "build"
WINE = Path(__file__).resolve().parent / "wine.sh"
STUB = ROOT / "exercises/03_sphere/rt/quadratic.hpp"
ANSWER = (ROOT / "solutions/03_sphere/rt/quadratic.hpp").read_text()
SHIPPED = STUB.read_text()
BEGIN = "roots_from_discriminant(Real a, Real b, Real c, Real discriminant) {\n"


class Learner(unittest.TestCase):
    def tearDown(self):
        STUB.write_text(SHIPPED)

    def course(self, *words, code=None):
        """What the companion prints."""
        done = subprocess.run([WINE, BUILD / "bin/course.exe", *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, timeout=1800, cwd=ROOT)
        said = done.stdout.decode()
        print(f"--- {' '.join(words)}: {done.returncode}\n{said}", flush=True)
        if code is not None:
            self.assertEqual(done.returncode, code, said)
        return said

    def check(self, text, *expected, code):
        """What `check 03.1` says of this file."""
        STUB.write_bytes(text.encode())
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

    def test_2_lines_of_windows(self):
        self.check(SHIPPED.replace("\n", "\r\n"), "to be written", code=3)
        self.check(ANSWER.replace("\n", "\r\n"), "03.1", "done", code=0)

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
        self.crash("    std::optional<Roots> none;\n    return *none;", "the value of an empty std::optional")

    def test_7_endless(self):
        self.crash("    for (volatile int i = 0;;) i = i + 1;", "without finishing")

    def test_8_watch(self):
        watch = subprocess.Popen([WINE, BUILD / "bin/course.exe", "watch", "03"], stdin=subprocess.PIPE,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=ROOT)
        os.set_blocking(watch.stdout.fileno(), False)
        said = ""

        def wait_for(words):
            nonlocal said
            end = time.monotonic() + 600  # other programs may use the machine, too
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
        self.course("own", "new", f"{own}", code=0)
        self.assertTrue((own / "scenes").is_dir())
        for file in (ROOT / "solutions/09_own").iterdir():
            shutil.copy(file, own)
        for step in ("1", "3", "6"):
            self.course("own", "judge", f"{own}", "--step", step, "--seed", "1", code=0)
        for part in ("hard", "broken"):
            self.course("own", "judge", f"{own}", "--part", part, "--seed", "1", code=0)

    def picture(self, name):
        """Takes a picture away that an earlier command drew, so that the next command must draw it."""
        file = ROOT / "out" / name
        file.unlink(missing_ok=True)
        return file

    def test_pictures(self):
        drawn, compared = self.picture("03_sphere_mine.png"), self.picture("03_sphere_compare.png")
        STUB.write_text(ANSWER)
        self.course("check", "03.1", code=0)
        self.assertIn("Yours: 03.1.", self.course("run", "03", "--width", "96", "--height", "54", code=0))
        self.assertTrue(drawn.exists())
        self.assertIn("same", self.course("compare", "03", code=0))
        self.assertTrue(compared.exists())

    def test_tracer(self):
        drawn = self.picture("tracer.png")
        self.course("tracer", "--from", "03", code=0)
        self.course("tracer", "--graft", "03", "--seed", "1", code=0)
        self.assertTrue(drawn.exists())

    def test_words(self):
        self.assertIn("03.1", self.course("hint", "03.1", code=0))
        self.course("ask", "03", "--answer", "1")
        self.course("certify", code=3)
        self.assertTrue((ROOT / "out/certificate.html").exists())
        STUB.write_text(ANSWER)
        self.course("reset", "03.1", code=0)
        self.assertEqual(STUB.read_text(), SHIPPED)

    def test_long_name(self):
        folder = BUILD / "/".join(["a name of forty letters, é ü 李, and more"] * 6)
        folder.mkdir(parents=True, exist_ok=True)
        picture = folder / "sphere.png"
        done = subprocess.run([WINE, BUILD / "bin/03_sphere_solution.exe", "--width", "8", "--height", "8", "--out", picture],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, 0, done.stdout.decode())
        self.assertGreater(len(str(picture)), 260)
        self.assertTrue(picture.exists())

    def course_cmd(self, words, **variables):
        """What course.cmd does in a course whose script prints its words."""
        folder = BUILD / "cmd"
        folder.mkdir(exist_ok=True)
        shutil.copy(ROOT / "course.cmd", folder)
        (folder / "course").write_text("#!/bin/sh\nprintf '[%s]' \"$MSYSTEM\" \"$@\"\nexit 3\n")
        (folder / "course").chmod(0o755)
        return subprocess.run([WINE, "cmd", "/c", "course.cmd", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              cwd=folder, env=os.environ | variables)

    def test_course_cmd(self):
        missing = self.course_cmd(["list"])
        self.assertEqual(missing.returncode, 1)
        self.assertIn("MSYS2 is missing", missing.stderr.decode())
        self.assertEqual(missing.stderr.count(b"\n"), 1)
        drive_c = Path(subprocess.check_output([WINE, "--boot"]).decode().splitlines()[-1])
        for place, variables in ((BUILD / "msys 64", {"MSYS2": f"Z:{BUILD}/msys 64"}), (drive_c / "msys64", {})):
            (place / "usr/bin").mkdir(parents=True, exist_ok=True)
            shutil.copy(BUILD / "tools/bash.exe", place / "usr/bin")
            done = self.course_cmd(["check", "01.1", "a b", "José"], **variables)
            shutil.rmtree(place)
            self.assertEqual(done.stdout.decode(), "[UCRT64][check][01.1][a b][José]")
            self.assertEqual(done.returncode, 3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
