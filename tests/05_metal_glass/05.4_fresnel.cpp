#include <rt/fresnel.hpp>

#include "exact_vectors.hpp"

using namespace checkpoint;

namespace {

// A surface that light meets at some angle: everything in Fresnel's equations, in twice the
// digits of double.
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
    // How much the cosine behind, a square root of a difference, magnifies rounding errors.
    double magnification() const {
        return 1 + (eta * eta * cosine * cosine / squared_beyond()).high;
    }
};

// The formulas round fewer than 50 times, counting a square twice, and the cosine behind brings
// its own errors.
double allowed(const Interface& surface) {
    return static_cast<double>(rt::rounding_bound(50)) * surface.magnification();
}

template <class Check>
void check_interface(Real eta, Real cosine, const Check& check) {
    const Interface surface{exact(eta), exact(cosine)};
    if (!surface.is_total()) check(eta, cosine, surface);
}

// Every angle and index ratio of a grid, as Real holds them, and others at random, except
// for total reflection.
template <class Check>
void for_each_interface(Check check) {
    for (const double ratio : {0.4, 0.5, 1 / 1.5, 0.75, 0.9, 1.1, 1.33, 1.5, 2.0, 2.5})
        for (int i = 1; i <= 60; ++i)
            check_interface(real(ratio), static_cast<Real>(i) / 60, check);
    rt::Rng rng{54, 1};
    for (int i = 0; i < 1000; ++i) {
        const Real eta = rng.uniform(real(0.2), 3), least = eta > 1 ? 1 - 1 / eta / eta : 0;
        const Real cosine = std::sqrt(rng.uniform(least + real(0.01) * (1 - least), 1));
        if (std::abs(eta - 1) > real(0.01)) check_interface(eta, cosine, check);
    }
}

// The hard cases: ratios of any size and as near to 1 as Real can hold, angles as near to 0, to a
// right angle and to total reflection.
template <class Check>
void for_each_hard_interface(Check check) {
    rt::Rng rng{54, 4};
    const auto any_power = [&](Real lowest, Real highest) {
        return std::pow(Real(10), rng.uniform(lowest, highest));
    };
    const Real smallest = for_this_precision(-6, -15);
    for (int i = 0; i < 4000; ++i) {
        const Real near_1 = 1 + (i & 4 ? any_power(smallest, -1) : -any_power(smallest, -1));
        const Real eta = i % 100 == 0 ? 1 : i & 1 ? near_1 : any_power(-3, 3);
        // The cosine at the critical angle, where there is one.
        const Real critical = eta > 1 ? std::sqrt((1 - 1 / eta) * (1 + 1 / eta)) : 0;
        const Real part = i & 2   ? rng.uniform()
                          : i & 8 ? any_power(smallest / 2, -1)
                                  : 1 - any_power(smallest, -1);
        check_interface(eta, i % 50 == 1 ? 1 : critical + (1 - critical) * part, check);
    }
}

void check_error(Real computed, Exact expected, double limit, Real eta, Real cosine,
                 const char* hint) {
    const double error = std::abs((expected - exact(computed)).high);
    if (!(error <= limit)) {
        INFO("cosine " << text(cosine) << ", eta " << text(eta) << "; rounding allows an error of "
                       << limit);
        HINT(expected, computed, hint);
        REQUIRE(text(computed) == text(expected));
    }
    REQUIRE(error <= limit);
}

}  // namespace

TEST_CASE("05.4 the cosine of the refraction angle follows from the law of refraction", "[05.4]") {
    for_each_interface([](Real eta, Real cosine, const Interface& surface) {
        const auto computed = rt::refracted_cosine(cosine, eta);
        if (!computed) {
            INFO("cosine " << text(cosine) << ", eta " << text(eta) << ": light goes through here");
            REQUIRE(computed.has_value());
        }
        check_error(*computed, surface.beyond(), allowed(surface), eta, cosine,
                    "the cosine of the refraction angle is sqrt(1 - eta^2 (1 - cosine^2))");
    });
    const auto beyond = rt::refracted_cosine(real(0.5), real(1.5));
    INFO(
        "refracted_cosine(0.5, 1.5): " EXPECTED "none, " ACTUAL
        << (beyond ? text(*beyond) : "none")
        << "\nHint: below the root is 1 - 2.25 * 0.75, which is below 0: return {} before you take "
           "the root");
    CHECK(!beyond.has_value());
}

