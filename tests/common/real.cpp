#include <rt/real.hpp>

#include "checkpoint.hpp"
#include "exact_differences.hpp"

using checkpoint::Real;

TEST_CASE("rounding_bound bounds roundings in a row", "[real]") {
    constexpr Real u = rt::epsilon / 2;
    CHECK(rt::rounding_bound(0) == 0);
    CHECK(rt::rounding_bound(1) > u);
    CHECK(rt::rounding_bound(1) < u * (1 + 4 * u));
    CHECK(rt::rounding_bound(10) > 10 * u);
    CHECK(rt::rounding_bound(10) < 10 * u * (1 + 22 * u));
    for (int n = 0; n < 100; ++n) CHECK(rt::rounding_bound(n) < rt::rounding_bound(n + 1));
}

TEST_CASE("rounding_bound holds for a chain of products", "[real]") {
    // Multiplied up from 1 by numbers near 1, with the exact product beside it.
    for (int start = 1; start < 50; ++start) {
        Real computed = 1;
        study::DoubleDouble exact = 1;
        for (int n = 1; n <= 40; ++n) {
            const Real factor =
                1 + static_cast<Real>((start * n) % 17 - 8) / 64 + rt::epsilon * Real(start);
            computed *= factor;
            exact = exact * static_cast<double>(factor);
            const double error = std::abs((exact - static_cast<double>(computed)).high);
            REQUIRE(error <= static_cast<double>(rt::rounding_bound(n)) * exact.high);
        }
    }
}

TEST_CASE("difference_of_products is within 1.5 units, however much cancels", "[real]") {
    for (const auto& row : exact::differences()) {
        const Real a = checkpoint::real(row.v[0]), b = checkpoint::real(row.v[1]),
                   c = checkpoint::real(row.v[2]), d = checkpoint::real(row.v[3]);
        const Real computed = rt::difference_of_products(a, b, c, d);
        INFO(a << " * " << b << " - " << c << " * " << d);
        HINT(row.difference, computed, "");
        CHECK(checkpoint::error_in_ulp(computed, row.difference) <= 1.5);
    }
}

TEST_CASE("difference_of_products of equal products is exactly 0", "[real]") {
    const Real a = Real(0.1), b = Real(0.3);
    CHECK(rt::difference_of_products(a, b, b, a) == 0);
    CHECK(rt::difference_of_products(a, b, -a, -b) == 0);
}

TEST_CASE("a half turn is pi", "[real]") {
    CHECK(checkpoint::error_in_ulp(rt::radians(180),
                                   {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}) <= 1.5);
    CHECK(rt::radians(0) == 0);
    CHECK(rt::radians(-90) == -rt::radians(90));
}
