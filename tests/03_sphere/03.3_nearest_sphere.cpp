#include <optional>
#include <rt/nearest_sphere.hpp>
#include <vector>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;
using rt::infinity;
using rt::Interval;
using rt::nearest_sphere;
using rt::Ray;
using rt::SceneSphere;

namespace {

using Nearest = std::optional<rt::NearestSphere>;
using Spheres = std::vector<SceneSphere>;

constexpr Interval ahead{0, infinity};
const Ray forward{{0, 0, 0}, {0, 0, -1}};

std::string text(const Nearest& nearest) {
    if (!nearest) return "no sphere";
    return "number " + std::to_string(nearest->number) + " at t = " + checkpoint::text(nearest->t);
}

// The nearest of the hits that each sphere alone gives.
Nearest by_comparing(const Spheres& spheres, const Ray& ray, Interval within) {
    Nearest nearest;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const auto t = rt::hit_sphere(spheres[i].shape, ray, within);
        if (t && !(nearest && nearest->t < *t)) nearest = rt::NearestSphere{i, *t};
    }
    return nearest;
}

const char* suggestion(const Nearest& expected, const Nearest& computed, std::size_t count) {
    if (!expected) return "no sphere is hit within the interval: return {}";
    if (!computed) return "call hit_sphere for every sphere, and keep the hits that it returns";
    if (computed->number >= count) return "the spheres are numbered from 0 to their count minus 1";
    if (computed->number == expected->number)
        return "return the t that hit_sphere gave for this very sphere";
    if (computed->t == expected->t)
        return "the number is the index in the list, from 0; of equally near spheres the last "
               "counts";
    return "after each hit, set the far end of the interval to the t of this hit, and leave the "
           "near end unchanged";
}

void check(const Spheres& spheres, const Ray& ray, Interval within, const Nearest& expected) {
    const Nearest computed = nearest_sphere(spheres, ray, within);
    std::string list;
    for (std::size_t i = 0; i < spheres.size() && i < 6; ++i)
        list += "\n  number " + std::to_string(i) + ": center " +
                checkpoint::text(spheres[i].shape.center) + ", radius " +
                checkpoint::text(spheres[i].shape.radius);
    if (spheres.size() > 6) list += "\n  and more";
    INFO("spheres: " << spheres.size() << list << "\nray from " << checkpoint::text(ray.origin)
                     << " along " << checkpoint::text(ray.direction) << ", t from "
                     << checkpoint::text(within.min) << " to " << checkpoint::text(within.max));
    INFO(EXPECTED << text(expected) << ", " ACTUAL << text(computed)
                  << ".\nHint: " << suggestion(expected, computed, spheres.size()));
    REQUIRE(text(computed) == text(expected));
    REQUIRE(computed == expected);
}

// A sphere of radius 1 whose near side is at this t of the ray `forward`.
SceneSphere sphere_at(Real t, int material = 0) {
    return {{{0, 0, -(t + 1)}, 1}, material};
}

const SceneSphere beside{{{5, 0, -5}, 1}, 0};

// Checks a list of spheres around (0, 0, 0), a ray through their midst, and intervals.
void check_any(rt::Rng& rng, Real scale) {
    const std::size_t count = rng() % 12;
    Spheres spheres;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 center{rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)};
        spheres.push_back(
            {{scale * center, scale * rng.uniform(Real(0.1), 2)}, static_cast<int>(i) % 3});
        if (rng() % 4 == 0) spheres.push_back(spheres[rng() % spheres.size()]);
    }
    const auto place = [&] {
        return scale * Vec3{rng.uniform(-4, 4), rng.uniform(-4, 4), rng.uniform(-4, 4)};
    };
    const Vec3 from = place();
    const Ray ray{from, std::pow(Real(10), rng.uniform(-7, 7)) * (place() - from)};
    const Interval line{-infinity, infinity};
    check(spheres, ray, ahead, by_comparing(spheres, ray, ahead));
    check(spheres, ray, line, by_comparing(spheres, ray, line));
    // Intervals that end at a hit, or between hits.
    const Nearest first = by_comparing(spheres, ray, ahead);
    if (!first) return;
    const Real t = first->t, beyond = std::nextafter(t, infinity);
    for (const Interval within :
         {Interval{0, t}, Interval{0, std::nextafter(t, Real(0))}, Interval{beyond, infinity},
          Interval{t, t}, Interval{beyond, 2 * t}, Interval{-t, t / 2}, Interval{beyond, 0}})
        check(spheres, ray, within, by_comparing(spheres, ray, within));
}

}  // namespace

