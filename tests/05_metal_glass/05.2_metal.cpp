#include <rt/ending.hpp>
#include <rt/lambertian.hpp>
#include <rt/metal.hpp>
#include <rt/path.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>

#include "exact_vectors.hpp"
#include "hemisphere.hpp"
#include "statistics.hpp"

using namespace checkpoint;

namespace {

constexpr double fuzz_values[]{0, 0.1, 0.3, 0.5, 1};

// The seeds are fixed. With other seeds, one comparison in 370 would stray by more than 3 standard
// errors, one in 16000 by more than 4.

// What rounding may do to an average of numbers up to 1 that have a few roundings each.
const double rounding = static_cast<double>(rt::rounding_bound(16));

// A surface and light that arrives at it from the normal's side, now and then all but along it.
Arrival any_arrival(rt::Rng& rng) {
    Arrival arrival = random_arrival(rng);
    if (rng() % 4 == 0) {
        const ExactVec3 n = exact(arrival.normal);
        const ExactVec3 along = unit(cross(n, exact(random_unit(rng))));
        arrival.incoming = rounded(unit(along - exact(any_size(rng, -12, -1)) * n));
    }
    return arrival;
}

// v, folded above the surface, exactly, and with length 1.
ExactVec3 folded(const ExactVec3& v, const ExactVec3& n) {
    const Exact height = dot(v, n);
    return unit(height.high < 0 ? v - (Exact(2) * height) * n : v);
}

// How far a folded direction may be off, in epsilon: by the rounding of v, and by the lift where
// the height may be nothing but rounding.
double allowed_in_epsilons(const ExactVec3& v, const ExactVec3& n, double in_v) {
    const double size = length(v).high, height = std::abs(dot(v, n).high) / size;
    return in_v + (height < 64 * static_cast<double>(rt::epsilon) ? 40 : 0);
}

double off_in_epsilons(Vec3 computed, const ExactVec3& correct) {
    return in_epsilon(length(exact(computed) - correct));
}

// Remembers what it has drawn.
struct Recorded {
    rt::Rng rng{52, 8};
    std::vector<Real> drawn;
    Real uniform() {
        drawn.push_back(rng.uniform());
        return drawn.back();
    }
};

// Uniform directions that are as good as uniform_direction(place): with the two numbers swapped,
// the axes in another order, or any of them reversed.
struct UniformDirection {
    int kind;  // 0 is the plain one
    static constexpr int kinds = 96;

    Vec3 operator()(rt::Vec2 place) const {
        if (kind / 48) std::swap(place.x, place.y);
        const Vec3 d = rt::uniform_direction(place);
        const int axes = kind / 8 % 6, signs = kind % 8;
        Vec3 turned = axes % 3 == 0 ? d : axes % 3 == 1 ? Vec3{d.y, d.z, d.x} : Vec3{d.z, d.x, d.y};
        if (axes / 3) std::swap(turned.x, turned.y);
        if (signs & 1) turned.x = -turned.x;
        if (signs & 2) turned.y = -turned.y;
        if (signs & 4) turned.z = -turned.z;
        return turned;
    }
};

rt::Hit floor_hit() {
    rt::Hit hit;
    hit.normal = floor_normal;
    return hit;
}

}  // namespace

TEST_CASE("05.2 uniform directions cover the sphere evenly", "[05.2]") {
    rt::Rng rng{52, 21};
    Grid grid{{0, 0, 1}};
    double worst = 0;
    for (int i = 0; i < samples; ++i) {
        const Vec3 d = rt::uniform_direction(rt::random_place(rng));
        worst = std::max(worst, length_error(d) / static_cast<double>(rt::epsilon));
        // Slices of equal height have equal area.
        grid.add(d, [](double cosine) { return (1 - cosine) / 2 * rings; });
    }
    {
        INFO("lengths differ from 1 by up to " << worst << " epsilon, " EXPECTED "at most 100");
        CHECK(worst <= 100);
    }
    const double statistic = chi_square(
        grid.counts,
        std::vector<double>(turns * rings, static_cast<double>(samples) / turns / rings));
    INFO("chi-square of 200 cells of equal area: "
         << statistic
         << ".\nHint: z is spread evenly from -1 to 1, the angle about the z axis from 0 to 2 pi; "
            "if the angle from the pole is spread evenly, directions crowd at the poles");
    CHECK(statistic < chi_square_limit(turns * rings - 1));
}

