#include <rt/refract.hpp>

#include "exact_vectors.hpp"

using namespace checkpoint;

namespace {

// The sine of the angle between two vectors, exactly as they are stored.
Exact sine(Vec3 a, Vec3 b) {
    return length(cross(exact(a), exact(b))) / (length(exact(a)) * length(exact(b)));
}

// The star: Snell's law may be off by 4 epsilon, units in the last place of 1: the sine's own last
// place is no measure, since each component of the result is rounded, and that turns it by up to
// half an epsilon however small its sine is. Stored unit vectors are off by half an epsilon in
// length each, the cosine by 3 roundings, which eta multiplies, and each component by 4 more. If
// all the worst cases came together it would be 6; in 5 million directions the largest error was
// 2.2.
constexpr double allowed = 4;

// The core, in epsilon: any formula will do, also one with the square of the cosine. That square is
// off by 4 for its 7 roundings and by 2 for the lengths of the stored vectors, so eta^2 (1 - c^2)
// is off by less than 8 eta^2, and its root, the components and their sum add less than 8. Twice
// that is allowed in the square of the sine, for angles and their sines.
double plain(Real eta) {
    return 16 * (1 + static_cast<double>(eta) * static_cast<double>(eta));
}

// Snell's law for random directions and ratios up to this one or its inverse. off_over_allowed(a,
// b, eta) is at most 1 where the sines a and b of the refraction angle are as good as equal.
template <class Off>
void check_law(int directions, Real most, Off off_over_allowed, const char* hint) {
    rt::Rng rng{53, 1};
    double worst = 0;
    for (int i = 0; i < directions; ++i) {
        const auto [incoming, normal] = random_arrival(rng);
        const Real eta = rng.uniform(1 / most, most);
        const Exact expected = exact(eta) * sine(incoming, normal);
        // So close to total reflection both answers are right.
        if (off_over_allowed(Exact(1), expected, eta) <= 1) continue;
        const auto refracted = rt::refract(incoming, normal, eta);
        if (refracted.has_value() != (expected.high < 1)) {
            INFO("eta = " << text(eta) << ", eta * sine = " << text(expected)
                          << "\nHint: no direction has a sine above 1: return {}");
            REQUIRE(refracted.has_value() == (expected.high < 1));
        }
        if (!refracted) continue;
        const Exact computed = sine(*refracted, normal);
        const double off = off_over_allowed(computed, expected, eta);
        worst = std::max(worst, off);
        if (off <= 1) continue;
        INFO("incoming " << text(incoming) << ", normal " << text(normal) << ", eta " << text(eta));
        INFO("the sine of the refraction angle: " EXPECTED << text(expected) << ", " ACTUAL
                                                           << text(computed));
        INFO("Hint: " << hint << ". The value is the error, divided by the allowed error");
        REQUIRE(off <= 1);
    }
    CHECK(worst <= 1);
}

Vec3 refract_or_fail(Vec3 incoming, Vec3 normal, Real eta) {
    const auto refracted = rt::refract(incoming, normal, eta);
    INFO("refract(" << text(incoming) << ", " << text(normal) << ", " << text(eta)
                    << "): eta times the sine is less than 1: " EXPECTED
                       "a direction, actual: none");
    REQUIRE(refracted.has_value());
    return *refracted;
}

}  // namespace

TEST_CASE("05.3 light that arrives head on goes straight on", "[05.3]") {
    for (const double eta : {0.4, 1 / 1.5, 1.5, 2.5}) {
        const Vec3 computed = refract_or_fail({0, -1, 0}, floor_normal, real(eta));
        INFO("eta = " << eta);
        const char* hint =
            "if the light arrives head on, the part along the surface, d + c n, is zero; c = -(d . "
            "n) is greater than 0";
        if (computed.y > 0) hint = "the result must point to the other side, against the normal";
        HINT((Vec3{0, -1, 0}), computed, hint);
        if (!(computed == Vec3{0, -1, 0})) CHECK(text(computed) == "(0, -1, 0)");
    }
}

