"""Exact tables for chapter 03."""
from exact import *


def equation(kind, a, b, c):
    """A row, with the exact solutions of a t^2 + b t + c = 0; none where they are not real."""
    fa, fb, fc = Fraction(a), Fraction(b), Fraction(c)
    discriminant = fb * fb - 4 * fa * fc
    low = high = Fraction(0)
    if discriminant >= 0:
        # Without cancellation, since sqrt has "only" 200 bits.
        q = -(fb + sqrt(discriminant) * (1 if fb >= 0 else -1)) / 2
        low, high = sorted([q / fa, fc / q])
    return f'"{kind}", {number(a)}, {number(b)}, {number(c)}, {exact(discriminant)}, ' \
           f'{exact(low)}, {exact(high)}'


def quadratics(precision):
    rounded, rng = rounder(precision), seeded("quadratics", precision)
    bits = 24 if precision == "float" else 53
    most = 8 if precision == "float" else 60  # decimal digits between coefficients

    def size(low, high):
        return rounded(rng.choice([-1, 1]) * 10 ** rng.uniform(low, high))

    for _ in range(60):
        yield equation("random", size(-2, 2), size(-2, 2), size(-2, 2))
    for _ in range(60):  # b^2 much larger than 4 a c
        yield equation("small root", size(-1, 1), size(most / 4, most / 2), size(-most / 4, 1))
    for _ in range(60):  # (p t - q)^2 with the coefficients rounded: two solutions, one or none
        p, q = rng.uniform(1, 2), rng.uniform(1, 2)
        yield equation("nearly equal", rounded(p * p), rounded(-2 * p * q), rounded(q * q))
    half = bits // 2
    for _ in range(20):  # p and q short enough for exact coefficients: exactly one solution
        p, q = rng.getrandbits(half - 1) | 1, rng.getrandbits(half - 1) | 1
        yield equation("exactly equal", float(p * p), float(-2 * p * q), float(q * q))
    for _ in range(20):  # discriminant 4: b^2 and 4 a c share all digits but the last
        n = (1 << (bits - 2)) + 2 * rng.getrandbits(bits - 4)
        yield equation("nearly equal", float(n), float(2 * (n + 1)), float(n + 2))
    far = 17 if precision == "float" else 150
    for _ in range(40):
        yield equation("huge discriminant", size(far - 2, far), size(far - 2, far),
                       -size(far - 2, far))


def hit(kind, precision, center, radius, origin, direction):
    """A row, or None where rounding may decide between hit and miss."""
    f = [Fraction(o) - Fraction(c) for o, c in zip(origin, center)]
    r, eps = Fraction(radius), Fraction(1, 1 << (23 if precision == "float" else 52))
    a, b = dot(direction, direction), dot(f, direction)
    moment = cross(f, direction)
    p, size = sqrt(dot(moment, moment) / a), sqrt(dot(f, f)) + r
    if abs(p - r) < 3 * eps * size:
        return None
    hits, low, high, allowed = p < r, Fraction(0), Fraction(0), Fraction(0)
    if hits:
        h, length = sqrt(r * r - p * p), sqrt(a)
        low, high = (-b / length - h) / length, (-b / length + h) / length
        allowed = 6 * eps * size * (1 + p / h) / length
    return f'"{kind}", {numbers(center)}, {number(radius)}, {numbers(origin)}, ' \
           f'{numbers(direction)}, {"true" if hits else "false"}, {exact(low)}, {exact(high)}, ' \
           f'{number(round_to_double(allowed))}'


def hits(precision):
    rounded, rng = rounder(precision), seeded("hits", precision)
    eps = 2.0**-23 if precision == "float" else 2.0**-52

    def unit():
        v = [rng.gauss(0, 1) for _ in range(3)]
        return [x / math.sqrt(sum(y * y for y in v)) for x in v]

    def perpendicular(w):
        v = unit()
        along = sum(x * y for x, y in zip(v, w))
        v = [x - along * y for x, y in zip(v, w)]
        return [x / math.sqrt(sum(y * y for y in v)) for x in v]

    def aimed(kind, radius, distance, aside, length=1.0, around=1.0):
        """A ray from so many radii away that passes the center at so many radii aside."""
        w = unit()
        side = perpendicular(w)
        center = [rounded(rng.uniform(-1, 1) * radius * around) for _ in range(3)]
        origin = [rounded(c + radius * distance * x) for c, x in zip(center, w)]
        # The direction that leaves the center exactly that far aside, as seen from the origin.
        sine = aside / distance
        cosine = math.sqrt(max(0.0, 1 - sine * sine))
        direction = [rounded(length * (sine * s - cosine * x)) for s, x in zip(side, w)]
        return hit(kind, precision, center, rounded(radius), origin, direction)

    rows = []
    for _ in range(60):
        rows.append(aimed("near", 10 ** rng.uniform(-1, 1), 1.5 + 10 * rng.random(),
                          1.5 * math.sqrt(rng.random())))
    for exponent in (2, 3, 4, 5, 6, 6, 6):
        for _ in range(15):
            rows.append(aimed("far", 10 ** rng.uniform(-1, 1), 10.0**exponent,
                              1.4 * math.sqrt(rng.random())))
    for _ in range(120):
        distance = 10 ** rng.uniform(0.3, 3)
        gap = 10 ** rng.uniform(math.log10(4 * eps * (distance + 1)), -2)
        rows.append(aimed("grazing", 10 ** rng.uniform(-1, 1), distance,
                          1 + rng.choice([-1, 1]) * gap))
    for _ in range(40):
        distance = rng.random()
        rows.append(aimed("inside", 10 ** rng.uniform(-1, 1), distance, distance * rng.random()))
    for radius in (1e-6, 1e6):
        for _ in range(20):
            rows.append(aimed("tiny or huge", radius, 2 + 100 * rng.random(),
                              1.3 * math.sqrt(rng.random())))
            # A speck seen in a room of 1 m, a planet from its surface.
            rows.append(aimed("tiny or huge", radius, 1e6 if radius < 1 else 1 + 1e-6,
                              math.sqrt(rng.random())))
    for _ in range(40):
        rows.append(aimed("any direction", 10 ** rng.uniform(-1, 1), 2 + 10 * rng.random(),
                          1.3 * math.sqrt(rng.random()), 10 ** rng.uniform(-6, 6)))
    for _ in range(40):  # rounded to the surface: just outside, just inside, or on it
        w, v = unit(), unit()
        r = rounded(10 ** rng.uniform(-1, 1))
        center = [rounded(rng.uniform(-3, 3)) for _ in range(3)]
        rows.append(hit("surface", precision, center, r,
                        [rounded(c + r * x) for c, x in zip(center, w)], [rounded(x) for x in v]))
    yield from (row for row in rows if row)


HEADERS = {
    "tests/03_sphere/exact_quadratics.hpp": header(
        "03_sphere.py", "Quadratic",
        ["const char* kind", "double a, b, c",
         "checkpoint::Exact discriminant, low, high"], quadratics),
    # allowed is how much the computed t may differ: 6 epsilon (|f| + r) (1 + p / h) / |d|.
    "tests/03_sphere/exact_hits.hpp": header(
        "03_sphere.py", "Hit",
        ["const char* kind", "double center[3], radius, origin[3], direction[3]", "bool hits",
         "checkpoint::Exact low, high", "double allowed"], hits),
}