TEST_CASE("05.4 for head-on light both formulas give ((1 - eta) / (1 + eta))^2", "[05.4]") {
    for (const double index : {1.1, 1.33, 1.5, 2.0, 2.5})
        for (const double ratio : {index, 1 / index}) {
            const double r = (1 - ratio) / (1 + ratio);
            const auto is_near = [&](Real computed) {
                const double limit = static_cast<double>(rt::rounding_bound(64));
                return std::abs(static_cast<double>(computed) - r * r) <= limit;
            };
            const Real fresnel = rt::fresnel_reflectance(1, real(ratio));
            const Real schlick = rt::schlick_reflectance(1, real(ratio));
            INFO("eta = " << ratio << ": " EXPECTED "((1 - eta) / (1 + eta))^2 = "
                          << text(real(r * r)) << ", " ACTUAL << text(fresnel) << " (exact), "
                          << text(schlick) << " (Schlick)");
            {
                INFO("Hint: here r_s and r_p have equal squares; the exact value is their mean");
                CHECK(is_near(fresnel));
            }
            {
                INFO("Hint: with a cosine of 1, Schlick's formula gives r0");
                CHECK(is_near(schlick));
            }
        }
}

TEST_CASE("05.4 Fresnel reflectance is the mean over both polarizations", "[05.4]") {
    for_each_interface([](Real eta, Real cosine, const Interface& surface) {
        const Real computed = rt::fresnel_reflectance(cosine, eta);
        const char* hint =
            "the mean of r_s squared and r_p squared: r_s = (eta c - c') / (eta c + c'), "
            "r_p = (c - eta c') / (c + eta c'), where c' is refracted_cosine(c, eta)";
        const auto is_near = [&](Exact x) {
            return std::abs((x - exact(computed)).high) <= allowed(surface);
        };
        if (is_near(surface.r_s() * surface.r_s()))
            hint = "this is r_s squared: take the mean of r_s squared and r_p squared";
        if (is_near(surface.r_p() * surface.r_p()))
            hint = "this is r_p squared: take the mean of r_s squared and r_p squared";
        check_error(computed, surface.reflectance(), allowed(surface), eta, cosine, hint);
        if (0 <= computed && computed <= 1) return;
        INFO("cosine " << text(cosine) << ", eta " << text(eta)
                       << ".\nHint: rounding may put the reflectance above 1; it is a fraction: "
                          "take std::min(Real(1), ...)");
        REQUIRE(text(computed) == "from 0 to 1");
    });
}

TEST_CASE("05.4 reflectance and transmittance add up to 1", "[05.4]") {
    for_each_interface([](Real eta, Real cosine, const Interface& surface) {
        const Real computed = rt::fresnel_reflectance(cosine, eta);
        check_error(computed, Exact(1) - surface.transmittance(), allowed(surface), eta, cosine,
                    "light that is not reflected goes through: reflectance and transmittance, "
                    "which the test computes from the refracted light's amplitudes, add up to 1");
    });
}

TEST_CASE("05.4 at the Brewster angle one polarization is not reflected", "[05.4]") {
    for (const double index : {1.1, 1.33, 1.5, 2.0, 2.5})
        for (const double n : {index, 1 / index}) {
            // tan(angle) = n, the index behind divided by the one in front: r_p is 0 there.
            const Real cosine = real(1 / std::sqrt(1 + n * n)), eta = real(1 / n);
            const double r_s = (n * n - 1) / (n * n + 1);
            const Interface surface{exact(eta), exact(cosine)};
            INFO("index " << n << ": only r_s^2 / 2 of the light is reflected");
            check_error(rt::fresnel_reflectance(cosine, eta), Exact(r_s * r_s / 2),
                        allowed(surface), eta, cosine,
                        "r_p = (cosine - eta * beyond) / (cosine + eta * beyond) is 0 here");
        }
}

TEST_CASE("05.4 Schlick takes the cosine on the side with the lower index", "[05.4]") {
    for_each_interface([](Real eta, Real cosine, const Interface& surface) {
        check_error(rt::schlick_reflectance(cosine, eta), surface.schlick(), 5 * allowed(surface),
                    eta, cosine,
                    eta > 1 ? "from the denser side (eta > 1), Schlick's formula takes the cosine "
                              "of the refraction angle"
                            : "r0 + (1 - r0) (1 - cosine)^5 with r0 = ((1 - eta) / (1 + eta))^2 "
                              "and, for eta <= 1, the given cosine");
    });
}

