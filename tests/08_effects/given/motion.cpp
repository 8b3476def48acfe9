// Motion blur, lens, textures and mirrors: what chapter 08 gives beside its exercises.

#include <rt/aggregate.hpp>
#include <rt/area_split.hpp>
#include <rt/cameras.hpp>
#include <rt/make_camera.hpp>
#include <rt/metal.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/textures.hpp>
#include <rt/wide_builder.hpp>
#include <statistics.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color;

using MovingTree = rt::TreeOf<rt::MovingSphere>;
static MovingTree tree_of(std::vector<rt::MovingSphere> spheres) {
    return rt::make_tree(std::move(spheres), rt::AreaSplit{});
}

TEST_CASE("a moving sphere covers what geometry says") {
    // It crosses the ray's line at right angles: it covers the line for 2 r of a way of length 6.
    const MovingTree tree = tree_of({{{{-3, 0, -5}, Real(0.6)}, {6, 0, 0}, 0}});
    for (const Real height : {Real(0), Real(0.36), Real(0.48), Real(0.7)}) {
        const double half =
            static_cast<double>(std::sqrt(std::max(Real(0), Real(0.36) - height * height)));
        const double expected = 2 * half / 6;
        constexpr int count = 6000;
        int covered = 0;
        for (int i = 0; i < count; ++i) {
            const rt::TimedRay ray{
                {0, height, 0}, {0, 0, -1}, (static_cast<Real>(i) + Real(0.5)) / count};
            covered += tree.hit(ray, {}) ? 1 : 0;
        }
        INFO("covered " << covered << " of " << count << " times, " EXPECTED << expected * count);
        // The two ends of the way may each be off by one moment.
        CHECK(std::abs(covered - expected * count) <= 2);
    }
}

TEST_CASE("the shutter's times are spread evenly over a pixel's samples") {
    const rt::Camera camera = rt::make_camera({}, 3, 3);
    const rt::ShutterCamera<rt::Camera> eye{camera, true};
    rt::Rng random{3, 3};
    std::vector<long> observed(50);
    for (int i = 0; i < 50000; ++i) {
        const rt::TimedRay ray = make_ray(eye, 1, 1, {Real(0.5), Real(0.5)}, random);
        ++observed[static_cast<std::size_t>(50 * ray.time)];
    }
    CHECK(chi_square(observed, std::vector<double>(50, 1000)) < chi_square_limit(49));
}

TEST_CASE("cameras draw no numbers for what they do not have") {
    const rt::Camera camera = rt::make_camera({}, 30, 30);
    const rt::LensCamera closed{camera, {0, 5}};
    const rt::ShutterCamera<rt::LensCamera> still{closed, false};
    for (int column = 0; column < 30; ++column) {
        const rt::Ray expected = rt::primary_ray(camera, column, 7, {Real(0.2), Real(0.9)});
        rt::Rng random{3, 3}, untouched{3, 3};
        const rt::Ray by_lens = make_ray(closed, column, 7, {Real(0.2), Real(0.9)}, random);
        const rt::TimedRay by_both = make_ray(still, column, 7, {Real(0.2), Real(0.9)}, random);
        CHECK(by_lens.origin == expected.origin);
        CHECK(by_lens.direction == expected.direction);
        CHECK(by_both.origin == expected.origin);
        CHECK(by_both.direction == expected.direction);
        CHECK(by_both.time == 0);
        CHECK(random() == untouched());
    }
}

TEST_CASE("the tree of moving spheres finds what trying them all finds") {
    rt::Rng random{6, 1};
    std::vector<rt::MovingSphere> spheres;
    for (int i = 0; i < 200; ++i)
        spheres.push_back({{10 * any_direction(random), random.uniform(Real(0.1), 2)},
                           random.uniform(0, 8) * any_direction(random),
                           i});
    const MovingTree tree = tree_of(spheres);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const rt::TimedRay ray{20 * any_direction(random), any_direction(random), random.uniform()};
        rt::Interval within;
        int nearest = -1;
        for (std::size_t k = 0; k < spheres.size(); ++k)
            if (const auto t = hit_sphere(sphere_at(spheres[k], ray.time),
                                          rt::Ray{ray.origin, ray.direction}, within)) {
                within.max = *t;
                nearest = static_cast<int>(k);
            }
        const auto hit = tree.hit(ray, {});
        REQUIRE(hit.has_value() == (nearest >= 0));
        if (!hit) continue;
        ++hits;
        REQUIRE(hit->t == within.max);
        REQUIRE(hit->material == nearest);
    }
    CHECK(hits > 200);
    CHECK_FALSE(tree_of({}).hit(rt::TimedRay{{0, 0, 0}, {0, 0, 1}, 0}, {}));
}

