#pragma once
#include <rt/false_color_image.hpp>
#include <rt/length.hpp>
#include <rt/shown_pixel.hpp>

namespace rt {

// A world whose hits carry, in place of a material, the number of the sphere that was hit (given).
template <class World>
struct NumberedWorld {
    const World& world;
    const std::vector<SceneSphere>& spheres;

    std::optional<Hit> hit(const Ray& ray, Interval within) const {
        std::optional<Hit> found = world.hit(ray, within);
        if (!found) return {};
        // Whatever type the world has, the point lies on the surface of the sphere that was hit.
        const auto distance = [&](const SceneSphere& sphere) {
            return std::abs(length(found->point - sphere.shape.center) - sphere.shape.radius);
        };
        Real nearest = infinity;
        for (std::size_t i = 0; i < spheres.size(); ++i)
            if (const Real now = distance(spheres[i]); now < nearest) {
                nearest = now;
                found->material = static_cast<int>(i);
            }
        return found;
    }
};

// The picture that --show asks for, drawn by a tracer that follows paths (given). The arguments are
// the call, the scene and those of render_pixel.
template <class AnyCamera, class World, class Materials, class Sky>
Image shown_image(const TracerCall& call, const SceneText& scene, const AnyCamera& camera,
                  const World& world, const Materials& materials, const Sky& sky,
                  const Quality& quality) {
    expect(call.show != "samples" || quality.samples_per_pixel > 1, "2 samples or more to compare");
    const auto path = [&](const Ray& ray, const auto& counting, Rng& random) {
        return path_radiance(ray, counting, materials, sky, BlackEnding{}, quality.depth, random);
    };
    const NumberedWorld<World> numbered{world, scene.spheres};
    return false_color_image(call, scene, [&](int x, int y) {
        const auto shown = [&](const auto& any_world) {
            return shown_pixel(call.show, camera, any_world, path, quality.samples_per_pixel,
                               quality.seed, x, y);
        };
        return call.show == "sphere" ? shown(numbered) : shown(world);
    });
}

}  // namespace rt
