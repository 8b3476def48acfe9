#include <checkpoint.hpp>
#include <rt/color.hpp>
#include <rt/lit_path.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/path.hpp>
#include <statistics.hpp>

#include "lit.hpp"

using namespace checkpoint;

namespace {

// Lights that nobody looks for: the path has to meet them.
struct FoundByChance : rt::SceneLights {
    bool empty() const { return true; }
};

// A floor: it is convex, so no light comes to it from itself.
const rt::Sphere floor_ball{{0, -10, 0}, 10};
const Ray down{{0, Real(0.5), 0}, {0, -1, 0}};

// Lights that are chosen as a test says, with one random number. They remember the point for
// which they were asked.
struct OneSample : rt::SceneLights {
    std::optional<rt::ChosenLight> sample;
    mutable Vec3 asked_from{};
    mutable std::optional<std::uint32_t> drawn{};

    template <class Random>
    std::optional<rt::ChosenLight> choose(Vec3 from, Random& random) const {
        asked_from = from;
        drawn = random();
        return sample;
    }
};

// Lights of a scene that has none: nobody may ask for one.
struct NoneToChoose : rt::SceneLights {
    template <class Random>
    std::optional<rt::ChosenLight> choose(Vec3, Random&) const {
        FAIL("lights.empty() is true.\nHint: then do not call direct_light");
        return {};
    }
};

// A material that absorbs whatever arrives.
struct Absorbing {};
template <class Random>
std::optional<rt::Scatter> scatter(const Absorbing&, Vec3, const rt::Hit&, Random&) {
    return {};
}
[[maybe_unused]] Real scatter_density(const Absorbing&, const rt::Hit&, Vec3) {
    return 0;
}

// A world that finds the same as another one, and requires that the ray's time is 0.25.
struct AtThatTime {
    const rt::SphereList& world;
    mutable int asked = 0;
    mutable Ray last{};

    std::optional<rt::Hit> hit(const rt::TimedRay& ray, rt::Interval within) const {
        ++asked;
        last = {ray.origin, ray.direction};
        REQUIRE(ray.time == Real(0.25));
        return world.hit(ray, within);
    }
};

bool is_near(Color a, Color b) {
    const auto near = [](Real x, Real y) { return std::abs(x - y) <= 64 * rt::epsilon * y; };
    return near(a.r, b.r) && near(a.g, b.g) && near(a.b, b.b);
}
std::string text(Color c) {
    return checkpoint::text(Vec3{c.r, c.g, c.b});
}

// What direct_light makes of a sample above the top of the floor.
struct Direct {
    Lit lit;
    rt::Light light;
    OneSample lights;
    bool goes_on = true;
    int asked = 0;

    // In this direction, of this density.
    Direct(Vec3 direction, Real distance, Real density) {
        lit.add(floor_ball, white);
        const rt::Sphere bulb{distance * rt::normalize(direction), Real(0.01)};
        light = {bulb, {2, 3, 4}};
        lights.add(light);
        lights.sample =
            rt::ChosenLight{{rt::normalize(direction), distance, density}, {2, 3, 4}, &light};
        lit.world.spheres.push_back({bulb, 7, 0});
    }
    Color operator()() {
        const AtThatTime world{lit.world};
        rt::Rng random{1, 1};
        const rt::TimedRay ray{{0, Real(0.5), 0}, {0, -1, 0}, Real(0.25)};
        const auto vertex = rt::next_vertex(ray, world, lit.materials, lit.fog, random);
        rt::Rng before = random;
        world.asked = 0;
        const Color color = rt::direct_light(ray, world, lights, vertex, goes_on, random);
        before();
        INFO("lights.choose draws from `random`; direct_light itself must draw nothing");
        CHECK(random() == before());
        INFO("lights.choose must be called with vertex.point");
        CHECK(lights.asked_from == vertex.point);
        asked = world.asked;
        if (asked > 0) check_shadow_ray(world.last, vertex);
        return color;
    }
    template <class Vertex>
    void check_shadow_ray(const Ray& ray, const Vertex& vertex) const {
        const Vec3 direction = lights.sample->sample.direction, origin = vertex.origin(direction);
        const auto check = [](Vec3 found, Vec3 expected, const char* hint) {
            if (rt::length(found - expected) <= 64 * rt::epsilon) return;
            INFO("Hint: before you call sees_light, set " << hint);
            CHECK(checkpoint::text(found) == checkpoint::text(expected));
        };
        check(ray.direction, direction, "ray.direction to the direction of the sample");
        check(ray.origin, origin, "ray.origin to vertex.origin(direction of the sample)");
    }
};

void check_direct(Color found, Color expected, const char* hint) {
    if (is_near(found, expected)) return;
    INFO("Hint: " << hint);
    CHECK(text(found) == text(expected));
}

}  // namespace