TEST_CASE("05.2 equal parts of the square become equally large parts of the sphere", "[05.2]") {
    rt::Rng rng{52, 23};
    for (int i = 0; i < 2000; ++i)
        check_area_ratio(
            rt::uniform_direction, [](Vec2) { return 4 * 3.14159265358979323846; },
            any_spot(rng, i),
            "uniform_direction turns once around, by 2 pi y, neither more nor less, and z goes "
            "evenly from one pole to the other: the whole square becomes the whole sphere, whose "
            "area is 4 pi");
}

TEST_CASE("05.2 above_horizon mirrors a direction that points below the surface", "[05.2]") {
    const auto check = [](Vec3 v, Vec3 expected) {
        const Vec3 computed = rt::above_horizon(v, floor_normal);
        INFO("above_horizon(" << text(v) << ", (0, 1, 0))");
        HINT(
            expected, computed,
            dot(v, floor_normal) < 0
                ? "the height, v . normal, is below 0: reverse the height alone, and keep the part "
                  "along the surface; then normalize"
                : "the height, v . normal, is not below 0: nothing changes, except that the result "
                  "is normalized");
        CHECK(off_in_epsilons(computed, exact(expected)) <= 8);
    };
    check({3, 4, 0}, {real(0.6), real(0.8), 0});
    check({3, -4, 0}, {real(0.6), real(0.8), 0});
    check({0, -8, 0}, {0, 1, 0});
    check({0, real(-0.3), real(-0.4)}, {0, real(0.6), real(-0.8)});
    for (const Real scale : {real(1e-9), real(1e9)}) {
        check({0, 3 * scale, 4 * scale}, {0, real(0.6), real(0.8)});
        check({3 * scale, -4 * scale, 0}, {real(0.6), real(0.8), 0});
    }
}

TEST_CASE("05.2 metal without fuzz is a mirror", "[05.2]") {
    rt::Rng rng{52, 1};
    for (int i = 0; i < 1000; ++i) {
        const auto [incoming, normal] = random_arrival(rng);
        const Vec3 mirrored = rt::reflect(incoming, normal);
        const Vec3 computed = rt::metal_direction(incoming, normal, 0, rt::random_place(rng));
        const double off = off_in_epsilons(computed, exact(mirrored));
        if (!(off <= 32)) {
            UNSCOPED_INFO("metal_direction(" << text(incoming) << ", " << text(normal)
                                             << ", fuzz 0)");
            UNSCOPED_HINT(mirrored, computed,
                          "with fuzz 0 nothing is added to the mirror direction, which is "
                          "reflect(incoming, normal)");
        }
        REQUIRE(off <= 32);
    }
}

TEST_CASE("05.2 fuzz is added to the mirror direction and the sum is folded", "[05.2]") {
    rt::Rng rng{52, 9};
    std::vector<int> kinds(UniformDirection::kinds);  // those that explain all directions so far
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = static_cast<int>(i);
    for (int i = 0; i < 2000; ++i) {
        const Arrival arrival = any_arrival(rng);
        const Vec3 incoming = arrival.incoming, normal = arrival.normal;
        const Real fuzz = i % 4 == 0 ? 1 : i % 4 == 1 ? any_size(rng, -9, 0) : rng.uniform();
        const rt::Vec2 place = rt::random_place(rng);
        const Vec3 computed = rt::metal_direction(incoming, normal, fuzz, place);
        const ExactVec3 d = exact(incoming), n = exact(normal);
        const ExactVec3 mirror = d - (Exact(2) * dot(d, n)) * n;
        const auto is_off = [&](int kind) {
            const ExactVec3 v = mirror + exact(fuzz) * exact(UniformDirection{kind}(place));
            const double allowed = allowed_in_epsilons(v, n, 24 / length(v).high);
            return !(off_in_epsilons(computed, folded(v, n)) <= allowed);
        };
        std::vector<int> left;
        for (const int kind : kinds)
            if (!is_off(kind)) left.push_back(kind);
        if (left.empty()) {
            const ExactVec3 v = mirror + exact(fuzz) * exact(rt::uniform_direction(place));
            INFO("metal_direction(" << text(incoming) << ", " << text(normal) << ", fuzz "
                                    << text(fuzz) << ", place (" << text(place.x) << ", "
                                    << text(place.y) << "))");
            HINT(folded(v, n), computed,
                 "return above_horizon(mirror + fuzz * s, normal) with the mirror direction from "
                 "reflect and s from uniform_direction(place): fold the sum, not s alone");
            REQUIRE(text(computed) == text(rounded(folded(v, n))));
        }
        kinds = left;
    }
    CHECK(!kinds.empty());
}

