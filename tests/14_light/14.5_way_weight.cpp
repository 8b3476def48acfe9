#include <rt/rng.hpp>
#include <rt/way_weight.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Way;
using rt::Ways;

namespace {

constexpr Ways all_ways[]{Ways::samples, Ways::bounces, Ways::balance, Ways::power};
constexpr Way both[]{Way::sample, Way::bounce};

const char* name(Ways ways) {
    switch (ways) {
        case Ways::samples:
            return "Ways::samples";
        case Ways::bounces:
            return "Ways::bounces";
        case Ways::balance:
            return "Ways::balance";
        default:
            return "Ways::power";
    }
}
const char* name(Way way) {
    return way == Way::sample ? "Way::sample" : "Way::bounce";
}

void check_weight(Ways ways, Way way, Real density, Real other, double expected, double allowed,
                  const char* hint) {
    const Real weight = rt::way_weight(ways, way, density, other);
    INFO("way_weight(" << name(ways) << ", " << name(way) << ", " << text(density) << ", "
                       << text(other) << ")");
    HINT(real(expected), weight, hint);
    const bool is_near = std::abs(static_cast<double>(weight) - expected) <= allowed;
    REQUIRE(is_near);
}

constexpr double few_epsilon = 8 * static_cast<double>(rt::epsilon);

// The integral of x^3 from 0 to 1 by two ways: numbers spread evenly, with the density 1, and
// square roots of such numbers, with the density 2 x. `skips` is where the second way chooses
// nothing.
Mean integral(Ways ways, rt::Rng& rng, int count) {
    Mean mean;
    for (int i = 0; i < count; ++i) {
        const auto value = [&](Way way, Real x) {
            const Real even = 1, rising = 2 * x;
            const Real density = way == Way::sample ? even : rising,
                       other = way == Way::sample ? rising : even;
            return x * x * x / density * rt::way_weight(ways, way, density, other);
        };
        const Real a = 1 - rng.uniform(), b = std::sqrt(1 - rng.uniform());
        mean.add(static_cast<double>(value(Way::sample, a) + value(Way::bounce, b)));
    }
    return mean;
}

}  // namespace

TEST_CASE("14.5 the weights agree with an example on paper", "[14.5]") {
    check_weight(Ways::balance, Way::sample, 3, 1, 0.75, few_epsilon, "p / (p + q) = 3 / 4");
    check_weight(Ways::balance, Way::bounce, 1, 3, 0.25, few_epsilon, "p / (p + q) = 1 / 4");
    check_weight(Ways::power, Way::sample, 3, 1, 0.9, few_epsilon, "p^2 / (p^2 + q^2) = 9 / 10");
    check_weight(Ways::power, Way::bounce, 1, 3, 0.1, few_epsilon, "p^2 / (p^2 + q^2) = 1 / 10");
}

TEST_CASE("14.5 each heuristic follows its formula", "[14.5]") {
    rt::Rng rng{145, 1};
    for (int i = 0; i < 1000; ++i) {
        const Real p = any_size(rng, -3, 3), q = any_size(rng, -3, 3);
        const double a = static_cast<double>(p), b = static_cast<double>(q);
        for (const Way way : both) {
            check_weight(Ways::balance, way, p, q, a / (a + b), few_epsilon,
                         "the balance heuristic is density / (density + other)");
            check_weight(Ways::power, way, p, q, a * a / (a * a + b * b), few_epsilon,
                         "the power heuristic has squares: density^2 / (density^2 + other^2)");
        }
    }
}

TEST_CASE("14.5 one way alone counts in full and the other not at all", "[14.5]") {
    rt::Rng rng{145, 2};
    for (int i = 0; i < 100; ++i) {
        const Real p = any_size(rng, -3, 3), q = any_size(rng, -3, 3);
        const char* const hint =
            "Ways::samples counts only what Way::sample has found, Ways::bounces only what "
            "Way::bounce has found, whatever the densities are";
        check_weight(Ways::samples, Way::sample, p, q, 1, 0, hint);
        check_weight(Ways::samples, Way::bounce, p, q, 0, 0, hint);
        check_weight(Ways::bounces, Way::sample, p, q, 0, 0, hint);
        check_weight(Ways::bounces, Way::bounce, p, q, 1, 0, hint);
    }
}

