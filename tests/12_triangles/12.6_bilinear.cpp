#include <rt/bilinear.hpp>

#include "shapes.hpp"

using namespace checkpoint;
using rt::Color;
using rt::Image;
using rt::Vec2;

namespace {

std::string text_of(Color c) {
    return '(' + text(c.r) + ", " + text(c.g) + ", " + text(c.b) + ')';
}

void check_color(const Image& image, Vec2 uv, Color expected, const char* hint,
                 Real near = 100 * rt::epsilon) {
    const Color actual = rt::bilinear(image, uv);
    const bool right = std::abs(actual.r - expected.r) <= near &&
                       std::abs(actual.g - expected.g) <= near &&
                       std::abs(actual.b - expected.b) <= near;
    if (!right) {
        INFO("at the texture coordinates (" << text(uv.x) << ", " << text(uv.y)
                                            << ") of an image of " << image.width() << " x "
                                            << image.height() << " pixels");
        INFO(EXPECTED << text_of(expected) << "\n" ACTUAL << text_of(actual));
        INFO("Hint: " << hint);
        REQUIRE(right);
    }
    REQUIRE(right);
}

// Each pixel has its column in red and its row in green.
Image numbered(int width, int height) {
    return rt::make_image(width, height, [](int x, int y) {
        return Color{static_cast<Real>(x), static_cast<Real>(y), 1};
    });
}

Vec2 middle(const Image& image, int x, int y) {
    return {(static_cast<Real>(x) + real(0.5)) / static_cast<Real>(image.width()),
            1 - (static_cast<Real>(y) + real(0.5)) / static_cast<Real>(image.height())};
}

}  // namespace

