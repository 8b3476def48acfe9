#include <rt/dielectric.hpp>
#include <rt/ending.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/material_set.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>

#include "exact_vectors.hpp"

using namespace checkpoint;

namespace {

// Draws the same number again and again, and counts how often.
struct Fixed {
    Real number;
    int draws = 0;
    Real uniform() {
        ++draws;
        return number;
    }
};

// The smallest and the largest random number: one reflects wherever anything is reflected,
// the other nowhere. The learner chooses which one reflects; a reflectance of one half
// finds it out here.
constexpr Real smallest = 0, largest = 1 - rt::epsilon / 2;
bool small_numbers_reflect() {
    rt::Hit hit;
    hit.normal = floor_normal;
    Fixed random{real(0.25)};
    const auto half = [](Real, Real) { return real(0.5); };
    return rt::scatter_at_glass(real(1.5), half, arriving_at_floor(30), hit, random).direction.y >
           0;
}
Fixed always_reflect() {
    return {small_numbers_reflect() ? smallest : largest};
}
Fixed never_reflect() {
    return {small_numbers_reflect() ? largest : smallest};
}

rt::Hit floor_hit(bool front) {
    rt::Hit hit;
    hit.normal = front ? floor_normal : -floor_normal;
    hit.front = front;
    return hit;
}

double distance(Vec3 a, Vec3 b) {
    return length(exact(a - b)).high;
}

using Glass = rt::MaterialSet<rt::Dielectric>;

const rt::GradientSky gradient{{real(0.2), real(0.1), 0}, {real(0.3), real(0.6), 1}};

}  // namespace

TEST_CASE("05.5 light enters glass and leaves it by the law of refraction", "[05.5]") {
    const rt::Dielectric glass{real(1.5)};
    for (const bool front : {true, false}) {
        const double sine = front ? 0.6 : 0.4, beyond = front ? 0.4 : 0.6;
        const Vec3 incoming{real(sine), -real(std::sqrt(1 - sine * sine)), 0};
        const Vec3 expected{real(beyond), -real(std::sqrt(1 - beyond * beyond)), 0};
        Fixed random = never_reflect();
        const auto bounce = scatter(glass, incoming, floor_hit(front), random);
        REQUIRE(bounce.has_value());
        INFO("light along " << text(incoming)
                            << (front ? " from outside, eta = 1 / 1.5" : " from inside, eta = 1.5")
                            << ", the facing normal is " << text(Vec3{0, 1, 0}));
        const char* hint =
            "eta is 1 / index if hit.front, else index; the normal that counts is "
            "facing_normal(hit), on the side that the light comes from";
        if (distance(bounce->direction, {incoming.x, -incoming.y, 0}) <=
            static_cast<double>(rt::rounding_bound(32)))
            hint =
                "your code reflects this light: reflect only if random.uniform() is less than the "
                "reflectance, else refract. The cosine, -dot(incoming, facing_normal(hit)), is "
                "above 0";
        HINT(expected, bounce->direction, hint);
        if (distance(bounce->direction, expected) > static_cast<double>(rt::rounding_bound(32)))
            CHECK(text(bounce->direction) == text(expected));
    }
}

TEST_CASE("05.5 light that is not let through is reflected", "[05.5]") {
    const rt::Dielectric glass{real(1.5)};
    const auto check = [&](bool front, double degrees, Fixed random, const char* hint) {
        const Vec3 incoming = arriving_at_floor(degrees);
        const auto bounce = scatter(glass, incoming, floor_hit(front), random);
        INFO((front ? "from outside" : "from inside") << " at " << degrees << " degrees");
        INFO("Hint: " << hint);
        REQUIRE(bounce.has_value());
        const Vec3 expected{incoming.x, -incoming.y, incoming.z};
        HINT(expected, bounce->direction, "the light must leave along the mirror direction");
        if (distance(bounce->direction, expected) > static_cast<double>(rt::rounding_bound(32)))
            CHECK(text(bounce->direction) == text(expected));
    };
    const char* drawn = "reflect if random.uniform() is less than the reflectance";
    check(true, 30, always_reflect(), drawn);
    check(false, 30, always_reflect(), drawn);
    const char* total = "if refract returns none, all light is reflected";
    check(false, 42, never_reflect(), total);
    check(false, 89, never_reflect(), total);
}

