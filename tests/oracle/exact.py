"""Exact arithmetic for the tables that checkpoints compare with, from Python's own library only.

Every input is a number that float (or double) holds exactly. Every result is computed with rational
numbers, square roots and trigonometric functions to 200 bits, and written as the sum of two doubles,
which holds about 106 bits of it.
"""
import math
import random
import struct
from fractions import Fraction

BITS = 200


def to_float(x):
    """The nearest number that a C++ float holds."""
    return struct.unpack("f", struct.pack("f", x))[0]


def rounder(precision):
    return to_float if precision == "float" else float


def round_to_double(x):
    """The double nearest to a Fraction, however many digits it has."""
    return x.numerator / x.denominator  # Python rounds the quotient of integers correctly


def sqrt(x):
    """The square root of a Fraction x >= 0, with a relative error below 2^-BITS."""
    if x == 0:
        return Fraction(0)
    # Scale to an integer with more than 2 * BITS bits, by a power of 4.
    shift = max(0, BITS + 8 - (x.numerator.bit_length() - x.denominator.bit_length()) // 2)
    return Fraction(math.isqrt((x.numerator << (2 * shift)) // x.denominator), 1 << shift)


def sin_cos(x):
    """Sine and cosine of a Fraction with |x| <= 4, by their series, to about 2^-BITS."""
    sums, term, n = [Fraction(0), Fraction(0)], Fraction(1), 0
    while abs(term) > Fraction(1, 1 << (BITS + 40)):
        sums[n % 2] += term if n % 4 < 2 else -term
        n += 1
        term = term * x / n
        term = Fraction(round(term * (1 << (BITS + 60))), 1 << (BITS + 60))
    return sums[1], sums[0]


def dot(a, b):
    return sum(Fraction(p) * Fraction(q) for p, q in zip(a, b))


def cross(a, b):
    a, b = [Fraction(p) for p in a], [Fraction(p) for p in b]
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def number(x):
    """A double as a C++ literal without rounding."""
    x = float(x)
    return str(int(x)) + ".0" if x == int(x) and abs(x) < 1e6 else x.hex()


def numbers(values):
    return "{" + ", ".join(number(v) for v in values) + "}"


def exact(x):
    """An exact value as an initializer of checkpoint::Exact."""
    high = round_to_double(Fraction(x))
    return numbers([high, round_to_double(Fraction(x) - Fraction(high))])


def exact_vector(v):
    return "{" + ", ".join(exact(c) for c in v) + "}"


def random_vector(rng, rounded, low=-1, high=1):
    """Components of random sign whose sizes are 10^low to 10^high."""
    return [rounded(rng.choice([-1, 1]) * 10 ** rng.uniform(low, high)) for _ in range(3)]


def header(script, row_type, fields, table):
    """A C++ header with the rows of both precisions, and a function that picks those at hand.

    table(precision) yields the initializer of each row. The function is named like the row type, in
    lower case and with an s: exact::Length gives exact::lengths().
    """
    name = row_type.lower() + "s"
    lines = [f"#pragma once\n// Made by tests/oracle/{script}: exact values, not to be edited.\n",
             '#include <span>\n\n#include "checkpoint.hpp"\n', "// clang-format off",
             f"namespace exact {{\n\nstruct {row_type} {{"]
    lines += [f"    {field};" for field in fields]
    lines.append("};\n")
    for precision in ("float", "double"):
        lines.append(f"inline constexpr {row_type} {name}_in_{precision}[] = {{")
        lines += [f"    {{{row}}}," for row in table(precision)]
        lines.append("};\n")
    lines.append(f"""inline std::span<const {row_type}> {name}() {{
    return checkpoint::for_this_precision<std::span<const {row_type}>>({name}_in_float,
                                                                 {name}_in_double);
}}
""")
    lines.append("}  // namespace exact\n// clang-format on")
    return "\n".join(lines) + "\n"


def seeded(*words):
    """A random generator that gives the same numbers on every machine."""
    return random.Random(" ".join(words))
