// Random numbers from Sobol's sequence, which chapter 11 gives beside its exercises.

#include <algorithm>
#include <density.hpp>
#include <rt/make_camera.hpp>
#include <rt/sobol_samples.hpp>
#include <vector>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color, rt::SobolRandom, rt::SobolSamples, rt::Vec2;

namespace {

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

TEST_CASE("each pair of numbers is one of each box over the samples of a pixel") {
    constexpr std::size_t count = 64;
    for (const std::uint32_t first : {0u, 64u, 640u})
        for (int pixel = 0; pixel < 5; ++pixel) {
            const auto all = draws(7, pixel, 3, first, count, 10);
            for (std::size_t pair = 0; pair < 5; ++pair)
                for (std::size_t columns = 1; columns <= count; columns *= 2) {
                    const std::size_t rows = count / columns;
                    std::vector<int> boxes(count);
                    for (const auto& row : all) {
                        const Real x = row[2 * pair], y = row[2 * pair + 1];
                        REQUIRE((0 <= x && x < 1 && 0 <= y && y < 1));
                        const auto column =
                            static_cast<std::size_t>(x * static_cast<Real>(columns));
                        ++boxes[static_cast<std::size_t>(y * static_cast<Real>(rows)) * columns +
                                column];
                    }
                    CHECK(std::count(boxes.begin(), boxes.end(), 1) == count);
                }
        }
}

TEST_CASE("the pairs of a sample are independent of each other") {
    constexpr std::size_t numbers = 8;
    std::vector<PairCounts> counts(numbers * numbers);
    for (int pixel = 0; pixel < 2000; ++pixel)
        for (const auto& row : draws(1, pixel % 50, pixel / 50, 0, 4, numbers))
            for (std::size_t i = 0; i < numbers; ++i)
                for (std::size_t j = 0; j < i; ++j) counts[i * numbers + j].add(row[i], row[j]);
    for (std::size_t i = 0; i < numbers; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            INFO("numbers " << j << " and " << i);
            CHECK(counts[i * numbers + j].chi_square() < PairCounts::limit());
        }
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
