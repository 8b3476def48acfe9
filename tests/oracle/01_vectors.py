"""Exact tables for chapter 01."""
from exact import *


def lengths(precision):
    """Vectors of every size, also of such that their squares overflow or underflow."""
    rounded, rng = rounder(precision), seeded("lengths", precision)
    far = 30 if precision == "float" else 200
    vectors = [[1, 0, 0], [0, -2, 0], [3, 4, 0], [2, 3, 6], [-1, 1, 1]]
    vectors += [random_vector(rng, rounded) for _ in range(200)]
    # Where the squares become subnormal numbers, which hold fewer digits the smaller they are.
    fading = (-19, -20, -21, -22) if precision == "float" else (-155, -157, -159, -161)
    for e in (-far, -far // 2, *fading, 19, far // 2, far):
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


def inverse3(columns):
    """The rows of the inverse of the matrix with these columns, None where it is singular."""
    a, b, c = columns
    determinant = dot(a, cross(b, c))
    if determinant == 0:
        return None
    return [[x / determinant for x in row] for row in (cross(b, c), cross(c, a), cross(a, b))]


def inverses(precision):
    """Columns of a linear part and the rows of its inverse; also badly scaled and nearly flat ones."""
    rounded, rng = rounder(precision), seeded("inverses", precision)
    far = 9 if precision == "float" else 100
    flat = 1e-3 if precision == "float" else 1e-9
    matrices = [[[2, 0, 0], [0, 4, 0], [0, 0, 8]], [[1, 0, 0], [1, 1, 0], [0, 0, 1]],
                [[0, 1, 0], [0, 0, 1], [1, 0, 0]]]
    matrices += [[random_vector(rng, rounded) for _ in range(3)] for _ in range(60)]
    for e in (-far, far):
        matrices += [[random_vector(rng, rounded, e, e + 1) for _ in range(3)] for _ in range(10)]
    for _ in range(20):  # the third column almost in the plane of the other two
        a, b = random_vector(rng, rounded, 0, 1), random_vector(rng, rounded, 0, 1)
        matrices.append([a, b, [rounded(p + q + flat * rng.uniform(-1, 1)) for p, q in zip(a, b)]])
    for columns in matrices:
        rows = inverse3(columns)
        if rows:
            yield "{" + ", ".join(numbers(c) for c in columns) + "}, {" + \
                  ", ".join(exact_vector(r) for r in rows) + "}"


HEADERS = {
    "tests/01_vectors/exact_lengths.hpp": header(
        "01_vectors.py", "Length",
        ["double v[3]", "checkpoint::Exact length", "checkpoint::ExactVec3 unit"], lengths),
    "tests/01_vectors/exact_products.hpp": header(
        "01_vectors.py", "Product",
        ["double a[3], b[3]", "checkpoint::Exact dot", "checkpoint::ExactVec3 cross",
         "bool nearly_parallel"], crosses),
    "tests/01_vectors/exact_inverses.hpp": header(
        "01_vectors.py", "Inverse", ["double columns[3][3]", "checkpoint::ExactVec3 rows[3]"],
        inverses),
}
