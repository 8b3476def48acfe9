#include <rt/lambert.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;

namespace {

// What lambert gives for a floor and a light; the sine of the light's height above the
// horizon is given.
Real light_on_floor(Real height) {
    return rt::lambert({0, 1, 0}, {std::sqrt(1 - height * height), height, 0});
}

// What rounding may do to a product that is the cosine itself. It leaves room for vectors that are
// normalized once more, within 3.5 units in the last place each.
constexpr double allowed_ulps = 8;

}  // namespace

TEST_CASE("04.2 the light falls off as the cosine at 50 angles", "[04.2]") {
    for (int i = 0; i < 50; ++i) {
        const Real angle = rt::pi / 2 * static_cast<Real>(i) / 50;
        const Real cosine = std::cos(angle), sine = std::sin(angle);
        const Real computed = rt::lambert({0, 1, 0}, {sine, cosine, 0});
        INFO("angle between normal and light: " << 90 * i / 50.0 << " degrees");
        HINT(cosine, computed, "the dot product of two vectors of length 1 is the cosine");
        REQUIRE(error_in_ulp(computed, cosine) <= allowed_ulps);
    }
}

TEST_CASE("04.2 no light falls on a surface that faces away", "[04.2]") {
    for (int i = 51; i <= 100; ++i) {
        const Real angle = rt::pi * static_cast<Real>(i) / 100;
        const Real computed = rt::lambert({0, 1, 0}, {0, std::cos(angle), std::sin(angle)});
        INFO("angle between normal and light: " << 180 * i / 100.0 << " degrees");
        HINT(Real(0), computed, "light from behind adds nothing, and there is no negative light");
        REQUIRE(computed == 0);
    }
}

TEST_CASE("04.2 the cosine is right for any two directions", "[04.2]") {
    rt::Rng rng{42, 1};
    for (int i = 0; i < 10000; ++i) {
        const Vec3 n = any_direction(rng), l = any_direction(rng);
        const Exact cosine =
            Exact(n.x) * Exact(l.x) + Exact(n.y) * Exact(l.y) + Exact(n.z) * Exact(l.z);
        const Exact expected = cosine.high > 0 ? cosine : Exact(0);
        const Real computed = rt::lambert(n, l);
        // Three products whose absolute values add up to at most 1, and the lengths.
        const double error_in_epsilons =
            std::abs((expected - Exact(computed)).high) / static_cast<double>(rt::epsilon);
        if (!(error_in_epsilons <= 8)) {
            UNSCOPED_INFO("lambert(" << text(n) << ", " << text(l) << ")");
            UNSCOPED_HINT(expected, computed, "the light is max(0, cosine)");
        }
        REQUIRE(error_in_epsilons <= 8);
    }
}

TEST_CASE("04.2 light from just above the horizon is not lost", "[04.2][hard]") {
    for (Real height = real(0.5); height > std::numeric_limits<Real>::min(); height /= 4) {
        const Real computed = light_on_floor(height);
        INFO("the light is " << text(height) << " above the horizon");
        {
            HINT(height, computed, "only a value below 0 becomes 0: use no threshold above 0");
            REQUIRE(error_in_ulp(computed, height) <= allowed_ulps);
        }
        const Real set = light_on_floor(-height);
        if (set == 0) continue;
        INFO("now the light is as far below the horizon");
        HINT(Real(0), set, "the cosine is negative there: take the larger of 0 and the cosine");
        REQUIRE(text(set) == "0");
    }
}
