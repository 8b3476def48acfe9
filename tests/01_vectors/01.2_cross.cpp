#include <rt/cross.hpp>

#include "checkpoint.hpp"
#include "exact_products.hpp"

using namespace checkpoint;

TEST_CASE("01.2 x cross y is z and so on around", "[01.2]") {
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    INFO(
        "Hint: if only signs are wrong, two products are swapped: the order is y z - z y, "
        "z x - x z, x y - y x");
    CHECK(rt::cross(x, y) == z);
    CHECK(rt::cross(y, z) == x);
    CHECK(rt::cross(z, x) == y);
}

TEST_CASE("01.2 the cross product changes its sign when its factors are swapped", "[01.2]") {
    const Vec3 a{1, 2, 3}, b{4, 5, 7};
    INFO("cross((1, 2, 3), (4, 5, 7)) must be (-1, 5, -3), yours is " << text(rt::cross(a, b)));
    CHECK(rt::cross(a, b) == Vec3{-1, 5, -3});
    CHECK(rt::cross(b, a) == Vec3{1, -5, 3});
}

TEST_CASE("01.2 the cross product of a vector with itself is exactly zero", "[01.2][hard]") {
    const Vec3 a{real(0.1), real(-0.7), real(0.3)};
    INFO("yours is " << text(rt::cross(a, a))
                     << ".\nHint: the two products of a component must round alike");
    CHECK(rt::cross(a, a) == Vec3{0, 0, 0});
}

TEST_CASE("01.2 the cross product is within 1.5 ulp even where its products cancel",
          "[01.2][hard]") {
    for (const auto& row : exact::products()) {
        const Vec3 a = vec3(row.a), b = vec3(row.b);
        const Vec3 computed = rt::cross(a, b);
        INFO("cross(" << text(a) << ", " << text(b) << ")"
                      << (row.nearly_parallel ? ", which are nearly parallel" : ""));
        HINT(row.cross, computed,
             "a component p q - r s loses its digits where both products are nearly the same; "
             "difference_of_products(p, q, r, s) keeps them");
        REQUIRE(error_in_ulp(computed, row.cross) <= 1.5);
    }
}
