#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <rt/light_file.hpp>
#include <stdexcept>

#include "checkpoint.hpp"

using checkpoint::Real;
using rt::Color;
using rt::Image;

namespace {

constexpr int enough = 1 << 20;  // pixels

// Why a file is refused; empty if it is not.
std::string refused(const std::string& file, int most_pixels = enough) {
    try {
        rt::decode_light(file, most_pixels);
    } catch (const std::length_error&) {
        return "too many pixels";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

// The bytes of these floats, the lowest first.
std::string low_first(const std::vector<float>& numbers) {
    std::string bytes;
    for (const float number : numbers)
        for (int shift = 0; shift < 32; shift += 8)
            bytes += static_cast<char>(std::bit_cast<std::uint32_t>(number) >> shift & 255);
    return bytes;
}

// From starlight to a sun, in runs and out of them.
Image dusk(int width, int height) {
    return rt::make_image(width, height, [&](int x, int y) {
        if (x == width / 2 && y == height / 2) return Color{100'000, 50'000, 7};
        if (y % 3 == 0) return Color{Real(y) / 64, 0, 1};
        const auto light = Real(std::ldexp(1 + (x * 7 + y * 13) % 16, y % 20 - 12));
        return Color{light, light / 2, Real(x % 5)};
    });
}

}  // namespace

TEST_CASE("a PFM file is its header and little-endian floats from the bottom row up",
          "[light_file]") {
    Image image{1, 2};
    image.at(0, 0) = {1, Real(0.5), 1000};
    image.at(0, 1) = {0, -2, 3};
    CHECK(rt::encode_pfm(image) == std::string("PF\n1 2\n-1.0\n"
                                               "\0\0\0\0\0\0\0\xc0\0\0\x40\x40"
                                               "\0\0\x80\x3f\0\0\0\x3f\0\0\x7a\x44",
                                               12 + 24));
}

TEST_CASE("a HDR file is its header, and three bytes with one exponent", "[light_file]") {
    Image image{2, 1, {1, Real(0.5), 0}};
    image.at(1, 0) = {0, 1000, -5};
    const std::string file = rt::encode_hdr(image), data("\x80\x40\0\x81\0\xfa\0\x8a", 8);
    CHECK(file.rfind("#?RADIANCE\n", 0) == 0);
    CHECK(file.find("\nFORMAT=32-bit_rle_rgbe\n") != std::string::npos);
    CHECK(file.find("\n\n-Y 1 +X 2\n") != std::string::npos);
    CHECK(file.substr(file.size() - 8) == data);
}

TEST_CASE("a PFM file brings back every float", "[light_file]") {
    for (const int width : {1, 7, 200}) {
        const Image image = dusk(width, 40);
        const Image read = rt::decode_light(rt::encode_pfm(image), enough);
        REQUIRE(read.width() == width);
        REQUIRE(read.height() == 40);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < width; ++x) {
                const Color in = image.at(x, y), out = read.at(x, y);
                CHECK(static_cast<float>(in.r) == static_cast<float>(out.r));
                CHECK(static_cast<float>(in.g) == static_cast<float>(out.g));
                CHECK(static_cast<float>(in.b) == static_cast<float>(out.b));
            }
    }
}

TEST_CASE("a HDR file brings back each channel to 1/128 of the largest", "[light_file]") {
    // Rows of fewer than 8 pixels, and of more than 32767, are not compressed.
    for (const int width : {1, 7, 8, 500, 40'000}) {
        const int height = width == 40'000 ? 2 : 40;
        const Image image = dusk(width, height);
        const Image read = rt::decode_light(rt::encode_hdr(image), enough);
        REQUIRE(read.width() == width);
        REQUIRE(read.height() == height);
        bool is_near = true;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Color in = image.at(x, y), out = read.at(x, y);
                const Real most = std::max({in.r, in.g, in.b}) / 128;
                for (const Real lost : {in.r - out.r, in.g - out.g, in.b - out.b})
                    is_near = is_near && 0 <= lost && lost < most;
            }
        CHECK(is_near);
        // What is read is what was stored, so that it can be stored again without a loss.
        CHECK(rt::decode_light(rt::encode_hdr(read), enough) == read);
    }
}

TEST_CASE("a color that is not finite reaches no file of light", "[light_file]") {
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), rt::infinity}) {
        Image image{3, 3};
        image.at(2, 2) = {0, 0, bad};
        CHECK_THROWS_AS(rt::encode_hdr(image), std::logic_error);
        CHECK_THROWS_AS(rt::encode_pfm(image), std::logic_error);
    }
}

