"""Exact tables for chapter 02."""
from exact import *


def viewports(precision):
    """Fields of view from a thousandth of a degree to 179.9 degrees."""
    rounded, rng = rounder(precision), seeded("viewports", precision)
    degrees = [0.001, 0.01, 0.1, 1, 20, 45, 50, 60, 90, 120, 140, 170, 179, 179.9]
    degrees += [10 ** rng.uniform(-3, 2.2) for _ in range(30)]
    degrees += [180 - 10 ** rng.uniform(-1, 1.5) for _ in range(20)]
    for degree in degrees:
        fov = rounded(degree * math.pi / 180)
        aspect = rounded(rng.choice([1, 1.5, 16 / 9, 1e-4, 1e4, 10 ** rng.uniform(-1, 1)]))
        sine, cosine = sin_cos(Fraction(fov) / 2)
        height = 2 * sine / cosine
        yield f"{number(degree)}, {number(fov)}, {number(aspect)}, " \
              f"{exact(height * Fraction(aspect))}, {exact(height)}"


def unit(v):
    """The vector with length 1 in the direction of v, each component to about BITS bits."""
    length = sqrt(dot(v, v))
    return [round_bits(Fraction(c) / length) for c in v]


def round_bits(x):
    """x to 400 bits after the point, so that fractions do not grow without end."""
    return Fraction(round(x * (1 << 400)), 1 << 400)


def basis(back, up):
    w, u = unit(back), unit(cross(up, back))
    return u, unit(cross(back, cross(up, back))), w


def difference(a, b):
    return [Fraction(p) - Fraction(q) for p, q in zip(a, b)]


def views(precision):
    """Cameras: near and far, tiny and huge, and such that look almost along up."""
    rounded, rng = rounder(precision), seeded("views", precision)
    far = 30 if precision == "float" else 200
    digits = 24 if precision == "float" else 53

    def row(start, target, up, near_parallel):
        u, v, w = basis(difference(start, target), up)
        return f"{numbers(start)}, {numbers(target)}, {numbers(up)}, {near_parallel}, " \
               f"{exact_vector(u)}, {exact_vector(v)}, {exact_vector(w)}"

    def vector(size):
        return [rounded(size * rng.uniform(-1, 1)) for _ in range(3)]

    # Well apart: the angle between the view and up is at least 30 degrees.
    count = 0
    while count < 40:
        scale = [1, 1, 1e6, 10.0 ** (far - 1), 10.0**-far][count % 5]
        distance = 1 if scale == 1e6 else scale
        start = vector(scale)
        target = [rounded(a + b) for a, b in zip(start, vector(distance))]
        up = vector(rng.choice([1, 10.0**-far, 10.0 ** (far - 1)]))
        u, _, w = basis(difference(start, target), up)
        sine_squared = dot(cross(unit(up), w), cross(unit(up), w))
        if sine_squared > Fraction(1, 4):
            count += 1
            yield row(start, target, up, "false")
    # Nearly parallel, looking at the origin, so that no rounding stands between input and angle.
    for i in range(40):
        up = vector(1) if i % 3 else [0, 1, 0]
        angle = 2.0 ** rng.uniform(-(digits - 3), -4)
        sign = rng.choice([-3, 5])
        start = [rounded(sign * (a + angle * b)) for a, b in zip(up, vector(1))]
        if any(cross(up, start)):
            yield row(start, [0, 0, 0], up, "true")


def rays(precision):
    """Cameras turned in any direction, with fields of view from 0.001 to 179.9 degrees."""
    rounded, rng = rounder(precision), seeded("rays", precision)
    degrees = [0.001, 0.01, 1, 20, 90, 140, 179, 179.9]
    sizes = [(960, 540), (1, 1), (1, 10000), (10000, 1), (3, 2), (641, 359)]
    for i in range(72):
        b = [[rounded(float(c)) for c in e]
             for e in basis([rng.uniform(-1, 1) for _ in range(3)],
                            [rng.uniform(-1, 1) for _ in range(3)])]
        width, height = sizes[i % len(sizes)]
        degree = degrees[i % len(degrees)]
        tall = rounded(2 * math.tan(degree * math.pi / 360))
        wide = rounded(tall * width / height)
        column, row = rng.choice([0, width // 2, width - 1]), rng.choice([0, height // 2, height - 1])
        offset = [rounded(rng.choice([0.5, rng.uniform(0, 1)])) for _ in range(2)]
        x = ((column + Fraction(offset[0])) / width - Fraction(1, 2)) * Fraction(wide)
        y = (Fraction(1, 2) - (row + Fraction(offset[1])) / height) * Fraction(tall)
        d = unit([x * Fraction(b[0][k]) + y * Fraction(b[1][k]) - Fraction(b[2][k])
                  for k in range(3)])
        yield f"{number(degree)}, {width}, {height}, {column}, {row}, {numbers(offset)}, " \
              f"{numbers([wide, tall])}, {numbers(b[0])}, {numbers(b[1])}, {numbers(b[2])}, " \
              f"{exact_vector(d)}"


HEADERS = {
    "tests/02_camera/exact_viewports.hpp": header(
        "02_camera.py", "Viewport",
        ["double degrees, vertical_fov, aspect_ratio", "checkpoint::Exact width, height"],
        viewports),
    "tests/02_camera/exact_views.hpp": header(
        "02_camera.py", "View",
        ["double from[3], at[3], up[3]", "bool nearly_parallel", "checkpoint::ExactVec3 u, v, w"],
        views),
    "tests/02_camera/exact_rays.hpp": header(
        "02_camera.py", "Ray",
        ["double degrees", "int width, height, column, row", "double offset[2], viewport[2]",
         "double u[3], v[3], w[3]", "checkpoint::ExactVec3 direction"], rays),
}
