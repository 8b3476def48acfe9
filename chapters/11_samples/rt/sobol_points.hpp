#pragma once
#include <rt/batch_renderer.hpp>
#include <rt/sobol_samples.hpp>

namespace rt {

// SobolSamples (given) for chapter 10's batches: see JitteredPoints.
struct SobolPoints {
    using Random = SobolRandom;
    SobolSamples samples;

    int count() const { return samples.count; }
    static constexpr int cells() { return 1; }

    template <class Add>
    void each(int x, int y, const Add& add) const {
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(samples.count); ++i) {
            SobolRandom random{samples.seed, x, y, samples.first + i};
            const Vec2 place = random_place(random);
            add(
                SamplePoint{
                    static_cast<Real>(x), static_cast<Real>(y), {}, place, {infinity, infinity}},
                random);
        }
    }
};

}  // namespace rt
