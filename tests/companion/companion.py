#!/usr/bin/env python3
"""companion.py COURSE SCRIPT: tries the companion's commands as a learner does, on a course of two
exercises whose checkpoints are shell scripts. On a terminal too, a pseudo one."""

import json
import os
import pty
import re
import select
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest
import zlib
from pathlib import Path

COURSE, SCRIPT = sys.argv[1], sys.argv[2]
DECLARED = Path(SCRIPT).parent / "companion/commands/commands.inc"

CHECK = r"""#!/bin/sh
# check.sh ID FILE: stands in for compiler and checkpoint. The words in FILE say how it goes.
id=$1 file=$2
say() { printf '%s\n' "$*"; }  # echo would turn \n into the end of a line
event() { say "printf '%s\n' \"\$COURSE_EVENTS \"'$*' >&3"; }
if grep -q 'syntax error' "$file"; then
    echo "FAILED: $id.o"
    echo "$file:3:5: error: expected ';'"
    echo "    3 | syntax error"
    exit 1
fi
if grep -q warned "$file" && [ ! -f ../compiled ]; then
    echo "$file:3:5: warning: no return [-Wreturn-type]"
fi
mkdir -p check
{
    echo '#!/bin/sh'
    cases='{"name":"'"$id"' the answer is right"}'
    for name in $(sed -n 's/^star \([a-z]*\) .*/\1/p' "$file"); do
        cases=$cases',{"name":"'"${id%.float} star $name"'","hard":true}'
    done
    ! grep -q '^one less' "$file" || cases=$cases',{"name":"another","hard":false}'
    ! grep -q '^at once' "$file" || echo 'exit 0'
    event '{"event":"cases","cases":['"$cases"']}'
    say 'case $3 in "[hard]"*) ;; *)'
    event '{"event":"begins","name":"'"$id"' the answer is right"}'
    failed='{"event":"ends","passed":false,"output":""}'
    narrow=no
    case $id in *.float) grep -q 'not in float' "$file" && narrow=yes ;; esac
    counts=$(sed -n 's/^counts //p' "$file")
    if grep -q wrong "$file" || [ $narrow = yes ]; then
        event '{"event":"failed","macro":"CHECK","expression":"a == b","expanded":"3 == 2",' \
            '"messages":[{"text":"expected 2, but yours gives 3.\nHint: count once more","expected":"2"},' \
            '{"text":"","counts":"'"$counts"'"}]}'
        event "$failed"
    elif grep -q 'needs 01.2' "$file"; then
        event '{"event":"failed","exception":"there","missing":"01.2","messages":[]}'
        event "$failed"
    elif grep -q 'needs 01.1' "$file"; then
        event '{"event":"failed","exception":"there","missing":"01.1",' \
            '"messages":[{"text":"Hint: is it the function that was declared?"}]}'
        event "$failed"
    elif grep -q '^endless\|^computes\|^crash\|, then crash\|chatter' "$file"; then
        :
    elif grep -q '^leaves' "$file"; then
        say 'exit 0'
    else
        event '{"event":"ends","passed":true,"output":""}'
    fi
    say ';; esac'
    # The hard cases, where the file speaks of stars: "star one open", "star two open in float", "star
    # one crash". $3 may ask for the core alone, or for these but for those that it names.
    say '[ "$3" != "~[hard]" ] || exit 0'
    for name in $(sed -n 's/^star \([a-z]*\) .*/\1/p' "$file"); do
        say 'case $3 in *"star '"$name"'"*) ;; *)'
        event '{"event":"begins","name":"'"${id%.float} star $name"'","hard":true}'
        if grep -q "star $name crash" "$file"; then
            say 'kill -SEGV $$ ;; esac'
            continue
        fi
        if grep -q "star $name leaves" "$file"; then
            say 'exit 0 ;; esac'
            continue
        fi
        if grep -q "star $name computes" "$file"; then
            event '{"event":"computes","seconds":3}'
            say 'kill -TERM $$ ;; esac'
            continue
        fi
        if grep -q "star $name endless" "$file"; then
            say 'exec sleep 60 ;; esac'
            continue
        fi
        if grep -q "star $name awaits 01.2" "$file"; then
            event '{"event":"failed","exception":"01.2 is still to be written","missing":"01.2","messages":[]}'
            event '{"event":"ends","passed":false,"output":""}'
            say ';; esac'
            continue
        fi
        passed=true
        ! grep -q "star $name open$" "$file" || passed=false
        case $id in *.float) ! grep -q "star $name open in float$" "$file" || passed=false ;; esac
        [ $passed = true ] ||
            event '{"event":"failed","macro":"CHECK","expression":"c == d","expanded":"8 == 7",' \
                '"messages":[{"text":"expected 7, but yours gives 8","expected":"7"}]}'
        event '{"event":"ends","passed":'$passed',"output":""}'
        say ';; esac'
    done
    grep -q chatter "$file" && echo 'yes without end'
    grep -q '^crash\|, then crash' "$file" && echo 'kill -SEGV $$'
    grep -q '^computes' "$file" && event '{"event":"computes","seconds":3}' && echo 'kill -TERM $$'
    grep -q '^endless' "$file" && echo 'sleep 60'
    grep -q 'wrong\|awaits' "$file" && echo 'exit 1'
    [ $narrow = no ] || echo 'exit 1'
    echo 'exit 0'
} >check/check.$id.$$
chmod +x check/check.$id.$$
mv check/check.$id.$$ check/check.$id  # another process may run it
"""

STUB = '#pragma once\n// Exercise 01.%d.\ninline int f() {\n    return rt::todo("01.%d");\n}\n'


