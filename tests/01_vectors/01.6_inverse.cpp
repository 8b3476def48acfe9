#include <rt/inverse.hpp>
#include <rt/rng.hpp>

#include "checkpoint.hpp"
#include "exact_inverses.hpp"

using namespace checkpoint;
using rt::Mat4;

namespace {

Mat4 matrix(const exact::Inverse& row, Vec3 origin) {
    return rt::from_columns(vec3(row.columns[0]), vec3(row.columns[1]), vec3(row.columns[2]),
                            origin);
}

// Whether the inverse is refused, and refused by the right exception.
bool is_refused(const Mat4& m) {
    try {
        rt::inverse(m);
    } catch (const std::domain_error&) {
        return true;
    }
    return false;
}

Vec3 row_of(const Mat4& m, int row) {
    return {m(row, 0), m(row, 1), m(row, 2)};
}

// How much rounding in the cross products is amplified: the sum of the terms of the determinant
// without their signs, divided by the determinant. 1 where nothing cancels.
double condition(const exact::Inverse& row, int i) {
    const auto& [x, y, z] = row.rows[i];
    const double* column = row.columns[i];
    return std::abs(column[0] * x.high) + std::abs(column[1] * y.high) +
           std::abs(column[2] * z.high);
}

}  // namespace

TEST_CASE("01.6 the inverse undoes stretching and moving", "[01.6]") {
    const Mat4 m{{{{2, 0, 0, 10}, {0, 0, -1, 20}, {0, 1, 0, 30}, {0, 0, 0, 1}}}};
    const Mat4 computed = rt::inverse(m);
    INFO(
        "row 0 is " << text(row_of(computed, 0)) << ' ' << text(computed(0, 3)) << ", row 1 "
                    << text(row_of(computed, 1)) << ' ' << text(computed(1, 3)) << ", row 2 "
                    << text(row_of(computed, 2)) << ' ' << text(computed(2, 3))
                    << ".\nHint: the last column of the inverse is the inverse's linear part times "
                       "the translation, negative");
    CHECK(computed ==
          Mat4{{{{real(0.5), 0, 0, -5}, {0, 0, 1, -30}, {0, -1, 0, 20}, {0, 0, 0, 1}}}});
}

TEST_CASE("01.6 to_object and to_world are each other's way back", "[01.6]") {
    const Mat4 placement = rt::multiply(rt::translation({4, 8, -16}), rt::scaling({2, 4, 8}));
    CHECK(rt::to_world(placement, {1, 1, 1}) == Vec3{6, 12, -8});
    CHECK(rt::to_object(placement, {6, 12, -8}) == Vec3{1, 1, 1});
    CHECK(rt::to_object(placement, {4, 8, -16}) == Vec3{0, 0, 0});
}

TEST_CASE("01.6 the inverse is as accurate as its determinant allows", "[01.6][hard]") {
    for (const auto& row : exact::inverses()) {
        const Mat4 computed = rt::inverse(matrix(row, {0, 0, 0}));
        for (int i = 0; i < 3; ++i) {
            INFO("columns " << text(vec3(row.columns[0])) << ' ' << text(vec3(row.columns[1]))
                            << ' ' << text(vec3(row.columns[2])) << ", row " << i
                            << " of the inverse");
            HINT(row.rows[i], row_of(computed, i),
                 "build it from your cross product, which keeps its digits on nearly parallel "
                 "columns, and split_scale the columns so that nothing overflows");
            // 3 roundings of the cross product and 1 of the division, 6 of the determinant.
            CHECK(error_in_ulp(row_of(computed, i), row.rows[i]) <= 4 + 6 * condition(row, i));
        }
    }
}

TEST_CASE("01.6 a singular matrix is refused", "[01.6][hard]") {
    const auto check_refused = [](const Mat4& m) {
        INFO("this matrix flattens space:\n"
             << m
             << "Hint: throw std::domain_error where the determinant, without its sign, is not "
                "larger than its own rounding error");
        CHECK(is_refused(m));
    };
    const Vec3 a{1, real(0.1), -3}, b{real(0.7), 2, real(0.3)};
    check_refused(rt::scaling({1, 0, 1}));
    check_refused(rt::from_columns(a, b, a));
    check_refused(rt::from_columns(a, -2 * a, b));
    check_refused(rt::from_columns({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
    // d = e + f exactly, in numbers too long for exact products: the determinant is 0, but what
    // rounding makes of it need not be.
    rt::Rng rng{6, 1};
    const Real k = real(for_this_precision(0x1p22, 0x1p51));
    const auto whole = [&] { return std::floor(rng.uniform(-k, k)); };
    for (int i = 0; i < 20; ++i) {
        const Vec3 e{whole(), whole(), whole()}, f{whole(), whole(), whole()};
        check_refused(rt::from_columns(e + f, e, f));
        check_refused(rt::from_columns(e, f, e + f));
    }
}

TEST_CASE("01.6 a matrix that is not finite is refused", "[01.6][hard]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    INFO("Hint: not-a-number compares false with everything; is_finite(v) tells");
    CHECK(is_refused(rt::scaling({1, 1, nan})));
    CHECK(is_refused(rt::scaling({rt::infinity, 1, 1})));
    CHECK(is_refused(rt::translation({rt::infinity, 0, 0})));
    CHECK(is_refused(rt::translation({0, nan, 0})));
}

TEST_CASE("01.6 a mirror is not singular", "[01.6]") {
    INFO("its determinant is negative, which is no flaw: compare without the sign");
    CHECK(rt::inverse(rt::scaling({1, 1, -1})) == rt::scaling({1, 1, -1}));
}

TEST_CASE("01.6 small is not singular", "[01.6][hard]") {
    // A scene in nanometers beside one in light years; its determinant is far from 1, not its
    // shape.
    const Real s = real(for_this_precision(0x1p-40, 0x1p-400));
    INFO(
        "Hint: compare the determinant with its own rounding error, not with a constant; and "
        "split_scale "
        "the columns, so that no product of three overflows or underflows");
    CHECK(rt::inverse(rt::scaling({s, s, s})) == rt::scaling({1 / s, 1 / s, 1 / s}));
    CHECK(rt::inverse(rt::scaling({1 / s, s, 1})) == rt::scaling({s, 1 / s, 1}));
}
