#pragma once
// Three renderers written by hand, each for one scene alone, as somebody would write them who
// has never heard of any other effect: no templates, no variants, no list of renderers. They
// draw the same pictures.

#include <rt/dielectric.hpp>
#include <rt/jitter.hpp>
#include <rt/leave_surface.hpp>
#include <rt/lens_ray.hpp>
#include <rt/make_camera.hpp>
#include <rt/metal.hpp>
#include <rt/primary_ray.hpp>
#include <rt/rng.hpp>
#include <rt/sample_rng.hpp>
#include <rt/scene.hpp>
#include <rt/wide_builder.hpp>

namespace by_hand {

using namespace rt;

struct Picture {
    int width, height, samples, depth;
    std::uint64_t seed;
};

inline WideTree tree_of(const SceneDescription& scene) {
    std::vector<SceneSphere> spheres;
    for (const SphereDescription& sphere : scene.spheres)
        spheres.push_back({sphere.shape, sphere.material});
    return make_wide_tree(spheres);
}

// Matte spheres, a pinhole and the sky.
struct Matte {
    Camera camera;
    WideTree world;
    std::vector<Color> albedos;
    GradientSky sky;
    Picture picture;

    Matte(const SceneDescription& scene, const Picture& p)
        : camera{make_camera(scene.camera.view, p.width, p.height)},
          world{tree_of(scene)},
          sky{scene.sky},
          picture{p} {
        for (const MaterialDescription& material : scene.materials)
            albedos.push_back(std::get<Lambertian>(material).albedo);
    }

    Color radiance(Ray ray, Rng& random) const {
        Color throughput{1, 1, 1};
        for (int bounces = 0; bounces < picture.depth; ++bounces) {
            const auto hit = world.hit(ray, {0, infinity});
            if (!hit) break;
            throughput *= albedos[static_cast<std::size_t>(hit->material)];
            const Vec3 direction = cosine_direction(facing_normal(*hit), random_place(random));
            ray = {leave_surface(*hit, direction), direction};
        }
        return throughput * sky(ray.direction);
    }
    Color operator()(int x, int y) const {
        Rng places = pixel_rng(picture.seed, x, y);
        int sample = 0;
        return pixel_average(picture.samples, places, [&](Vec2 offset) {
            Rng random = sample_rng(picture.seed, x, y, sample++);
            return radiance(primary_ray(camera, x, y, offset), random);
        });
    }
};

// Matte and metal spheres, a pinhole and the sky.
struct MatteAndMetal {
    enum Kind { matte, mirror, rough };
    struct Material {
        Color albedo;
        Kind kind = matte;
        Real fuzz = 0;
    };
    Camera camera;
    WideTree world;
    std::vector<Material> materials;
    GradientSky sky;
    Picture picture;

    MatteAndMetal(const SceneDescription& scene, const Picture& p)
        : camera{make_camera(scene.camera.view, p.width, p.height)},
          world{tree_of(scene)},
          sky{scene.sky},
          picture{p} {
        for (const MaterialDescription& material : scene.materials) {
            if (const auto* const m = std::get_if<Metal>(&material))
                materials.push_back({m->albedo, m->fuzz == 0 ? mirror : rough, m->fuzz});
            else
                materials.push_back({std::get<Lambertian>(material).albedo});
        }
    }

    Color radiance(Ray ray, Rng& random) const {
        Color throughput{1, 1, 1};
        for (int bounces = 0; bounces < picture.depth; ++bounces) {
            const auto hit = world.hit(ray, {0, infinity});
            if (!hit) break;
            const Material& material = materials[static_cast<std::size_t>(hit->material)];
            const Vec3 normal = facing_normal(*hit);
            Vec3 direction;
            if (material.kind == matte)
                direction = cosine_direction(normal, random_place(random));
            else if (material.kind == mirror)
                direction = above_horizon(reflect(ray.direction, normal), normal);
            else
                direction =
                    metal_direction(ray.direction, normal, material.fuzz, random_place(random));
            throughput *= material.albedo;
            ray = {leave_surface(*hit, direction), direction};
        }
        return throughput * sky(ray.direction);
    }
    Color operator()(int x, int y) const {
        Rng places = pixel_rng(picture.seed, x, y);
        int sample = 0;
        return pixel_average(picture.samples, places, [&](Vec2 offset) {
            Rng random = sample_rng(picture.seed, x, y, sample++);
            return radiance(primary_ray(camera, x, y, offset), random);
        });
    }
};

// Matte and glass spheres, a lens and the sky.
struct GlassAndLens {
    struct Material {
        Color albedo;
        Real index = 0;  // 0 where it is matte
    };
    Camera camera;
    Lens lens;
    WideTree world;
    std::vector<Material> materials;
    GradientSky sky;
    Picture picture;

    GlassAndLens(const SceneDescription& scene, const Picture& p)
        : camera{make_camera(scene.camera.view, p.width, p.height)},
          lens{scene.camera.lens},
          world{tree_of(scene)},
          sky{scene.sky},
          picture{p} {
        for (const MaterialDescription& material : scene.materials) {
            if (const auto* const glass = std::get_if<Dielectric>(&material))
                materials.push_back({{}, glass->index});
            else
                materials.push_back({std::get<Lambertian>(material).albedo});
        }
    }

    Color radiance(Ray ray, Rng& random) const {
        Color throughput{1, 1, 1};
        for (int bounces = 0; bounces < picture.depth; ++bounces) {
            const auto hit = world.hit(ray, {0, infinity});
            if (!hit) break;
            const Material& material = materials[static_cast<std::size_t>(hit->material)];
            Vec3 direction;
            if (material.index > 0) {
                direction = scatter_at_glass(material.index, fresnel_reflectance, ray.direction,
                                             *hit, random)
                                .direction;
            } else {
                direction = cosine_direction(facing_normal(*hit), random_place(random));
                throughput *= material.albedo;
            }
            ray = {leave_surface(*hit, direction), direction};
        }
        return throughput * sky(ray.direction);
    }
    Color operator()(int x, int y) const {
        Rng places = pixel_rng(picture.seed, x, y);
        int sample = 0;
        return pixel_average(picture.samples, places, [&](Vec2 offset) {
            Rng random = sample_rng(picture.seed, x, y, sample++);
            return radiance(lens_ray(camera, lens, x, y, offset, random_place(random)), random);
        });
    }
};

}  // namespace by_hand
