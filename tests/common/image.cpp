#include <rt/image.hpp>

#include "checkpoint.hpp"

using rt::Color;
using rt::Image;

TEST_CASE("an image keeps each pixel in its place", "[image]") {
    Image image{3, 2};
    CHECK(image.width() == 3);
    CHECK(image.height() == 2);
    REQUIRE(image.pixels().size() == 6);
    image.at(2, 0) = {1, 0, 0};
    image.at(0, 1) = {0, 1, 0};
    CHECK(image.pixels()[2] == Color{1, 0, 0});
    CHECK(image.pixels()[3] == Color{0, 1, 0});
    CHECK(image.at(1, 1) == Color{});
}

TEST_CASE("an image can start filled, and copies are independent", "[image]") {
    const Image filled{2, 2, {1, 1, 1}};
    Image copy = filled;
    CHECK(copy == filled);
    copy.at(0, 0) = {};
    CHECK_FALSE(copy == filled);
    CHECK(filled.at(0, 0) == Color{1, 1, 1});
}

TEST_CASE("an image of the same pixels in another shape is another image", "[image]") {
    CHECK_FALSE(Image{2, 3} == Image{3, 2});
}

TEST_CASE("an image needs at least one pixel", "[image]") {
    CHECK_THROWS_AS(Image(0, 5), std::invalid_argument);
    CHECK_THROWS_AS(Image(5, 0), std::invalid_argument);
    CHECK_THROWS_AS(Image(-1, -1), std::invalid_argument);
}

TEST_CASE("make_image shades every pixel once, row by row from the top", "[image]") {
    std::vector<std::pair<int, int>> order;
    const Image image = rt::make_image(2, 2, [&](int x, int y) {
        order.emplace_back(x, y);
        return Color{static_cast<rt::Real>(x), static_cast<rt::Real>(y), 0};
    });
    CHECK(order == std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {0, 1}, {1, 1}});
    CHECK(image.at(1, 0) == Color{1, 0, 0});
    CHECK(image.at(0, 1) == Color{0, 1, 0});
}

namespace {

// A canvas that counts how often one of its kind was copied, and how many there are.
struct CountedCanvas {
    static inline int copies = 0, alive = 0;
    std::vector<Color> colors;

    CountedCanvas(int width, int height)
        : colors(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        ++alive;
    }
    CountedCanvas(const CountedCanvas& other) : colors{other.colors} {
        ++copies;
        ++alive;
    }
    CountedCanvas(CountedCanvas&& other) noexcept : colors{std::move(other.colors)} { ++alive; }
    ~CountedCanvas() { --alive; }
    int width() const { return 3; }
    int height() const { return 2; }
    Color* begin() { return colors.data(); }
};

}  // namespace

TEST_CASE("an image takes over a canvas without copying it and gives it up at its end", "[image]") {
    CountedCanvas::copies = 0;
    {
        CountedCanvas canvas{3, 2};
        const Color* const pixels = canvas.begin();
        canvas.begin()[4] = {1, 0, 0};
        Image image = std::move(canvas);
        CHECK(&image.at(0, 0) == pixels);
        CHECK(image.at(1, 1) == Color{1, 0, 0});
        Image moved = std::move(image);
        CHECK(&moved.at(0, 0) == pixels);
        CHECK(image.width() == 0);
        CHECK(image.pixels().empty());
        CHECK(CountedCanvas::copies == 0);
        Image copy = moved;
        CHECK(CountedCanvas::copies == 1);
        CHECK(copy == moved);
        CHECK(&copy.at(0, 0) != pixels);
        copy = std::move(moved);
        CHECK(&copy.at(0, 0) == pixels);
        CHECK(CountedCanvas::copies == 1);
        const Image made = rt::make_image<CountedCanvas>(3, 2, [](int, int) { return Color{}; });
        CHECK(CountedCanvas::alive >= 2);
        CHECK(CountedCanvas::copies == 1);
    }
    CHECK(CountedCanvas::alive == 0);
}
