#include <limits>
#include <rt/false_colors.hpp>
#include <set>

#include "checkpoint.hpp"

using rt::Color, rt::Real, rt::Shown;

TEST_CASE("a direction's components become channels", "[false_colors]") {
    CHECK(rt::direction_color({0, 0, 1}) == Color{Real(0.5), Real(0.5), 1});
    CHECK(rt::direction_color({-1, 0, 0}) == Color{0, Real(0.5), Real(0.5)});
}

TEST_CASE("each number has a color of its own", "[false_colors]") {
    std::set<std::array<Real, 3>> seen;
    for (int i = 0; i < 100; ++i) {
        const Color color = rt::number_color(i);
        seen.insert({color.r, color.g, color.b});
    }
    CHECK(seen.size() == 100);
}

TEST_CASE("amounts are scaled by their own median", "[false_colors]") {
    // However large or small they are.
    for (const Real unit : {Real(0x1p-90), Real(1), Real(0x1p90)}) {
        std::vector<Real> amounts;
        for (int i = 40; i >= 0; --i) amounts.push_back(static_cast<Real>(i) * unit);
        const rt::AmountScale scale{amounts};
        CHECK(scale.low == 2 * unit);
        CHECK(scale.high == 38 * unit);
        CHECK(scale.place(0) == 0);
        CHECK(scale.place(20 * unit) == Real(0.5));
        CHECK(scale.place(29 * unit) == Real(0.75));
        CHECK(scale.place(40 * unit) == 1);
    }
}

TEST_CASE("amounts that are nearly all the same are in the middle", "[false_colors]") {
    const rt::AmountScale scale{{1, 1, 1, 1}};
    CHECK(scale.place(Real(0.9)) == 0);
    CHECK(scale.place(1) == Real(0.5));
    CHECK(scale.place(Real(1.1)) == 1);
}

TEST_CASE("false colors are explained in words", "[false_colors]") {
    const std::vector<Shown> pixels{Real(1), Real(2), {}, Real(4)};
    const auto [image, words] = rt::false_colors(2, 2, pixels, "the distance");
    CHECK(image.at(1, 0) == rt::heat_color(Real(0.5)));
    CHECK(image.at(0, 1) == rt::nothing_color);
    CHECK(words ==
          "  black is 1 or less, red the median, 2, white 4 or more: the distance\n"
          "  gray: nothing but sky\n");
    CHECK(rt::false_colors(1, 1, {7}, "the spheres").words ==
          "  a color for each of the spheres, by its number: 1 is seen\n");
}

TEST_CASE("what is no number stands out and does not reach the image", "[false_colors]") {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    const std::vector<Shown> pixels{Real(1), nan, rt::Vec3{nan, 0, 0}, -rt::infinity};
    const auto [image, words] = rt::false_colors(4, 1, pixels, "x");
    CHECK(image.at(0, 0) == rt::heat_color(Real(0.5)));
    CHECK(image.at(1, 0) == Color{1, 1, 1});
    CHECK(image.at(2, 0) == Color{});
    CHECK(image.at(3, 0) == Color{1, 1, 1});
    CHECK(words.find("black and white dots: NaN or infinity, in 3 pixels") != std::string::npos);
    const std::string of_one = rt::false_colors(2, 1, {Real(1), nan}, "x").words;
    CHECK(of_one.find("NaN or infinity, in 1 pixel\n") != std::string::npos);
}
