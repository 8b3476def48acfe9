#!/usr/bin/env python3
"""Writes tests/common/exact_values.hpp: values for the checkpoints' own oracle.

    python3 tests/oracle/make_tables.py           writes it
    python3 tests/oracle/make_tables.py --check   fails when it is not what this script makes

Checkpoints compute their exact values in double-double arithmetic. These tables check that arithmetic, so they
need more digits than it has: here they are rational numbers, and series and roots to 200 bits. Each is written
as the sum of two doubles, which holds about 106 bits of it.
"""
import math
import pathlib
import random
import sys
from fractions import Fraction

BITS = 200
PI = Fraction(314159265358979323846264338327950288419716939937510582097494459230781640628620899863, 10**83)
E = sum(Fraction(1, math.factorial(n)) for n in range(70))

# Where rt::portable is farthest from the functions of <cmath>, as far as a search with random numbers in quadruple
# precision found; then numbers from 2^20 on, and results that are almost too large.
WORST = """sin 0x1.634c93497269p+2
sin -0x1.a2fb129ada6f4p+17
sin 0x1.93c05c9ed3cbcp+19
cos 0x1.93c05c9ed3cbcp+18
tan 0x1.93c05c9ed3cbcp+18
cos 0x1.2644404aa060cp+1
cos 0x1.23b1fcffdbdep+19
tan 0x1.f1f7c11f01f5dp+1
tan 0x1.d335bc7dbae84p+18
asin 0x1.fd16f153c376bp-4
asin 0x1.90a7f47a8ec49p-1
asin 0x1.efbdeb5000001p-26
acos 0x1.fc06556a2fbc1p-1
acos 0x1.fafed32b88ecep-1
acos -0x1.bbac8cebeb8c3p-1
atan -0x1.26bc3a0559fb6p+0
atan -0x1.443b6cfad80c2p+0
atan2 -0x1.85e588ce2a0ap-3 0x1.84cb8c214bd9ap+0
atan2 -0x1.a36ab0562d956p-20 0x1.a2d427de753eep-17
exp -0x1.3e52eae823312p+9
exp 0x1.62e42fefa39efp+9
exp2 -0x1.9cc21b4a32b75p+2
exp2 0x1.ffffffffffff8p+9
pow 0x1.6994fe0b69e83p-4 0x1.aaaaaaaaaaaaap-2
pow 0x1.2f071d7f8c234p+3 0x1.b52ededa585bp+0
pow 0x1.73bfae43be3fbp-1 -0x1.0ef0758c16317p+11
pow 0x1.6a091eccb7fa5p-1 -0x1.cd77f2fa696a2p+10
pow 1.3752 -1442.7
cbrt -0x1.acaf9f2adad6ep+16
log2 0x1.5fa11948567a7p+0
log10 0x1.5469d605c6a8fp+0
log1p 0x1.9fffffffffffep-53
log1p -0x1.ap-53
hypot 0x1.efdc61f2a4baep+30 0x1.4ce2da01b49fp+9
hypot 1e308 1e308
hypot 0x1.7076bb3f47259p+1000 0x1.f5ae6076b981dp+1020
far_sin 1048576
far_sin 1e15
far_sin -1e22
far_sin 1.7976931348623157e308
far_cos 1048577
far_cos 1e22
far_tan 1e15"""


def rounded(x):
    """The double nearest to a Fraction, however many digits it has."""
    return x.numerator / x.denominator  # Python rounds the quotient of integers correctly