TEST_CASE("08.4 one sample of direct light has the value of the formula", "[08.4]") {
    // cos = 0.8, so that a white floor takes this direction with the density 0.8 / pi.
    const Real toward = Real(0.8) / rt::pi;
    const Vec3 up{Real(0.6), Real(0.8), 0};
    const Color radiance{2, 3, 4};
    for (const Real density : {Real(0.1), Real(0.5), Real(40)}) {
        Direct direct{up, 5, density};
        direct.goes_on = false;
        const Color found = direct();
        INFO("the vertex has the density " << text(toward) << ", the sample " << text(density));
        {
            INFO(
                "Hint: the light is above the floor, and nothing is in the way. Ask vertex.density "
                "for the direction of the sample, and then sees_light, once");
            REQUIRE(direct.asked == 1);
        }
        if (found == Color{})
            check_direct(found, toward / density * radiance,
                         "nothing is in the way, but no light arrives: set both members of the ray "
                         "before you call sees_light");
        check_direct(found, toward / density * radiance,
                     "divide the vertex's density by the sample's density, and multiply by the "
                     "radiance; if you use weights, the weight is 1 if the path does not go on");
    }
}

TEST_CASE("08.4 a sample is multiplied by its weight if the path goes on", "[08.4][hard]") {
    const Real toward = Real(0.8) / rt::pi;
    for (const Real density : {Real(0.1), Real(0.5), Real(40)}) {
        Direct direct{{Real(0.6), Real(0.8), 0}, 5, density};
        INFO("the vertex has the density " << text(toward) << ", the sample " << text(density));
        const Real weight = density * density / (density * density + toward * toward);
        check_direct(direct(), toward / density * weight * Color{2, 3, 4},
                     "multiply by the sample's weight, which is shared_weight(sample.density, "
                     "density of the vertex)");
    }
}

TEST_CASE("08.4 a light that is hidden or behind the surface gives no light", "[08.4]") {
    const Color black;
    Direct direct{{0, 1, 0}, 5, 1};
    direct.lit.world.spheres.push_back({{{0, 3, 0}, Real(0.5)}, 0});
    check_direct(direct(), black, "a sphere is between the vertex and the light: call sees_light");
    Direct behind{{0, 1, 0}, 5, 1};
    behind.goes_on = false;
    behind.lit.world.spheres.push_back({{{0, 8, 0}, Real(0.5)}, 0});
    check_direct(behind(), Color{2, 3, 4} / rt::pi, "an object behind the light is not in the way");
    Direct below{{1, Real(-0.5), 0}, 5, 1};
    const char* const behind_the_surface =
        "the light lies below the floor: the vertex's density is 0 there, so return black at once";
    check_direct(below(), black, behind_the_surface);
    {
        INFO("Hint: " << behind_the_surface << ", without a call of sees_light");
        CHECK(below.asked == 0);
    }
    Direct none{{0, 1, 0}, 5, 1};
    none.lights.sample.reset();
    check_direct(none(), black, "lights.choose gave no sample, so there is no direct light");
}

