#include <rt/cross.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;

namespace {

void check_cross(Vec3 a, Vec3 b) {
    const ExactVec3 expected = cross(exact_vector(a), exact_vector(b));
    const Vec3 computed = rt::cross(a, b);
    INFO("cross(" << text(a) << ", " << text(b) << ")");
    HINT(expected, computed,
         "a component p q - r s loses its digits if both products are nearly the same; "
         "difference_of_products(p, q, r, s) keeps the digits");
    REQUIRE(error_in_ulp(computed, expected) <= 1.5);
}

}  // namespace

TEST_CASE("01.3 x cross y is z and y cross z is x and z cross x is y", "[01.3]") {
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    INFO(
        "Hint: if only signs are wrong, you have swapped the two products: the order is y z - z y, "
        "z x - x z, x y - y x");
    CHECK(rt::cross(x, y) == z);
    CHECK(rt::cross(y, z) == x);
    CHECK(rt::cross(z, x) == y);
}

TEST_CASE("01.3 the cross product changes its sign when its factors are swapped", "[01.3]") {
    const Vec3 a{1, 2, 3}, b{4, 5, 7};
    INFO("cross((1, 2, 3), (4, 5, 7)): " EXPECTED "(-1, 5, -3), " ACTUAL << text(rt::cross(a, b)));
    CHECK(rt::cross(a, b) == Vec3{-1, 5, -3});
    CHECK(rt::cross(b, a) == Vec3{1, -5, 3});
}

TEST_CASE("01.3 the cross product of a vector with itself is exactly zero", "[01.3][hard]") {
    const Vec3 a{real(0.1), real(-0.7), real(0.3)};
    INFO(EXPECTED "(0, 0, 0), " ACTUAL
         << text(rt::cross(a, a))
         << ".\nHint: the two products of a component must be rounded in the same way");
    CHECK(rt::cross(a, a) == Vec3{0, 0, 0});
}

TEST_CASE("01.3 the cross product is perpendicular to both factors and has the right length",
          "[01.3]") {
    // Small whole numbers, with which nothing is rounded.
    rt::Rng rng{2, 1};
    const auto whole = [&] { return std::floor(rng.uniform(-9, 10)); };
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a{whole(), whole(), whole()}, b{whole(), whole(), whole()};
        const ExactVec3 expected = cross(exact_vector(a), exact_vector(b));
        const Vec3 computed = rt::cross(a, b);
        INFO("cross(" << text(a) << ", " << text(b) << ")");
        HINT(expected, computed,
             "each component uses only the two other letters: x is ay bz - az by");
        REQUIRE(error_in_ulp(computed, expected) <= 1.5);
    }
}

TEST_CASE("01.3 the cross product is within 1.5 ulp even where its products cancel",
          "[01.3][hard]") {
    // Products near the largest and the smallest numbers, and factors that are parallel except for
    // their last digits.
    const Real apart = for_this_precision<Real>(3, 50), far = for_this_precision<Real>(8, 70);
    rt::Rng rng{2, 2};
    for (int i = 0; i < 6000; ++i) {
        const Vec3 a = any_vector(rng, -apart, apart), b = any_vector(rng, -apart, apart);
        check_cross(a * any_number(rng, -far, far), b * any_number(rng, -far, far));
        const Vec3 tilted = a + any_vector(rng, -16, -1) * a;
        check_cross(a, tilted * any_number(rng, -far, far));
    }
}
