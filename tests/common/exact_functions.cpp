#include "exact_functions.hpp"

#include "checkpoint.hpp"
#include "exact_values.hpp"

using checkpoint::Exact;

namespace {

double relative_error(Exact computed, Exact exact) {
    return std::abs((computed - exact).high) / std::abs(exact.high);
}

constexpr double bound = 0x1p-94;

}  // namespace

TEST_CASE("exact sines and cosines keep 94 bits, also where they are almost 0",
          "[exact_functions]") {
    for (const auto& row : exact::turns) {
        const auto [sine, cosine] = checkpoint::exact_sine_cosine_of_turn(row.turn);
        INFO("turn " << row.turn);
        CHECK(relative_error(sine, row.sine) <= bound);
        CHECK(relative_error(cosine, row.cosine) <= bound);
    }
}

TEST_CASE("exact tangents keep 94 bits, also near half a turn", "[exact_functions]") {
    for (const auto& row : exact::halves) {
        INFO("angle " << row.angle);
        CHECK(relative_error(checkpoint::exact_tangent_of_half(row.angle), row.tangent) <= bound);
    }
}

TEST_CASE("exact roots keep 94 bits", "[exact_functions]") {
    CHECK(checkpoint::exact_root(0, 5).high == 0);
    for (const auto& row : exact::roots) {
        INFO("root " << row.n << " of " << row.x);
        CHECK(relative_error(checkpoint::exact_root(row.x, row.n), row.root) <= bound);
    }
}