TEST_CASE("08.4 direct light comes through the fog", "[08.4][hard]") {
    Direct direct{{0, 1, 0}, 5, 1};
    direct.goes_on = false;
    // The way is 5 units long, and 2 of them are foggy; the ray to the floor stays outside.
    direct.lit.fog = {{{{0, 3, 0}, 1}, Real(0.5), {1, 1, 1}, 0}};
    check_direct(direct(), std::exp(Real(-1)) / rt::pi * Color{2, 3, 4},
                 "multiply by vertex.fog.gets_through(ray, sample.distance), where ray is the ray "
                 "to the light");
}

TEST_CASE("08.4 a path never loses the light that it has collected", "[08.4]") {
    // One bounce on a floor, white or all but black, far below a light that makes up for it: what
    // the floor gets is the same for every ending.
    for (const Real albedo : {Real(1), Real(1e-6)}) {
        Lit lit;
        lit.add(floor_ball, rt::Lambertian{{albedo, albedo, albedo}});
        const Color radiance = 2 / albedo * Color{1, 1, 1};
        lit.add_light({{0, 40, 0}, 1}, radiance);
        const double expected = 2 / 1600.0;
        const auto check = [&](const auto& ending, int depth, const char* name) {
            const Mean mean = lit.mean(down, lit.lights, ending, depth, 4000, 5);
            INFO("a floor of albedo "
                 << checkpoint::text(albedo) << " under a light of radiance " << text(radiance)
                 << "; the paths end " << name << " after " << depth
                 << " bounces; mean of the light: " << mean.mean() << ", " EXPECTED << expected
                 << ".\nHint: a path adds the direct light before it ends, in black or in the sky, "
                    "times the throughput from before the ending, however small that is");
            CHECK(std::abs(mean.mean() - expected) <=
                  limit * mean.standard_error() + 0.01 * expected);
        };
        check(rt::SkyEnding{}, 1, "in the sky");
        check(rt::BlackEnding{}, 1, "in black");
        check(rt::RouletteEnding{Real(0.5)}, 1, "by roulette, at least half of them each time,");
        check(rt::SkyEnding{}, 3, "in the sky");
        // A second surface that absorbs everything: what was collected on the way to it stays.
        lit.add({{0, 0, 0}, 1000}, rt::Lambertian{{0, 0, 0}});
        check(rt::BlackEnding{}, 4, "in black, most of them at a black wall,");
    }
}

TEST_CASE("08.4 an absorbed path keeps the light that it has collected", "[08.4]") {
    // A white floor under a light; whatever leaves the floor is absorbed by a wall around it.
    const rt::SphereList world{{{floor_ball, 0}, {{{0, 0, 0}, 1000}, 1}, {{{0, 40, 0}, 1}, 2, 0}}};
    const rt::MaterialSet<rt::Lambertian, Absorbing> materials{{white, Absorbing{}, white}};
    const rt::SceneLights lights{{{rt::Sphere{{0, 40, 0}, 1}, {2, 2, 2}}}};
    Mean mean;
    rt::Rng random{9, 8};
    for (int i = 0; i < 4000; ++i)
        mean.add(gray(rt::lit_path_radiance(down, world, materials, rt::UniformSky{{0, 0, 0}},
                                            lights, rt::NoFog{}, rt::SkyEnding{}, 5, random)));
    const double expected = 2 / 1600.0;
    INFO("mean of the light: " << mean.mean() << ", " EXPECTED << expected
                               << ".\nHint: where the material gives no Scatter, return the light "
                                  "that was collected so far");
    CHECK(std::abs(mean.mean() - expected) <= limit * mean.standard_error() + 0.01 * expected);
}

TEST_CASE("08.4 a matte bounce draws random numbers to sample a light and a mirror draws none",
          "[08.4]") {
    const auto draws = [](const auto& material, int of_material, bool asks) {
        Lit lit;
        lit.add(floor_ball, material);
        OneSample lights;
        lights.add({rt::Sphere{{0, 40, 0}, 1}, {2, 2, 2}});
        rt::Rng random{4, 4}, expected = random;
        rt::lit_path_radiance(down, lit.world, lit.materials, lit.sky, lights, rt::NoFog{},
                              rt::SkyEnding{}, 1, random);
        for (int i = 0; i < of_material; ++i) expected.uniform();
        if (asks) expected();
        INFO(
            "Hint: pass the same generator to vertex.scatter and to direct_light. Call "
            "direct_light "
            "only where the density of the bounce is greater than 0");
        CHECK(random() == expected());
    };
    draws(white, 2, true);
    draws(rt::Mirror{{1, 1, 1}}, 0, false);
    // Rough metal may ask for a light: with weights that is right, too.
}