TEST_CASE("05.5 glass reflects as often as the reflectance says", "[05.5]") {
    {
        INFO(
            "Hint: leave the two materials as they were given: if no index is given, each of them "
            "is glass");
        CHECK(text(rt::Dielectric{}.index) == "1.5");
        CHECK(text(rt::SchlickDielectric{}.index) == "1.5");
    }
    // Any reflectance, as a function that records what it is asked.
    rt::Rng rng{55, 1};
    for (int i = 0; i < 3000; ++i) {
        Arrival arrival = random_arrival(rng);
        if (i % 10 == 9) arrival.incoming = -arrival.normal;  // head on
        const Vec3 incoming = arrival.incoming, normal = arrival.normal;
        const Real near_1 = std::pow(Real(10), rng.uniform(for_this_precision(-6, -14), -1));
        const Real index = i % 30 == 2  ? 1
                           : i % 3 == 0 ? rng.uniform(real(0.3), 3)
                           : i % 3 == 1 ? std::pow(Real(10), rng.uniform(-1, 1))
                                        : 1 + (i % 2 ? near_1 : -near_1);
        rt::Hit hit;
        hit.front = rng() & 1;
        hit.normal = hit.front ? normal : -normal;
        const Real tiny = std::pow(Real(10), rng.uniform(for_this_precision(-6, -15), -1));
        const Real wanted = i % 8 == 0   ? 0
                            : i % 8 == 1 ? 1
                            : i % 8 < 4  ? tiny
                            : i % 8 < 6  ? 1 - tiny
                                         : rng.uniform();
        Real cosine = -1, eta = -1;
        const auto reflectance = [&](Real c, Real e) {
            cosine = c;
            eta = e;
            return wanted;
        };
        const Real eta_expected = hit.front ? 1 / index : index;
        const Real cosine_expected = static_cast<Real>(-dot(exact(incoming), exact(normal)).high);
        const auto through = rt::refract(incoming, normal, eta_expected);
        const Vec3 mirror = rt::above_horizon(rt::reflect(incoming, normal), normal);
        const auto describe = [&] {
            return "index " + text(index) + ", hit from " + (hit.front ? "outside" : "inside") +
                   ", incoming " + text(incoming) + ", normal " + text(hit.normal) +
                   ", reflectance " + text(wanted);
        };
        int draws = 0;
        const auto is_reflected = [&](Real drawn) {
            Fixed random{drawn};
            const rt::Scatter bounce =
                rt::scatter_at_glass(index, reflectance, incoming, hit, random);
            draws = std::max(draws, random.draws);
            if (!(bounce.attenuation == rt::Color{1, 1, 1})) {
                INFO(describe());
                INFO("attenuation "
                     << bounce.attenuation
                     << "\nHint: the probabilities of the random choice are already the weights: "
                        "do not dim the reflected or the refracted light");
                REQUIRE(text(Vec3{bounce.attenuation.r, bounce.attenuation.g,
                                  bounce.attenuation.b}) == "(1, 1, 1)");
            }
            const double rounding = 32 * static_cast<double>(rt::epsilon);
            if (distance(bounce.direction, mirror) <= rounding) return true;
            // Close to the critical angle the last digit of the ratio shows.
            const double behind =
                std::abs(static_cast<double>(rt::dot(through.value_or(normal), normal)));
            const double loose = rounding * (1 + static_cast<double>(eta_expected)) *
                                 (1 + 1 / std::max(1e-9, behind));
            if (through && distance(bounce.direction, *through) <= loose) return false;
            INFO(describe() << ", drawn " << text(drawn));
            INFO(EXPECTED "either the mirror direction "
                 << text(mirror) << " or the refracted direction "
                 << (through ? text(*through) : "(none)") << ", " ACTUAL << text(bounce.direction));
            INFO(
                "Hint: eta is 1 / index if hit.front, else index; the normal is "
                "facing_normal(hit), for above_horizon, too");
            REQUIRE(text(bounce.direction) == text(through.value_or(mirror)));
            return false;
        };
        // The numbers on one side of a limit are reflected. Which side does not matter.
        Real low = smallest, high = largest, share = 0;
        const bool small_ones = is_reflected(low);
        if (is_reflected(high) == small_ones) {
            share = small_ones ? 1 : 0;
        } else {
            while (high - low > rt::epsilon / 2) {
                const Real middle = low + (high - low) / 2;
                if (!(low < middle && middle < high)) break;
                (is_reflected(middle) == small_ones ? low : high) = middle;
            }
            share = small_ones ? high : 1 - high;
        }
        const Real expected = through ? wanted : 1;
        if (!(std::abs(share - expected) <= 2 * rt::epsilon)) {
            INFO(describe());
            HINT(expected, share,
                 through ? "the values are the reflected fraction: reflect if random.uniform() is "
                           "less than the reflectance, however small that is"
                         : "the values are the reflected fraction. If refract returns none, all "
                           "light is "
                           "reflected");
            REQUIRE(text(share) == text(expected));
        }
        const bool asks_right = std::abs(cosine - cosine_expected) <= 8 * rt::epsilon &&
                                std::abs(eta - eta_expected) <= 4 * rt::epsilon * eta_expected;
        if ((through || cosine != -1) && !asks_right) {
            INFO(describe());
            INFO(EXPECTED "reflectance("
                 << text(cosine_expected) << ", " << text(eta_expected)
                 << "), " ACTUAL "reflectance(" << text(cosine) << ", " << text(eta)
                 << ")\nHint: cosine = -dot(incoming, normal) with the facing normal, and eta is "
                    "the index on this side divided by the index on the other");
            REQUIRE(text(eta) == text(eta_expected));
            REQUIRE(text(cosine) == text(cosine_expected));
        }
        INFO(describe() << ": the values are the number of random numbers that were drawn. Each "
                           "decision needs one number, and a reflectance of 0 needs none");
        REQUIRE(draws <= (wanted > 0 ? 1 : 0));
        if (through && 0 < wanted && wanted < 1) REQUIRE(draws == 1);
    }
}

