#pragma once
#include <cstdint>
#include <rt/color_sum.hpp>
#include <rt/render_pixel.hpp>
#include <rt/rng.hpp>
#include <rt/sobol.hpp>

namespace rt {

// The random numbers of one sample of a pixel (given), for use wherever an Rng is used. The first
// two are a point of Sobol's sequence, the next two a point of another shuffling of it, and so on.
// Over all samples of the pixel, each pair of numbers is spread evenly, and is independent of the
// other pairs. Source: Burley, "Practical hash-based Owen scrambling", JCGT 2020.
class SobolRandom {
  public:
    SobolRandom(std::uint64_t seed, int x, int y, std::uint32_t sample) : sample_{sample} {
        const auto pixel = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x);
        pixel_ = mix_bits(mix_bits(seed) ^ pixel);
    }

    // A number in [0, 1), like Rng::uniform.
    Real uniform() {
        if (has_second_) {
            has_second_ = false;
            return fraction(second_);
        }
        const std::uint64_t pair = mix_bits(pixel_ + ++pair_), scramble = mix_bits(pair);
        // The order of the points is shuffled, too, so that pairs are not correlated. Scrambling
        // takes 2^m neighbors to 2^m neighbors, which are just as evenly spread.
        const FixedPoint2 point =
            sobol_point(owen_scrambled(sample_, static_cast<std::uint32_t>(pair)));
        second_ = owen_scrambled(point.y, static_cast<std::uint32_t>(scramble >> 32));
        has_second_ = true;
        return fraction(owen_scrambled(point.x, static_cast<std::uint32_t>(scramble)));
    }

    // A number in [low, high).
    Real uniform(Real low, Real high) { return low + (high - low) * uniform(); }

  private:
    static Real fraction(std::uint32_t bits) {
        if constexpr (std::numeric_limits<Real>::digits <= 32)
            return static_cast<Real>(bits >> (32 - std::numeric_limits<Real>::digits)) *
                   (epsilon / 2);
        else
            return static_cast<Real>(bits) / 4294967296;
    }

    std::uint64_t pixel_ = 0, pair_ = 0;
    std::uint32_t sample_ = 0, second_ = 0;
    bool has_second_ = false;
};

// Samples of a pixel from Sobol's sequence (given): numbers first ... first + count - 1 of the
// sequence that belongs to the seed and the pixel. See JitteredSamples.
struct SobolSamples {
    std::uint64_t seed = 1;
    int count = 1;
    std::uint32_t first = 0;

    template <class AnyCamera, class Path>
    Color average(const AnyCamera& camera, int column, int row, const Path& path) const {
        ColorSum sum;
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
            SobolRandom random{seed, column, row, first + i};
            const Vec2 offset = random_place(random);
            sum.add(path(make_ray(camera, column, row, offset, random), random));
        }
        return sum.mean(count);
    }
};

}  // namespace rt
