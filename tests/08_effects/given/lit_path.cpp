// Fog, and hard scenes for the loop of 08.4.

#include "../lit.hpp"

using namespace checkpoint;

TEST_CASE("a white furnace with white fog stays white") {
    Lit lit;
    lit.sky = {{1, 1, 1}};
    lit.add({{0, 0, 0}, 1}, white);
    lit.add({{2, 1, 0}, 1}, rt::Metal{{1, 1, 1}, Real(0.4)});
    lit.add({{-2, 1, 0}, 1}, rt::Dielectric{});
    lit.add({{0, -102, 0}, 100}, rt::Mirror{{1, 1, 1}});
    for (const Real asymmetry : {Real(-0.6), Real(0), Real(0.8)}) {
        lit.fog = {{{{0, 0, 0}, 30}, Real(0.3), {1, 1, 1}, asymmetry}};
        rt::Rng random{5, 5};
        for (int i = 0; i < 3000; ++i) {
            const Ray ray{{0, 3, 6}, any_direction(random)};
            const Color color =
                rt::lit_path_radiance(ray, lit.world, lit.materials, lit.sky, lit.lights, lit.fog,
                                      rt::SkyEnding{}, 40, random);
            REQUIRE((color == Color{1, 1, 1}));
        }
    }
}

TEST_CASE("fog lets through what the formula says") {
    for (const Real density : {Real(0.05), Real(0.5), Real(2)}) {
        Lit lit;
        lit.sky = {{1, 1, 1}};
        lit.fog = {{{{0, 0, 0}, Real(1.5)}, density, {0, 0, 0}, 0}};
        // Straight through the middle: 3 units of fog that scatters nothing.
        check_mean(lit.mean({{0, 0, 9}, {0, 0, -1}}, rt::NoLights{}, rt::SkyEnding{}, 5, 100000, 3),
                   std::exp(-3 * static_cast<double>(density)));
        // From within.
        check_mean(lit.mean({{0, 0, 0}, {0, 1, 0}}, rt::NoLights{}, rt::SkyEnding{}, 5, 100000, 4),
                   std::exp(-1.5 * static_cast<double>(density)));
        const Ray through{{0, 0, 9}, {0, 0, -1}};
        CHECK(std::abs(lit.fog.gets_through(through, 100) - std::exp(-3 * density)) <=
              rt::rounding_bound(60));
        CHECK(std::abs(lit.fog.gets_through(through, 9) - std::exp(Real(-1.5) * density)) <=
              rt::rounding_bound(60));
        CHECK(lit.fog.gets_through(through, 7) == 1);
        CHECK(lit.fog.gets_through(Ray{{0, 2, 9}, {0, 0, -1}}, 100) == 1);
    }
}

TEST_CASE("free flights are as long as the formula says") {
    // Ten bins of equal probability: d_i = -log(1 - i / 10) / density.
    rt::Rng random{8, 1};
    std::vector<long> observed(50);
    for (int i = 0; i < 50000; ++i) {
        const double d = static_cast<double>(rt::free_flight(Real(0.7), random.uniform()));
        ++observed[static_cast<std::size_t>(
            std::min(49.0, 50 * (1 - std::exp(-static_cast<double>(Real(0.7)) * d))))];
    }
    CHECK(chi_square(observed, std::vector<double>(50, 1000)) < chi_square_limit(49));
}

TEST_CASE("fog scatters with the density that it says") {
    for (const Real g : {Real(-0.95), Real(-0.7), Real(0), Real(1e-16), Real(1e-7), Real(0.001),
                         Real(0.3), Real(0.9)}) {
        INFO("asymmetry " << text(g));
        const Vec3 incoming = rt::normalize(Vec3{1, -2, Real(0.5)});
        rt::Rng random{9, 1};
        Mean cosines;
        constexpr int bins = 50, count = 100000;
        std::vector<long> observed(bins);
        for (int i = 0; i < count; ++i) {
            const Vec3 d = rt::phase_direction(g, incoming, rt::random_place(random));
            REQUIRE(std::abs(rt::length(d) - 1) <= rt::rounding_bound(20));
            const double cosine = static_cast<double>(rt::dot(incoming, d));
            cosines.add(cosine);
            ++observed[static_cast<std::size_t>(
                std::clamp((cosine + 1) / 2 * bins, 0.0, bins - 1.0))];
        }
        CHECK(std::abs(cosines.mean() - static_cast<double>(g)) <=
              limit * cosines.standard_error());
        // The density, summed over each bin in 2000 steps.
        std::vector<double> expected(bins);
        double total = 0;
        for (int i = 0; i < bins * 2000; ++i) {
            const double cosine = (i + 0.5) / (bins * 1000) - 1;
            const double share =
                2 * 3.14159265358979 / (bins * 1000) *
                static_cast<double>(rt::phase_density(g, static_cast<Real>(cosine)));
            expected[static_cast<std::size_t>(i / 2000)] += count * share;
            total += share;
        }
        CHECK(std::abs(total - 1) < 1e-4);
        CHECK(chi_square(observed, expected) < chi_square_limit(bins - 1));
    }
}

TEST_CASE("fog that turns light hardly at all, or right back, has finite densities") {
    rt::Rng random{9, 2};
    for (const Real less : {Real(1e-2), Real(1e-4), 4 * rt::epsilon})
        for (const Real g : {1 - less, less - 1})
            for (int i = 0; i < 10000; ++i) {
                const Vec3 incoming = rt::uniform_direction(rt::random_place(random));
                const Vec3 d = rt::phase_direction(g, incoming, rt::random_place(random));
                const Real density = rt::phase_density(g, rt::dot(incoming, d));
                REQUIRE(std::isfinite(density));
                REQUIRE(density > 0);
            }
}