TEST_CASE("08.4 random numbers are drawn for the bounce and the ending before the light",
          "[08.4]") {
    Lit lit;
    lit.add(floor_ball, white);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        OneSample lights;
        lights.add({rt::Sphere{{0, 40, 0}, 1}, {2, 2, 2}});
        rt::Rng random{seed, 4}, expected = random;
        rt::lit_path_radiance(down, lit.world, lit.materials, lit.sky, lights, rt::NoFog{},
                              rt::RouletteEnding{}, 1, random);
        for (int i = 0; i < 3; ++i) expected.uniform();  // two for the bounce, one for the ending
        INFO(
            "a white floor, and roulette from the first bounce on.\nHint: the order is "
            "place.scatter, the ending, direct_light");
        REQUIRE(lights.drawn.has_value());
        REQUIRE(*lights.drawn == expected());
    }
}

TEST_CASE("08.4 a bounce adds no light that was sampled even if it was hidden", "[08.4]") {
    // A floor in a lamp that is all around. The sample is hidden by a black ball, but most bounces
    // meet the lamp elsewhere.
    Lit lit;
    lit.add(floor_ball, white);
    lit.add({{0, 3, 0}, Real(0.5)}, rt::Lambertian{{0, 0, 0}});
    lit.add_light({{0, 0, 0}, 50}, {1, 1, 1});
    // So likely to sample the lamp that the star's weight of the bounce is 0.
    struct Likely : OneSample {
        Real density(const rt::Light&, Vec3) const { return Real(1e9); }
    } lights;
    lights.add(lit.lights.all()[0]);
    lights.sample = rt::ChosenLight{{{0, 1, 0}, 50, Real(1e9)}, {1, 1, 1}, &lights.all()[0]};
    const Mean mean = lit.mean(down, lights, rt::SkyEnding{}, 2, 200, 8);
    INFO("mean of the light: " ACTUAL
         << mean.mean()
         << ", " EXPECTED
            "0.\nHint: a light that was sampled, but is hidden, is in the sample with "
            "0. So `sampled` does not depend on what direct_light returns: otherwise partly hidden "
            "lamps are too bright");
    CHECK(mean.mean() <= 0.001);
}

TEST_CASE("08.4 without lights and fog the result equals that of 04.7 exactly", "[08.4]") {
    Lit lit;
    lit.add({{0, -100, 0}, 100}, gray_matte);
    lit.add({{0, 1, 0}, 1}, rt::Metal{{1, Real(0.9), Real(0.8)}, Real(0.2)});
    lit.add({{2, 1, 0}, 1}, rt::Dielectric{});
    lit.add({{-2, 1, 0}, 1}, white);
    const rt::GradientSky sky{{Real(0.2), Real(0.3), 0}, {1, 1, 1}};
    const auto check = [&](const auto& ending) {
        rt::Rng directions{1, 2};
        for (std::uint64_t i = 0; i < 500; ++i) {
            const Ray ray{{0, 2, 5}, any_direction(directions)};
            rt::Rng first{i, 3}, second{i, 3}, third{i, 3};
            const Color expected =
                rt::path_radiance(ray, lit.world, lit.materials, sky, ending, 5, first);
            const Color without = rt::lit_path_radiance(
                ray, lit.world, lit.materials, sky, rt::NoLights{}, rt::NoFog{}, ending, 5, second);
            const Color empty = rt::lit_path_radiance(ray, lit.world, lit.materials, sky,
                                                      NoneToChoose{}, lit.fog, ending, 5, third);
            REQUIRE((expected == without));
            REQUIRE((expected == empty));
            // The same numbers were drawn.
            const auto next = first();
            REQUIRE(second() == next);
            REQUIRE(third() == next);
        }
    };
    check(rt::SkyEnding{});
    check(rt::BlackEnding{});
    check(rt::RouletteEnding{});
}

