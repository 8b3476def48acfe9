// What two halves know about a picture without its noise.

#include "../../../chapters/11_samples/denoise_halves.hpp"

#include <rt/rng.hpp>

#include "checkpoint.hpp"

namespace {

using namespace rt;

constexpr int width = 48, height = 40;

// A wall whose left half is even and whose right half has stripes that are no feature. A half of
// the picture is that, with noise.
Color wall(int x, int y) {
    const Real light = x < width / 2 ? Real(0.5) : y / 3 % 2 == 0 ? Real(0.2) : Real(0.8);
    return {light, light, light / 2};
}
Image drawn(std::uint64_t seed) {
    Image image = Canvas<Color>{width, height};
    for_each_pixel({0, 0, width, height}, [&](int x, int y) {
        Rng random = pixel_rng(seed, x, y);
        const auto noise = [&] { return random.uniform(Real(-0.2), Real(0.2)); };
        const Real r = noise(), g = noise(), b = noise();
        image.at(x, y) = wall(x, y) + Color{r, g, b};
    });
    return image;
}
Canvas<Features> one_surface() {
    Canvas<Features> features{width, height};
    for (Features& feature : features) feature = {{1, 1, 1}, {0, 0, 1}};
    return features;
}

double square_error(const Image& picture) {
    double sum = 0;
    for_each_pixel({0, 0, width, height}, [&](int x, int y) {
        const Color off = picture.at(x, y) - wall(x, y);
        sum += static_cast<double>(off.r * off.r + off.g * off.g + off.b * off.b);
    });
    return sum / (3 * width * height);
}

}  // namespace

TEST_CASE("two halves know the error of a filtered picture") {
    const Canvas<Features> features = one_surface();
    double estimated = 0, truth = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Halves<Image> half{drawn(2 * seed), drawn(2 * seed + 1)};
        const Halves<Image> filtered{denoised(half.first, features, {}),
                                     denoised(half.second, features, {})};
        Image mean = Canvas<Color>{width, height};
        for_each_pixel({0, 0, width, height}, [&](int x, int y) {
            for (const auto channel : {&Color::r, &Color::g, &Color::b}) {
                const Halves<Real> light{half.first.at(x, y).*channel,
                                         half.second.at(x, y).*channel};
                const Halves<Real> smooth{filtered.first.at(x, y).*channel,
                                          filtered.second.at(x, y).*channel};
                mean.at(x, y).*channel = twin_mean(smooth);
                estimated += static_cast<double>(samples::filtered_square_error(light, smooth));
            }
        });
        truth += square_error(mean) * 3 * width * height;
    }
    INFO("estimated error / true error: " << std::sqrt(estimated / truth));
    CHECK(std::abs(std::sqrt(estimated / truth) - 1) < 0.02);
}

TEST_CASE("the width that the halves choose errs less than any one width") {
    const Canvas<Features> features = one_surface();
    double chosen = 0, said = 0, noisy = 0, usual = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Halves<Image> half{drawn(2 * seed), drawn(2 * seed + 1)};
        Image mean = Canvas<Color>{width, height};
        for_each_pixel({0, 0, width, height}, [&](int x, int y) {
            mean.at(x, y) = (half.first.at(x, y) + half.second.at(x, y)) / 2;
        });
        const samples::Denoised best = samples::denoise_halves(half, features);
        chosen += square_error(best.picture);
        said += std::pow(static_cast<double>(best.error), 2);
        noisy += square_error(mean);
        usual += square_error(denoised(mean, features, {}));
    }
    INFO("square errors: noisy " << noisy << ", usual width " << usual << ", chosen " << chosen
                                 << ", of which the halves say " << said);
    CHECK(chosen < 0.75 * noisy);
    CHECK(chosen < 0.75 * usual);
    // The choice prefers what looks good by chance.
    CHECK(said < 1.05 * chosen);
    CHECK(said > 0.7 * chosen);
}

TEST_CASE("a picture without noise stays as it is") {
    const Image wall_itself = [] {
        Image image = Canvas<Color>{width, height};
        for_each_pixel({0, 0, width, height}, [&](int x, int y) { image.at(x, y) = wall(x, y); });
        return image;
    }();
    const auto [picture, error] =
        samples::denoise_halves({wall_itself, wall_itself}, one_surface());
    CHECK(square_error(picture) < 1e-5);
    CHECK(error < Real(0.01));
}