TEST_CASE("03.3 the nearest sphere is found whatever the order of the list", "[03.3]") {
    check({sphere_at(2), sphere_at(6)}, forward, ahead, rt::NearestSphere{0, 2});
    check({sphere_at(6), sphere_at(2)}, forward, ahead, rt::NearestSphere{1, 2});
    check({sphere_at(6), sphere_at(2), sphere_at(10)}, forward, ahead, rt::NearestSphere{1, 2});
    check({sphere_at(10), sphere_at(6), sphere_at(2)}, forward, ahead, rt::NearestSphere{2, 2});
    check({sphere_at(2), sphere_at(10), sphere_at(6)}, forward, ahead, rt::NearestSphere{0, 2});
}

TEST_CASE("03.3 a ray that meets no sphere gives no hit", "[03.3]") {
    check({}, forward, ahead, {});
    check({beside}, forward, ahead, {});
    check({beside, beside, beside}, forward, ahead, {});
    check({sphere_at(2)}, {{0, 0, 0}, {0, 0, 1}}, ahead, {});
}

TEST_CASE("03.3 every sphere of the list is tested", "[03.3]") {
    for (std::size_t count = 1; count <= 40; ++count)
        for (std::size_t hit = 0; hit < count; ++hit) {
            Spheres spheres(count, beside);
            spheres[hit] = sphere_at(3);
            check(spheres, forward, ahead, rt::NearestSphere{hit, 3});
        }
}

TEST_CASE("03.3 the number is the index in the list and not the material", "[03.3]") {
    check({sphere_at(6, 4), beside, sphere_at(2, 7)}, forward, ahead, rt::NearestSphere{2, 2});
    check({sphere_at(6, 1), sphere_at(2, 0), beside}, forward, ahead, rt::NearestSphere{1, 2});
}

TEST_CASE("03.3 a sphere that is near but off the ray does not count", "[03.3]") {
    const SceneSphere near_by{{{3, 0, -1}, 1}, 0};
    check({near_by, sphere_at(6), near_by}, forward, ahead, rt::NearestSphere{1, 6});
    // The nearest center belongs to the small sphere, the nearest surface to the large one.
    const SceneSphere large{{{0, 0, -100}, 98}, 0};
    check({sphere_at(6), large}, forward, ahead, rt::NearestSphere{1, 2});
    check({large, sphere_at(6)}, forward, ahead, rt::NearestSphere{0, 2});
}

TEST_CASE("03.3 only hits within the interval count", "[03.3]") {
    const Spheres spheres{sphere_at(10), sphere_at(2), sphere_at(6)};
    check(spheres, forward, {0, 1}, {});
    check(spheres, forward, {0, 5}, rt::NearestSphere{1, 2});
    check(spheres, forward, {5, infinity}, rt::NearestSphere{2, 6});
    check(spheres, forward, {9, infinity}, rt::NearestSphere{0, 10});
    check(spheres, forward, {3, 5}, rt::NearestSphere{1, 4});  // its far side
    check(spheres, forward, {5, Real(5.5)}, {});
    check(spheres, forward, {13, infinity}, {});
}

TEST_CASE("03.3 a sphere behind the ray never hides one in front of it", "[03.3]") {
    const SceneSphere behind{{{0, 0, 3}, 1}, 0};
    check({behind, sphere_at(6), behind}, forward, ahead, rt::NearestSphere{1, 6});
    check({behind, sphere_at(6)}, forward, {-infinity, infinity}, rt::NearestSphere{0, -4});
}

