#include <rt/inverse.hpp>
#include <rt/rng.hpp>
#include <rt/todo.hpp>
#include <string>

#include "checkpoint.hpp"
#include "random_inputs.hpp"
#include "refusal.hpp"

using namespace checkpoint;
using rt::Mat4;

namespace {

std::string refusal_by_inverse(const Mat4& m) {
    return checkpoint::refusal([&] { rt::inverse(m); });
}
std::string refusal_by_to_object(const Mat4& m) {
    return checkpoint::refusal([&] { rt::to_object(m, {1, 2, 3}); });
}

double largest_error(Vec3 computed, const ExactVec3& exact) {
    const ExactVec3 off = exact - exact_vector(computed);
    return std::max({std::abs(off.x.high), std::abs(off.y.high), std::abs(off.z.high)});
}

Vec3 row_of(const Mat4& m, int row) {
    return {m(row, 0), m(row, 1), m(row, 2)};
}

// A map as its columns, each of ordinary size times a power of two, with the exact inverse of its
// linear part, in which the powers of two are left out.
struct Exactly {
    Vec3 columns[3];
    int exponents[3];
    Vec3 origin;
    ExactVec3 rows[3];
    // The sum of the absolute values of the determinant's terms, divided by the determinant. It
    // depends on the row or column by which the determinant is expanded; this is the largest.
    double condition = 0;
    // What an inverse in any stable way, such as elimination with the largest pivot, may be off by
    // in each number of the rows: Higham, "Accuracy and Stability of Numerical Algorithms", 2nd
    // ed., section 14.3.
    double any_way = 0;

    Exactly(Vec3 a, Vec3 b, Vec3 c, int e, int f, int g, Vec3 moved)
        : columns{a, b, c}, exponents{e, f, g}, origin{moved} {
        const ExactVec3 x = exact_vector(a), y = exact_vector(b), z = exact_vector(c);
        const ExactVec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
        const Exact determinant = dot(x, yz);
        if (determinant.high == 0) return;  // no inverse
        const Exact inverse = Exact(1) / determinant;
        rows[0] = inverse * yz, rows[1] = inverse * zx, rows[2] = inverse * xy;
        const auto by_row = [&](auto component) {
            return size_of_terms({component(x), component(y), component(z)},
                                 {component(rows[0]), component(rows[1]), component(rows[2])});
        };
        condition =
            std::max({size_of_terms(x, rows[0]), size_of_terms(y, rows[1]),
                      size_of_terms(z, rows[2]), by_row([](const ExactVec3& v) { return v.x; }),
                      by_row([](const ExactVec3& v) { return v.y; }),
                      by_row([](const ExactVec3& v) { return v.z; })});
        double size = 0, size_of_inverse = 0;
        for (const ExactVec3& column : {x, y, z}) size += size_of_terms(column, {1, 1, 1});
        for (const ExactVec3& row : rows) size_of_inverse += size_of_terms(row, {1, 1, 1});
        any_way = 8 * static_cast<double>(rt::epsilon) * size * size_of_inverse * size_of_inverse;
    }