TEST_CASE("05.3 light that enters glass bends toward the normal", "[05.3]") {
    const auto check = [](double sine_in, double eta, double sine_out) {
        const Vec3 incoming{real(sine_in), -real(std::sqrt(1 - sine_in * sine_in)), 0};
        const Vec3 expected{real(sine_out), -real(std::sqrt(1 - sine_out * sine_out)), 0};
        const Vec3 computed = refract_or_fail(incoming, floor_normal, real(eta));
        INFO("light along " << text(incoming) << " meets a surface with the normal "
                            << text(floor_normal) << ", eta = " << eta
                            << ": the sine of the incoming angle is " << sine_in
                            << ", and the sine of the refraction angle is " << sine_out);
        const char* hint =
            "the sine of the refraction angle is eta times the sine of the incoming angle; the "
            "part along the surface is scaled by eta, and the part along the normal follows from "
            "length 1";
        if (computed.y > 0) hint = "the refracted light must point to the other side";
        if (computed.x < 0) hint = "the part along the surface keeps its direction";
        HINT(expected, computed, hint);
        const double off_in_epsilons = in_epsilon(length(exact(computed) - exact(expected)));
        CHECK(off_in_epsilons <= 16);
    };
    check(0.6, 2.0 / 3, 0.4);
    check(0.4, 1.5, 0.6);
    check(0.75, 0.5, 0.375);
}

TEST_CASE("05.3 the law of refraction holds for 20000 directions", "[05.3]") {
    check_law(
        20000, 5, [](Exact a, Exact b, Real eta) { return in_epsilon(a * a - b * b) / plain(eta); },
        "the sine of the refraction angle is eta times the sine of the incoming angle");
}

TEST_CASE("05.3 the law of refraction holds to 4 epsilon for 100000 directions", "[05.3][hard]") {
    check_law(
        100000, real(2.5), [](Exact a, Exact b, Real) { return in_epsilon(a - b) / allowed; },
        "a sine from sqrt(1 - cosine^2) loses digits");
}

TEST_CASE("05.3 refracted light has length 1 and stays in the plane of incidence", "[05.3]") {
    rt::Rng rng{53, 2};
    for (int i = 0; i < 5000; ++i) {
        const auto [incoming, normal] = random_arrival(rng);
        const Real eta = rng.uniform(real(0.4), real(2.5));
        const double sine_behind = (exact(eta) * sine(incoming, normal)).high;
        if (sine_behind > 0.999) continue;
        const Vec3 computed = refract_or_fail(incoming, normal, eta);
        // The root magnifies the rounding under it, unless it is taken from what is returned. The
        // cosine's 3 roundings and the normal's length count eta times.
        const double cosine_behind = std::sqrt(1 - sine_behind * sine_behind);
        const double longer = in_epsilon(length(exact(computed)) - Exact(1));
        const double longer_over_allowed = longer * cosine_behind / 24;
        const double side = dot(exact(computed), exact(normal)).high;
        const ExactVec3 across = cross(exact(normal), exact(incoming));
        const double beside =
            length(across).high > 1e-3 ? in_epsilon(dot(exact(computed), unit(across))) : 0;
        const double sense = dot(cross(exact(normal), exact(computed)), across).high;
        if (longer_over_allowed <= 1 && side < 0 && beside <= plain(eta) && sense > 0) continue;
        INFO("refract(" << text(incoming) << ", " << text(normal) << ", " << text(eta)
                        << ") = " << text(computed));
        {
            INFO("Hint: the result must have length 1. Its length is off by " << longer
                                                                              << " epsilon");
            REQUIRE(longer_over_allowed <= 1);
        }
        {
            INFO(
                "Hint: the result must point to the other side of the surface. The values are its "
                "dot product with the normal");
            REQUIRE(side < 0);
        }
        {
            INFO(
                "Hint: the result must lie in the plane of the normal and the incoming light. The "
                "values are its distance from the plane, in epsilon");
            REQUIRE(beside <= plain(eta));
        }
        INFO("Hint: the part along the surface must keep its direction");
        REQUIRE(sense > 0);
    }
}

