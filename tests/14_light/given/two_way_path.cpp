// The lamps of a scene, and the loop that finds them in both ways.

#include <rt/ending.hpp>
#include <rt/lobe.hpp>
#include <rt/mesh_world.hpp>
#include <rt/rng.hpp>
#include <rt/tree_lights.hpp>
#include <rt/two_way_path.hpp>

#include "checkpoint.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using namespace rt;

namespace {

// A floor below a triangle that shines and a sphere that does.
struct Room {
    Aggregate<decltype(make_wide_tree(std::vector<SceneSphere>{})), TriangleTree> world;
    MaterialSet<Lambertian, Lobe> materials;
    MeshLights lights;
    Triangle lamp{{-1, 2, -1}, {1, 2, -1}, {0, 3, 1}};

    explicit Room(bool mirrors) {
        materials.materials = {Lambertian{}};
        if (mirrors)
            materials.materials.push_back(Lobe{{real(0.8), real(0.8), real(0.8)}, 30});
        else
            materials.materials.push_back(Lambertian{{real(0.8), real(0.8), real(0.8)}});
        const Sphere ball{{2, real(1.5), 0}, real(0.4)};
        world.first = make_wide_tree(std::vector<SceneSphere>{{ball, 0, 0}});
        world.second = make_wide_tree(
            std::vector<SceneTriangle>{{{{-9, 0, -9}, {0, 0, 9}, {9, 0, -9}}, 1, 0}, {lamp, 0, 1}});
        lights = MeshLights{{Light{ball, {4, 4, 4}, 0, 0}}, {{lamp, {2, 2, 2}, 1}}};
    }
};

struct Black {
    Color operator()(Vec3) const { return {}; }
};

Mean light_from(const Room& room, Ways ways, const Ray& ray, int count) {
    Rng random{14, 7};
    Mean mean;
    for (int i = 0; i < count; ++i)
        mean.add(
            static_cast<double>(two_way_radiance(ray, room.world, room.materials, Black{},
                                                 room.lights, ways, NoFog{}, SkyEnding{}, 4, random)
                                    .r));
    return mean;
}

}  // namespace

