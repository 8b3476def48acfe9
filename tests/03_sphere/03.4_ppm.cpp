#include <cctype>
#include <rt/ppm.hpp>
#include <rt/rng.hpp>
#include <rt/todo.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color;
using rt::Image;

namespace {

// The text, without the comments that the format allows.
std::string written(const Image& image) {
    std::ostringstream out;
    rt::write_ppm(out, image);
    std::string text = out.str();
    for (auto from = text.find('#'); from != std::string::npos; from = text.find('#', from))
        text.erase(from, std::min(text.find('\n', from), text.size()) - from);
    return text;
}

// The start of what was written, for messages: ? for characters that a terminal cannot show.
std::string begin_of(const std::string& text) {
    std::string shown = text.substr(0, 60);
    for (char& letter : shown)
        if (!std::isprint(static_cast<unsigned char>(letter)) && letter != '\n') letter = '?';
    return '"' + shown + '"';
}

// The numbers after the header.
std::vector<int> bytes_of(const std::string& text) {
    std::istringstream in{text};
    std::string word;
    for (int i = 0; i < 4; ++i) in >> word;  // P3, width, height, 255
    std::vector<int> bytes;
    for (int byte; in >> byte;) bytes.push_back(byte);
    return bytes;
}

std::vector<int> bytes_of(const Image& image) {
    return bytes_of(written(image));
}

std::string list(const std::vector<int>& bytes) {
    std::string text;
    for (const int byte : bytes) text += ' ' + std::to_string(byte);
    return text;
}

void check_bytes(const Image& image, const std::vector<int>& expected, const char* hint) {
    const std::vector<int> bytes = bytes_of(image);
    INFO(EXPECTED "the bytes" << list(expected) << ", " ACTUAL
                              << (bytes.empty() ? "none that can be read" : list(bytes))
                              << ".\nHint: " << hint);
    CHECK(bytes == expected);
}

constexpr Color black{0, 0, 0}, red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1}, white{1, 1, 1};

}  // namespace

TEST_CASE("03.4 the header contains the format and the size and 255", "[03.4]") {
    const std::string text = written(Image{3, 2});
    std::istringstream in{text};
    std::string format;
    int width = 0, height = 0, full = 0;
    in >> format >> width >> height >> full;
    INFO("an image 3 wide and 2 high: " EXPECTED "P3, 3, 2 and 255 at the start, " ACTUAL
         << begin_of(text));
    CHECK(format == "P3");
    CHECK(width == 3);
    CHECK(height == 2);
    CHECK(full == 255);
}

TEST_CASE("03.4 bytes are written as numbers and not as characters", "[03.4]") {
    const std::string text = written(Image{2, 2, white});
    INFO("the text is " << begin_of(text)
                        << ".\nHint: a std::uint8_t is printed as a character; write + before it "
                           "to print a number, and a space or a line break after each number");
    for (std::size_t i = 2; i < text.size(); ++i) {  // after P3
        const auto letter = static_cast<unsigned char>(text[i]);
        REQUIRE((std::isdigit(letter) || std::isspace(letter)));
    }
    CHECK(bytes_of(text) == std::vector<int>(12, 255));
}

TEST_CASE("03.4 red comes before green and green before blue", "[03.4]") {
    Image image{2, 2};  // the same if rows and columns are swapped
    image.at(0, 0) = red;
    image.at(1, 0) = image.at(0, 1) = green;
    image.at(1, 1) = blue;
    check_bytes(image, {255, 0, 0, 0, 255, 0, 0, 255, 0, 0, 0, 255},
                "write c.r, c.g and c.b in this order: red, green, blue");
}

TEST_CASE("03.4 rows are written from the top and pixels from the left", "[03.4]") {
    Image image{2, 3};
    image.at(0, 0) = red;
    image.at(1, 0) = green;
    image.at(0, 1) = blue;
    image.at(1, 1) = white;
    check_bytes(image, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0},
                "the pixels are (0, 0), (1, 0), then (0, 1), (1, 1), ...: y in the outer loop");
}

TEST_CASE("03.4 colors are stored in sRGB", "[03.4]") {
    // 0.5 of the light is byte 188; 0.2 is 124 and 0.002 is 7 (the straight piece of the curve).
    check_bytes(Image{1, 1, {Real(0.5), Real(0.2), Real(0.002)}}, {188, 124, 7},
                "the image holds linear light: rt::to_byte applies the sRGB curve");
}