TEST_CASE("08.4 a light that is seen directly shows its radiance", "[08.4]") {
    Lit lit;
    lit.add(floor_ball, white);
    lit.add_light({{0, 3, 0}, 1}, {998, 500, 2});
    check_mean(lit.mean({{0, 1, 0}, {0, 1, 0}}, lit.lights, rt::SkyEnding{}, 3, 10, 1), 500);
}

TEST_CASE("08.4 a floor gets as much light as the formula says", "[08.4]") {
    // Facing the light: E = pi L sin^2 a; a white floor sends back E / pi.
    for (const Real distance : {Real(1.2), Real(3), Real(40)}) {
        // Away from the scene's origin.
        const Vec3 place{5, 2, -3};
        Lit lit;
        lit.add({place + floor_ball.center, floor_ball.radius}, white);
        lit.add_light({place + Vec3{0, distance, 0}, 1}, {2, 2, 2});
        const Ray ray{place + Vec3{Real(0.1), Real(0.1), 0}, rt::normalize(Vec3{-1, -1, 0})};
        const auto sine = static_cast<double>(1 / distance);
        const double expected = 2 * sine * sine;
        INFO("distance " << text(distance));
        // The light sample alone, it and the bounce, and the bounce alone.
        check_mean(lit.mean(ray, lit.lights, rt::SkyEnding{}, 1, 8000, 1), expected);
        const Mean both = lit.mean(ray, lit.lights, rt::SkyEnding{}, 2, 8000, 2);
        INFO((both.mean() > expected
                  ? "Hint: a bounce from a place where the light was sampled may meet it, too. Do "
                    "not count it twice: after such a bounce, the light adds nothing more"
                  : "Hint: light is lost. If the sample has a weight, a bounce that meets the "
                    "light brings the rest: the two weights add up to 1"));
        check_mean(both, expected);
        const FoundByChance chance{lit.lights};
        check_mean(lit.mean(ray, chance, rt::SkyEnding{}, 2, 40000, 3), expected);
        {
            INFO(
                "paths end by roulette. If you use weights: a path that ended might have met the "
                "light, too, so the sample still has its weight");
            check_mean(lit.mean(ray, lit.lights, rt::RouletteEnding{Real(0.5)}, 1, 40000, 6),
                       expected);
        }
    }
}

TEST_CASE("08.4 small lights are found although paths hardly ever meet them", "[08.4]") {
    // The light's share of the sky is 1 in 250000.
    Lit lit;
    lit.add(floor_ball, white);
    lit.add_light({{0, 1, 0}, Real(0.004)}, {1, 1, 1});
    const Mean direct = lit.mean(down, lit.lights, rt::SkyEnding{}, 2, 2000, 4);
    const double expected = 0.004 * 0.004;
    CHECK(std::abs(direct.mean() - expected) <= 0.01 * expected);
}

