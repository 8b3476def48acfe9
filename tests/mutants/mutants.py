#!/usr/bin/env python3
"""Mutants: do the checkpoints stop small wrong changes to each solution?

Takes the solution of an exercise, makes many small changes to it (an operator, a comparison, a
constant, a sign, another variable of the same type, a dropped statement ...) and runs the exercise's
checkpoints on each. A mutant that passes all of them, in double and in float, has survived: either a
better test is needed, or no test should stop it. The latter are listed with the reason in NN.k.txt
beside this file, as "function  |  change".

All mutants of an exercise are compiled into one answer; the environment variable RT_MUTANT chooses one:

    a + b   becomes   (rt_mutant == 7 ? a - b : a + b)

A mutant that does not compile in this form is left out. A mutant that cannot be chosen while the program
runs, such as a parameter by value instead of by reference, is compiled alone.

Values are tried 2 % too large, and 1000 epsilon off. A test case that notices the former in one of them, but
the latter in none, allows too much, or is listed in NN.k.txt as "NN.k what holds  |  1000 epsilon".

Needs python3 with libclang (package python3-clang) and a configured build folder.
"""

import argparse
import collections
import concurrent.futures
import contextlib
import html
import json
import math
import os
import pathlib
import re
import resource
import shlex
import subprocess
import sys
import time

try:
    from clang import cindex
    from clang.cindex import CursorKind as Kind
except ImportError:
    print("mutants: python3 has no libclang: install the package python3-clang", file=sys.stderr)
    sys.exit(77)  # which ctest takes as skipped

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent

# Exercises in which any design passes that keeps a contract: a small change makes another right design.
FREE = {"05.6"}

# ---- Making mutants ----------------------------------------------------------------------------

SWAPPED_OPERATORS = {
    "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["/"],
    "<": ["<=", ">"], "<=": ["<", ">="], ">": [">=", "<"], ">=": [">", "<="],
    "==": ["!="], "!=": ["=="], "&&": ["||"], "||": ["&&"],
    "+=": ["-=", "="], "-=": ["+=", "="], "*=": ["/=", "="], "/=": ["*=", "="],
    "<<": [">>"], ">>": ["<<"], "&": ["|"], "|": ["&"], "^": ["|"], "^=": ["|="],
}
ARITHMETIC = {"+", "-", "*", "/"}
SWAPPED_FUNCTIONS = {
    "min": "max", "max": "min", "sin": "cos", "cos": "sin", "floor": "ceil", "ceil": "floor",
    "front": "back", "back": "front", "begin": "end", "first": "last", "nextafter": "max",
    "copysign": "max", "minmax": "max", "sqrt": "abs", "abs": "sqrt", "lower_bound": "upper_bound",
    "stable_partition": "partition", "min_element": "max_element", "max_element": "min_element",
    "push_back": "emplace_back", "cross": "dot", "dot": "cross",
}
CASTS = {Kind.UNEXPOSED_EXPR, Kind.CXX_FUNCTIONAL_CAST_EXPR, Kind.PAREN_EXPR}
REALS = {"double", "float", "long double"}
WIDE_INTEGERS = {"unsigned long", "long", "unsigned long long", "long long"}
MEASURED = re.compile(r"(long )?double|float|rt::(Vec2|Vec3|Vec3Of<.*>|Color)|<dependent type>"
                      r"|.*vector_size.* (double|float)")
# A bound on an error may be a little larger; a number has its own mutants.
NOT_MEASURED = re.compile(r"rounding_bound|margin|point_error|^-?[\d.]+$")
TOO_LARGE, SLIGHTLY_OFF = " * rt::Real(1.02)", "slightly_off("
TOLERANT = "  |  1000 epsilon"  # ends the key of a test case


class Mutant:
    """A change of the bytes [start, end) of a file; `form` says how it is chosen."""

    def __init__(self, start, end, text, form="expression"):
        self.start, self.end, self.text, self.form = start, end, text, form
        self.number = 0
        self.function = ""
        self.key = ""


