#include <companion/compare/student_t.hpp>
#include <rt/rng.hpp>
#include <study/ulp.hpp>

#include "catch.hpp"

using companion::Sample;

namespace {

constexpr double pi = 3.14159265358979323846;

double relative_error(double computed, double exact) {
    return std::abs(computed / exact - 1);
}

}  // namespace

TEST_CASE("the t distribution has the tabulated quantiles", "[student_t]") {
    // Two-sided chance, degrees of freedom, quantile: as tables of statistics have them.
    const double table[][3] = {{0.1, 1, 6.313752},    {0.05, 1, 12.706205},  {0.01, 1, 63.656741},
                               {0.05, 2, 4.302653},   {0.01, 5, 4.032143},   {0.001, 5, 6.868827},
                               {0.05, 7, 2.364624},   {0.001, 7, 5.407883},  {0.05, 10, 2.228139},
                               {0.01, 14, 2.976843},  {0.001, 14, 4.140454}, {0.05, 30, 2.042272},
                               {0.001, 30, 3.645959}, {0.05, 120, 1.979930}, {0.5, 3, 0.764892}};
    for (const auto& [p, degrees, t] : table) {
        INFO(degrees << " degrees, t = " << t);
        // The tables have seven digits; the tail is steeper than the quantile.
        CHECK(relative_error(companion::two_sided_p(t, degrees), p) < 1e-5);
    }
}

TEST_CASE("the tail is right where it is tiny", "[student_t]") {
    for (const double t : {0.5, 3.0, 1e2, 1e5, 1e8}) {
        INFO("t = " << t);
        // In closed form. For 1 degree: 2 / pi times the angle whose tangent is 1 / t.
        CHECK(relative_error(companion::two_sided_p(t, 1), 2 / pi * std::atan(1 / t)) < 1e-11);
        // For 2: 1 - t / sqrt(t^2 + 2), without the cancellation.
        const double root = std::sqrt(t * t + 2);
        CHECK(relative_error(companion::two_sided_p(t, 2), 2 / (root * (root + t))) < 1e-11);
        // For 4: with s = t / sqrt(t^2 + 4), 1 - s (3 - s^2) / 2 = (1 - s)^2 (2 + s) / 2.
        const double r4 = std::sqrt(t * t + 4), s = t / r4, one_minus_s = 4 / (r4 * (r4 + t));
        CHECK(relative_error(companion::two_sided_p(t, 4),
                             one_minus_s * one_minus_s * (2 + s) / 2) < 1e-11);
    }
    CHECK(companion::two_sided_p(0, 5) == 1);
    CHECK(companion::two_sided_p(rt::infinity, 5) == 0);
    // Many degrees are the normal distribution: erfc(t / sqrt 2).
    CHECK(relative_error(companion::two_sided_p(5, 1e9), std::erfc(5 / std::sqrt(2.0))) < 1e-6);
}

TEST_CASE("the incomplete beta function has its values in closed form", "[student_t]") {
    for (const double x : {0.0, 0.01, 0.3, 0.5, 0.99, 1.0}) {
        CHECK(std::abs(companion::incomplete_beta(1, 1, x) - x) < 1e-14);
        CHECK(std::abs(companion::incomplete_beta(2, 1, x) - x * x) < 1e-14);
        CHECK(std::abs(companion::incomplete_beta(3.5, 2.25, x) +
                       companion::incomplete_beta(2.25, 3.5, 1 - x) - 1) < 1e-13);
    }
}

TEST_CASE("Welch's test agrees with an example computed by hand", "[student_t]") {
    // Means 3 and 6, variances 2.5 and 10: t = -3 / sqrt(0.5 + 2) and
    // 2.5^2 / (0.25 / 4 + 4 / 4) = 100 / 17 degrees of freedom.
    const Sample a = companion::describe({1, 2, 3, 4, 5}),
                 b = companion::describe({2, 4, 6, 8, 10});
    CHECK(a.mean == 3);
    CHECK(a.variance == 2.5);
    CHECK(b.variance == 10);
    const double expected = companion::two_sided_p(3 / std::sqrt(2.5), 100.0 / 17);
    CHECK(relative_error(companion::welch_p(a, b), expected) < 1e-13);
    CHECK(std::abs(expected - 0.1075) < 0.0005);  // as R's t.test has it
}

TEST_CASE("Welch's test of values that do not vary", "[student_t]") {
    const Sample zeros{0, 0, 8}, ones{1, 0, 8};
    CHECK(companion::welch_p(zeros, zeros) == 1);
    CHECK(companion::welch_p(zeros, ones) == 0);
    // Where rounding alone makes the difference, it is none.
    CHECK(companion::welch_p(zeros, ones, 1) > 0.3);
}

TEST_CASE("Welch's test errs as often as it says", "[student_t]") {
    rt::Rng rng{1, 1};
    const auto normal = [&] {
        double sum = 0;
        for (int i = 0; i < 12; ++i) sum += static_cast<double>(rng.uniform()) - 0.5;
        return sum;
    };
    constexpr int runs = 20'000;
    int below_hundredth = 0;
    for (int run = 0; run < runs; ++run) {
        std::vector<double> a(8), b(8);
        for (double& x : a) x = normal();
        for (double& x : b) x = 3 * normal();
        below_hundredth +=
            companion::welch_p(companion::describe(a), companion::describe(b)) < 0.01;
    }
    // 200 are expected, give or take 14.
    CHECK(below_hundredth > 140);
    CHECK(below_hundredth < 260);
}