TEST_CASE("a ray that starts on the fog's surface keeps its way through the fog") {
    rt::Rng random{9, 3};
    int lost = 0;
    for (int i = 0; i < 10000; ++i) {
        const rt::Sphere ball{{1, -2, 3}, Real(1.7)};
        const Vec3 outward = rt::uniform_direction(rt::random_place(random));
        const Vec3 direction = rt::uniform_direction(rt::random_place(random));
        const Real inward = -rt::dot(outward, direction);
        const rt::Interval part =
            rt::within_ball(ball, ball.center + ball.radius * outward, direction);
        const Real expected = std::max(Real(0), 2 * ball.radius * inward);
        // The point is off by a few roundings, which count more if the ray is flatter.
        const Real allowed = rt::rounding_bound(20) * 4 / std::max(std::abs(inward), Real(1e-6));
        lost += std::abs(part.size() - expected) > allowed;
    }
    CHECK(lost == 0);
}

TEST_CASE("there is no fog inside glass") {
    // Fog that swallows everything, and a glass ball around the eye: only inside nothing is lost.
    Lit lit;
    lit.add({{0, 0, 0}, 1}, rt::Dielectric{1});
    lit.sky = {{1, 1, 1}};
    lit.fog = {{{{0, 0, 0}, 2}, Real(0.8), {0, 0, 0}, 0}};
    check_mean(lit.mean({{0, 0, 0}, {0, 0, -1}}, lit.lights, rt::SkyEnding{}, 5, 100000, 6),
               std::exp(-0.8));
}

TEST_CASE("light sampled at rough metal is the light found by chance") {
    struct Chance : rt::SceneLights {
        static constexpr bool empty() { return true; }
    };
    for (const Real fuzz : {Real(0.2), Real(0.5), Real(1)}) {
        Lit lit;
        lit.add({{0, -100, 0}, 100}, rt::Metal{{1, Real(0.9), Real(0.8)}, fuzz});
        lit.add({{1, Real(0.5), 0}, Real(0.5)}, rt::Metal{{1, 1, 1}, fuzz});
        lit.add_light({{0, 2, -2}, Real(0.5)}, {2, 3, 4});
        lit.add_light({{0, 3, 5}, 2}, {1, 1, 0});
        INFO("fuzz " << text(fuzz));
        // Onto the floor, also nearly flat, where much of the lobe is folded up, and onto the ball.
        for (const Vec3 to :
             {Vec3{0, Real(-0.8), -2}, Vec3{0, Real(-0.05), -2}, Vec3{1, Real(-0.2), -2}}) {
            const Ray ray{{0, 1, 2}, rt::normalize(to)};
            check_same(lit.mean(ray, lit.lights, rt::SkyEnding{}, 5, 20000, 21),
                       lit.mean(ray, Chance{lit.lights}, rt::SkyEnding{}, 5, 200000, 22));
        }
    }
}

TEST_CASE("lights and fog at any scale give the same light") {
    for (const Real scale : {Real(1e-9), Real(1e9)}) {
        const auto scene = [](Real s) {
            Lit lit;
            lit.add({{0, -100 * s, 0}, 100 * s}, gray_matte);
            lit.add({{s, s / 2, 0}, s / 2}, rt::Dielectric{});
            lit.add_light({{0, 3 * s, 0}, s}, {2, 3, 4});
            lit.fog = {{{{0, 0, 0}, 5 * s}, Real(0.1) / s, {1, 1, 1}, Real(0.5)}};
            return lit;
        };
        const Vec3 direction = rt::normalize(Vec3{Real(0.1), -1, -2});
        const Mean usual = scene(1).mean({{0, 1, 2}, direction}, scene(1).lights,
                                         rt::RouletteEnding{}, 4, 20000, 1);
        const Mean scaled =
            scene(scale).mean({{0, scale, 2 * scale}, direction}, scene(scale).lights,
                              rt::RouletteEnding{}, 4, 20000, 2);
        INFO("scale " << text(scale));
        check_same(usual, scaled);
    }
}

TEST_CASE("lights that touch, are entered, or are far away give finite light") {
    Lit lit;
    lit.add({{0, -1, 0}, 1}, white);
    lit.add_light({{0, Real(0.5), 0}, Real(0.5)}, {1, 1, 1});      // touches the ball
    lit.add_light({{1, -1, 0}, Real(0.3)}, {1, 1, 1});             // goes into it
    lit.add_light({{0, Real(1e12), 0}, Real(1e-3)}, {9, 9, 9});    // too small to be met
    lit.add_light({{0, 0, Real(1e15)}, Real(0.9e15)}, {1, 1, 1});  // huge
    lit.fog = {{{{0, 0, 0}, 2}, Real(0.5), {1, 1, 1}, Real(0.9)}};
    rt::Rng random{4, 4};
    for (int i = 0; i < 50000; ++i) {
        const Ray ray{{0, Real(0.1), 3}, any_direction(random)};
        const Color color = rt::lit_path_radiance(ray, lit.world, lit.materials, lit.sky,
                                                  lit.lights, lit.fog, rt::SkyEnding{}, 6, random);
        REQUIRE(rt::is_finite(color));
        REQUIRE(color.r >= 0);
    }
}
