#include <rt/dot.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;

namespace {

void check_dot(Vec3 a, Vec3 b) {
    const Exact expected = dot(exact_vector(a), exact_vector(b));
    const Real computed = rt::dot(a, b);
    const double allowed = static_cast<double>(rt::rounding_bound(3)) *
                           size_of_terms(exact_vector(a), exact_vector(b));
    INFO("dot(" << text(a) << ", " << text(b) << ")");
    HINT(expected, computed,
         "compute with Real throughout, and add up the 3 products unchanged, whatever their sizes");
    const double error_over_allowed = times_allowed(computed, expected, allowed);
    REQUIRE(error_over_allowed <= 1);
}

}  // namespace

TEST_CASE("01.2 the dot product sums the products of all three components", "[01.2]") {
    const Vec3 a{1, 2, 3}, b{10, 100, 1000};
    const Real computed = rt::dot(a, b);
    INFO("dot((1, 2, 3), (10, 100, 1000)): " EXPECTED "10 + 200 + 3000 = 3210, " ACTUAL
         << text(computed));
    if (computed == 210) INFO("Hint: the product of the z components is missing from your sum");
    CHECK(computed == 3210);
}

TEST_CASE("01.2 the dot product is correct for any vectors", "[01.2]") {
    rt::Rng rng{1, 1};
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = any_vector(rng, -2, 2), b = any_vector(rng, -2, 2);
        check_dot(a, b);
        check_dot(a, a);
        check_dot(a, -b);
    }
}

TEST_CASE("01.2 the dot product is as accurate as three rounded products allow", "[01.2][hard]") {
    // Products near the largest and the smallest numbers, too.
    const Real apart = for_this_precision<Real>(7, 60), far = for_this_precision<Real>(8, 70);
    rt::Rng rng{1, 2};
    for (int i = 0; i < 4000; ++i) {
        const Vec3 a = any_vector(rng, -apart, apart), b = any_vector(rng, -apart, apart);
        check_dot(a * any_number(rng, -far, far), b * any_number(rng, -far, far));
        // Nearly perpendicular: the terms cancel except for their last digits.
        const Vec3 c = any_vector(rng, -3, 3), d = any_vector(rng, -3, 3);
        const Real tilt = 1 + any_number(rng, -16, -1);
        if (c.z != 0) check_dot(c, {d.x, d.y, -tilt * (c.x * d.x + c.y * d.y) / c.z});
    }
}