class Maker:
    """Walks the syntax tree of one solution file and collects its mutants."""

    def __init__(self, path, arguments, given, draws=False):
        self.path = str(path)
        self.source = path.read_bytes()
        self.given = given  # functions that the stub gives: they are not the learner's
        self.draws = draws  # a picture, which has 256 levels
        self.mutants = []
        self.seen = set()
        self.no_sign = set()  # -x == 0 says what x == 0 says
        self.assigned = set()  # what is on the left of an assignment must stay a variable
        self.function = ""  # around the place that is visited
        unit = cindex.Index.create().parse(self.path, args=arguments + ["-x", "c++"])
        for cursor in unit.cursor.get_children():
            if cursor.location.file and cursor.location.file.name == self.path:
                self.visit(cursor, [])

    def text(self, cursor):
        return self.source[cursor.extent.start.offset:cursor.extent.end.offset].decode()

    def add(self, cursor, text, form="expression"):
        self.add_range(cursor.extent.start.offset, cursor.extent.end.offset, text, form)

    def add_range(self, start, end, text, form="expression"):
        original = self.source[start:end].decode()
        if (start, end, text) in self.seen or text == original or end <= start:
            return
        if (start, end) in self.assigned and form in ("expression", "condition"):
            return
        if (start, end) in self.no_sign and text == f"-{original}":
            return
        self.seen.add((start, end, text))
        self.mutants.append(Mutant(start, end, text, form))
        self.mutants[-1].function = self.function

    def visit(self, cursor, scope):
        if cursor.extent.start.file is None or cursor.extent.start.file.name != self.path:
            return
        kind = cursor.kind
        functions = (Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.FUNCTION_TEMPLATE, Kind.CONSTRUCTOR,
                     Kind.DESTRUCTOR, Kind.LAMBDA_EXPR)
        if kind in functions:
            if kind != Kind.LAMBDA_EXPR:
                if self.is_given(cursor):
                    return
                self.function = cursor.spelling.split("<")[0] or self.function
            scope = list(scope)
            for child in cursor.get_children():
                if child.kind == Kind.PARM_DECL:
                    scope.append(child)
                    self.by_value(child)
        if kind in (Kind.TEMPLATE_TYPE_PARAMETER, Kind.TYPE_REF, Kind.STATIC_ASSERT,
                    Kind.CONCEPT_DECL if hasattr(Kind, "CONCEPT_DECL") else Kind.STATIC_ASSERT):
            return
        if kind == Kind.COMPOUND_STMT:
            scope = list(scope)
            self.statements(cursor)
        children = list(cursor.get_children())
        handler = {
            Kind.BINARY_OPERATOR: self.binary, Kind.COMPOUND_ASSIGNMENT_OPERATOR: self.binary,
            Kind.UNARY_OPERATOR: self.unary, Kind.CALL_EXPR: self.call,
            Kind.INTEGER_LITERAL: self.integer, Kind.FLOATING_LITERAL: self.floating,
            Kind.CXX_BOOL_LITERAL_EXPR: self.boolean,
            Kind.CONDITIONAL_OPERATOR: self.conditional, Kind.IF_STMT: self.branch,
            Kind.WHILE_STMT: self.loop, Kind.FOR_STMT: self.loop,
            Kind.CXX_FOR_RANGE_STMT: self.range_loop, Kind.RETURN_STMT: self.returned,
            Kind.MEMBER_REF_EXPR: self.member,
        }.get(kind)
        if handler:
            handler(cursor, children)
        if kind == Kind.DECL_REF_EXPR:
            self.variable(cursor, scope)
        if kind == Kind.VAR_DECL and children and children[-1].kind.is_expression() and (
                self.text(children[-1]) != ":"):  # as in a loop over a range
            self.value(children[-1])
            self.slightly_off(children[-1])
        for child in children:
            self.visit(child, scope)
            if child.kind == Kind.DECL_STMT:
                scope += [c for c in child.get_children() if c.kind == Kind.VAR_DECL]
            elif child.kind == Kind.VAR_DECL:
                scope.append(child)

    def is_given(self, function):
        squeezed = "".join(self.text(function).split())
        return "{" in squeezed and squeezed in self.given

    # A value: rounded to float, cut to 32 bits, or 2 % too large.
    def value(self, cursor):
        inner = cursor
        while inner.kind in CASTS and len(list(inner.get_children())) == 1:
            inner = next(inner.get_children())
        if inner.kind in (Kind.INTEGER_LITERAL, Kind.FLOATING_LITERAL) and (
                inner is cursor or self.text(inner).isdigit()):
            return
        text, type_name = self.text(cursor), self.type(cursor)
        if type_name in REALS:
            self.add(cursor, f"static_cast<std::decay_t<decltype({text})>>(static_cast<float>({text}))")
            self.add(cursor, f"({text}){TOO_LARGE}")
        elif type_name in WIDE_INTEGERS:
            self.add(cursor, f"static_cast<std::decay_t<decltype({text})>>(static_cast<std::uint32_t>({text}))")

    # A value: 1000 epsilon off, but not all components alike, since a vector may be normalized later.
    def slightly_off(self, cursor):
        while True:
            parts = [part for part in cursor.get_children() if part.kind not in (Kind.TYPE_REF, Kind.NAMESPACE_REF)]
            if len(parts) != 1 or not (cursor.kind in CASTS or parts[0].kind == Kind.INIT_LIST_EXPR
                                       or self.text(cursor) == self.text(parts[0])):
                break
            cursor = parts[0]
        text = self.text(cursor)
        is_unwritten = cursor.kind == Kind.CALL_EXPR and not parts  # the constructor of a variable
        is_named = cursor.kind == Kind.DECL_REF_EXPR and cursor.referenced.kind == Kind.VAR_DECL  # off already there
        if cursor.kind == Kind.INIT_LIST_EXPR:
            for part in parts:
                self.slightly_off(part)
        elif MEASURED.fullmatch(self.type(cursor)) and not (
                self.draws or is_unwritten or is_named or NOT_MEASURED.search(text)):
            self.add(cursor, f"{SLIGHTLY_OFF}{text})")

    @staticmethod
    def type(cursor):
        return cursor.type.get_canonical().spelling.replace("const ", "").replace(" &", "").strip()

    def operator_between(self, left, right):
        start, end = left.extent.end.offset, right.extent.start.offset
        token = self.source[start:end].decode().strip()
        return token, start, end

    def binary(self, cursor, children):
        if len(children) != 2:
            return
        left, right = children
        token, start, end = self.operator_between(left, right)
        a, b = self.text(left), self.text(right)
        if token.endswith("=") and token not in ("==", "!=", "<=", ">="):
            self.assigned.add((left.extent.start.offset, left.extent.end.offset))
        for other in SWAPPED_OPERATORS.get(token, []):
            self.add(cursor, f"{a} {other} {b}")
        if token == "=":
            self.slightly_off(right)
        if token in ARITHMETIC:
            self.add(cursor, a)
            if token != "/":
                self.add(cursor, b)
            if token == "-" or token == "/":
                self.add(cursor, f"{b} {token} {a}")
        if token in ("&&", "||"):
            self.add(cursor, a)
            self.add(cursor, b)
        if token in ("==", "!=") and b == "0":
            self.no_sign.add((left.extent.start.offset, left.extent.end.offset))
        if token in ("<", "<=", ">", ">=", "==", "!="):
            self.add(cursor, "true")
            self.add(cursor, "false")

    def unary(self, cursor, children):
        text = self.text(cursor)
        if text.startswith(("-", "~")):
            self.add(cursor, text[1:])
        if text.startswith("!"):
            self.add(cursor, text[1:], form="condition")
        for old, new in (("++", "--"), ("--", "++")):
            if text.startswith(old):
                self.add(cursor, new + text[2:])
            if text.startswith(old) or text.endswith(old) or text.startswith("&"):
                self.assigned |= {(c.extent.start.offset, c.extent.end.offset) for c in children}

    def call(self, cursor, children):
        text = self.text(cursor)
        name = cursor.spelling or (cursor.referenced.spelling if cursor.referenced else "")
        if name.startswith("operator") and len(children) == 3:  # it names its function in the middle
            left, right = children[0], children[2]
            if left.extent.end.offset <= right.extent.start.offset:
                self.binary(cursor, [left, right])
            return
        if name.startswith("operator") and len(children) == 2 and text.startswith("-"):
            self.add(cursor, text[1:])
            return
        arguments = [a for a in cursor.get_arguments() if a is not None]
        callee = re.match(r"([\w:]*?)(\w+)\s*\(", text)
        if callee and callee.group(2) in SWAPPED_FUNCTIONS:
            other = SWAPPED_FUNCTIONS[callee.group(2)]
            self.add(cursor, callee.group(1) + other + text[callee.end(2):])
        method = re.match(r"(.*[.>])(\w+)\(\)$", text, re.S)
        if method and method.group(2) in SWAPPED_FUNCTIONS:
            self.add(cursor, method.group(1) + SWAPPED_FUNCTIONS[method.group(2)] + "()")
        if len(arguments) == 1 and callee and (
                not self.type(cursor).startswith("rt::") or self.type(cursor) == self.type(arguments[0])):
            self.add(cursor, self.text(arguments[0]))  # of another type, it would hide mutants in the lines below
        symmetric = callee and callee.group(2) in ("min", "max", "dot")
        for first, second in zip(arguments, arguments[1:]):
            if symmetric:
                break
            if self.type(first) != self.type(second) and "dependent" not in self.type(first):
                continue
            start, end = first.extent.start.offset, second.extent.end.offset
            base = cursor.extent.start.offset
            between = self.source[first.extent.end.offset:second.extent.start.offset].decode()
            raw = self.source
            self.add(cursor, raw[base:start].decode() + self.text(second) + between
                     + self.text(first) + raw[end:cursor.extent.end.offset].decode())

    def integer(self, cursor, _):
        text = self.text(cursor)
        if not re.fullmatch(r"\d+", text):
            return
        value = int(text)
        self.add(cursor, str(value + 1))
        if value > 0:
            self.add(cursor, str(value - 1))

    def floating(self, cursor, _):
        text = self.text(cursor)
        self.add(cursor, f"({text} * 1.02)")
        self.add(cursor, f"({text} * 2)")

    def boolean(self, cursor, _):
        self.add(cursor, "false" if self.text(cursor) == "true" else "true")

    def condition(self, cursor):
        if cursor.kind.is_expression():
            for text in ("true", "false", f"!({self.text(cursor)})"):
                self.add(cursor, text, form="condition")

    def conditional(self, cursor, children):
        if len(children) != 3:
            return
        if "vector_size" not in self.type(children[0]):
            self.condition(children[0])
            return
        text = self.text(children[0])  # the mask of a pack
        for other in (f"~({text})", f"({text}) & 0", f"({text}) | -1"):
            self.add(children[0], other)

    def branch(self, cursor, children):
        # A condition that declares a variable cannot be replaced.
        if children and children[0].kind.is_expression() and "=" not in re.sub(
                "[<>=!]=", "", self.text(children[0])):
            self.condition(children[0])
        elif len(children) > 1 and children[0].kind == Kind.DECL_STMT:
            self.condition(children[1])

    def loop(self, cursor, children):
        for child in children[:-1]:
            if child.kind == Kind.BINARY_OPERATOR or self.type(child) == "bool":
                self.add(child, "false")  # the body never runs
                if cursor.kind != Kind.WHILE_STMT:
                    left = list(child.get_children())
                    if len(left) == 2:
                        token, _, _ = self.operator_between(*left)
                        if token in ("<", "<=", "!="):
                            self.add(child, f"{self.text(left[0])} + 1 {token} {self.text(left[1])}")

    def range_loop(self, cursor, children):
        body = children[-1]
        head = self.source[cursor.extent.start.offset:body.extent.start.offset].decode()
        declared = re.match(r"for\s*\((.*[^:]):([^:].*)\)\s*$", head, re.S)
        if not declared:
            return
        sequence = declared.group(2).strip()
        for name, test in (("skips the first", "rt_k++ == 0"),
                           ("skips the last", f"++rt_k == static_cast<long>(std::size({sequence}))"),
                           ("ends after the first", "rt_k++ > 0")):
            self.add(cursor, f"{{ /* {name} */ long rt_k = 0; {head} {{ if ({test}) continue; "
                     f"{self.text(body)}{'' if body.kind == Kind.COMPOUND_STMT else ';'} }} }}",
                     form="statement")

    def returned(self, cursor, children):
        if children and children[0].kind.is_expression():
            value = children[0]
            self.value(value)
            self.slightly_off(value)
            if self.type(value) == "bool":
                self.add(value, "true")
                self.add(value, "false")
            if self.type(value) in ("rt::Vec3", "rt::Color"):
                self.add(value, f"({self.text(value)}){TOO_LARGE}")
                self.add(value, f"-({self.text(value)})")

    def member(self, cursor, children):
        """Another member of the same type."""
        field = cursor.referenced
        if field is None or field.kind != Kind.FIELD_DECL or not children:
            return
        fields = [f for f in field.semantic_parent.type.get_fields() if self.type(f) == self.type(field)]
        names = [f.spelling for f in fields]
        if len(names) > 1 and self.text(cursor).endswith(field.spelling):
            other = names[(names.index(field.spelling) + 1) % len(names)]
            self.add(cursor, self.text(cursor)[:-len(field.spelling)] + other)
        if self.type(field) in REALS:
            self.add(cursor, f"-{self.text(cursor)}")

    def variable(self, cursor, scope):
        declared = cursor.referenced
        if declared is None or declared.kind not in (Kind.VAR_DECL, Kind.PARM_DECL):
            return
        name = self.text(cursor)
        if name != declared.spelling:
            return
        same = [v.spelling for v in scope if v.spelling and v.spelling != name
                and self.type(v) == self.type(declared)]
        for other in dict.fromkeys(same[-2:]):
            self.add(cursor, other)
        if self.type(declared) in REALS or self.type(declared) == "rt::Vec3":
            self.add(cursor, f"-{name}")
        if name in ("rng", "random", "generator"):
            self.add(cursor, f"(*new std::decay_t<decltype({name})>({name}))")

    def statements(self, block):
        """Dropped statements."""
        def drop(statement):
            kind = statement.kind
            if kind.is_expression() or kind in (Kind.BREAK_STMT, Kind.CONTINUE_STMT):
                self.add(statement, "", form="dropped")

        def walk(statement):
            drop(statement)
            if statement.kind in (Kind.IF_STMT, Kind.FOR_STMT, Kind.WHILE_STMT,
                                  Kind.CXX_FOR_RANGE_STMT):
                inner = list(statement.get_children())
                for child in inner[1:] if statement.kind == Kind.IF_STMT else inner[-1:]:
                    if child.kind != Kind.COMPOUND_STMT:
                        walk(child)

        for statement in block.get_children():
            walk(statement)

    def by_value(self, parameter):
        text = self.text(parameter)
        if "&" in text and "const" not in text and "&&" not in text and "(" not in text:
            self.add(parameter, text.replace("&", "", 1), form="alone")


