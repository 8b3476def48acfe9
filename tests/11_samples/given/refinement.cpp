// Refining a picture: what it costs, what it promises, and that it is not biased.

#include <rt/refinement.hpp>
#include <rt/sample_rng.hpp>
#include <rt/sobol_samples.hpp>

#include "checkpoint.hpp"

namespace {

using namespace rt;

constexpr int width = 24, height = 20, side = 8;

// A picture whose light is known: it gets brighter from left to right, and noisier from tile
// to tile. A pass is the light, several times too bright with a small probability, and
// otherwise a bit too dark.
struct Noise {
    Color mean;
    Real deviation = 0;
};
Noise noise_at(int x, int y) {
    const Real light = static_cast<Real>(x + 1) / width;
    return {{light, light / 2, light / 4}, static_cast<Real>(1 + x / side + 4 * (y / side)) / 8};
}

constexpr Real rare = Real(0.125);

void draw_noise(const Tile& tile, const Pass& pass, Image& image, std::uint64_t& rays) {
    for_each_pixel(tile, [&](int x, int y) {
        Rng random = pixel_rng(seed_of(pass), x, y);
        const auto [mean, deviation] = noise_at(x, y);
        // Of mean 0 and variance 1.
        const Real size = std::sqrt(rare * (1 - rare));
        const auto lot = [&] { return ((random.uniform() < rare ? 1 : 0) - rare) / size; };
        const Real r = lot(), g = lot(), b = lot();
        image.at(x, y) = mean + deviation * Color{r, g, b};
        ++rays;
    });
}

RefinementPlan plan_of_noise(std::uint64_t seed, int threads = 1) {
    return {.grid = {width, height, side}, .threads = threads, .seed = seed, .make_worker = [] {
                return draw_noise;
            }};
}

Image picture_of(const Refinement& refinement) {
    return refinement.picture(Canvas<Color>{width, height});
}

// The mean square distance of a picture from what it should be.
double square_error(const Image& picture) {
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Color off = picture.at(x, y) - noise_at(x, y).mean;
            sum += static_cast<double>(off.r * off.r + off.g * off.g + off.b * off.b);
        }
    return sum / (3 * width * height);
}

}  // namespace

TEST_CASE("refining ends below the error that is asked for and the estimate is true") {
    double estimated = 0, truth = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Refinement refinement{plan_of_noise(seed)};
        refinement.draw_pilot(2);
        refinement.refine_to(Real(0.05));
        const auto error = static_cast<double>(refinement.error());
        REQUIRE(error <= 0.05);
        estimated += error * error;
        truth += square_error(picture_of(refinement));
    }
    // 40 pictures of 1440 numbers: each sum has a standard error of less than 1 %.
    INFO("estimated error / true error: " << std::sqrt(estimated / truth));
    CHECK(std::abs(std::sqrt(estimated / truth) - 1) < 0.04);
}

TEST_CASE("more passes go where there is more noise") {
    Refinement refinement{plan_of_noise(3)};
    refinement.draw_pilot(8);
    refinement.refine_with(9000);
    CHECK(std::abs(refinement.passes() - 9000) <= 2 * 9);
    // The deviation of the last tile is 11 times that of the first.
    const double ratio = static_cast<double>(refinement.passes_at(width - 1, height - 1)) /
                         refinement.passes_at(0, 0);
    INFO("passes of the noisiest tile, of one of the least noisy: " << ratio);
    CHECK(ratio > 8);
    CHECK(ratio < 14);
    CHECK(refinement.rays() >= 9000u * side * (height % side));
}

TEST_CASE("a refined picture is not biased") {
    // Each picture's mean is off by its noise alone, so the mean of many is as near as chance
    // allows.
    constexpr int pictures = 500;
    RunningVariance off;
    for (std::uint64_t seed = 0; seed < pictures; ++seed) {
        RefinementPlan plan = plan_of_noise(1000 + seed);
        plan.grid.tile_size = 1;  // the fewer the numbers that decide, the larger a bias
        Refinement refinement{plan};
        refinement.draw_pilot(2);
        refinement.refine_with(std::int64_t{width} * height * 12);
        const Image picture = picture_of(refinement);
        double sum = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                sum += static_cast<double>(picture.at(x, y).r - noise_at(x, y).mean.r);
        add(off, static_cast<Real>(sum / (width * height)));
    }
    const auto mean = static_cast<double>(off.mean);
    const double error =
        std::sqrt(static_cast<double>(variance(off)) / static_cast<double>(off.count));
    INFO("mean " << mean << " with a standard error of " << error);
    CHECK(std::abs(mean) < 5 * error);  // by chance once in a million
}

