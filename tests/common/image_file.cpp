#include <stb_image.h>

#include <rt/image_file.hpp>

#include "checkpoint.hpp"

using checkpoint::Real;
using rt::Color;
using rt::Image;

namespace {

// The bytes of a decoded image, row by row.
std::vector<int> decode(const std::string& file, int& width, int& height) {
    int channels = 0;
    stbi_uc* const pixels =
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()),
                              static_cast<int>(file.size()), &width, &height, &channels, 0);
    REQUIRE(pixels);
    CHECK(channels == 3);
    const std::vector<int> bytes(pixels, pixels + width * height * channels);
    stbi_image_free(pixels);
    return bytes;
}

// Every byte value occurs, and no two rows or columns are the same.
Image test_image() {
    return rt::make_image(61, 43, [](int x, int y) {
        const auto hex = static_cast<std::uint32_t>((x * 4 % 256) << 16 | (y * 5 % 256) << 8 |
                                                    ((x * 7 + y * 13) % 256));
        return rt::from_hex(hex);
    });
}

void check_decoded(const std::string& file) {
    const Image image = test_image();
    int width = 0, height = 0;
    const std::vector<int> bytes = decode(file, width, height);
    CHECK(width == image.width());
    CHECK(height == image.height());
    std::vector<int> expected;
    for (const Color& c : image.pixels())
        for (const Real channel : {c.r, c.g, c.b}) expected.push_back(rt::to_byte(channel));
    CHECK(bytes == expected);
}

}  // namespace

TEST_CASE("a PNG file holds the image, as another program reads it", "[image_file]") {
    check_decoded(rt::encode_png(test_image()));
}

TEST_CASE("a PPM file holds the image, as another program reads it", "[image_file]") {
    check_decoded(rt::encode_ppm(test_image()));
}

TEST_CASE("a PPM file is its header and three bytes per pixel", "[image_file]") {
    Image image{2, 1, {1, 1, 1}};
    image.at(1, 0) = {0, Real(0.5), 2};
    CHECK(rt::encode_ppm(image) == std::string("P6\n2 1\n255\n\xff\xff\xff\x00\xbc\xff", 17));
}

TEST_CASE("a color that is not finite reaches no file", "[image_file]") {
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), rt::infinity}) {
        Image image{3, 3};
        image.at(2, 2) = {0, 0, bad};
        CHECK_THROWS_AS(rt::encode_png(image), std::logic_error);
        CHECK_THROWS_AS(rt::encode_ppm(image), std::logic_error);
    }
}
