#pragma once
// The group drawn with samples of several kinds.

#include <rt/jitter.hpp>
#include <rt/make_camera.hpp>
#include <rt/path.hpp>
#include <rt/render_pixel.hpp>
#include <vector>

#include "low_discrepancy.hpp"
#include "scene.hpp"

namespace normals_aa {

struct Stage {
    Scene scene = make_scene();
    // A small picture of the middle of the group: bright tops, creases, edges and ground.
    Camera camera = make_camera(group_view(), 16, 9);

    template <Ending AnyEnding, class Random>
    Color sample(int x, int y, Vec2 offset, int depth, const AnyEnding& ending,
                 Random& random) const {
        return path_radiance(make_ray(camera, x, y, offset, random), scene.world, scene.materials,
                             scene.sky, ending, depth, random);
    }
};

using Pixels = std::vector<Color>;

// The picture with every sample independent of the others.
inline Pixels draw_independent(const Stage& stage, int samples, int depth, std::uint64_t seed) {
    Pixels pixels;
    for (int y = 0; y < stage.camera.height; ++y)
        for (int x = 0; x < stage.camera.width; ++x) {
            Rng random = pixel_rng(seed, x, y);
            Color sum;
            for (int i = 0; i < samples; ++i)
                sum += stage.sample(x, y, random_place(random), depth, SkyEnding{}, random);
            pixels.push_back(sum / static_cast<Real>(samples));
        }
    return pixels;
}

// The chapter's own way: the sample points within the pixel are jittered, the bounces are not.
template <Ending AnyEnding>
Pixels draw_jittered(const Stage& stage, const Quality& quality, const AnyEnding& ending) {
    Pixels pixels;
    for (int y = 0; y < stage.camera.height; ++y)
        for (int x = 0; x < stage.camera.width; ++x)
            pixels.push_back(render_pixel(stage.camera, stage.scene.world, stage.scene.materials,
                                          stage.scene.sky, ending, quality, x, y));
    return pixels;
}

// The picture with sample points and bounces from an Owen-scrambled Sobol sequence.
template <Ending AnyEnding>
Pixels draw_low_discrepancy(const Stage& stage, int samples, int depth, std::uint64_t seed,
                            const AnyEnding& ending) {
    Pixels pixels;
    for (int y = 0; y < stage.camera.height; ++y)
        for (int x = 0; x < stage.camera.width; ++x) {
            Color sum;
            for (int i = 0; i < samples; ++i) {
                LowDiscrepancy random{seed, x, y, i};
                sum += stage.sample(x, y, random_place(random), depth, ending, random);
            }
            pixels.push_back(sum / static_cast<Real>(samples));
        }
    return pixels;
}

}  // namespace normals_aa
