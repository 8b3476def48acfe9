#include <optional>
#include <rt/quadratic.hpp>
#include <string>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;
using rt::Roots;

namespace {

std::string text(const std::optional<Roots>& roots) {
    if (!roots) return "no solution";
    return '(' + checkpoint::text(roots->low) + ", " + checkpoint::text(roots->high) + ')';
}

std::string equation(Real a, Real b, Real c) {
    using checkpoint::text;
    return "a = " + text(a) + ", b = " + text(b) + ", c = " + text(c);
}

// For small whole numbers nothing is rounded: the solutions are exactly these.
void check_exactly(Real a, Real b, Real c, Real low, Real high, const std::string& hint) {
    const auto roots = rt::solve_quadratic(a, b, c);
    const bool is_swapped = roots && low < high && roots->low == high && roots->high == low;
    INFO("solve_quadratic for " << equation(a, b, c) << ": " EXPECTED "(" << low << ", " << high
                                << "), " ACTUAL << text(roots) << ".\nHint: "
                                << (is_swapped ? "low is the smaller solution, whatever the signs"
                                               : hint));
    REQUIRE(text(roots) != "no solution");
    CHECK(error_in_ulp(roots->low, Exact(low)) <= 4);
    CHECK(error_in_ulp(roots->high, Exact(high)) <= 4);
}

// The same for any numbers, by both functions. The discriminant that roots_from_discriminant gets
// is rounded, but keeps its digits. The equation is solved with a 2^i, b 2^j and c 2^(2 j - i): its
// solutions are those of a, b and c times 2^(j - i).
//
// With u = epsilon / 2, the discriminant is off by at most 2 u of its value, and its root by half
// of that. Rounding the root, the sum and the quotient adds u each: 4 u in all, which is at most 4
// units in the last place.
void check_solutions(Real a, Real b, Real c, const char* hint, int i = 0, int j = 0) {
    const Exact ea(a), eb(b), ec(c);
    const Exact discriminant = eb * eb - Exact(4) * ea * ec;
    const Exact root = study::sqrt(discriminant);
    const bool any = !(discriminant.high < 0) && !(a == 0 && b == 0);
    const Exact q = -(eb + (b < 0 ? -root : root)) * Exact(0.5);
    Exact low, high;
    if (any && q.high != 0) {
        low = ec / q;
        high = a == 0 ? low : q / ea;
        if (high < low) std::swap(low, high);
    }
    const Real a_i = std::scalbn(a, i), b_j = std::scalbn(b, j), c_k = std::scalbn(c, 2 * j - i);
    const auto expected = [&](const Exact& t) { return std::scalbn(real(t.high), j - i); };
    const auto check = [&](const char* name, const std::optional<Roots>& roots) {
        INFO(name << " for " << equation(a_i, b_j, c_k) << ": " EXPECTED
                  << (any ? text(Roots{expected(low), expected(high)}) : "no solution")
                  << ", " ACTUAL << text(roots) << ".\nHint: " << hint);
        const std::string count = roots ? "solutions" : "no solution";
        REQUIRE(count == (any ? "solutions" : "no solution"));
        if (!any) return;
        REQUIRE(error_in_ulp(std::scalbn(roots->low, i - j), low) <= 4);
        REQUIRE(error_in_ulp(std::scalbn(roots->high, i - j), high) <= 4);
        REQUIRE(roots->low <= roots->high);
    };
    // Before each, another call whose solutions must not show up in the next one.
    rt::solve_quadratic(1, -3, 2);
    check("solve_quadratic", rt::solve_quadratic(a_i, b_j, c_k));
    const Real given = std::scalbn(real(discriminant.high), 2 * j);
    rt::roots_from_discriminant(1, -3, 2, 1);
    check("roots_from_discriminant", rt::roots_from_discriminant(a_i, b_j, c_k, given));
}

void check_none(const std::optional<Roots>& roots, const char* what) {
    INFO(what << ", which has no solution: " EXPECTED "no solution, " ACTUAL << text(roots)
              << ".\nHint: return {} before you divide anything");
    CHECK(text(roots) == "no solution");
}

}  // namespace

TEST_CASE("03.1 both solutions are found and the smaller one comes first", "[03.1]") {
    const auto check = [](Real a, Real b, Real c, Real low, Real high) {
        const Real discriminant = b * b - 4 * a * c;
        check_exactly(a, b, c, low, high,
                      "b^2 - 4 a c is " + checkpoint::text(discriminant) + ", so t = (" +
                          checkpoint::text(-b) + " -+ " +
                          checkpoint::text(std::sqrt(discriminant)) + ") / (" +
                          checkpoint::text(2 * a) + ')');
    };
    check(1, -3, 2, 1, 2);
    check(1, 3, 2, -2, -1);
    check(-1, 3, -2, 1, 2);
    check(-1, -3, -2, -2, -1);
    check(1, 1, -6, -3, 2);
    check_exactly(2, -6, 4, 1, 2,
                  "divide by the whole of 2 a: x / 2 * a divides by 2 and then multiplies by a");
}

