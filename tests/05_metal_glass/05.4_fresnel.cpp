#include <rt/fresnel.hpp>
#include <vector>

#include "exact_vectors.hpp"

using namespace checkpoint;

namespace {

// A surface, met at some angle: all that Fresnel's equations speak of, in twice the digits of
// double.
struct Interface {
    Exact eta, cosine;
    Exact squared_beyond() const {
        return Exact(1) - eta * eta * (Exact(1) - cosine) * (Exact(1) + cosine);
    }
    bool is_total() const { return squared_beyond() < Exact(0); }
    Exact beyond() const { return sqrt(squared_beyond()); }
    Exact r_s() const { return (eta * cosine - beyond()) / (eta * cosine + beyond()); }
    Exact r_p() const { return (cosine - eta * beyond()) / (cosine + eta * beyond()); }
    Exact reflectance() const { return (r_s() * r_s() + r_p() * r_p()) / Exact(2); }
    // What goes through, from the wave's amplitudes and the widths of the beams.
    Exact transmittance() const {
        const Exact t_s = Exact(2) * eta * cosine / (eta * cosine + beyond());
        const Exact t_p = Exact(2) * eta * cosine / (cosine + eta * beyond());
        return beyond() / (eta * cosine) * (t_s * t_s + t_p * t_p) / Exact(2);
    }
    Exact schlick() const {
        const Exact thin = Exact(1) < eta ? beyond() : cosine;
        const Exact r = (Exact(1) - eta) / (Exact(1) + eta), x = Exact(1) - thin;
        return r * r + (Exact(1) - r * r) * x * x * x * x * x;
    }
    // The cosine behind is a square root of a difference: how much it magnifies rounding errors.
    double magnification() const {
        return 1 + (eta * eta * cosine * cosine / squared_beyond()).high;
    }
};

// The formulas round fewer than 50 times, counting a square twice, and the cosine behind brings its
// own errors.
double allowed(const Interface& surface) {
    return static_cast<double>(rt::rounding_bound(50)) * surface.magnification();
}

// Every angle and index ratio of a grid, as Real holds them, but for total reflection.
template <class Check>
void for_each_interface(Check check) {
    for (const double ratio : {0.4, 0.5, 1 / 1.5, 0.75, 0.9, 1.1, 1.33, 1.5, 2.0, 2.5})
        for (int i = 1; i <= 60; ++i) {
            const Real eta = real(ratio), cosine = static_cast<Real>(i) / 60;
            const Interface surface{exact(eta), exact(cosine)};
            if (!surface.is_total()) check(eta, cosine, surface);
        }
}

void check_error(Real computed, Exact expected, double limit, Real eta, Real cosine,
                 const char* hint) {
    if (std::abs((expected - exact(computed)).high) <= limit) return;
    INFO("cosine " << text(cosine) << ", eta " << text(eta));
    HINT(expected, computed, hint);
    REQUIRE(std::abs((expected - exact(computed)).high) <= limit);
}

}  // namespace

TEST_CASE("05.4 the cosine behind the surface follows from the law of Snell", "[05.4]") {
    for_each_interface([](Real eta, Real cosine, const Interface& surface) {
        const auto computed = rt::refracted_cosine(cosine, eta);
        INFO("cosine " << text(cosine) << ", eta " << text(eta));
        REQUIRE(computed.has_value());
        check_error(*computed, surface.beyond(), allowed(surface), eta, cosine,
                    "cosine behind = sqrt(1 - eta^2 (1 - cosine^2)); where that cancels, "
                    "difference_of_products(eta c, eta c, eta - 1, eta + 1) keeps the digits");
    });
    CHECK(!rt::refracted_cosine(real(0.5), real(1.5)).has_value());
}

TEST_CASE("05.4 head on both formulas give the square of the contrast", "[05.4]") {
    for (const double index : {1.1, 1.33, 1.5, 2.0, 2.5})
        for (const double ratio : {index, 1 / index}) {
            const double r = (1 - ratio) / (1 + ratio);
            INFO("eta = " << ratio << ": expected ((1 - eta) / (1 + eta))^2 = " << r * r);
            const double limit = static_cast<double>(rt::rounding_bound(64));
            CHECK(std::abs(static_cast<double>(rt::fresnel_reflectance(1, real(ratio))) - r * r) <=
                  limit);
            CHECK(std::abs(static_cast<double>(rt::schlick_reflectance(1, real(ratio))) - r * r) <=
                  limit);
        }
}

