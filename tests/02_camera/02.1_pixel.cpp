#include <rt/pixel.hpp>

#include "checkpoint.hpp"
#include "random_inputs.hpp"

using namespace checkpoint;
using rt::Camera;
using rt::Vec2;

namespace {

Camera camera(int width, int height, Real viewport_width, Real viewport_height) {
    Camera c;
    c.eye = {7, 8, 9};  // which does not count
    c.width = width;
    c.height = height;
    c.viewport = {viewport_width, viewport_height};
    return c;
}

// A point in any pixel of any image, on a viewport of any shape. Points next to the middle of a
// large image are left out: there, more digits on the way could change every digit of x.
void check_anywhere(rt::Rng& rng, int most_pixels, Real smallest, Real largest) {
    const auto upto = [&](int n) { return static_cast<int>(rng() % static_cast<unsigned>(n)); };
    Camera c = camera(1 + upto(most_pixels), 1 + upto(most_pixels),
                      std::abs(any_number(rng, smallest, largest)),
                      std::abs(any_number(rng, smallest, largest)));
    c.eye = any_vector(rng, -1, 1);
    const auto index = [&](int n) {
        return rng() % 4 == 0 ? (rng() % 2 == 0 ? 0 : n - 1) : upto(n);
    };
    const int column = index(c.width), row = index(c.height);
    const auto place = [&] { return rng() % 4 == 0 ? Real(rng() % 2) : rng.uniform(); };
    const Vec2 offset{place(), place()};
    const Vec2 p = rt::pixel_to_viewport(c, column, row, offset);
    const auto check = [&](const char* name, Real computed, int i, int pixels, Real within,
                           Real size) {
        const Exact from_middle = Exact(i) + Exact(within) - Exact(pixels) / Exact(2);
        if (std::abs(from_middle.high) * 2048 < pixels) return;
        const Exact exact = from_middle / Exact(pixels) * Exact(size);
        INFO(name);
        HINT(exact, computed,
             "subtract half the width from the column, which is exact, and then divide: if you "
             "subtract a half after the division, digits cancel near the middle");
        REQUIRE(error_in_ulp(computed, exact) <= 3);
    };
    INFO(c.width << 'x' << c.height << " pixels on a viewport of "
                 << checkpoint::text(c.viewport.width) << 'x' << checkpoint::text(c.viewport.height)
                 << ", column " << column << ", row " << row << ", offset ("
                 << checkpoint::text(offset.x) << ", " << checkpoint::text(offset.y) << ')');
    check("x", p.x, column, c.width, offset.x, c.viewport.width);
    check("y", -p.y, row, c.height, offset.y, c.viewport.height);
}

std::string text(Vec2 p) {
    return '(' + checkpoint::text(p.x) + ", " + checkpoint::text(p.y) + ')';
}

// 4 x 2 pixels on a viewport of 8 x 3: each pixel is 2 wide and 1.5 high.
const Camera coarse = camera(4, 2, 8, 3);

std::string suggestion(Vec2 p, Vec2 expected) {
    if (p.x == expected.x && p.y == -expected.y)
        return "your picture is upside down: row 0 is the top row, and y grows upward";
    if (std::abs(3 * p.x - 4 * expected.x) < Real(0.01))
        return "add the offset to the column, and divide by width, not by width - 1: four pixels "
               "lie side by side";
    if (p.x == expected.x + 4)
        return "x = 0 is the middle of the viewport, not its left edge. (In C++, 1 / 2 is 0: write "
               "Real(0.5), or x / 2)";
    if (p.x == 0 || p.x == -4)
        return "do not divide a whole number by a whole number: in C++, 1 / 4 is 0. Convert to "
               "Real first";
    if (p.x == expected.x - 1 || p.x == expected.x + 1)
        return "your result is half a pixel off: add the offset once";
    if (std::abs(p.x) > 4) return "x must be in the units of the viewport, not in pixels";
    return "a pixel's width is the viewport's width divided by the number of columns; add the "
           "offset before you scale";
}

}  // namespace