def rendered(source, mutants, start, end):
    """The text of [start, end) with all mutants in it, nested as their ranges are."""
    here = [m for m in mutants if start <= m.start and m.end <= end]
    groups = collections.OrderedDict()
    for mutant in sorted(here, key=lambda m: (m.start, -m.end)):
        groups.setdefault((mutant.start, mutant.end), []).append(mutant)
    out, position = [], start
    for (first, last), group in groups.items():
        if first < position:
            continue  # inside one that has been written
        inner = [m for m in here if first <= m.start and m.end <= last
                 and (m.start, m.end) != (first, last)]
        body = rendered(source, inner, first, last)
        for mutant in group:
            number = mutant.number
            cast = "static_cast<bool>" if mutant.form == "condition" else ""
            if mutant.form == "condition":  # such as a pointer
                body = f"static_cast<bool>({body})"
            if mutant.form in ("expression", "condition"):
                body = f"\n/*@{number}*/(rt_mutant == {number} ? {cast}({mutant.text}) :\n/*@*/ ({body}))\n/*@*/"
            elif mutant.form == "statement":
                body = f"\n/*@{number}*/if (rt_mutant == {number}) {mutant.text.replace(chr(10), ' ')} else\n/*@*/ {{ {body}; }}\n/*@*/"
            else:  # dropped
                body = f"\n/*@{number}*/if (rt_mutant != {number})\n/*@*/ {{ {body}; }}\n/*@*/"
        out.append(source[position:first].decode() + body)
        position = last
    return "".join(out) + source[position:end].decode()


