// Any design that keeps the contract passes: nothing here knows what the learner's material is.

#include <array>
#include <functional>
#include <optional>
#include <rt/dielectric.hpp>
#include <rt/ending.hpp>
#include <rt/lambertian.hpp>
#include <rt/metal.hpp>
#include <rt/own_material.hpp>
#include <rt/path.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>
#include <sstream>

#include "exact_vectors.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::Color;
using rt::OwnMaterial;
using rt::Rng;

namespace {

using Bounce = std::optional<rt::Scatter>;

constexpr std::array<Real, 5> amounts{0, Real(0.25), Real(0.5), Real(0.75), 1};

// Light that meets a surface of the material, and the random numbers that decide what it does.
struct Sample {
    OwnMaterial material;
    Vec3 incoming;
    rt::Hit hit;
    Rng random{56, 0};

    Bounce operator()() const {
        Rng copy = random;
        return scatter(material, incoming, hit, copy);
    }
};

Sample sample_at(Vec3 incoming, Vec3 facing, bool front, OwnMaterial material, Rng& rng) {
    Sample sample{material, incoming, {}, {rng(), 56}};
    sample.hit.t = rng.uniform(1, 5);
    sample.hit.point = {rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)};
    sample.hit.normal = front ? facing : -facing;
    sample.hit.front = front;
    sample.hit.point_error = rt::rounding_bound(8);
    return sample;
}

// Any side, any angle but the last half degree, any color and amount.
Sample any_sample(Rng& rng) {
    for (;;) {
        const Arrival arrival = random_arrival(rng);
        if (dot(exact(arrival.incoming), exact(arrival.normal)).high > -0.01) continue;
        const OwnMaterial material{{rng.uniform(), rng.uniform(), rng.uniform()},
                                   rng() % 2 ? amounts[rng() % 5] : rng.uniform()};
        return sample_at(arrival.incoming, arrival.normal, rng() % 2 == 0, material, rng);
    }
}

std::string text_of(Color c) {
    return '(' + text(c.r) + ", " + text(c.g) + ", " + text(c.b) + ')';
}

std::string text_of(const Bounce& bounce) {
    if (!bounce) return "absorbed";
    return "attenuation " + text_of(bounce->attenuation) + ", direction " + text(bounce->direction);
}

std::string text_of(const Sample& sample) {
    std::ostringstream out;
    out << "color " << text_of(sample.material.color) << ", amount " << text(sample.material.amount)
        << ", incoming " << text(sample.incoming) << ", facing normal "
        << text(facing_normal(sample.hit)) << ", from "
        << (sample.hit.front ? "outside" : "inside");
    return out.str();
}

// What rounding may add to a share of light that is 1.
const Real most = 1 + rt::rounding_bound(16);

bool is_share(Color c) {
    const auto within = [](Real share) { return 0 <= share && share <= most; };
    return within(c.r) && within(c.g) && within(c.b);
}

void check_direction(const Sample& sample, const Bounce& bounce) {
    const Vec3 direction = bounce ? bounce->direction : sample.hit.normal;
    const Real cosine = rt::dot(direction, sample.hit.normal);
    const double off = in_epsilon(length(exact(direction)) - Exact(1));
    const bool is_right = !bounce || (off <= 64 && cosine != 0);
    if (!is_right) {
        INFO(text_of(sample) << ": " << text_of(*bounce));
        {
            INFO(EXPECTED
                 "a direction of length 1; the values are the error of its length, in "
                 "epsilon\nHint: pass a sum of vectors through normalize, or through "
                 "above_horizon, which also accepts the zero vector");
            REQUIRE(off <= 64);
        }
        INFO("the dot product of the direction and the normal: " EXPECTED
             "any number but 0, actual: 0\nHint: light must not run along the surface: for light "
             "that is reflected, return above_horizon(direction, facing_normal(hit)), which lifts "
             "it if it has the star of 05.2");
        REQUIRE(cosine != 0);
    }
    REQUIRE(is_right);
}

