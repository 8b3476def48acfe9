#include <rt/transform.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;
using rt::Mat4;

namespace {

// x is doubled, y goes to z, z to -y, and everything moves by (10, 20, 30). Its inverse
// was found by hand.
const Mat4 map{{{{2, 0, 0, 10}, {0, 0, -1, 20}, {0, 1, 0, 30}, {0, 0, 0, 1}}}};
const Mat4 inverse_of_map{{{{real(0.5), 0, 0, -5}, {0, 0, 1, -30}, {0, -1, 0, 20}, {0, 0, 0, 1}}}};

Exact dot(const Vec3& a, const Vec3& b) {
    return dot(exact_vector(a), exact_vector(b));
}

Vec3 row_of(const Mat4& m, int row) {
    return {m(row, 0), m(row, 1), m(row, 2)};
}
Vec3 column_of(const Mat4& m, int column) {
    return {m(0, column), m(1, column), m(2, column)};
}

// A map that has no symmetry at all.
Mat4 any_map(rt::Rng& rng, Real low, Real high) {
    const Vec3 x = any_vector(rng, low, high), y = any_vector(rng, low, high),
               z = any_vector(rng, low, high), origin = any_vector(rng, low, high);
    return rt::from_columns(x, y, z, origin);
}

// The sum of the products of two vectors' components, plus one more number.
void check_sum(Vec3 a, Vec3 b, Real more, Real computed, const char* what) {
    const Exact expected = dot(a, b) + Exact(more);
    const double size =
        size_of_terms(exact_vector(a), exact_vector(b)) + static_cast<double>(std::abs(more));
    INFO(what << ": " EXPECTED << text(expected) << ", " ACTUAL << text(computed));
    const double error_over_allowed =
        times_allowed(computed, expected, static_cast<double>(rt::rounding_bound(5)) * size);
    REQUIRE(error_over_allowed <= 1);
}

// Every function, in every component.
void check_maps(rt::Rng& rng, Real low, Real high) {
    const Mat4 m = any_map(rng, low, high), other = any_map(rng, low, high);
    const Vec3 p = any_vector(rng, low, high);
    INFO("the matrix:\n" << m << "and (x, y, z) = " << text(p));
    const char* const names[] = {"x", "y", "z"};
    const auto check_vector = [&](const std::string& what, Vec3 computed, auto factors, auto more) {
        const Real components[] = {computed.x, computed.y, computed.z};
        for (int i = 0; i < 3; ++i)
            check_sum(factors(i), p, more(i), components[i], (what + ", " + names[i]).c_str());
    };
    const auto row = [&](int i) { return row_of(m, i); };
    const auto column = [&](int i) { return column_of(m, i); };
    const auto translation = [&](int i) { return m(i, 3); };
    const auto none = [](int) { return Real(0); };
    check_vector("transform_point", rt::transform_point(m, p), row, translation);
    check_vector("transform_vector", rt::transform_vector(m, p), row, none);
    check_vector("transform_normal, given the inverse", rt::transform_normal(m, p), column, none);

    const Mat4 product = rt::multiply(m, other);
    INFO("times the matrix:\n" << other);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) {
            const std::string entry = std::to_string(i) + ", " + std::to_string(j);
            check_sum(row_of(m, i), column_of(other, j), j == 3 ? m(i, 3) : 0, product(i, j),
                      ("multiply, entry (" + entry + ")").c_str());
        }
    const Vec3 last_row{product(3, 0), product(3, 1), product(3, 2)};
    INFO("multiply: the last row of the product must be 0 0 0 1");
    REQUIRE(last_row == Vec3{0, 0, 0});
    REQUIRE(product(3, 3) == 1);
}

}  // namespace

TEST_CASE("01.6 a point is turned and moved", "[01.6]") {
    const Vec3 computed = rt::transform_point(map, {1, 2, 3});
    INFO(EXPECTED "(12, 17, 32), " ACTUAL << text(computed)
                                          << ".\nHint: multiply each row by (x, y, z, 1): (12, 17, "
                                             "32) is (2 x, -z, y) + (10, 20, 30)");
    CHECK(computed == Vec3{12, 17, 32});
}

