#pragma once
#include <cstdint>
#include <rt/jitter.hpp>
#include <rt/path.hpp>
#include <rt/primary_ray.hpp>
#include <rt/rng.hpp>
#include <rt/world.hpp>

namespace rt {

// How much work goes into a picture, and the seed of everything random in it.
struct Quality {
    int samples_per_pixel = 1;
    int depth = 1;  // the maximum number of bounces of a path
    std::uint64_t seed = 1;
};

// The ray of a camera through a point of a pixel (given). Cameras of other types bring their own
// make_ray; the one for a camera with a lens uses `random` to choose a point on the lens.
template <class Random>
Ray make_ray(const Camera& camera, int column, int row, Vec2 offset, Random& /*random*/) {
    return primary_ray(camera, column, row, offset);
}

// The color of one pixel (given): the light along the path of each sample, averaged. The color
// depends on the arguments alone. The types are those of path_radiance.
template <class AnyCamera, World AnyWorld, class Materials, class Sky, Ending AnyEnding>
Color render_pixel(const AnyCamera& camera, const AnyWorld& world, const Materials& materials,
                   const Sky& sky, const AnyEnding& ending, const Quality& quality, int column,
                   int row) {
    Rng random = pixel_rng(quality.seed, column, row);
    return pixel_average(quality.samples_per_pixel, random, [&](Vec2 offset) {
        return path_radiance(make_ray(camera, column, row, offset, random), world, materials, sky,
                             ending, quality.depth, random);
    });
}

}  // namespace rt