void check_attenuation(const Sample& sample, const Bounce& bounce) {
    const bool is_right = !bounce || is_share(bounce->attenuation);
    if (!is_right) {
        INFO(text_of(sample) << ": " << text_of(*bounce));
        INFO(EXPECTED
             "each channel of the attenuation in [0, 1]: no more light leaves than arrives\nHint: "
             "if the path takes one of several ways at random, the probabilities are already the "
             "weights: do not add up the ways, and do not divide by the probability. The cosine is "
             "-dot(incoming, facing_normal(hit))");
        REQUIRE(text_of(bounce->attenuation) == "within [0, 1]");
    }
    REQUIRE(is_right);
}

void check_bounce(const Sample& sample, const Bounce& bounce) {
    check_direction(sample, bounce);
    check_attenuation(sample, bounce);
}

bool is_same(const Bounce& a, const Bounce& b) {
    if (!a || !b) return !a && !b;
    return a->attenuation == b->attenuation && a->direction == b->direction;
}

// The same but for rounding.
bool is_close(const Bounce& a, const Bounce& b) {
    if (!a || !b) return !a && !b;
    const Color p = a->attenuation, q = b->attenuation;
    const Real share = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    return share <= rt::rounding_bound(32) &&
           in_epsilon(length(exact(a->direction) - exact(b->direction))) <= 64;
}

// How much white light from outside comes back on average, in the brightest channel.
double visible_light(Real amount) {
    Rng rng{56, 4};
    Mean r, g, b;
    for (int i = 0; i < 2000; ++i) {
        Sample sample = any_sample(rng);
        sample.hit.normal = facing_normal(sample.hit);
        sample.hit.front = true;
        sample.material = {{1, 1, 1}, amount};
        const Bounce bounce = sample();
        const Color light = bounce ? bounce->attenuation : Color{};
        r.add(static_cast<double>(light.r));
        g.add(static_cast<double>(light.g));
        b.add(static_cast<double>(light.b));
    }
    return std::max({r.mean(), g.mean(), b.mean()});
}

// A material that is given, with the learner's color and amount.
struct Given {
    const char* name;
    std::function<Bounce(const Sample&, Rng&)> scatter;
};

template <class Make>
Given given(const char* name, const Make& make) {
    return {name, [make](const Sample& s, Rng& random) {
                return scatter(make(s.material), s.incoming, s.hit, random);
            }};
}

// The hard cases' colors and amounts: both ends, what is next to them, and the middle.
OwnMaterial extreme_material(Rng& rng) {
    const Real least = std::numeric_limits<Real>::min();
    const Real shares[]{0, 1, least, rt::epsilon, Real(0.5), 1 - rt::epsilon / 2};
    const auto any = [&] { return shares[rng() % 6]; };
    const Real gray = any();
    const Color color = rng() % 2 ? Color{gray, gray, gray} : Color{any(), any(), any()};
    return {color, rng() % 2 ? Real(rng() % 2) : any()};
}

}  // namespace

TEST_CASE("05.6 light leaves in a direction of length 1", "[05.6]") {
    Rng rng{56, 1};
    for (int i = 0; i < 4000; ++i) {
        const Sample sample = any_sample(rng);
        check_direction(sample, sample());
    }
}

TEST_CASE("05.6 no more light leaves than arrives", "[05.6]") {
    Rng rng{56, 2};
    for (int i = 0; i < 4000; ++i) {
        Sample sample = any_sample(rng);
        if (i % 4 == 0) sample.material.color = {1, 1, 1};
        check_attenuation(sample, sample());
    }
}

TEST_CASE("05.6 the same random numbers give the same result", "[05.6]") {
    Rng rng{56, 3};
    std::vector<Sample> samples;
    std::vector<Bounce> first;
    for (int i = 0; i < 2000; ++i) {
        samples.push_back(any_sample(rng));
        first.push_back(samples.back()());
    }
    // Again in the other order, each twice, with others in between.
    for (std::size_t i = samples.size(); i-- > 0;) {
        const Sample& sample = samples[i];
        samples[rng() % samples.size()]();
        for (const char* when : {"later, after other calls", "once more, right after that"}) {
            const Bounce again = sample();
            const bool same = is_same(again, first[i]);
            if (!same) {
                INFO(text_of(sample));
                INFO("the same random numbers, "
                     << when
                     << ": " EXPECTED
                        "the same result\nHint: draw all random numbers from `random`, not from a "
                        "generator of your own, and keep nothing from one call to the next: use no "
                        "static or global variables. Give every variable a value");
                REQUIRE("expected " + text_of(first[i]) == "actual " + text_of(again));
            }
            REQUIRE(same);
        }
    }
}