def one_line(text):
    return " ".join(re.sub(r"//[^\n]*", "", text).split())


def name_mutants(source, mutants):
    """A key that stays when lines move: the function, and the change."""
    seen = collections.Counter()
    for mutant in mutants:
        mutant.row = source[:mutant.start].count(b"\n") + 1
        original = one_line(source[mutant.start:mutant.end].decode())
        if mutant.form == "dropped":
            change = f"drop {original}"
        elif mutant.form == "statement":
            change = re.search(r"/\* (.*?) \*/", mutant.text).group(1)
        else:
            change = f"{original} -> {one_line(mutant.text)}"
        key = f"{mutant.function or 'members'}  |  {change}"
        seen[key] += 1
        mutant.key = key if seen[key] == 1 else f"{key}  #{seen[key]}"


# ---- Building and running ----------------------------------------------------------------------

PRELUDE = """#pragma once
#include <cstdint>
#include <cstdlib>
#include <concepts>
#include <iterator>
#include <type_traits>
#include <rt/real.hpp>
inline const int rt_mutant = std::getenv("RT_MUTANT") ? std::atoi(std::getenv("RT_MUTANT")) : 0;
template <class T> requires(!std::integral<T>) T slightly_off(T value, int epsilons = 1000) {
    if constexpr (requires { value.z; }) value.z = slightly_off(value.z, -epsilons);
    if constexpr (requires { value.x; }) value.x = slightly_off(value.x, epsilons);
    else if constexpr (requires { value.r; }) value.r = slightly_off(value.r, epsilons);
    else return value * (1 + epsilons * rt::epsilon);
    return value;
}
"""