TEST_CASE("05.4 Fresnel reflectance is the mean over both polarisations", "[05.4]") {
    for_each_interface([](Real eta, Real cosine, const Interface& surface) {
        const Real computed = rt::fresnel_reflectance(cosine, eta);
        const char* hint = "square r_s and r_p each, then take the mean";
        const auto is_near = [&](Exact x) {
            return std::abs((x - exact(computed)).high) <= allowed(surface);
        };
        if (is_near(surface.r_s() * surface.r_s())) hint = "this is r_s squared alone";
        if (is_near(surface.r_p() * surface.r_p())) hint = "this is r_p squared alone";
        check_error(computed, surface.reflectance(), allowed(surface), eta, cosine, hint);
    });
}

TEST_CASE("05.4 reflectance and transmittance add up to 1", "[05.4]") {
    for_each_interface([](Real eta, Real cosine, const Interface& surface) {
        const Real computed = rt::fresnel_reflectance(cosine, eta);
        check_error(computed, Exact(1) - surface.transmittance(), allowed(surface), eta, cosine,
                    "what is not reflected goes through: the transmittance, from the amplitudes "
                    "behind the surface, is the rest");
    });
}

TEST_CASE("05.4 at the angle of Brewster one polarisation is left", "[05.4]") {
    for (const double index : {1.1, 1.33, 1.5, 2.0, 2.5})
        for (const double n : {index, 1 / index}) {
            // tan(angle) = n, the index behind divided by the one in front: r_p is 0 there.
            const Real cosine = real(1 / std::sqrt(1 + n * n)), eta = real(1 / n);
            const double r_s = (n * n - 1) / (n * n + 1);
            const Interface surface{exact(eta), exact(cosine)};
            INFO("index " << n << ": r_s^2 / 2 is left of the light");
            check_error(rt::fresnel_reflectance(cosine, eta), Exact(r_s * r_s / 2),
                        allowed(surface), eta, cosine,
                        "r_p = (cosine - eta * beyond) / (cosine + eta * beyond) is 0 here");
        }
}

TEST_CASE("05.4 Schlick takes the cosine on the thinner side", "[05.4]") {
    for_each_interface([](Real eta, Real cosine, const Interface& surface) {
        check_error(rt::schlick_reflectance(cosine, eta), surface.schlick(), 5 * allowed(surface),
                    eta, cosine,
                    eta > 1 ? "from the denser side (eta > 1), Schlick's cosine is the one behind "
                              "the surface"
                            : "r0 + (1 - r0) (1 - cosine)^5 with r0 = ((1 - eta) / (1 + eta))^2");
    });
}

TEST_CASE("05.4 total reflection reflects everything", "[05.4]") {
    for (const double ratio : {1.1, 1.5, 2.5})
        for (const double part : {0.0, 0.5, 0.99}) {
            const Real cosine = real(part * std::sqrt(1 - 1 / (ratio * ratio)));
            INFO("eta = " << ratio << ", cosine " << cosine << ": beyond the critical angle");
            CHECK(!rt::refracted_cosine(cosine, real(ratio)).has_value());
            const Real fresnel = rt::fresnel_reflectance(cosine, real(ratio));
            const Real schlick = rt::schlick_reflectance(cosine, real(ratio));
            INFO("expected 1, but yours gives " << text(fresnel) << " (exact), " << text(schlick)
                                                << " (Schlick)");
            CHECK((fresnel == 1));
            CHECK((schlick == 1));
        }
}