TEST_CASE("05.5 glass keeps all light", "[05.5]") {
    rt::Rng rng{55, 2};
    for (const bool front : {true, false})
        for (const double degrees : {0.0, 30.0, 60.0, 89.0})
            for (int i = 0; i < 20; ++i) {
                const auto bounce = scatter(rt::Dielectric{real(1.5)}, arriving_at_floor(degrees),
                                            floor_hit(front), rng);
                INFO(
                    "Hint: the probabilities of the random choice are already the weights: do not "
                    "dim the reflected or the refracted light");
                REQUIRE(bounce.has_value());
                const rt::Color weight = bounce->attenuation;
                if (!(weight == rt::Color{1, 1, 1}))
                    REQUIRE(text(Vec3{weight.r, weight.g, weight.b}) == "(1, 1, 1)");
            }
}

TEST_CASE("05.5 a glass ball turns light by twice the difference of the two angles", "[05.5]") {
    // Light that meets the ball at `aside` of its radius arrives at an angle a with that sine, goes
    // on at b, and leaves at a again. Each time it turns by a - b, toward the middle.
    const rt::SphereList world{{{{{0, 0, 0}, 1}, 0}}};
    const double index = 1.5;
    const Glass glass{{rt::Dielectric{real(index)}}};
    for (const double aside : {0.0, 0.2, 0.5, 0.8, 0.95}) {
        Vec3 leaves;
        const auto sky = [&](Vec3 direction) {
            leaves = direction;
            return rt::Color{1, 1, 1};
        };
        Fixed random = never_reflect();
        rt::path_radiance(rt::Ray{{real(aside), 0, 5}, {0, 0, -1}}, world, glass, sky,
                          rt::BlackEnding{}, 8, random);
        const double turn = 2 * (std::asin(aside) - std::asin(aside / index));
        const Vec3 expected{real(-std::sin(turn)), 0, real(-std::cos(turn))};
        INFO("light at " << aside << " of the radius");
        HINT(expected, leaves, "from inside the ball, hit.front is false: eta is the index itself");
        // The points are off by point_error, 20 epsilon at most; angles there by that over cosine.
        const double off_in_epsilons =
            distance(leaves, expected) / static_cast<double>(rt::epsilon);
        CHECK(off_in_epsilons <= 40 / std::sqrt(1 - aside * aside));
    }
}

TEST_CASE("05.5 a ball of index 1 is invisible", "[05.5][hard]") {
    const rt::SphereList empty,
        with_ball{{{{{0, 0, -3}, 1}, 0}, {{{real(0.4), 0, -3}, real(0.3)}, 0}}};
    const Glass glass{{rt::Dielectric{1}}};
    const rt::Camera camera = rt::make_camera({}, 24, 24);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto draw = [&](const rt::SphereList& world) {
                return rt::render_pixel(camera, world, glass, gradient, rt::BlackEnding{},
                                        {4, 9, 1}, x, y);
            };
            const rt::Color computed = draw(with_ball), expected = draw(empty);
            // Except for the rounding of directions that were normalized once more.
            const rt::Color off = computed - expected;
            const bool is_near =
                std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}) <= 64 * rt::epsilon;
            if (!is_near) {
                INFO("pixel (" << x << ", " << y << "): " EXPECTED << expected << ", " ACTUAL
                               << computed
                               << "\nHint: where the reflectance is 0, refract, and draw no random "
                                  "number: the next sample of the pixel needs it. Schlick's "
                                  "reflectance is never 0, so this case needs the star of 05.4");
                const auto all = [](rt::Color c) { return text(Vec3{c.r, c.g, c.b}); };
                REQUIRE(all(computed) == all(expected));
            }
            REQUIRE(is_near);
        }
}

