#pragma once
#include <rt/false_color_image.hpp>
#include <rt/shown_pixel.hpp>

namespace rt {

// The picture that --show asks for, drawn by a tracer that follows paths (given). The arguments are
// the call, the scene and those of render_pixel.
template <class AnyCamera, World AnyWorld, class Materials, class Sky>
Image shown_image(const TracerCall& call, const SceneText& scene, const AnyCamera& camera,
                  const AnyWorld& world, const Materials& materials, const Sky& sky,
                  const Quality& quality) {
    expect(call.show != "samples" || quality.samples_per_pixel > 1, "2 samples or more to compare");
    const auto path = [&](const Ray& ray, const auto& counting, Rng& random) {
        return path_radiance(ray, counting, materials, sky, BlackEnding{}, quality.depth, random);
    };
    return false_color_image(call, scene, [&](int x, int y) {
        return shown_pixel(call.show, camera, world, path, quality.samples_per_pixel, quality.seed,
                           x, y);
    });
}

}  // namespace rt
