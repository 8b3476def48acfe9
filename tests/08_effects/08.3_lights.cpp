#include <checkpoint.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/rng.hpp>
#include <rt/sphere_light.hpp>
#include <statistics.hpp>

#include "places.hpp"

using namespace checkpoint;
using rt::LightSample;
using rt::Sphere;
using rt::Vec2;

namespace {

Exact exact(Real x) {
    return static_cast<double>(x);
}

Exact exact_height(Real radius, Real distance) {
    const Exact r = exact(radius), d = exact(distance);
    const Exact sine = r / d, cosine = sqrt((d - r) * (d + r)) / d;
    return sine * sine / (Exact(1) + cosine);
}

// The message before it says what was computed and expected: Catch2 shows few digits.
void check_near(Real computed, Real expected, Real allowed) {
    const bool is_near = std::abs(computed - expected) <= allowed;
    CHECK(is_near);
}

// The formula rounds 7 times at most, so it is right within 7 units. A scale that is a power of
// two rounds nothing.
void check_height(Real radius, Real distance, Real scale = 1) {
    const Exact expected = exact_height(radius, distance);
    const Real height = rt::cone_height(scale * radius, scale * distance);
    INFO("cone_height for the radius " << text(scale * radius) << " and the distance "
                                       << text(scale * distance));
    HINT(expected, height,
         scale == 1
             ? "1 - cos a loses its digits where the light is small or far, and 1 - sin^2 a "
               "where it is close: use 1 - cos a = sin^2 a / (1 + cos a), and (d - r) (d + r)"
             : "at this size d^2 and (d - r) (d + r) overflow or underflow: divide each "
               "factor by d first");
    CHECK(error_in_ulp(height, expected) <= 7);
}

LightSample sampled(const Sphere& light, Vec3 from, Vec2 place) {
    const auto sample = rt::sample_light(light, from, place);
    INFO("a light of radius " << text(light.radius) << " around " << text(light.center)
                              << ", seen from " << text(from)
                              << ": " EXPECTED "a sample, " ACTUAL "none");
    REQUIRE(sample);
    return *sample;
}

// What most often goes wrong with a light of this size.
const char* hint_on_size(Real radius, Real distance) {
    const Real squared = distance * distance;
    if (squared == 0 || squared > std::numeric_limits<Real>::max())
        return ".\nHint: at this size (d - r) (d + r) overflows or underflows: first divide a "
               "factor by d, or by r if the point is inside";
    if (distance > 100 * radius)
        return ".\nHint: the sine of a small angle is sqrt(k (2 - k)); 1 - cos^2 has no digits "
               "left";
    return "";
}

// The sample's direction leads to the light, and the distance to its surface.
void check_sample(const Sphere& light, Vec3 from, Vec2 place) {
    const LightSample sample = sampled(light, from, place);
    const Vec3 apart = light.center - from;
    const Real distance = rt::length(apart), scale = distance + light.radius;
    INFO("a light of radius " << text(light.radius) << " around " << text(light.center)
                              << ", seen from " << text(from) << ", place " << text(place.x) << ", "
                              << text(place.y));
    INFO("direction " << text(sample.direction) << ", distance " << text(sample.distance));
    {
        const Real length = rt::length(sample.direction);
        INFO("the direction's length must be 1 within 5 epsilon: normalize it");
        if (!(std::abs(length - 1) <= rt::rounding_bound(10))) CHECK(text(length) == "1");
    }
    // At the rim, the point that the ray meets moves with the root of the rounding error. What has
    // to be right is the point's position along the normal.
    const Vec3 point = sample.distance * sample.direction - apart;
    {
        const Real away = rt::length(point);
        INFO("the distance from the sampled point to the light's center"
             << hint_on_size(light.radius, distance));
        if (!(std::abs(away - light.radius) / scale <= rt::rounding_bound(60)))
            CHECK(text(away) == text(light.radius));
    }
    {
        INFO("the light's surface must lie ahead, not behind: a distance is never negative");
        // On the surface itself, the distance to it may be 0.
        CHECK((distance == light.radius ? sample.distance >= 0 : sample.distance > 0));
    }
    // The near side: the one that is seen.
    if (distance > light.radius) {
        INFO("the sample must lie on the near side of the light");
        CHECK(rt::dot(point, sample.direction) / scale < rt::rounding_bound(60));
    }
    const Real density = rt::light_density(light, from);
    INFO("the sample's density must be that of light_density");
    if (!(std::abs(sample.density - density) <= rt::rounding_bound(20) * density))
        CHECK(text(sample.density) == text(density));
}

// Place {0, 0} is the light's center, and the way there is the distance less the radius. That
// difference is exact close to the light, and one rounding elsewhere; the formula in the text
// rounds about 15 times more, and nothing in it cancels.
void check_middle(const Sphere& light, Vec3 from) {
    const LightSample sample = sampled(light, from, {0, 0});
    const Vec3 apart = light.center - from;
    const Real distance = rt::length(apart), way = distance - light.radius;
    INFO("a light of radius " << text(light.radius) << " around " << text(light.center)
                              << ", seen from " << text(from) << ", place 0, 0");
    {
        INFO("place.x = 0 must lead to the light's center, in the direction "
             << text(apart / distance) << ", " ACTUAL << text(sample.direction)
             << ".\nHint: orthonormal_basis(w) with w = (center - from) / d, of length 1, turns "
                "(0, 0, 1) there; here k is 0, and so is the sine");
        if (!(max_component(sample.direction - apart / distance) <= rt::rounding_bound(30)))
            REQUIRE(text(sample.direction) == text(apart / distance));
    }
    HINT(
        exact(way), sample.distance,
        distance > 2 * light.radius
            ? "the distance to the nearest point of the light is d - r: of the two solutions, take "
              "the one with the minus"
            : "the distance to the nearest point of the light is d - r; close to the light, the "
              "difference of d cos and the root has no digits left: use the form with (d - r) (d + "
              "r) in the numerator");
    check_near(sample.distance, way, rt::rounding_bound(30) * way);
}

const Sphere usual{{2, 3, -1}, Real(0.7)};

// Directions to a light from outside: their angle to the middle, and the turn around it from where
// place.y = 0 is, to one side or the other.
void check_cone(const Sphere& light, Vec3 from, rt::Rng& rng) {
    const Vec3 apart = light.center - from;
    const Real distance = rt::length(apart);
    const Real height = static_cast<Real>(exact_height(light.radius, distance).high);
    const rt::Basis basis = rt::orthonormal_basis(apart / distance);
    const Real widest = std::sqrt(height * (2 - height)),
               rounding = rt::rounding_bound(80) / widest;
    INFO("a light of radius " << text(light.radius) << " around " << text(light.center)
                              << ", seen from " << text(from));
    {
        const Real expected = 1 / (2 * rt::pi * height);
        const Real density = rt::light_density(light, from);
        INFO(
            "light_density.\nHint: 1 / (2 pi h), where h is cone_height for the distance from "
            "`from` to the center");
        if (!(std::abs(density / expected - 1) <= rt::rounding_bound(80)))
            REQUIRE(text(density) == text(expected));
    }
    if (rounding > Real(0.01)) return;
    // How far a sample's direction is from the middle, in units of the widest.
    const auto beside = [&](Real x, Real y) {
        const Vec3 d = sampled(light, from, {x, y}).direction;
        return Vec2{rt::dot(d, basis.u) / widest, rt::dot(d, basis.v) / widest};
    };
    const auto turned_by = [&](Real x, Real turn, int side) {
        const Vec2 at = beside(x, 0);
        const Real angle = static_cast<Real>(side) * 2 * rt::pi * turn;
        const Real c = std::cos(angle), s = std::sin(angle);
        return Vec2{c * at.x - s * at.y, s * at.x + c * at.y};
    };
    const auto gap = [](Vec2 a, Vec2 b) {
        return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
    };
    const Vec2 probe = beside(Real(0.9), Real(0.125));
    const int side = gap(probe, turned_by(Real(0.9), Real(0.125), 1)) <
                             gap(probe, turned_by(Real(0.9), Real(0.125), -1))
                         ? 1
                         : -1;
    for (int i = 0; i < 8; ++i) {
        const Real last = 1 - rt::epsilon / 2;
        const Real x = i == 0 ? last : i % 3 == 1 ? any_size(rng, -9, 0) * last : rng.uniform();
        const Real y = i == 1 ? last : rng.uniform();
        const Vec2 at = beside(x, y), expected = turned_by(x, y, side);
        const Real k = x * height, sine = std::sqrt(k * (2 - k)) / widest;
        const Real away = std::sqrt(at.x * at.x + at.y * at.y);
        INFO("place " << text(x) << ", " << text(y));
        if (!(std::abs(away - sine) <= rounding)) {
            INFO(
                "the sine of the sample's angle from the light's center, divided by the sine of "
                "the rim's angle.\nHint: with k = "
                "place.x * h the cosine is 1 - k and the sine sqrt(k (2 - k))");
            REQUIRE(text(away) == text(sine));
        }
        if (!(gap(at, expected) <= 2 * rounding)) {
            const auto pair = [](Vec2 v) { return '(' + text(v.x) + ", " + text(v.y) + ')'; };
            INFO(
                "the direction's two components perpendicular to the way to the light's center "
                "(your code gives "
                << pair(beside(x, 0))
                << " for place.y = 0).\nHint: place.y is the fraction of a turn, and a full turn "
                   "is 2 pi");
            REQUIRE(pair(at) == pair(expected));
        }
        check_sample(light, from, {x, y});
    }
}

}  // namespace

