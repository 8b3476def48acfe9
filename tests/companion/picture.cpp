#include <stb_image.h>

#include <app/errors.hpp>
#include <companion/compare/comparison_sheet.hpp>
#include <companion/compare/permutation.hpp>
#include <companion/compare/program_pictures.hpp>
#include <rt/image_file.hpp>

#include "catch.hpp"

using companion::Picture;

TEST_CASE("both kinds of .ppm are read", "[picture]") {
    const Picture expected{2, 1, {1, 2, 3, 10, 255, 35}};
    CHECK(companion::parse_ppm("P3\n2 1\n255\n1 2 3\n10 255 35\n") == expected);
    CHECK(companion::parse_ppm("P3 # a comment\n2 1 # another\n255 1 2 3 10 255 35") == expected);
    CHECK(companion::parse_ppm("P6\n2 1\n255\n\x01\x02\x03\x0a\xff\x23") == expected);
}

TEST_CASE("what is not a .ppm is refused", "[picture]") {
    for (const char* const text :
         {"", "P", "P3", "P5\n1 1\n255\nx", "P3\n1 1\n255\n1 2", "P3\n1 1\n255\n1 2 256",
          "P3\n0 1\n255\n", "P3\n1 1\n65535\n1 2 3", "P6\n1 1\n255\nxx", "P6\n1 1\n255\nxxxx",
          "P3\n60000 60000\n255\n1 2 3", "P3\n1 1\n255\n1 2 -3", "P3\n#"}) {
        INFO(text);
        CHECK_THROWS_AS(companion::parse_ppm(text), app::Failure);
    }
}

TEST_CASE("what is wrong with a .ppm is said with pixel and word", "[picture]") {
    const auto said = [](const std::string& text) {
        try {
            companion::parse_ppm(text);
        } catch (const app::Failure& failure) {
            return std::string{failure.what()};
        }
        return std::string{"taken"};
    };
    const std::string header = "P3\n2 2\n255\n0 0 0 1 1 1 2 2 2 ";
    CHECK(said(header + "3 -2147483648 3") ==
          "pixel (1, 1) of the .ppm file: '-2147483648' is no whole number from 0 to 255: NaN, or "
          "not clamped?");
    for (const char* const word : {"nan", "256", "1.5", "done", "-1", "0x10"})
        CHECK(said(header + "3 3 " + word).find('\'' + std::string{word} + '\'') !=
              std::string::npos);
    CHECK(said(header + "3 3") == "pixel (1, 1) of the .ppm file: the file ends before it");
    CHECK(said(header + "3 3 3 4") == "the .ppm file goes on after its last pixel, with '4'");
    CHECK(said(header + "3 3 3\ndone in 2 s\n") ==
          "the .ppm file goes on after its last pixel, with 'done'");
    CHECK(said(header + "3 3 3 # a comment\n\n") == "taken");
    CHECK(said("P3\n2 two\n255\n") == "the .ppm file has no height from 1 to 65536, but 'two'");
    CHECK(said("P6\n2 1\n255\n\x01\x02\x03\r\n\xff\x23").find("std::ios::binary") !=
          std::string::npos);
    CHECK(said("P6\n2 1\n255\n\x01\x02\x03\xff\x23").find("std::ios::binary") == std::string::npos);
}

TEST_CASE("a written image is read as its bytes", "[picture]") {
    const rt::Image image = rt::make_image(5, 4, [](int x, int y) {
        return rt::Color{x / rt::Real(4), y / rt::Real(3), rt::Real(0.5)};
    });
    const Picture picture = companion::parse_ppm(rt::encode_ppm(image));
    CHECK(picture.width == 5);
    CHECK(picture.height == 4);
    CHECK(picture.bytes[0] == 0);
    CHECK(picture.bytes[2] == rt::to_byte(rt::Real(0.5)));
    CHECK(companion::mean_of({picture, picture}).at(4, 3).r == 1);
}