TEST_CASE("05.4 both formulas are continuous at total reflection", "[05.4][hard]") {
    for (const double ratio : {1.05, 1.1, 1.33, 1.5, 2.0, 2.5}) {
        const Real eta = real(ratio);
        const Exact inverse = Exact(1) / exact(eta);
        Real cosine = static_cast<Real>(sqrt((Exact(1) - inverse) * (Exact(1) + inverse)).high);
        for (int i = 0; i < 4; ++i) cosine = std::nextafter(cosine, Real(0));
        for (int ulps = -4; ulps <= 4; ++ulps, cosine = std::nextafter(cosine, Real(1))) {
            // 4 ulp beside the critical angle, the cosine behind is up to eta * sqrt(8 epsilon),
            // and half as much again is its rounding error. To first order each formula falls by a
            // multiple of it.
            const double c = static_cast<double>(cosine);
            const double beyond = ratio * std::sqrt(12 * static_cast<double>(rt::epsilon));
            const double fresnel_falls = 2 * beyond * (1 / (ratio * c) + ratio / c);
            const double schlick_falls = 5 * beyond;
            const double fresnel = static_cast<double>(rt::fresnel_reflectance(cosine, eta));
            const double schlick = static_cast<double>(rt::schlick_reflectance(cosine, eta));
            INFO(
                "eta = " << ratio << ", " << ulps << " ulp from the critical angle: exact "
                         << fresnel << ", Schlick " << schlick
                         << "\nHint: not a number comes from the root of a negative number or from "
                            "0 / 0; a value too far from 1 from 1 - eta^2 (1 - c^2), which has no "
                            "digits left here (take difference_of_products), or, Schlick's, from "
                            "the wrong cosine");
            REQUIRE((1 - fresnel_falls <= fresnel && fresnel <= 1));
            const double rounding = static_cast<double>(rt::rounding_bound(8));
            REQUIRE((1 - schlick_falls - rounding <= schlick && schlick <= 1 + rounding));
        }
    }
}

TEST_CASE("05.4 equal indices reflect nothing", "[05.4][hard]") {
    for (const Real cosine : {Real(0), std::numeric_limits<Real>::denorm_min(), rt::epsilon,
                              real(0.1), real(0.5), 1 - rt::epsilon, Real(1), 1 + rt::epsilon}) {
        INFO("cosine " << text(cosine)
                       << "\nHint: with eta = 1 there is no surface; at a cosine of "
                       << "0 the formulas even divide 0 by 0");
        const Real computed = rt::fresnel_reflectance(cosine, 1);
        INFO("expected 0, but yours gives " << text(computed));
        CHECK((computed == 0));
    }
}

TEST_CASE("05.4 nearly equal indices keep their digits", "[05.4][hard]") {
    for (int exponent = 3; exponent < std::numeric_limits<Real>::digits - 1; ++exponent)
        for (const int sign : {-1, 1})
            for (const double part : {0.05, 0.3, 0.7, 1.0}) {
                const Real eta = 1 + static_cast<Real>(sign) * std::scalbn(Real(1), -exponent);
                const Real cosine = real(part);
                const Interface surface{exact(eta), exact(cosine)};
                if (surface.is_total()) continue;
                const Exact expected = surface.reflectance();
                check_error(rt::fresnel_reflectance(cosine, eta), expected,
                            allowed(surface) * expected.high, eta, cosine,
                            "eta c - c' cancels here; it equals (eta^2 - 1) / (eta c + c'), and "
                            "eta^2 - 1 is (eta - 1) (eta + 1)");
            }
}

TEST_CASE("05.4 grazing light is reflected as a whole", "[05.4][hard]") {
    for (const double ratio : {0.4, 1 / 1.5, 0.99}) {
        const double rounding = static_cast<double>(rt::rounding_bound(50));
        for (const Real cosine : {Real(0), std::numeric_limits<Real>::denorm_min()}) {
            INFO("eta " << ratio << ", cosine " << text(cosine));
            const auto fresnel = static_cast<double>(rt::fresnel_reflectance(cosine, real(ratio)));
            const auto schlick = static_cast<double>(rt::schlick_reflectance(cosine, real(ratio)));
            CHECK((1 - rounding <= fresnel && fresnel <= 1));
            CHECK(std::abs(schlick - 1) <= rounding);
        }
    }
}

TEST_CASE("05.4 a cosine that rounding put above 1 counts as 1", "[05.4][hard]") {
    for (const double ratio : {0.4, 1 / 1.5, 1.5, 2.5}) {
        const Real above = 1 + 3 * rt::epsilon, eta = real(ratio);
        const auto check = [&](const char* name, Real at_1, Real computed) {
            INFO(name << ", eta " << text(eta) << ", cosine " << text(above));
            HINT(at_1, computed, "take std::min(cosine, Real(1)) wherever the cosine is used");
            CHECK((computed == at_1));
        };
        check("exact", rt::fresnel_reflectance(1, eta), rt::fresnel_reflectance(above, eta));
        check("Schlick", rt::schlick_reflectance(1, eta), rt::schlick_reflectance(above, eta));
    }
}