TEST_CASE("08.3 cone_height returns the height of the cap that a light covers", "[08.3]") {
    // A light as far away as its diameter is seen at 30 degrees to each side.
    {
        HINT(Exact(1) - sqrt(Exact(3)) / Exact(2), rt::cone_height(1, 2),
             "the height is 1 - cos a, with sin a = radius / distance");
        check_near(rt::cone_height(1, 2), 1 - std::sqrt(Real(3)) / 2, 4 * rt::epsilon);
    }
    for (int i = 1; i < 60; ++i) check_height(static_cast<Real>(i) / 60, 1);
    check_height(3, 5);
}

TEST_CASE("08.3 the density is one over the solid angle", "[08.3]") {
    const Vec3 from{0, 0, 0};
    const Real distance = rt::length(usual.center);
    const Real expected =
        1 / (2 * rt::pi * static_cast<Real>(exact_height(Real(0.7), distance).high));
    const Real density = rt::light_density(usual, from);
    {
        INFO(EXPECTED
             << text(expected) << ", " ACTUAL << text(density)
             << ".\nHint: the solid angle of a cap is 2 pi times its height, and the density "
                "is 1 / (2 * pi * height), with the parentheses");
        check_near(density, expected, rt::rounding_bound(30) * expected);
    }
    const Real inside = rt::light_density(usual, usual.center + Vec3{Real(0.2), 0, Real(0.1)});
    INFO("for a point inside the light: " EXPECTED
         << text(1 / (4 * rt::pi)) << ", " ACTUAL << text(inside)
         << ".\nHint: from inside, the light is seen in every direction");
    check_near(inside, 1 / (4 * rt::pi), 4 * rt::epsilon);
    const Real on_surface = rt::light_density({{3, 0, -4}, 5}, {0, 0, 0});
    INFO("for a point on the surface, where the distance is the radius: " EXPECTED
         << text(1 / (4 * rt::pi)) << ", " ACTUAL << text(on_surface));
    check_near(on_surface, 1 / (4 * rt::pi), 4 * rt::epsilon);
}