def limit(process, seconds):
    """Ends a program after so many seconds of processor time, rounded up: an endless loop ends however busy the machine is.
    The program runs already, since preexec_fn, by which it would begin with its limits, takes longer than most mutants."""
    # Filling more memory would take most of the time of some exercises.
    limits = {resource.RLIMIT_DATA: 2 << 30, resource.RLIMIT_CORE: 0, resource.RLIMIT_CPU: math.ceil(seconds)}
    for kind, most in limits.items():
        with contextlib.suppress(ProcessLookupError):
            resource.prlimit(process.pid, kind, (most, most))


def processor_time(process):
    """The seconds of processor time that a program has taken so far; 0 where /proc does not tell."""
    try:
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def escaped(name):
    """A test case's name, as Catch2 takes it on the command line."""
    return re.sub(r"([\\\[\],*])", r"\\\1", name)


def time_of_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Answer:
    """The answer of an exercise in one precision, compiled with an edited solution, and its checkpoint."""

    def __init__(self, build, exercise, precision, folder):
        self.build, self.folder = build, folder
        suffix = exercise + (".float" if precision == "float" else "")
        target = f"answer.{suffix}"
        commands = json.loads((build / "compile_commands.json").read_text())
        self.compiles = [c for c in commands if f"/{target}.dir/" in c["command"]]
        self.linked = (build / "link" / f"{target}.txt").read_text().split("\n")
        self.checkpoint = build / "check" / f"check.{suffix}"
        self.place = folder / precision
        self.place.mkdir(parents=True, exist_ok=True)
        self.is_library = any(f.name == "answer.cpp" for f in map(pathlib.Path, (c["file"] for c in self.compiles)))
        self.result = self.place / (f"libanswer.{exercise}.so" if self.is_library else f"answer.{exercise}")
        self.cases, self.slow = set(), []  # test cases
        self.likely = []  # quick test cases that stopped mutants, the last first

    def words(self, command, edited):
        """The words that compile a source, with the edited folder first, but for the source and the object."""
        words = shlex.split(command["command"])
        for option in ("-c", "-o"):
            at = words.index(option)
            del words[at:at + 2]
        first = 2 if "ccache" in words[0] else 1
        every_error = "-ferror-limit=0" if "clang" in words[first - 1] else "-fmax-errors=0"
        words[first:first] = [f"-I{edited}", f"-I{edited}/rt", f"-I{ROOT}/common", "-w", every_error, "-fno-diagnostics-show-caret"]
        return words

    def compile(self, edited):
        """Compiles with the edited folder first. Returns the errors; empty if it compiles."""
        objects, errors, link = [], "", []
        for command in self.compiles:
            file = pathlib.Path(command["file"])
            for other in (edited / "rt" / file.name, edited / file.name):
                if other.exists():
                    file = other
            name = self.place / f"{file.name}.o"
            words = self.words(command, edited)
            link = link or words
            done = subprocess.run([*words, "-c", str(file), "-o", str(name)],
                                  cwd=self.build, capture_output=True, text=True)
            if done.returncode:
                errors += done.stderr
            objects.append(str(name))
        if errors:
            return errors
        if "-include" in link:
            at = link.index("-include")
            link = link[:at] + link[at + 2:]
        done = subprocess.run([*link, *objects, *filter(None, self.linked), "-o", str(self.result)],
                              cwd=self.build, capture_output=True, text=True)
        return done.stderr if done.returncode else ""

    def finished(self, number, words, seconds, processor_seconds):
        """Runs the checkpoint on this mutant: its exit code and its output, or None if the time is over."""
        environment = dict(os.environ, RT_MUTANT=str(number), COURSE_ANSWER=str(self.place),
                           LD_LIBRARY_PATH=str(self.place), DYLD_LIBRARY_PATH=str(self.place))
        with subprocess.Popen([str(self.checkpoint), "-w", "NoTests", *words],
                              cwd=self.folder, env=environment, text=True, errors="replace",
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
            limit(process, processor_seconds)
            end = time.time() + seconds
            while True:
                try:
                    said, _ = process.communicate(timeout=0.1)
                    return process.returncode, said
                except subprocess.TimeoutExpired:
                    if time.time() > end or processor_time(process) > processor_seconds:
                        process.kill()
                        return None

    def run(self, number, words, seconds=300, processor_seconds=300):
        """The checkpoint's output on this mutant; None if a test fails or the time is over."""
        done = self.finished(number, ["--abort", *words], seconds, processor_seconds)
        if done is None:
            return None
        code, said = done
        if code == 0:
            return said
        failed = re.search(r"^-{79}\n(\d\d\.\d [ -~]*)\n", said, re.M)  # of a long name, the first line
        if failed and not any(name.startswith(failed[1]) for name in self.slow):
            name = f'"{escaped(failed[1])}*"'
            self.likely = [name] + [other for other in self.likely if other != name]
        return None

    def failing(self, number, names):
        """Which of these test cases fail on this mutant? Those after one that crashes are not run."""
        if not names:
            return set()
        processor_seconds = 4 + sum(part[2] for part in self.parts)  # every failure is described
        done = self.finished(number, ["-r", "xml", ",".join(f'"{escaped(name)}"' for name in names)],
                             300, processor_seconds)
        cases = re.findall(r'<TestCase name="([^"]*)"(.*?)(?=<TestCase |\Z)', done[1] if done else "", re.S)
        return {html.unescape(name) for name, said in cases if '<OverallResult success="true"' not in said}

    def noticing_much(self, mutants, names):
        """Which of these test cases notice a value that is 2 % too large?"""
        slight = {(m.file, m.start, m.end) for m in mutants if m.text.startswith(SLIGHTLY_OFF)}
        noticing = set()
        for mutant in mutants:
            if mutant.text.endswith(TOO_LARGE) and (mutant.file, mutant.start, mutant.end) in slight:
                noticing |= self.failing(mutant.number, names - noticing)
        return noticing

    def noticing_nothing_slight(self, mutants, names):
        """Which of these test cases notice no value that is 1000 epsilon off?"""
        for mutant in mutants:
            if mutant.text.startswith(SLIGHTLY_OFF):
                names = names - self.failing(mutant.number, names)
        return names

    def measure(self, words):
        """Runs these test cases on the solution. Returns what it prints, None if it fails, and the arguments with which
        run() tries a mutant."""
        begun, used = time.time(), time_of_children()
        said = self.run(0, words)
        return said, (words, max(5.0, 8 * (time.time() - begun)), 0.3 + 8 * (time_of_children() - used))

    def try_solution(self):
        """Does the solution pass? Then mutants are run part by part: the quick test cases first, so that a mutant
        without end does not run for as long as the slow ones may take."""
        said, whole = self.measure(["-d", "yes"])
        if said is None:
            return False
        self.parts = [whole]
        times = re.findall(r"^([\d.]+) s: (.*)$", said, re.M)
        self.cases = {name for _, name in times}
        slow = [name for seconds, name in times if float(seconds) > 0.2]
        if not 0 < len(slow) < len(times):
            return True
        self.slow = slow
        quick = self.measure(["".join(f'~"{escaped(name)}"' for name in slow)])
        rest = self.measure([",".join(f'"{escaped(name)}"' for name in slow)])
        self.parts = [quick[1], rest[1]]
        return quick[0] is not None and rest[0] is not None

    def passes(self, number, should=False):
        """Do all test cases pass? Unless they should, those that stopped earlier mutants are tried first: most often, one
        of them stops this one, too."""
        parts = self.parts
        if self.likely and not should:
            parts = [([",".join(self.likely[:3])], *parts[0][1:]), *parts]
        return all(self.run(number, *part) is not None for part in parts)


class Exercise:
    def __init__(self, chapter, exercise):
        self.chapter, self.id = chapter, exercise["id"]
        self.files = exercise["files"]
        self.reasons = HERE / f"{self.id}.txt"

    def allowed(self):
        """The keys of mutants that no test should stop. Their reasons are indented."""
        if not self.reasons.exists():
            return set()
        return {line.strip() for line in self.reasons.read_text().splitlines()
                if line.strip() and not line.startswith(" ")}


def blame(errors):
    """Numbers of the mutants that errors speak of, by the marks in the lines that they name."""
    numbers, around, cache = set(), set(), {}
    for path, row in re.findall(r"([^\s:]+):(\d+)(?::\d+)?: ", errors) + re.findall(
            r"([^\s:]+):(\d+)(?:,|:)", errors):
        if "/mutated/" not in path:
            continue
        if path not in cache:
            cache[path] = pathlib.Path(path).read_text().split("\n")
        lines = cache[path]
        row = int(row) - 1
        marks = re.findall(r"/\*@(\d*)\*/", lines[row]) if row < len(lines) else []
        if not marks:  # a mutant's text may span lines
            above = row
            while above > 0 and not re.search(r"/\*@\d*\*/", lines[above]):
                above -= 1
            marks = re.findall(r"/\*@(\d*)\*/", lines[above])
        if marks and marks[0]:
            numbers.add(int(marks[0]))
        else:  # said of what stands around it
            near = "".join(lines[max(row - 3, 0):row + 4])
            around |= {int(n) for n in re.findall(r"/\*@(\d+)\*/", near)}
    return numbers or around


def run_exercise(exercise, build, float_too, log):
    started = time.time()
    folder = build / "mutants" / exercise.id
    edited = folder / "mutated"
    (edited / "rt").mkdir(parents=True, exist_ok=True)
    (edited / "rt" / "mutant_number.hpp").write_text(PRELUDE)
    answer = Answer(build, exercise.id, "double", folder)
    words = answer.words(answer.compiles[0], edited)[1:]
    parse = ["-std=c++20", "-w", "-DRT_REAL=double"]
    parse += [w for w in words if w.startswith(("-I", "-D"))]
    parse += [w for pair in zip(words, words[1:]) if pair[0] == "-isystem" for w in pair]
    clang_headers = subprocess.run(["clang++", "-print-resource-dir"], capture_output=True,
                                   text=True).stdout.strip()
    if clang_headers:
        parse += ["-isystem", clang_headers + "/include"]

    files, mutants, number = [], [], 0
    for name in exercise.files:
        path = ROOT / "solutions" / exercise.chapter / name
        stub = ROOT / "exercises" / exercise.chapter / name
        given = "".join(stub.read_text().split()) if stub.exists() else ""
        maker = Maker(path, parse, given, draws=not answer.is_library)
        name_mutants(maker.source, maker.mutants)
        for mutant in maker.mutants:
            number += 1
            mutant.number, mutant.file = number, name
        files.append((name, maker.source, maker.mutants))
        mutants += maker.mutants

    def write(chosen):
        for name, source, own in files:
            text = rendered(source, [m for m in own if m in chosen and m.form != "alone"], 0, len(source))
            target = edited / name
            line = "#pragma once"
            head = '#include "mutant_number.hpp"\n'
            text = text.replace(line, line + "\n" + head, 1) if line in text else head + text
            target.write_text(text)

    kept = set(mutants)
    for _ in range(12):
        write(kept)
        errors = answer.compile(edited)
        blamed = blame(errors)
        bad = {m for m in kept if m.number in blamed}
        if not bad:
            break
        kept -= bad
    if errors:
        raise RuntimeError(f"{exercise.id}: the mutants do not compile:\n{errors[:3000]}")
    if not answer.try_solution():
        raise RuntimeError(f"{exercise.id}: the solution itself does not pass")

    chosen = sorted((m for m in kept if m.form != "alone"), key=lambda m: m.number)
    alone = [m for m in kept if m.form == "alone"]
    allowed = exercise.allowed()
    surviving, stopped = [], 0
    for mutant in chosen:
        if answer.passes(mutant.number, should=mutant.key in allowed):
            surviving.append(mutant)
        else:
            stopped += 1
    for mutant in alone:
        single = folder / f"alone{mutant.number}" / "mutated"
        (single / "rt").mkdir(parents=True, exist_ok=True)
        for name, source, own in files:
            text = source
            if mutant in own:
                text = source[:mutant.start] + mutant.text.encode() + source[mutant.end:]
            (single / name).write_bytes(text)
        lonely = Answer(build, exercise.id, "double", single.parent)
        if lonely.compile(single):
            continue  # it is left out
        lonely.parts, lonely.slow = answer.parts, answer.slow
        if lonely.passes(0):
            surviving.append(mutant)
        else:
            stopped += 1
    tolerant = answer.noticing_nothing_slight(chosen, answer.noticing_much(chosen, answer.cases))
    doubtful = {name for name in tolerant if name + TOLERANT not in allowed}
    if float_too and (doubtful or any(m.form != "alone" and m.key not in allowed for m in surviving)):
        narrow = Answer(build, exercise.id, "float", folder)
        errors, in_both = narrow.compile(edited), set(kept)
        while bad := {m for m in in_both if m.number in blame(errors)}:
            in_both -= bad
            write(in_both)
            errors = narrow.compile(edited)
        if errors:
            log(f"{exercise.id}: not compiled in float: {errors[:300]}")
        elif narrow.try_solution():
            left = []
            for mutant in surviving:
                if mutant.form == "alone" or mutant.key in allowed or narrow.passes(mutant.number):
                    left.append(mutant)
                else:
                    stopped += 1
            surviving = left
            doubtful = narrow.noticing_nothing_slight(chosen, doubtful)
        else:
            log(f"{exercise.id}: the solution itself does not pass in float")
    equal = [m for m in surviving if m.key in allowed]
    surviving = [m for m in surviving if m.key not in allowed]
    keys = {m.key for m in mutants} | {name + TOLERANT for name in answer.cases}
    stale = sorted(k for k in allowed if k not in keys)
    needless = {m.key for m in kept if m not in equal} | {name + TOLERANT for name in answer.cases - tolerant}
    needless = sorted(needless & allowed)
    made = stopped + len(equal) + len(surviving)
    log(f"{exercise.id}  made {made:4}  stopped {stopped:4}  allowed {len(equal):3}  "
        f"survived {len(surviving):3}   {time.time() - started:4.0f} s")
    for mutant in surviving:
        log(f"    {mutant.file}:{mutant.row}\n{mutant.key}")
    for name in sorted(doubtful):
        log(f"    a test case that notices a value 2 % too large, but none 1000 epsilon off:\n{name}{TOLERANT}")
    if surviving or doubtful:
        log(f"    A better test case stops it. If none should: tests/mutants/{exercise.id}.txt lists it, with the reason\n"
            "    in the next line, indented.")
    for key in stale:
        log(f"    no such mutant any more: {key}")
    for key in needless:
        log(f"    stopped now, no need to list it: {key}")
    return made, stopped, len(equal), len(surviving) + len(doubtful), len(stale) + len(needless)


def main():
    parser = argparse.ArgumentParser(description="small wrong changes to the solutions: do the "
                                                 "checkpoints stop them?")
    parser.add_argument("exercises", nargs="*", help="NN or NN.k; all if none is named")
    parser.add_argument("--build", default=str(ROOT / "build"), help="a configured build folder")
    parser.add_argument("--as-built", action="store_true", help="the checkpoints are built already")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--no-float", action="store_true", help="do not try survivors in float")
    options = parser.parse_args()
    build = pathlib.Path(options.build).resolve()

    course = json.loads((ROOT / "course.json").read_text())
    exercises = [Exercise(c["name"], e) for c in course["chapters"] for e in c.get("exercises", [])]
    if options.exercises:
        for wanted in options.exercises:
            if not any(e.id == wanted or e.id.startswith(wanted + ".") for e in exercises):
                sys.exit(f"mutants: there is no exercise {wanted}; course.json has them all")
        exercises = [e for e in exercises if any(
            e.id == w or e.id.startswith(w + ".") for w in options.exercises)]
    exercises = [e for e in exercises if e.id not in FREE]
    if not exercises:
        print("mutants: none are made, since any design passes that keeps the contract")
        return
    targets = [f"check.{e.id}" for e in exercises]
    if not options.no_float:
        targets += [f"{target}.float" for target in targets]
    if not options.as_built:
        subprocess.run(["cmake", "--build", str(build), "-j", str(options.jobs), "--target", *targets],
                       check=True, stdout=subprocess.DEVNULL)

    failed, totals = False, [0, 0, 0, 0, 0]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        running = []
        for exercise in exercises:
            said = []
            running.append((exercise, said, pool.submit(run_exercise, exercise, build, not options.no_float,
                                                        said.append)))
        for exercise, said, result in running:
            try:
                totals = [a + b for a, b in zip(totals, result.result())]
            except (RuntimeError, subprocess.CalledProcessError) as error:
                said.append(f"{exercise.id}: {error}")
                failed = True
            print("\n".join(said), flush=True)
    print(f"all  made {totals[0]}  stopped {totals[1]}  allowed {totals[2]}  survived {totals[3]}")
    sys.exit(1 if failed or totals[3] or totals[4] else 0)


if __name__ == "__main__":
    main()