TEST_CASE("the nearer of a moving and a standing sphere is seen") {
    const std::vector<rt::SceneSphere> still{{{{0, 0, -5}, 1}, 7}};
    const auto world =
        rt::both(rt::make_wide_tree(still), tree_of({{{{0, 0, -12}, 1}, {0, 0, 10}, 9}}));
    const auto material = [&](Real time) {
        return world.hit(rt::TimedRay{{0, 0, 0}, {0, 0, -1}, time}, {})->material;
    };
    CHECK(material(0) == 7);
    CHECK(material(1) == 9);
}

TEST_CASE("a checker's cubes take turns in all directions") {
    const Color black{0, 0, 0}, white{1, 1, 1};
    const rt::CheckeredMatte checker{white, black, Real(0.5)};
    const auto at = [&](Real x, Real y, Real z) { return rt::checker_color(checker, {x, y, z}); };
    CHECK(at(0, 0, 0) == white);
    CHECK(at(Real(0.24), Real(-0.24), Real(0.2)) == white);
    CHECK(at(Real(0.5), 0, 0) == black);
    CHECK(at(Real(-0.5), 0, 0) == black);
    CHECK(at(0, Real(0.5), 0) == black);
    CHECK(at(0, 0, Real(-0.5)) == black);
    CHECK(at(Real(0.5), Real(0.5), 0) == white);
    CHECK(at(Real(-0.5), Real(0.5), Real(0.5)) == black);
    CHECK(at(1, 0, 0) == white);
    const Real huge = std::numeric_limits<Real>::max();
    CHECK(rt::is_finite(at(huge, -huge, huge)));
}

TEST_CASE("an image goes around a sphere like a map around a globe") {
    // Four columns: red, green, blue, white; two rows, the lower one half as bright.
    const rt::Image map = rt::make_image(4, 2, [](int x, int y) {
        const Color columns[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
        return Real(y == 0 ? 1 : 0.5) * columns[x];
    });
    const auto seen = [&](Vec3 direction) {
        return rt::image_color(map, rt::normalize(direction));
    };
    const Real up = Real(0.3);
    // Looking along -z at the globe, you see green on the left and blue on the right.
    CHECK((seen({-1, up, 1}) == Color{0, 1, 0}));
    CHECK((seen({1, up, 1}) == Color{0, 0, 1}));
    CHECK((seen({-1, up, -1}) == Color{1, 0, 0}));
    CHECK((seen({1, up, -1}) == Color{1, 1, 1}));
    CHECK((seen({1, -up, 1}) == Color{0, 0, Real(0.5)}));
    for (const Vec3 edge : {Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}, Vec3{Real(-0.0), 0, -1}})
        CHECK(rt::is_finite(seen(edge)));
}

TEST_CASE("a mirror draws nothing and gives what metal of fuzz 0 gives") {
    rt::Rng random{2, 2}, untouched{2, 2};
    rt::Rng directions{1, 1};
    for (int i = 0; i < 200; ++i) {
        rt::Hit hit;
        hit.normal = any_direction(directions);
        const Vec3 incoming = any_direction(directions);
        hit.front = rt::dot(incoming, hit.normal) <= 0;
        const auto mirrored = scatter(rt::Mirror{{1, 1, 1}}, incoming, hit, random);
        const Vec3 expected =
            rt::metal_direction(incoming, facing_normal(hit), 0, {Real(0.5), Real(0.5)});
        CHECK(mirrored->direction == expected);
    }
    CHECK(random() == untouched());
}
