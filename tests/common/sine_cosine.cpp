#include <bit>
#include <cstdint>
#include <rt/sine_cosine.hpp>

#include "checkpoint.hpp"
#include "exact_functions.hpp"
#include "random_inputs.hpp"

using checkpoint::Exact;
using checkpoint::Real;
using rt::sine_cosine_of_turn;

namespace {

double error_in_epsilons(Real computed, const Exact& exact) {
    return std::abs((exact - computed).high) / static_cast<double>(rt::epsilon);
}

// Eighths and what lies beside them, tiny parts, and any.
template <class Check>
void for_turns(Check check) {
    const Real step = rt::epsilon / 2;
    rt::Rng rng{4, 4};
    for (int i = 0; i < 600; ++i) {
        const Real eighth = static_cast<Real>(i / 4) / 8, beside = static_cast<Real>(i % 4 - 1);
        const Real turn = i < 32       ? std::max(Real(0), eighth + beside * step)
                          : i < 35     ? 1 - static_cast<Real>(i - 31) * step
                          : i % 8 == 0 ? std::abs(checkpoint::any_number(rng, -30, -1))
                                       : rng.uniform();
        INFO("turn " << checkpoint::text(turn));
        check(sine_cosine_of_turn(turn),
              checkpoint::exact_sine_cosine_of_turn(static_cast<double>(turn)));
    }
}

// One number from all bits of many results (FNV-1a).
constexpr std::uint64_t hash_of_bits() {
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](Real number) {
        const auto bits =
            std::bit_cast<std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>>(
                number);
        hash = (hash ^ bits) * 1099511628211u;
    };
    for (int i = 0; i < 1000; ++i) {
        const auto [sine, cosine] = sine_cosine_of_turn(static_cast<Real>(i) / 1009);
        add(sine);
        add(cosine);
    }
    return hash;
}

}  // namespace

TEST_CASE("sine and cosine of a turn are within epsilon", "[sine_cosine]") {
    for_turns([](auto computed, const auto& exact) {
        CHECK(error_in_epsilons(computed.sine, exact.sine) <= 1);
        CHECK(error_in_epsilons(computed.cosine, exact.cosine) <= 1);
    });
}

TEST_CASE("quarters of a turn are exact", "[sine_cosine]") {
    const Real sines[] = {0, 1, 0, -1}, cosines[] = {1, 0, -1, 0};
    for (int i = 0; i < 4; ++i) {
        const auto [sine, cosine] = sine_cosine_of_turn(static_cast<Real>(i) / 4);
        CHECK(sine == sines[i]);
        CHECK(cosine == cosines[i]);
    }
}

TEST_CASE("a sine or cosine that is almost 0 keeps its digits", "[sine_cosine]") {
    for_turns([](auto computed, const auto& exact) {
        CHECK(checkpoint::error_in_ulp(computed.sine, exact.sine) <= 2);
        CHECK(checkpoint::error_in_ulp(computed.cosine, exact.cosine) <= 2);
    });
    // The sine is 2 pi times the turn, down to where numbers begin to have fewer digits.
    const Exact whole{0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52};
    for (Real turn = Real(0x1p-30); turn >= std::numeric_limits<Real>::min(); turn /= 3) {
        const auto [sine, cosine] = sine_cosine_of_turn(turn);
        INFO("turn " << turn);
        CHECK(checkpoint::error_in_ulp(sine / turn, whole) <= 2);
        CHECK(cosine == 1);
    }
}

TEST_CASE("the squares of sine and cosine add up to 1", "[sine_cosine]") {
    rt::Rng rng{4, 3};
    for (int i = 0; i < 100'000; ++i) {
        const Real turn = rng.uniform();
        const auto [sine, cosine] = sine_cosine_of_turn(turn);
        const Exact s = sine, c = cosine;
        const double squares = (s * s + c * c - 1).high;
        if (std::abs(squares) <= 2 * static_cast<double>(rt::epsilon)) continue;
        INFO("turn " << checkpoint::text(turn));
        REQUIRE(std::abs(squares) <= 2 * static_cast<double>(rt::epsilon));
    }
}

TEST_CASE("a quarter of a turn further on the cosine is the sine", "[sine_cosine]") {
    for (int i = 0; i < 3 << 16; ++i) {
        // Adding a quarter rounds nothing. None of these turns is an eighth, to which two quarters
        // would be equally near.
        const Real turn = static_cast<Real>(2 * i + 1) / (8 << 16);
        const auto here = sine_cosine_of_turn(turn),
                   further = sine_cosine_of_turn(turn + Real(0.25));
        INFO("turn " << turn);
        REQUIRE(further.cosine == -here.sine);
        REQUIRE(further.sine == here.cosine);
    }
}

// With every compiler and library, at compile time and at run time.
TEST_CASE("sine and cosine of a turn have the same bits everywhere", "[sine_cosine]") {
    constexpr std::uint64_t compiled = hash_of_bits();
    CHECK(compiled ==
          checkpoint::for_this_precision<std::uint64_t>(0x7554176b2a4e4c7f, 0x4990c55c1b860eb6));
    CHECK(hash_of_bits() == compiled);
}