TEST_CASE("05.5 grazing light is reflected to its own side", "[05.5][hard]") {
    rt::Rng rng{55, 5};
    for (int i = 0; i < 2000; ++i) {
        const Vec3 normal = random_unit(rng);
        // Along the surface, but for rounding.
        const Vec3 incoming = rounded(unit(cross(exact(normal), exact(random_unit(rng)))));
        rt::Hit hit;
        hit.front = i % 2 == 0;
        hit.normal = hit.front ? normal : -normal;
        Fixed random = always_reflect();
        const auto bounce = scatter(rt::Dielectric{real(1.5)}, incoming, hit, random);
        REQUIRE(bounce.has_value());
        const Real height = rt::dot(bounce->direction, normal);
        if (height > 0) continue;
        INFO("incoming " << text(incoming) << ", facing normal " << text(normal) << ": "
                         << text(bounce->direction) << ", its dot product with the normal is "
                         << text(height)
                         << "\nHint: rounding may put a grazing mirror direction on the wrong "
                            "side; pass it through above_horizon, with facing_normal(hit)");
        REQUIRE(text(height) == "greater than 0");
    }
}

TEST_CASE("05.5 glass in a white furnace stays white", "[05.5][hard]") {
    // A ball of glass in a ball of glass, with a bubble in it, all at every scale.
    for (const double scale : {1e-9, 1.0, 1e9}) {
        const Real s = real(scale);
        const rt::SphereList nested{{{{{0, 0, 0}, s}, 0},
                                     {{{s * real(0.1), 0, 0}, real(0.7) * s}, 1},
                                     {{{s * real(0.2), 0, 0}, real(0.3) * s}, 2}}};
        const Glass glass{{rt::Dielectric{real(1.5)}, rt::Dielectric{real(2.4 / 1.5)},
                           rt::Dielectric{real(1 / 2.4)}}};
        rt::Rng rng{55, 3};
        for (int i = 0; i < 2000; ++i) {
            const rt::Ray ray{{s * rng.uniform(-1, 1), s * rng.uniform(-1, 1), 5 * s}, {0, 0, -1}};
            const rt::Color light =
                rt::path_radiance(ray, nested, glass, rt::UniformSky{}, rt::SkyEnding{}, 100, rng);
            if (!(light == rt::Color{1, 1, 1})) {
                INFO("scale " << scale << ": " EXPECTED "white, " ACTUAL << light);
                REQUIRE(text(light.g) == "1");
            }
            REQUIRE(light == rt::Color{1, 1, 1});
        }
    }
}

TEST_CASE("05.5 light leaves glass at every scale", "[05.5][hard]") {
    // Without chance: light that is never reflected where it may go through passes each of the
    // three balls' surfaces twice, so 6 bounces are enough whatever the scale. If rounding caught
    // it on a surface again, they would not be enough.
    for (const double scale : {1e-9, 1.0, 1e9}) {
        const Real s = real(scale);
        const rt::SphereList nested{{{{{0, 0, 0}, s}, 0},
                                     {{{0, 0, 0}, real(0.9) * s}, 1},
                                     {{{0, 0, 0}, real(0.8) * s}, 2}}};
        const Glass glass{
            {rt::Dielectric{real(1.2)}, rt::Dielectric{real(1.3)}, rt::Dielectric{real(1.1)}}};
        rt::Rng rng{55, 4};
        for (int i = 0; i < 2000; ++i) {
            const Real aside = real(0.999) * rng.uniform();
            Fixed random = never_reflect();
            const rt::Color light =
                rt::path_radiance(rt::Ray{{s * aside, 0, 5 * s}, {0, 0, -1}}, nested, glass,
                                  rt::UniformSky{}, rt::BlackEnding{}, 7, random);
            if (!(light == rt::Color{1, 1, 1})) {
                INFO("scale " << scale << ", light at " << aside
                              << " of the radius: the light never leaves the ball");
                REQUIRE(text(light.g) == "1");
            }
            REQUIRE(light == rt::Color{1, 1, 1});
        }
    }
}
