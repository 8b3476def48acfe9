#include <limits>
#include <memory>
#include <rt/for_each_pixel.hpp>
#include <rt/rng.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"

using rt::Tile;

namespace {

struct Pixel {
    int column, row;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

std::string text(const Pixel& pixel) {
    return "column " + std::to_string(pixel.column) + " of row " + std::to_string(pixel.row);
}
std::string text(const Tile& tile) {
    return "columns " + std::to_string(tile.left) + " to just before " +
           std::to_string(tile.right) + ", rows " + std::to_string(tile.top) + " to just before " +
           std::to_string(tile.bottom);
}

// Stops if there are more calls than the tile has pixels, since a loop may never end.
std::vector<Pixel> visited(const Tile& tile, std::size_t most) {
    std::vector<Pixel> pixels;
    rt::for_each_pixel(tile, [&](int column, int row) {
        if (pixels.size() == most) {
            const Pixel first = pixels.empty() ? Pixel{column, row} : pixels[0];
            FAIL("tile: " << text(tile) << "\n" EXPECTED << most
                          << " calls, actual: more; the next call is for "
                          << text(Pixel{column, row}) << ".\nHint: "
                          << (first.column < tile.left || first.row < tile.top
                                  ? "the loops begin at tile.left and tile.top, not at 0"
                                  : "the end of a tile does not belong to it: compare with <, not "
                                    "with <=. The outer loop counts with ++row, the inner one "
                                    "with ++column"));
        }
        pixels.push_back({column, row});
    });
    return pixels;
}

void check(const Tile& tile) {
    std::vector<Pixel> expected;
    if (tile.left < tile.right && tile.top < tile.bottom) {
        const long long width = static_cast<long long>(tile.right) - tile.left;
        const long long height = static_cast<long long>(tile.bottom) - tile.top;
        for (long long i = 0; i < width * height; ++i)
            expected.push_back(
                {static_cast<int>(tile.left + i % width), static_cast<int>(tile.top + i / width)});
    }
    const std::vector<Pixel> actual = visited(tile, expected.size());
    INFO("tile: " << text(tile));
    for (std::size_t i = 0; i < actual.size(); ++i) {
        if (actual[i] == expected[i]) continue;
        const Pixel swapped{actual[i].row, actual[i].column};
        INFO("call number " << i << ": " EXPECTED << text(expected[i]) << ", " ACTUAL
                            << text(actual[i]) << ".\nHint: "
                            << (swapped == expected[i]
                                    ? "the column comes first: visit(column, row)"
                                    : "rows in the outer loop, from the top; columns in the inner "
                                      "one, from the left"));
        REQUIRE(text(actual[i]) == text(expected[i]));
    }
    INFO("Hint: the last column is right - 1, and the last row is bottom - 1");
    REQUIRE(actual.size() == expected.size());
}

}  // namespace

TEST_CASE("02.5 each row is visited from left to just before right", "[02.5]") {
    check({0, 0, 1, 1});
    check({0, 0, 5, 1});
    check({0, 0, 2, 1});
}

TEST_CASE("02.5 the rows are visited from top to just before bottom", "[02.5]") {
    check({0, 0, 1, 4});
    check({0, 0, 3, 2});
    check({0, 0, 2, 3});
    check({0, 0, 4, 4});
}

TEST_CASE("02.5 a tile may begin anywhere", "[02.5]") {
    check({7, 0, 9, 2});
    check({0, 7, 2, 9});
    check({16, 32, 32, 48});
    check({3, 5, 4, 6});
    check({100, 2, 103, 4});
    check({2, 100, 4, 103});
    check({-3, -2, 2, 1});
}

TEST_CASE("02.5 a tile may be the whole picture", "[02.5]") {
    check({0, 0, 96, 54});
    check({0, 0, 54, 96});
    check({0, 0, 1, 1000});
    check({0, 0, 1000, 1});
}

TEST_CASE("02.5 every pixel is visited in any tile of a picture", "[02.5]") {
    rt::Rng rng{25, 1};
    for (int i = 0; i < 500; ++i) {
        const auto place = [&] { return static_cast<int>(rng() % 2000); };
        const int left = place(), top = place();
        check({left, top, left + 1 + place() % 20, top + 1 + place() % 20});
    }
}

TEST_CASE("02.5 visit may itself go over the pixels of a tile", "[02.5]") {
    int calls = 0;
    rt::for_each_pixel({0, 0, 2, 2}, [&](int, int) {
        if (calls < 100) rt::for_each_pixel({5, 5, 6, 8}, [&](int, int) { ++calls; });
    });
    CHECK(calls == 12);
}

TEST_CASE("02.5 no call is made for a tile without pixels", "[02.5]") {
    for (const Tile& tile :
         {Tile{}, Tile{5, 5, 5, 5}, Tile{5, 0, 5, 3}, Tile{0, 5, 3, 5}, Tile{6, 0, 5, 3},
          Tile{0, 6, 3, 5}, Tile{9, 9, 2, 2}, Tile{0, 0, -1, -1}, Tile{0, 0, 3, -2}})
        check(tile);
}

TEST_CASE("02.5 every pixel is visited in very wide and very tall tiles", "[02.5][hard]") {
    check({0, 0, 70'000, 2});
    check({0, 0, 2, 70'000});
}

TEST_CASE("02.5 every pixel is visited at both ends of the range of int", "[02.5][hard]") {
    constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
    check({most - 3, most - 2, most, most});
    check({least, least, least + 3, least + 2});
}

TEST_CASE("02.5 an exception from visit ends the loop and reaches the caller", "[02.5]") {
    int calls = 0;
    bool came_through = false;
    try {
        rt::for_each_pixel(Tile{0, 0, 4, 4}, [&](int, int) {
            if (++calls == 6) throw std::out_of_range("the sixth");
        });
    } catch (const std::out_of_range&) {
        came_through = true;
    }
    CHECK(came_through);
    CHECK(calls == 6);
}

TEST_CASE("02.5 the same visit is called for all pixels and never copied", "[02.5][hard]") {
    // It has a counter of its own, and cannot be copied.
    std::vector<int> counts;
    rt::for_each_pixel(Tile{0, 0, 3, 2}, [&counts, count = std::make_unique<int>(0)](
                                             int, int) mutable { counts.push_back(++*count); });
    CHECK(counts == std::vector<int>{1, 2, 3, 4, 5, 6});
}