TEST_CASE("05.2 scatter takes each parameter from the material and the hit", "[05.2]") {
    {
        INFO("Hint: leave Metal as it was given: a metal for which no fuzz is given is a mirror");
        CHECK(text(rt::Metal{}.fuzz) == "0");
    }
    rt::Rng rng{52, 10};
    Recorded random;
    for (int i = 0; i < 500; ++i) {
        const Arrival arrival = any_arrival(rng);
        const Vec3 incoming = arrival.incoming, normal = arrival.normal;
        // Often 0 or 1: no number of a material is a case of its own.
        const auto share = [&] { return rng() % 3 ? rng.uniform() : static_cast<Real>(rng() % 2); };
        const rt::Metal metal{{share(), share(), share()},
                              i % 4 == 3 ? any_size(rng, -9, -1) : share()};
        rt::Hit hit;
        hit.front = i % 2;
        hit.normal = hit.front ? normal : -normal;
        random.drawn.clear();
        const auto bounce = scatter(metal, incoming, hit, random);
        INFO("fuzz " << text(metal.fuzz) << ", hit from " << (hit.front ? "outside" : "inside"));
        {
            INFO("Hint: metal always returns a Scatter, whatever its fuzz and color");
            REQUIRE(bounce.has_value());
        }
        {
            INFO("attenuation " << bounce->attenuation << ", albedo " << metal.albedo
                                << "\nHint: the attenuation is the albedo, also for a mirror");
            REQUIRE(text(bounce->attenuation.r) == text(metal.albedo.r));
            REQUIRE(text(bounce->attenuation.g) == text(metal.albedo.g));
            REQUIRE(text(bounce->attenuation.b) == text(metal.albedo.b));
        }
        {
            INFO(
                "the values are the number of random numbers that were drawn.\nHint: a place in "
                "the unit square takes two: random_place(random)");
            // A mirror needs none.
            if (!(metal.fuzz == 0 && random.drawn.empty())) REQUIRE(random.drawn.size() == 2);
        }
        random.drawn.resize(2);
        const Real a = random.drawn[0], b = random.drawn[1];
        const auto direction = [&](rt::Vec2 place) {
            return rt::metal_direction(incoming, normal, metal.fuzz, place);
        };
        // A mirror may do without the lift.
        const double allowed = metal.fuzz == 0 ? 48 : 8;
        if (off_in_epsilons(bounce->direction, exact(direction({a, b}))) <= allowed) continue;
        if (off_in_epsilons(bounce->direction, exact(direction({b, a}))) <= allowed) continue;
        HINT(direction({a, b}), bounce->direction,
             "call metal_direction with the incoming direction, facing_normal(hit), the material's "
             "fuzz and the random place");
        REQUIRE(text(bounce->direction) == text(direction({a, b})));
    }
}