TEST_CASE("03.3 t is the value that hit_sphere gives for the nearest sphere", "[03.3]") {
    // Each list ends with a sphere that the ray misses, and one that is farther away.
    rt::Rng rng{33, 1};
    for (int i = 0; i < 1000; ++i) {
        const Real near = rng.uniform(1, 10);
        const Ray ray{{rng.uniform(Real(-0.5), Real(0.5)), 0, 0},
                      {0, 0, -rng.uniform(Real(0.1), 3)}};
        const Spheres spheres{sphere_at(near + 3), sphere_at(near), sphere_at(near + 6), beside};
        check(spheres, ray, ahead,
              rt::NearestSphere{1, *rt::hit_sphere(spheres[1].shape, ray, ahead)});
    }
}

TEST_CASE("03.3 a call does not affect the next call", "[03.3]") {
    check({sphere_at(2)}, forward, ahead, rt::NearestSphere{0, 2});
    check({beside, sphere_at(6)}, forward, ahead, rt::NearestSphere{1, 6});
    check({beside}, forward, ahead, {});
}

TEST_CASE("03.3 of equally near spheres the last in the list counts", "[03.3]") {
    check({sphere_at(2), sphere_at(2)}, forward, ahead, rt::NearestSphere{1, 2});
    check({sphere_at(2), sphere_at(6), sphere_at(2), beside}, forward, ahead,
          rt::NearestSphere{2, 2});
    check({sphere_at(6), sphere_at(2), sphere_at(2), sphere_at(2), sphere_at(6)}, forward, ahead,
          rt::NearestSphere{3, 2});
    // Of different sizes: both begin at t = 2.
    check({{{{0, 0, -10}, 8}, 0}, sphere_at(2)}, forward, ahead, rt::NearestSphere{1, 2});
    check({sphere_at(2), {{{0, 0, -10}, 8}, 0}}, forward, ahead, rt::NearestSphere{1, 2});
    // Where the interval ends with it.
    check({sphere_at(2), sphere_at(2)}, forward, {0, 2}, rt::NearestSphere{1, 2});
    check({sphere_at(2), sphere_at(2)}, forward, {2, 2}, rt::NearestSphere{1, 2});
}

TEST_CASE("03.3 a sphere around the ray's origin is hit where the ray leaves it", "[03.3]") {
    const auto around = [](Real radius) { return SceneSphere{{{0, 0, 0}, radius}, 0}; };
    check({around(5), around(3), around(8)}, forward, ahead, rt::NearestSphere{1, 3});
    check({around(5), sphere_at(2), around(8)}, forward, ahead, rt::NearestSphere{1, 2});
    check({sphere_at(6), around(5), around(8)}, forward, ahead, rt::NearestSphere{1, 5});
    check({around(3), around(5)}, forward, {4, infinity}, rt::NearestSphere{1, 5});
}

TEST_CASE("03.3 the last digit of t decides which sphere is nearer", "[03.3][hard]") {
    rt::Rng rng{33, 2};
    for (int i = 0; i < 1000; ++i) {
        // A ray from the center hits the sphere at t = radius.
        const Real radius = std::pow(Real(10), rng.uniform(-6, 6));
        const SceneSphere far{{{0, 0, 0}, radius}, 0};
        const SceneSphere near{{{0, 0, 0}, std::nextafter(radius, Real(0))}, 0};
        for (const Spheres& spheres : {Spheres{near, far}, Spheres{far, near}})
            check(spheres, forward, ahead, by_comparing(spheres, forward, ahead));
    }
}

TEST_CASE("03.3 the nearest sphere is found in lists of any spheres", "[03.3][hard]") {
    rt::Rng rng{33, 3};
    for (int i = 0; i < 3000; ++i) check_any(rng, 1);
}

TEST_CASE("03.3 the nearest sphere is found in tiny and huge scenes", "[03.3][hard]") {
    rt::Rng rng{33, 4};
    const Real most = for_this_precision<Real>(5, 30);
    for (int i = 0; i < 3000; ++i) check_any(rng, std::pow(Real(10), rng.uniform(-most, most)));
}

TEST_CASE("03.3 a list may have many spheres", "[03.3]") {
    Spheres spheres(70'000, beside);
    for (const std::size_t number : {std::size_t{300}, std::size_t{69'999}}) {
        spheres[number] = sphere_at(number == 300 ? 9 : 4);
        check(spheres, forward, ahead, by_comparing(spheres, forward, ahead));
    }
}