TEST_CASE("05.4 beyond the critical angle both formulas give 1", "[05.4]") {
    rt::Rng rng{54, 2};
    for (int i = 0; i < 1000; ++i) {
        const double ratios[] = {1.1, 1.5, 2.5};
        const double ratio = i < 9 ? ratios[i / 3] : 1 + std::pow(10, rng.uniform(-3, 3));
        const double parts[] = {0.0, 0.5, 0.99};
        const double part = i < 9 ? parts[i % 3] : 0.99 * static_cast<double>(rng.uniform());
        const Real eta = real(ratio), cosine = real(part * std::sqrt(1 - 1 / (ratio * ratio)));
        const auto beyond = rt::refracted_cosine(cosine, eta);
        const Real fresnel = rt::fresnel_reflectance(cosine, eta);
        const Real schlick = rt::schlick_reflectance(cosine, eta);
        INFO("eta = " << text(eta) << ", cosine " << text(cosine)
                      << ": beyond the critical angle, all light is reflected");
        CHECK_FALSE(beyond.has_value());
        INFO(EXPECTED "1, " ACTUAL << text(fresnel) << " (exact), " << text(schlick)
                                   << " (Schlick)");
        REQUIRE(text(fresnel) == "1");
        REQUIRE(text(schlick) == "1");
    }
}

TEST_CASE("05.4 cosine and reflectance keep to their error bounds at any ratio and angle",
          "[05.4][hard]") {
    // So close to the critical angle the product of eta and the cosine is rounded too much to tell.
    const auto is_in_doubt = [](const Interface& surface) {
        const Exact scaled = surface.eta * surface.cosine;
        return std::abs(surface.squared_beyond().high) <=
               8 * static_cast<double>(rt::epsilon) * (scaled * scaled).high;
    };
    for_each_hard_interface([&](Real eta, Real cosine, const Interface& surface) {
        if (eta > 1 && is_in_doubt(surface)) return;
        const auto beyond = rt::refracted_cosine(cosine, eta);
        if (!beyond) {
            INFO("cosine " << text(cosine) << ", eta " << text(eta) << ": light goes through here");
            REQUIRE(beyond.has_value());
        }
        check_error(
            *beyond, surface.beyond(), allowed(surface) * surface.beyond().high, eta, cosine,
            "the cosine of the refraction angle loses digits, because 1 - eta^2 (1 - cosine^2) "
            "cancels; difference_of_products(eta c, eta c, eta - 1, eta + 1) keeps the digits");
        const Real fresnel = rt::fresnel_reflectance(cosine, eta);
        check_error(fresnel, surface.reflectance(), allowed(surface), eta, cosine,
                    "r_s = (eta - 1) (eta + 1) / (eta c + c')^2 and the ratio r_p / r_s from the "
                    "text do not cancel");
        if (!(0 <= fresnel && fresnel <= 1)) {
            INFO("cosine " << text(cosine) << ", eta " << text(eta)
                           << ".\nHint: rounding may put the reflectance above 1; it is a "
                              "fraction: take std::min(Real(1), ...)");
            REQUIRE(text(fresnel) == "from 0 to 1");
        }
        check_error(rt::schlick_reflectance(cosine, eta), surface.schlick(), 5 * allowed(surface),
                    eta, cosine,
                    "for Schlick's formula, use the same refracted cosine if eta > 1; there is no "
                    "other special case");
    });
    // And where nothing goes through, however near that is to the critical angle.
    rt::Rng rng{54, 5};
    for (int i = 0; i < 2000; ++i) {
        const Real eta = 1 + std::pow(Real(10), rng.uniform(-2, 2));
        const Real critical = std::sqrt((1 - 1 / eta) * (1 + 1 / eta));
        const Real below = std::pow(Real(10), rng.uniform(for_this_precision(-6, -15), 0));
        const Real cosine = critical * (1 - below);
        const Interface surface{exact(eta), exact(cosine)};
        if (!surface.is_total() || is_in_doubt(surface)) continue;
        const auto beyond = rt::refracted_cosine(cosine, eta);
        if (!beyond) continue;
        INFO("cosine " << text(cosine) << ", eta " << text(eta)
                       << ": the square of the refraction angle's cosine would be "
                       << surface.squared_beyond().high << ": " EXPECTED "none, " ACTUAL
                       << text(*beyond) << ".\nHint: return {} if it is below 0, however slightly");
        REQUIRE_FALSE(beyond.has_value());
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
                         << "\nHint: NaN comes from the root of a negative number or from 0 / 0; a "
                            "value too far from 1 comes from 1 - eta^2 (1 - c^2), which has no "
                            "digits left here (take difference_of_products), or, in Schlick's "
                            "formula, from the wrong cosine");
            const double rounding = static_cast<double>(rt::rounding_bound(8));
            REQUIRE(fresnel >= 1 - fresnel_falls);
            REQUIRE(schlick >= 1 - schlick_falls - rounding);
            INFO("the reflectance is a fraction, so it is at most 1");
            if (fresnel > 1) REQUIRE(text(real(fresnel)) == "1 at most");
            if (schlick > 1 + rounding) REQUIRE(text(real(schlick)) == "1 at most");
        }
    }
}