TEST_CASE("03.4 an image may have a single pixel", "[03.4]") {
    check_bytes(Image{1, 1, black}, {0, 0, 0}, "one pixel has three numbers");
    for (const Image& image : {Image{1, 7}, Image{7, 1}, Image{70'000, 1}, Image{1, 70'000}}) {
        INFO("an image of " << image.width() << 'x' << image.height() << " pixels starts with "
                            << begin_of(written(image)));
        CHECK(bytes_of(image).size() == image.pixels().size() * 3);
        std::istringstream in{written(image)};
        std::string format;
        int width = 0, height = 0;
        in >> format >> width >> height;
        CHECK(width == image.width());
        CHECK(height == image.height());
    }
}

TEST_CASE("03.4 light outside of 0 to 1 is clamped", "[03.4]") {
    const char* const hint = "light above 1 becomes 255, and negative light becomes 0";
    check_bytes(Image{1, 1, {1, Real(1.5), 1000}}, {255, 255, 255}, hint);
    check_bytes(Image{1, 1, {-1, Real(-1e-6), Real(-1e30)}}, {0, 0, 0}, hint);
    check_bytes(Image{1, 1, {1 - rt::epsilon, 1 + rt::epsilon, Real(1e30)}}, {255, 255, 255}, hint);
}

TEST_CASE("03.4 each of the 256 byte values is written and read back unchanged", "[03.4]") {
    Image image{256, 1};
    std::vector<int> expected;
    for (int byte = 0; byte < 256; ++byte) {
        const Real light = rt::srgb_decode(static_cast<Real>(byte) / 255);
        image.at(byte, 0) = {light, light, light};
        for (int channel = 0; channel < 3; ++channel) expected.push_back(byte);
    }
    check_bytes(
        image, expected,
        "round to the nearest byte: if you cut off the digits, the byte may be one too small");
}

TEST_CASE("03.4 every byte of any image is written correctly", "[03.4]") {
    rt::Rng rng{33, 1};
    for (const int width : {1, 13, 64}) {
        Image image{width, 41};
        std::vector<int> expected;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < width; ++x) {
                const auto light = [&] {
                    const Real encoded = rng.uniform(Real(-0.1), Real(1.1));
                    return encoded < 0   ? encoded
                           : encoded > 1 ? 10 * encoded
                                         : rt::srgb_decode(encoded);
                };
                const Color c{light(), light(), light()};
                image.at(x, y) = c;
                for (const Real channel : {c.r, c.g, c.b}) expected.push_back(rt::to_byte(channel));
            }
        const std::vector<int> bytes = bytes_of(image);
        INFO("an image of " << width << 'x' << image.height() << " pixels");
        REQUIRE(bytes.size() == expected.size());
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            INFO("pixel (" << i / 3 % static_cast<std::size_t>(width) << ", "
                           << i / 3 / static_cast<std::size_t>(width) << "), "
                           << (i % 3 == 0   ? "red"
                               : i % 3 == 1 ? "green"
                                            : "blue")
                           << ": " EXPECTED << expected[i] << ", " ACTUAL << bytes[i]
                           << ".\nHint: write every pixel in its place, and convert each channel "
                              "with rt::to_byte");
            REQUIRE(bytes[i] == expected[i]);
        }
    }
}

TEST_CASE("03.4 no line is longer than 70 characters", "[03.4]") {
    std::istringstream in{written(Image{100, 2, white})};
    for (std::string line; std::getline(in, line);) {
        INFO("a line of " << line.size()
                          << " characters.\nHint: the format asks for lines of at most "
                          << "70; one line per pixel is simplest");
        REQUIRE(line.size() <= 70);
    }
}

TEST_CASE("03.4 a color that is not finite is refused", "[03.4][hard]") {
    const Real largest = std::numeric_limits<Real>::max();  // finite, though a sum of two is not
    CHECK(bytes_of(Image{1, 1, {largest, largest, largest}}) == std::vector<int>{255, 255, 255});
    CHECK(bytes_of(Image{1, 1, white}).size() == 3);  // a color that is fine goes through
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const auto refusal = [](const Image& image) -> std::string {
        std::ostringstream out;
        try {
            rt::write_ppm(out, image);
        } catch (const rt::NotImplemented&) {
            throw;
        } catch (const std::logic_error&) {
            return "std::logic_error";
        } catch (const std::exception& other) {
            return "another exception: " + std::string(other.what());
        }
        return "nothing was thrown";
    };
    for (const Real bad : {rt::infinity, -rt::infinity, nan})
        for (const Color& c : {Color{bad, 0, 0}, Color{0, bad, 0}, Color{0, 0, bad}})
            for (const int place : {0, 4, 11}) {
                Image image{4, 3, white};
                image.at(place % 4, place / 4) = c;
                INFO("an image with " << c << " in pixel (" << place % 4 << ", " << place / 4
                                      << ") must throw std::logic_error.\nHint: check "
                                         "rt::is_finite(color) for every color before you write "
                                         "it");
                CHECK(refusal(image) == "std::logic_error");
            }
}