class Companion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="course test ")
        self.root = Path(self.folder.name)
        self.facts = []
        hints = "# Hints\n"
        cmake = "cmake_minimum_required(VERSION 3.22)\nproject(tiny NONE)\n"
        for number, name in ((1, "one"), (2, "two")):
            self.facts.append({"id": f"01.{number}", "title": f"Number {name}", "minutes": 10 * number, "star_minutes": 5,
                               "files": [f"rt/{name}.hpp"]})
            hints += f"\n## 01.{number}\n\n1. idea\n2. formula √x in `code`\n3. shape\n"
            self.write(name, STUB % (number, number))
            self.put(f"solutions/01_tiny/rt/{name}.hpp", f"// solution {number}\n")
            for target in (f"01.{number}", f"01.{number}.float"):
                cmake += self.answer(target, f"01_tiny/rt/{name}.hpp")
        programs = [f"01_tiny_{kind}{study}" for kind in ("mine", "solution")
                    for study in ("", "_study", "_float_study")]
        for program in [*programs, "01_tiny_follow", "09_own_solution"]:
            cmake += self.program(program)
        cmake += "add_custom_target(own_start)\n"
        for target in ("02.1", "02.1.float"):
            cmake += self.answer(target, "02_more/rt/three.hpp")
        self.put_course(self.chapter("01_tiny", self.facts))
        self.put("docs/hints/01-tiny.md", hints)
        self.put("CMakeLists.txt", cmake)
        self.put("check.sh", CHECK)
        self.put("program.sh", '#!/bin/sh\n[ "$1" != --describe ] || { echo "{}"; exit; }\n'
                 '[ "$1" != --quiet ] || { printf "P3 1 1 255 0 0 0" >"$3"; exit; }\necho "program $*"\n'
                 '[ "$1" != --study ] || echo study,variant,precision,x,x_name,error,error_name,cost,cost_name '
                 '>"$2/01_tiny.csv"\n[ "$3" != --fail ] || exit 3\n'
                 '[ "$3" != --crash ] || kill -SEGV $$\n'
                 '[ "$3" != --long ] || { trap \'echo a part >"$2"; kill %1; exit 130\' INT; sleep 60 & '
                 'echo x >"${2%/*}/started"; wait; }\n'
                 '[ "$3" != --longer ] || { echo x >"${2%/*}/started"; exec sleep 60; }\n')
        os.chmod(self.root / "program.sh", 0o755)
        self.configure()
        self.put("build/bin/course", f'#!/bin/sh\nexec "{COURSE}" "$@"\n')
        os.chmod(self.root / "build/bin/course", 0o755)
        self.environment = {**os.environ, "COURSE_TEST_FOLDER": str(self.root), "TERM": "xterm"}
        for name in ("NO_COLOR", "COURSE_CMAKE_ARGS"):
            self.environment.pop(name, None)

    @staticmethod
    def program(name):
        return (f"add_custom_target({name} COMMAND ${{CMAKE_COMMAND}} -E make_directory bin "
                f"COMMAND ${{CMAKE_COMMAND}} -E copy ${{CMAKE_SOURCE_DIR}}/program.sh bin/{name} VERBATIM)\n")

    @staticmethod
    def answer(target, file):
        return (f"add_custom_target(check.{target})\nadd_custom_target(yours.{target} COMMAND sh "
                f"${{CMAKE_SOURCE_DIR}}/check.sh {target} ${{CMAKE_SOURCE_DIR}}/exercises/{file} VERBATIM)\n")

    def configure(self):
        ninja = ["-G", "Ninja"] if shutil.which("ninja") else []  # as `course` does; it takes half of make's time
        subprocess.run(["cmake", *ninja, "-S", self.root, "-B", self.root / "build"], check=True,
                       stdout=subprocess.DEVNULL)

    def chapter(self, name, facts):
        return {"name": name, "core": True, "uses_real": True, "title": "Tiny", "reading": 30,
                "text": f"docs/{name.replace('_', '-')}.md",
                "hints": f"docs/hints/{name.replace('_', '-')}.md", "caption": "Nothing", "exercises": facts}

    def put_course(self, *chapters):
        self.put("course.json", json.dumps({"chapters": chapters}))
        self.put("docs/studies/captions.json", json.dumps({"axes": {}, "studies": {}}))

    def add_second_chapter(self):
        stub = (STUB % (1, 1)).replace("01.1", "02.1")
        self.put("exercises/02_more/rt/three.hpp", stub)
        self.put_course(self.chapter("01_tiny", self.facts), self.chapter("02_more", [
            {"id": "02.1", "title": "Number three", "minutes": 10, "files": ["rt/three.hpp"]}]))

    def add_elective(self):
        self.add_second_chapter()
        facts = json.loads((self.root / "course.json").read_text())["chapters"]
        facts[1]["core"] = False
        self.put_course(*facts)

    def tearDown(self):
        if self.is_ahead():  # begun by a test on a terminal, which has closed
            subprocess.run([COURSE, "prepare", "--end"], env=self.environment, check=False)
        self.folder.cleanup()

    def put(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def stub(self, name):
        return self.root / "exercises/01_tiny/rt" / f"{name}.hpp"

    def write(self, name, text):
        self.put(f"exercises/01_tiny/rt/{name}.hpp", text)

    def course(self, *words, code=0, stdin=subprocess.DEVNULL):
        done = subprocess.run([COURSE, *words], env=self.environment, stdin=stdin, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertNotIn("\033", done.stdout + done.stderr)  # not a terminal
        return done.stdout if code != 2 else done.stderr

    # ---- an elective --------------------------------------------------------------------------

    def test_an_elective_is_listed_and_counts_for_nothing(self):
        before = self.course("list").split("\n\n")[1]
        self.add_elective()
        said = self.course("list")
        self.assertIn("02_more          [..........] 0 of 1, elective, 0.7 hours; stars: 0.0 hours\n", said)
        self.assertEqual(said.split("\n\n")[1], before)
        self.put("exercises/02_more/rt/three.hpp", "right\n")
        self.course("check", "02")
        said = self.course("list")
        self.assertRegex(said, r"\+ 02.1 .* done\n")
        self.assertEqual(said.split("\n\n")[1],
                         before + "\nBeyond the course: 1 of 1 exercises in electives")

    def test_an_elective_is_offered_after_the_core_alone(self):
        self.add_elective()
        self.write("two", "right\n")
        said = self.course("check", "01.2")
        self.assertIn("Next: 01.1 Number one", said)
        self.assertNotIn("elective", said)
        self.write("one", "right\n")
        said = self.course("check")
        self.assertIn("Every exercise of the core passes. The last step: ./course certify\n"
                      "Beyond the course, an elective: 02 Tiny, about 40 minutes\n"
                      "  read   docs/02-more.md\n  check  ./course watch 02\n", said)
        # Who has begun it stays in it.
        self.assertIn("Next: 02.1", self.course("check", "02", code=3))
        self.put("exercises/02_more/rt/three.hpp", "right\n")
        self.assertIn("Every exercise passes. The last step", self.course("check", "02"))
        self.assertNotIn("Beyond the course, an elective", self.course())

    def test_next_stays_in_the_chapter_one_is_in(self):
        self.add_elective()
        course = json.loads((self.root / "course.json").read_text())
        course["chapters"][1]["exercises"].append({**self.facts[0], "id": "02.2", "title": "Number four"})
        self.put_course(*course["chapters"])
        for name in ("one", "two"):
            self.put(f"exercises/02_more/rt/{name}.hpp", (STUB % (1, 1)).replace("01.1", "02.2"))
        self.put("exercises/02_more/rt/three.hpp", "right\n")
        self.assertIn("\nNext: 02.2 Number four", self.course("check", "02.1"))
        self.assertIn("\nNext: 02.2 Number four", self.course("check", "02", code=3))
        said = self.course("list", "02")
        self.assertTrue(said.startswith("02_more          [#####.....] 1 of 2, elective"), said)
        self.assertNotIn("01_tiny", said)
        self.assertIn("\nNext: 02.2 Number four", said)
        self.assertIn("\nNext: 01.1", self.course("list", "01"))

    def test_it_says_once_that_one_may_begin_anywhere(self):
        self.assertIn("You may begin at any chapter", self.course())
        self.write("one", "right\n")
        self.course("check", "01.1")
        self.assertNotIn("You may begin", self.course())

    def test_watch_goes_on_to_no_elective(self):
        self.add_elective()
        self.write("one", "right\n")
        self.write("two", "right\n")
        self.assertIn("Every exercise of the core passes", self.course("watch"))
        self.assertIn("Next: 02.1", self.course("watch", "02", code=3))

    # ---- a program of one's own --------------------------------------------------------------

    def add_own_chapter(self):
        self.put_course(self.chapter("01_tiny", self.facts), {
            "name": "09_own", "core": True, "title": "Your own", "reading": 5, "minutes": 60,
            "text": "docs/09-own.md", "caption": "A picture.", "scene": "own_start/one.txt"})
        self.put("build/own_start/TASK.md", "# Your own\n")
        self.put("build/own_start/main.cpp", "")
        self.put("build/own_start/build.sh", "false\n")
        # Both programs draw one black pixel, whatever the scene.
        self.put("program.sh", "#!/bin/sh\nprintf 'P3 1 1 255 0 0 0' >$2\n")

    def test_own_new_makes_a_folder_once(self):
        self.add_own_chapter()
        folder = self.root / "my tracer"
        self.assertIn("Read TASK.md", self.course("own", "new", str(folder)))
        self.assertEqual(sorted(f.name for f in folder.iterdir()), ["TASK.md", "build.sh", "main.cpp"])
        self.put("my tracer/main.cpp", "mine\n")
        self.assertIn("not empty", self.course("own", "new", str(folder), code=2))
        self.assertEqual((folder / "main.cpp").read_text(), "mine\n")
        (self.root / "empty").mkdir()
        self.course("own", "new", str(self.root / "empty"))
        self.course("own", code=2)
        for words in (["--step", "11"], ["--step", "0"], ["--step", "-1"], ["--seed", "-1"], ["--seed", "x"]):
            self.assertEqual(self.course("own", "judge", str(folder), *words, code=2).count("\n"), 1)
        self.assertIn("step1, step2", self.course("own", "judge", str(folder), "--part", "x", code=2))
        self.assertIn("own judge", self.course("check", "09", code=2))

    def test_own_judge_says_in_one_line_why_there_is_no_program(self):
        self.add_own_chapter()
        folder = self.root / "tracer"
        self.assertIn("x build.sh\n    there is no folder", self.course("own", "judge", str(folder), code=1))
        self.course("own", "new", str(folder))
        said = self.course("own", "judge", str(folder), "--step", "1", code=1)
        self.assertIn("x build.sh\n    build.sh: exit code 1", said)
        self.assertIn("0 of 1 lines pass", said)

    def test_own_verdict_is_kept_until_the_sources_change(self):
        self.add_own_chapter()
        folder = self.root / "tracer"
        self.course("own", "new", str(folder))
        self.assertIn("09_own           [..........] not judged yet, 1.0 hours\n", self.course())
        self.put("tracer/build.sh", "cp '%s' own && chmod +x own\n" % (self.root / "program.sh"))
        said = self.course("own", "judge", str(folder), "--step", "1", "--seed", "5")
        self.assertIn("+ step 1: a sky and nothing else\n", said)
        self.assertIn("Next: ./course own judge %s --step 2" % folder, said)
        self.assertIn("--seed 5", said)
        self.assertIn("not judged yet", self.course())  # a part of the verdict is none
        said = self.course("own", "judge", str(folder), code=1)
        self.assertRegex(said, r"(\d+ of \d+ lines) pass")
        lines = re.search(r"(\d+ of \d+ lines) pass", said)[1]
        self.assertIn("x step 3: --seed\n    two different seeds give the same bytes", said)
        # What it looked at is kept until the next verdict.
        again = '"%s/own" out/judge/step_3_seed/scene.txt out/judge/step_3_seed/again.ppm --seed 2' % folder
        self.assertIn("    Draw it again:     %s\n" % again, said)
        self.assertIn("picture ", (self.root / "out/judge/step_3_seed/scene.txt").read_text())
        self.course("own", "judge", str(folder), "--step", "1")
        self.assertFalse((self.root / "out/judge").exists())
        self.assertIn("09_own           [", self.course())
        self.assertIn("] %s pass, 1.0 hours" % lines, self.course())
        self.put("tracer/main.cpp", "changed\n")
        self.assertIn("changed since it was judged", self.course())

    def test_own_judge_leaves_nothing_behind(self):
        self.add_own_chapter()
        scratch = self.root / "scratch"
        scratch.mkdir()
        self.environment["TMPDIR"] = str(scratch)
        self.course("own", "judge", str(self.root / "missing"), code=1)
        self.course("own", "judge", "/", code=1)
        folder = self.root / "tracer"
        self.course("own", "new", str(folder))
        self.put("tracer/build.sh", "echo x >../started; sleep 60\n")
        process = subprocess.Popen([COURSE, "own", "judge", str(folder)], env=self.environment,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait_for(lambda: (self.root / "started").exists() or any(scratch.rglob("started")))
        self.assertTrue(any(scratch.iterdir()))
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(20), -signal.SIGINT)
        self.wait_for(lambda: not any(scratch.iterdir()))

    def wait_for(self, what):
        for _ in range(400):
            if what():
                return
            time.sleep(0.05)
        self.fail("it does not come")

    def test_certify_believes_no_record_of_the_own_program(self):
        self.add_own_chapter()
        folder = self.root / "tracer"
        self.course("own", "new", str(folder))
        self.put("tracer/build.sh", "cp '%s' own && chmod +x own\n" % (self.root / "program.sh"))
        self.course("own", "judge", str(folder), code=1)
        state = self.root / ".course/state.json"
        record = json.loads(state.read_text())
        self.assertFalse(record["own"]["core"])
        record["own"].update(core=True, passed=record["own"]["lines"])
        state.write_text(json.dumps(record))
        self.assertIn("your own ray tracer passes", self.course())
        said = self.course("certify", code=3)
        self.assertIn("x step 3: --seed\n", said)
        self.assertFalse(json.loads(state.read_text())["own"]["core"])
        for name in ("", "gone"):
            record["own"].update(hash="", folder=str(self.root / name))
            state.write_text(json.dumps(record))
            said = self.course("certify", code=3)
            self.assertNotIn("step", said.replace("steps", ""))
            self.assertIn("not judged yet", said)

    def test_certify_checks_an_elective_in_float_too(self):
        self.add_elective()
        self.put("exercises/02_more/rt/three.hpp", "right, but not in float\n")
        self.assertIn("0 of 1 exercises pass", self.course("certify", code=3))
        state = json.loads((self.root / ".course/state.json").read_text())
        self.assertFalse(state["exercises"]["02.1"]["passed"])
        self.put("exercises/02_more/rt/three.hpp", "right\n")
        self.assertIn("1 of 1 exercises pass", self.course("certify", code=3))

    def test_own_chapter_comes_after_the_exercises(self):
        self.add_own_chapter()
        self.write("one", "right\n")
        self.write("two", "right\n")
        self.assertIn("Every exercise passes. Next: 09 Your own, about 60 minutes\n  read   docs/09-own.md\n"
                      "  begin  ./course own new FOLDER\n", self.course("check"))
        folder = self.root / "tracer"
        self.course("own", "new", str(folder))
        self.assertIn("  check  ./course own judge %s\n" % folder, self.course())

    # ---- list and check ----------------------------------------------------------------------

    def test_list_says_where_things_stand(self):
        said = self.course()
        self.assertIn("0 of 2 exercises, 1.0 hours of 1.0 hours left; stars: 0.2 hours", said)
        self.assertIn("Next: 01.1 Number one, about 10 minutes (its stars: 5 more)", said)
        self.assertEqual([path.name for path in (self.root / ".course").iterdir()], ["stubs"])
        self.write("one", "right\n")
        self.assertRegex(self.course("list"), r"\? 01.1 .* not checked since it changed")
        self.course("check", "01.1")
        said = self.course("list")
        self.assertRegex(said, r"\+ 01.1 .* done")
        self.assertIn("1 of 2 exercises, 0.7 hours of 1.0 hours left", said)
        self.assertIn("Next: 01.2", said)
        self.write("one", "right, but touched\n")
        self.assertRegex(self.course("list"), r"\? 01.1 .* not checked since it changed")

    def test_check_an_exercise_that_is_to_be_written(self):
        self.assertRegex(self.course("check", "01", code=3), r"\. 01.1 .* to be written")
        self.assertFalse((self.root / "build/check").exists())  # nothing was built
        self.assertIn("Nothing is written yet", self.course("check", code=3))

    def test_check_a_wrong_answer(self):
        self.write("one", "wrong\n")
        self.write("two", "right\n")
        said = self.course("check", code=1)
        self.assertRegex(said, r"x 01.1 .* failing: 1 of 1 test case")
        self.assertRegex(said, r"\+ 01.2 .* done")
        for part in ("expected 2, but yours gives 3.", "Hint: count once more",
                     "checked: CHECK( a == b )", "actual: 3 == 2",
                     "docs/01-tiny.md, section 01.1", "./course hint 01.1"):
            self.assertIn(part, said)
        self.assertRegex(self.course("list"), r"x 01.1 .* failing")

    def test_check_in_float_too(self):
        self.write("one", "right, but not in float\n")
        said = self.course("check", "01.1", code=1)
        self.assertRegex(said, r"\+ 01.1 .* done\n.*x 01.1 .* failing in float: 1 of 1 test case")
        self.assertIn("It passes in double and fails in float", said)
        self.assertRegex(self.course("list"), r"x 01.1 .* failing")
        self.write("one", "right\n")
        self.assertNotIn("float", self.course("check", "01.1"))

    def test_core_and_stars(self):
        self.write("one", "star one open\nstar two right\nstar three open\n")
        said = self.course("check", "01.1")
        self.assertRegex(said, r"^01_tiny\n  \* 01.1 .* core passes, 2 stars open \(--stars shows them\)\n\nNext: 01.2")
        said = self.course("check", "01.1", "--stars")
        self.assertRegex(said, r"\* 01.1 .* core passes, 2 stars open\n")
        self.assertIn("Star: 01.1 star one\n    expected 7, but yours gives 8\n", said)
        self.assertIn("Star: 01.1 star three\n", said)
        said = self.course("list")
        self.assertIn("01_tiny          [#####.....] 1 of 2, 1.0 hours; stars: 1 of 3 checked, 0.2 hours\n", said)
        self.assertRegex(said, r"\* 01.1 .* core passes, 2 stars open\n")
        self.assertIn("Next: 01.2", said)
        self.write("two", "right\n")
        said = self.course("check", "1")
        self.assertNotIn("Star: ", said)
        self.assertIn("Chapter 01 is done: its core passes. 2 stars open: ./course check 01 --stars",
                      said)
        self.assertEqual(self.course("check", "01", "--stars").count("Star: "), 2)
        self.write("one", "star one right\nstar two right\n")
        said = self.course("check", "1")
        self.assertIn("every checkpoint passes", said)
        self.assertIn("2 of 2, 1.0 hours; stars: 2 of 2 checked, 0.2 hours\n", self.course("list"))

    def test_the_core_comes_before_the_stars(self):
        self.write("one", "wrong\nstar one open\n")
        said = self.course("check", "01.1", code=1)
        self.assertRegex(said, r"x 01.1 .* failing")
        self.assertIn("expected 2, but yours gives 3.", said)

    def test_a_star_may_fail_in_float_alone(self):
        self.write("one", "star one open in float\nstar two right\n")
        said = self.course("check", "01.1")
        self.assertRegex(said, r"\+ 01.1 .* done\n    01.1  in float: 1 more star is open \(--stars shows it\)\n")
        self.assertIn("Star: 01.1 star one, in float\n", self.course("check", "01.1", "--stars"))
        self.assertRegex(self.course("list"), r"\* 01.1 .* core passes, 1 star open")

    def test_a_star_may_crash(self):
        self.write("one", "star one crash\nstar two open\nstar three right\n")
        said = self.course("check", "01.1", "--stars")
        self.assertRegex(said, r"\* 01.1 .* core passes, 2 stars open\n")
        self.assertRegex(said, "Star: 01.1 star one\n +it accessed memory that does not belong to it")
        self.assertIn("Star: 01.1 star two\n    expected 7", said)
        self.assertIn("stars: 1 of 3", self.course("list"))
        # Where the core is wrong, that is all that counts.
        self.write("one", "star one crash\nwrong\n")
        said = self.course("check", "01.1", code=1)
        self.assertIn("expected 2, but yours gives 3", said)
        self.assertNotIn("It crashes", said)

    def test_a_star_may_never_end(self):
        self.write("one", "star one right\nstar two endless\nstar three open\n")
        started = time.time()
        said = self.course("check", "01.1", "--stars")
        self.assertLess(time.time() - started, 25)  # in double and in float
        self.assertRegex(said, r"\* 01.1 .* core passes, 1 star open\n")
        self.assertIn("Star: 01.1 star two\n    it timed out after 4 s", said)

    def test_check_goes_on_in_the_chapter(self):
        self.write("two", "right\n")
        self.assertIn("Next: 01.1", self.course("check", "01.2"))
        self.write("one", "right\n")
        self.write("two", STUB % (2, 2))
        self.assertIn("Next: 01.2", self.course("check", "01.1"))

    def test_the_next_step_may_be_a_graft(self):
        chapter = self.chapter("01_tiny", self.facts)
        chapter["graft"] = {"title": "Any", "minutes": 1, "reads": "scene", "still": True, "steps": [1], "headers": ["one.hpp"]}
        self.put("course.json", json.dumps({"chapters": [chapter], "route": ["01.2", "graft 01", "01.1"]}))
        self.write("two", "right\n")
        for words, code in ((["check", "01.2"], 0), (["check", "01"], 3), (["certify"], 3), (["list"], 0)):
            self.assertIn("\nNext: graft 01, Any", self.course(*words, code=code), words)
        with self.watched("01") as terminal:
            terminal.expect("Next: .*graft 01, Any")
            terminal.expect("check  ./course tracer")
            terminal.expect("Then:")
            terminal.expect("Next: .*01.1 Number one")
            terminal.press("q")
            self.assertEqual(terminal.end(), 0)

    def test_what_fails_comes_before_what_is_new(self):
        self.write("one", "wrong\n")
        self.course("check", "01.1", code=1)
        self.write("two", "right\n")
        self.assertIn("Next: 01.1", self.course("check", "01.2"))

    def test_check_refuses_an_unknown_sanitizer(self):
        self.assertIn("takes nothing, address or thread",
                      self.course("check", "01.1", "--sanitize", "speed", code=2))
        self.assertIn("needs an exercise", self.course("check", "--sanitize", code=2))

    def test_check_does_not_compile(self):
        self.write("one", "syntax error\n")
        self.write("two", "right\n")
        said = self.course("check", "1", code=1)
        self.assertIn("\nexercises/01_tiny/rt/one.hpp:3:5: error: expected ';'\n", said)
        self.assertRegex(said, r"\+ 01.2 .* done")
        self.assertNotIn("FAILED", said)

    def test_compilers_speak_english(self):
        check = (self.root / "check.sh").read_text()
        self.put("check.sh", check.replace("#!/bin/sh\n", '#!/bin/sh\n[ "${LC_ALL-}" = C ] || exit 1\n', 1))
        self.write("one", "right, warned\n")
        self.environment.update(LANG="de_DE.UTF-8", LC_ALL="de_DE.UTF-8", LANGUAGE="de")
        self.course("check", "01.1")

    def test_check_crashes_and_waits(self):
        self.write("one", "crash\n")
        said = self.course("check", "01.1", code=1)
        self.assertIn("It crashes in the test case\n  01.1 the answer is right\n", said)
        self.assertIn("it accessed memory that does not belong to it (segmentation fault)", said)
        self.assertIn("./course check 01.1 --sanitize", said)
        self.write("one", "needs 01.2\n")
        self.assertIn("needs 01.2 first", self.course("check", "01.1", code=3))
        self.write("two", "needs 01.2\n")  # the linker took the definition that throws
        self.assertIn("the checkpoints do not call your function", self.course("check", "01.2", code=1))

    def test_check_waits_for_no_exercise_that_only_a_star_calls(self):
        self.write("one", "right\nstar one awaits 01.2\n")
        said = self.course("check", "01.1", "--stars")
        self.assertRegex(said, r"\* 01.1 .* core passes, 1 star open\n")
        self.assertIn("Star: 01.1 star one\n    it threw: 01.2 is still to be written\n", said)
        self.assertNotIn("It calls your function", said)

    def test_check_tells_of_code_that_ends_the_program(self):
        for word, where in (("leaves", " in the test case\n  01.1 the answer is right\n"), ("at once", "\n")):
            self.write("one", word + "\n")
            said = self.course("check", "01.1", code=1)
            self.assertRegex(said, r"x 01.1 .* ends the program\n")
            self.assertIn("Your code ended the program" + where + "  A function must return to its caller", said)
        # A test case that was compiled does not run.
        self.write("one", "one less\n")
        self.assertRegex(self.course("check", "01.1", code=1), r"x 01.1 .* ends the program\n")
        # It prints what the reporter writes, in place of what was compiled.
        check = (self.root / "check.sh").read_text()
        self.put("check.sh", check.replace(">&3", ""))
        self.write("one", "right\n")
        self.assertRegex(self.course("check", "01.1", code=1), r"x 01.1 .* ends the program\n")
        self.put("check.sh", check)
        self.write("one", "star one leaves\nstar two open\n")
        said = self.course("check", "01.1", "--stars")
        self.assertIn("Star: 01.1 star one\n    the code ended the program.\n", said)
        self.assertIn("core passes, 2 stars open", said)

    def test_check_stops_what_never_ends(self):
        self.write("one", "endless\n")
        self.write("two", "right\n")
        started = time.time()
        said = self.course("check", code=1)
        self.assertLess(time.time() - started, 20)
        self.assertIn("It was stopped: it timed out after 4 s in the test case\n  01.1 the answer is right\n"
                      "  Which loop or recursion never ends?", said)
        self.assertRegex(said, r"\+ 01.2 .* done")

    def test_check_tells_an_endless_loop(self):
        self.write("one", "computes\n")
        said = self.course("check", "01.1", code=1)
        self.assertIn("It was stopped: it computed for 3 s without finishing in the test case\n"
                      "  01.1 the answer is right\n  Which loop or recursion never ends?\n", said)
        self.write("one", "star one right\nstar two computes\n")
        said = self.course("check", "01.1", "--stars")
        self.assertRegex(said, r"\* 01.1 .* core passes, 1 star open\n")
        self.assertIn("Star: 01.1 star two\n    it computed for 3 s without finishing.\n", said)

    def test_check_all_right(self):
        self.write("one", "right\n")
        self.write("two", "right\n")
        said = self.course("check", "tiny")
        self.assertIn("Chapter 01 is done", said)
        self.assertIn("./course compare 01", said)

    def test_check_tells_of_a_warning_every_time(self):
        self.write("one", "wrong, warned\n")
        for _ in range(2):  # nothing is compiled the second time
            said = self.course("check", "01.1", code=1)
            self.assertIn("warned:\n    exercises/01_tiny/rt/one.hpp:3: no return\n", said)
            self.put("compiled", "")
        self.write("one", "wrong\n")
        self.assertNotIn("warned", self.course("check", "01.1", code=1))
        self.write("one", "warned\n")
        self.assertNotIn("warned", self.course("check", "01.1"))

    def test_check_tells_what_failed_before_a_crash(self):
        self.write("one", "wrong, then crash\n")
        said = self.course("check", "01.1", code=1)
        self.assertIn("it accessed memory that does not belong to it", said)
        self.assertIn("Before that, this failed:\n  01.1 the answer is right\n", said)
        self.assertIn("expected 2, but yours gives 3.", said)

    def test_check_stops_what_prints_without_end(self):
        self.write("one", "chatter\n")
        started = time.time()
        said = self.course("check", "01.1", code=1)
        self.assertLess(time.time() - started, 15)
        self.assertIn("it printed more than 16 MB", said)

    def test_check_a_file_that_is_changed_but_keeps_its_todo(self):
        self.put("build/check/nothing", "")
        self.course()
        self.write("one", STUB % (1, 1) + "int g() { return 1; }  // needs 01.1\n")
        said = self.course("check", "01.1", code=3)
        self.assertRegex(said, r"\. 01.1 .* begun")
        self.assertIn("Hint: is it the function that was declared?", said)
        self.assertRegex(self.course("list"), r"- 01.1 .* begun")
        self.write("one", STUB % (1, 1) + "int f() { return 1; }  // right\n")
        self.course("check", "01.1")
        self.assertRegex(self.course("list"), r"\+ 01.1 .* done")

    # ---- what counts is what is in the files -------------------------------------------------

    def build_by_time_stamps(self):
        """As real targets do: nothing is built where no file is newer."""
        cmake = (self.root / "CMakeLists.txt").read_text()
        object = r"${CMAKE_BINARY_DIR}/chapters/01_tiny/CMakeFiles/\1.dir/answer.o"
        cmake = re.sub(r"add_custom_target\((yours\.01\S+) (COMMAND .* (\S+)) VERBATIM\)",
                       rf"add_custom_command(OUTPUT {object} \2 COMMAND ${{CMAKE_COMMAND}} -E touch {object} "
                       rf"DEPENDS \3 VERBATIM)\nadd_custom_target(\1 DEPENDS {object})", cmake)
        for target in ("yours.01.1", "yours.01.2", "yours.01.1.float", "yours.01.2.float"):
            (self.root / f"build/chapters/01_tiny/CMakeFiles/{target}.dir").mkdir(parents=True)
        self.put("CMakeLists.txt", cmake)
        self.configure()

    def test_an_older_time_stamp_hides_no_change(self):
        self.build_by_time_stamps()
        self.write("one", "right\n")
        self.course("check", "01.1")
        hour = 3600
        for age, text, code in ((1, "wrong\n", 1), (2, "right\n", 0), (3, "wrong\n", 1)):
            self.write("one", text)
            then = time.time() - age * hour
            os.utime(self.stub("one"), (then, then))
            said = self.course("check", "01.1", code=code)
            self.assertRegex(self.course("list"), r"x 01.1 .* failing" if code else r"\+ 01.1 .* done")
        # The clock was set back: what was built is of tomorrow.
        later = time.time() + 24 * hour
        for path in (self.root / "build").rglob("*"):
            os.utime(path, (later, later))
        for text, code in (("right\n", 0), ("wrong\n", 1)):
            self.write("one", text)
            self.course("check", "01.1", code=code)

    def test_what_a_learner_adds_counts(self):
        self.build_by_time_stamps()
        self.write("one", "right\n")
        self.course("check", "01.1")
        for name in ("one.hpp~", ".one.hpp.swp", "#one.hpp#"):
            self.put("exercises/01_tiny/rt/" + name, "an editor's")
        self.assertRegex(self.course("list"), r"\+ 01.1 .* done")
        self.put("exercises/01_tiny/rt/mine.hpp", "")
        self.assertRegex(self.course("list"), r"\? 01.1 .* not checked since it changed")
        (self.root / "build/check/check.01.1").unlink()
        self.course("check", "01.1")
        self.assertTrue((self.root / "build/check/check.01.1").exists())  # compiled again

    def test_a_missing_file_is_no_answer(self):
        # Of several todos: with the solution's header none of them would be left.
        self.write("one", 2 * (STUB % (1, 1)))
        self.course()
        self.write("one", "right\n")
        self.course("check", "01.1")
        words = ("exercises/01_tiny/rt/one.hpp is missing; ./course reset 01.1 restores the stub, "
                 "and git checkout -- exercises/01_tiny/rt/one.hpp restores what you last committed\n")
        self.stub("one").rename(self.root / "elsewhere.hpp")
        for said in (self.course("check", "01.1", code=1), self.course("check", code=1), self.course()):
            self.assertIn("\n" + words, said)
            self.assertRegex(said, "[!x] 01.1 .* a file is missing")
            self.assertNotIn("Next", said)
        self.assertIn("0 of 2 exercises", said)
        self.assertIn("None of the code is yours", subprocess.run(
            [COURSE, "run", "01"], env=self.environment, text=True, stderr=subprocess.PIPE,
            stdout=subprocess.DEVNULL).stderr)
        (self.root / "exercises").rename(self.root / "moved")
        said = self.course()
        self.assertIn(words, said)
        self.assertIn("0 of 2 exercises", said)
        (self.root / "moved").rename(self.root / "exercises")
        self.course("reset", "01.1")
        self.assertRegex(self.course("list"), r"\. 01.1 .* to be written")
        (self.root / "elsewhere.hpp").rename(self.stub("one"))
        self.assertRegex(self.course("list"), r"[?] 01.1 .* not checked")

    def test_what_is_no_file_is_no_answer(self):
        self.write("one", "right\n")
        self.course("check", "01.1")
        self.stub("one").unlink()

        def refused(what):
            words = f"exercises/01_tiny/rt/one.hpp {what}; move it away"
            self.assertIn(words, self.course("check", "01.1", code=1))
            self.assertIn(words, self.course())
            reset = subprocess.run([COURSE, "reset", "01.1"], env=self.environment, text=True,
                                   stderr=subprocess.PIPE, timeout=20)
            self.assertEqual(reset.returncode, 1)
            self.assertEqual(reset.stderr.count("\n"), 1)
            self.assertIn(words, reset.stderr)

        self.stub("one").mkdir()
        refused("is a folder, not a file")
        self.stub("one").rmdir()
        os.mkfifo(self.stub("one"))
        refused("is a pipe or a device, not a file")
        self.write("two", "right\n")
        self.assertIn("one.hpp is a pipe", self.course("check", "01.2", code=1))
        self.stub("one").unlink()
        self.stub("one").symlink_to("/nowhere/one.hpp")
        refused("is a link to /nowhere/one.hpp, which is missing")
        self.stub("one").unlink()
        self.write("one", "")  # which was never checked
        self.assertRegex(self.course("list"), r"[?] 01.1 .* not checked")

    def test_line_ends_do_not_count(self):
        def end_lines_as_windows_does(path):
            path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))

        end_lines_as_windows_does(self.stub("one"))
        self.assertRegex(self.course("list"), r"\. 01.1 .* to be written")
        self.assertIn("as it was shipped", self.course("reset", "01.1"))
        self.write("two", "right\n")
        self.course("check", "01.2")
        for name in (".course/stubs/01_tiny/rt/one.hpp", "docs/hints/01-tiny.md", "course.json",
                     "exercises/01_tiny/rt/two.hpp"):
            end_lines_as_windows_does(self.root / name)
        said = self.course("list")
        self.assertRegex(said, r"\. 01.1 .* to be written")
        self.assertRegex(said, r"\+ 01.2 .* done")
        self.assertIn("hint 1 of 3\nidea", self.course("hint", "01.1"))

    # ---- hint, reset, run --------------------------------------------------------------------

    def test_hints_come_one_by_one(self):
        said = [self.course("hint", "01.1") for _ in range(5)]
        self.assertIn("hint 1 of 3\nidea", said[0])
        self.assertIn("formula √x in code\n", said[1])
        self.assertIn("shape", said[2])
        self.assertIn("no more hints", said[3])
        self.assertIn("solutions/01_tiny/rt/one.hpp", said[4])
        for line in said[3].split("\n"):
            self.assertLessEqual(len(line), 98)
        self.assertIn("idea", self.course("hint", "1.2"))

    def test_hints_for_stars_wait_for_the_core(self):
        self.put("docs/hints/01-tiny.md", "# Hints\n" + "".join(
            f"\n## 01.{number}\n\n1. idea\n\n   ★ above\n2. formula\n3. shape\n\n   ★ below\n" for number in (1, 2)))
        self.write("one", "wrong")
        self.course("check", "01.1", code=1)
        said = [self.course("hint", "01.1") for _ in range(4)]
        self.assertNotIn("★", "".join(said))
        self.write("one", "fine")
        self.course("check", "01.1")
        self.assertRegex(self.course("hint", "01.1"), "(?s)★ above.*★ below.*no more hints")
        self.write("two", "fine")
        self.course("check", "01.2")
        self.assertIn("idea\n\n★ above", self.course("hint", "01.2"))

    def test_reset_keeps_what_was_there(self):
        self.assertIn("as it was shipped", self.course("reset", "01.1"))
        for text in ("first\n", "second\n"):
            self.write("one", text)
            self.write("two", "mine\n")
            said = self.course("reset", "01.1")
            self.assertEqual(self.stub("one").read_text(), STUB % (1, 1))
            self.assertEqual(self.stub("two").read_text(), "mine\n")
            kept = re.search(r"kept +(\S+)", said).group(1)
            self.assertEqual((self.root / kept).read_text(), text)
        self.stub("one").unlink()
        self.course("reset", "01.1")
        self.assertEqual(self.stub("one").read_text(), STUB % (1, 1))

    def test_the_demo_draws_pictures_as_large_as_in_the_texts(self):
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        (self.root / "docs/images").mkdir()
        (self.root / "docs/images/01_tiny.png").write_bytes(
            b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 3, 2, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(2 * b"\0abc")) + chunk(b"IEND", b""))
        shutil.copy(self.root / "program.sh", self.root / "build/bin/01_tiny_solution")
        self.assertIn("program --out 01_tiny.png --width 3 --height 2\n", self.course("demo"))

    def test_run_gives_another_scene_another_picture(self):
        self.put("scenes/moon.json", "{}")
        said = self.course("run", "01", str(self.root / "scenes/moon.json"))
        self.assertIn(f"--out {self.root}/out/01_tiny_moon_mine.png", said)

    def test_run_takes_what_passes_and_says_whose_it_is(self):
        def run(words):
            done = subprocess.run([COURSE, "run", "01"], env=self.environment, text=True,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(words, done.stderr)

        def code(name):
            return (self.root / f"build/yours/rt/{name}.hpp").read_text()

        run("None of the code is yours yet")
        self.assertIn("// solution 1", code("one"))
        self.write("one", "right\n")  # it was not checked yet
        run("Yours: 01.1. The solution's: 01.2.")
        self.assertTrue(code("one").endswith("exercises/01_tiny/rt/one.hpp\"\nright\n"), code("one"))
        self.assertIn("// solution 2", code("two"))
        self.write("two", "right\n")
        run("All of the code is yours.")
        before = (self.root / "build/yours/rt/one.hpp").stat().st_mtime_ns
        self.write("two", "wrong\n")
        run("Yours: 01.1. The solution's: 01.2. It stands in for 01.2, which does not pass yet.\n"
            "With your code as it is: ./course run 01 --mine\n")
        self.assertIn("// solution 2", code("two"))
        self.assertEqual((self.root / "build/yours/rt/one.hpp").stat().st_mtime_ns, before)

    def write_program_that_draws(self):
        """Makes a program that draws the brightness that its code has: 10, or that after "draws"."""
        self.put("program.sh", '''#!/bin/sh
[ "$1" != --describe ] || { echo '{"width": "2", "height": "1"}'; exit; }
bright=10
case $0 in *_mine) found=$(sed -n 's/.*draws //p' "${0%/bin/*}"/yours/rt/*.hpp); bright=${found:-10} ;; esac
while [ "$1" != --out ]; do shift; done
printf 'P3\\n2 1\\n255\\n%s 0 0 0 0 0\\n' "$bright" >"$2"
''')
        os.chmod(self.root / "program.sh", 0o755)

    def test_compare_and_run_say_that_wrong_code_draws_something_else(self):
        self.write_program_that_draws()
        self.write("one", "right\n")
        self.write("two", "wrong, and draws 99\n")
        said = self.course("compare", "01")
        self.assertIn("It stands in for 01.2, which does not pass yet.\n"
                      "With your code as it is: ./course compare 01 --mine\n", said)
        self.assertIn("bit for bit", said)
        said = self.course("compare", "01", "--mine", code=1)
        self.assertIn("These do not pass yet, but are used anyway: 01.2.", said)
        self.assertIn("01_tiny: It differs from the solution's.\n", said)
        self.assertNotIn("Drawing it again", said)
        self.assertEqual(self.course("run", "01"), "01_tiny: The same as the solution's, bit for bit.\n")
        self.assertEqual(self.course("run", "01", "--mine"),
                         "01_tiny: It differs from the solution's. Where: ./course compare 01 --mine\n")
        self.assertEqual(self.course("run", "01", "--out", "a.ppm"), "")
        self.write("two", "star one open\n// draws 99\n")
        self.assertEqual(self.course("run", "01"), "01_tiny: It differs from the solution's. "
                         "Where, and whether it may: ./course compare 01\n")

    def test_compare_says_what_is_no_mistake(self):
        self.write_program_that_draws()

        def compare(code):
            done = subprocess.run([COURSE, "compare", "01"], env=self.environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(done.returncode, code, done.stdout)
            return done.stdout

        self.write("one", "right\n")
        self.write("two", "right, and draws 10\n")
        self.assertIn("bit for bit", compare(0))
        self.write("two", "right, but draws 99\n")
        said = compare(1)
        self.assertNotIn("no mistake", said)
        self.assertIn("times as bright", said)
        self.write("two", "star one open\n// draws 99\n")
        said = compare(0)
        self.assertIn("It differs from the solution's, which is no mistake here:", said)
        self.assertIn("01.2 has open stars.\n  With the solution's code for this exercise, the pictures are the same."
                      "\n  Where: middle.\n", said)
        self.assertNotRegex(said, "too (dark|bright)|times as bright|differ by more")
        self.write("two", "right, but draws 99\n")
        self.write("one", "star one open\n")
        self.assertNotIn("no mistake", compare(1))  # with or without the open star
        self.write("one", "right\n")
        self.facts[1]["several_answers"] = True
        self.put_course(self.chapter("01_tiny", self.facts))
        self.assertIn("01.2 has several right answers.", compare(0))

    def test_the_first_program_is_compiled_and_drawn(self):
        self.put("exercises/00_toolchain/first.cpp", '#include <iostream>\nint main() { std::cout << "P3\\n1 1\\n255\\n1 2 3\\n"; }\n')
        self.assertEqual(self.course("run", "00.1"), "Your picture: out/00_first.png\n")
        self.assertTrue((self.root / "out/00_first.png").exists())
        self.put("exercises/00_toolchain/first.cpp", "int main() { return }\n")
        done = subprocess.run([COURSE, "run", "00.1"], env=self.environment, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("exercises/00_toolchain/first.cpp:1:", done.stderr)
        self.assertIn("first.cpp does not compile", done.stderr)

    def test_run_mine_takes_what_fails_too(self):
        def run(words, *options):
            done = subprocess.run([COURSE, "run", "01", *options], env=self.environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, words + "\n")
            return done.stdout

        def code(name):
            return (self.root / f"build/yours/rt/{name}.hpp").read_text()

        self.write("one", "wrong\n")
        run("The solution's: 01.2. All else is yours. These do not pass yet, but are used anyway: 01.1.", "--mine")
        self.assertTrue(code("one").endswith("wrong\n"), code("one"))
        self.assertIn("// solution 2", code("two"))
        self.write("two", "wrong, too\n")
        said = run("All of the code is yours. These do not pass yet, but are used anyway: 01.", "--width", "9", "--mine")
        self.assertIn(f"program --out {self.root}/out/01_tiny_mine.png --width 9\n", said)
        self.stub("two").unlink()
        run("The solution's: 01.2. All else is yours. These do not pass yet, but are used anyway: 01.1.", "--mine")
        self.write("one", "right\n")
        self.write("two", "right\n")
        run("All of the code is yours.", "--mine")
        self.write("one", "wrong\n")
        run("Yours: 01.2. The solution's: 01.1. It stands in for 01.1, which does not pass yet.\n"
            "With your code as it is: ./course run 01 --mine")
        self.assertIn("// solution 1", code("one"))
        # What the program says of a stub ends as usual.
        self.course("run", "01", "--mine", "--fail", code=3)

    def test_a_slip_is_refused_before_the_build(self):
        self.put("build/bin/01_tiny_mine", '#!/bin/sh\ncase "$*" in *nonsense*) echo no such option >&2; exit 2 ;; esac\n')
        os.chmod(self.root / "build/bin/01_tiny_mine", 0o755)
        self.assertEqual(self.course("run", "01", "--nonsense", code=2), "no such option\n")
        self.assertFalse((self.root / "build/yours").exists())
        for words in (["study", "99"], ["study", "--mine", "99"], ["run", "99"]):
            self.course(*words, code=2)
            self.assertFalse((self.root / "build/yours").exists())

    def test_run_builds_what_the_options_ask_for(self):
        programs = "08_effects_mine", "08_effects_mine_study", "renderer_mine", "10_more_mine"
        with open(self.root / "CMakeLists.txt", "a") as file:
            file.writelines(map(self.program, programs))
        chapters = []
        for name in ("08_effects", "10_more"):
            chapters.append(self.chapter(name, [{"id": f"{name[:2]}.1", "title": "Any", "minutes": 10,
                                                 "files": [f"rt/{name}.hpp"]}]))
            self.put(f"solutions/{name}/rt/{name}.hpp", "// solution\n")
        self.put_course(*chapters)
        self.put("program.sh", '#!/bin/sh\necho "${0##*/}"\n')
        for scene, text in (("meshes", '{"meshes": []}'), ("plain", '{"spheres": []}')):
            self.put(f"{scene}.json", text)
        for words, program in (([], "08_effects_mine"), (["--batches"], "renderer_mine"),
                               (["--sampler=sobol"], "renderer_mine"),
                               ([f"{self.root}/meshes.json"], "renderer_mine"),
                               ([f"{self.root}/plain.json"], "08_effects_mine"),
                               (["--study", f"{self.root}/out"], "08_effects_mine_study")):
            self.assertEqual(self.course("run", "08", *words), program + "\n")
        self.assertEqual(self.course("run", "10", "--time-budget", "1"), "10_more_mine\n")

    def test_run_passes_options_on(self):
        said = self.course("run", "01", "--width", "9")
        self.assertIn(f"program --out {self.root}/out/01_tiny_mine.png --width 9", said)
        for option in (["--out", "a.png"], ["--out=a.png"]):  # a bare name is meant in out/
            self.assertRegex(self.course("run", "1", *option),
                             f"program --out[ =]{self.root}/out/a.png")
        for path in ("./a.png", f"{self.root}/a.png"):
            self.assertIn(f"program --out {path}\n", self.course("run", "1", "--out", path))
        self.course("run", "01", "--fail", code=3)
        crashed = subprocess.run([COURSE, "run", "01", "--crash"], env=self.environment, text=True,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.assertEqual(crashed.returncode, 1)
        self.assertIn("./course check 01", crashed.stderr)

    def test_run_follows_the_light_of_a_sample(self):
        self.put("program.sh", r"""#!/bin/sh
case $* in *--describe) echo '{"spp": "100"}'; exit ;; esac
printf 'P3 2 1 255 1 2 3 4 5 6' >"$3"
case $0 in *_mine) shift 3; echo "$@" >"${0%/*}/../drawn"; exit ;; esac
camera='camera\teye\t0 0 4\tu\t1 0 0\tv\t0 1 0\tw\t0 0 1\tviewport\t2 1\tcolumns\t2\trows\t1\tleft\t0\ttop\t0\toffset\t0.5 0.5\n'
ray="$camera"'ray\torigin\t0 0 4\tdirection\t0 0 -1\n'
case $COURSE_FOLLOW in
'1 0 0') printf "$ray"'miss\n' >"$COURSE_TRAIL" ;;
'1 0 2') printf "$ray" >"$COURSE_TRAIL"; kill -SEGV $$ ;;
'1 0 3') echo 01.2 is still to be written >&2; exit 3 ;;
'1 0 9') printf 'pixel\tsamples\t9\n' >"$COURSE_TRAIL" ;;
esac
""")
        os.chmod(self.root / "program.sh", 0o755)
        drawing = self.root / "out/01_tiny-follow.svg"
        said = self.course("run", "01", "--follow", "1,0", "--depth", "5", "--spp", "64")
        self.assertIn("Pixel 1,0, sample 0\n", said)
        self.assertIn("   1 from (0, 0, 4) along (0, 0, -1)\n     meets nothing\nDrawn: out/01_tiny-follow.svg\n", said)
        self.assertIn("data:image/png;base64,", drawing.read_text())
        # The picture below the path has few samples.
        self.assertEqual((self.root / "build/drawn").read_text(), "--depth 5 --spp 9\n")
        self.course("run", "--follow", "1,0,0", "01", "--spp=4")
        self.assertEqual((self.root / "build/drawn").read_text(), "--spp 4\n")
        for words, error in (("1", "--follow takes a pixel's column and row"),
                             ("1,0,x", "--follow takes a pixel's column and row"),
                             ("5,0", "--follow 5,0 is outside of the picture: its columns are 0 to 1, and its rows 0 to 0"),
                             ("0,0", "--follow 0,0: the program sends no ray through this pixel"),
                             ("1,0,9", "--follow: there is no sample 9: those of the pixel 1,0 are 0 to 8")):
            drawing.unlink(missing_ok=True)
            self.assertIn(error, self.course("run", "01", "--follow", words, code=2))
            self.assertFalse(drawing.exists())
        self.assertIn("takes no --out", self.course("run", "01", "--follow", "1,0", "--out", "a.png", code=2))
        self.assertIn("     the program crashed here: signal 11", self.course("run", "01", "--follow", "1,0,2", code=1))
        self.assertEqual(self.course("run", "01", "--follow", "1,0,3", code=3), "")
        # The picture may be the reason to look.
        self.put("program.sh", (self.root / "program.sh").read_text().replace("*_mine) ", "*_mine) kill -SEGV $$; "))
        said = self.course("run", "01", "--follow", "1,0")
        self.assertIn("There is no picture below the path: 01_tiny: signal 11", said)
        self.assertNotIn("<image", drawing.read_text())
        # With code that fails, too.
        self.write("one", "wrong\n")
        self.course("run", "01", "--follow", "1,0")
        self.assertIn("// solution 1", (self.root / "build/yours/rt/one.hpp").read_text())
        self.course("run", "01", "--follow", "1,0", "--mine")
        self.assertTrue((self.root / "build/yours/rt/one.hpp").read_text().endswith("wrong\n"))

    def test_what_a_program_prints_does_not_rule_the_terminal(self):
        self.put("program.sh", "#!/bin/sh\nprintf 'so \\033[2J\\033]0;title\\007far\\a\\nit goes'; "
                 "[ \"$3\" = --all ] && yes goes on 2>/dev/null | head -c 1300000; echo; echo end\n")
        with Terminal([COURSE, "run", "01"], self.environment) as terminal:
            terminal.expect("so far\r\nit goes\r\nend\r\n")
            self.assertEqual(terminal.end(), 0)
        with Terminal([COURSE, "run", "01", "--all"], self.environment) as terminal:
            terminal.expect(r"\n\.\.\. and more, which is not shown\.\r\n")
            self.assertEqual(terminal.end(), 0)
            self.assertEqual(terminal.said, "")

    def test_ctrl_c_reaches_what_runs(self):
        started = self.root / "out/started"

        def wait_for_start():
            for _ in range(400):
                if started.exists():
                    return started.unlink()
                time.sleep(0.05)
            self.fail("it does not start")

        def stopped(*words):
            process = subprocess.Popen([COURSE, "run", "01", *words], env=self.environment,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            wait_for_start()
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(20), 130)

        stopped("--long")
        self.assertEqual((self.root / "out/01_tiny_mine.png").read_text(), "a part\n")
        # What has nothing to keep ends at once.
        stopped("--longer")
        with self.watched("01") as terminal:
            terminal.expect("q quit")
            self.put("program.sh", (self.root / "program.sh").read_text().replace('"$3" != --long ', '1 = 2 '))
            (self.root / "out/01_tiny_mine.png").unlink()
            terminal.press("r")
            wait_for_start()
            terminal.press("\x03")
            self.assertEqual(terminal.end(), -signal.SIGINT)
            self.assertTrue(terminal.echoes())
        self.assertEqual((self.root / "out/01_tiny_mine.png").read_text(), "a part\n")

    def test_mine_is_another_name_for_running_the_last_chapter(self):
        self.put("program.sh", "#!/bin/sh\n[ \"$1\" != --out ] || { echo \"$*\"; echo a picture >\"$2\"; }\n")
        self.assertEqual(self.course("mine"), f"--out {self.root}/out/01_tiny_mine.png\n")
        self.put("program.sh", "#!/bin/sh\nexit 1\n")
        self.course("mine", code=1)
        self.assertEqual((self.root / "out/01_tiny_mine.png").read_text(), "a picture\n")

    # ---- the page to share -------------------------------------------------------------------

    def first_passed(self, exercise):
        state = json.loads((self.root / ".course/state.json").read_text())
        return state["exercises"][exercise]["first_passed"]

    def test_the_time_of_the_first_pass_is_recorded(self):
        self.write("one", "wrong\n")
        self.course("check", "01.1", code=1)
        self.assertEqual(self.first_passed("01.1"), 0)
        self.write("one", "not in float\n")
        self.course("check", "01.1", code=1)
        self.assertEqual(self.first_passed("01.1"), 0)
        self.write("one", "right\n")
        before = int(time.time())
        self.course("check", "01.1")
        self.assertTrue(before <= self.first_passed("01.1") <= time.time())
        state = json.loads((self.root / ".course/state.json").read_text())
        state["exercises"]["01.1"]["first_passed"] = 1000000
        self.put(".course/state.json", json.dumps(state))
        self.write("one", "wrong\n")
        self.course("check", "01.1", code=1)
        self.write("one", "right again\n")
        self.course("check", "01.1")
        self.assertEqual(self.first_passed("01.1"), 1000000)

    def test_a_time_that_nobody_knows_stays_unknown(self):
        self.add_second_chapter()
        self.write("one", "right\n")
        self.put("exercises/02_more/rt/three.hpp", "right\n")
        self.course("check")
        self.assertEqual(self.first_passed("01.1"), -1)
        self.assertEqual(self.first_passed("02.1"), -1)
        self.write("one", "right again\n")
        self.course("check", "01.1")
        self.assertEqual(self.first_passed("01.1"), -1)
        self.course("book", "--mine")
        self.assertIn("This is not known: there is no record of when 2 answers first passed.", (self.root / "out/mine.html").read_text())

    def test_a_first_pass_counts_in_both_precisions(self):
        self.add_second_chapter()
        self.write("one", "right\n")
        self.put("exercises/02_more/rt/three.hpp", "not in float\n")
        self.course("check", code=1)
        self.assertGreater(self.first_passed("01.1"), 0)  # and not unknown: it is the only one
        self.assertEqual(self.first_passed("02.1"), 0)

    def test_book_mine_makes_a_page_to_share(self):
        self.write("one", "right\n")
        self.write("two", "wrong\n")
        self.put("build/mine/rt/old.hpp", "old\n")
        said = self.course("book", "--mine")
        self.assertEqual(said, "Yours: 01.1. The solution's: 01.2. It stands in for 01.2, which does not pass yet.\n"
                         "The page to share is out/mine.html. It has no picture yet: draw the final scene with ./course run 08, then run ./course book --mine again.\n")
        page = (self.root / "out/mine.html").read_text()
        self.assertIn("1 of 2 exercises pass", page)
        self.assertIn("Everything passed on one day", page)
        headers = self.root / "build/mine/rt"
        self.assertEqual([file.name for file in headers.iterdir()], ["one.hpp"])
        self.assertEqual((self.root / "build/mine/passed.txt").read_text(), "01.1\n")
        self.assertTrue((headers / "one.hpp").read_text().endswith("exercises/01_tiny/rt/one.hpp\"\nright\n"))

        # What fails runs in figures only if it is named.
        failing, as_it_is = self.root / "build/mine/failing.txt", self.root / "build/mine/as_it_is/rt"
        self.assertFalse(failing.exists())
        self.course("book", "--mine", "01.2")
        self.assertEqual(failing.read_text(), "01.2\n")
        self.assertEqual(sorted(file.name for file in as_it_is.iterdir()), ["one.hpp", "two.hpp"])
        self.assertTrue((as_it_is / "two.hpp").read_text().endswith("wrong\n"))
        self.assertEqual([file.name for file in headers.iterdir()], ["one.hpp"])
        self.assertIn("01.1 passes, so the figures need no switch for it.\n", self.course("book", "--mine", "01.1"))
        self.assertFalse(failing.exists())
        self.write("two", STUB % (2, 2))
        self.assertIn("01.2 cannot run yet; ./course check 01.2 says why", self.course("book", "--mine", "01.2", code=2))
        self.write("two", "wrong\n")

        self.put("program.sh", "#!/bin/sh\n[ \"$1\" != --out ] || echo a picture $3 >\"$2\"\n")
        self.course("run", "01")
        self.assertIn("The page to share is out/mine.html.\n", self.course("book", "--mine"))
        page = (self.root / "out/mine.html").read_text()
        self.assertIn("Drawn by its author's code for 01.1, and by the course's for 01.2.", page)
        self.assertIn("base64,YSBwaWN0dXJlCg==", page)
        # In false colors, it is not the final scene.
        self.course("run", "01", "--show", "normal")
        self.assertIn("It has no picture yet", self.course("book", "--mine"))
        self.course("book", code=2)
        self.course("book", "--mine", "x", code=2)

    def put_questions(self):
        self.put("docs/x.png", "a picture")
        self.put("chapters/01_tiny/questions.json", json.dumps({"questions": [
            {"kind": "predict", "ask": "What is 1/2 + 1/4?", "answer": 0.75, "tolerance": 0.01,
             "nudge": "Draw it.", "because": "Three quarters."},
            {"kind": "find the fault", "ask": "Which one?", "picture": "docs/x.png",
             "choices": ["01.1 one", "01.2 two"], "answer": "01.2 two", "nudge": "Look again.",
             "because": "It is two."}]}))

    def test_ask_without_a_terminal(self):
        self.assertIn("All questions are answered", self.course("ask"))
        self.put_questions()
        said = self.course("ask", "01")
        self.assertIn("Chapter 01, question 1 of 2 (predict)\n  What is 1/2 + 1/4?\n", said)
        self.assertIn("./course ask 01 --answer ANSWER", said)
        said = self.course("ask", "01", "--answer", "1", code=1)
        self.assertIn("Not yet.\n  Draw it.", said)
        self.assertNotIn("Three quarters", said)
        self.assertIn("No. The right answer is 0.75\n  Three quarters.", self.course("ask", "01", "--answer", "2", code=1))
        self.assertIn("takes a number", self.course("ask", "01", "--answer", "what", code=2))
        self.assertIn("Right.\n  Three quarters.", self.course("ask", "1", "--answer", "3/4"))
        said = self.course("ask", "--answer", "a", code=1)
        self.assertIn("Look at out/question-01.png\n    a) 01.1 one\n    b) 01.2 two\n", said)
        self.course("ask", "--answer", "B")
        self.assertIn("All questions of chapter 01 are answered", self.course("ask", "01"))

    def test_ask_on_a_terminal(self):
        self.put_questions()
        with Terminal([COURSE, "ask", "01"], self.environment) as terminal:
            terminal.expect("What is 1/2")
            terminal.press("0.5\n")
            terminal.expect("Draw it")
            terminal.press(".75\n")
            terminal.expect("Right")
            terminal.expect("question 2 of 2")
            terminal.press("z\n")
            terminal.expect("one of the letters")
            terminal.press("\x04")
            self.assertEqual(terminal.end(), 0)
        with Terminal([COURSE, "ask"], self.environment) as terminal:
            terminal.expect("question 2 of 2")
            terminal.press("a\na\n")
            terminal.expect("Look again")
            terminal.expect("It is two")
            self.assertEqual(terminal.end(), 0)

    def test_ask_reviews_earlier_chapters(self):
        self.add_second_chapter()
        self.put_questions()
        self.put("chapters/02_more/questions.json", json.dumps({"questions": [
            {"kind": "predict", "ask": f"What is {n} + {n}?", "answer": 2 * n, "tolerance": 0, "nudge": "Count.",
             "because": "It is."} for n in (1, 2, 3)]}))
        # Nothing of chapter 01 has been answered.
        said = self.course("ask", "02")
        self.assertNotIn("review", said)
        for answer in (".75", "b"):
            self.course("ask", "01", "--answer", answer)
        with Terminal([COURSE, "ask", "02"], self.environment) as terminal:
            terminal.expect("Chapter 02, question 1 of 3")
            terminal.press("2\n")
            terminal.expect("Chapter 01, question 1 of 2")
            terminal.expect("(predict, review)")
            terminal.press("7\n")
            terminal.expect("Draw it")
            terminal.press(".75\n")
            terminal.expect("Chapter 02, question 2 of 3")
            terminal.press("4\n")
            terminal.expect("(find the fault, review)")
            terminal.press("\x04")
            self.assertEqual(terminal.end(), 0)
        # Only what is not done yet is left.
        self.assertIn("Chapter 02, question 3 of 3", self.course("ask", "02", "--answer", "6"))
        said = self.course("ask", "02")
        self.assertIn("Chapter 01, question 2 of 2 (find the fault, review)", said)
        self.assertIn("./course ask 02 --answer ANSWER", said)
        self.assertIn("Not yet.", self.course("ask", "02", "--answer", "a", code=1))
        self.assertIn("Right.", self.course("ask", "02", "--answer", "b"))
        self.assertIn("All questions of chapter 02 are answered", self.course("ask", "02"))
        self.assertIn("All questions of chapter 01 are answered", self.course("ask", "01"))

    def put_graft(self, **more):
        """A course with a graft, our answer to it, and a scene; returns a tracer that draws something else."""
        chapter = self.chapter("01_tiny", self.facts)
        chapter["graft"] = {"title": "Any", "minutes": 1, "reads": "scene", "still": True, "steps": [1], "headers": ["one.hpp"]}
        self.put("course.json", json.dumps({"chapters": [chapter], **more}))
        self.put("CMakeLists.txt", (self.root / "CMakeLists.txt").read_text() +
                 "add_custom_target(tracer.01 COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/ours.sh bin/tracer.01)\n")
        self.put("ours.sh", "#!/bin/sh\nprintf 'P3\\n2 1\\n255\\n9 9 9 9 9 9\\n' >\"$2\"\n")
        os.chmod(self.root / "ours.sh", 0o755)
        self.put("exercises/tracer/my.txt", "picture 2 1 1 1\n")
        return '#include <fstream>\nint main(int, char** w) { std::ofstream{w[2]} << "P3\\n2 1\\n255\\n1 2 3 4 5 6\\n"; }\n'

    def test_tracer_draws_beside_ours_and_in_false_colors(self):
        program = self.put_graft()
        self.put("exercises/tracer/tracer.cpp", program)

        def tracer(*words):
            done = subprocess.run([COURSE, "tracer", *words], env=self.environment, text=True, timeout=60,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            return done.stdout + done.stderr

        said = tracer()
        self.assertIn("Beside ours:  out/tracer_beside_ours.png", said)
        self.assertTrue((self.root / "out/tracer_beside_ours.png").exists())
        kept = "out/judge/a_sky_and_nothing_else"
        self.assertIn("    Yours beside ours: %s/beside.png\n" % kept, said)
        self.assertIn("    Draw it again:     build/tracer %s/scene.txt %s/again.ppm\n" % (kept, kept), said)
        for name in ("scene.txt", "yours.png", "ours.png", "beside.png"):
            self.assertTrue((self.root / kept / name).exists())
        self.assertIn("  ./course tracer --from 01  to go on without doing this graft\n", said)
        self.assertNotIn("to do this graft again", said)
        self.assertIn("your tracer has no --show yet", tracer("--show", "normal"))
        self.put("chapters/01_tiny/rt/false_color_image.hpp", "#pragma once\n")
        self.put("exercises/tracer/tracer.cpp", "#include <rt/false_color_image.hpp>\n" + program)
        said = tracer("--show", "normal")
        self.assertIn("Your picture: out/tracer_show.png", said)
        self.assertNotIn("Graft", said)
        # The light of a sample, by the program that is compiled with the recorder.
        self.assertIn("--follow needs a tracer that reads a scene", tracer("--follow", "1,0"))
        self.put("chapters/01_tiny/rt/tracer_call.hpp", "#pragma once\n")
        self.put("exercises/tracer/tracer.cpp", "#include <rt/tracer_call.hpp>\n" + program)
        self.assertIn("--follow 1,0: the program sends no ray through this pixel", tracer("--follow", "1,0"))
        self.put("companion/follow/recorder/rt/tracer_call.hpp", """#include <cstdlib>
#include <fstream>
inline const bool told = [] {
    std::ofstream{std::getenv("COURSE_TRAIL")} << "camera\\toffset\\t0 0\\tviewport\\t2 1\\n"
        "ray\\torigin\\t0 0 4\\tdirection\\t0 0 -1\\nmiss\\n";
    return true;
}();
""")
        self.put("exercises/tracer/my.txt", "picture 2 1 64 1\n")
        said = tracer("--follow", "1,0,3")
        self.assertIn("\nPixel 1,0, sample 3\n", said)
        self.assertIn("     meets nothing\nDrawn: out/tracer-follow.svg\n", said)
        # Begun from our answer, with what comes next.
        self.put("solutions/tracer/01.cpp", "ours\n")
        self.assertRegex(tracer("--from", "1"),
                         r"^kept   .*/tracer.cpp\nbegun  exercises/tracer/tracer.cpp, from our answer to graft 01, Any\n"
                         r"\nNext: 01.1 Number one")
        self.assertEqual((self.root / "exercises/tracer/tracer.cpp").read_text(), "ours\n")

    def test_tracer_is_drawn_and_not_judged_until_the_next_graft_is_ready(self):
        graft = {"title": "Any", "minutes": 1, "reads": "scene", "still": True, "steps": [1], "headers": ["one.hpp"]}
        self.add_second_chapter()
        course = json.loads((self.root / "course.json").read_text())
        for chapter in course["chapters"]:
            chapter["graft"] = graft
        self.put("course.json", json.dumps({**course, "route": ["graft 01", "01.1", "graft 02", "01.2", "02.1"]}))
        # On the way to graft 02, it may have the headers of chapter 02, and draws what graft 01 reads.
        self.put("chapters/02_more/rt/later.hpp", "#pragma once\n")
        self.put("solutions/02_more/rt/three.hpp", "#pragma once\n")
        self.put("exercises/tracer/my.txt", "picture 2 1 1 1\n")
        self.put("solutions/tracer/01.cpp", '#include <fstream>\n#include <rt/later.hpp>\n'
                 'int main(int, char** w) { std::ofstream{w[2]} << "P3\\n2 1\\n255\\n1 2 3 4 5 6\\n"; }\n')
        self.course("tracer", "--from", "01")
        said = self.course("tracer")
        self.assertTrue(said.startswith("Your tracer, on the way to graft 02\n"), said)
        self.assertIn("Your picture: out/tracer.png\n", said)
        self.assertIn("\nNext: 01.1 Number one", said)
        self.assertIn("If you have done graft 02 already: ./course tracer --graft 02\n", said)
        # It may be ahead, and read scenes, although the last graft that passed reads none.
        course["chapters"][0]["graft"] = {**graft, "reads": "nothing"}
        self.put("course.json", json.dumps({**course, "route": ["graft 01", "01.1", "graft 02", "01.2", "02.1"]}))
        self.assertIn("No picture: ", self.course("tracer", code=1))
        self.put("chapters/02_more/rt/tracer_call.hpp", "#pragma once\n")
        tracer = (self.root / "exercises/tracer/tracer.cpp").read_text()
        self.put("exercises/tracer/tracer.cpp", "#include <rt/tracer_call.hpp>\n" + tracer)
        self.assertIn("Your picture: out/tracer.png\n", self.course("tracer"))
        course["chapters"][0]["graft"] = graft
        self.put("course.json", json.dumps({**course, "route": ["graft 01", "01.1", "graft 02", "01.2", "02.1"]}))
        for word in ("Beside ours", "Stuck", "passes"):
            self.assertNotIn(word, said)
        self.assertTrue(self.course("tracer", "--graft", "01", code=1).startswith("Graft 01: Any\n"))
        self.put("exercises/tracer/tracer.cpp", "int main() { return 3; }\n")
        self.assertIn("No picture: ", self.course("tracer", code=1))
        self.put("exercises/tracer/tracer.cpp", "no program\n")
        self.write("one", "right\n")  # it is checked first
        self.assertTrue(self.course("check", "tracer", code=1).startswith("Graft 02: Any\n"))

    def test_a_tracer_that_draws_for_ever_ends_with_the_companion(self):
        chapter = self.chapter("01_tiny", self.facts)
        chapter["graft"] = {"title": "Any", "minutes": 1, "reads": "scene", "still": True, "steps": [1], "headers": ["one.hpp"]}
        self.put_course(chapter)
        self.put("exercises/tracer/tracer.cpp",
                 '#include <fstream>\n#include <unistd.h>\nint main() { std::ofstream{"started"} << 1; sleep(60); }\n')
        with subprocess.Popen([COURSE, "tracer"], env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as tracer:
            self.wait_for(lambda: (self.root / "started").exists())
            tracer.terminate()
            self.assertEqual(tracer.wait(timeout=10), -signal.SIGTERM)

    def test_study_measures_what_passes(self):
        self.write("one", "right\n")
        said = self.course("study", "01", "--mine")
        self.assertIn("Yours: 01.1. The solution's: 01.2. Tables and plots are in ", said)
        self.assertEqual(said.count(f"program --study {self.root}/out/study-mine"), 2)
        self.assertIn("Your code is as accurate and as fast as the solution's", said)
        for folder in ("study-mine", "study"):
            self.assertTrue((self.root / "out" / folder / "01_tiny.csv").exists())

    # ---- bad input ---------------------------------------------------------------------------

    def test_bad_input_gets_one_line(self):
        for words in (["nonsense"], ["check", "99"], ["check", "01.9"], ["check", "01", "02"],
                      ["check", ""], ["hint"], ["hint", "01"], ["hint", "x"], ["reset"],
                      ["reset", "01"], ["reset", "01.9"], ["run"], ["run", "99"], ["list", "x"],
                      ["watch", "99"], ["watch", "01", "02"], ["chek"], ["check", "01.1", "--help"]):
            said = self.course(*words, code=2)
            self.assertEqual(said.count("\n"), 1, words)
            self.assertTrue(said.startswith("course: "), said)

    def test_what_is_not_expected_is_listed_as_it_was_typed(self):
        self.assertIn("mine: not expected: --width 320 --height 180;",
                      self.course("mine", "--width", "320", "--height", "180", code=2))
        self.assertIn("own: not expected: --x y;", self.course("own", "judge", "x", "--x", "y", code=2))

    def test_guesses(self):
        for word, meant in (("chek", "check"), ("lst", "list"), ("hnit", "hint"), ("wach", "watch")):
            self.assertIn(f"did you mean {meant}?", self.course(word, code=2))
        self.assertIn("the commands are list, check", self.course("nonsense", code=2))
        self.assertIn("'01' is a chapter; its exercises are 01.1, 01.2",
                      self.course("hint", "01", code=2))

    def test_broken_state_is_set_aside(self):
        self.put(".course/state.json", "{broken")
        self.course("list")
        self.assertEqual((self.root / ".course/state.broken-1.json").read_text(), "{broken")

    def test_a_state_with_odd_numbers_is_set_aside(self):
        self.course("hint", "01.1")
        state = self.root / ".course/state.json"
        good = state.read_text()
        for number in ("1e99", "-7", "1.5", "99999999999", "1e3"):
            state.write_text(good.replace('"hints":1', '"hints":' + number))
            self.assertIn("hint 1 of 3", self.course("hint", "01.1"))
        self.assertEqual(len([p for p in state.parent.iterdir() if "broken" in p.name]), 5)

    def test_a_file_that_cannot_be_written_is_named(self):
        self.write("one", "right\n")
        done = subprocess.run(["sh", "-c", 'ulimit -f 0; exec "$0" check 01.1', COURSE], env=self.environment,
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"^course: cannot write /.+: File too large\n$")

    def test_a_state_that_is_no_file_is_set_aside(self):
        self.write("one", "right\n")
        state = self.root / ".course/state.json"
        state.parent.mkdir()
        for make in (state.mkdir, lambda: os.mkfifo(state), lambda: state.symlink_to("/nowhere/state.json")):
            make()
            self.course("check", "01.1")
            self.assertTrue(state.is_file())
            state.unlink()
        self.assertEqual(len([p for p in state.parent.iterdir() if "broken" in p.name]), 3)

    def test_many_at_once(self):
        self.write("one", "right\n")
        self.write("two", "right\n")
        running = [subprocess.Popen([COURSE, *words.split()], env=self.environment,
                                    stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, text=True)
                   for words in ["check", "hint 01.1", "hint 01.2", "list"] * 4]
        for process in running:
            said, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 0, said)
        said = self.course("list")
        self.assertIn("2 of 2", said)
        self.assertIn("no more hints", self.course("hint", "01.1"))
        self.assertEqual(sorted(path.name for path in (self.root / ".course").iterdir()),
                         ["build.lock", "state.json", "state.lock", "turn.lock"])

    # ---- the script ---------------------------------------------------------------------------

    def use_script(self):
        """As in a checkout of the course: ./course builds the companion first."""
        with open(self.root / "CMakeLists.txt", "a") as cmake:
            cmake.write("file(GLOB none CONFIGURE_DEPENDS none/*)\n"  # as the course has some
                        "add_custom_target(course COMMAND ${CMAKE_COMMAND} -E make_directory bin "
                        "COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/wrapper bin/course VERBATIM)\n")
        (self.root / "build/bin/course").rename(self.root / "wrapper")
        self.put("CMakePresets.json", json.dumps({"version": 3, "configurePresets": [
            {"name": "release", "binaryDir": "${sourceDir}/build"}]}))
        self.put("companion/commands/commands.inc", DECLARED.read_text())
        self.put("course", Path(SCRIPT).read_text())

    def script(self, *words, code=0):
        done = subprocess.run(["sh", str(self.root / "course"), *words], env=self.environment, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              timeout=120)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_help_needs_nothing_that_is_built(self):
        self.use_script()
        shutil.rmtree(self.root / "build")
        whole = self.script("help")
        self.assertIn("\n  check [NN | tracer]     build and check your answers", whole)
        self.assertIn("\n      --stars             show the hard cases", whole)
        self.assertEqual(self.script("--help"), whole)
        for line in whole.split("\n"):
            self.assertLessEqual(len(line), 100, line)
        commands = re.findall(r"^(?:COMMAND|SCRIPT)\((\w+),", DECLARED.read_text(), re.M)
        self.assertGreater(len(commands), 17)
        for command in commands:
            words = command.split("_")
            for name in (words, words[:1]):
                for flag in ("--help", "-h"):
                    said = self.script(*name, flag)
                    self.assertTrue(said.startswith(f"  {' '.join(name)} "), said)
                    self.assertIn(said.split("\n")[0], whole.split("\n"))
        self.assertEqual(self.script("check", "--help").count("\n"), 3)
        for words in (["study", "01"], ["own", "judge", "x"], ["check", "01.1", "--stars"]):
            for flag in ("--help", "-h"):
                of_command = [word for word in words if word in ("study", "own", "judge", "check")]
                self.assertEqual(self.script(*words, flag), self.script(*of_command, flag))
        for words in (["study", "99"], ["run", "99", "--spp", "4"], ["run", "99", "--help"], ["check", "99.1"]):
            self.assertIn("there is no chapter '99'", self.script(*words, code=2))
        self.assertFalse((self.root / "build").exists())
        for words in (["nonsense"], ["chec"], ["own_new"], ["c.*"], ["TEXT"]):
            said = self.script(*words, code=2)
            self.assertEqual(said.count("\n"), 1, said)
            self.assertIn("./course help lists the commands", said)
        # The companion takes what the help names.
        self.assertIn("there is no chapter '99'", self.course("run", "99", "--help", code=2))
        for words in (["check", "--stars", "99"], ["ask", "--answer", "x", "99"], ["study", "--mine", "99"],
                      ["own", "judge", "x", "--part", "y", "--seed", "7"]):
            self.assertRegex(self.course(*words, code=2), "there is no (chapter|part) ", words)

    def test_in_every_language(self):
        self.use_script()
        self.write("one", "right\n")
        whole = self.script("help")
        self.script("check", "01.1")
        (self.root / "locales").mkdir()
        self.environment["LOCPATH"] = str(self.root / "locales")
        # In Turkish and Azerbaijani, neither I nor i is between A and Z; the last is not UTF-8, either.
        for language, letters in (("tr_TR", "UTF-8"), ("az_AZ", "UTF-8"), ("tr_TR", "ISO-8859-9")):
            name = f"{language}.{letters}"
            if shutil.which("localedef"):
                subprocess.run(["localedef", "-i", language, "-f", letters, self.root / "locales" / name],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if not (self.root / "locales" / name).exists():
                self.skipTest(f"there is no localedef, or it knows no {name}")
            self.environment["LC_ALL"] = name
            done = subprocess.run(["grep", "[A-Z]"], input=b"I", env=self.environment, stdout=subprocess.PIPE)
            self.assertEqual(done.stdout, b"")
            self.assertEqual(self.script("help"), whole, name)
            self.assertTrue(self.script("test", "--help").startswith("  test "), name)
            self.assertNotIn("onfiguring", self.script("check", "01.1"), name)
            shutil.rmtree(self.root / "build")
            self.assertIn("done", self.script("check", "01.1"), name)
            self.assertNotIn("onfiguring", self.script("check", "01.1"), name)

    def use_cmake(self, *names):
        """What these files of the course's folder cmake/ do is a part of CMakeLists.txt."""
        for name in names:
            with open(self.root / "CMakeLists.txt", "a") as cmake:
                cmake.write(f"include(\"{Path(SCRIPT).parent}/cmake/{name}.cmake\")\n")

    def test_a_file_of_the_future_is_built_once(self):
        self.use_script()
        self.use_cmake("Clock")
        self.write("one", "right\n")
        tomorrow = time.time() + 24 * 3600
        self.put("companion/main.cpp", "")
        for name in ("CMakeLists.txt", "companion/main.cpp"):
            for is_new in (True, False):
                if is_new:
                    shutil.rmtree(self.root / "build")
                os.utime(self.root / name, (tomorrow, tomorrow))
                self.script("check", "01.1")
                logs = [self.root / "build" / log for log in ("configure.log", "build.log")]
                said = "".join(log.read_text() for log in logs if log.exists())
                self.assertEqual(said.count("Configuring done"), 1, (name, said))
                self.assertIn(f"given the current time: 1 files, such as {name}\n", said)
                self.assertLess((self.root / name).stat().st_mtime, time.time())
                self.assertNotIn("Building", self.script("check", "01.1"), name)

    def test_flags_that_lose_infinities_are_refused(self):
        if not shutil.which("c++"):
            self.skipTest("there is no compiler named c++")
        self.use_script()
        self.use_cmake("Flags")
        cmake = (self.root / "CMakeLists.txt").read_text()
        self.put("CMakeLists.txt", cmake.replace("project(tiny NONE)", "project(tiny CXX)"))
        self.put("common/rt/real.hpp", (Path(SCRIPT).parent / "common/rt/real.hpp").read_text())
        words = ("course: the course cannot be compiled with -ffast-math, -Ofast or -ffinite-math-only: "
                 "take it out of CXXFLAGS\n")
        for flag in ("-ffast-math", "-O2 -Ofast", "-ffinite-math-only"):
            shutil.rmtree(self.root / "build")
            self.environment["CXXFLAGS"] = flag
            self.assertEqual(self.script("check", "01.1", code=1), words)
        self.environment["CXXFLAGS"] = "-O2 -ffast-math -fno-fast-math"
        self.assertIn("done", self.script("check", "01.1", code=3))
        self.environment["COURSE_CMAKE_ARGS"] = "-DCMAKE_CXX_FLAGS=-ffast-math"
        self.assertEqual(self.script("check", "01.1", code=1), words)
        del self.environment["COURSE_CMAKE_ARGS"]
        self.script("check", "01.1", code=3)
        self.assertNotIn("CMAKE_CXX_FLAGS:STRING=-ffast", (self.root / "build/CMakeCache.txt").read_text())

    def test_the_calls_of_an_answer_are_made_from_the_solution(self):
        self.use_cmake("Answers")
        with open(self.root / "CMakeLists.txt", "a") as cmake:
            cmake.write("set(course_files_01.1 rt/one.hpp)\nset(course_files_01.2 rt/two.hpp first.cpp)\n"
                        "set(course_files_01.3 first.cpp)\nset(course_helpers helper)\n"
                        "set(course_folders_01_tiny ${CMAKE_SOURCE_DIR}/solutions/01_tiny)\n"
                        "foreach(id 01.1 01.2 01.3)\n  course_bridge(01_tiny ${id})\n"
                        "  file(APPEND ${CMAKE_BINARY_DIR}/calls \"${course_call_${id}}\\n\")\nendforeach()\n")
        self.put("solutions/01_tiny/rt/one.hpp", "#pragma once\n#include <rt/real.hpp>\n#include <vector>\n\nnamespace rt {\n\n"
                 "inline constexpr Real most{1};\n\ninline int helper(int a) {\n    return a;\n}\n\n"
                 "// No inline int comment(int a) {\ninline const Real* f(const std::map<int, Real>& a, std::map<int, Real> b,\n"
                 "                     [[maybe_unused]] const int* c, int& d) {\n    return x[2];\n}\n\n"
                 "inline void g() {\n    inline_call(a) {};\n}\n\ntemplate <class T>\nint h(T t) {\n}\n\n}  // namespace rt\n")
        self.put("solutions/01_tiny/rt/two.hpp", "#pragma once\n\ntemplate <class T>\nint h(T t) {\n}\n")
        self.put("build/generated/01.1/rt/stale.hpp", "")
        self.configure()
        made = self.root / "build/generated"
        declared = (made / "01.1/rt/one.hpp").read_text()
        self.assertIn("\n#include <rt/real.hpp>\n#include <vector>\n\n", declared)
        self.assertIn("{\n\nconst Real* f(const std::map<int, Real>& a, std::map<int, Real> b, const int* c, int& d);\n"
                      "void g();\n\n}", declared)
        calls = (made / "01.1/answer.cpp").read_text()
        self.assertIn("{\n\nconst Real* f(const std::map<int, Real>& a, std::map<int, Real> const b, const int* const c, "
                      "int& d) {\n    return rt::f(a, b, c, d);\n}\n\nvoid g() {\n    rt::g();\n}\n\n}", calls)
        self.assertFalse((made / "01.1/rt/stale.hpp").exists())
        self.assertIn("#error no function in solutions/01_tiny/rt/two.hpp can be called by rule: write "
                      "tests/01_tiny/01.2/rt/two.hpp and answer.cpp\n", (made / "01.2/rt/two.hpp").read_text())
        # What is written by hand is used instead, or as well.
        before = (made / "01.1/answer.cpp").stat().st_mtime_ns
        self.put("tests/01_tiny/01.2/rt/two.hpp", "")
        self.put("tests/01_tiny/01.2/answer.cpp", "")
        (self.root / "build/calls").unlink()
        self.configure()
        self.assertEqual((self.root / "build/calls").read_text(),
                         f"{made}/01.1/answer.cpp\n{self.root}/tests/01_tiny/01.2/answer.cpp\n\n")
        self.assertFalse((made / "01.2/rt/two.hpp").exists())
        self.assertEqual((made / "01.1/answer.cpp").stat().st_mtime_ns, before)
        self.put("tests/01_tiny/01.1/answer.cpp", "")
        self.configure()
        self.assertIn('\n#include "01.1/answer.cpp"\n#include <rt/one.hpp>\n', (made / "01.1/answer.cpp").read_text())

    def test_which_tests_there_are_is_chosen_each_time(self):
        self.use_script()
        with open(self.root / "CMakeLists.txt", "a") as cmake:
            cmake.write("option(COURSE_ALL_TESTS \"\" OFF)\noption(COURSE_CHECK_STUBS \"\" OFF)\nenable_testing()\n"
                        "add_test(NAME short COMMAND true)\nadd_test(NAME 02_more.small_picture COMMAND true)\n"
                        "if(COURSE_ALL_TESTS)\n  add_test(NAME long.01.2 COMMAND true)\nendif()\n"
                        "if(COURSE_CHECK_STUBS)\n  add_test(NAME shipped.01.1 COMMAND grep todo "
                        "${CMAKE_SOURCE_DIR}/exercises/01_tiny/rt/one.hpp)\nendif()\n"
                        "add_custom_target(project_tests)\nadd_custom_target(exercise.01.1)\n"
                        "add_custom_target(chapter.01)\n")

        def tested(*words, code=0):
            said = self.script("test", *words, code=code)
            return sorted(re.findall(r"Test +#\d+: (\S+)", said)), said

        few, both = ["02_more.small_picture", "short"], ["02_more.small_picture", "long.01.2", "short"]
        self.assertEqual(tested()[0], few)
        self.assertEqual(tested("01.1")[0], ["shipped.01.1"])
        self.write("one", "right\n")
        self.assertEqual(tested("01.1", code=8)[0], ["shipped.01.1"])
        self.assertEqual(tested()[0], few)
        self.assertNotIn("onfiguring", tested()[1])
        self.assertEqual(tested("01", code=8)[0], ["02_more.small_picture", "long.01.2", "shipped.01.1"])
        self.assertEqual(tested("--all")[0], both)
        self.environment["COURSE_CMAKE_ARGS"] = "-DCOURSE_CHECK_STUBS=ON"
        self.assertEqual(tested("--all", code=8)[0], [*both[:2], "shipped.01.1", "short"])
        del self.environment["COURSE_CMAKE_ARGS"]
        self.assertNotIn("onfiguring", self.script("check", "01.1"))
        (self.root / "build/CMakeCache.txt").write_text("COURSE_ALL_TESTS:BOOL=ON\nCOURSE_CHECK_STUBS:BOOL=OFF\n")
        self.assertEqual(tested("--all")[0], both)
        self.assertIn("there is no chapter '99'", tested("99", code=2)[1])

    def test_a_damaged_build_folder_heals(self):
        self.use_script()
        self.write("one", "right\n")
        shutil.rmtree(self.root / "build")
        self.assertNotIn("is incomplete", self.script("check", "01.1"))
        self.assertIn("01.1", self.script())  # without words: the list
        self.assertNotIn("onfiguring", self.script("check", "01.1"))
        build = self.root / "build"
        rules = "build.ninja" if (build / "build.ninja").exists() else "Makefile"
        for name in (rules, "CMakeCache.txt"):
            for share in (0, 0.9):
                text = (build / name).read_bytes()
                (build / name).write_bytes(text[:int(share * len(text))])
                self.assertIn("done", self.script("check", "01.1"), (name, share))
            (build / name).unlink()
            self.assertIn("is incomplete: configuring again", self.script("check", "01.1"))
        shutil.rmtree(build / "CMakeFiles")
        self.assertIn("done", self.script("check", "01.1"))
        self.assertNotIn("onfiguring", self.script("check", "01.1"))

    def test_the_page_to_share_needs_no_node(self):
        self.use_script()
        self.write("one", "right\n")
        for words in (["--nonsense"], ["--mine", "x"], ["x"]):
            self.assertEqual(self.script("book", *words, code=2),
                             "course: book takes --mine, --mine NN.k, --serve, --url URL, --source URL or nothing\n")
        self.assertIn("./course book --mine 01.2\n", self.script("book", "01.2", code=2))
        for words in (["--url"], ["--mine", "--source"]):
            self.assertEqual(self.script("book", *words, code=2), f"course: {words[-1]} needs a URL: https://...\n")
        self.put("tools/npm", "#!/bin/sh\nexit 1\n")  # found before the real one
        self.put("tools/node", "#!/bin/sh\nexit 1\n")
        self.put("tools/apt-get", f"#!/bin/sh\necho \"$@\" >>'{self.root}/asked'\nexit 1\n")
        self.put("tools/sudo", "#!/bin/sh\n[ \"$1\" != -n ] || shift\n\"$@\"\n")
        for tool in ("npm", "node", "apt-get", "sudo"):
            os.chmod(self.root / "tools" / tool, 0o755)
        self.environment["PATH"] = f"{self.root}/tools:{os.environ['PATH']}"
        shutil.rmtree(self.root / "build")
        said = self.script("book", "--mine")
        self.assertIn("The page to share is out/mine.html.", said)
        self.assertIn("Installing with apt-get: nodejs npm\n", said)
        self.assertIn("install -y --no-install-recommends nodejs npm\n", (self.root / "asked").read_text())
        self.assertIn("Could not install npm (see build/install.log).\n", said)
        self.assertIn("The web book itself needs Node.js 18", said)
        self.assertTrue((self.root / "out/mine.html").exists())
        self.assertIn("the web book needs Node.js 18", self.script("book", code=1))

    def put_tools(self, **tools):
        """Shell scripts that are found before the real programs; a name's _ stands for -."""
        for name, text in tools.items():
            self.put(f"tools/{name.replace('_', '-')}", "#!/bin/sh\n" + text)
            os.chmod(self.root / "tools" / name.replace("_", "-"), 0o755)
        self.environment["PATH"] = f"{self.root}/tools:{os.environ['PATH']}"

    def test_what_is_missing_or_broken_is_named(self):
        self.use_script()
        shutil.rmtree(self.root / "build")
        # Neither a compiler that is old nor one that does not work is called the other.
        for said, expected in (("echo >&2 \"error: invalid value 'c++20' in '-std=c++20'\"; exit 1", "is too old: g"),
                               ("echo >&2 'xcrun: error: invalid path'; echo >&2; exit 1", "does not work; it says: xcrun: error: invalid path\n"),
                               ("exit 9", "does not work; it says: nothing, and ends with exit code 9\n")):
            self.put_tools(mycxx=said + "\n")
            self.environment["CXX"] = "mycxx"
            self.assertIn(expected, self.script("list", code=1))
        del self.environment["CXX"]
        self.put_tools(cmake="echo cmake version 3.18.4\n", apt_get="exit 1\n", sudo="exit 1\n")
        self.assertIn("CMake 3.22 or newer is needed, and this machine has 3.18.4: install", self.script("list", code=1))
        # Git Bash, which has no pacman, and another window of MSYS2, which has.
        self.environment["MSYSTEM"] = "MINGW64"
        if not shutil.which("pacman"):
            self.assertIn("Git Bash has no compiler: install MSYS2", self.script("list", code=1))
        self.put_tools(pacman=f"echo \"$@\" >>'{self.root}/asked'\nexit 1\n")
        self.assertIn("open that with the name UCRT64, not MINGW64", self.script("list", code=1))
        # MSYS2 gets LLVM's linker, if it lacks one.
        self.environment["MSYSTEM"] = "UCRT64"
        self.script("list", code=1)
        asked = (self.root / "asked").read_text()
        self.assertEqual("mingw-w64-ucrt-x86_64-lld" in asked, not shutil.which("ld.lld"))
        self.assertIn("mingw-w64-ucrt-x86_64-cmake", asked)
        # Arch: no new package lists without an upgrade of all packages.
        del self.environment["MSYSTEM"]
        (self.root / "asked").unlink()
        for tool in ("apt-get", "dnf"):
            (self.root / "tools" / tool).unlink(missing_ok=True)
        self.put_tools(sudo="[ \"$1\" != -n ] || shift\n\"$@\"\n")
        links = self.root / "links"  # all of this machine's programs but other package managers
        links.mkdir()
        for folder in os.environ["PATH"].split(":"):
            for program in Path(folder).glob("*") if folder and Path(folder).is_dir() else ():
                if program.name not in ("apt-get", "dnf", "zypper", "brew") and not (links / program.name).exists():
                    (links / program.name).symlink_to(program)
        self.environment["PATH"] = f"{self.root}/tools:{links}"
        said = self.script("list", code=1)
        self.assertIn("upgrade the system first: sudo pacman -Syu", said)
        asked = (self.root / "asked").read_text()
        self.assertIn("-S --noconfirm --needed", asked)
        self.assertNotIn("-Sy", asked)

    def test_a_folder_that_cmake_cannot_build_in_is_said(self):
        for name in ('a"b', "a;b", "a#b", "a$b", "a\\b", "a[b", "a]b", "a<b", "a>b", "a|b", "a?b", "a:b", "a\nb", "a\n"):
            self.put(name + "/course", Path(SCRIPT).read_text())
            self.put(name + "/companion/commands/commands.inc", DECLARED.read_text())
            for script, folder in ((self.root / name / "course", "."), ("./course", self.root / name)):
                if name[-1] == "\n" and folder == ".":
                    continue
                done = subprocess.run(["sh", str(script), "check"], cwd=folder, text=True, stderr=subprocess.PIPE,
                                      stdout=subprocess.PIPE)
                self.assertEqual(done.returncode, 1)
                self.assertEqual(done.stdout, "")
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertIn("CMake cannot build in a folder whose name", done.stderr)

    def test_a_read_only_course_is_named(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        self.use_script()
        (self.root / "build").chmod(0o555)
        said = self.script("demo", code=1)
        (self.root / "build").chmod(0o755)
        self.assertEqual(said, f"course: cannot write to the folder {self.root}/build\n")

    def test_odd_folder_names_build_once(self):
        self.use_script()
        self.write("one", "right\n")
        shutil.rmtree(self.root / "build")
        for name in ("o'neil", "a&b", "a*b", "a`b", "a^b"):
            self.environment["COURSE_TEST_FOLDER"] = str(self.root / name)
            shutil.copytree(self.root, self.root / name, ignore=shutil.ignore_patterns("o?neil", "a?b"))
            done = subprocess.run(["sh", str(self.root / name / "course"), "check", "01.1"], env=self.environment,
                                  text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, timeout=120)
            self.assertEqual(done.returncode, 0, done.stdout)
            # ninja reads no dependency in such a folder.
            self.assertFalse((self.root / name / "build/build.ninja").exists(), name)

    # ---- known mistakes ----------------------------------------------------------------------

    def add_mistakes(self):
        """Four mistakes of 01.1. The compiler notes each that it begins, and finishes when let()."""
        self.put("solutions/01_tiny/rt/one.hpp", "int f() {\n    return 2;\n}\n")
        text = "# Mistakes of 01.1\n"
        for name, fails in (("unlike", "other"), ("twin", "wrong"), ("meant", "wrong"), ("passes", "passes")):
            test = "01.1 another" if name == "passes" else "01.1 the answer is right"
            text += (f"\n## 01.1_{name}\ntitle: the {name}\ncaught by: {test}\n\nIt is {name}.\n\n"
                     f"```diff rt/one.hpp\n-    return 2;\n+    return {fails} + {name};\n```\n")
        self.put("tests/mistakes/01_tiny/01.1.md", text)
        self.put("build/compile_commands.json", json.dumps([
            {"directory": str(self.root), "file": "answer.cpp",
             "command": "./compiler.sh of/answer.01.1.dir/ -o x.o -c answer.cpp"}]))
        self.put("build/link/answer.01.1.txt", "\n")
        self.put("compiler.sh", """#!/bin/sh
folder=${1#-I}
for word in "$@"; do result=$word; done
case $* in
    *' -c '*) ;;
    *)
        cp "$result.answer.cpp.o" "$result"
        exit
        ;;
esac
name=${folder##*_}
echo "$name" >>begun
until [ -e "let-$name" ]; do sleep 0.02; done
cp "$folder/rt/one.hpp" "$result"
""")
        os.chmod(self.root / "compiler.sh", 0o755)
        # It judges the answer of the environment, or else the learner's.
        self.put("check.sh", """#!/bin/sh
[ ! -e "check/check.$1" ] || exit 0
mkdir -p check
cat >"check/check.$1" <<END
#!/bin/sh
answer=\\$(ls "\\$COURSE_ANSWER"/*answer.01.1* 2>/dev/null | head -n 1)  # libanswer.01.1.so
[ -n "\\$answer" ] || answer='$2'
event() { printf '%s\\\\n' "\\$COURSE_EVENTS \\$*" >&3; }
event '{"event":"cases","cases":[{"name":"01.1 the answer is right"},{"name":"01.1 another"}]}'
event '{"event":"begins","name":"01.1 the answer is right"}'
for word in wrong other; do
    ! grep -q \\$word "\\$answer" || event '{"event":"failed","macro":"CHECK","expression":"'\\$word'",' \\
        '"expanded":"3 == 2","messages":[{"text":"expected 2, but yours gives 3","expected":"2"}]}'
done
if grep -q 'wrong\\|other' "\\$answer"; then passed=false; else passed=true; fi
event '{"event":"ends","passed":'\\$passed',"output":""}'
event '{"event":"begins","name":"01.1 another"}'
event '{"event":"ends","passed":true,"output":""}'
[ \\$passed = true ]
END
chmod +x "check/check.$1"
""")

    def let(self, *names):
        for name in names:
            self.put(f"let-{name}", "")

    def begun(self):
        file = self.root / "begun"
        return file.read_text().split() if file.exists() else []

    def test_the_verdict_comes_before_the_likeliest_mistake_and_that_before_the_others(self):
        self.add_mistakes()
        self.write("one", "int f() {\n    return wrong + meant;\n}\n")
        with Terminal([COURSE, "check", "01.1"], self.environment) as terminal:
            terminal.expect("failing: 1 of 2 test cases")
            terminal.expect("expected 2, but yours gives 3")
            terminal.expect("comparing with known mistakes")
            self.let("meant")
            terminal.expect("This looks like: the meant")
            terminal.expect("comparing with known mistakes")
            self.let("twin", "unlike")
            terminal.expect("or like: the twin")
            terminal.expect("Read docs/01-tiny.md")
            self.assertEqual(terminal.end(), 1)
        self.assertIn("meant", self.begun()[:os.cpu_count()])  # that many are tried at a time
        self.assertEqual(sorted(self.begun()), ["meant", "twin", "unlike"])  # what cannot be is not tried

        # From now on they are known; and a pipe gets the same in the same order.
        said = self.course("check", "01.1", code=1)
        self.assertEqual(len(self.begun()), 3)
        parts = ["failing: 1 of 2", "expected 2, but yours gives 3", "This looks like: the meant", "It is meant",
                 "or like: the twin", "It is twin", "Read docs/01-tiny.md"]
        self.assertEqual([said.count(part) for part in parts], [1] * len(parts), said)
        self.assertEqual(sorted(said.index(part) for part in parts), [said.index(part) for part in parts])
        self.assertNotIn("comparing", said)
        self.assertFalse((self.root / "build/mistakes/01.1_meant").exists())

    def test_the_test_case_that_catches_a_known_mistake_is_the_one_shown(self):
        self.add_mistakes()
        mistakes = (self.root / "tests/mistakes/01_tiny/01.1.md").read_text()
        self.put("tests/mistakes/01_tiny/01.1.md", mistakes.replace(
            "the meant\ncaught by: 01.1 the answer is right", "the meant\ncaught by: 01.1 another"))
        begins = """event '{"event":"begins","name":"01.1 another"}'\n"""
        check = (self.root / "check.sh").read_text()
        self.put("check.sh", check.replace(begins, begins + """! grep -q meant "\\$answer" || \\
    event '{"event":"failed","macro":"CHECK","expression":"more","expanded":"5 == 4","messages":[]}' || true
if grep -q meant "\\$answer"; then event '{"event":"ends","passed":false,"output":""}'; exit 1; fi
"""))
        self.let("meant", "twin", "unlike", "passes")
        self.write("one", "int f() {\n    return wrong + meant;\n}\n")
        first, second = "01.1 the answer is right", "01.1 another"
        for shown, other in ((first, second), (second, first)):  # unknown, then known
            said = self.course("check", "01.1", code=1)
            self.assertIn(f"one.hpp\n\n  {shown}\n    ", said)
            self.assertIn(f"  Also failing:\n    {other}\n", said)
            self.assertIn("This looks like: the meant\n", said)

    def test_a_save_ends_the_search_for_a_mistake(self):
        self.add_mistakes()
        self.write("one", "int f() {\n    return wrong;\n}\n")
        with self.watched("01") as terminal:
            terminal.expect("comparing with known mistakes")
            self.write("one", "right\n")
            terminal.expect("01.1 .*done", 5)
            self.assertNotIn("like: ", terminal.said)
        self.let("meant", "twin", "unlike")
        self.write("one", "int f() {\n    return wrong;\n}\n")
        said = self.course("check", "01.1", code=1)  # what was cut off has not been taken for a result
        self.assertIn("This looks like: ", said)
        self.assertIn("or like: ", said)

    # ---- building ahead ----------------------------------------------------------------------

    def build_ahead_slowly(self):
        """Each target that can be built ahead notes that it begins, and ends when let()."""
        self.put("slow.sh", """#!/bin/sh
echo "$1 $$" >>"$2/begun"
until [ -e "$2/let-$1" ]; do sleep 0.02; done
""")
        cmake = (self.root / "CMakeLists.txt").read_text()
        for target in ("check_runtime", "check.01.1", "check.01.2"):
            cmake = cmake.replace(f"add_custom_target({target})\n", "")
            cmake += (f"add_custom_command(OUTPUT {target}.built COMMAND sh ${{CMAKE_SOURCE_DIR}}/slow.sh {target} "
                      f"${{CMAKE_SOURCE_DIR}} COMMAND ${{CMAKE_COMMAND}} -E touch {target}.built VERBATIM)\n"
                      f"add_custom_target({target} DEPENDS {target}.built)\n")
        self.put("CMakeLists.txt", cmake)
        self.configure()

    def in_a_shell(self):
        """A terminal in which ./course has run, and that stays open."""
        return Terminal(["/bin/sh", "-c", f"'{COURSE}'; echo 'the prompt'; cat"], self.environment)

    @staticmethod
    def runs(process):
        return subprocess.run(["ps", "-p", process], stdout=subprocess.DEVNULL, check=False).returncode == 0

    def is_ahead(self):
        return (self.root / "build/building-ahead").exists()

    def test_what_checks_need_is_built_ahead_once(self):
        self.build_ahead_slowly()
        with self.in_a_shell() as shell:
            shell.expect("the prompt")
            self.wait_for(lambda: self.begun()[::2] == ["check_runtime"])
            self.write("one", "right\n")
            with Terminal([COURSE, "check", "01.1"], self.environment) as check:
                check.expect("waiting for what all checks need")
                self.let("check.01.1", "check.01.2")
                time.sleep(0.3)
                self.assertEqual(self.begun()[::2], ["check_runtime"])  # nobody builds beside it
                self.let("check_runtime")
                check.expect("01.1 .*done")
                self.assertEqual(check.end(), 0)
            self.wait_for(lambda: (self.root / "build/prepared").exists() and not self.is_ahead())
            self.assertEqual(sorted(self.begun()[::2]), ["check.01.1", "check.01.2", "check_runtime"])
        # All is there: it does not begin again.
        (self.root / "build/check_runtime.built").unlink()
        with self.in_a_shell() as shell:
            shell.expect("the prompt")
            time.sleep(0.5)
            self.assertEqual(len(self.begun()[::2]), 3)

    def test_building_ahead_ends_with_the_terminal_and_on_request(self):
        self.build_ahead_slowly()

        for way in ("closes", "ends", "asked"):
            with self.subTest(way=way):
                with self.in_a_shell() as shell:
                    shell.expect("the prompt")
                    (self.root / "begun").unlink(missing_ok=True)
                    self.wait_for(lambda: len(self.begun()) == 2)
                    self.assertTrue(self.is_ahead())
                    process = self.begun()[1]
                    if way == "asked":
                        self.course("prepare", "--end")
                        self.assertFalse(self.runs(process))
                    elif way == "ends":
                        shell.press("\x04")
                        shell.end()
                self.wait_for(lambda: not self.runs(process) and not self.is_ahead())
                self.assertFalse((self.root / "build/prepared").exists())

    def test_building_ahead_ends_on_request_while_it_waits_for_its_turn(self):
        self.build_ahead_slowly()
        self.put("patient.sh", 'echo x >"$1/started"\nuntil [ -e "$1/let-patient" ]; do sleep 0.02; done\n')
        self.put("CMakeLists.txt", (self.root / "CMakeLists.txt").read_text().replace(
            "/check.sh 01.1 ", "/patient.sh ${CMAKE_SOURCE_DIR} COMMAND sh ${CMAKE_SOURCE_DIR}/check.sh 01.1 ", 1))
        self.configure()
        self.let("check_runtime", "check.01.1", "check.01.2")
        self.write("one", "right\n")
        process = subprocess.Popen([COURSE, "check", "01.1"], env=self.environment, stdout=subprocess.DEVNULL)
        self.wait_for((self.root / "started").exists)
        with self.in_a_shell() as shell:
            shell.expect("the prompt")
            self.wait_for(self.is_ahead)
            self.course("prepare", "--end")
            self.assertFalse(self.is_ahead())
        self.let("patient")
        self.assertEqual(process.wait(20), 0)
        self.assertNotIn("check_runtime", self.begun())

    def test_the_script_builds_nothing_beside_what_is_built_ahead(self):
        self.use_script()
        self.build_ahead_slowly()
        self.script("list")
        with Terminal(["/bin/sh", "-c", f"sh '{self.root}/course'; echo 'the prompt'; cat"], self.environment) as shell:
            shell.expect("the prompt")
            self.wait_for(lambda: len(self.begun()) == 2)
            process = self.begun()[1]
            self.put("CMakeLists.txt", (self.root / "CMakeLists.txt").read_text())  # the companion is built again
            self.assertIn("Building: done", self.script("list"))
            self.assertFalse(self.runs(process))
            self.assertFalse(self.is_ahead())

    def test_nothing_is_built_ahead_without_a_terminal_unless_asked(self):
        self.build_ahead_slowly()
        self.let("check_runtime", "check.01.1", "check.01.2")
        self.course("list")
        time.sleep(0.5)
        self.assertEqual(self.begun(), [])
        self.assertFalse(self.is_ahead())
        said = self.course("prepare")
        self.assertEqual(said, "Building what all checks need.\nBuilding the test cases of 01.1.\n"
                               "Building the test cases of 01.2.\n")
        self.assertEqual(self.begun()[::2], ["check_runtime", "check.01.1", "check.01.2"])
        self.assertFalse(self.is_ahead())

    def test_what_cannot_be_built_ahead_is_tried_once_and_said_when_asked(self):
        self.put("fails.sh", 'echo x >>"$1/begun"\nexit 1\n')
        self.put("CMakeLists.txt", (self.root / "CMakeLists.txt").read_text() +
                 "add_custom_target(check_runtime COMMAND sh ${CMAKE_SOURCE_DIR}/fails.sh ${CMAKE_SOURCE_DIR} VERBATIM)\n")
        self.configure()
        for _ in range(2):
            with self.in_a_shell() as shell:
                shell.expect("the prompt")
                self.wait_for(lambda: (self.root / "build/prepared").exists() and not self.is_ahead())
                time.sleep(0.3)
                self.assertEqual(self.begun(), ["x"])
        done = subprocess.run([COURSE, "prepare"], env=self.environment, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("check_runtime cannot be built", done.stderr)

    # ---- watch -------------------------------------------------------------------------------

    def test_watch_without_a_terminal(self):
        said = self.course("watch", code=3)
        self.assertIn("Next: 01.1", said)
        process = subprocess.Popen([COURSE, "watch", "01"], env=self.environment, text=True,
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        process.stdin.write("h\nq\n")
        process.stdin.flush()
        said, _ = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 0)
        self.assertIn("idea", said)
        self.assertNotIn("\033", said)
        self.write("one", "right\n")
        self.write("two", "right\n")
        said = self.course("watch", "01")
        self.assertIn("Chapter 01 is done", said)
        self.assertIn("Every exercise passes", said)

    def watched(self, *words):
        return Terminal([COURSE, "watch", *words], self.environment)

    def test_watch_checks_on_save_and_moves_on(self):
        self.add_second_chapter()
        with self.watched("01") as terminal:
            terminal.expect("Next: .*01.1 Number one")
            self.assertFalse(terminal.echoes())
            self.write("one", "wrong\n")
            terminal.expect("expected 2, but yours gives 3")
            # As most editors save: into another file, which is then renamed.
            self.write("new", "right\n")
            self.stub("new").rename(self.stub("one"))
            terminal.expect("01.1 .*done")
            terminal.expect("Next: .*01.2 Number two")
            terminal.press("h")
            terminal.expect("idea")
            terminal.press("l")
            terminal.expect("1 of 3 exercises")
            terminal.press("r")
            terminal.expect("program --out")
            terminal.press("x")
            self.write("two", "right\n")
            terminal.expect("Chapter 01 is done")
            terminal.expect("Next: .*02.1 Number three")
            self.write("one", "right\nstar one open\n")
            terminal.expect(r"core passes.*, .*1 star open.* \(\./course check 01\.1 --stars shows it\)")
            terminal.expect("Next: .*02.1 Number three")
            self.put("exercises/02_more/rt/three.hpp", "right\n")
            terminal.expect("Chapter 02 is done")
            terminal.expect("Every exercise passes")
            self.write("one", "right\n")
            terminal.expect("01.1 .*done")
            terminal.press("q")
            self.assertEqual(terminal.end(), 0)
            self.assertTrue(terminal.echoes())

    def test_watch_says_that_a_file_has_gone(self):
        with self.watched("01") as terminal:
            terminal.expect("q quit")
            self.stub("one").unlink()
            terminal.expect(r"one\.hpp is missing; \./course reset 01\.1")
            self.write("one", "right\n")
            terminal.expect("01.1 .*done")
            # An editor that removes a file before it writes it anew is no trouble.
            self.stub("two").unlink()
            time.sleep(0.3)
            self.write("two", "right\n")
            terminal.expect("01.2 .*done")
            self.assertNotIn("is missing", terminal.said)

    def test_watch_restores_the_terminal(self):
        for how in ("q", "\x03", signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            with self.subTest(how=how), self.watched() as terminal:
                terminal.expect("q quit")
                self.assertFalse(terminal.echoes())
                if isinstance(how, str):
                    terminal.press(how)
                else:
                    os.kill(terminal.process, how)
                code = terminal.end()
                self.assertEqual(code, 0 if how == "q" else -int(how) if not isinstance(how, str)
                                 else -signal.SIGINT)
                self.assertTrue(terminal.echoes())

    def test_watch_stops_and_goes_on(self):
        with self.watched() as terminal:
            terminal.expect("q quit")
            os.kill(terminal.process, signal.SIGTSTP)  # as Ctrl-Z does
            _, status = os.waitpid(terminal.process, os.WUNTRACED)
            self.assertTrue(os.WIFSTOPPED(status))
            self.assertTrue(terminal.echoes())
            os.kill(terminal.process, signal.SIGCONT)  # as fg does
            terminal.press("l")
            terminal.expect("0 of 2 exercises")
            self.assertFalse(terminal.echoes())
            terminal.press("q")
            self.assertEqual(terminal.end(), 0)

    def test_watch_survives_a_crash_and_an_interruption_ends_what_runs(self):
        with self.watched("01") as terminal:
            terminal.expect("q quit")
            self.write("one", "crash\n")
            terminal.expect("It crashes")
            self.write("one", "endless\n")
            terminal.expect("checking 01.1")
            time.sleep(1)
            started = time.time()
            terminal.press("\x03")
            self.assertEqual(terminal.end(), -signal.SIGINT)
            self.assertLess(time.time() - started, 5)
            self.assertTrue(terminal.echoes())


class Terminal:
    """A program on a pseudo terminal."""

    def __init__(self, command, environment):
        self.here, self.there = pty.openpty()
        self.process = os.fork()
        if self.process == 0:
            os.setsid()
            for descriptor in range(3):
                os.dup2(self.there, descriptor)
            os.close(os.open(os.ttyname(0), os.O_RDWR))  # makes it the controlling terminal
            os.closerange(3, 64)
            os.execve(command[0], command, environment)
        self.said = ""
        self.code = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.code is None:
            os.kill(self.process, signal.SIGKILL)
            os.waitpid(self.process, 0)
        os.close(self.here)
        os.close(self.there)

    def read(self, seconds):
        if select.select([self.here], [], [], seconds)[0]:
            self.said += os.read(self.here, 65536).decode(errors="replace")

    def expect(self, pattern, seconds=20):
        end = time.time() + seconds
        while time.time() < end:
            found = re.search(pattern, self.said)
            if found:
                self.said = self.said[found.end():]
                return
            self.read(0.1)
        raise AssertionError(f"{pattern!r} did not come; instead: {self.said[-2000:]!r}")

    def press(self, key):
        os.write(self.here, key.encode())

    def echoes(self):
        flags = termios.tcgetattr(self.there)[3]
        return bool(flags & termios.ECHO) and bool(flags & termios.ICANON)

    def end(self, seconds=20):
        end = time.time() + seconds
        while time.time() < end:
            self.read(0.05)
            ended, status = os.waitpid(self.process, os.WNOHANG)
            if ended:
                self.code = os.waitstatus_to_exitcode(status)
                return self.code
        raise AssertionError(f"it does not end; it said: {self.said!r}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