TEST_CASE("a program's options are read from its description", "[picture]") {
    const auto random = companion::options_from(
        R"({"out": "a.png", "width": "960", "height": "540", "spp": "64", "seed": "1"})");
    CHECK(random.width == 960);
    CHECK(random.height == 540);
    CHECK(random.spp == 64);
    CHECK(random.has_seed);
    const auto still = companion::options_from(R"({"width": "1280", "height": "720"})");
    CHECK(still.width == 1280);
    CHECK(still.height == 720);
    CHECK(still.spp == 0);
    CHECK_FALSE(still.has_seed);
    CHECK_THROWS_AS(companion::options_from("no description"), app::UsageError);
    const auto small = companion::for_comparison(random);
    CHECK(small.width == 256);
    CHECK(small.height == 144);
    CHECK(small.spp == 9);
    CHECK(companion::for_comparison(still).width == 1280);
}

TEST_CASE("a program that cannot draw is told from one that draws otherwise", "[picture]") {
    CHECK_THROWS_AS(companion::draw_with("/nonexistent/program", {}, 1), companion::DrawingFailed);
    CHECK_THROWS_AS(companion::draw_with("/bin/false", {}, 1), companion::DrawingFailed);
}

TEST_CASE("the picture of a comparison shows both and where they differ", "[picture]") {
    Picture solution{64, 32, std::vector<std::uint8_t>(64 * 32 * 3, 128)};
    Picture mine = solution;
    for (int y = 16; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                mine.bytes[3 * static_cast<std::size_t>(y * 64 + x) + c] = 64;
    const rt::Image sheet = companion::comparison_sheet(companion::compare_still(mine, solution));
    const std::string png = rt::encode_png(sheet);
    int width, height, channels;
    stbi_uc* const pixels =
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()),
                              static_cast<int>(png.size()), &width, &height, &channels, 3);
    REQUIRE(pixels);
    // Eight times as large, side by side, 12 pixels apart, below a line of words.
    CHECK(width == 3 * 64 * 8 + 4 * 12);
    CHECK(height == 32 * 8 + 34 + 12);
    const auto at = [&](int panel, int x, int y, int channel) {
        return int(
            pixels[3 * ((34 + 8 * y) * width + 12 + panel * (64 * 8 + 12) + 8 * x) + channel]);
    };
    CHECK(at(0, 8, 24, 0) == 64);
    CHECK(at(1, 8, 24, 0) == 128);
    CHECK(at(2, 8, 24, 2) > at(2, 8, 24, 0) + 50);  // too dark: blue
    CHECK(at(2, 50, 4, 2) == at(2, 50, 4, 0));      // the same: gray
    stbi_image_free(pixels);
}

TEST_CASE("a program whose later pictures have another size is shown with such a picture",
          "[picture]") {
    const Picture solution{64, 32, std::vector<std::uint8_t>(64 * 32 * 3, 128)};
    const Picture large{64, 32, std::vector<std::uint8_t>(64 * 32 * 3, 120)};
    const Picture small{16, 8, std::vector<std::uint8_t>(16 * 8 * 3, 120)};
    int drawn = 0;
    const auto mine = [&](std::uint64_t) { return ++drawn < 3 ? large : small; };
    const companion::Comparison found =
        companion::compare({mine, [&](std::uint64_t) { return solution; }, true});
    CHECK(found.sizes_differ);
    CHECK(found.words().at(0).find("16x8") != std::string::npos);
    CHECK(companion::comparison_sheet(found).height() == 32 * 8 + 34 + 12);
    CHECK_THROWS_AS(companion::mean_of({large, small}), app::Failure);
}

TEST_CASE("dealing the pictures out again tells chance from difference", "[picture]") {
    // 4 against 4 can be dealt out in 70 ways, two of which are the worst.
    companion::Products apart{8}, alike{8};
    const std::vector<double> groups{1, 1.01, 0.99, 1, -1, -1.02, -0.99, -0.99};
    apart.add(groups);
    alike.add({1, -1, 1, -1, 1, -1, 1, -1});
    CHECK(std::abs(companion::permutation_p(apart, 4, 8) - 2.0 / 70) < 1e-12);
    CHECK(companion::permutation_p(alike, 4, 8) == 1);
    CHECK(companion::permutation_p(companion::Products{8}, 4, 8) == 1);
}
