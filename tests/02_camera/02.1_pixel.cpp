#include <rt/pixel.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Camera;
using rt::Vec2;

namespace {

Camera camera(int width, int height, Real viewport_width, Real viewport_height) {
    Camera c;
    c.width = width;
    c.height = height;
    c.viewport = {viewport_width, viewport_height};
    return c;
}

std::string text(Vec2 p) {
    return '(' + checkpoint::text(p.x) + ", " + checkpoint::text(p.y) + ')';
}

// 4 x 2 pixels on a viewport of 8 x 3: each pixel is 2 wide and 1.5 high.
const Camera coarse = camera(4, 2, 8, 3);

std::string suggestion(Vec2 p, Vec2 expected) {
    if (p.x == expected.x && p.y == -expected.y)
        return "upside down: row 0 is the top row, and y grows upwards";
    if (p.x == expected.x + 4) return "x = 0 is the middle of the viewport, not its left edge";
    if (p.x == 0 || p.x == -4)
        return "does a whole number divide a whole number? In C++ 1 / 4 is 0: make them Real first";
    if (p.x == expected.x - 1 || p.x == expected.x + 1)
        return "half a pixel off: is the offset in it, once?";
    if (std::abs(p.x) > 4) return "is x in the units of the viewport, not of pixels?";
    return "a pixel's width is the viewport's width / the number of columns; is the offset in it?";
}

}  // namespace

TEST_CASE("02.1 x grows to the right and y upwards from the middle", "[02.1]") {
    const struct {
        int column, row;
        Vec2 expected;
    } pixels[] = {{0, 0, {-3, Real(0.75)}}, {3, 0, {3, Real(0.75)}}, {1, 1, {-1, Real(-0.75)}}};
    for (const auto& [column, row, expected] : pixels) {
        const Vec2 p = rt::pixel_to_viewport(coarse, column, row, {Real(0.5), Real(0.5)});
        INFO("4x2 pixels on a viewport of 8x3: the middle of column "
             << column << ", row " << row << ": expected " << text(expected) << ", yours gives "
             << text(p) << ".\nHint: " << suggestion(p, expected));
        CHECK(p == expected);
    }
}

TEST_CASE("02.1 the offset counts from the top left corner of the pixel", "[02.1]") {
    const Vec2 top_left = rt::pixel_to_viewport(coarse, 1, 0, {0, 0});
    INFO(
        "4x2 pixels on a viewport of 8x3, column 1, row 0: its top left corner is (-2, 1.5), yours "
        "gives "
        << text(top_left)
        << ".\nHint: offset (0, 0) is the corner, and a half that is "
           "always added ignores the offset");
    CHECK(top_left == Vec2{-2, Real(1.5)});
    const Vec2 inside = rt::pixel_to_viewport(coarse, 1, 0, {Real(0.25), Real(0.5)});
    INFO("offset (0.25, 0.5) in it is at (-1.5, 0.75), yours gives " << text(inside));
    CHECK(inside == Vec2{Real(-1.5), Real(0.75)});
}

TEST_CASE("02.1 the pixels fill the viewport from edge to edge", "[02.1]") {
    for (const int width : {1, 2, 8, 1024}) {
        const Camera c = camera(width, 2 * width, 16, 32);
        const Vec2 first = rt::pixel_to_viewport(c, 0, 0, {0, 0});
        const Vec2 last = rt::pixel_to_viewport(c, width - 1, 2 * width - 1, {1, 1});
        INFO(
            width
            << "x" << 2 * width
            << " pixels on a viewport of 16x32: the outermost corners are "
               "(-8, 16) and (8, -16), yours gives "
            << text(first) << " and " << text(last)
            << ".\nHint: n pixels have n widths between the outer edges, so it is / width, not / "
               "(width - 1); and half of an odd width is no whole number: make width a Real first");
        CHECK(first == Vec2{-8, 16});
        CHECK(last == Vec2{8, -16});
    }
}

TEST_CASE("02.1 an image of one pixel and one of 1x10000", "[02.1][hard]") {
    {
        const Vec2 middle = rt::pixel_to_viewport(camera(1, 1, 2, 2), 0, 0, {Real(0.5), Real(0.5)});
        INFO("the middle of a single pixel is (0, 0), yours gives "
             << text(middle)
             << ".\nHint: width - 1 is 0 here, and so is width / 2 as long as width is an int");
        CHECK(middle == Vec2{0, 0});
    }

    const Camera tall = camera(1, 10'000, 1, 10'000);  // each pixel is 1 x 1
    for (const int row : {0, 4999, 5000, 9999}) {
        const Vec2 p = rt::pixel_to_viewport(tall, 0, row, {Real(0.5), Real(0.5)});
        const Exact y = Exact(4999.5) - Exact(row);
        INFO("1x10000 pixels of size 1, row " << row << ": yours gives " << text(p));
        HINT(y, p.y,
             "rows go with the height, and half of the height is subtracted before anything is "
             "divided");
        CHECK(p.x == 0);
        CHECK(error_in_ulp(p.y, y) <= 3);
    }
}

TEST_CASE("02.1 every pixel is within three units in the last place", "[02.1][hard]") {
    // Offset, division, product: three roundings. All else in the formula can be exact.
    for (const int size : {1, 2, 3, 10, 101, 640, 1919, 10'000, 65'536}) {
        const Real wide = Real(1.7), tall = Real(0.00001);
        const Camera c = camera(size, size, wide, tall);
        for (int step = 0; step <= 40; ++step) {
            const int i = static_cast<int>(std::int64_t{size - 1} * step / 40);
            const Real offset = static_cast<Real>((i * 7 + 3) % 10) / 10;
            const Exact from_middle = Exact(i) + Exact(offset) - Exact(size) / Exact(2);
            const Exact x = from_middle / Exact(size) * Exact(wide);
            const Exact y = -from_middle / Exact(size) * Exact(tall);
            const Vec2 p = rt::pixel_to_viewport(c, i, i, {offset, offset});
            INFO(size << 'x' << size << " pixels, column and row " << i << ", offset "
                      << checkpoint::text(offset));
            const char* const late =
                "a half that is subtracted after the division cancels near the middle: subtract "
                "half "
                "of the width from the column, which rounds nothing, then divide";
            {
                HINT(x, p.x, late);
                REQUIRE(error_in_ulp(p.x, x) <= 3);
            }
            HINT(y, p.y, late);
            REQUIRE(error_in_ulp(p.y, y) <= 3);
        }
    }
}

TEST_CASE("02.1 the left half mirrors the right half exactly", "[02.1][hard]") {
    for (const int width : {2, 7, 640, 10'000}) {
        const Camera c = camera(width, width, Real(1.7), Real(0.3));
        for (int column = 0; column < width; column += 1 + width / 50) {
            const int mirrored = width - 1 - column;
            const Vec2 p = rt::pixel_to_viewport(c, column, column, {Real(0.5), Real(0.5)});
            const Vec2 q = rt::pixel_to_viewport(c, mirrored, mirrored, {Real(0.5), Real(0.5)});
            INFO(
                "the middles of columns "
                << column << " and " << mirrored << " of " << width << ": yours gives " << text(p)
                << " and " << text(q)
                << ".\nHint: count pixels from the middle of the image before anything is rounded");
            REQUIRE(p.x == -q.x);
            REQUIRE(p.y == -q.y);
        }
    }
}