TEST_CASE("08.3 each sample leads to the light", "[08.3]") {
    for (const Vec3 from : {Vec3{0, 0, 0}, Vec3{2, 3, 4}, Vec3{2, 0, -1}, Vec3{-50, 20, 9}}) {
        check_middle(usual, from);
        for_each_place(8, [&](Vec2 place) { check_sample(usual, from, place); });
    }
}

TEST_CASE("08.3 place.x determines the height in the cap and place.y the turn", "[08.3]") {
    for (const Vec3 from : {Vec3{0, 0, 0}, Vec3{2, 3, 0}, Vec3{2, Real(2.2), -1}}) {
        const Vec3 apart = usual.center - from;
        const Real distance = rt::length(apart);
        const Exact height = exact_height(usual.radius, distance);
        for (const Real x : {Real(0), Real(0.25), Real(0.5), Real(0.875)})
            for (const Real turn : {Real(0), Real(0.25), Real(0.625)}) {
                const Vec3 direction = sampled(usual, from, {x, turn}).direction;
                const Real cosine = rt::dot(direction, apart / distance);
                const Exact expected = Exact(1) - exact(x) * height;
                INFO("place " << text(x) << ", " << text(turn)
                              << ": the cosine of the angle to the light's center");
                HINT(expected, cosine,
                     "1 - place.x * h, whatever place.y is; the turn is 2 pi place.y");
                check_near(cosine, static_cast<Real>(expected.high), rt::rounding_bound(40));
                if (x == 0) continue;
                const auto beside = [&](Vec3 d) {
                    return rt::normalize(d - rt::dot(d, apart) / rt::dot(apart, apart) * apart);
                };
                const Vec3 start = sampled(usual, from, {x, 0}).direction;
                const Real turned = rt::dot(beside(direction), beside(start)),
                           wanted = std::cos(2 * rt::pi * turn);
                INFO("the cosine of the angle by which place.y turns the sample");
                HINT(wanted, turned, "place.y is the fraction of a turn, and a full turn is 2 pi");
                check_near(turned, wanted, real(1e-4));
            }
    }
}