TEST_CASE("02.1 x grows to the right and y grows upward from the middle", "[02.1]") {
    const struct {
        int column, row;
        Vec2 expected;
    } pixels[] = {{0, 0, {-3, Real(0.75)}}, {3, 0, {3, Real(0.75)}}, {1, 1, {-1, Real(-0.75)}}};
    for (const auto& [column, row, expected] : pixels) {
        const Vec2 p = rt::pixel_to_viewport(coarse, column, row, {Real(0.5), Real(0.5)});
        INFO("4x2 pixels on a viewport of 8x3: the middle of column "
             << column << ", row " << row << ": " EXPECTED << text(expected) << ", " ACTUAL
             << text(p) << ".\nHint: " << suggestion(p, expected));
        CHECK(p == expected);
    }
}

TEST_CASE("02.1 the offset is measured from the top left corner of the pixel", "[02.1]") {
    const Vec2 top_left = rt::pixel_to_viewport(coarse, 1, 0, {0, 0});
    INFO("4x2 pixels on a viewport of 8x3, column 1, row 0, offset (0, 0): " EXPECTED
         "its top left corner (-2, 1.5), " ACTUAL
         << text(top_left)
         << ".\nHint: offset (0, 0) is the corner: add the offset, not a fixed half");
    CHECK(top_left == Vec2{-2, Real(1.5)});
    const Vec2 inside = rt::pixel_to_viewport(coarse, 1, 0, {Real(0.25), Real(0.5)});
    INFO("4x2 pixels on a viewport of 8x3, column 1, row 0, offset (0.25, 0.5): " EXPECTED
         "(-1.5, 0.75), " ACTUAL
         << text(inside));
    CHECK(inside == Vec2{Real(-1.5), Real(0.75)});
}

TEST_CASE("02.1 the pixels fill the viewport from edge to edge", "[02.1]") {
    for (const int width : {1, 2, 5, 8, 1024}) {
        const int height = 2 * width + 1;
        const Camera c = camera(width, height, 16, 32);
        const Vec2 first = rt::pixel_to_viewport(c, 0, 0, {0, 0});
        const Vec2 last = rt::pixel_to_viewport(c, width - 1, height - 1, {1, 1});
        INFO(width
             << "x" << height
             << " pixels on a viewport of 16x32: " EXPECTED
                "the outermost corners (-8, 16) and (8, -16), " ACTUAL
             << text(first) << " and " << text(last)
             << ".\nHint: n pixels have n widths between the outer edges, so divide by width, not "
                "by width - 1; and half of an odd size is not a whole number: convert it to Real "
                "first");
        CHECK(first == Vec2{-8, 16});
        CHECK(last == Vec2{8, -16});
    }
}

TEST_CASE("02.1 points are correct in images of 1x1 and 1x10000 pixels", "[02.1][hard]") {
    {
        const Vec2 middle = rt::pixel_to_viewport(camera(1, 1, 2, 2), 0, 0, {Real(0.5), Real(0.5)});
        INFO("the middle of a single pixel: " EXPECTED "(0, 0), " ACTUAL
             << text(middle)
             << ".\nHint: width - 1 is 0 here, and so is width / 2 as long as width is an int");
        CHECK(middle == Vec2{0, 0});
    }

    const Camera tall = camera(1, 10'000, 1, 10'000);  // each pixel is 1 x 1
    for (const int row : {0, 4999, 5000, 9999}) {
        const Vec2 p = rt::pixel_to_viewport(tall, 0, row, {Real(0.5), Real(0.5)});
        const Exact y = Exact(4999.5) - Exact(row);
        INFO("1x10000 pixels of size 1, row " << row << ": your point is " << text(p));
        HINT(y, p.y, "use the height for rows, and subtract half the height before you divide");
        CHECK(p.x == 0);
        CHECK(error_in_ulp(p.y, y) <= 3);
    }
}

TEST_CASE("02.1 every point is accurate to three units in the last place", "[02.1][hard]") {
    // Offset, division, product: three roundings. Everything else in the formula can be exact.
    rt::Rng rng{21, 1};
    for (int i = 0; i < 2000; ++i) {
        check_anywhere(rng, 10, 0, 1);
        check_anywhere(rng, 2000, -4, 4);
        check_anywhere(rng, 65'536, -12, 12);
    }
}
