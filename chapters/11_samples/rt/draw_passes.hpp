#pragma once
#include <rt/for_each_pixel.hpp>
#include <rt/refinement.hpp>
#include <rt/renderer.hpp>
#include <rt/sobol_samples.hpp>

namespace rt {

// Draws passes with a renderer (given), which must outlive the result. samples_of(pass) returns the
// samples that a pass takes in each pixel. Column 0 of the image is column `left` of the renderer's
// picture.
template <class AnyRenderer, class SamplesOf>
DrawPass draw_passes(const AnyRenderer& renderer, int left, const SamplesOf& samples_of) {
    return [&renderer, left, samples_of](const Tile& tile, const Pass& pass, Image& image,
                                         std::uint64_t& rays) {
        const auto samples = samples_of(pass);
        for_each_pixel(
            tile, [&](int x, int y) { image.at(x, y) = renderer(samples, left + x, y, rays); });
    };
}

// Passes with `count` jittered samples in each pixel.
template <class AnyRenderer>
DrawPass jittered_passes(const AnyRenderer& renderer, int count) {
    return draw_passes(renderer, 0, [count](const Pass& pass) {
        return JitteredSamples{seed_of(pass), count};
    });
}

// The samples of a pass: the next `count` of Sobol's points in each pixel.
inline SobolSamples sobol_samples(const Pass& pass, int count) {
    return {pass.seed, count, static_cast<std::uint32_t>(pass.number * count)};
}

// Passes with the next `count` of Sobol's points in each pixel.
template <class AnyRenderer>
DrawPass sobol_passes(const AnyRenderer& renderer, int count, int left = 0) {
    return draw_passes(renderer, left,
                       [count](const Pass& pass) { return sobol_samples(pass, count); });
}

}  // namespace rt
