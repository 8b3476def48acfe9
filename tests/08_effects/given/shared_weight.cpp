// The weights of two ways to find one light.

#include <rt/rng.hpp>
#include <rt/shared_weight.hpp>
#include <statistics.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;

TEST_CASE("two ways to find the same light count once in total") {
    const auto check = [](Real density, Real other, Real expected) {
        INFO("densities " << text(density) << " and " << text(other));
        CHECK(std::abs(rt::shared_weight(density, other) - expected) <= 4 * rt::epsilon);
    };
    check(2, 2, Real(0.5));
    check(3, 1, Real(0.9));
    check(1, 3, Real(0.1));
    check(1, 0, 1);
    check(0, 1, 0);
    for (int i = 1; i < 40; ++i) {
        const Real a = static_cast<Real>(i), b = static_cast<Real>(i * i % 17 + 1);
        CHECK(std::abs(rt::shared_weight(a, b) + rt::shared_weight(b, a) - 1) <= 4 * rt::epsilon);
    }
}

TEST_CASE("weights of huge and tiny densities are numbers") {
    const Real huge = std::numeric_limits<Real>::max(), tiny = std::numeric_limits<Real>::min();
    const Real power = for_this_precision(Real(37), Real(307));
    rt::Rng rng{83, 3};
    const auto check = [](Real density, Real other) {
        const Real ratio = density < other ? density / other : other / density;
        const Real lesser = ratio * ratio / (1 + ratio * ratio);
        const Real expected = density < other ? lesser : 1 - lesser;
        INFO("densities " << text(density) << " and " << text(other));
        REQUIRE(std::abs(rt::shared_weight(density, other) - expected) <= 8 * rt::epsilon);
    };
    for (const Real density : {huge, tiny}) check(density, density);
    check(huge, tiny);
    check(tiny, huge);
    check(huge, 0);
    check(0, tiny);
    for (int i = 0; i < 2000; ++i) {
        const Real density = any_size(rng, -power, power);
        check(density, any_size(rng, -power, power));
        check(density, std::min(huge, density * any_size(rng, -1, 1)));
    }
}