TEST_CASE("03.1 a negative discriminant means no solution", "[03.1]") {
    check_none(rt::solve_quadratic(1, 0, 1), "solve_quadratic: t^2 + 1 = 0");
    check_none(rt::solve_quadratic(1, 2, 3), "solve_quadratic: t^2 + 2 t + 3 = 0");
    check_none(rt::roots_from_discriminant(1, 0, 1, -4),
               "roots_from_discriminant: a discriminant of -4");
    check_none(rt::roots_from_discriminant(1, -2, 1, -std::numeric_limits<Real>::min()),
               "roots_from_discriminant: a discriminant just below 0");
}

TEST_CASE("03.1 a discriminant of zero means one solution", "[03.1]") {
    const char* const hint = "a discriminant of 0 is not negative: low and high coincide";
    check_exactly(1, -6, 9, 3, 3, hint);
    check_exactly(4, 4, 1, Real(-0.5), Real(-0.5), hint);
    check_exactly(1, 0, 0, 0, 0, "t^2 = 0 has the solution 0: here q is 0, and c / q is NaN");
}

TEST_CASE("03.1 solutions are accurate to 4 units in the last place for ordinary coefficients",
          "[03.1][hard]") {
    rt::Rng rng{31, 1};
    for (int i = 0; i < 1000; ++i) {
        const Vec3 k = any_vector(rng, -2, 2);
        if (k.x != 0 && k.y != 0)
            check_solutions(k.x, k.y, k.z,
                            "the solutions are c / q and q / a, the smaller one first");
    }
}

TEST_CASE("03.1 roots_from_discriminant uses the given discriminant", "[03.1]") {
    // (t - m)^2 = s^2. The true c is m^2 - s^2, which is rounded: only the discriminant knows s.
    rt::Rng rng{31, 2};
    for (int i = 0; i < 500; ++i) {
        const Real s = std::pow(Real(10), rng.uniform(for_this_precision<Real>(-3, -7), -1));
        const Real m = Real(1) + std::floor(rng.uniform(0, 1000)) / 1024;
        const Real c = real((Exact(m) * Exact(m) - Exact(s) * Exact(s)).high);
        const auto roots = rt::roots_from_discriminant(1, -2 * m, c, 4 * s * s);
        INFO("roots_from_discriminant(1, " << text(-2 * m) << ", " << text(c) << ", "
                                           << text(4 * s * s) << "): " EXPECTED << text(m) << " -+ "
                                           << text(s) << ", " ACTUAL << text(roots)
                                           << ".\nHint: use the given discriminant; do not compute "
                                              "it again");
        REQUIRE(text(roots) != "no solution");
        REQUIRE(error_in_ulp(roots->low, Exact(m) - Exact(s)) <= 6);
        REQUIRE(error_in_ulp(roots->high, Exact(m) + Exact(s)) <= 6);
    }
}

TEST_CASE("03.1 an equation with b = 0 is solved", "[03.1]") {
    const char* const hint = "the sign of 0 must count as plus or minus, not as 0: std::copysign";
    check_exactly(1, 0, -4, -2, 2, hint);
    check_exactly(1, Real(-0.0), -4, -2, 2, hint);
    check_exactly(-4, 0, 1, Real(-0.5), Real(0.5), hint);
}

TEST_CASE("03.1 an equation with c = 0 is solved", "[03.1]") {
    const char* const hint = "t (a t + b) = 0: one solution is 0, the other is -b / a";
    check_exactly(1, -5, 0, 0, 5, hint);
    check_exactly(1, -1, 0, 0, 1, hint);
    check_exactly(2, 5, 0, Real(-2.5), 0, hint);
}

TEST_CASE("03.1 an equation with a = 0 is solved", "[03.1][hard]") {
    const char* const hint =
        "b t + c = 0 has the one solution -c / b, which is c / q; q / a divides by 0";
    check_exactly(0, 2, -6, 3, 3, hint);
    check_exactly(0, -2, -6, -3, -3, hint);
    check_exactly(0, 4, 0, 0, 0, hint);
    check_none(rt::solve_quadratic(0, 0, 1), "solve_quadratic: 0 t^2 + 0 t + 1 = 0");
    check_none(rt::solve_quadratic(0, 0, 0), "solve_quadratic with a = b = 0, as documented");
}