TEST_CASE("08.3 samples are accurate for lights of all sizes and distances", "[08.3][hard]") {
    rt::Rng rng{83, 1};
    const Real smallest = for_this_precision(Real(-17), Real(-140));
    for (int i = 0; i < 4000; ++i) {
        const Real distance = any_size(rng, -15, 15);
        const Real share = any_size(rng, i % 2 ? Real(-2) : smallest, 0);
        const Real radius = i % 4 ? distance * share : distance * (1 - share);
        if (0 < radius && radius < distance) check_height(radius, distance);
    }
    for (int i = 0; i < 400; ++i) {
        const Real size = any_size(rng, -15, 15), distance = size * any_size(rng, -2, 2);
        const Vec3 center = size * any_direction(rng);
        const Real share = any_size(rng, i % 2 ? -1 : for_this_precision(-3, -9), 0);
        const Real radius = std::min(share, Real(0.99)) * distance;
        const Vec3 from = center + distance * any_direction(rng);
        // Where the position of one or the other is rounded, so is their distance.
        if (rt::length(from - center) > Real(1.001) * radius)
            check_cone({center, radius}, from, rng);
    }
}

TEST_CASE("08.3 samples are spread evenly over the solid angle of the light", "[08.3]") {
    // Seen from the origin, straight above: rings of equal height of the cap, and sixths of a turn.
    const Sphere light{{0, 5, 0}, 4};
    const double height = exact_height(4, 5).high;
    std::vector<long> observed(36);
    std::vector<double> expected(36, 60 * 60 / 36.0);
    for_each_place(60, [&](Vec2 place) {
        const Vec3 d = sampled(light, {0, 0, 0}, place).direction;
        const double ring = (1 - static_cast<double>(d.y)) / height;
        const double turn = std::atan2(static_cast<double>(d.x), static_cast<double>(d.z)) /
                                (2 * 3.14159265358979) +
                            0.5;
        const int i = std::clamp(static_cast<int>(6 * ring), 0, 5);
        const int j = std::clamp(static_cast<int>(6 * turn), 0, 5);
        ++observed[static_cast<std::size_t>(6 * i + j)];
    });
    const double statistic = chi_square(observed, expected);
    INFO("36 parts of equal solid angle should get 100 of 3600 sample points each; chi-square is "
         << statistic << "; " EXPECTED "less than " << chi_square_limit(35)
         << ".\nHint: the height of the cap, 1 - cos, is spread evenly, not the angle to the "
            "center; and the turn goes all the way around, 2 pi");
    CHECK(statistic < chi_square_limit(35));
}

