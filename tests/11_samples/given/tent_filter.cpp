// The tent filter: each sample is shared by the pixels around it.

#include <rt/make_camera.hpp>
#include <rt/tent_filter.hpp>

#include "checkpoint.hpp"

namespace {

using namespace rt;

constexpr int width = 23, height = 17;

// Light that depends on the ray alone, or on the random numbers, too.
template <bool noisy>
struct Painter {
    Camera camera = make_camera({}, width, height);

    template <class Samples>
    Color operator()(const Samples& samples, int column, int row, std::uint64_t& rays) const {
        return samples.average(camera, column, row, [&](const Ray& ray, auto& random) {
            ++rays;
            // Numbers after the first ones of a sample are independent of each other.
            for (std::uint32_t i = 2; noisy && i < sobol_dimensions; ++i) random.uniform();
            const Real light = noisy ? random.uniform() : Real(2);
            return Color{light, light + ray.direction.x, light - ray.direction.y};
        });
    }
};

template <bool noisy>
Image filtered(int side, int samples, std::uint64_t seed = 1) {
    Image image = Canvas<Color>{width, height};
    std::uint64_t rays = 0;
    for (int y = 0; y < height; y += side)
        for (int x = 0; x < width; x += side)
            draw_with_tent(Painter<noisy>{}, SobolSamples{seed, samples},
                           {x, y, std::min(x + side, width), std::min(y + side, height)}, image,
                           rays);
    return image;
}

}  // namespace

TEST_CASE("a filtered picture does not depend on its tiles") {
    const Image expected = filtered<true>(64, 5);
    for (const int side : {1, 4, 16}) CHECK(filtered<true>(side, 5) == expected);
}

TEST_CASE("only samples that count for a pixel of the tile are followed") {
    Image image = Canvas<Color>{width, height};
    std::uint64_t rays = 0;
    constexpr int samples = 64;  // a quarter of them in each quarter of a pixel
    draw_with_tent(Painter<false>{}, SobolSamples{1, samples}, {7, 5, 8, 6}, image, rays);
    // All of the pixel itself, half of four neighbors, and a quarter of four more.
    CHECK(rays == 4 * samples);
}

TEST_CASE("even light stays as it is, up to the border") {
    const Image image = filtered<false>(8, 3);
    for (const Color& color : image.pixels()) CHECK(std::abs(color.r - 2) < 8 * epsilon);
}

TEST_CASE("a filtered pixel has the mean of a tent around its middle") {
    // Light that grows evenly stays the same, whatever even filter averages it.
    const Image image = filtered<false>(8, 1024);
    const Camera camera = make_camera({}, width, height);
    for (int y = 1; y < height; y += 5)
        for (int x = 1; x < width; x += 7) {
            const Vec3 middle = primary_ray(camera, x, y, {Real(0.5), Real(0.5)}).direction;
            CHECK(std::abs(image.at(x, y).g - 2 - middle.x) < Real(0.002));
            CHECK(std::abs(image.at(x, y).b - 2 + middle.y) < Real(0.002));
        }
}

TEST_CASE("a tent leaves four ninths of the noise's variance") {
    // The mean square of its weights: twice the integral of (1 - x)^2, which is 2/3, for x and y.
    double squares = 0;
    constexpr int pictures = 60, samples = 64;
    for (std::uint64_t seed = 1; seed <= pictures; ++seed) {
        const Image image = filtered<true>(32, samples, seed);
        for (const Color& color : image.pixels())
            squares += std::pow(static_cast<double>(color.r) - 0.5, 2) / (width * height);
    }
    const double share = squares / pictures * 12 * samples;
    INFO("variance, as a share of that of independent samples in a box: " << share);
    CHECK(std::abs(share - 4.0 / 9) < 0.03);
}
