#include <rt/real.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using checkpoint::Exact;
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
    rt::Rng rng{1, 4};
    const auto any = [&] { return checkpoint::any_number(rng, -3, 3); };
    for (int i = 0; i < 1000; ++i) {
        const Real a = any(), b = any(), c = any();
        // Unrelated products, and products that agree in all but their last digits.
        const Real d =
            i % 2 == 0 ? rng.uniform(-9, 9) : a * b / c * (1 + rng.uniform(-6, 6) * rt::epsilon);
        const Real computed = rt::difference_of_products(a, b, c, d);
        const Exact exact = Exact(a) * Exact(b) - Exact(c) * Exact(d);
        INFO(a << " * " << b << " - " << c << " * " << d);
        HINT(exact, computed, "");
        CHECK(checkpoint::error_in_ulp(computed, exact) <= 1.5);
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