TEST_CASE("12.6 the color in the middle of a pixel is the pixel's color", "[12.6]") {
    const Image image = numbered(8, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            check_color(
                image, middle(image, x, y), {static_cast<Real>(x), static_cast<Real>(y), 1},
                "pixel x extends from x / width to (x + 1) / width, and its middle is half a pixel "
                "farther on; y counts upward in texture coordinates, but downward in an image");
}

TEST_CASE("12.6 colors are mixed between the middles of neighboring pixels", "[12.6]") {
    rt::Rng rng{126, 1};
    for (const Image& image : {numbered(8, 4), numbered(300, 700)})
        for (int i = 0; i < 2000; ++i) {
            const Real width = static_cast<Real>(image.width()),
                       height = static_cast<Real>(image.height());
            const Real x = rng.uniform(0, width - 1), y = rng.uniform(0, height - 1);
            check_color(
                image, {(x + real(0.5)) / width, 1 - (y + real(0.5)) / height}, {x, y, 1},
                "mix two neighbors along x, then two rows, with the weights 1 - share and share",
                8 * (width + height) * rt::epsilon);
        }
}

TEST_CASE("12.6 width and height may be any numbers", "[12.6]") {
    const Image image = numbered(5, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x)
            check_color(image, middle(image, x, y), {static_cast<Real>(x), static_cast<Real>(y), 1},
                        "the column before x and the one after it, modulo the width");
    check_color(image, {0, real(0.5)}, {2, 1, 1},
                "at the left edge, the first and the last column have the weight 1/2 each");
    check_color(image, {real(0.5), 0}, {2, 1, 1},
                "at the lower edge, the last and the first row have the weight 1/2 each");
}

TEST_CASE("12.6 the colors agree with an example of four pixels on paper", "[12.6]") {
    Image image{2, 2};
    image.at(0, 0) = {1, 0, 0};
    image.at(1, 0) = {0, 1, 0};
    image.at(0, 1) = {0, 0, 1};
    image.at(1, 1) = {1, 1, 1};
    check_color(image, {real(0.5), real(0.5)}, {real(0.5), real(0.5), real(0.5)},
                "in the middle of the image, each pixel has the weight 1/4");
    check_color(image, {real(0.375), real(0.75)}, {real(0.75), real(0.25), 0},
                "the position is a quarter of a column to the right of the middle of the first "
                "column, in the upper row");
}

TEST_CASE("12.6 beyond its edges the image repeats", "[12.6]") {
    const Image image = numbered(8, 4);
    check_color(image, {0, real(0.875)}, {real(3.5), 0, 1},
                "at the left edge, the first and the last column have the weight 1/2 each");
    check_color(image, {1, real(0.875)}, {real(3.5), 0, 1},
                "at the right edge, the last and the first column have the weight 1/2 each");
    check_color(image, {real(0.0625), 1}, {0, real(1.5), 1},
                "at the upper edge, the first and the last row have the weight 1/2 each");
    check_color(image, {real(0.0625), 0}, {0, real(1.5), 1},
                "at the lower edge, the last and the first row have the weight 1/2 each");
    // Less than half a pixel from an edge.
    const char* const hint = "beyond the middle of the last pixel, the first one is its neighbor";
    check_color(image, {real(0.96875), real(0.875)}, {real(5.25), 0, 1}, hint);
    check_color(image, {real(0.03125), real(0.875)}, {real(1.75), 0, 1}, hint);
    check_color(image, {real(0.0625), real(0.9375)}, {0, real(0.75), 1}, hint);
    check_color(image, {real(0.0625), real(0.0625)}, {0, real(2.25), 1}, hint);
    rt::Rng rng{126, 2};
    for (int i = 0; i < 2000; ++i) {
        const Vec2 uv{rng.uniform(), rng.uniform()};
        const Color once = rt::bilinear(image, uv);
        for (const Vec2 away : {Vec2{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {3, -5}, {-7, 2}})
            check_color(
                image, {uv.x + away.x, uv.y + away.y}, once,
                "one whole image farther on, the color is the same, also at negative coordinates",
                real(1e3) * rt::epsilon);
    }
}

TEST_CASE("12.6 an image of one pixel has one color", "[12.6]") {
    const Image image{1, 1, {real(0.2), real(0.4), real(0.6)}};
    rt::Rng rng{126, 3};
    for (int i = 0; i < 100; ++i)
        check_color(image, {rng.uniform(-2, 2), rng.uniform(-2, 2)}, image.at(0, 0),
                    "the image has one pixel, which is its own neighbor");
}

TEST_CASE("12.6 coordinates just below a whole number give the correct color", "[12.6][hard]") {
    const Image image = numbered(8, 4);
    const Real tiny = std::numeric_limits<Real>::min();
    for (const Real x : {-tiny, -std::numeric_limits<Real>::denorm_min(), -rt::epsilon / 8,
                         1 - rt::epsilon / 2, std::nextafter(Real(2), Real(0))})
        check_color(image, {x, real(0.875)}, {real(3.5), 0, 1},
                    "x - floor(x) may be rounded to 1: the index must stay below the width");
    for (const Real y : {-tiny, -rt::epsilon / 8, 1 - rt::epsilon / 2})
        check_color(image, {real(0.0625), y}, {0, real(1.5), 1},
                    "y - floor(y) may be rounded to 1: the index must stay below the height");
}

TEST_CASE("12.6 the image repeats even at huge texture coordinates", "[12.6][hard]") {
    const Image image = numbered(8, 4);
    const Real largest = std::numeric_limits<Real>::max();
    for (const Real far : {Real(1e9), Real(-1e9), Real(1e30), Real(-1e30), largest, -largest}) {
        const Color along_x = rt::bilinear(image, {far, real(0.875)}),
                    along_y = rt::bilinear(image, {real(0.0625), far});
        // These are whole numbers: the left edge, and the lower one.
        INFO("at the texture coordinate " << text(far) << ": " << text_of(along_x) << " and "
                                          << text_of(along_y));
        INFO("Hint: an int has no room for such a number; subtract the whole part first");
        CHECK(std::abs(along_x.r - real(3.5)) <= 100 * rt::epsilon);
        CHECK(std::abs(along_y.g - real(1.5)) <= 100 * rt::epsilon);
    }
    if (std::numeric_limits<Real>::digits > 32)
        check_color(image, {real(1e9 + 0.3125), real(0.875)}, {2, 0, 1},
                    "the digits after the decimal point still count", real(1e-5));
}
