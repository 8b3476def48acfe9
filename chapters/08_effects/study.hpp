#pragma once
// What it takes to find light, what the formulas lose, and what each effect costs.

#include <array>
#include <numeric>
#include <rt/choose_renderer.hpp>
#include <rt/effects_of.hpp>
#include <rt/renderers.hpp>
#include <study/double_double.hpp>
#include <study/report.hpp>
#include <study/ulp.hpp>

#include "../07_bvh/cover.hpp"

namespace effects {

using namespace rt;

// The irradiance of a floor that faces a light, over pi: what each of several ways of looking for
// it gives for one sample. The right answer is sin^2 a.
struct LightAbove {
    Real distance;  // of a light of radius 1
    Sphere light() const { return {{0, distance, 0}, 1}; }

    // The path has to meet the light by itself.
    Real by_chance(Rng& random) const {
        const Vec3 direction = cosine_direction({0, 1, 0}, random_place(random));
        return meets(direction) ? 1 : 0;
    }
    // A point anywhere on the light, also on its far side.
    Real by_area(Rng& random) const {
        const Vec3 normal = uniform_direction(random_place(random));
        const Vec3 apart = light().center + normal;
        const Real squared = dot(apart, apart);
        const Vec3 direction = apart / std::sqrt(squared);
        const Real facing = -dot(normal, direction);
        return facing > 0 ? 4 * direction.y * facing / squared : 0;
    }
    Real by_cone(Rng& random) const {
        const auto sample = sample_light(light(), {0, 0, 0}, random_place(random));
        return sample->direction.y / (pi * sample->density);
    }
    // The cone and the path, weighed.
    Real by_both(Rng& random) const {
        const auto sample = sample_light(light(), {0, 0, 0}, random_place(random));
        const Real toward = sample->direction.y / pi;
        Real sum = toward / sample->density * shared_weight(sample->density, toward);
        const Vec3 direction = cosine_direction({0, 1, 0}, random_place(random));
        if (meets(direction))
            sum += shared_weight(direction.y / pi, light_density(light(), {0, 0, 0}));
        return sum;
    }
    bool meets(Vec3 direction) const {
        return hit_sphere(light(), {{0, 0, 0}, direction}, {}).has_value();
    }
};

// A few hundred matte spheres on the ground, and one effect more.
inline SceneDescription scene_with(const char* name) {
    SceneDescription scene;
    const std::string effect = name;
    scene.sky = {{1, 1, 1}, {Real(0.5), Real(0.7), 1}};
    scene.camera.view = {{0, 3, 9}, {0, Real(0.3), 0}, {0, 1, 0}, radians(35)};
    scene.materials = {Lambertian{{Real(0.6), Real(0.5), Real(0.4)}},
                       Lambertian{{Real(0.2), Real(0.5), Real(0.8)}}};
    if (effect == "mirror") scene.materials.push_back(Metal{{1, Real(0.8), 1}, 0});
    if (effect == "fuzz") scene.materials.push_back(Metal{{1, 1, 1}, Real(0.3)});
    if (effect == "glass") scene.materials.push_back(Dielectric{});
    if (effect == "texture")
        scene.materials.push_back(CheckeredMatte{{0, 0, 0}, {1, 1, 1}, Real(0.1)});
    if (effect == "lights") scene.materials.push_back(Emitter{{2, 2, 2}});
    if (effect == "lens") scene.camera.lens = {Real(0.2), 9};
    if (effect == "motion") scene.camera.shutter = 1;
    if (effect == "fog") scene.fog = Fog{{{0, 0, 0}, 20}, Real(0.02), {1, 1, 1}, 0};
    scene.spheres.push_back({{{0, -1000, 0}, 1000}, 0});
    Rng random{1, 8};
    const auto kinds = static_cast<int>(scene.materials.size()) - 1;
    for (int i = 0; i < 200; ++i) {
        const Real radius = Real(0.1) + Real(0.3) * random.uniform();
        SphereDescription sphere{{{random.uniform(-6, 6), radius, random.uniform(-8, 5)}, radius},
                                 1 + i % kinds};
        if (effect == "lights" && sphere.material == 2 && i > 20) sphere.material = 1;
        if (effect == "motion" && i < 20) sphere.velocity = {0, radius, 0};
        scene.spheres.push_back(sphere);
    }
    return scene;
}

// The cover scene of chapter 07 as a scene of this one.
inline SceneDescription cover_scene(const bvh::Cover& cover) {
    SceneDescription scene;
    scene.camera.view = cover.view;
    scene.sky = cover.sky;
    for (const auto& material : cover.materials.materials) {
        if (const auto* const glass = std::get_if<SchlickDielectric>(&material))
            scene.materials.push_back(Dielectric{glass->index});  // the exact reflectance
        else if (const auto* const metal = std::get_if<Metal>(&material))
            scene.materials.push_back(*metal);
        else
            scene.materials.push_back(std::get<Lambertian>(material));
    }
    for (const SceneSphere& sphere : cover.spheres)
        scene.spheres.push_back({sphere.shape, sphere.material});
    return scene;
}

inline void study_effects(study::Report& report) {
    const auto row = [&](const char* study, const char* variant, double x, const char* x_name,
                         double error, const char* error_name, double cost, const char* cost_name) {
        report.add({study, variant, x, x_name, error, error_name, cost, cost_name});
    };

    // Four ways to find a light: how far off the mean of a number of samples is, and its time.
    using Way = Real (LightAbove::*)(Rng&) const;
    constexpr std::array<std::pair<const char*, Way>, 4> ways{
        {{"by chance", &LightAbove::by_chance},
         {"point on the sphere", &LightAbove::by_area},
         {"cone", &LightAbove::by_cone},
         {"cone and chance", &LightAbove::by_both}}};
    for (const auto& [name, measured_way] : ways) {
        const auto way = measured_way;  // clang++ 14 cannot capture what a binding names
        for (const Real distance : {Real(1.1), Real(1.5), Real(3), Real(10), Real(30), Real(100)}) {
            const LightAbove scene{distance};
            const double expected = 1 / static_cast<double>(distance * distance);
            Rng random{8, 3};
            double squares = 0;
            constexpr int timed = 100'000;
            // By chance one direction in distance^2 meets the light. A thousand must, or their
            // number is itself chance.
            const int count = way == &LightAbove::by_chance
                                  ? std::max(timed, static_cast<int>(1000 / expected))
                                  : timed;
            for (int i = 0; i < count; ++i) {
                const double off = static_cast<double>((scene.*way)(random)) - expected;
                squares += off * off;
            }
            const auto many = [&] {
                for (int i = 0; i < timed; ++i) study::keep((scene.*way)(random));
            };
            const double ns = study::once_ns(many, 3) / timed;
            row("light", name, static_cast<double>(distance), "distance / radius",
                std::sqrt(squares / count) / expected, "error of one sample / mean", ns,
                "time per sample / ns");
        }
    }

    // The height of the cap, 1 - cos a.
    using Exact = study::DoubleDouble;
    const auto naive = [](Real radius, Real distance) {
        const Real sine = radius / distance;
        return 1 - std::sqrt(1 - sine * sine);
    };
    const auto height = [&](const char* name, double power, const auto& formula) {
        double largest = 0;
        Rng random{8, 4};
        for (int i = 0; i < 200; ++i) {
            const Real distance = static_cast<Real>(std::pow(10, power)) * random.uniform(1, 2);
            const Exact d = static_cast<double>(distance), one = 1;
            const Exact cosine = sqrt((d - one) * (d + one)) / d;
            largest = std::max(largest,
                               std::min(1e18, study::error_in_ulp(formula(Real(1), distance),
                                                                  one / (d * d) / (one + cosine))));
        }
        Real distance = 2;
        const double ns = study::time_ns(
            [&] {
                study::keep(distance);
                study::keep(formula(Real(1), distance));
            },
            3);
        row("solid-angle", name, std::pow(10, power), "distance / radius", largest,
            "largest error / ulp", ns, "time / ns");
    };
    for (double power = 0.5; power < 9; ++power) {
        height("1 - cos", power, naive);
        height("sin^2 / (1 + cos)", power, cone_height);
    }

    // What each effect costs where it is absent, compiled in but unused, and present. The three are
    // timed in turn, so that what else the machine does slows all of them.
    constexpr int width = 64, rows = 36;
    const auto shader = [&](const SceneDescription& scene, const Effects& effects) {
        return renderer_makers[narrowest(effects, renderer_effects)](scene, width, rows, {4, 8, 1});
    };
    const auto draw = [&](const PixelShader& shade) {
        std::uint64_t rays = 0;
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < width; ++x) study::keep(shade(x, y, rays));
        return rays;
    };
    const SceneDescription matte = scene_with("matte");
    for (const NamedEffect& effect : all_effects) {
        const SceneDescription scene = scene_with(effect.name);
        Effects one;
        one.*effect.member = true;
        const std::array<std::pair<const char*, PixelShader>, 3> variants{
            {{"absent", shader(matte, {})},
             {"compiled in", shader(matte, one)},
             {"present", shader(scene, one)}}};
        std::array<std::vector<double>, 3> times;
        for (int round = 0; round < 7; ++round)
            for (std::size_t i = 0; i < 3; ++i) {
                std::uint64_t rays = 1;
                const double ns = study::once_ns([&] { rays = draw(variants[i].second); }, 1);
                times[i].push_back(ns / static_cast<double>(rays));
            }
        std::array<double, 3> per_ray{};
        for (std::size_t i = 0; i < 3; ++i) {
            std::nth_element(times[i].begin(), times[i].begin() + 3, times[i].end());
            per_ray[i] = times[i][3];
            row("effects", (std::string(effect.name) + ", " + variants[i].first).c_str(),
                static_cast<double>(i), "absent, compiled in, present", per_ray[i] / per_ray[0],
                "times the time without", per_ray[i], "time per ray / ns");
        }
    }

    // The cover scene, end to end, against the classic way.
    const bvh::Cover cover = bvh::make_cover();
    const auto classic = bvh::make_classic(cover);
    const SceneDescription scene = cover_scene(cover);
    const double slow = study::once_ns([&] { study::keep(bvh::render_cover(cover, classic)); }, 1);
    const double fast = study::once_ns(
        [&] {
            const PixelShader shade =
                renderer_makers[narrowest(effects_of(scene), renderer_effects)](
                    scene, cover.width, cover.height, cover.quality);
            Color sum;
            std::uint64_t rays = 0;
            for (int y = 0; y < cover.height; ++y)
                for (int x = 0; x < cover.width; ++x) sum += shade(x, y, rays);
            study::keep(sum);
        },
        3);
    row("cover", "classic", 486, "spheres", 1, "times as fast", slow * 1e-6, "time / ms");
    row("cover", "narrowest renderer", 486, "spheres", slow / fast, "times as fast", fast * 1e-6,
        "time / ms");
}

}  // namespace effects