    Mat4 map() const {
        const auto column = [&](int i) {
            return Vec3{std::scalbn(columns[i].x, exponents[i]),
                        std::scalbn(columns[i].y, exponents[i]),
                        std::scalbn(columns[i].z, exponents[i])};
        };
        return rt::from_columns(column(0), column(1), column(2), origin);
    }
    // Whether there is an inverse by so wide a margin that rounding cannot hide it.
    bool is_clear() const {
        return condition > 0 && condition * static_cast<double>(rt::epsilon) < 1.0 / 16;
    }
    double allowed_ulp() const { return 4 + 6 * condition; }
};

enum class Accuracy { of_any_way, of_determinant };

// Checks the linear part's numbers, the translation, and both transforms between the spaces. A sum
// may have the errors of its terms.
void check_inverse(const Exactly& exact, Vec3 point, Accuracy accuracy = Accuracy::of_determinant) {
    const bool is_any_way = accuracy == Accuracy::of_any_way;
    const Mat4 m = exact.map();
    INFO("the matrix:\n"
         << m
         << (is_any_way
                 ? ""
                 : "Hint: build the rows from your cross product, which keeps its digits for "
                   "nearly parallel columns, and scale the columns with split_scale so "
                   "that nothing overflows"));
    const Mat4 inverse = rt::inverse(m);
    const Real translations[] = {inverse(0, 3), inverse(1, 3), inverse(2, 3)};
    const ExactVec3 origin = exact_vector(exact.origin), p = exact_vector(point);
    // An ulp is at most epsilon times the number, and each term is rounded up to four more times.
    const double of_terms = (exact.allowed_ulp() + 4) * static_cast<double>(rt::epsilon);
    for (int i = 0; i < 3; ++i) {
        const auto unscaled = [&](Real x) { return std::scalbn(x, exact.exponents[i]); };
        const Vec3 row = row_of(inverse, i);
        const Vec3 computed{unscaled(row.x), unscaled(row.y), unscaled(row.z)};
        const ExactVec3& expected = exact.rows[i];
        const double moves = size_of_terms(expected, origin);
        const double moves_any_way = 4 * exact.any_way * size_of_terms(origin, {1, 1, 1});
        {
            INFO("row " << i << " of the inverse" << (exact.exponents[i] == 0 ? "" : ", unscaled"));
            HINT(expected, computed, "divide each row by the determinant, with its sign");
            if (is_any_way)
                REQUIRE(largest_error(computed, expected) <= exact.any_way);
            else
                REQUIRE(error_in_ulp(computed, expected) <= exact.allowed_ulp());
        }
        {
            const Exact moved = -dot(expected, origin);
            INFO("the last number of row " << i << " of the inverse");
            HINT(moved, unscaled(translations[i]),
                 "the last number is minus the dot product of the inverse's row and the "
                 "translation");
            const double error_over_allowed = times_allowed(
                unscaled(translations[i]), moved, is_any_way ? moves_any_way : of_terms * moves);
            REQUIRE(error_over_allowed <= 1);
        }
    }
    const Vec3 there = rt::to_object(m, point);
    const Real seen[] = {there.x, there.y, there.z};
    for (int i = 0; i < 3; ++i) {
        const auto unscaled = [&](Real x) { return std::scalbn(x, exact.exponents[i]); };
        const ExactVec3& expected = exact.rows[i];
        const double moves = size_of_terms(expected, origin);
        const Exact seen_there = dot(expected, p - origin);
        INFO("to_object, component " << i << ", of " << text(point));
        HINT(seen_there, unscaled(seen[i]), "call transform_point with the inverse");
        const double sizes = size_of_terms(origin, {1, 1, 1}) + size_of_terms(p, {1, 1, 1});
        const double error_over_allowed =
            times_allowed(unscaled(seen[i]), seen_there,
                          is_any_way ? 4 * exact.any_way * sizes
                                     : of_terms * (moves + size_of_terms(expected, p)));
        REQUIRE(error_over_allowed <= 1);
    }
    const Vec3 back = rt::to_world(m, point);
    const Real seen_back[] = {back.x, back.y, back.z}, origins[] = {m(0, 3), m(1, 3), m(2, 3)};
    for (int i = 0; i < 3; ++i) {
        const ExactVec3 row = exact_vector(row_of(m, i));
        const Exact moved = dot(row, p) + Exact(origins[i]);
        const double size = size_of_terms(row, p) + static_cast<double>(std::abs(origins[i]));
        INFO("to_world, component " << i << ", of " << text(point));
        HINT(moved, seen_back[i], "call transform_point with the map itself");
        const double error_over_allowed =
            times_allowed(seen_back[i], moved, static_cast<double>(rt::rounding_bound(5)) * size);
        REQUIRE(error_over_allowed <= 1);
    }
}

}  // namespace

TEST_CASE("01.7 the inverse undoes stretching and moving", "[01.7]") {
    const Mat4 m{{{{2, 0, 0, 10}, {0, 0, -1, 20}, {0, 1, 0, 30}, {0, 0, 0, 1}}}};
    const Mat4 expected{{{{real(0.5), 0, 0, -5}, {0, 0, 1, -30}, {0, -1, 0, 20}, {0, 0, 0, 1}}}};
    const Mat4 computed = rt::inverse(m);
    bool same = true, columns = true;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            same = same && computed(i, j) == expected(i, j);
            columns = columns && computed(j, i) == expected(i, j);
        }
    INFO("row 0 is " << text(row_of(computed, 0)) << ' ' << text(computed(0, 3)) << ", row 1 "
                     << text(row_of(computed, 1)) << ' ' << text(computed(1, 3)) << ", row 2 "
                     << text(row_of(computed, 2)) << ' ' << text(computed(2, 3)) << ".\nHint: "
                     << (same ? "the last column of the inverse is minus the inverse's linear part "
                                "times the translation"
                         : columns ? "rows and columns are exchanged: from_columns takes columns, "
                                     "and the cross products are rows"
                                   : "row 0 is b x c divided by the determinant"));
    CHECK(computed == expected);
}

TEST_CASE("01.7 to_object and to_world undo each other", "[01.7]") {
    const Mat4 placement = rt::multiply(rt::translation({4, 8, -16}), rt::scaling({2, 4, 8}));
    CHECK(rt::to_world(placement, {1, 1, 1}) == Vec3{6, 12, -8});
    CHECK(rt::to_object(placement, {6, 12, -8}) == Vec3{1, 1, 1});
    CHECK(rt::to_object(placement, {4, 8, -16}) == Vec3{0, 0, 0});
    // The same linear part at another place: nothing may be kept from the calls before.
    const Mat4 moved = rt::multiply(rt::translation({0, 0, 8}), rt::scaling({2, 4, 8}));
    CHECK(rt::to_object(moved, {2, 4, 16}) == Vec3{1, 1, 1});
}