TEST_CASE("05.6 each bounce draws its own random numbers", "[05.6]") {
    Rng rng{56, 7};
    int by_numbers = 0, by_bounces = 0;  // how many results differ
    for (int i = 0; i < 1000; ++i) {
        const Sample sample = any_sample(rng);
        Sample other = sample;
        other.random = {rng(), 56};
        by_numbers += !is_same(sample(), other());
        Rng random = sample.random;
        const auto bounce = [&] {
            return scatter(sample.material, sample.incoming, sample.hit, random);
        };
        const Bounce first = bounce();
        by_bounces += !is_same(first, bounce());
    }
    INFO("other random numbers change "
         << by_numbers << " of 1000 results, but the second of two bounces, one right after the "
         << "other, is never different from the first\nHint: draw from `random` itself, not from a "
         << "copy of it: a function of your own must take it as Random&");
    // A design that draws no random numbers is sound, and few results that differ may be chance.
    const int least = by_numbers > 50 ? 1 : 0;
    CHECK(by_bounces >= least);
}

TEST_CASE("05.6 a material of a light color returns visible light", "[05.6]") {
    double brightest = 0;
    for (const Real amount : amounts) brightest = std::max(brightest, visible_light(amount));
    INFO(
        "white, amounts 0, 0.25, 0.5, 0.75 and 1, from outside: the largest average of the "
        "returned light must be at least 0.01, actual: "
        << brightest << "\nHint: where the light goes on, return Scatter{attenuation, direction}; "
        << "return {} absorbs it");
    CHECK(brightest >= 0.01);
}

TEST_CASE("05.6 each channel of the color counts", "[05.6]") {
    for (Real Color::*channel : {&Color::r, &Color::g, &Color::b}) {
        Rng rng{56, 5};
        bool differs = false;
        for (int i = 0; i < 1000 && !differs; ++i) {
            Sample sample = any_sample(rng);
            sample.material.color.*channel = real(0.2);
            const Bounce dark = sample();
            sample.material.color.*channel = real(0.9);
            differs = !is_same(dark, sample());
        }
        const char* const name = channel == &Color::r   ? "red"
                                 : channel == &Color::g ? "green"
                                                        : "blue";
        INFO("color." << name[0]
                      << " is 0.2 in one run and 0.9 in another: " EXPECTED "different samples, "
                      << "actual: all 1000 samples are the same\nHint: use material.color, all "
                      << "three channels of it");
        CHECK((differs ? "" : std::string{name} + " changes nothing") == "");
    }
}

TEST_CASE("05.6 the material differs from all given materials", "[05.6]") {
    const Given all[]{
        given("Lambertian", [](const OwnMaterial& m) { return rt::Lambertian{m.color}; }),
        given("Metal with fuzz = amount",
              [](const OwnMaterial& m) {
                  return rt::Metal{m.color, m.amount};
              }),
        given("Metal with fuzz 0",
              [](const OwnMaterial& m) {
                  return rt::Metal{m.color, 0};
              }),
        given("Metal with fuzz 1",
              [](const OwnMaterial& m) {
                  return rt::Metal{m.color, 1};
              }),
        given("Dielectric of index 1.5", [](const OwnMaterial&) { return rt::Dielectric{}; })};
    for (const Given& other : all)
        // One that draws a number in vain is still the same material.
        for (int in_vain = 0; in_vain <= 2; ++in_vain) {
            Rng rng{56, 6};
            bool differs = false;
            for (int i = 0; i < 1000 && !differs; ++i) {
                const Sample sample = any_sample(rng);
                Rng random = sample.random;
                for (int k = 0; k < in_vain; ++k) random.uniform();
                differs = !is_close(sample(), other.scatter(sample, random));
            }
            INFO(EXPECTED "a material of its own, actual: in all 1000 samples it does what "
                 << other.name << " does"
                 << (in_vain ? ", and draws random numbers without using them" : "")
                 << "\nHint: make the result depend on the angle, on a random choice, on the "
                    "position or on the amount");
            REQUIRE(differs);
        }
}

