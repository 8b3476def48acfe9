#pragma once
// A scene like the cover of the classic tutorial: 486 spheres, three of them large and one the
// ground. All of them are matte here.

#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>
#include <rt/rng.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>

#include "classic.hpp"

namespace bvh {

using namespace rt;

struct Cover {
    std::vector<SceneSphere> spheres;
    MaterialList<Lambertian> materials;
    GradientSky sky{{1, 1, 1}, {Real(0.5), Real(0.7), 1}};
    int width = 400, height = 225;
    Quality quality{10, 50, 1};
    View view{{13, 2, 3}, {0, 0, 0}, {0, 1, 0}, radians(20)};
};

inline Cover make_cover() {
    Cover cover;
    Rng rng{1, 7};
    const auto add = [&](Vec3 center, Real radius, Color albedo) {
        cover.spheres.push_back({{center, radius}, static_cast<int>(cover.spheres.size())});
        cover.materials.materials.push_back({albedo});
    };
    add({0, -1000, 0}, 1000, {Real(0.5), Real(0.5), Real(0.5)});
    add({0, 1, 0}, 1, {Real(0.8), Real(0.8), Real(0.8)});
    add({-4, 1, 0}, 1, {Real(0.4), Real(0.2), Real(0.1)});
    add({4, 1, 0}, 1, {Real(0.7), Real(0.6), Real(0.5)});
    for (int i = 0; cover.spheres.size() < 486; ++i) {
        const auto row = static_cast<Real>(i / 22 % 22 - 11),
                   column = static_cast<Real>(i % 22 - 11);
        const Vec3 center{row + Real(0.9) * rng.uniform(), Real(0.2),
                          column + Real(0.9) * rng.uniform()};
        const Vec3 apart = center - Vec3{4, Real(0.2), 0};
        if (dot(apart, apart) <= Real(0.81)) continue;
        const Real r = rng.uniform(), g = rng.uniform(), b = rng.uniform();
        add(center, Real(0.2), {r * r, g * g, b * b});
    }
    return cover;
}

// The whole picture's mean color: what is computed is used.
template <class World>
Color render_cover(const Cover& cover, const World& world) {
    const Camera camera = make_camera(cover.view, cover.width, cover.height);
    Color sum;
    for (int y = 0; y < cover.height; ++y)
        for (int x = 0; x < cover.width; ++x)
            sum += render_pixel(camera, world, cover.materials, cover.sky, BlackEnding{},
                                cover.quality, x, y);
    return sum / static_cast<Real>(cover.width * cover.height);
}

inline classic::Vec in_double(Vec3 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline std::shared_ptr<classic::Hittable> make_classic(const Cover& cover) {
    classic::Node::Objects objects;
    for (const SceneSphere& sphere : cover.spheres) {
        const Color c = cover.materials.materials[static_cast<std::size_t>(sphere.material)].albedo;
        objects.push_back(std::make_shared<classic::Ball>(
            in_double(sphere.shape.center), static_cast<double>(sphere.shape.radius),
            std::make_shared<classic::Matte>(in_double({c.r, c.g, c.b}))));
    }
    return std::make_shared<classic::Node>(objects, 0, objects.size());
}

inline Color render_cover(const Cover& cover, const classic::Hittable& world) {
    const Camera camera = make_camera(cover.view, cover.width, cover.height);
    classic::Vec sum;
    for (int y = 0; y < cover.height; ++y)
        for (int x = 0; x < cover.width; ++x)
            for (int i = 0; i < cover.quality.samples_per_pixel; ++i) {
                const Ray ray = primary_ray(camera, x, y,
                                            {static_cast<Real>(classic::random_double()),
                                             static_cast<Real>(classic::random_double())});
                sum = sum + classic::ray_color({in_double(ray.origin), in_double(ray.direction)},
                                               cover.quality.depth, world);
            }
    const double count = double(cover.width) * cover.height * cover.quality.samples_per_pixel;
    sum = 1 / count * sum;
    return {static_cast<Real>(sum.x), static_cast<Real>(sum.y), static_cast<Real>(sum.z)};
}

}  // namespace bvh