TEST_CASE("all ways to find a lamp bring the same light on average") {
    // Of 5,000 such tests with other seeds, one would fail.
    for (const bool mirrors : {false, true}) {
        const Room room{mirrors};
        const Ray ray{{-2, 2, 0}, normalize({real(1.8), -2, real(0.1)})};
        const Mean by_power = light_from(room, Ways::power, ray, 40'000);
        for (const Ways ways : {Ways::samples, Ways::bounces, Ways::balance}) {
            const Mean other = light_from(room, ways, ray, 40'000);
            INFO("way " << static_cast<int>(ways) << (mirrors ? ", a lobe" : ", a matte floor"));
            INFO(other.mean() << " and " << by_power.mean());
            CHECK(other.mean() > 0.01);
            CHECK(std::abs(other.mean() - by_power.mean()) <
                  4 * std::hypot(other.standard_error(), by_power.standard_error()));
        }
    }
}

TEST_CASE("a lamp that the eye sees counts in full, from both sides") {
    const Room room{false};
    for (const Ways ways : {Ways::samples, Ways::bounces, Ways::balance, Ways::power})
        for (const Real height : {real(0.5), real(4)}) {
            const Vec3 from{0, height, 0}, middle{0, real(7.0 / 3), real(-1.0 / 3)};
            const Mean seen = light_from(room, ways, {from, normalize(middle - from)}, 3);
            CHECK(seen.mean() == 2);
        }
}

TEST_CASE("lamps are chosen by their power, with the density that they say") {
    const Room room{false};
    const Vec3 from{real(0.3), 0, real(0.2)};
    Rng random{14, 8};
    constexpr int count = 20'000;
    int triangles = 0;
    for (int i = 0; i < count; ++i) {
        const auto chosen = room.lights.choose(from, random);
        REQUIRE(chosen);
        const Vec3 point = from + chosen->sample.distance * chosen->sample.direction;
        const Real density = room.lights.density(*chosen->light, from, point);
        const bool is_near =
            std::abs(chosen->sample.density - density) <= 500 * epsilon * chosen->sample.density;
        CHECK(is_near);
        triangles += chosen->light->number < 0;
    }
    const double area = static_cast<double>(
        length(cross(room.lamp.b - room.lamp.a, room.lamp.c - room.lamp.a)));  // of both sides
    const double of_triangle = 2 * area, of_sphere = 4 * 4 * 3.14159265358979 * 0.16;
    const double share = of_triangle / (of_triangle + of_sphere);
    CHECK(std::abs(triangles / static_cast<double>(count) - share) <
          4 * std::sqrt(share * (1 - share) / count));
}

TEST_CASE("only lamps are found, by the number of the triangle or sphere") {
    const Room room{false};
    Hit hit;
    hit.light = 0;
    REQUIRE(room.lights.find(hit));
    CHECK(room.lights.find(hit)->radiance == Color{4, 4, 4});
    hit.light = kept_as_light(1);
    REQUIRE(room.lights.find(hit));
    CHECK(room.lights.find(hit)->radiance == Color{2, 2, 2});
    for (const int none : {-1, kept_as_light(0), kept_as_light(2), kept_as_light(1'000'000)}) {
        hit.light = none;
        CHECK(room.lights.find(hit) == nullptr);
    }
    CHECK(MeshLights{}.empty());
}

TEST_CASE("the density of a lobe is that of its directions") {
    // The mean of 1 / density over all directions is the solid angle of the hemisphere; and a lobe
    // sends nothing below the surface. One of 15,000 such tests would fail.
    Rng random{14, 9};
    for (const Real concentration : {real(0.5), real(4), real(40)}) {
        const Lobe lobe{{1, 1, 1}, concentration};
        Hit hit;
        hit.normal = {0, 1, 0};
        hit.front = true;
        const Vec3 incoming = normalize({1, real(-0.5), 0});
        Mean whole;
        for (int i = 0; i < 50'000; ++i) {
            const auto bounce = scatter(lobe, incoming, hit, random);
            REQUIRE(bounce);
            REQUIRE(bounce->direction.y >= 0);
            // Directions spread evenly over the hemisphere.
            Vec3 even = any_direction(random);
            even.y = std::abs(even.y);
            whole.add(2 * 3.14159265358979 *
                      static_cast<double>(scatter_density(lobe, incoming, hit, even)));
        }
        INFO("concentration " << concentration << ": the density adds up to " << whole.mean());
        CHECK(std::abs(whole.mean() - 1) < 4.3 * whole.standard_error());
    }
}

TEST_CASE("a tree of lamps brings the same light as their list, with the density that it says") {
    // Of 5,000 such tests with other seeds, one would fail.
    std::vector<Light> spheres;
    std::vector<LampTriangle> triangles;
    Rng random{14, 10};
    for (int i = 0; i < 40; ++i) {
        const Vec3 at{random.uniform(-4, 4), random.uniform(1, 2), random.uniform(-4, 4)};
        const Real bright = random.uniform(1, 3);
        spheres.push_back({Sphere{at, real(0.1)}, {bright, bright, bright}, i, i});
        const Vec3 corner{-at.x, at.y, at.z};
        triangles.push_back({{corner, corner + Vec3{real(0.3), 0, 0}, corner + Vec3{0, 0, 1}},
                             {bright, bright, bright},
                             i});
    }
    const MeshLights list{spheres, triangles};
    const TreeLights tree{spheres, triangles};
    const Vec3 from{real(0.3), 0, real(0.2)};
    const auto light_of = [&](const auto& lights) {
        Mean mean;
        for (int i = 0; i < 40'000; ++i) {
            const auto chosen = lights.choose(from, random);
            REQUIRE(chosen);
            const LightSample& sample = chosen->sample;
            const Real density =
                lights.density(*chosen->light, from, from + sample.distance * sample.direction);
            const bool is_near =
                std::abs(sample.density - density) <= 2000 * epsilon * sample.density;
            REQUIRE(is_near);
            mean.add(static_cast<double>(sample.direction.y * chosen->radiance.r / sample.density));
        }
        return mean;
    };
    const Mean by_list = light_of(list), by_tree = light_of(tree);
    INFO(by_list.mean() << " and " << by_tree.mean());
    CHECK(std::abs(by_list.mean() - by_tree.mean()) <
          4 * std::hypot(by_list.standard_error(), by_tree.standard_error()));
    CHECK(by_tree.variance() < by_list.variance() / 2);
}
