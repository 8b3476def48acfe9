#include <checkpoint.hpp>
#include <rt/color.hpp>
#include <rt/through_haze.hpp>

using namespace checkpoint;
using rt::Color;
using rt::Haze;

namespace {

const Real far_away = std::numeric_limits<Real>::infinity();
const Color orange{Real(0.9), Real(0.5), Real(0.1)}, blue{Real(0.25), Real(0.5), Real(0.75)};

// What the eye sees through this haze, and how often the distance was asked for.
template <class AnyHaze>
Color seen(const AnyHaze& haze, Color color, Real distance, int* asked = nullptr) {
    int count = 0;
    const Color result = rt::through_haze(haze, color, [&] {
        ++count;
        return distance;
    });
    if (asked) *asked = count;
    return result;
}

std::string words(Color color) {
    return text(Vec3{color.r, color.g, color.b});
}

// Checks a color that is right within a few roundings of its channels.
void check(const Haze& haze, Color color, Real distance, Color expected, const char* hint) {
    const Color computed = seen(haze, color, distance);
    INFO("density " << text(haze.density) << ", color of the haze " << words(haze.color));
    INFO("light " << words(color) << ", distance " << text(distance));
    INFO(EXPECTED << words(expected) << ", " ACTUAL << words(computed) << "\nHint: " << hint);
    const auto is_near = [](Real a, Real b) { return std::abs(a - b) <= 16 * rt::epsilon * b; };
    CHECK((is_near(computed.r, expected.r) && is_near(computed.g, expected.g) &&
           is_near(computed.b, expected.b)));
}

void check_same(Color computed, Color expected, const char* hint) {
    INFO(EXPECTED << words(expected) << ", " ACTUAL << words(computed) << "\nHint: " << hint);
    CHECK(computed == expected);
}

}  // namespace

TEST_CASE("08.6 haze dims what is behind it", "[08.6]") {
    // Black haze takes light away and adds none. exp(-ln 2) = 1/2.
    const Real half = real(0.69314718055994530942);
    check({half, {}}, orange, 1, Real(0.5) * orange,
          "the fraction exp(-density * distance) gets through, here a half");
    check({half, {}}, orange, 3, Real(0.125) * orange,
          "the way through the haze is three times as long: half of a half of a half gets through");
    check({3 * half, {}}, orange, 1, Real(0.125) * orange,
          "the haze is three times as dense: half of a half of a half gets through");
    check({Real(0.25), {}}, {1, 1, 1}, 8, real(0.13533528323661269189) * Color{1, 1, 1},
          "exp(-0.25 * 8) = 0.135");
}

TEST_CASE("08.6 the color of the haze replaces the light that is lost", "[08.6]") {
    const Real half = real(0.69314718055994530942);
    check({half, blue}, {}, 1, Real(0.5) * blue,
          "behind the haze it is black: you see half of the haze's own color");
    check({half, blue}, orange, 1, Real(0.5) * orange + Real(0.5) * blue,
          "half of each color: add the haze's color, and do not multiply by it");
    check({half, blue}, orange, 2, Real(0.25) * orange + Real(0.75) * blue,
          "a quarter of the color gets through, and three quarters are the haze's color");
    check({Real(0.1), blue}, blue, 7, blue,
          "an object of the haze's color keeps it: the two fractions add up to 1");
}

TEST_CASE("08.6 at distance 0 there is no haze and at infinity only haze", "[08.6]") {
    check({2, blue}, orange, 0, orange, "at distance 0 everything gets through");
    check({2, blue}, orange, far_away, blue,
          "infinitely far away nothing gets through: only the haze is left, and the sky is no "
          "exception");
}

TEST_CASE("08.6 at density 0 the color stays and distance is not called", "[08.6]") {
    for (const Real distance : {Real(0), Real(3), far_away}) {
        int asked = 0;
        check_same(
            seen(Haze{0, blue}, orange, distance, &asked), orange,
            "a renderer that has every effect also draws scenes without haze, and if a ray misses "
            "everything, 0 times infinity is NaN: return the color itself if the density is 0");
        INFO("Hint: if the density is 0, return before you call distance(): it is a search");
        CHECK(asked == 0);
    }
}

TEST_CASE("08.6 without the effect the color stays and distance is not called", "[08.6]") {
    for (const Real distance : {Real(0), Real(3), far_away}) {
        int asked = 0;
        check_same(seen(rt::NoHaze{}, orange, distance, &asked), orange,
                   "with NoHaze there is no haze: return the color itself");
        INFO(
            "Hint: call distance() only inside of the `if constexpr`: an effect that is absent "
            "must cost nothing");
        CHECK(asked == 0);
    }
}

TEST_CASE("08.6 distance is called only once", "[08.6]") {
    int asked = 0;
    seen(Haze{Real(0.5), blue}, orange, 2, &asked);
    INFO("Hint: distance() is a whole search: call it once, and keep what it gives");
    CHECK(asked == 1);
}

TEST_CASE("08.6 nothing is left of a bright lamp behind dense haze", "[08.6][hard]") {
    const Color lamp{real(1e6), real(1e9), real(1e12)};
    const char* const hint =
        "nothing gets through, so only the haze's color is left; color + (1 - share) * (haze - "
        "color) subtracts a huge number from itself: weight the two by share and 1 - share instead";
    check_same(seen(Haze{1, blue}, lamp, far_away), blue, hint);
    check_same(seen(Haze{1, blue}, lamp, 10'000), blue, hint);
    // A little of it: exp(-20) of 1e6 is 0.002.
    check(
        {1, blue}, {real(1e6), real(1e6), real(1e6)}, 20,
        real(2061.1536224385578280e-6) * Color{1, 1, 1} + real(1 - 2.0611536224385578280e-9) * blue,
        hint);
}

TEST_CASE("08.6 the largest and smallest densities and distances give correct colors",
          "[08.6][hard]") {
    const Real most = std::numeric_limits<Real>::max(), least = std::numeric_limits<Real>::min();
    const char* const dense = "the haze is so dense that nothing gets through";
    check_same(seen(Haze{most, blue}, orange, most), blue, dense);
    check_same(seen(Haze{most, blue}, orange, 1), blue, dense);
    check_same(seen(Haze{1, blue}, orange, most), blue, dense);
    const char* const thin = "the haze is so thin that everything gets through";
    check_same(seen(Haze{least, blue}, orange, 1), orange, thin);
    check_same(seen(Haze{least, blue}, orange, least), orange, thin);
    // The same scene, with all lengths 2^60 times as large or as small.
    const Color here = seen(Haze{Real(0.5), blue}, orange, 2);
    for (const Real scale : {Real(0x1p60), Real(0x1p-60)})
        check_same(seen(Haze{Real(0.5) / scale, blue}, orange, 2 * scale), here,
                   "only the product of density and distance counts, and it is a pure number");
}