TEST_CASE("08.4 a light behind glass is added to the light that was collected", "[08.4]") {
    // A white floor under a bulb, glass of index 1 around both, and a lamp around everything. Every
    // path meets the floor, where the bulb is sampled, the glass, where nothing is, and the lamp.
    const rt::Sphere bulb{{0, 5, 0}, Real(0.001)};
    const rt::SphereList world{
        {{floor_ball, 0}, {{{0, 0, 0}, 30}, 1}, {{{0, 0, 0}, 50}, 2, 0}, {bulb, 2, 1}}};
    const rt::MaterialSet<rt::Lambertian, rt::Dielectric> materials{
        {white, rt::Dielectric{1}, rt::Lambertian{{0, 0, 0}}}};
    OneSample lights;
    lights.add({rt::Sphere{{0, 0, 0}, 50}, {1, 2, 3}, 0});
    lights.add({bulb, {20000, 20000, 20000}, 1});
    // Of a density so large that the star's weight is 1.
    const Real density = 10000;
    lights.sample =
        rt::ChosenLight{{{0, 1, 0}, 5, density}, {20000, 20000, 20000}, &lights.all()[1]};
    rt::Rng random{8, 4};
    const Color found = rt::lit_path_radiance(down, world, materials, rt::UniformSky{{0, 0, 0}},
                                              lights, rt::NoFog{}, rt::SkyEnding{}, 9, random);
    const Color expected = Color{1, 2, 3} + 2 / rt::pi * Color{1, 1, 1};
    INFO("light "
         << text(found) << ", " EXPECTED << text(expected)
         << ": 0.637 from the bulb above the floor, and (1, 2, 3) from the lamp behind the "
            "glass.\nHint: at glass no light is sampled, so `sampled` is false again there, "
            "and the lamp that the path then meets is added in full to what was collected");
    CHECK(rt::max_component(Vec3{found.r - expected.r, found.g - expected.g,
                                 found.b - expected.b}) < Real(0.001));
}

TEST_CASE("08.4 a furnace whose light comes from lights alone stays white", "[08.4][hard]") {
    // The camera is inside a light of radiance 1: whatever it sees is white, fog or no fog.
    for (const Real density : {Real(0), Real(0.4)}) {
        Lit lit;
        lit.add({{0, 0, 0}, 1}, white);
        lit.add({{2, 1, 0}, 1}, rt::Metal{{1, 1, 1}, Real(0.4)});
        lit.add({{-2, 1, 0}, 1}, rt::Dielectric{});
        lit.add_light({{0, 0, 0}, 20}, {1, 1, 1});
        lit.fog = {{{{0, 0, 0}, 12}, density, {1, 1, 1}, Real(0.3)}};
        for (const Vec3 direction : {Vec3{0, 0, -1}, Vec3{Real(0.28), 0, Real(-0.96)}})
            check_mean(
                lit.mean({{0, 0, 6}, direction}, lit.lights, rt::RouletteEnding{}, 20, 4000, 77),
                1);
    }
}

namespace {

// Lights of all sizes over a floor, beside metal and glass.
Lit varied(bool foggy) {
    Lit lit;
    lit.add(floor_ball, gray_matte);
    lit.add({{Real(1.2), Real(0.7), 0}, Real(0.7)}, rt::Metal{{1, 1, 1}, Real(0.1)});
    lit.add({{-1, Real(0.5), Real(0.3)}, Real(0.5)}, rt::Dielectric{});
    lit.add({{0, Real(0.3), -1}, Real(0.3)}, rt::CheckeredMatte{{1, 1, 1}, {0, 0, 0}, 1});
    lit.add_light({{0, 3, 0}, 1}, {2, 3, 4});
    lit.add_light({{2, 1, 2}, Real(0.5)}, {1, 1, 0});
    if (foggy) lit.fog = {{{{0, 0, 0}, 5}, Real(0.2), {1, Real(0.9), 1}, Real(0.5)}};
    return lit;
}
const Ray to_floor{{0, 1, 2}, rt::normalize(Vec3{Real(0.1), -1, -2})};
const Ray to_glass{{0, 1, 2}, rt::normalize(Vec3{-1, Real(-0.5), Real(-1.7)})};
const Ray to_metal{{0, 1, 2}, rt::normalize(Vec3{Real(1.2), Real(-0.3), -2})};
const Ray to_nothing{{0, 1, 2}, {0, 0, 1}};

void check_both_ways(const Lit& lit, const Ray& ray, int count) {
    const FoundByChance chance{lit.lights};
    const Mean direct = lit.mean(ray, lit.lights, rt::RouletteEnding{}, 4, count, 11);
    const Mean pure = lit.mean(ray, chance, rt::RouletteEnding{}, 4, 8 * count, 12);
    INFO("variance per sample: " << direct.variance() << " direct, " << pure.variance() << " pure");
    check_same(direct, pure);
}

}  // namespace