TEST_CASE("light that a file cannot hold becomes the most that it can", "[light_file]") {
    const Image image{1, 1, {std::numeric_limits<Real>::max(), 0, 1}};
    const std::string hdr = rt::encode_hdr(image), pfm = rt::encode_pfm(image);
    CHECK(hdr.substr(hdr.size() - 4) == std::string("\xff\0\0\xff", 4));
    CHECK(pfm.substr(pfm.size() - 12) == low_first({std::numeric_limits<float>::max(), 0, 1}));
}

TEST_CASE("a PFM file may be gray, scaled, and have its highest bytes first", "[light_file]") {
    const Image gray = rt::decode_light("Pf\n1 1\n-2.0\n" + low_first({3}), enough);
    CHECK(gray.at(0, 0) == Color{6, 6, 6});
    const Image high = rt::decode_light(
        std::string("PF\n1 1\n1.0\n\x3f\x80\0\0\x40\0\0\0\0\0\0\0", 11 + 12), enough);
    CHECK(high.at(0, 0) == Color{1, 2, 0});
}

TEST_CASE("a picture of light that cannot be used is refused with a reason", "[light_file]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    const auto one = [](float light) { return "PF\n1 1\n-1.0\n" + low_first({0, light, 0}); };
    CHECK(refused(one(1e9F)).empty());
    CHECK(refused(one(nan)) == "has a NaN for a pixel");
    CHECK(refused(one(infinite)) == "has an infinitely bright pixel");
    CHECK(refused(one(-1)) == "has a pixel with less light than 0");
    CHECK(refused(one(-infinite)) == "has a pixel with less light than 0");
    CHECK(refused(one(1.1e9F)) == "has a pixel brighter than 1e9, which is too bright");
    CHECK(refused("") == "is neither a .hdr nor a .pfm file");
    CHECK(refused("\x89PNG\r\n\x1a\n") == "is neither a .hdr nor a .pfm file");
    CHECK(refused("PF\n0 1\n-1.0\n") == "does not say its width and height");
    CHECK(refused("PF\n-1 1\n-1.0\n") == "does not say its width and height");
    CHECK(refused("PF\n99999999999999999999 1\n-1.0\n") == "does not say its width and height");
    CHECK(refused("PF\nx 1\n-1.0\n") == "does not say its width and height");
    CHECK(refused("PF\n1 1\n0\n") == "must have a scale that is not 0, such as -1.0");
    CHECK(refused("PF\n1 1\nnan\n") == "must have a scale that is not 0, such as -1.0");
    CHECK(refused("PF\n3 4\n-1.0\n", 11) == "too many pixels");
    CHECK(refused("PF\n2147483647 2147483647\n-1.0\n") == "too many pixels");
    const std::string start = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    CHECK(refused(start + "-Y 3 +X 4\n", 11) == "too many pixels");
    CHECK(refused(start + "-Y 2147483647 +X 1\n") == "too many pixels");
    CHECK(refused(start + "+X 3 -Y 4\n") ==
          "does not have its rows from the top, left to right (-Y, +X)");
    CHECK(refused("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n") ==
          "has the FORMAT=32-bit_rle_xyze; only 32-bit_rle_rgbe is read");
    CHECK(refused(start + "-Y 1 +X 1\n\x80\x80\x80\xff") ==
          "has a pixel brighter than 1e9, which is too bright");
    CHECK(refused(start + "-Y 1 +X 2\n\x80\x80\x80\x80\x01\x01\x01\x05") ==
          "is compressed in the old way of Radiance; save it anew with another program");
    // A run of 0 pixels, which would never end, and one that is longer than its row.
    const std::string row = start + "-Y 1 +X 8\n" + std::string("\x02\x02\0\x08", 4);
    CHECK(refused(row + std::string(9, '\0')) ==
          "has a row that is longer or shorter than the picture");
    CHECK(refused(row + "\x89\x01") == "has a row that is longer or shorter than the picture");
}

TEST_CASE("a picture of light that ends too early is refused, wherever it ends", "[light_file]") {
    for (const int width : {3, 30})
        for (const std::string& file :
             {rt::encode_pfm(dusk(width, 4)), rt::encode_hdr(dusk(width, 4))}) {
            CHECK(refused(file).empty());
            for (std::size_t size = 12; size < file.size(); ++size) {
                INFO("the first " << size << " of " << file.size() << " bytes");
                CHECK_FALSE(refused(file.substr(0, size)).empty());
            }
        }
}
