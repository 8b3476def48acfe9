"""Exact tables for chapter 01."""
from exact import *


def lengths(precision):
    """Vectors of every size, also of such that their squares overflow or underflow."""
    rounded, rng = rounder(precision), seeded("lengths", precision)
    far = 30 if precision == "float" else 200
    vectors = [[1, 0, 0], [0, -2, 0], [3, 4, 0], [2, 3, 6], [-1, 1, 1]]
    vectors += [random_vector(rng, rounded) for _ in range(200)]
    for e in (-far, -far // 2, -19, 19, far // 2, far):
        vectors += [[rounded(3 * 10.0**e), 0, rounded(4 * 10.0**e)]]
        vectors += [random_vector(rng, rounded, e - 1, e + 1) for _ in range(20)]
    vectors += [[rounded(10.0**far), rounded(10.0**-far), 1], [1, rounded(10.0**-far), 0]]
    for v in vectors:
        length = sqrt(dot(v, v))
        yield f"{numbers(v)}, {exact(length)}, {exact_vector([Fraction(c) / length for c in v])}"


def crosses(precision):
    """Pairs of vectors: unrelated ones, and ones that are parallel but for their last digits."""
    rounded, rng = rounder(precision), seeded("crosses", precision)
    pairs = [([1, 0, 0], [0, 1, 0]), ([0, 1, 0], [0, 0, 1]), ([1, 2, 3], [4, 5, 6])]
    pairs += [(random_vector(rng, rounded), random_vector(rng, rounded)) for _ in range(150)]
    tiny = 2.0**-20 if precision == "float" else 2.0**-48
    for _ in range(150):
        a = random_vector(rng, rounded)
        pairs.append((a, [rounded(c * 3 * (1 + rng.uniform(-tiny, tiny))) for c in a]))
    for a, b in pairs:
        nearly_parallel = "true" if dot(cross(a, b), cross(a, b)) * 10**8 < dot(a, a) * dot(b, b) \
            else "false"
        yield f"{numbers(a)}, {numbers(b)}, {exact(dot(a, b))}, {exact_vector(cross(a, b))}, " \
              f"{nearly_parallel}"


HEADERS = {
    "tests/01_vectors/exact_lengths.hpp": header(
        "01_vectors.py", "Length",
        ["double v[3]", "checkpoint::Exact length", "checkpoint::ExactVec3 unit"], lengths),
    "tests/01_vectors/exact_products.hpp": header(
        "01_vectors.py", "Product",
        ["double a[3], b[3]", "checkpoint::Exact dot", "checkpoint::ExactVec3 cross",
         "bool nearly_parallel"], crosses),
}