TEST_CASE("08.4 sampling lights and finding them by chance give equal means", "[08.4]") {
    for (const Ray& ray : {to_floor, to_glass, to_metal}) check_both_ways(varied(false), ray, 5000);
    // A gray room, where much light comes by way of several walls: each takes its share.
    Lit room;
    room.add({{0, 0, 0}, 4}, gray_matte);
    room.add_light({{0, 2, 0}, 1}, {2, 3, 4});
    check_both_ways(room, to_floor, 5000);
    // Rough metal, for which vertex.shared_density and vertex.density differ.
    Lit rough;
    rough.add(floor_ball, rt::Metal{{1, 1, 1}, Real(0.5)});
    rough.add_light({{0, 3, 0}, 1}, {2, 3, 4});
    check_both_ways(rough, {{Real(0.1), 1, 0}, rt::normalize(Vec3{Real(-0.1), -1, Real(0.3)})},
                    5000);
}

TEST_CASE("08.4 sampling lights and finding them by chance give equal means in fog",
          "[08.4][hard]") {
    for (const Ray& ray : {to_floor, to_glass, to_nothing})
        check_both_ways(varied(true), ray, 5000);
}

TEST_CASE("08.4 a light that a bounce meets is weighted from the bounce's point", "[08.4][hard]") {
    // In a gray room a path often bounces several times before it meets the light.
    Lit room;
    room.add({{0, 0, 0}, 4}, gray_matte);
    room.add_light({{0, 2, 0}, 1}, {2, 3, 4});
    struct Followed {
        const rt::SphereList& world;
        mutable Vec3 origin{};  // of the last ray
        std::optional<rt::Hit> hit(const Ray& ray, rt::Interval within) const {
            origin = ray.origin;
            return world.hit(ray, within);
        }
    } const world{room.world};
    struct Asked : rt::SceneLights {
        const Followed* world = nullptr;
        mutable int times = 0;
        mutable std::string wrong{};
        Real density(const rt::Light& light, Vec3 from) const {
            ++times;
            if (!(rt::length(from - world->origin) <= 1000 * rt::epsilon))
                wrong = "point " + checkpoint::text(from) + ", but the ray came from " +
                        checkpoint::text(world->origin);
            return rt::SceneLights::density(light, from);
        }
    } lights;
    lights.add(room.lights.all()[0]);
    lights.world = &world;
    rt::Rng random{8, 5};
    for (int i = 0; i < 200; ++i)
        rt::lit_path_radiance(to_floor, world, room.materials, room.sky, lights, rt::NoFog{},
                              rt::BlackEnding{}, 9, random);
    INFO(
        "Hint: if the path meets a light, ask lights.density for the point of the last bounce: "
        "keep vertex.point at each bounce, before the ray goes on");
    CHECK(lights.times > 0);
    CHECK(lights.wrong == "");
}

TEST_CASE("08.4 a light that is seen in a mirror counts in full", "[08.4]") {
    // Most light comes to the floor by way of the mirror around it: a matte bounce, then a mirror,
    // for which no light was looked for, then the light.
    Lit lit;
    lit.add(floor_ball, gray_matte);
    lit.add({{0, 0, 0}, 40}, rt::Mirror{{1, 1, 1}});
    lit.add_light({{0, 9, 0}, 4}, {1, 2, 3});
    const Ray ray{{0, 1, 2}, rt::normalize(Vec3{Real(0.1), -1, -2})};
    const FoundByChance chance{lit.lights};
    const Mean direct = lit.mean(ray, lit.lights, rt::RouletteEnding{}, 6, 6000, 21);
    const Mean pure = lit.mean(ray, chance, rt::RouletteEnding{}, 6, 20000, 22);
    INFO(
        "the mean with sampled lights must equal the mean with lights found by chance alone. A "
        "mirror gives a density of 0, so no light is sampled there: a light that the path meets "
        "after the mirror counts in full");
    check_same(direct, pure);
}
