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


def table(row_type, fields, rows):
    name = row_type.lower() + "s"
    rows = [", ".join(numbers(v) if len(v) > 1 else str(v[0]) if isinstance(v[0], int) else float(v[0]).hex()
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
    + table("Root", "double x;\n    int n;\n    DoubleDouble root", roots()) + """}  // namespace exact
// clang-format on
"""
path = pathlib.Path(__file__).resolve().parents[1] / "common/exact_values.hpp"
if "--check" not in sys.argv:
    path.write_text(text)
elif not path.exists() or path.read_text() != text:
    sys.exit("tests/common/exact_values.hpp is not what tests/oracle/make_tables.py makes")