TEST_CASE("08.3 a light that faces the surface gives the irradiance of the textbook formula",
          "[08.3]") {
    // E = pi L sin^2 a. Over sample points in the middle of equal strips, the mean of cos / density
    // is exact, because the cosine changes evenly with place.x.
    const Real radiance = 3;
    for (const Real distance : {Real(1.01), Real(2), Real(10), Real(1000)}) {
        const Sphere light{{0, distance, 0}, 1};
        Real sum = 0;
        for_each_place(16, [&](Vec2 place) {
            const LightSample sample = sampled(light, {0, 0, 0}, place);
            sum += radiance * sample.direction.y / sample.density;
        });
        const Real expected = rt::pi * radiance / distance / distance;
        INFO("a light of radius 1 and radiance 3 at distance " << text(distance));
        HINT(exact(expected), sum / 256,
             "each sample adds radiance * cosine / density; so 1 / density must be the solid "
             "angle, and the directions must be spread evenly over it");
        check_near(sum / 256, expected, rt::rounding_bound(400) * expected);
    }
}

TEST_CASE("08.3 samples and density are accurate for small and distant lights", "[08.3][hard]") {
    for (Real distance = 2; distance < for_this_precision(Real(1e15), Real(1e100)); distance *= 7)
        check_height(1, distance);
    // The sun in its true size, seen from its true distance.
    const Sphere sun{{0, Real(1.496e11), 0}, Real(6.957e8)};
    for_each_place(4, [&](Vec2 place) { check_sample(sun, {0, 0, 0}, place); });
    const Real expected = rt::pi * Real(6.957e8 / 1.496e11) * Real(6.957e8 / 1.496e11);
    const Real angle = 1 / rt::light_density(sun, {0, 0, 0});
    INFO("the sun's solid angle is about " << text(expected) << ", yours is " << text(angle));
    check_near(angle, expected, Real(1e-4) * expected);
}

TEST_CASE("08.3 samples are accurate from points just above the light's surface", "[08.3][hard]") {
    for (Real gap = Real(0.5); 1 + gap > 1; gap /= 3) check_height(1, 1 + gap);
    const Sphere light{{0, 0, 0}, 1};
    for (const Real gap : {Real(0.01), 64 * rt::epsilon}) {
        check_middle(light, {0, 1 + gap, 0});
        for_each_place(4, [&](Vec2 place) { check_sample(light, {0, 1 + gap, 0}, place); });
    }
}

TEST_CASE("08.3 at the rim of a light the distance is never NaN", "[08.3][hard]") {
    // The last sample point before the rim: h and k differ by one unit in the
    // last place, if at all.
    const Real last = 1 - rt::epsilon / 2;
    rt::Rng random{8, 31};
    for (int i = 0; i < 10'000; ++i) {
        const Real gap = std::exp2(-for_this_precision(Real(18), Real(30)) * random.uniform());
        const Sphere light{{0, 0, 0}, 1 + random.uniform()};
        const Real height = light.radius * (1 + gap);
        const LightSample sample = sampled(light, {0, height, 0}, {last, random.uniform()});
        const Real distance = sample.distance;
        if (distance > 0 && distance <= height) continue;
        INFO("a light of radius "
             << text(light.radius) << " at distance " << text(height)
             << ", place.x = 1 - epsilon / 2: yours gives the distance " << text(distance)
             << ".\nHint: k may be almost h, and then h (2 - h) - k (2 - k) may be rounded to less "
                "than 0. (h - k) (2 - h - k) is equal and never negative");
        REQUIRE(text(distance) == text(std::sqrt(gap * (2 + gap)) * light.radius));
    }
}

