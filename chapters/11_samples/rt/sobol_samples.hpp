#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <rt/color_sum.hpp>
#include <rt/render_pixel.hpp>
#include <rt/rng.hpp>
#include <rt/sobol.hpp>
#include <rt/sobol_columns.hpp>
#include <rt/tile.hpp>

namespace rt {

// The random numbers of one sample of a pixel (given). A SobolRandom can be used wherever an Rng is
// used. The first eight numbers are a point of Sobol's sequence in eight dimensions, with each
// coordinate scrambled on its own, and differently in each pixel. So the samples of a pixel are
// evenly spread over the pixel, the lens, the time and the directions of the first bounces, and
// over combinations of these, too. Later numbers are independent, because there, even spacing
// hardly gains anything.
//
// A single sample is as random as with an Rng, so the mean is unbiased. But the samples are not
// independent of each other: in each of the eight numbers, samples 2 j and 2 j + 1 are in opposite
// halves of [0, 1). The gain is greatest with 8, 16, 32 ... samples. Source of the scrambling of
// each coordinate: Burley, "Practical hash-based Owen scrambling", JCGT 2020.
class SobolRandom {
  public:
    // The scrambling of one pixel's numbers.
    struct Pixel {
        std::uint64_t key;
        SobolCoordinates seeds{};

        Pixel(std::uint64_t seed, int x, int y) : key{pixel_state(seed, x, y)} {
            for (std::uint32_t number = 0; number < sobol_dimensions; ++number)
                seeds[number] = high_half(mix_bits(key + number));
        }
    };

    // The numbers of one sample of this pixel; `point` is the sample's point of the sequence.
    SobolRandom(const Pixel& pixel, std::uint32_t sample, const SobolCoordinates& point)
        : pixel_{pixel.key}, sample_{sample} {
        // The processor scrambles all eight numbers at once. This takes less time than scrambling
        // only those that a path draws, one by one.
#pragma omp simd
        for (std::size_t i = 0; i < sobol_dimensions; ++i)
            first_[i] = fraction(owen_scrambled(point[i], pixel.seeds[i]));
    }
    SobolRandom(std::uint64_t seed, int x, int y, std::uint32_t sample)
        : SobolRandom{Pixel{seed, x, y}, sample, SobolTable::get()[sample]} {}

    // A number in [0, 1), like Rng::uniform.
    Real uniform() {
        const std::uint32_t number = number_++;
        if (number < sobol_dimensions) return first_[number];
        return fraction(high_half(mix_bits(mix_bits(pixel_ + number) + sample_)));
    }

    // A number in [low, high); rounding can make it equal to high, as in Rng.
    Real uniform(Real low, Real high) {
        return low + (high - low) * uniform();
    }

  private:
    static std::uint32_t high_half(std::uint64_t bits) {
        return static_cast<std::uint32_t>(bits >> 32);
    }
    static Real fraction(std::uint32_t bits) {
        if constexpr (std::numeric_limits<Real>::digits <= 32)
            return static_cast<Real>(bits >> (32 - std::numeric_limits<Real>::digits)) *
                   (epsilon / 2);
        else
            return static_cast<Real>(bits) / 4294967296;
    }

    std::array<Real, sobol_dimensions> first_{};
    std::uint64_t pixel_ = 0;
    std::uint32_t sample_ = 0, number_ = 0;
};

// The first of the two pixels in a row whose middles a sample lies between: -1 for the pixel to the
// left of the sample's own, or 0 for its own. The same holds for the two pixels in a column.
inline int first_of_two(Real offset) {
    return offset < Real(0.5) ? -1 : 0;
}

// Samples of a pixel from Sobol's sequence (given): points first ... first + count - 1 of the
// sequence, scrambled for this seed and pixel. See JitteredSamples.
struct SobolSamples {
    std::uint64_t seed = 1;
    int count = 1;
    std::uint32_t first = 0;
    // If set, only the samples that a tent lets count for a pixel of this tile: those less than one
    // pixel from its middle, both across and down.
    std::optional<Tile> near{};

    // Calls visit(parts...) for each sample of a pixel, with the arguments that make its
    // SobolRandom.
    template <class Visit>
    void each(int column, int row, const Visit& visit) const {
        const SobolRandom::Pixel pixel{seed, column, row};
        const SobolTable& points = SobolTable::get();
        const bool all = !near || contains(*near, column, row);
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i)
            if (all || is_near(column, row, {pixel, first + i, points[first + i]}))
                visit(pixel, first + i, points[first + i]);
    }
    // Calls keep(offset, light) for each sample: `offset` is its position in the pixel, and `light`
    // is the result of path(ray, random).
    template <class AnyCamera, class Path, class Keep>
    void each(const AnyCamera& camera, int column, int row, const Path& path,
              const Keep& keep) const {
        each(column, row, [&](const auto&... parts) {
            SobolRandom random{parts...};
            const Vec2 offset = random_place(random);
            keep(offset, path(make_ray(camera, column, row, offset, random), random));
        });
    }
    template <class AnyCamera, class Path>
    Color average(const AnyCamera& camera, int column, int row, const Path& path) const {
        ColorSum sum;
        each(camera, column, row, path, [&](Vec2, const Color& light) { sum.add(light); });
        return sum.mean(count);
    }

  private:
    bool is_near(int column, int row, SobolRandom random) const {
        const Vec2 offset = random_place(random);
        const int left = column + first_of_two(offset.x), top = row + first_of_two(offset.y);
        return left + 1 >= near->left && left < near->right && top + 1 >= near->top &&
               top < near->bottom;
    }
};

}  // namespace rt
