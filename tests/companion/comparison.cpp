#include <companion/compare/comparison.hpp>
#include <rt/rng.hpp>

#include "catch.hpp"

using companion::Comparison;
using companion::Picture;
using companion::TwoPrograms;

namespace {

constexpr int width = 96, height = 64;

// A synthetic program: light(x, y, random) is one sample of a pixel's gray light; `samples` of them
// are averaged.
template <class Light>
auto program(Light light, int samples = 4) {
    return [=](std::uint64_t seed) {
        Picture picture{width, height};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                rt::Rng random = rt::pixel_rng(seed, x, y);
                rt::Real sum = 0;
                for (int i = 0; i < samples; ++i) sum += light(x, y, random);
                const auto byte = rt::to_byte(sum / static_cast<rt::Real>(samples));
                picture.bytes.insert(picture.bytes.end(), {byte, byte, byte});
            }
        return picture;
    };
}

// Skewed noise, as light has it: mostly dark, seldom bright; calm on the left, still at the top.
rt::Real noisy(int x, int y, rt::Rng& random) {
    if (y < 16) return rt::Real(0.3);
    const rt::Real u = random.uniform();
    return rt::Real(0.2) + rt::Real(0.4) * u * u * u * u * static_cast<rt::Real>(x) / width;
}

// The same noise from other numbers of the generator.
rt::Real other_order(int x, int y, rt::Rng& random) {
    random();
    return noisy(x, y, random);
}

bool says(const Comparison& found, const std::string& part) {
    for (const std::string& line : found.words())
        if (line.find(part) != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE("equal code draws the same picture bit for bit", "[comparison]") {
    const auto found = companion::compare({program(noisy), program(noisy), true});
    CHECK(found.same);
    CHECK(found.bit_for_bit);
}

TEST_CASE("random numbers in another order are the same within noise", "[comparison]") {
    const auto found = companion::compare({program(other_order), program(noisy), true});
    CHECK(found.same);
    CHECK_FALSE(found.bit_for_bit);
    CHECK(says(found, "same within the noise"));
}

TEST_CASE("right programs are seldom called wrong", "[comparison]") {
    int alarms = 0;
    const int runs = 100;
    for (int run = 0; run < runs; ++run)
        alarms += !companion::compare({program(other_order), program(noisy), true},
                                      static_cast<std::uint64_t>(100 + run))
                       .same;
    // One in a thousand is expected: two in a hundred would happen once in 200 times.
    CHECK(alarms <= 1);
}

TEST_CASE("a part that is a little too dark is found and named", "[comparison]") {
    const auto darker = [](int x, int y, rt::Rng& random) {
        const bool lower_left = x < width / 3 && y >= 2 * height / 3;
        return noisy(x, y, random) * (lower_left ? rt::Real(0.97) : 1);
    };
    const auto found = companion::compare({program(darker), program(noisy), true});
    CHECK_FALSE(found.same);
    INFO(found.words().back());
    CHECK((says(found, "lower left: 2.") || says(found, "lower left: 3.")));
    CHECK(says(found, "% too dark"));
}

TEST_CASE("samples that are all alike are found by their noise", "[comparison]") {
    const auto found = companion::compare({program(noisy, 1), program(noisy, 4), true});
    CHECK_FALSE(found.same);
    CHECK(found.pixel_noise_differs);
}

TEST_CASE("pixels that make up for each other in a tile are found", "[comparison]") {
    const auto checkered = [](int x, int y, rt::Rng& random) {
        return noisy(x, y, random) +
               ((x + y) % 2 ? rt::Real(0.02) : rt::Real(-0.02)) * (y >= 16 && x >= 48);
    };
    const auto found = companion::compare({program(checkered), program(noisy), true});
    CHECK_FALSE(found.same);
    CHECK(found.pixels_differ);
}

TEST_CASE("a still part that differs is found, whatever the noise beside it", "[comparison]") {
    const auto brighter = [](int x, int y, rt::Rng& random) {
        return noisy(x, y, random) + (y < 4 && x < 48 ? rt::Real(0.01) : 0);
    };
    const auto found = companion::compare({program(brighter), program(noisy), true});
    CHECK_FALSE(found.same);
    CHECK(found.statistics.still_differing == 4 * 48);
}

TEST_CASE("without chance one pixel in a thousand may differ", "[comparison]") {
    Picture solution{100, 30, std::vector<std::uint8_t>(9000, 100)};
    Picture mine = solution;
    for (std::uint8_t& byte : mine.bytes) byte = 101;  // a step is rounding
    CHECK(companion::compare_still(mine, solution).same);
    for (const std::size_t pixel : {7u, 1000u, 2999u}) mine.bytes[3 * pixel + 1] = 150;
    const auto three = companion::compare_still(mine, solution);
    CHECK(three.same);
    CHECK(three.statistics.still_differing == 3);
    mine.bytes[0] = 103;
    const auto four = companion::compare_still(mine, solution);
    CHECK_FALSE(four.same);
    CHECK(four.words()[1].find("4 of 3000 pixels") == 0);
}

TEST_CASE("pictures of different sizes are different", "[comparison]") {
    const Picture wide{2, 1, {0, 0, 0, 0, 0, 0}}, high{1, 2, {0, 0, 0, 0, 0, 0}};
    const auto found = companion::compare_still(wide, high);
    CHECK_FALSE(found.same);
    CHECK(says(found, "2x1"));
}