TEST_CASE("08.3 from inside every direction leads to the light", "[08.3][hard]") {
    const Sphere light{{1, 1, 1}, 3};
    {
        const Real density = rt::light_density(light, {1, 4, 1});
        INFO("on the surface itself, d = r, " EXPECTED
             << text(1 / (4 * rt::pi)) << ", " ACTUAL << text(density)
             << ".\nHint: a point with d <= r counts as inside");
        check_near(density, 1 / (4 * rt::pi), 4 * rt::epsilon);
    }
    rt::Rng rng{83, 2};
    for (int i = 0; i < 300; ++i) {
        const Real size = any_size(rng, -9, 9);
        const Sphere any{4 * size * any_direction(rng), size};
        // Near the middle and at it, anywhere, near the surface; on it in whole numbers.
        const Real deep = i % 3 ? rng.uniform() : any_size(rng, -4, 0);
        const Vec3 from =
            any.center + Real(0.9999) * (i % 2 ? deep : 1 - deep) * size * any_direction(rng);
        check_sample(any, i % 50 ? from : any.center, {rng.uniform(), rng.uniform()});
        const Real whole = std::ldexp(Real(1), i % 60 - 30);
        const Vec3 corner{i % 5 ? whole : 7 * whole, whole, whole};
        check_sample({corner, 3 * whole}, corner + Vec3{whole, -2 * whole, 2 * whole},
                     {rng.uniform(), rng.uniform()});
    }
    // All directions are equally likely: a hundred zones along z, then a hundred parts of a turn.
    std::vector<long> zones(200), parts(200);
    const int count = 60'000;
    for (int i = 0; i < count; ++i) {
        const Real x = rng.uniform(), y = rng.uniform();
        const Vec3 d = sampled(light, {1, 1, 0}, {x, y}).direction;
        const double turn = std::atan2(double(d.y), double(d.x)) / (2 * 3.14159265358979) + 0.5;
        const auto hundredth = [](double share) {
            return std::clamp(static_cast<int>(100 * share), 0, 99);
        };
        ++zones[static_cast<std::size_t>(2 * hundredth((1 + double(d.z)) / 2) + (d.x > 0))];
        ++parts[static_cast<std::size_t>(2 * hundredth(turn) + (d.z > 0))];
    }
    const std::vector<double> expected(200, count / 200.0);
    const double by_zones = chi_square(zones, expected), by_parts = chi_square(parts, expected);
    const double limit = chi_square_limit(199);
    {
        INFO("200 parts of equal solid angle should get "
             << expected[0] << " of " << count
             << " directions each; the chi-square is that of the heights.\nHint: call "
                "uniform_direction of 05.2");
        CHECK(by_zones < limit);
    }
    INFO("200 parts of equal solid angle should get "
         << expected[0] << " of " << count
         << " directions each; the chi-square is that of the angles around z."
            "\nHint: a full turn is 2 pi");
    CHECK(by_parts < limit);
}

TEST_CASE("08.3 from a point on the surface every direction has a distance", "[08.3][hard]") {
    // Among these directions are some along the surface, whatever the poles of the learner's are.
    for (const Real radius : {Real(1), Real(3), Real(0.25)})
        for (int axis = 0; axis < 6; ++axis) {
            const Real way = axis % 2 ? radius : -radius;
            const Vec3 from{axis / 2 == 0 ? way : 0, axis / 2 == 1 ? way : 0,
                            axis / 2 == 2 ? way : 0};
            for (int i = 0; i < 64; ++i)
                check_sample({{0, 0, 0}, radius}, from,
                             {static_cast<Real>(i / 8) / 8, static_cast<Real>(i % 8) / 8});
        }
}

