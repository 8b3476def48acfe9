#include <rt/dot.hpp>

#include "checkpoint.hpp"
#include "exact_products.hpp"

using namespace checkpoint;

TEST_CASE("01.1 the dot product sums the products of all three components", "[01.1]") {
    const Vec3 a{1, 2, 3}, b{10, 100, 1000};
    const Real computed = rt::dot(a, b);
    INFO("dot((1, 2, 3), (10, 100, 1000)): expected 10 + 200 + 3000 = 3210, yours gives "
         << text(computed));
    if (computed == 210) INFO("Hint: is the product of the z components in your sum?");
    CHECK(computed == 3210);
}

TEST_CASE("01.1 the dot product has the accuracy that three products allow", "[01.1][hard]") {
    for (const auto& row : exact::products()) {
        const Vec3 a = vec3(row.a), b = vec3(row.b);
        const double size = std::abs(row.a[0] * row.b[0]) + std::abs(row.a[1] * row.b[1]) +
                            std::abs(row.a[2] * row.b[2]);
        const Real computed = rt::dot(a, b);
        const double error = std::abs((row.dot - Exact(computed)).high);
        INFO("dot(" << text(a) << ", " << text(b) << ")");
        HINT(row.dot, computed, "compute with Real throughout, and add up no more than 3 products");
        REQUIRE(error <= static_cast<double>(rt::rounding_bound(3)) * size);
    }
}