TEST_CASE("05.3 any ratio of indices bends light by the right amount", "[05.3][hard]") {
    // Ratios from a millionth to a million, and as near to 1 as there are numbers.
    rt::Rng rng{53, 6};
    for (int i = 0; i < 20000; ++i) {
        const Real smallest = for_this_precision(-6, -15);
        const Real part = std::pow(Real(10), rng.uniform(smallest, -1));
        const Real eta = i % 2   ? 1 + (i % 4 == 1 ? part : -part)
                         : i % 4 ? std::pow(Real(10), rng.uniform(-6, 6))
                                 : std::pow(Real(10), rng.uniform(-1, 1));
        const Vec3 normal = random_unit(rng);
        const ExactVec3 n = exact(normal), across = unit(cross(n, exact(random_unit(rng))));
        // Any sine that gets through, also a tiny one, and now and then one that does not.
        const Real largest = std::min(Real(1), 1 / eta);
        const Real fine = std::pow(Real(10), rng.uniform(for_this_precision(-5, -14), 0));
        Real s = i % 3 == 0 ? fine * largest : i % 3 == 1 ? (1 - fine) * largest : rng.uniform();
        if (i % 16 == 0) s = 0;
        const Exact c = sqrt((Exact(1) - exact(s)) * (Exact(1) + exact(s)));
        const Vec3 incoming = rounded(exact(s) * across - c * n);
        const ExactVec3 d = exact(incoming);
        const ExactVec3 along = exact(eta) * (d - dot(d, n) * n);
        const Exact squared = Exact(1) - dot(along, along);
        // What is under the root is off by a few epsilon, times eta squared in the textbook's
        // formula; near the critical angle either answer is right.
        const double rounding =
            6 * static_cast<double>(rt::epsilon) * std::pow(1 + static_cast<double>(eta), 2);
        if (std::abs(squared.high) <= 4 * rounding) continue;
        const auto refracted = rt::refract(incoming, normal, eta);
        const auto describe = [&] {
            return "refract(" + text(incoming) + ", " + text(normal) + ", " + text(eta) +
                   "): eta times sine is " + text(length(along));
        };
        if (refracted.has_value() != (squared.high > 0)) {
            INFO(describe());
            INFO("Hint: light goes through where eta times sine is less than 1, and only there");
            REQUIRE(refracted.has_value() == (squared.high > 0));
        }
        if (!refracted) continue;
        const ExactVec3 expected = along - sqrt(squared) * n;
        const double off = length(exact(*refracted) - expected).high;
        const double off_over_allowed = off / (rounding * (2 + 2 / sqrt(squared).high));
        if (!(off_over_allowed <= 1)) {
            UNSCOPED_INFO(describe());
            UNSCOPED_HINT(expected, *refracted,
                          "eta (d + c n) is the part along the surface, for any eta greater than "
                          "0. Return d unchanged only if eta == 1 exactly");
        }
        REQUIRE(off_over_allowed <= 1);
    }
}

TEST_CASE("05.3 light leaves a slab parallel to the direction in which it entered", "[05.3]") {
    rt::Rng rng{53, 3};
    for (int i = 0; i < 5000; ++i) {
        const auto [incoming, normal] = random_arrival(rng);
        const double aside = sine(incoming, normal).high;
        if (aside > 0.999) continue;
        const Real index = rng.uniform(real(1.01), real(2.5));
        const Vec3 within = refract_or_fail(incoming, normal, 1 / index);
        const Vec3 computed = refract_or_fail(within, normal, index);
        // Each surface is off by less than half of plain(index) in the square of the sine. The
        // second multiplies the sine by its eta, and the first's error with it, and 1 / index is
        // rounded. The error of the square, divided by twice the sine and by the cosine, is that of
        // the angle.
        const double cosine = -dot(exact(incoming), exact(normal)).high;
        const double off_in_epsilons = in_epsilon(length(exact(computed) - exact(incoming)));
        const double at_most = plain(index) / (aside * cosine);
        if (!(off_in_epsilons <= at_most)) {
            UNSCOPED_INFO("index " << text(index) << ", normal " << text(normal));
            UNSCOPED_HINT(incoming, computed,
                          "eta is 1 / index on the way into the slab, and index on the way out");
        }
        REQUIRE(off_in_epsilons <= at_most);
    }
}

