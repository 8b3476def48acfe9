#include <rt/transform.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Mat4;

namespace {

// x is doubled, y goes to z, z to -y, and all moves by (10, 20, 30). Its inverse is known by hand.
const Mat4 map{{{{2, 0, 0, 10}, {0, 0, -1, 20}, {0, 1, 0, 30}, {0, 0, 0, 1}}}};
const Mat4 inverse_of_map{{{{real(0.5), 0, 0, -5}, {0, 0, 1, -30}, {0, -1, 0, 20}, {0, 0, 0, 1}}}};

Exact dot(const Vec3& a, const Vec3& b) {
    return Exact(a.x) * Exact(b.x) + Exact(a.y) * Exact(b.y) + Exact(a.z) * Exact(b.z);
}

}  // namespace

TEST_CASE("01.5 a point is turned and moved", "[01.5]") {
    const Vec3 computed = rt::transform_point(map, {1, 2, 3});
    INFO("yours gives " << text(computed)
                        << ".\nHint: each row times (x, y, z, 1); (12, 17, 32) is 2 x, -z, y, then "
                           "+ (10, 20, 30)");
    CHECK(computed == Vec3{12, 17, 32});
}

TEST_CASE("01.5 a direction is turned but not moved", "[01.5]") {
    const Vec3 computed = rt::transform_vector(map, {1, 2, 3});
    INFO("yours gives " << text(computed) << ".\nHint: each row times (x, y, z, 0)");
    CHECK(computed == Vec3{2, -3, 2});
}

TEST_CASE("01.5 a normal stays perpendicular to its surface", "[01.5]") {
    // A slope along (1, 1, 0) has the normal (1, -1, 0). Stretched twice in x it runs along (2, 1,
    // 0).
    const Mat4 stretch = rt::scaling({2, 1, 1}), shrink = rt::scaling({real(0.5), 1, 1});
    const Vec3 along = rt::transform_vector(stretch, {1, 1, 0});
    const Vec3 normal = rt::transform_normal(shrink, {1, -1, 0});
    INFO("the surface now runs along " << text(along) << ", your normal is " << text(normal)
                                       << ", which must be perpendicular to that.\nHint: the "
                                          "columns of the inverse, not its rows, "
                                          "times n");
    CHECK(dot(along, normal).high == 0);
    CHECK(normal == Vec3{real(0.5), -1, 0});
}

TEST_CASE("01.5 a normal takes the columns of the inverse and does not move", "[01.5]") {
    const Vec3 computed = rt::transform_normal(inverse_of_map, {1, 2, 3});
    INFO("yours gives " << text(computed)
                        << ".\nHint: component x is column 0 of the inverse times n, and so on; "
                           "the translation is left out");
    CHECK(computed == Vec3{real(0.5), -3, 2});
}

TEST_CASE("01.5 the product of two maps applies the right one first", "[01.5]") {
    const Mat4 move = rt::translation({1, 0, 0}), stretch = rt::scaling({2, 3, 4});
    const Mat4 moved_last = rt::multiply(move, stretch), moved_first = rt::multiply(stretch, move);
    INFO(
        "Hint: entry (row, column) is the sum over k of a(row, k) b(k, column), and the sum starts "
        "at 0");
    CHECK(moved_last == Mat4{{{{2, 0, 0, 1}, {0, 3, 0, 0}, {0, 0, 4, 0}, {0, 0, 0, 1}}}});
    CHECK(moved_first == Mat4{{{{2, 0, 0, 2}, {0, 3, 0, 0}, {0, 0, 4, 0}, {0, 0, 0, 1}}}});
}

TEST_CASE("01.5 a map times its inverse is the identity", "[01.5][hard]") {
    CHECK(rt::multiply(map, inverse_of_map) == Mat4{});
    CHECK(rt::multiply(inverse_of_map, map) == Mat4{});
}

TEST_CASE("01.5 a sheared and squeezed surface keeps its normal", "[01.5][hard]") {
    // Powers of two, so that nothing is rounded: the angle must be right exactly.
    const Real s = real(for_this_precision(0x1p-20, 0x1p-200));
    const Mat4 shear{{{{1, 4, 0, 7}, {0, s, 0, 8}, {0, 0, 1 / s, 9}, {0, 0, 0, 1}}}};
    const Mat4 unshear{{{{1, -4 / s, 0, 0}, {0, 1 / s, 0, 0}, {0, 0, s, 0}, {0, 0, 0, 1}}}};
    const Vec3 normal = rt::transform_normal(unshear, {1, 2, 0});
    const Vec3 along = rt::transform_vector(shear, {2, -1, 0});
    INFO("the surface now runs along " << text(along) << ", your normal is " << text(normal));
    CHECK(dot(along, normal).high == 0);
    CHECK(std::abs(normal.x) + std::abs(normal.y) > 0);
}

TEST_CASE("01.5 a point is within the bound of four roundings", "[01.5][hard]") {
    // Terms that cancel: the bound is on the size of the terms, not of their sum.
    const Real big = real(for_this_precision(1e7, 1e15));
    const Mat4 m{
        {{{big, -big, 1, 3}, {1, 2, real(0.1), -5}, {real(0.3), 7, -big, big}, {0, 0, 0, 1}}}};
    const Vec3 p{real(0.7), real(0.7), real(1.1)};
    const Vec3 computed = rt::transform_point(m, p);
    const Real rows[3] = {computed.x, computed.y, computed.z};
    for (int i = 0; i < 3; ++i) {
        const Vec3 row{m(i, 0), m(i, 1), m(i, 2)};
        const Exact expected = dot(row, p) + Exact(m(i, 3));
        const Vec3 sizes{std::abs(row.x * p.x), std::abs(row.y * p.y), std::abs(row.z * p.z)};
        const Real size = sizes.x + sizes.y + sizes.z + std::abs(m(i, 3));
        HINT(expected, rows[i], "sum x, y, z and the translation, once each");
        CHECK(std::abs((expected - Exact(rows[i])).high) <=
              static_cast<double>(rt::rounding_bound(5) * size));
    }
}