TEST_CASE("05.2 fuzz spreads the light by the right amount", "[05.2]") {
    // Head on nothing points below. For a direction m + f s, m and s of length 1 and s uniform, the
    // cosine with m is 1 - f^2 / 3 on average, and the rest cancels.
    for (const double fuzz : fuzz_values) {
        rt::Rng rng{52, 2};
        Mean x, y, z;
        for (int i = 0; i < 5000; ++i) {
            const Vec3 d =
                rt::metal_direction({0, -1, 0}, floor_normal, real(fuzz), rt::random_place(rng));
            x.add(static_cast<double>(d.x));
            y.add(static_cast<double>(d.y));
            z.add(static_cast<double>(d.z));
        }
        INFO("fuzz " << fuzz << ", light from straight above: the average direction is ("
                     << x.mean() << ", " << y.mean() << ", " << z.mean() << "), " EXPECTED "(0, "
                     << 1 - fuzz * fuzz / 3
                     << ", 0)\nHint: above_horizon(mirror + fuzz * s, normal), s from "
                     << "uniform_direction(place): the sum is folded, not s alone");
        CHECK(std::abs(y.mean() - (1 - fuzz * fuzz / 3)) <= 4 * y.standard_error() + rounding);
        CHECK(std::abs(x.mean()) <= 4 * x.standard_error() + rounding);
        CHECK(std::abs(z.mean()) <= 4 * z.standard_error() + rounding);
    }
}

TEST_CASE("05.2 folding leaves the part along the surface unchanged", "[05.2]") {
    // It reverses the height and nothing else. So along the surface the average is the one without
    // a surface: the mirror direction's part, times 1 - f^2 / 3.
    for (const double angle : {60.0, 89.9})
        for (const double fuzz : fuzz_values) {
            rt::Rng rng{52, 3};
            const Vec3 incoming = arriving_at_floor(angle);
            Mean x;
            for (int i = 0; i < 5000; ++i)
                x.add(static_cast<double>(
                    rt::metal_direction(incoming, floor_normal, real(fuzz), rt::random_place(rng))
                        .x));
            const double expected = static_cast<double>(incoming.x) * (1 - fuzz * fuzz / 3);
            INFO("fuzz "
                 << fuzz << " at " << angle << " degrees: the average part along the surface "
                 << "is " << x.mean() << ", " EXPECTED << expected
                 << "\nHint: mirror a direction that points below at the surface; do not drop it, "
                    "flatten it or draw it again");
            CHECK(std::abs(x.mean() - expected) <= 4 * x.standard_error() + rounding);
        }
}

TEST_CASE("05.2 white metal in a white furnace stays white", "[05.2]") {
    for (const double angle : {0.0, 60.0, 89.9})
        for (const double fuzz : fuzz_values) {
            rt::Rng rng{52, 4};
            const rt::Metal white{{1, 1, 1}, real(fuzz)};
            Mean light;
            for (int i = 0; i < 5000; ++i) {
                const auto bounce = scatter(white, arriving_at_floor(angle), floor_hit(), rng);
                const bool is_out = bounce && bounce->direction.y >= 0;
                light.add(is_out ? static_cast<double>(bounce->attenuation.g) : 0);
            }
            INFO("fuzz "
                 << fuzz << " at " << angle
                 << " degrees: " EXPECTED "1, because all light comes back, " ACTUAL << light.mean()
                 << ", with a standard error of " << light.standard_error()
                 << "\nHint: light whose direction points below the surface must not be lost");
            CHECK(std::abs(light.mean() - 1) <= 3 * light.standard_error() + rounding);
        }
}

TEST_CASE("05.2 metal attenuates light by its albedo", "[05.2]") {
    rt::Rng rng{52, 5};
    const rt::Color albedo{real(0.9), real(0.6), real(0.3)};
    for (const double angle : {0.0, 45.0, 89.0}) {
        const auto bounce =
            scatter(rt::Metal{albedo, real(0.3)}, arriving_at_floor(angle), floor_hit(), rng);
        REQUIRE(bounce.has_value());
        INFO("attenuation " << bounce->attenuation << ", albedo " << albedo);
        CHECK(text(bounce->attenuation.r) == text(albedo.r));
        CHECK(text(bounce->attenuation.g) == text(albedo.g));
        CHECK(text(bounce->attenuation.b) == text(albedo.b));
    }
    // Inside a ball, say, light must stay inside.
    rt::Hit inside = floor_hit();
    inside.front = false;
    const auto bounce = scatter(rt::Metal{albedo, 1}, {0, 1, 0}, inside, rng);
    INFO("Hint: metal that is hit from behind reflects to that side: use facing_normal(hit)");
    CHECK(bounce->direction.y < 0);
}