TEST_CASE("05.3 beyond the critical angle all light is reflected", "[05.3]") {
    for (const double eta : {1.1, 1.33, 1.5, 2.0, 2.5}) {
        const double critical = std::asin(1 / eta) * 180 / 3.14159265358979323846;
        INFO("eta = " << eta << ": the critical angle is " << critical << " degrees");
        CHECK(rt::refract(arriving_at_floor(critical - 0.1), floor_normal, real(eta)).has_value());
        CHECK(!rt::refract(arriving_at_floor(critical + 0.1), floor_normal, real(eta)).has_value());
        CHECK(!rt::refract(arriving_at_floor(89.9), floor_normal, real(eta)).has_value());
        INFO("light that arrives at a denser material is never totally reflected");
        CHECK(rt::refract(arriving_at_floor(89.9), floor_normal, real(1 / eta)).has_value());
    }
}

TEST_CASE("05.3 refraction and total reflection are told apart within 3 ulp of the critical angle",
          "[05.3][hard]") {
    for (const double ratio : {1.05, 1.1, 1.33, 1.5, 1.7, 2.0, 2.2, 2.4, 2.5}) {
        const Real eta = real(ratio);
        Real s = 1 / eta;
        for (int i = 0; i < 3; ++i) s = std::nextafter(s, Real(0));
        for (int ulps = -3; ulps <= 3; ++ulps, s = std::nextafter(s, Real(1))) {
            const Real c =
                static_cast<Real>(sqrt((Exact(1) - exact(s)) * (Exact(1) + exact(s))).high);
            for (const auto& [incoming, normal] :
                 {Arrival{{s, -c, 0}, {0, 1, 0}}, Arrival{{0, s, -c}, {0, 0, 1}},
                  Arrival{{c, 0, -s}, {-1, 0, 0}}}) {
                const auto refracted = rt::refract(incoming, normal, eta);
                // Both as stored, and for a direction of length exactly 1: 1 ulp from the critical
                // angle they agree. Where they do not, both answers are right.
                const Exact as_stored = exact(eta) * exact(s) - Exact(1);
                const Exact as_unit = exact(eta) * sine(incoming, normal) - Exact(1);
                INFO(
                    "eta = " << text(eta) << ", sine = " << text(s)
                             << ": eta * sine - 1 = " << as_stored.high
                             << "\nHint: take the sine as the length of normal x incoming, and the "
                                "sign of std::fma(eta, sine, -1): it rounds once");
                if (as_stored.high > 0 && as_unit.high > 0) REQUIRE(!refracted.has_value());
                if (as_stored.high < 0 && as_unit.high < 0) REQUIRE(refracted.has_value());
                if (!refracted) continue;
                REQUIRE(rt::is_finite(*refracted));
                REQUIRE(in_epsilon(length(exact(*refracted)) - Exact(1)) <= 6);
                REQUIRE(dot(exact(*refracted), exact(normal)).high <= 0);
            }
        }
    }
}