TEST_CASE("03.1 tiny numbers are not treated as zero", "[03.1][hard]") {
    const char* const hint =
        "compare the discriminant, q and a with 0 exactly: no number is too small to count";
    const int far = for_this_precision(14, 140);
    rt::Rng rng{31, 3};
    const auto power = [&] {
        return static_cast<int>(rng() % static_cast<unsigned>(2 * far)) - far;
    };
    for (int i = 0; i < 1500; ++i) {
        // The solutions times 2^unit, all coefficients times 2^all; now and then one is 0. b stays
        // between numbers whose squares neither overflow nor underflow.
        const Vec3 k = any_vector(rng, -2, 2);
        const int all = 5 * power(), unit = power() - all;
        check_solutions(std::scalbn(k.x, all), std::scalbn(k.y, all + unit),
                        std::scalbn(k.z, all + 2 * unit), hint);
        // Two solutions that differ little, or not at all.
        const Real p = rng.uniform(1, 2), q = i % 2 == 0 ? rng.uniform(1, 2) : p;
        check_solutions(std::scalbn(p * p, all), std::scalbn(-2 * p * q, all + unit),
                        std::scalbn(q * q, all + 2 * unit), hint);
    }
}

TEST_CASE("03.1 a discriminant of NaN means no solution", "[03.1][hard]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    check_none(rt::roots_from_discriminant(1, -3, 2, nan),
               "roots_from_discriminant: a discriminant of NaN");
    check_none(rt::solve_quadratic(1, nan, 2), "solve_quadratic with b = NaN");
}

TEST_CASE("03.1 solutions are accurate to 4 units in the last place for any coefficients",
          "[03.1][hard]") {
    rt::Rng rng{31, 5};
    const auto any = [&] { return any_number(rng, -2, 2); };
    for (int i = 0; i < 300; ++i)
        check_solutions(any(), any(), any(),
                        "compute q, in which b and the root add up, and from it both solutions: q "
                        "/ a and c / q. Then nothing cancels");
}

TEST_CASE("03.1 a small solution keeps its digits beside a large one", "[03.1][hard]") {
    // b^2 is much larger than 4 a c.
    constexpr Real most = for_this_precision<Real>(8, 60);
    rt::Rng rng{31, 6};
    for (int i = 0; i < 300; ++i)
        check_solutions(any_number(rng, -1, 1), any_number(rng, most / 4, most / 2),
                        any_number(rng, -most / 4, 1),
                        "-b and the root nearly cancel in one of the two solutions. Compute q, in "
                        "which they add up: the other solution is q / a, and this one is c / q, "
                        "because their product is c / a");
}

TEST_CASE("03.1 nearly equal solutions are told apart", "[03.1][hard]") {
    const char* const hint =
        "b b and 4 a c agree in most digits: rt::difference_of_products(b, b, 4 * a, c) keeps "
        "them, as 4 * a is exact and a * c is not. (b / 2 is exact, too.)";
    constexpr int digits = std::numeric_limits<Real>::digits;
    rt::Rng rng{31, 7};
    const auto whole = [&](int bits) {
        return std::floor(rng.uniform() * std::scalbn(Real(1), bits));
    };
    for (int i = 0; i < 200; ++i) {
        // (p t - q)^2 with the coefficients rounded: two solutions, one or none.
        const Real p = rng.uniform(1, 2), q = rng.uniform(1, 2);
        check_solutions(p * p, -2 * p * q, q * q, hint);
        // The discriminant is 4: b^2 and 4 a c share all digits but the last.
        const Real n = std::scalbn(Real(1), digits - 2) + 2 * whole(digits - 4);
        check_solutions(n, 2 * (n + 1), n + 2, hint);
        // p and q short enough for exact coefficients: exactly one solution.
        const Real r = 2 * whole(digits / 2 - 2) + 1, s = 2 * whole(digits / 2 - 2) + 1;
        check_solutions(r * r, -2 * r * s, s * s, "the discriminant is exactly 0");
    }
}

TEST_CASE("03.1 a huge discriminant does not overflow", "[03.1][hard]") {
    constexpr Real far = for_this_precision<Real>(17, 150);
    rt::Rng rng{31, 8};
    const auto huge = [&] { return any_number(rng, far - 2, far); };
    for (int i = 0; i < 200; ++i)
        check_solutions(huge(), huge(), huge(),
                        "get one solution as c / q; b b - 4 a c does not overflow here, so your "
                        "other products must not overflow either");
}

TEST_CASE("03.1 nothing overflows if a or c is close to the largest number", "[03.1][hard]") {
    const char* const hint =
        "4 a c does not overflow here, but 4 * a or 4 * c does. Use b / 2, which is exact: "
        "difference_of_products then gives a quarter of the discriminant without the factor 4";
    rt::Rng rng{31, 4};
    const int most = std::numeric_limits<Real>::max_exponent - 2, j = for_this_precision(14, 140);
    for (int n = 0; n < 1000; ++n) {
        // a or c is in the last two powers of two; 4 a c is as large as b b, which is
        // of ordinary size.
        const int i = n % 2 == 0 ? most : 2 * j - most;
        const auto size = [&] { return rng() % 2 == 0 ? rng.uniform(1, 3) : -rng.uniform(1, 3); };
        check_solutions(size(), size(), size(), hint, i, j);
        const Real p = rng.uniform(1, 2), q = n % 4 < 2 ? rng.uniform(1, 2) : p;
        check_solutions(p * p, -2 * p * q, q * q, hint, i, j);
    }
}