TEST_CASE("05.2 no direction points below the surface even after rounding", "[05.2][hard]") {
    rt::Rng rng{52, 6};
    for (int i = 0; i < 10000; ++i) {
        const Vec3 normal = random_unit(rng);
        // Along the surface, but for rounding and a height that shrinks from 1 to nothing.
        const ExactVec3 along = unit(cross(exact(normal), exact(random_unit(rng))));
        const int digits = std::numeric_limits<Real>::digits;
        const Real height = std::scalbn(rng.uniform(-1, 1), i % 2 ? -(i % 70) : 1 - digits);
        // Any length: a height is small only relative to v.
        const int far = for_this_precision(40, 300);
        const int power =
            i % 4 ? 0 : static_cast<int>(rng() % static_cast<unsigned>(2 * far)) - far;
        const Vec3 v = std::scalbn(Real(1), power) * rounded(along + exact(height) * exact(normal));
        const Vec3 computed = rt::above_horizon(v, normal);
        const ExactVec3 n = exact(normal), correct = folded(exact(v), n);
        const double off = off_in_epsilons(computed, correct);
        const double allowed = allowed_in_epsilons(exact(v), n, 16);
        const double longer = in_epsilon(length(exact(computed)) - Exact(1));
        const Real cosine = rt::dot(computed, normal);
        const bool is_right = cosine > 0 && longer <= 2 && off <= allowed;
        if (!is_right) {
            INFO("above_horizon(" << text(v) << ", " << text(normal) << ") = " << text(computed));
            {
                INFO("the computed dot product with the normal is "
                     << text(cosine)
                     << "\nHint: a height that is smaller than its own rounding error may have "
                        "either sign; lift it above that error, to least = rounding_bound(16) * "
                        "length(v): v + (max(|h|, least) - h) n");
                REQUIRE(cosine > 0);
            }
            {
                INFO("the result must have length 1. The values are the difference, in epsilon");
                REQUIRE(longer <= 2);
            }
            HINT(correct, computed,
                 "reverse v . normal if it is below 0, and lift it no more than rounding makes "
                 "necessary: to rounding_bound(16) * length(v). The values are the difference, in "
                 "epsilon");
            REQUIRE(off <= allowed);
        }
        REQUIRE(is_right);
    }
}

TEST_CASE("05.2 light along the surface is reflected above it for any fuzz", "[05.2][hard]") {
    rt::Rng rng{52, 13};
    for (int i = 0; i < 6000; ++i) {
        const Vec3 normal = random_unit(rng);
        const ExactVec3 n = exact(normal), along = unit(cross(n, exact(random_unit(rng))));
        const Real height = std::scalbn(rng.uniform(), -(i % 70));
        const Vec3 incoming = rounded(unit(along - exact(height) * n));
        const Real fuzz = i % 3 == 0 ? 0 : i % 3 == 1 ? any_size(rng, -18, -6) : rng.uniform();
        rt::Hit hit;
        hit.front = rng() % 2;
        hit.normal = hit.front ? normal : -normal;
        const auto bounce = scatter(rt::Metal{{1, 1, 1}, fuzz}, incoming, hit, rng);
        for (const Vec3 d : {rt::metal_direction(incoming, normal, fuzz, rt::random_place(rng)),
                             bounce ? bounce->direction : Vec3{}}) {
            const double longer = in_epsilon(length(exact(d)) - Exact(1));
            const bool is_right = rt::dot(d, normal) > 0 && longer <= 2;
            INFO(
                "metal of fuzz " << text(fuzz) << ", light along " << text(incoming)
                                 << " on the side of the normal " << text(normal)
                                 << " leaves along " << text(d) << ", whose dot product with the "
                                 << "normal is " << text(rt::dot(d, normal))
                                 << ", and whose length is off by " << longer
                                 << " epsilon\nHint: above_horizon lifts and normalizes any "
                                    "direction: also call it for the mirror direction with fuzz 0");
            REQUIRE(is_right);
        }
    }
}