TEST_CASE("14.5 what the other way never finds counts in full", "[14.5]") {
    rt::Rng rng{145, 3};
    for (const Ways ways : all_ways)
        for (const Way way : both)
            for (int i = 0; i < 20; ++i)
                check_weight(ways, way, any_size(rng, -3, 3), 0, 1, 0,
                             "if the density of the other way is 0, only this way can find the "
                             "light, and nothing else would make up for it");
}

TEST_CASE("14.5 the weights of both ways add up to 1", "[14.5]") {
    rt::Rng rng{145, 4};
    for (const Ways ways : all_ways)
        for (int i = 0; i < 500; ++i) {
            const Real p = any_size(rng, -3, 3), q = any_size(rng, -3, 3);
            const Real sum =
                rt::way_weight(ways, Way::sample, p, q) + rt::way_weight(ways, Way::bounce, q, p);
            INFO(name(ways) << " for the densities " << text(p) << " of samples and " << text(q)
                            << " of bounces");
            HINT(Real(1), sum,
                 "the weights of both ways must add up to 1, or light counts too much or too "
                 "little; what is `density` for one way is `other` for the other");
            const bool is_near = std::abs(sum - 1) <= 4 * rt::epsilon;
            REQUIRE(is_near);
        }
}

TEST_CASE("14.5 all ways have the same mean", "[14.5]") {
    // Of 4,000 right answers with other seeds, one would fail in one of the four.
    rt::Rng rng{145, 5};
    for (const Ways ways : all_ways) {
        const Mean mean = integral(ways, rng, 20'000);
        INFO("the integral of x^3 from 0 to 1 by two ways, with " << name(ways));
        HINT(real(0.25), real(mean.mean()),
             "each sample is divided by the density of its own way and multiplied by its weight; "
             "where the weights add up to 1, the mean is right");
        CHECK(std::abs(mean.mean() - 0.25) < 4 * mean.standard_error());
    }
}

TEST_CASE("14.5 an infinite density leaves nothing to the other way", "[14.5][hard]") {
    for (const Ways ways : {Ways::balance, Ways::power}) {
        const char* const hint =
            "infinity / infinity is NaN: divide numerator and denominator by the density first, "
            "which "
            "leaves 1 / (1 + other / density)";
        check_weight(ways, Way::bounce, rt::infinity, 2, 1, 0, hint);
        check_weight(ways, Way::sample, 2, rt::infinity, 0, 0, hint);
    }
    check_weight(Ways::samples, Way::bounce, rt::infinity, 2, 0, 0, "samples alone count");
}

TEST_CASE("14.5 densities of any size have weights", "[14.5][hard]") {
    const Real largest = std::numeric_limits<Real>::max(), least = std::numeric_limits<Real>::min();
    const char* const hint =
        "the square, or the sum, of these densities is no number: divide numerator and denominator "
        "by the density first, which leaves 1 / (1 + (other / density)^2)";
    for (const Real size : {largest, largest / 3, least, 3 * least}) {
        check_weight(Ways::balance, Way::sample, size, size, 0.5, few_epsilon, hint);
        check_weight(Ways::power, Way::sample, size, size, 0.5, few_epsilon, hint);
        check_weight(Ways::power, Way::bounce, size / 2, size, 0.2, few_epsilon, hint);
    }
    check_weight(Ways::power, Way::sample, largest, least, 1, 0, hint);
    check_weight(Ways::power, Way::sample, least, largest, 0, 0, hint);
}

TEST_CASE("14.5 the weights of both ways add up to 1 for densities of all sizes", "[14.5][hard]") {
    rt::Rng rng{145, 6};
    const Real power = for_this_precision(37, 300);
    for (const Ways ways : all_ways)
        for (int i = 0; i < 500; ++i) {
            const Real p = any_size(rng, -power, power), q = any_size(rng, -power, power);
            const Real sum =
                rt::way_weight(ways, Way::sample, p, q) + rt::way_weight(ways, Way::bounce, q, p);
            INFO(name(ways) << " for the densities " << text(p) << " of samples and " << text(q)
                            << " of bounces");
            HINT(Real(1), sum, "the weights of both ways must add up to 1 within epsilon");
            const bool is_near = std::abs(sum - 1) <= rt::epsilon;
            REQUIRE(is_near);
        }
}
