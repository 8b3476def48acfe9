#pragma once
// A scene like the cover of the classic tutorial: 486 spheres of matte, metal and glass, three of
// them large and one the ground.

#include <rt/compiler.hpp>
#include <rt/dielectric.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/render_pixel.hpp>
#include <rt/rng.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>

#include "classic.hpp"

namespace bvh {

using namespace rt;

// Schlick's reflectance, as the baseline has it.
using CoverMaterials = MaterialSet<Lambertian, Metal, SchlickDielectric>;

struct Cover {
    std::vector<SceneSphere> spheres;
    CoverMaterials materials;
    GradientSky sky{{1, 1, 1}, {Real(0.5), Real(0.7), 1}};
    int width = 400, height = 225;
    Quality quality{10, 50, 1};
    View view{{13, 2, 3}, {0, 0, 0}, {0, 1, 0}, radians(20)};
};

inline Cover make_cover() {
    Cover cover;
    Rng rng{1, 7};
    // As many bits as float has: the same scene in both precisions.
    const auto uniform = [&] { return static_cast<Real>(rng() >> 8) / Real(1 << 24); };
    const auto add = [&](Vec3 center, Real radius, const auto& material) {
        cover.spheres.push_back({{center, radius}, static_cast<int>(cover.spheres.size())});
        cover.materials.materials.push_back(material);
    };
    add({0, -1000, 0}, 1000, Lambertian{{Real(0.5), Real(0.5), Real(0.5)}});
    add({0, 1, 0}, 1, SchlickDielectric{});
    add({-4, 1, 0}, 1, Lambertian{{Real(0.4), Real(0.2), Real(0.1)}});
    add({4, 1, 0}, 1, Metal{{Real(0.7), Real(0.6), Real(0.5)}, 0});
    for (int i = 0; cover.spheres.size() < 486; ++i) {
        const auto row = static_cast<Real>(i / 22 % 22 - 11),
                   column = static_cast<Real>(i % 22 - 11);
        const Real x = uniform(), z = uniform();
        const Vec3 center{row + Real(0.9) * x, Real(0.2), column + Real(0.9) * z};
        const Vec3 apart = center - Vec3{4, Real(0.2), 0};
        if (dot(apart, apart) <= Real(0.81)) continue;
        // Four in five are matte, most others metal.
        const Real kind = uniform(), r = uniform(), g = uniform(), b = uniform();
        if (kind < Real(0.8))
            add(center, Real(0.2), Lambertian{{r * r, g * g, b * b}});
        else if (kind < Real(0.95))
            add(center, Real(0.2), Metal{{(1 + r) / 2, (1 + g) / 2, (1 + b) / 2}, uniform() / 2});
        else
            add(center, Real(0.2), SchlickDielectric{});
    }
    return cover;
}

// The whole picture's mean color: what is computed is used.
template <class World, class Materials>
RT_INLINES_ALL Color render_cover(const Cover& cover, const World& world,
                                  const Materials& materials) {
    const Camera camera = make_camera(cover.view, cover.width, cover.height);
    Color sum;
    for (int y = 0; y < cover.height; ++y)
        for (int x = 0; x < cover.width; ++x)
            sum += render_pixel(camera, world, materials, cover.sky, BlackEnding{}, cover.quality,
                                x, y);
    return sum / static_cast<Real>(cover.width * cover.height);
}

// The same for the baseline.

inline classic::Vec in_double(Vec3 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
inline classic::Vec in_double(Color c) {
    return in_double(Vec3{c.r, c.g, c.b});
}

inline std::shared_ptr<classic::Material> make_classic(const Lambertian& matte) {
    return std::make_shared<classic::Matte>(in_double(matte.albedo));
}
inline std::shared_ptr<classic::Material> make_classic(const Metal& metal) {
    return std::make_shared<classic::Metal>(in_double(metal.albedo),
                                            static_cast<double>(metal.fuzz));
}
inline std::shared_ptr<classic::Material> make_classic(const SchlickDielectric& glass) {
    return std::make_shared<classic::Glass>(static_cast<double>(glass.index));
}

inline std::shared_ptr<classic::Hittable> make_classic(const Cover& cover) {
    classic::Objects objects;
    for (const SceneSphere& sphere : cover.spheres)
        objects.push_back(std::make_shared<classic::Ball>(
            in_double(sphere.shape.center), static_cast<double>(sphere.shape.radius),
            std::visit([](const auto& material) { return make_classic(material); },
                       cover.materials.materials[static_cast<std::size_t>(sphere.material)])));
    const auto tree = std::make_shared<classic::Node>(objects, 0, objects.size());
    return std::make_shared<classic::List>(classic::Objects{tree});
}

inline Color render_cover(const Cover& cover, const std::shared_ptr<classic::Hittable>& world) {
    const classic::Camera camera{cover.width,
                                 cover.height,
                                 static_cast<double>(cover.view.vertical_fov),
                                 in_double(cover.view.from),
                                 in_double(cover.view.at),
                                 in_double(cover.view.up)};
    classic::Vec sum;
    for (int y = 0; y < cover.height; ++y)
        for (int x = 0; x < cover.width; ++x)
            for (int i = 0; i < cover.quality.samples_per_pixel; ++i)
                sum = sum + classic::ray_color(camera.ray(x, y), cover.quality.depth, *world);
    sum = sum / (double(cover.width) * cover.height * cover.quality.samples_per_pixel);
    return {static_cast<Real>(sum.x()), static_cast<Real>(sum.y()), static_cast<Real>(sum.z())};
}

}  // namespace bvh
