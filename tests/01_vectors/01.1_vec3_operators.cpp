#include <limits>
#include <rt/vec3.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;

namespace {

constexpr Real no_number = std::numeric_limits<Real>::quiet_NaN();

// Equal to the last bit, as far as == sees; NaN where NaN is expected.
bool same(Real a, Real b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}
bool same(Vec3 a, Vec3 b) {
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

void check(const std::string& what, Vec3 expected, Vec3 actual, const char* hint) {
    if (!same(expected, actual)) {
        INFO(what << ": " EXPECTED << text(expected) << ", " ACTUAL << text(actual)
                  << ".\nHint: " << hint);
        const std::string wanted = text(expected), came = text(actual);
        REQUIRE(came == wanted);
    }
    REQUIRE(same(expected, actual));
}

void check_plus(Vec3 a, Vec3 b) {
    check(text(a) + " + " + text(b), {a.x + b.x, a.y + b.y, a.z + b.z}, a + b,
          "add x to x, y to y, z to z: {a.x + b.x, ...}");
}
void check_minus(Vec3 a, Vec3 b) {
    check(text(a) + " - " + text(b), {a.x - b.x, a.y - b.y, a.z - b.z}, a - b,
          "subtract each component of b from the same component of a");
}
void check_times(Vec3 v, Real s) {
    check(text(v) + " * " + text(s), {v.x * s, v.y * s, v.z * s}, v * s,
          "multiply each of the three components by s");
}
void check_over(Vec3 v, Real s) {
    check(text(v) + " / " + text(s), {v.x / s, v.y / s, v.z / s}, v / s,
          "divide each component by s; multiplying by 1 / s rounds twice");
}

}  // namespace

TEST_CASE("01.1 a sum adds each component of one vector to that of the other", "[01.1]") {
    check_plus({1, 2, 3}, {4, 6, 9});
    check_plus({1, 0, 0}, {0, 1, 0});
    check_plus({0, 0, 1}, {0, 0, 1});
    check_plus({-1, 5, -7}, {1, -5, 7});
    check_plus({1, 2, 3}, {});
}

TEST_CASE("01.1 a difference subtracts the second vector's components from the first's", "[01.1]") {
    check_minus({4, 6, 9}, {1, 2, 3});
    check_minus({1, 2, 3}, {4, 6, 9});
    check_minus({0, 0, 0}, {1, 2, 3});
    check_minus({1, 2, 3}, {1, 2, 3});
}

TEST_CASE("01.1 a product with a number multiplies every component", "[01.1]") {
    check_times({1, 2, 3}, 2);
    check_times({1, 2, 3}, -1);
    check_times({1, 2, 3}, Real(0.5));
    check_times({1, 2, 3}, 0);
    check_times({5, -7, 11}, 3);
}

TEST_CASE("01.1 a quotient divides every component", "[01.1]") {
    check_over({2, 4, 6}, 2);
    check_over({5, -7, 11}, -4);
    check_over({1, 2, 3}, Real(0.5));
}

TEST_CASE("01.1 the operators are correct for any vectors of ordinary size", "[01.1]") {
    rt::Rng rng{11, 1};
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = any_vector(rng, -3, 3), b = any_vector(rng, -3, 3);
        const Real s = any_number(rng, -3, 3);
        check_plus(a, b);
        check_minus(a, b);
        check_times(a, s);
    }
}

TEST_CASE("01.1 the given operators work with your four operators", "[01.1]") {
    const Vec3 a{1, 2, 3}, b{4, 6, 9};
    check("2 * (1, 2, 3)", {2, 4, 6}, 2 * a,
          "this operator is given in <rt/vec3.hpp> and calls your v * s");
    Vec3 c = a;
    c += b;
    check("(1, 2, 3) += (4, 6, 9)", {5, 8, 12}, c, "this operator calls your a + b");
    c -= a;
    check("(5, 8, 12) -= (1, 2, 3)", {4, 6, 9}, c, "this operator calls your a - b");
    c *= 3;
    check("(4, 6, 9) *= 3", {12, 18, 27}, c, "this operator calls your v * s");
    c /= 6;
    check("(12, 18, 27) /= 6", {2, 3, Real(4.5)}, c, "this operator calls your v / s");
}

TEST_CASE("01.1 the operands do not change", "[01.1]") {
    Vec3 a{1, 2, 3}, b{4, 6, 9};
    const Vec3 all[] = {a + b, a - b, a * 5, a / 5};
    check("a after all four", {1, 2, 3}, a, "return a new vector, and change neither a nor b");
    check("b after all four", {4, 6, 9}, b, "return a new vector, and change neither a nor b");
    static_cast<void>(all);
}

TEST_CASE("01.1 each component is rounded once", "[01.1][hard]") {
    rt::Rng rng{11, 2};
    const Real most = for_this_precision<Real>(18, 150);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 a = any_vector(rng, -most, most), b = any_vector(rng, -most, most);
        const Real s = any_number(rng, -most, most);
        check_plus(a, b);
        check_minus(a, b);
        check_times(a, s);
        check_over(a, s);
    }
}

TEST_CASE("01.1 a quotient by a tiny number overflows only if it must", "[01.1][hard]") {
    // 1 / s overflows where s is subnormal; v / s need not.
    const Real tiny = std::numeric_limits<Real>::denorm_min() * 4;
    check_over(Vec3{tiny, -2 * tiny, 3 * tiny}, tiny);
    check_over(Vec3{tiny, tiny, tiny}, 2 * tiny);
    const Real huge = std::numeric_limits<Real>::max();
    check_over(Vec3{huge, -huge, huge / 4}, huge);
}

TEST_CASE("01.1 infinite components and zeros give the right result", "[01.1][hard]") {
    const Real inf = rt::infinity;
    check_plus({inf, 1, -inf}, {1, inf, 1});
    check_plus({inf, -inf, 0}, {-inf, inf, 0});
    check_minus({inf, 1, 2}, {inf, -inf, 2});
    check_times({inf, -1, 0}, -2);
    check_times({1, 0, -1}, inf);
    check_times({inf, 1, -inf}, 0);
    check_over({1, -1, 0}, 0);
    check_over({1, inf, -3}, inf);
    check_plus({no_number, 1, 2}, {1, no_number, 2});
}
