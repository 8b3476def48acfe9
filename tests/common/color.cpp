#include <rt/color.hpp>

#include "checkpoint.hpp"
#include "exact_functions.hpp"
#include "random_inputs.hpp"

using checkpoint::Exact;
using checkpoint::exact_power;
using checkpoint::exact_root;
using checkpoint::Real;
using rt::Color;

namespace {

Exact thousandths(int n) {
    return Exact(n) / Exact(1000);
}

// The sRGB transfer function and its inverse, as IEC 61966-2-1 has them.
Exact exact_encode(Exact x) {
    if (x < Exact(31308) / Exact(10'000'000)) return thousandths(12'920) * x;
    return thousandths(1055) * exact_root(exact_power(x, 5), 12) - thousandths(55);
}
Exact exact_decode(Exact x) {
    if (x < Exact(4045) / Exact(100'000)) return x / thousandths(12'920);
    return exact_root(exact_power((x + thousandths(55)) / thousandths(1055), 12), 5);
}

}  // namespace

// Rounded to six digits, as tables of sRGB print them.
TEST_CASE("the sRGB transfer function gives published values", "[color]") {
    const auto near = [](Real a, double b) {
        return std::abs(static_cast<double>(a) - b) < 5.1e-7;
    };
    CHECK(rt::srgb_encode(0) == 0);
    CHECK(checkpoint::error_in_ulp(rt::srgb_encode(1), {1}) <= 1);
    CHECK(near(rt::srgb_encode(Real(0.0031308)), 0.040450));
    CHECK(near(rt::srgb_encode(Real(0.18)), 0.461356));
    CHECK(near(rt::srgb_encode(Real(0.5)), 0.735357));
    CHECK(near(rt::srgb_decode(Real(0.5)), 0.214041));
    CHECK(rt::srgb_decode(1) == 1);
    CHECK(+rt::to_byte(Real(0.5)) == 188);
    CHECK(+rt::to_byte(Real(0.18)) == 118);
    CHECK(+rt::to_byte(0) == 0);
    CHECK(+rt::to_byte(1) == 255);
}

TEST_CASE("the sRGB transfer function and its inverse are as exact as std::pow", "[color]") {
    const Real ends[] = {0, Real(0.003), Real(0.0032), Real(0.0404), Real(0.0405), 1};
    rt::Rng rng{1, 5};
    for (int i = 0; i < 400; ++i) {
        const Real x = i < 6        ? ends[i]
                       : i % 2 == 0 ? rng.uniform()
                                    : std::abs(checkpoint::any_number(rng, -6, 0));
        INFO("x = " << checkpoint::text(x));
        // Rounding 1 / 2.4 and 1.055 moves the result by a few units, and the subtraction of 0.055
        // makes them up to 2.4 times as large.
        CHECK(checkpoint::error_in_ulp(rt::srgb_encode(x), exact_encode(x)) <= 12);
        CHECK(checkpoint::error_in_ulp(rt::srgb_decode(x), exact_decode(x)) <= 12);
    }
}

TEST_CASE("every byte survives decoding and encoding", "[color]") {
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        const Color c = rt::from_hex(byte << 16 | byte << 8 | byte);
        CHECK(rt::to_byte(c.r) == byte);
        CHECK(rt::to_byte(c.g) == byte);
        CHECK(rt::to_byte(c.b) == byte);
    }
}

TEST_CASE("brighter light never gets a smaller byte", "[color]") {
    int before = 0;
    for (int i = 0; i <= 10'000; ++i) {
        const int byte = rt::to_byte(static_cast<Real>(i) / 10'000);
        CHECK(byte >= before);
        CHECK(byte <= before + 3);  // the steepest part, near black, climbs 3295 / 10000 per step
        before = byte;
    }
}

TEST_CASE("light outside of 0 to 1 is clamped in files", "[color]") {
    CHECK(+rt::to_byte(-1) == 0);
    CHECK(+rt::to_byte(1000) == 255);
    CHECK(+rt::to_byte(rt::infinity) == 255);
    CHECK(rt::srgb_decode(2) == 1);
    CHECK(rt::srgb_decode(-2) == 0);
}

TEST_CASE("a color in hexadecimal has red first", "[color]") {
    CHECK(rt::from_hex(0xff0000) == Color{1, 0, 0});
    CHECK(rt::from_hex(0x00ff00) == Color{0, 1, 0});
    CHECK(rt::from_hex(0x0000ff) == Color{0, 0, 1});
}

TEST_CASE("colors add, scale, filter and mix by channel", "[color]") {
    const Color a{1, 2, 3}, b{4, 6, 8};
    CHECK(a + b == Color{5, 8, 11});
    CHECK(b - a == Color{3, 4, 5});
    CHECK(a * b == Color{4, 12, 24});
    CHECK(a * 2 == Color{2, 4, 6});
    CHECK(2 * a == Color{2, 4, 6});
    CHECK(b / 2 == Color{2, 3, 4});
    Color c = a;
    c += b;
    c *= Color{2, 1, 0};
    c *= Real(3);
    c /= Real(2);
    CHECK(c == Color{15, 12, 0});
    CHECK(rt::mix(a, b, 0) == a);
    CHECK(rt::mix(a, b, 1) == b);
    CHECK(rt::mix(a, b, Real(0.5)) == Color{Real(2.5), 4, Real(5.5)});
}

TEST_CASE("is_finite looks at every channel of a color", "[color]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    CHECK(rt::is_finite(Color{1, 2, 3}));
    for (const Real bad : {nan, rt::infinity, -rt::infinity}) {
        CHECK_FALSE(rt::is_finite(Color{bad, 0, 0}));
        CHECK_FALSE(rt::is_finite(Color{0, bad, 0}));
        CHECK_FALSE(rt::is_finite(Color{0, 0, bad}));
    }
}
