"""Exact tables for the given code in common/."""
from exact import *


def differences(precision):
    """a*b - c*d: unrelated products, and products that agree in all but their last digits."""
    rounded, rng = rounder(precision), seeded("differences", precision)
    tiny = 2.0**-22 if precision == "float" else 2.0**-51
    for i in range(240):
        a, b, c = [rounded(rng.choice([-1, 1]) * 10 ** rng.uniform(-3, 3)) for _ in range(3)]
        d = rounded(rng.uniform(-9, 9))
        if i % 2:
            d = rounded(float(Fraction(a) * Fraction(b) / Fraction(c)) * (1 + rng.uniform(-3, 3) * tiny))
        yield f"{numbers([a, b, c, d])}, {exact(dot([a, -c], [b, d]))}"


def double_double(rng):
    """A number of about 106 bits, as the two doubles that hold it."""
    value = Fraction(rng.getrandbits(106) + (1 << 106), 1 << rng.randrange(90, 120))
    high = round_to_double(value)
    return [high, round_to_double(value - Fraction(high))]


def value_of(pair):
    return Fraction(pair[0]) + Fraction(pair[1])


def operations(precision):
    """Sums, products, quotients and roots of numbers with 106 bits, also of such that cancel."""
    rng = seeded("operations")
    for i in range(60 if precision == "double" else 4):
        a, b = double_double(rng), double_double(rng)
        if i % 4 == 3:
            b = [a[0], a[1] * rng.uniform(0, 1)]
        sign = rng.choice([-1, 1])
        b = [sign * b[0], sign * b[1]]
        x, y = value_of(a), value_of(b)
        yield f"{numbers(a)}, {numbers(b)}, {exact(x + y)}, {exact(x - y)}, {exact(x * y)}, " \
              f"{exact(x / y)}, {exact(sqrt(x))}"


def root(x, n):
    """The n-th root of a Fraction, with a relative error below 2^-BITS, by Newton's method."""
    scaled = (x.numerator << (n * (BITS + 40))) // x.denominator
    guess = 1 << (scaled.bit_length() // n + 1)
    while True:
        better = ((n - 1) * guess + scaled // guess ** (n - 1)) // n
        if better >= guess:
            return Fraction(guess, 1 << (BITS + 40))
        guess = better


def srgb_encode(x):
    if x <= Fraction("0.0031308"):
        return Fraction("12.92") * x
    return Fraction("1.055") * root(x**5, 12) - Fraction("0.055")


def srgb_decode(x):
    if x <= Fraction("0.04045"):
        return x / Fraction("12.92")
    return root(((x + Fraction("0.055")) / Fraction("1.055")) ** 12, 5)


def transfers(precision):
    """The sRGB transfer function and its inverse, as IEC 61966-2-1 has them."""
    rounded, rng = rounder(precision), seeded("transfers", precision)
    values = [0.0, 0.001, 0.003, 0.0032, 0.0404, 0.0405, 0.18, 0.5, 1.0]
    values += [rng.uniform(0, 1) for _ in range(40)] + [10 ** rng.uniform(-6, 0) for _ in range(20)]
    for x in map(rounded, values):
        yield f"{number(x)}, {exact(srgb_encode(Fraction(x)))}, {exact(srgb_decode(Fraction(x)))}"


PI = Fraction(314159265358979323846264338327950288419716939937510582097494459230781640628620899863, 10**83)


def turns(precision):
    """Sine and cosine of parts of a whole turn: eighths and what lies beside them, tiny ones, any."""
    rounded, rng = rounder(precision), seeded("turns", precision)
    step = 2.0**-24 if precision == "float" else 2.0**-53
    values = [k / 8 for k in range(8)]
    values += [k / 8 + side * step for k in range(1, 9) for side in (-1, 1) if (k, side) != (8, 1)]
    values += [1 - 2 * step, step, 3 * step]
    values += [10 ** rng.uniform(-30, -1) for _ in range(40)] + [rng.uniform(0, 1) for _ in range(240)]
    for turn in map(rounded, values):
        # From the nearest quarter, where one of them is exactly 0.
        quarter = round(4 * Fraction(turn))
        sine, cosine = sin_cos(2 * PI * (Fraction(turn) - Fraction(quarter, 4)))
        for _ in range(quarter):
            sine, cosine = cosine, -sine
        yield f"{number(turn)}, {exact(sine)}, {exact(cosine)}"


HEADERS = {
    "tests/common/exact_differences.hpp": header(
        "00_common.py", "Difference", ["double v[4]", "checkpoint::Exact difference"], differences),
    "tests/common/exact_operations.hpp": header(
        "00_common.py", "Operation",
        ["double a[2], b[2]", "checkpoint::Exact sum, difference, product, quotient, root"],
        operations),
    "tests/common/exact_transfers.hpp": header(
        "00_common.py", "Transfer", ["double x", "checkpoint::Exact encoded, decoded"], transfers),
    "tests/common/exact_turns.hpp": header(
        "00_common.py", "Turn", ["double turn", "checkpoint::Exact sine, cosine"], turns),
}