TEST_CASE("01.7 any map that has an inverse is inverted", "[01.7]") {
    rt::Rng rng{16, 1};
    const auto any = [&] { return any_vector(rng, -1, 1); };
    for (int i = 0; i < 300; ++i) {
        const Vec3 a = any(), b = any(), c = any(), origin = any() * Real(i % 2 ? 1 : 10'000);
        const Exactly exact{a, b, c, 0, 0, 0, origin};
        if (exact.condition > 0 && exact.condition < 100)
            check_inverse(exact, any(), Accuracy::of_any_way);
    }
    // Nearly a turn, and nearly no change at all.
    for (int i = 0; i < 100; ++i) {
        const Real little = std::pow(Real(10), rng.uniform(-15, -1));
        const Mat4 turn = rt::rotation_y(rng.uniform(-3, 3) * Real(i % 2));
        const auto column = [&](int k) {
            return Vec3{turn(0, k), turn(1, k), turn(2, k)} + any() * little;
        };
        const Vec3 a = column(0), b = column(1), c = column(2), origin = any();
        const Exactly exact{a, b, c, 0, 0, 0, origin};
        if (exact.condition > 0 && exact.condition < 100)
            check_inverse(exact, any(), Accuracy::of_any_way);
    }
}

TEST_CASE("01.7 the inverse is as accurate as its determinant allows", "[01.7][hard]") {
    rt::Rng rng{16, 2};
    const auto any = [&] { return any_vector(rng, -1, 1); };
    check_inverse({{2, 0, 0}, {0, 4, 0}, {0, 0, 8}, 0, 0, 0, any()}, any());
    check_inverse({{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, 0, 0, 0, any()}, any());
    check_inverse({{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0, 0, any()}, any());
    // Ever closer to a plane.
    for (int i = 0; i < 600; ++i) {
        const Vec3 a = any(), b = any(), origin = any();
        const Vec3 c =
            rng.uniform(-2, 2) * a + rng.uniform(-2, 2) * b +
            std::pow(Real(10), rng.uniform(for_this_precision<Real>(-7, -16), 0)) * any();
        // Stretching along the axes by powers of two makes it no flatter.
        const int most = i % 2 == 0 ? 0 : for_this_precision(8, 20);
        const auto power = [&] {
            return std::scalbn(Real(1), static_cast<int>(rng() % 64) * most / 32 - most);
        };
        const Vec3 stretch{power(), power(), power()};
        const Exactly exact{stretch * a, stretch * b, stretch * c, 0, 0, 0, origin};
        if (exact.is_clear()) check_inverse(exact, any());
    }
}

TEST_CASE("01.7 all rows are divided by the same determinant", "[01.7][hard]") {
    // The bound takes the largest sum of terms over all expansions of the determinant. With each
    // row's own sum, that of its column, it would be too tight for some of these rows.
    rt::Rng rng{16, 4};
    for (int i = 0; i < 1500; ++i) {
        const auto any = [&] { return any_vector(rng, -1, 1); };
        const auto power = [&] { return std::scalbn(Real(1), static_cast<int>(rng() % 12)); };
        const Vec3 a = any(), b = any(), near = any();
        const Vec3 c = rng.uniform(-2, 2) * a + rng.uniform(-2, 2) * b + real(0.01) * near;
        const Vec3 stretch{power(), power(), power()};
        const Exactly exact{stretch * a, stretch * b, stretch * c, 0, 0, 0, any()};
        if (exact.is_clear()) check_inverse(exact, any());
    }
    // Columns of numbers that differ in size as much as they may.
    const Real apart = for_this_precision<Real>(15, 140);
    for (int i = 0; i < 500; ++i) {
        const auto any = [&] { return rt::split_scale(any_vector(rng, -apart, 0)).v; };
        const Vec3 a = any(), b = any(), c = any();
        const Exactly exact{a, b, c, 0, 0, 0, any_vector(rng, -1, 1)};
        if (exact.is_clear()) check_inverse(exact, any_vector(rng, -1, 1));
    }
}

TEST_CASE("01.7 a singular matrix is refused", "[01.7][hard]") {
    const auto check_refused = [](const Mat4& m) {
        INFO("this matrix flattens space:\n"
             << m
             << "Hint: throw std::domain_error if the absolute value of the determinant is not "
                "larger than its own rounding error");
        CHECK(refusal_by_inverse(m) == "std::domain_error");
        CHECK(refusal_by_to_object(m) == "std::domain_error");
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

TEST_CASE("01.7 a matrix that is not finite is refused", "[01.7][hard]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (const Real bad : {rt::infinity, -rt::infinity, nan})
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column) {
                Mat4 m{{{{2, 1, 0, 10}, {0, 3, -1, 20}, {-1, 1, 1, 30}, {0, 0, 0, 1}}}};
                m(row, column) = bad;
                INFO("inverse and to_object must throw std::domain_error for\n"
                     << m << "Hint: every comparison with NaN is false: test with is_finite(v)");
                CHECK(refusal_by_inverse(m) == "std::domain_error");
                CHECK(refusal_by_to_object(m) == "std::domain_error");
            }
}

TEST_CASE("01.7 a map that mirrors is inverted although its determinant is negative", "[01.7]") {
    INFO("the determinant is negative, which is allowed: compare its absolute value");
    check_inverse({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 0, 0, 0, {1, 2, 3}}, {4, 5, 6});
}

TEST_CASE("01.7 a map with a tiny or huge determinant is not refused", "[01.7][hard]") {
    // A scene in nanometers beside one in light years: the determinant is far from 1, but the
    // shape is ordinary.
    INFO(
        "Hint: compare the determinant with its own rounding error, not with a constant; and "
        "scale the columns with split_scale, so that no product of three numbers overflows or "
        "underflows");
    const int far = for_this_precision(50, 480), apart = for_this_precision(16, 100);
    rt::Rng rng{16, 3};
    const auto any = [&] { return any_vector(rng, -1, 1); };
    const auto exponent = [&](int most) {
        return static_cast<int>(rng() % static_cast<unsigned>(2 * most)) - most;
    };
    for (int i = 0; i < 400; ++i) {
        const Vec3 a = any(), b = any(), c = any(), origin = any();
        const int all = i % 2 == 0 ? exponent(far) : (i % 4 == 1 ? far : -far);
        const Exactly exact{
            a, b, c, all + exponent(apart), all + exponent(apart), all + exponent(apart), origin};
        if (exact.condition > 0 && exact.condition < 100) check_inverse(exact, any());
    }
    const Real smallest = std::numeric_limits<Real>::denorm_min();
    const Mat4 inverse = rt::inverse(rt::from_columns({1, 0, 0}, {0, smallest, 0}, {0, 0, 1}));
    INFO("the number " << text(smallest)
                       << " in the matrix has an inverse that is too large for Real");
    CHECK(inverse(1, 1) == rt::infinity);
}

TEST_CASE("01.7 an entry too large for Real does not spoil other entries", "[01.7][hard]") {
    const char* const hint =
        "infinity times 0 and infinity minus infinity are NaN: if the last column is not finite, "
        "add up its terms before you undo the scale";
    const auto check = [&](const Mat4& m, const Mat4& expected) {
        const Mat4 computed = rt::inverse(m);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column) {
                INFO("the matrix:\n"
                     << m << "number (" << row << ", " << column << ") of its inverse");
                HINT(expected(row, column), computed(row, column), hint);
                REQUIRE(computed(row, column) == expected(row, column));
            }
    };
    // Powers of two, so that nothing is rounded. 1 / tiny is too large, 1 / small is not.
    const Real tiny = real(for_this_precision(0x1p-140, 0x1p-1060)),
               small = real(for_this_precision(0x1p-100, 0x1p-700)),
               large = real(for_this_precision(0x1p60, 0x1p400));
    const Real far = large * (large * tiny), infinite = rt::infinity;
    check(rt::scaling({tiny, 1, 1}),
          {{{{infinite, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}});
    check(rt::from_columns({1, 0, 0}, {0, 0, 1}, {0, -tiny, 0}, {2, 0, -3}),
          {{{{1, 0, 0, -2}, {0, 0, 1, 3}, {0, -infinite, 0, 0}, {0, 0, 0, 1}}}});
    // A translation that is small enough is undone by a number that is not infinite.
    check(rt::from_columns({0, 0, tiny}, {0, 1, 0}, {1, 0, 0}, {5, large, far}),
          {{{{0, 0, infinite, -large * large}, {0, 1, 0, -large}, {1, 0, 0, -5}, {0, 0, 0, 1}}}});
    // A tiny number of a translation is not lost beside a large one.
    check(rt::translation({small, large, 1}), rt::translation({-small, -large, -1}));
    // A turn by 45 degrees, made small. Each product overflows, and their sum is 0 in one row.
    const Real back = real(0.5) / small;
    check(
        rt::from_columns({small, small, 0}, {-small, small, 0}, {0, 0, small}, {large, -large, 1}),
        {{{{back, back, 0, 0},
           {-back, back, 0, infinite},
           {0, 0, 1 / small, -1 / small},
           {0, 0, 0, 1}}}});
}