def root(x, n):
    """The n-th root of a Fraction, with an error below 2^-BITS, by Newton's method."""
    scaled = (x.numerator << (n * (BITS + 40))) // x.denominator
    guess = 1 << (scaled.bit_length() // n + 1)
    while True:
        better = ((n - 1) * guess + scaled // guess ** (n - 1)) // n
        if better >= guess:
            return Fraction(guess, 1 << (BITS + 40))
        guess = better


def sine_cosine(x):
    """Of a Fraction with |x| <= 8, by their series, to about 2^-BITS."""
    sums, term, n = [Fraction(0), Fraction(0)], Fraction(1), 0
    while abs(term) > Fraction(1, 1 << (BITS + 40)):
        sums[n % 2] += term if n % 4 < 2 else -term
        n += 1
        term = Fraction(round(term * x / n * (1 << (BITS + 60))), 1 << (BITS + 60))
    return sums[1], sums[0]


def pair(x):
    """A Fraction as the two doubles that hold it."""
    high = rounded(Fraction(x))
    return [high, rounded(Fraction(x) - Fraction(high))]


def numbers(values):
    return "{" + ", ".join(float(v).hex() for v in values) + "}"


def operations():
    """Sums, products, quotients and roots of numbers with 106 bits, also of such that cancel."""
    rng = random.Random("operations")
    for i in range(40):
        a, b = [pair(Fraction(rng.getrandbits(106) + (1 << 106), 1 << rng.randrange(90, 120))) for _ in range(2)]
        if i % 4 == 3:
            b = [a[0], a[1] * rng.uniform(0, 1)]
        sign = rng.choice([-1, 1])
        b = [sign * b[0], sign * b[1]]
        x, y = [Fraction(high) + Fraction(low) for high, low in (a, b)]
        yield [a, b, *map(pair, (x + y, x - y, x * y, x / y, root(x, 2)))]


def turns():
    """Sine and cosine of parts of a whole turn: beside quarters and between them."""
    for turn in (0.01, 0.125, 0.24, 0.25 + 2.0**-50, 0.4, 0.5 - 2.0**-40, 0.7, 0.875, 0.99):
        # From the nearest quarter, where one of them is exactly 0.
        quarter = round(4 * turn)
        sine, cosine = sine_cosine(2 * PI * (Fraction(turn) - Fraction(quarter, 4)))
        for _ in range(quarter):
            sine, cosine = cosine, -sine
        yield [[turn], pair(sine), pair(cosine)]


def halves():
    """The tangent of half an angle."""
    for angle in (2.0**-16, 0.1, 0.5, 1, 1.57, 1.6, 1.7, 2.5, 3, 3.1415, math.pi - 2.0**-10):
        sine, cosine = sine_cosine(Fraction(angle) / 2)
        yield [[angle], pair(sine / cosine)]


def roots():
    for n in (2, 5, 12):
        for x in (2.0**-20, 0.003, 0.7, 1, 1.5, 1000):
            yield [[x], [n], pair(root(Fraction(x), n))]


def exponential(x):
    """e^x of a Fraction, with a relative error of about 2^-BITS."""
    n = round(float(x))
    few, term, i = Fraction(0), Fraction(1), 0
    while term:
        few += term
        i += 1
        term = Fraction(round(term * (x - n) / i * (1 << (BITS + 60))), 1 << (BITS + 60))
    return few * E**n


def logarithm(x):
    """ln x of a Fraction near to a double: one step from that of the double, whose error is d."""
    guess = Fraction(math.log(x.numerator) - math.log(x.denominator) if abs(x - 1) > 0.5 else math.log1p(x - 1))
    d = x / exponential(guess) - 1
    return guess + d - d**2 / 2 + d**3 / 3 - d**4 / 4 + d**5 / 5


def arctangent(y, x):
    """The angle of (x, y), as above."""
    guess = Fraction(math.atan2(y, x))
    sine, cosine = sine_cosine(guess)
    d = (y * cosine - x * sine) / (x * cosine + y * sine)
    return guess + d - d**3 / 3 + d**5 / 5


def any_sine_cosine(x):
    return sine_cosine(x - round(x / (2 * PI)) * 2 * PI)


def far_sine_cosine(x):
    """Of the angle next to x that rt::portable takes from 2^20 on."""
    turn = Fraction(2 * math.pi)
    turns = math.floor(x / turn)
    assert abs(turns * (2 * PI - turn)) < Fraction(math.ulp(x)) / 2
    return sine_cosine(x - turns * turn)


def functions():
    """Functions of <cmath> where rt::portable is farthest from them, as far as a search found, and others."""
    one = Fraction(1)
    values = {
        "sin": lambda x: any_sine_cosine(x)[0],
        "cos": lambda x: any_sine_cosine(x)[1],
        "tan": lambda x: any_sine_cosine(x)[0] / any_sine_cosine(x)[1],
        "far_sin": lambda x: far_sine_cosine(x)[0],
        "far_cos": lambda x: far_sine_cosine(x)[1],
        "far_tan": lambda x: far_sine_cosine(x)[0] / far_sine_cosine(x)[1],
        "asin": lambda x: arctangent(x, root(one - x * x, 2)),
        "acos": lambda x: arctangent(root(one - x * x, 2), x),
        "atan": lambda x: arctangent(x, one),
        "atan2": arctangent,
        "exp": exponential,
        "exp2": lambda x: exponential(x * logarithm(Fraction(2))),
        "pow": lambda x, y: exponential(y * logarithm(x)),
        "cbrt": lambda x: root(x, 3) if x > 0 else -root(-x, 3),
        "log2": lambda x: logarithm(x) / logarithm(Fraction(2)),
        "log10": lambda x: logarithm(x) / logarithm(Fraction(10)),
        "log1p": lambda x: logarithm(one + x),
        "hypot": lambda x, y: root(x * x + y * y, 2),
    }
    for line in WORST.split("\n"):
        name, *words = line.split()
        arguments = [float.fromhex(word) if "x" in word else float(word) for word in words]
        value = values[name](*map(Fraction, arguments))
        yield [[f'"{name.removeprefix("far_")}"'], *([a] for a in (arguments + [0.0])[:2]), pair(value)]


def table(row_type, fields, rows):
    name = row_type.lower() + "s"
    rows = [", ".join(numbers(v) if len(v) > 1 else str(v[0]) if isinstance(v[0], (int, str)) else float(v[0]).hex()
                      for v in row) for row in rows]
    return f"struct {row_type} {{\n    {fields};\n}};\n\ninline constexpr {row_type} {name}[] = {{\n" + \
        "".join(f"    {{{row}}},\n" for row in rows) + "};\n\n"


text = """#pragma once
// Made by tests/oracle/make_tables.py, not to be edited: values with more digits than double-double
// arithmetic can compute, which check it.

#include <study/double_double.hpp>

// clang-format off
namespace exact {

using study::DoubleDouble;

""" + table("Operation", "DoubleDouble a, b, sum, difference, product, quotient, root", operations()) \
    + table("Turn", "double turn;\n    DoubleDouble sine, cosine", turns()) \
    + table("Half", "double angle;\n    DoubleDouble tangent", halves()).replace("halfs", "halves") \
    + table("Root", "double x;\n    int n;\n    DoubleDouble root", roots()) \
    + table("Function", "const char* name;\n    double x, y;\n    DoubleDouble value", functions()) + """}  // namespace exact
// clang-format on
"""
path = pathlib.Path(__file__).resolve().parents[1] / "common/exact_values.hpp"
if "--check" not in sys.argv:
    path.write_text(text)
elif not path.exists() or path.read_text() != text:
    sys.exit("tests/common/exact_values.hpp is not what tests/oracle/make_tables.py makes")