TEST_CASE(
    "05.2 uniform directions have length 1 within 2 epsilon even at the corners of the square",
    "[05.2][hard]") {
    const auto check = [](Vec2 place) {
        const Vec3 d = rt::uniform_direction(place);
        INFO("place (" << text(place.x) << ", " << text(place.y) << ") gives " << text(d));
        REQUIRE(rt::is_finite(d));
        const double off_in_epsilons = length_error(d) / static_cast<double>(rt::epsilon);
        INFO("the direction's length differs from 1 by this many epsilon; 2 are allowed");
        REQUIRE(off_in_epsilons <= 2);
    };
    for (const Vec2 place : corners) check(place);
    for (const Vec2 place : edges) check(place);
    // Close to a pole, whichever axis that is on, and whichever number of the place leads there.
    rt::Rng rng{52, 22};
    for (int i = 0; i < 2000; ++i) {
        // A multiple of epsilon, as random numbers are; and numbers of any size, as where the
        // square is cut into strips.
        const Real step =
            std::max(Real(1), std::round(any_size(rng, 0, for_this_precision(5, 14))));
        const Real x = i % 8 >= 4 ? any_size(rng, -25, -4)
                       : i % 2    ? step * rt::epsilon
                                  : 1 - step * rt::epsilon;
        const Real y = rng.uniform(real(0.1), real(0.4));
        const Vec2 place = i / 2 % 2 ? Vec2{x, y} : Vec2{y, x};
        const Vec3 d = rt::uniform_direction(place), a = rt::abs(d);
        const Real height = std::max({a.x, a.y, a.z});
        if (height < real(0.999)) continue;
        const auto from_axis = static_cast<double>(height == a.x   ? std::hypot(a.y, a.z)
                                                   : height == a.y ? std::hypot(a.x, a.z)
                                                                   : std::hypot(a.x, a.y));
        // Or twice that close to the rim of a disk, if the map goes through one.
        const double expected = static_cast<double>(2 * std::sqrt(x * (1 - x)));
        const double at_rim = 2 * expected * static_cast<double>(1 - 2 * std::min(x, 1 - x));
        const double off_in_epsilons =
            std::min(std::abs(from_axis / expected - 1), std::abs(from_axis / at_rim - 1)) /
            static_cast<double>(rt::epsilon);
        if (off_in_epsilons <= 8) continue;
        INFO("place (" << text(place.x) << ", " << text(place.y) << ") gives " << text(d));
        HINT(static_cast<Real>(expected), static_cast<Real>(from_axis),
             "the values are the direction's distance from the axis. Near the poles, 1 - z^2 "
             "cancels, and 1 - z lacks the digits that the rounding of z has lost; 4 x (1 - x) has "
             "all digits");
        REQUIRE(off_in_epsilons <= 8);
    }
}

TEST_CASE("05.2 above_horizon lifts vectors along an axis for any length and normal",
          "[05.2][hard]") {
    // Two components are 0 here, and the third must be enough to tell how far to lift.
    rt::Rng rng{52, 12};
    for (int i = 0; i < 600; ++i) {
        const auto turn = [i](Vec3 v) {
            return i % 3 == 0 ? v : i % 3 == 1 ? Vec3{v.z, v.x, v.y} : Vec3{v.y, v.z, v.x};
        };
        const Real angle = i % 4 == 0 ? 0 : rng.uniform(0, 2 * rt::pi);
        const Vec3 normal = turn({0, std::cos(angle), std::sin(angle)});
        const Real size = std::scalbn(Real(1), static_cast<int>(rng() % 60) - 30);
        const Vec3 v = turn({i & 8 ? size : -size, 0, 0});
        const Vec3 computed = rt::above_horizon(v, normal);
        const Real cosine = rt::dot(computed, normal);
        if (!(cosine > 0))
            UNSCOPED_INFO("above_horizon("
                          << text(v) << ", " << text(normal) << ") = " << text(computed)
                          << ", its dot product with the normal is " << text(cosine)
                          << "\nHint: least is rounding_bound(16) times the length of v, or |vx| + "
                             "|vy| + |vz|: use all three components");
        REQUIRE(cosine > 0);
        const ExactVec3 expected = unit(exact(v));
        HINT(expected, computed, "only the zero vector gives the normal: compare all of v with 0");
        REQUIRE(off_in_epsilons(computed, expected) <= 64);
    }
}

