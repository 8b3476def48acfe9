#include <study/double_double.hpp>

#include "checkpoint.hpp"
#include "exact_values.hpp"

using study::DoubleDouble;

namespace {

// 2^-98, the bound that double_double.hpp states.
constexpr double bound = 0x1p-98;

double relative_error(DoubleDouble computed, const DoubleDouble& exact) {
    return std::abs((computed - exact).high) / std::abs(exact.high);
}

}  // namespace

TEST_CASE("double-double arithmetic keeps 98 bits", "[double_double]") {
    for (const auto& row : exact::operations) {
        const DoubleDouble a = row.a, b = row.b;
        INFO(a.high << " + " << a.low << ", " << b.high << " + " << b.low);
        CHECK(relative_error(a + b, row.sum) <= bound);
        CHECK(relative_error(a - b, row.difference) <= bound);
        CHECK(relative_error(a * b, row.product) <= bound);
        CHECK(relative_error(a / b, row.quotient) <= bound);
        CHECK(relative_error(sqrt(a), row.root) <= bound);
    }
}

TEST_CASE("two-sum and two-product lose nothing", "[double_double]") {
    const auto [s, rest] = DoubleDouble::sum(1, 0x1p-60);
    CHECK(s == 1);
    CHECK(rest == 0x1p-60);
    const auto [p, error] = DoubleDouble::product(1 + 0x1p-30, 1 + 0x1p-30);
    CHECK(p == 1 + 0x1p-29);
    CHECK(error == 0x1p-60);
}

TEST_CASE("double-doubles compare by both parts", "[double_double]") {
    CHECK(DoubleDouble{1, 0} < DoubleDouble{1, 0x1p-60});
    CHECK(DoubleDouble{1, -0x1p-60} < DoubleDouble{1, 0});
    CHECK(DoubleDouble{1, 0x1p-60} < DoubleDouble{2, 0});
    CHECK_FALSE(DoubleDouble{1, 0} < DoubleDouble{1, 0});
    CHECK(sqrt(DoubleDouble{0}).high == 0);
    CHECK(sqrt(DoubleDouble{9}).high == 3);
    CHECK(sqrt(DoubleDouble{9}).low == 0);
}