TEST_CASE("05.6 scatter keeps its contract for grazing light", "[05.6][hard]") {
    Rng rng{56, 8};
    for (int i = 0; i < 8000; ++i) {
        const ExactVec3 n = exact(random_unit(rng));
        const Vec3 normal = rounded(n);
        const ExactVec3 along = unit(cross(n, exact(random_unit(rng))));
        const int digits = std::numeric_limits<Real>::digits;
        const Real height = std::scalbn(rng.uniform(), -static_cast<int>(rng() % (digits + 2u)));
        const Vec3 incoming = rounded(unit(along - exact(height) * n));
        if (!(rt::dot(incoming, normal) < 0)) continue;
        const Sample sample = sample_at(incoming, normal, i % 2 == 0, extreme_material(rng), rng);
        check_bounce(sample, sample());
    }
}

TEST_CASE("05.6 scatter keeps its contract for light along the normal", "[05.6][hard]") {
    Rng rng{56, 9};
    for (int i = 0; i < 4000; ++i) {
        Vec3 normal = random_unit(rng);
        if (i % 2) normal = i % 3 == 0 ? Vec3{1, 0, 0} : i % 3 == 1 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
        if (i % 4 == 1) normal = -normal;
        const Sample sample = sample_at(-normal, normal, i % 8 < 4, extreme_material(rng), rng);
        check_bounce(sample, sample());
    }
}

TEST_CASE("05.6 scatter keeps its contract for far and tiny hits", "[05.6][hard]") {
    Rng rng{56, 10};
    for (int i = 0; i < 4000; ++i) {
        Sample sample = any_sample(rng);
        const Real size = i % 3 == 0 ? real(1e9) : i % 3 == 1 ? real(1e-9) : 0;
        sample.hit.point = (size / 3) * sample.hit.point;
        sample.hit.t *= size;
        sample.hit.point_error *= size;
        if (i % 2) sample.material = extreme_material(rng);
        check_bounce(sample, sample());
    }
}

TEST_CASE("05.6 scatter keeps its contract for the smallest and largest random numbers",
          "[05.6][hard]") {
    Rng rng{56, 11};
    for (unsigned i = 0; i < 4000; ++i) {
        Sample sample = any_sample(rng);
        if (i % 2) sample.material = extreme_material(rng);
        Extreme random{i % 8};
        INFO("the first three random numbers are " << (i & 4 ? "1 - epsilon / 2, " : "0, ")
                                                   << (i & 2 ? "1 - epsilon / 2, " : "0, ")
                                                   << (i & 1 ? "1 - epsilon / 2" : "0"));
        check_bounce(sample, scatter(sample.material, sample.incoming, sample.hit, random));
    }
}

TEST_CASE("05.6 a ball of the material in a white furnace is nowhere brighter than 1",
          "[05.6][hard]") {
    for (const double scale : {1e-9, 1.0, 1e9}) {
        const Real s = real(scale);
        const rt::SphereList world{{{{s * Vec3{2, -1, 3}, s}, 0}}};
        Rng rng{56, 12};
        for (int i = 0; i < 1500; ++i) {
            const rt::MaterialList<OwnMaterial> material{{extreme_material(rng)}};
            // From the ball's center to its rim, or from inside it.
            const bool inside = i % 3 == 0;
            const Real aside = std::sqrt(rng.uniform());
            const Vec3 from = inside ? real(0.9) * aside * random_unit(rng) : Vec3{aside, 0, 9};
            const rt::Ray ray{s * (Vec3{2, -1, 3} + from),
                              inside ? random_unit(rng) : Vec3{0, 0, -1}};
            const Color light = rt::path_radiance(ray, world, material, rt::UniformSky{},
                                                  rt::BlackEnding{}, 20, rng);
            const Real bound = 1 + 20 * (most - 1);
            const bool is_right = 0 <= light.r && light.r <= bound && 0 <= light.g &&
                                  light.g <= bound && 0 <= light.b && light.b <= bound;
            if (!is_right) {
                INFO("ball of radius "
                     << scale << ", ray from " << (inside ? "inside" : "outside") << " at "
                     << text(aside) << " of the radius, color "
                     << text_of(material.materials[0].color) << ", amount "
                     << text(material.materials[0].amount)
                     << "\nHint: the attenuation of a bounce must not exceed 1 in any channel");
                REQUIRE("expected at most 1 in each channel, actual: " + text_of(light) == "");
            }
            REQUIRE(is_right);
        }
    }
}
