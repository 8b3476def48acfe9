// Random numbers from Sobol's sequence, which chapter 11 gives beside its exercises.

#include <algorithm>
#include <array>
#include <cmath>
#include <density.hpp>
#include <rt/make_camera.hpp>
#include <rt/sobol_samples.hpp>
#include <vector>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color, rt::SobolRandom, rt::SobolSamples, rt::Vec2;

namespace {

// Those that belong to one set of points.
constexpr std::size_t numbers = rt::sobol_dimensions;

// The first numbers that each sample draws, one row per sample.
std::vector<std::vector<Real>> draws(std::uint64_t seed, int x, int y, std::uint32_t first,
                                     std::size_t samples, std::size_t count) {
    std::vector<std::vector<Real>> all(samples, std::vector<Real>(count));
    for (auto& row : all) {
        SobolRandom random{seed, x, y, first++};
        for (Real& number : row) number = random.uniform();
    }
    return all;
}

}  // namespace

TEST_CASE("the points of a pixel are one in each box, and each number one in each slice") {
    constexpr std::size_t count = 64;
    for (const std::uint32_t first : {0u, 64u, 640u})
        for (int pixel = 0; pixel < 5; ++pixel) {
            const auto all = draws(7, pixel, 3, first, count, numbers);
            for (std::size_t columns = 1; columns <= count; columns *= 2) {
                const std::size_t rows = count / columns;
                std::vector<int> boxes(count);
                for (const auto& row : all) {
                    REQUIRE((0 <= row[0] && row[0] < 1 && 0 <= row[1] && row[1] < 1));
                    const auto column =
                        static_cast<std::size_t>(row[0] * static_cast<Real>(columns));
                    ++boxes[static_cast<std::size_t>(row[1] * static_cast<Real>(rows)) * columns +
                            column];
                }
                CHECK(std::count(boxes.begin(), boxes.end(), 1) == count);
            }
            for (std::size_t number = 0; number < numbers; ++number) {
                std::vector<int> slices(count);
                for (const auto& row : all)
                    ++slices[static_cast<std::size_t>(row[number] * static_cast<Real>(count))];
                INFO("number " << number);
                CHECK(std::count(slices.begin(), slices.end(), 1) == count);
            }
        }
}

TEST_CASE("any two numbers of a sample are independent of each other") {
    constexpr std::size_t more = numbers + 2;
    std::vector<PairCounts> counts(more * more);
    for (int pixel = 0; pixel < 8000; ++pixel)
        for (const auto& row :
             draws(1, pixel % 50, pixel / 50, static_cast<std::uint32_t>(pixel % 7), 1, more))
            for (std::size_t i = 0; i < more; ++i)
                for (std::size_t j = 0; j < i; ++j) counts[i * more + j].add(row[i], row[j]);
    for (std::size_t i = 0; i < more; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            INFO("numbers " << j << " and " << i);
            CHECK(counts[i * more + j].chi_square() < PairCounts::limit());
        }
}

TEST_CASE("the first eight numbers are spread evenly together") {
    // What two numbers do together and neither does alone: the product of both, each with the mean
    // 0 and the variance 1. Over the samples, its mean has the variance 1 / samples if they are
    // independent. If each pair of numbers is spread evenly for itself, it is 1.35 times that.
    constexpr std::size_t samples = 64;
    const auto centered = [](Real x) { return std::sqrt(12.0) * (static_cast<double>(x) - 0.5); };
    Mean all;
    for (int pixel = 0; pixel < 200; ++pixel) {
        const auto rows = draws(5, pixel, 1, 0, samples, numbers);
        for (std::size_t i = 0; i < numbers; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                double sum = 0;
                for (const auto& row : rows) sum += centered(row[i]) * centered(row[j]);
                all.add(sum * sum / samples);
            }
    }
    INFO("variance, as a multiple of that of independent samples: " << all.mean());
    CHECK(all.mean() < 0.5);
}

TEST_CASE("the columns of the later coordinates begin as their polynomials say") {
    // The odd numbers m of columns 0 to 4, from m(k) = the sum of 2^j a(j) m(k - j), modulo 2, and
    // m(k - degree), worked out by hand.
    constexpr std::array<std::array<std::uint32_t, 5>, 6> odd{{{1, 3, 3, 9, 29},
                                                               {1, 3, 1, 5, 31},
                                                               {1, 1, 1, 11, 31},
                                                               {1, 1, 3, 3, 25},
                                                               {1, 3, 5, 13, 11},
                                                               {1, 1, 5, 5, 17}}};
    for (std::uint32_t dimension = 2; dimension < numbers; ++dimension)
        for (std::size_t k = 0; k < 5; ++k)
            CHECK(rt::sobol_coordinate(dimension, 1u << k) == odd[dimension - 2][k] << (31 - k));
    CHECK(rt::sobol_coordinate(2, 0) == 0);
    CHECK(rt::sobol_coordinate(2, 7) == (0x80000000u ^ 0xc0000000u ^ 0x60000000u));
}

TEST_CASE("other seeds and pixels have other numbers") {
    const auto here = draws(1, 5, 6, 0, 4, 4);
    CHECK(here == draws(1, 5, 6, 0, 4, 4));
    CHECK(here != draws(2, 5, 6, 0, 4, 4));
    CHECK(here != draws(1, 6, 5, 0, 4, 4));
    CHECK(here != draws(1, 5, 7, 0, 4, 4));
}

TEST_CASE("a pixel's samples can be taken in parts") {
    const rt::Camera camera = rt::make_camera({}, 9, 7);
    const auto path = [](const rt::Ray& ray, SobolRandom& random) {
        return Color{ray.direction.x + 1, random.uniform(), random.uniform() * random.uniform()};
    };
    const Color whole = SobolSamples{3, 16, 0}.average(camera, 4, 2, path);
    const Color one = SobolSamples{3, 6, 0}.average(camera, 4, 2, path);
    const Color other = SobolSamples{3, 10, 6}.average(camera, 4, 2, path);
    const Color both = (Real(6) * one + Real(10) * other) / 16;
    const auto is_near = [](Real a, Real b) {
        return std::abs(a - b) <= rt::rounding_bound(40) * b;
    };
    CHECK(is_near(both.r, whole.r));
    CHECK(is_near(both.g, whole.g));
    CHECK(is_near(both.b, whole.b));
}

TEST_CASE("the error of a smooth pixel falls faster than that of independent samples") {
    // The mean of x y over the square is 1/4, and its variance 7/144.
    Mean squares;
    for (int pixel = 0; pixel < 300; ++pixel) {
        double sum = 0;
        for (const auto& row : draws(9, pixel, 0, 0, 64, 2))
            sum += static_cast<double>(row[0]) * static_cast<double>(row[1]);
        const double error = sum / 64 - 0.25;
        squares.add(error * error);
    }
    INFO("mean squared error " << squares.mean() << ", of independent samples " << 7.0 / 144 / 64);
    CHECK(squares.mean() < 7.0 / 144 / 64 / 100);
}