TEST_CASE("08.3 nothing overflows in huge and tiny scenes", "[08.3][hard]") {
    const int power = std::is_same_v<Real, float> ? 100 : 1000;
    for (const Real scale : {std::ldexp(Real(1), power), std::ldexp(Real(1), -power)}) {
        check_height(1, 3, scale);
        for_each_place(4, [&](Vec2 place) {
            check_sample({{0, 3 * scale, scale}, scale}, {0, 0, 0}, place);
            check_sample({{0, scale, scale}, 2 * scale}, {0, 0, 0}, place);
        });
    }
}

TEST_CASE("08.3 even a very small light is sampled", "[08.3][hard]") {
    // As long as the height of its cap is a number with all its digits.
    const Real smallest = 4 * std::sqrt(std::numeric_limits<Real>::min());
    for (Real ratio = std::sqrt(rt::epsilon) / 4; ratio > smallest; ratio /= 32) {
        const Sphere star{{0, 1, 0}, ratio};
        const Real expected = 1 / (rt::pi * ratio * ratio);  // h is ratio^2 / 2 after rounding
        const LightSample sample = sampled(star, {0, 0, 0}, {Real(0.25), Real(0.5)});
        for (const Real density : {rt::light_density(star, {0, 0, 0}), sample.density}) {
            INFO("a light of radius " << text(ratio) << " at distance 1: " EXPECTED "the density "
                                      << text(expected) << ", " ACTUAL << text(density)
                                      << ".\nHint: the height h is large enough if it is at least "
                                         "std::numeric_limits<Real>::min()");
            check_near(density, expected, rt::rounding_bound(30) * expected);
        }
    }
}

TEST_CASE("08.3 a light whose cap is too small for a normal number is not sampled",
          "[08.3][hard]") {
    // Of two heights, a hundredth more and a hundredth less than that number, only the
    // first has a density.
    for (const Real factor : {Real(1.01), Real(0.99)}) {
        const Sphere star{{0, 8, 0},
                          8 * std::sqrt(factor) * std::sqrt(2 * std::numeric_limits<Real>::min())};
        INFO("cone_height would be " << text(factor) << " times std::numeric_limits<Real>::min()");
        CHECK((rt::light_density(star, {0, 0, 0}) > 0) == (factor > 1));
        CHECK(rt::sample_light(star, {0, 0, 0}, {0, 0}).has_value() == (factor > 1));
    }
    // Heights below the smallest number with all digits, and one that is 0 after rounding.
    const Real tiny = std::numeric_limits<Real>::min();
    const Real least = std::numeric_limits<Real>::denorm_min();
    for (const Real height : {tiny / 4, tiny / 1024, 8 * least, least, Real(0)}) {
        const Sphere star = height > 0 ? Sphere{{0, 1, 0}, std::sqrt(height) * std::sqrt(Real(2))}
                                       : Sphere{{0, 1 / std::sqrt(tiny), 0}, std::sqrt(tiny)};
        INFO("a light of radius " << text(star.radius) << " at distance " << text(star.center.y)
                                  << "; cone_height gives "
                                  << text(rt::cone_height(star.radius, star.center.y)));
        {
            const Real density = rt::light_density(star, {0, 0, 0});
            INFO("light_density gives "
                 << text(density)
                 << " instead of 0.\nHint: below std::numeric_limits<Real>::min() a number does "
                    "not have full precision, and 1 divided by it may be infinite");
            CHECK(density == 0);
        }
        INFO("where light_density is 0, sample_light must give no sample");
        CHECK_FALSE(rt::sample_light(star, {0, 0, 0}, {Real(0.5), Real(0.5)}).has_value());
    }
}