TEST_CASE("a refined picture does not depend on the number of threads") {
    const auto refined = [](int threads) {
        Refinement refinement{plan_of_noise(5, threads)};
        refinement.draw_pilot(3);
        refinement.refine_to(Real(0.08));
        return picture_of(refinement);
    };
    const Image expected = refined(1);
    CHECK(refined(2) == expected);
    CHECK(refined(3) == expected);
}

TEST_CASE("refining stops where it is told to") {
    std::atomic<int> asked = 0;
    RefinementPlan plan = plan_of_noise(5);
    plan.is_over = [&] { return ++asked > 4; };
    Refinement refinement{plan};
    refinement.draw_pilot(2);
    refinement.refine_to(Real(1e-3));
    // Four passes were drawn, those of two tiles; the others show what they showed before.
    CHECK(refinement.passes() == 4);
    CHECK(refinement.error() == infinity);
    const Image picture = refinement.picture(Canvas<Color>{width, height, {7, 7, 7}});
    CHECK(picture.at(0, 0).r < 7);
    CHECK(picture.at(width - 1, height - 1).r == 7);
    CHECK(refinement.share() < 0.5);
}

TEST_CASE("a picture without noise takes the pilot and nothing more") {
    RefinementPlan plan = plan_of_noise(1);
    plan.make_worker = [] {
        return [](const Tile& tile, const Pass&, Image& image, std::uint64_t&) {
            for_each_pixel(tile, [&](int x, int y) { image.at(x, y) = {1, 2, 3}; });
        };
    };
    Refinement refinement{plan};
    refinement.draw_pilot(2);
    refinement.refine_to(Real(1e-6));
    CHECK(refinement.passes() == 9 * 4);
    CHECK(picture_of(refinement).at(4, 4) == Color{1, 2, 3});
}

TEST_CASE("numbers from Sobol's points integrate better than random ones") {
    // The mean of a smooth function of five numbers, which are spread evenly.
    const auto square_error = [](auto make) {
        double sum = 0;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            double mean = 0;
            for (int i = 0; i < 64; ++i) {
                auto random = make(seed, i);
                const Real a = random.uniform(), b = random.uniform(), c = random.uniform();
                const Real d = random.uniform(), e = random.uniform();
                mean += static_cast<double>(a * b + c * d * d + e) / 64;
            }
            sum += (mean - 11.0 / 12) * (mean - 11.0 / 12);
        }
        return sum / 400;
    };
    const double random =
        square_error([](std::uint64_t seed, int i) { return sample_rng(seed, 3, 5, i); });
    const double sobol = square_error([](std::uint64_t seed, int i) {
        return SobolRandom{seed, 3, 5, static_cast<std::uint32_t>(i)};
    });
    INFO("mean square errors: random " << random << ", Sobol " << sobol);
    CHECK(sobol < random / 100);
}

TEST_CASE("rare bright samples: a number of passes keeps their light, and a target loses some") {
    // A pass is gray, and one pixel in 2500 passes is much too bright.
    constexpr Real gray = Real(0.5), bright = 25, chance = Real(4e-4);
    constexpr double right = static_cast<double>(gray) + 25 * 4e-4;
    const auto mean_of = [&](const auto& refine) {
        RunningVariance means;
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            RefinementPlan plan;
            plan.grid = {16, 16, 8};
            plan.seed = seed;
            plan.make_worker = [&] {
                return [&](const Tile& tile, const Pass& pass, Image& image, std::uint64_t&) {
                    for_each_pixel(tile, [&](int x, int y) {
                        Rng random = pixel_rng(seed_of(pass), x, y);
                        const Real noise = (random.uniform() - Real(0.5));
                        const Real light =
                            gray + noise + (random.uniform() < chance ? bright : Real(0));
                        image.at(x, y) = {light, light, light};
                    });
                };
            };
            Refinement refinement{plan};
            refinement.draw_pilot(2);
            refine(refinement);
            double sum = 0;
            const Image picture = refinement.picture(Canvas<Color>{16, 16});
            for (const Color& color : picture.pixels()) sum += static_cast<double>(color.g);
            add(means, static_cast<Real>(sum / (16 * 16)));
        }
        return means;
    };
    const auto off = [&](const RunningVariance& means) {
        return static_cast<double>(means.mean) - right;
    };
    const auto error = [](const RunningVariance& means) {
        return std::sqrt(static_cast<double>(variance(means)) / static_cast<double>(means.count));
    };
    const RunningVariance fixed =
        mean_of([](Refinement& refinement) { refinement.refine_with(4 * 12); });
    const RunningVariance stopped =
        mean_of([](Refinement& refinement) { refinement.refine_to(Real(0.2)); });
    INFO("off by " << off(fixed) << " +- " << error(fixed) << " with a number of passes, by "
                   << off(stopped) << " +- " << error(stopped) << " with a target");
    CHECK(std::abs(off(fixed)) < 5 * error(fixed));
    // A quarter of it or more.
    CHECK(off(stopped) < -0.0025);
}
