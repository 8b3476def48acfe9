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
        samples.each(x, y, [&](const auto&... parts) {
            auto [point, random] = add(parts...);
            point = {static_cast<Real>(x),
                     static_cast<Real>(y),
                     {},
                     random_place(random),
                     {infinity, infinity}};
        });
    }
};

}  // namespace rt