TEST_CASE("05.4 the reflectance is 0 for equal indices", "[05.4][hard]") {
    for (const Real cosine : {Real(0), std::numeric_limits<Real>::denorm_min(), rt::epsilon,
                              real(0.1), real(0.5), 1 - rt::epsilon, Real(1), 1 + rt::epsilon}) {
        INFO("cosine " << text(cosine)
                       << "\nHint: with eta = 1 there is no surface: return 0. At a cosine of "
                       << "0 the formulas even divide 0 by 0");
        const Real computed = rt::fresnel_reflectance(cosine, 1);
        CHECK(text(std::abs(computed)) == "0");
    }
}

TEST_CASE("05.4 the reflectance is accurate for nearly equal indices", "[05.4][hard]") {
    rt::Rng rng{54, 3};
    const int digits = std::numeric_limits<Real>::digits;
    for (int i = 0; i < 4000; ++i) {
        // Any distance from 1, down to a few of Real's steps.
        const int exponent = 3 + i % (digits - 4);
        const Real distance = std::scalbn(i < 500 ? Real(1) : rng.uniform(1, 2), -exponent);
        const Real eta = rng() & 1 ? 1 + distance : 1 - distance;
        const Real parts[] = {real(0.05), real(0.3), real(0.7), 1};
        const Real cosine = i % 2 ? parts[rng() % 4] : rng.uniform(real(0.001), 1);
        const Interface surface{exact(eta), exact(cosine)};
        if (surface.is_total()) continue;
        const Exact expected = surface.reflectance();
        check_error(rt::fresnel_reflectance(cosine, eta), expected,
                    allowed(surface) * expected.high, eta, cosine,
                    "eta c - c' cancels here; it equals (eta^2 - 1) / (eta c + c'), and eta^2 - 1 "
                    "is (eta - 1) (eta + 1)");
    }
}

TEST_CASE("05.4 grazing light is reflected completely", "[05.4][hard]") {
    CHECK(rt::refracted_cosine(0, 1) == Real(0));  // no total reflection between equal indices
    const double rounding = static_cast<double>(rt::rounding_bound(50));
    for (const double ratio : {0.05, 0.2, 0.4, 0.5, 1 / 1.5, 0.75, 0.9, 0.99})
        for (const Real cosine : {Real(0), std::numeric_limits<Real>::denorm_min(),
                                  rt::epsilon / 1024, rt::epsilon / 64}) {
            INFO("eta " << ratio << ", cosine " << text(cosine)
                        << ": " EXPECTED
                           "1 within rounding, and never more than 1.\nHint: std::min(..., "
                           "Real(1)) limits a result that rounding put above 1");
            const Real fresnel = rt::fresnel_reflectance(cosine, real(ratio));
            const Real schlick = rt::schlick_reflectance(cosine, real(ratio));
            // At a small cosine it is 1 - 2 c (eta + 1 / eta) / sqrt(1 - eta^2), or 1 - 5 c.
            const double falls = 50 * static_cast<double>(cosine) / ratio;
            INFO("actual " << text(fresnel) << " (exact), " << text(schlick) << " (Schlick)");
            const bool fresnel_is_right =
                1 - rounding - falls <= static_cast<double>(fresnel) && fresnel <= 1;
            CHECK(fresnel_is_right);
            const bool schlick_is_right =
                std::abs(static_cast<double>(schlick) - 1) <= rounding + falls;
            CHECK(schlick_is_right);
        }
}

TEST_CASE("05.4 a cosine that rounding put above 1 counts as 1", "[05.4][hard]") {
    const auto check = [](const char* name, Real eta, Real cosine, Real at_1, Real computed) {
        if (computed == at_1) return;
        INFO(name << ", eta " << text(eta) << ", cosine " << text(cosine));
        HINT(at_1, computed, "take std::min(cosine, Real(1)) wherever the cosine is used");
        CHECK(text(computed) == text(at_1));
    };
    for (const double ratio : {0.1, 0.4, 1 / 1.5, 0.999, 1.0, 1.001, 1.5, 2.5, 10.0})
        for (const Real more : {1, 2, 3, 4}) {
            const Real above = 1 + more * rt::epsilon, eta = real(ratio);
            const auto behind = rt::refracted_cosine(above, eta);
            INFO("eta " << text(eta) << ", cosine " << text(above));
            REQUIRE(behind.has_value());
            check("refracted_cosine", eta, above, *rt::refracted_cosine(1, eta), *behind);
            check("exact", eta, above, rt::fresnel_reflectance(1, eta),
                  rt::fresnel_reflectance(above, eta));
            check("Schlick", eta, above, rt::schlick_reflectance(1, eta),
                  rt::schlick_reflectance(above, eta));
        }
}
