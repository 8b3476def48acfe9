#pragma once
// The ways to take samples that the studies compare, and functions that draw pictures with them.

#include <array>
#include <rt/draw_passes.hpp>
#include <rt/running_variance.hpp>

namespace samples {

using namespace rt;

// Each sample is anywhere in the pixel, independently of the others.
struct IndependentSamples {
    std::uint64_t seed = 1;
    int count = 1;

    template <class AnyCamera, class Path>
    Color average(const AnyCamera& camera, int column, int row, const Path& path) const {
        return average_samples(seed, column, row, count, [&](int, Rng& random) {
            const Vec2 offset = random_place(random);
            return path(make_ray(camera, column, row, offset, random), random);
        });
    }
};

// Samples of any kind. Their light is also added to `known`, which estimates its variance, channel
// by channel.
template <class Samples>
struct WatchedSamples {
    Samples samples;
    std::array<RunningVariance, 3>& known;

    template <class AnyCamera, class Path>
    Color average(const AnyCamera& camera, int column, int row, const Path& path) const {
        return samples.average(camera, column, row, [&](const auto& ray, auto& random) {
            const Color light = path(ray, random);
            add(known[0], light.r);
            add(known[1], light.g);
            add(known[2], light.b);
            return light;
        });
    }
};

// Draws a whole picture, with these samples in each pixel.
template <class Renderer, class Samples>
Image draw_with(const Renderer& renderer, const Samples& samples, int width, int height) {
    Image image = Canvas<Color>{width, height};
    std::uint64_t rays = 0;
    for_each_pixel({0, 0, width, height},
                   [&](int x, int y) { image.at(x, y) = renderer(samples, x, y, rays); });
    return image;
}

// A refined picture, and its error, estimated from its halves.
struct Refined {
    Image image;
    double error = 0;
};

// Draws a picture in twin halves, with about this many samples per pixel on average. With 16, 64 or
// 256 samples, a pixel gets 16 passes on average, and the pilot takes 8 of them. make_pass(count)
// gives a DrawPass for passes of that many samples.
template <class MakePass>
Refined refine(const TileGrid& grid, std::uint64_t seed, int samples, const MakePass& make_pass) {
    const int count = std::max(1, samples / 16);
    RefinementPlan plan;
    plan.grid = grid;
    plan.seed = seed;
    plan.make_worker = [&] { return make_pass(count); };
    Refinement refinement{std::move(plan)};
    refinement.draw_pilot(samples < 4 ? 1 : std::clamp(samples / count / 4, 2, 4));
    refinement.refine_with(std::int64_t{tile_count(grid)} * samples / count);
    return {refinement.picture(Canvas<Color>{grid.width, grid.height}),
            static_cast<double>(refinement.error())};
}

}  // namespace samples
