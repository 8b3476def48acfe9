#include <companion/compare/difference_text.hpp>

#include "catch.hpp"

using companion::describe_difference;
using companion::region_of;
using companion::TileStatistics;

namespace {

TileStatistics tile(std::array<double, 3> mine, std::array<double, 3> solution, int left = 0,
                    int top = 0) {
    TileStatistics test;
    test.tile = {left, top, 16, 16};
    test.mine = mine;
    test.solution = solution;
    return test;
}

}  // namespace

TEST_CASE("the ninths of a picture have names", "[difference_text]") {
    CHECK(region_of({0, 0, 16, 16}, 320, 180) == "upper left");
    CHECK(region_of({150, 0, 16, 16}, 320, 180) == "top");
    CHECK(region_of({304, 0, 16, 16}, 320, 180) == "upper right");
    CHECK(region_of({0, 80, 16, 16}, 320, 180) == "left");
    CHECK(region_of({150, 80, 16, 16}, 320, 180) == "middle");
    CHECK(region_of({304, 80, 16, 16}, 320, 180) == "right");
    CHECK(region_of({0, 176, 16, 4}, 320, 180) == "lower left");
    CHECK(region_of({150, 176, 16, 4}, 320, 180) == "bottom");
    CHECK(region_of({304, 176, 16, 4}, 320, 180) == "lower right");
    CHECK(region_of({0, 0, 1, 1}, 1, 1) == "middle");
}

TEST_CASE("a difference says how much and in which way", "[difference_text]") {
    CHECK(describe_difference({tile({0.969, 0.969, 0.969}, {1, 1, 1})}) == "3.1 % too dark");
    CHECK(describe_difference({tile({0.6, 0.6, 0.6}, {0.5, 0.5, 0.5})}) == "20 % too bright");
    CHECK(describe_difference({tile({0.9, 0.9, 0.9}, {0.3, 0.3, 0.3})}) == "3 times as bright");
    CHECK(describe_difference({tile({0.1, 0.1, 0.1}, {0, 0, 0})}) ==
          "bright where it should be black");
}

TEST_CASE("a channel that stands out is named", "[difference_text]") {
    CHECK(describe_difference({tile({0.5, 0.5, 0.4}, {0.5, 0.5, 0.5})}) ==
          "6.7 % too dark, 20 % too little blue");
    CHECK(describe_difference({tile({0.55, 0.475, 0.475}, {0.5, 0.5, 0.5})}) == "15 % too red");
}

TEST_CASE("light and dark that make up for each other are shapes that moved", "[difference_text]") {
    CHECK(describe_difference(
              {tile({0.6, 0.6, 0.6}, {0.5, 0.5, 0.5}), tile({0.4, 0.4, 0.4}, {0.5, 0.5, 0.5})}) ==
          "drawn differently, by 20 % on average");
}

TEST_CASE("a difference that is too faint for percent names its pixels", "[difference_text]") {
    TileStatistics faint = tile({0.50001, 0.50001, 0.50001}, {0.5, 0.5, 0.5});
    faint.largest_step = 0.3;
    CHECK(
        describe_difference({faint}) ==
        "the light differs by less than 0.1 %, but by more than noise explains; a pixel's mean by "
        "up to 0.3 of 255 steps");
    faint.largest_step = 3;
    faint.still_differing = 1;
    CHECK(describe_difference({faint}) == "1 pixel without noise differs, by up to 3 of 255 steps");
    faint.still_differing = 12;
    CHECK(describe_difference({faint, faint}) ==
          "24 pixels without noise differ, by up to 3 of 255 steps");
}

TEST_CASE("places are named region by region, the largest first", "[difference_text]") {
    const TileStatistics slight = tile({0.9, 0.9, 0.9}, {1, 1, 1}),
                         strong = tile({0.1, 0.1, 0.1}, {1, 1, 1}, 304, 160);
    const auto lines =
        companion::describe_by_region({slight, strong}, std::vector<TileStatistics>(200), 320, 180);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0] == "lower right: 90 % too dark");
    CHECK(lines[1] == "upper left: 10 % too dark");
}