TEST_CASE("05.2 a height of 0 is lifted to the bound for the vector's length", "[05.2][hard]") {
    for (const Vec3 v : {Vec3{3, 4, 0}, Vec3{-1, 1, 0}, Vec3{5, 0, 0}}) {
        const Vec3 n{0, 0, 1};
        const Real cosine = rt::dot(rt::above_horizon(v, n), n), least = rt::rounding_bound(16);
        INFO("above_horizon(" << text(v) << ", (0, 0, 1)) has the cosine " << text(cosine));
        CHECK(cosine >= least * Real(0.999));
        CHECK(cosine <= 2 * least);
    }
}

TEST_CASE("05.2 the normal is returned where fuzz cancels the mirror direction", "[05.2][hard]") {
    // In the reference, the place (0, 0) becomes the uniform direction +z; in other code another
    // place may. A zero vector must not reach normalize, and tiny ones must keep length 1.
    {
        INFO("above_horizon((0, 0, 0), (0, 1, 0)): " EXPECTED
             "the normal\nHint: the zero vector has no direction that normalize could keep; check "
             "v == Vec3{} first, and return the normal");
        for (const Real zero : {Real(0), -Real(0)}) {
            const Vec3 computed = rt::above_horizon({zero, 0, zero}, floor_normal);
            if (!(computed == floor_normal)) CHECK(text(computed) == "(0, 1, 0)");
            rt::Rng rng{52, 11};
            const Vec3 normal = random_unit(rng);
            if (!(rt::above_horizon({zero, zero, 0}, normal) == normal))
                CHECK(text(rt::above_horizon({zero, zero, 0}, normal)) == text(normal));
        }
    }
    for (const Vec3 mirror : {Vec3{0, 0, -1}, Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}})
        for (const Real x : {Real(0), real(0.25), real(0.5), 1 - rt::epsilon / 2})
            for (const Real y : {Real(0), real(0.25), real(0.5), real(0.75)}) {
                const Vec3 d = rt::metal_direction(-mirror, mirror, 1, {x, y});
                INFO("mirror direction " << text(mirror) << ", place (" << x << ", " << y
                                         << "): " << text(d));
                CHECK(in_epsilon(length(exact(d)) - Exact(1)) <= 2);
            }
}

TEST_CASE("05.2 a white metal ball stays white at every scale", "[05.2][hard]") {
    for (const double scale : {1e-9, 1.0, 1e9})
        for (const double fuzz : fuzz_values) {
            const Real s = real(scale);
            const rt::SphereList world{{{{s * Vec3{2, -1, 3}, s}, 0}}};
            const rt::MaterialList<rt::Metal> white{{{{1, 1, 1}, real(fuzz)}}};
            rt::Rng rng{52, 7};
            for (int i = 0; i < 500; ++i) {
                // From the ball's center to its rim. Light leaves a convex ball after one bounce.
                const Real aside = std::sqrt(rng.uniform());
                const rt::Ray ray{s * (Vec3{2, -1, 3} + Vec3{aside, 0, 9}), {0, 0, -1}};
                const rt::Color light = rt::path_radiance(ray, world, white, rt::UniformSky{},
                                                          rt::BlackEnding{}, 2, rng);
                if (!(light == rt::Color{1, 1, 1})) {
                    INFO("ball of radius " << scale << ", fuzz " << fuzz << ", hit at " << aside
                                           << " of its radius: " << light
                                           << "\nHint: some paths may never leave the ball");
                    REQUIRE(text(light.g) == "1");
                }
                REQUIRE(light == rt::Color{1, 1, 1});
            }
        }
}