TEST_CASE("01.6 a direction is turned but not moved", "[01.6]") {
    const Vec3 computed = rt::transform_vector(map, {1, 2, 3});
    INFO(EXPECTED "(2, -3, 2), " ACTUAL << text(computed)
                                        << ".\nHint: multiply each row by (x, y, z, 0)");
    CHECK(computed == Vec3{2, -3, 2});
}

TEST_CASE("01.6 a normal stays perpendicular to its surface", "[01.6]") {
    // A slope along (1, 1, 0) has the normal (1, -1, 0). Stretched by 2 in x, it runs
    // along (2, 1, 0).
    const Mat4 stretch = rt::scaling({2, 1, 1}), shrink = rt::scaling({real(0.5), 1, 1});
    const Vec3 along = rt::transform_vector(stretch, {1, 1, 0});
    const Vec3 normal = rt::transform_normal(shrink, {1, -1, 0});
    INFO("the surface now runs along " << text(along) << ", and your normal is " << text(normal)
                                       << "; the two must be perpendicular.\nHint: multiply n by "
                                          "the columns of the inverse, not by its rows");
    CHECK(dot(along, normal).high == 0);
    CHECK(normal == Vec3{real(0.5), -1, 0});
}

TEST_CASE("01.6 transform_normal uses the columns of the inverse and no translation", "[01.6]") {
    const Vec3 computed = rt::transform_normal(inverse_of_map, {1, 2, 3});
    INFO(EXPECTED "(0.5, -3, 2), " ACTUAL
         << text(computed)
         << ".\nHint: component x is the dot product of column 0 of the inverse and n, and so on; "
            "leave the translation out");
    CHECK(computed == Vec3{real(0.5), -3, 2});
}

TEST_CASE("01.6 the product of two maps applies the right-hand map first", "[01.6]") {
    const Mat4 move = rt::translation({1, 0, 0}), stretch = rt::scaling({2, 3, 4});
    const Mat4 moved_last = rt::multiply(move, stretch), moved_first = rt::multiply(stretch, move);
    INFO(
        "Hint: entry (row, column) is the sum over k of a(row, k) b(k, column), and the sum starts "
        "at 0");
    CHECK(moved_last == Mat4{{{{2, 0, 0, 1}, {0, 3, 0, 0}, {0, 0, 4, 0}, {0, 0, 0, 1}}}});
    CHECK(moved_first == Mat4{{{{2, 0, 0, 2}, {0, 3, 0, 0}, {0, 0, 4, 0}, {0, 0, 0, 1}}}});
}

TEST_CASE("01.6 points and vectors and normals are correct under any map", "[01.6]") {
    rt::Rng rng{5, 1};
    for (int i = 0; i < 300; ++i) check_maps(rng, -1, 1);
}

TEST_CASE("01.6 a map times its inverse is the identity", "[01.6][hard]") {
    CHECK(rt::multiply(map, inverse_of_map) == Mat4{});
    CHECK(rt::multiply(inverse_of_map, map) == Mat4{});
}

TEST_CASE("01.6 a sheared and squeezed surface keeps its normal", "[01.6][hard]") {
    // Powers of two, so that nothing is rounded: the angle must be exactly right.
    const Real s = real(for_this_precision(0x1p-20, 0x1p-200));
    const Mat4 shear{{{{1, 4, 0, 7}, {0, s, 0, 8}, {0, 0, 1 / s, 9}, {0, 0, 0, 1}}}};
    const Mat4 unshear{{{{1, -4 / s, 0, 0}, {0, 1 / s, 0, 0}, {0, 0, s, 0}, {0, 0, 0, 1}}}};
    const Vec3 normal = rt::transform_normal(unshear, {1, 2, 0});
    const Vec3 along = rt::transform_vector(shear, {2, -1, 0});
    INFO("the surface now runs along " << text(along) << ", and your normal is " << text(normal));
    CHECK(dot(along, normal).high == 0);
    CHECK(std::abs(normal.x) + std::abs(normal.y) > 0);
}

TEST_CASE("01.6 each number is accurate to within five roundings", "[01.6][hard]") {
    // Terms of very different sizes, which may cancel: the bound is on the size of the terms.
    const Real far = for_this_precision<Real>(15, 100);
    rt::Rng rng{5, 2};
    for (int i = 0; i < 300; ++i) check_maps(rng, -far, far);
}