TEST_CASE("05.3 a large ratio of indices does not blur the critical angle", "[05.3][hard]") {
    // Near the critical angle light arrives almost head on here. d + c n cancels, and eta magnifies
    // what was rounded; the cross product does not care.
    rt::Rng rng{53, 5};
    for (const double ratio : {10.0, 40.0, 160.0}) {
        const Real eta = real(ratio);
        const Exact s = Exact(1) / exact(eta), c = sqrt((Exact(1) - s) * (Exact(1) + s));
        for (int i = 0; i < 1000; ++i) {
            const Vec3 normal = random_unit(rng);
            const ExactVec3 along = unit(cross(exact(normal), exact(random_unit(rng))));
            const Vec3 incoming = rounded(s * along - c * exact(normal));
            // Both as stored, and for directions of length exactly 1. Cross product and length
            // round by less than 4 epsilon together; within them both answers are right.
            const Exact as_stored =
                exact(eta) * length(cross(exact(incoming), exact(normal))) - Exact(1);
            const Exact as_unit = exact(eta) * sine(incoming, normal) - Exact(1);
            const double excess = in_epsilon(as_stored);
            if (excess < 4) continue;
            const auto refracted = rt::refract(incoming, normal, eta);
            INFO("eta = " << text(eta) << ", incoming " << text(incoming) << ", normal "
                          << text(normal) << ": eta * sine - 1 = " << as_stored.high);
            if (as_stored.high > 0 && as_unit.high > 0) {
                INFO(
                    "Hint: within rounding_bound(8) * (1 + eta) of 0, on either side, 1 - a . a is "
                    "too close to call: the rounding error grows with eta");
                REQUIRE(!refracted.has_value());
            }
            if (as_stored.high < 0 && as_unit.high < 0) {
                INFO(
                    "Hint: light goes through. If 1 - a . a is too close to call, replace it by "
                    "the value from the cross product, whatever its sign; the rounding error "
                    "grows with eta");
                REQUIRE(refracted.has_value());
            }
            if (!refracted || excess < 16) continue;
            const Exact cosine = -dot(exact(*refracted), exact(normal));
            const Exact expected = -as_stored * (Exact(2) + as_stored);
            INFO("Hint: with e = eta * sine - 1, the square of the cosine is -e (1 + eta * sine)");
            INFO("the square of the refraction angle's cosine: " EXPECTED
                 << expected.high << ", " ACTUAL << (cosine * cosine).high);
            // 4 of 16 epsilon
            const double off_in_sixteenths =
                std::abs((cosine * cosine - expected).high) * 16 / expected.high;
            REQUIRE(off_in_sixteenths <= 4);
        }
    }
}

TEST_CASE("05.3 equal indices leave the direction unchanged bit for bit", "[05.3][hard]") {
    rt::Rng rng{53, 4};
    for (int i = 0; i < 1000; ++i) {
        const auto [incoming, normal] = random_arrival(rng);
        const Vec3 computed = refract_or_fail(incoming, normal, 1);
        HINT(incoming, computed, "with eta = 1 there is no surface: return `incoming` as it is");
        if (!(computed == incoming)) REQUIRE(text(computed) == text(incoming));
    }
    const Vec3 grazing = refract_or_fail({1, 0, 0}, floor_normal, 1);
    if (!(grazing == Vec3{1, 0, 0})) REQUIRE(text(grazing) == "(1, 0, 0)");
}

TEST_CASE("05.3 even the smallest angles are refracted accurately", "[05.3][hard]") {
    for (const double ratio : {0.4, 1 / 1.5, 1.5, 2.5}) {
        const Real eta = real(ratio);
        for (Real s = real(0.3); s > std::numeric_limits<Real>::min() / rt::epsilon; s /= 7) {
            const Vec3 incoming = rounded(unit(exact(Vec3{s, -1, 0})));
            const Vec3 computed = refract_or_fail(incoming, floor_normal, eta);
            const Exact expected = exact(eta) * exact(incoming.x);
            INFO("eta = " << text(eta) << ": along the surface");
            HINT(expected, computed.x,
                 "1 - cosine^2 loses the sine of a small angle; a cross product keeps it");
            REQUIRE(error_in_ulp(computed.x, expected) <= 4);
        }
    }
}

TEST_CASE("05.3 grazing light is refracted to the critical angle", "[05.3][hard]") {
    for (const double ratio : {0.4, 0.5, 1 / 1.5, 0.9}) {
        const Real eta = real(ratio);
        for (const Real height : {Real(0), std::numeric_limits<Real>::min(), rt::epsilon}) {
            const Vec3 computed = refract_or_fail({1, -height, 0}, floor_normal, eta);
            HINT(eta, computed.x,
                 "at a right angle to the normal, the sine is 1, and the sine of the refraction "
                 "angle is eta");
            CHECK(error_in_ulp(computed.x, exact(eta)) <= 4);
            CHECK(computed.y < 0);
        }
    }
}
