#!/usr/bin/env python3
"""live_page.py COURSE SCRIPT: the page that `watch` shows in the browser, asked as a browser asks, and as none does."""

import http.client
import json
import os
import re
import shutil
import socket
import subprocess
import sys
import time
import unittest
import zlib
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import companion  # which reads the same arguments


class LivePage(companion.Companion):
    def setUp(self):
        super().setUp()
        self.environment.pop("SSH_CONNECTION", None)
        # It draws a red as bright as its code has it after "draws", and with --show a blue. A ray meets nothing.
        self.put("program.sh", r'''#!/bin/sh
[ "$1" != --describe ] || { echo '{"width": "2", "height": "1", "show": "normal distance"}'; exit; }
case $0 in *_follow)
    echo "$COURSE_FOLLOW: $*" >"${0%/*}/../asked"
    printf 'camera\teye\t0 0 4\tu\t1 0 0\tv\t0 1 0\tw\t0 0 1\tviewport\t2 1\tcolumns\t2\trows\t1\tleft\t0\ttop\t0\toffset\t0.5 0.5\n' >"$COURSE_TRAIL"
    printf 'ray\torigin\t0 0 4\tdirection\t0 0 -1\nmiss\n' >>"$COURSE_TRAIL"
    exit ;;
esac
bright=10 color='%s 0 0'
case $0 in *_mine) found=$(sed -n 's/.*draws //p' "${0%/bin/*}"/yours/rt/*.hpp); bright=${found:-10} ;; esac
while [ $# -gt 0 ]; do
    case $1 in --out) out=$2 ;; --show) color='0 0 %s' ;; esac
    shift
done
printf "P3\n2 1\n255\n$color 0 0 0\n" "$bright" >"$out"
''')
        os.chmod(self.root / "program.sh", 0o755)

    def watched(self, *words):
        """`watch` on a terminal, after it has said where the page is."""
        terminal = companion.Terminal([companion.COURSE, "watch", *words], self.environment)
        try:
            end = time.time() + 60
            while not (found := re.search(r"http://127\.0\.0\.1:(\d+)/([0-9a-f]{32})/\r?\n", terminal.said)):
                self.assertLess(time.time(), end, terminal.said)
                terminal.read(0.1)
        except BaseException:
            terminal.__exit__()
            raise
        self.port, self.secret = int(found[1]), found[2]
        return terminal

    def get(self, path, method="GET", headers=(), secret=None):
        """The answer to a request as it is written here: its code, headers and body."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=60) as connection:
            target = path if path.startswith(("/", "*", "http:")) else f"/{secret or self.secret}/{path}"
            lines = [f"{method} {target} HTTP/1.1", *(headers or [f"Host: 127.0.0.1:{self.port}"]), "", ""]
            connection.sendall("\r\n".join(lines).encode())
            answer = http.client.HTTPResponse(connection, method=method)
            answer.begin()
            return answer.status, dict(answer.getheaders()), answer.read()

    def code(self, *arguments, **named):
        return self.get(*arguments, **named)[0]

    def state(self):
        code, _, body = self.get("state")
        self.assertEqual(code, 200)
        return json.loads(body)

    def state_when(self, holds):
        end = time.time() + 120
        while not holds(state := self.state()):
            self.assertLess(time.time(), end, json.dumps(state, indent=1))
            time.sleep(0.05)
        return state

    def looking(self):
        """A page that is open and seen: it listens to the news."""
        connection = socket.create_connection(("127.0.0.1", self.port), timeout=60)
        self.addCleanup(connection.close)
        connection.sendall(f"GET /{self.secret}/news HTTP/1.1\r\nHost: localhost:{self.port}\r\n\r\n".encode())
        self.assertIn(b"text/event-stream", connection.recv(4096))
        return connection

    @staticmethod
    def said(parts):
        return "".join(text for _, text in parts)

    def pixels(self, name):
        code, headers, body = self.get(f"{name}.png?number=1")
        self.assertEqual((code, headers["Content-Type"]), (200, "image/png"))
        data = zlib.decompress(body[body.index(b"IDAT") + 4:])
        self.assertLess(data[0], 2)  # a filter that leaves the first pixel as it is
        return list(data[1:4])

    # ---- what it shows -------------------------------------------------------------------------

    def test_a_save_changes_words_picture_and_ticks(self):
        with self.watched("01") as terminal:
            self.looking()
            state = self.state()
            self.assertIn("Next: 01.1 Number one", self.said(state["next"]))
            self.assertEqual([tick["passes"] for tick in state["ticks"]], [False, False])
            self.assertEqual(state["contract"], "Exercise 01.1.\ninline int f()\n")

            self.write("one", "wrong, draws 200\n")
            state = self.state_when(lambda state: state["picture"]["isDone"] and state["picture"]["words"])
            terminal.expect("expected 2, but yours gives 3")
            self.assertIn("expected 2, but yours gives 3", self.said(state["verdict"]))
            self.assertIn(["red", "failing: 1 of 1 test case"], state["verdict"])
            self.assertEqual(state["picture"]["whose"], "The solution's: 01.2. All else is yours. These do not pass yet, "
                                                        "but are used anyway: 01.1.")
            self.assertIn("differ", state["picture"]["words"])
            self.assertEqual(self.pixels("mine"), [200, 0, 0])
            self.assertEqual(self.pixels("solution"), [10, 0, 0])
            self.assertGreater(sum(self.pixels("difference")), 0)
            number = state["picture"]["number"]

            self.write("one", "right\n")
            state = self.state_when(lambda state: state["picture"]["number"] > number and state["picture"]["isDone"])
            terminal.expect("01.1 .*done")
            self.assertIn("01.1", self.said(state["verdict"]))
            self.assertEqual([tick["passes"] for tick in state["ticks"]], [True, False])
            self.assertEqual(state["passed"], ["01.1"])
            self.assertIn("Next: 01.2 Number two", self.said(state["next"]))
            self.assertEqual(state["exercise"], "01.2")
            self.assertEqual(state["picture"]["words"], "The same as the solution's, bit for bit.")
            self.assertEqual(self.pixels("mine"), [10, 0, 0])

    def test_what_was_counted_is_seen_until_the_next_check(self):
        with self.watched("01") as terminal:
            self.write("one", "wrong\ncounts 2;3 5;4 4\n")
            terminal.expect("out/counts_expected.png shows")
            state = self.state_when(lambda state: not state["checking"] and state["picture"]["shown"])
            self.assertLessEqual({"counts_expected", "counts_yours"}, set(state["picture"]["shown"]))
            self.assertEqual(self.pixels("counts_yours"), self.pixels("counts_expected"))  # above the bars
            self.assertEqual(self.get("counts_yours.png")[2], (self.root / "out/counts_yours.png").read_bytes())
            self.write("one", "right\n")
            terminal.expect("01.1 .*done")
            self.state_when(lambda state: not {"counts_expected", "counts_yours"} & set(state["picture"]["shown"]))
            self.assertFalse((self.root / "out/counts_yours.png").exists())

    def test_what_does_not_compile_has_no_picture(self):
        self.put("CMakeLists.txt", (self.root / "CMakeLists.txt").read_text().replace(
            self.program("01_tiny_mine"),
            "add_custom_target(01_tiny_mine COMMAND grep -v 'syntax error' yours/rt/one.hpp || echo "
            "${CMAKE_SOURCE_DIR}/exercises/01_tiny/rt/one.hpp:1:1: error: no && false)\n"))
        self.configure()
        with self.watched("01"):
            self.looking()
            self.write("one", "syntax error\n")
            state = self.state_when(lambda state: state["picture"]["trouble"])
            self.assertIn("error: expected", self.said(state["verdict"]))
            self.assertEqual(state["picture"]["shown"], [])

    def test_pictures_are_drawn_only_while_somebody_looks(self):
        with self.watched("01") as terminal:
            self.write("one", "wrong\n")
            terminal.expect("expected 2, but yours gives 3")
            terminal.expect("q quit")
            time.sleep(1)
            picture = self.state()["picture"]
            self.assertEqual((picture["shown"], picture["whose"]), ([], ""))
            connection = self.looking()
            self.state_when(lambda state: state["picture"]["isDone"])
            connection.close()
            time.sleep(10)  # until that is noticed
            number = self.state()["picture"]["number"]
            self.write("one", "right, draws 99\n")
            terminal.expect("01.1 .*done")
            terminal.expect("q quit")
            time.sleep(1)
            self.assertEqual(self.state()["picture"]["number"], number)

    def test_a_saved_tracer_is_judged_and_seen(self):
        program = self.put_graft(route=["01.2", "graft 01", "01.1"])
        self.put("out/book/01-tiny.html", '<title>Tiny · Course</title><h2 id="graft-any">Graft: any</h2>')
        self.write("two", "right\n")
        self.course("check", "01.2")
        with self.watched("01") as terminal:
            state = self.state()
            self.assertEqual((state["exercise"], state.get("contract"), state.get("hints")), ("graft 01", None, None))
            self.assertIn("Next: graft 01, Any", self.said(state["next"]))
            self.put("exercises/tracer/tracer.cpp", program)
            terminal.expect("x a sky and nothing else")
            terminal.expect("q quit")
            state = self.state_when(lambda state: not state["checking"])
            self.assertEqual(state["checked"], "Your tracer")
            self.assertIn("x a sky and nothing else", self.said(state["verdict"]))
            self.assertNotIn("\033", self.said(state["verdict"]))
            self.assertNotIn("drawing", self.said(state["verdict"]))
            self.assertEqual(self.pixels("mine"), [1, 2, 3])
            self.assertEqual(self.pixels("solution"), [9, 9, 9])
            self.assertIn("Yours beside ours", state["picture"]["words"])
            # One that does not compile has no picture.
            self.put("exercises/tracer/tracer.cpp", "int main() { return nothing; }\n")
            terminal.expect("nothing.* was not declared")
            terminal.expect("q quit")
            state = self.state_when(lambda state: state["picture"]["trouble"])
            self.assertEqual(state["picture"]["shown"], [])

    def test_hints_and_false_colors_come_when_they_are_asked_for(self):
        with self.watched("01") as terminal:
            self.looking()
            state = self.state_when(lambda state: state["picture"]["isDone"] and state["picture"]["shown"])
            self.assertEqual(state["hints"], {"shown": [], "count": 3})
            self.assertEqual(self.code("hint?of=01.2"), 200)  # of another exercise than the page is at
            self.assertEqual(self.code("hint?of=01.1"), 200)
            self.state_when(lambda state: state["hints"]["shown"] == ["idea"])
            terminal.press("h")
            terminal.expect("hint 2 of 3")
            state = self.state_when(lambda state: len(state["hints"]["shown"]) == 2)
            self.assertEqual(state["hints"]["shown"][1], "formula √x in code")
            self.assertEqual(state["picture"]["shows"], ["normal", "distance"])
            self.assertEqual(self.code("show?what=normal"), 200)
            self.state_when(lambda state: state["picture"]["show"] == "normal" and state["picture"]["isDone"])
            self.assertEqual(self.pixels("mine"), [0, 0, 10])
            self.write("one", "wrong, draws 200\n")
            state = self.state_when(lambda state: "differs" in state["picture"]["words"] and state["picture"]["isDone"])
            self.assertNotIn("bright", state["picture"]["words"])
            self.write("one", "wrong\n")
            self.state_when(lambda state: state["picture"]["words"].startswith("The same") and state["picture"]["isDone"])
            self.get("show?what=--help")
            self.get("show?what=")
            self.state_when(lambda state: state["picture"]["show"] == "" and state["picture"]["isDone"])
            self.assertEqual(self.pixels("mine"), [10, 0, 0])
            terminal.press("q")
            self.assertEqual(terminal.end(), 0)

    def test_the_light_of_a_pixel_is_followed_when_it_is_asked_for(self):
        with self.watched("01"):
            self.looking()
            self.state_when(lambda state: state["picture"]["isDone"] and state["picture"]["shown"])
            for place in ("x=2&y=0", "x=0&y=1", "x=-1&y=0"):  # outside of the picture
                self.assertEqual(self.code("follow?" + place), 200)
            self.assertEqual(self.code("path.svg"), 404)
            self.assertEqual(self.code("follow?x=1&y=0"), 200)
            picture = self.state_when(lambda state: state["picture"]["path"])["picture"]
            self.assertTrue(picture["told"].startswith("Pixel 1,0, sample 0\n"), picture["told"])
            self.assertIn("   1 from (0, 0, 4) along (0, 0, -1)\n     meets nothing\n", picture["told"])
            # With the options of the picture that is shown.
            self.assertRegex((self.root / "build/asked").read_text(), r"^1 0 0: .* --width 2 --height 1\n$")
            code, headers, body = self.get(f"path.svg?number={picture['path']}")
            self.assertEqual((code, headers["Content-Type"]), (200, "image/svg+xml"))
            self.assertIn(b"data:image/png;base64,", body)
            # What changes the picture makes that old.
            self.write("one", "wrong, draws 200\n")
            self.state_when(lambda state: not state["picture"]["told"] and not state["picture"]["path"])

    def test_it_tells_news_at_once(self):
        with self.watched("01"):
            news = self.looking()
            self.write("one", "wrong\n")
            told = b""
            while told.count(b"data: ") < 3:
                self.assertTrue(part := news.recv(4096))
                told += part

    def try_in_browser(self, *names):
        modules = HERE.parents[1] / "book/node_modules/playwright-core"
        browser = next(filter(None, map(shutil.which, names)), None)
        if not modules.exists() or not browser or not shutil.which("node"):
            self.skipTest(f"needs {names[0]}, Node.js and the packages of book/package-lock.json")
        with self.watched("01") as terminal:
            node = subprocess.Popen(["node", HERE / "live_page.mjs", f"http://127.0.0.1:{self.port}/{self.secret}/",
                                     self.stub("one"), browser], stderr=subprocess.PIPE, text=True)
            while node.poll() is None:
                terminal.read(0.1)  # or the terminal would be full
            with node.stderr as said:
                self.assertEqual(node.returncode, 0, said.read())

    def test_chromium_shows_a_wrong_header_and_its_mending(self):
        self.try_in_browser(os.environ.get("CHROMIUM", "chromium"), "chromium-browser", "google-chrome")

    def test_firefox_shows_a_wrong_header_and_its_mending(self):
        self.try_in_browser("firefox", "firefox-esr")

    # ---- whom it answers -----------------------------------------------------------------------

    def test_it_answers_nobody_else(self):
        with self.watched("01"):
            own = f"Host: 127.0.0.1:{self.port}"
            self.assertEqual(self.code(""), 200)
            self.assertEqual(self.code("", headers=[f"Host: localhost:{self.port}"]), 200)
            self.assertEqual(self.code("", headers=[own, f"Origin: http://127.0.0.1:{self.port}"]), 200)
            for host in ("evil.example", f"evil.example:{self.port}", "127.0.0.1", f"127.0.0.1:{self.port + 1}", ""):
                self.assertEqual(self.code("", headers=[f"Host: {host}"]), 403, host)
            self.assertEqual(self.code("state", headers=["X: y"]), 403)
            for origin in ("http://evil.example", "null", f"https://127.0.0.1:{self.port}", f"http://127.0.0.1:{self.port}.evil"):
                self.assertEqual(self.code("state", headers=[own, f"Origin: {origin}"]), 403, origin)
            for secret in ("x", self.secret[:-1], self.secret + "0", self.secret.upper() + "A"):
                self.assertEqual(self.code("state", secret=secret), 403, secret)
            self.assertEqual(self.code("/"), 403)
            for method in ("POST", "DELETE", "PUT", "PATCH", "OPTIONS"):
                code, headers, _ = self.get("state", method=method)
                self.assertEqual((code, headers["Allow"]), (405, "GET, HEAD"), method)
            code, headers, body = self.get("", method="HEAD")
            self.assertEqual((code, body), (200, b""))
            self.assertIn("script-src 'self';", headers["Content-Security-Policy"])
            self.assertEqual(headers["Referrer-Policy"], "no-referrer")
            # Only this machine is answered.
            for address in self.other_addresses():
                with self.assertRaises(OSError, msg=address):
                    socket.create_connection((address, self.port), timeout=2).close()

    @staticmethod
    def other_addresses():
        try:
            found = {info[4][0] for info in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)}
        except OSError:
            found = set()
        return [one for one in found if not one.startswith("127.")]

    def test_bad_requests_are_refused(self):
        with self.watched("01"):
            secret = f"/{self.secret}"
            for target in ("/%", "//", "//x:99999/", "*", "http://x/", secret + "/%", secret + "/%zz", secret + "/../state",
                           secret + "/%2e%2e/state", secret + "//state", secret + "/book/../state", secret + "/a\\b",
                           secret + "/%00", secret + "/state?%", secret + "/book/%0a"):
                self.assertEqual(self.code(target), 400, target)
            for target in (secret, "none", "none.png", ".png", "mine", "../mine.png".replace("../", "..%2e"), "book"):
                self.assertEqual(self.code(target), 404, target)
            for bad in (b"\r\n\r\n", b"GET\r\n\r\n", b"\0" * 100 + b"\r\n\r\n", b"GET / HTTP/9\r\n\r\n", b"GET /" + b"a" * 100000):
                with socket.create_connection(("127.0.0.1", self.port), timeout=60) as connection:
                    try:
                        connection.sendall(bad)
                        connection.shutdown(socket.SHUT_WR)
                        self.assertNotIn(b" 200 ", connection.recv(100))
                    except ConnectionError:
                        pass  # it may close without a word
            self.assertEqual(self.code("state"), 200)

    def test_the_book_is_served_and_nothing_else(self):
        page = '<html><head><title>01 Tiny · Book</title></head><body><h3 id="011-one">01.1 Number one</h3></body></html>'
        self.put("out/book/01-tiny.html", page)
        self.put("out/book/index.html", page)
        self.put("out/book/assets/book.js", "1")
        self.put("out/secret.txt", "secret")
        self.put("out/book.beside/secret.txt", "secret")
        (self.root / "out/book/link.txt").symlink_to("../secret.txt")
        (self.root / "out/book/folder").symlink_to("../book.beside")
        (self.root / "out/book/within.js").symlink_to("assets/book.js")
        with self.watched("01"):
            self.assertEqual(self.state()["link"], "book/01-tiny.html#011-one")
            _, _, body = self.get("book/")
            self.assertIn(b'<script src="../beside.js"></script>\n</body>', body)
            self.assertEqual(self.get("book/assets/book.js")[2], b"1")
            self.assertEqual(self.get("book/within.js")[2], b"1")
            for missing in ("book/link.txt", "book/folder/secret.txt", "book/none.html", "book/assets", "book/assets/"):
                self.assertEqual(self.code(missing), 404, missing)
            self.assertEqual(self.code(f"/{self.secret}/book/../secret.txt"), 400)
            # Where one was is remembered, if the book has such a page.
            for page in ("none.html", "../secret.txt", "link.txt", "%3Cscript%3E"):
                self.get(f"at?page={page}&section=x")
            self.get("at?page=01-tiny.html&section=011-one")
            state = self.state_when(lambda state: state["reading"])
            self.assertEqual(state["reading"], {"link": "book/01-tiny.html#011-one", "title": "01 Tiny"})

    # ---- when there is a page -------------------------------------------------------------------

    def test_there_is_no_page_where_nobody_would_look(self):
        self.assertNotIn("http:", self.course("watch", code=3))
        self.assertIn("http://127.0.0.1:", self.course("watch", "--page", code=3))
        with companion.Terminal([companion.COURSE, "watch", "--no-page"], self.environment) as terminal:
            terminal.expect("q quit")
            self.assertNotIn("http:", terminal.said)
        self.environment["SSH_CONNECTION"] = "10.0.0.1 1 10.0.0.2 22"
        with companion.Terminal([companion.COURSE, "watch"], self.environment) as terminal:
            terminal.expect("q quit")
            self.assertNotIn("http:", terminal.said)
        with self.watched("--page"):
            self.assertEqual(self.code(""), 200)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + (sys.argv[3:] or [
        f"LivePage.{name}" for name in vars(LivePage) if name.startswith("test_")]))
