#include <app/figure.hpp>

#include "checkpoint.hpp"

using app::Figure;
using rt::Color;
using rt::Image;
using rt::Real;

namespace {

const Color white{1, 1, 1};

// How many pixels are not black.
int painted(const Image& image) {
    int count = 0;
    for (const Color& color : image.pixels()) count += color != Color{};
    return count;
}

}  // namespace

TEST_CASE("a figure's units fill the image, and lie in its middle", "[figure]") {
    Image image{40, 20};
    Figure figure{image, 10, 10};  // 2 pixels per unit, and 10 pixels left free on both sides
    figure.box({0, 0, 10, 10}, white);
    CHECK(painted(image) == 20 * 20);
    CHECK(image.at(9, 0) == Color{});
    CHECK(image.at(10, 0) == white);
    CHECK(image.at(29, 19) == white);
    CHECK(image.at(30, 19) == Color{});
}

TEST_CASE("nothing that is drawn in a part reaches beyond it", "[figure]") {
    Image image{20, 20};
    Figure part = Figure{image}.part(app::pixel_box(5, 6, 4, 3));
    CHECK(part.columns() == 4);
    CHECK(part.rows() == 3);
    SECTION("its pixels") {
        part.fill([](int x, int y) { return Color{Real(x + 1), Real(y + 1), 0}; });
        CHECK(image.at(5, 6) == Color{1, 1, 0});
        CHECK(image.at(8, 8) == Color{4, 3, 0});
    }
    SECTION("a line through it") {
        part.line({-9, 1}, {30, 2}, white, 40);
    }
    SECTION("a box around it") {
        part.box({-9, -9, 50, 50}, white);
    }
    CHECK(painted(image) == 12);
}

TEST_CASE("what lies beside the image is left out", "[figure]") {
    Image image{6, 4};
    Figure figure{image};
    const auto paint = [&](const app::Box& box) {
        Figure part = figure.part(box);
        part.fill([](int, int) { return white; });
        part.line({0, 0}, {box.width, box.height}, white, 3);
        part.words({0, 0}, "WORDS", {8, white});
    };
    paint({6, 4, 5, 5});
    paint({50, 0, 5, 5});
    CHECK(painted(image) == 0);
    paint({4, 3, 100, 100});
    CHECK(painted(image) == 2);
}

TEST_CASE("a part without a pixel has one for a camera, and paints none", "[figure]") {
    Image image{6, 4};
    Figure part = Figure{image}.part({2, 2, 0, 0});
    CHECK(part.columns() == 1);
    CHECK(part.rows() == 1);
    part.fill([](int, int) { return white; });
    CHECK(painted(image) == 0);
}

TEST_CASE("an edge between pixels is smooth", "[figure]") {
    Image image{4, 1};
    Figure{image}.box({Real(0.25), -5, 2, 11}, white);
    CHECK(std::abs(image.at(0, 0).r - Real(0.75)) < Real(0.001));
    CHECK(image.at(1, 0) == white);
    CHECK(std::abs(image.at(2, 0).r - Real(0.25)) < Real(0.001));
    CHECK(image.at(3, 0) == Color{});
}

TEST_CASE("a share of a color is mixed in", "[figure]") {
    Image image{3, 3, {1, 0, 0}};
    Figure{image}.box(app::pixel_box(0, 0, 3, 3), {0, 1, 0}, Real(0.25));
    CHECK(image.at(1, 1) == Color{Real(0.75), Real(0.25), 0});
}

TEST_CASE("words end where their width says", "[figure]") {
    const Real height = 20, width = app::width_of("HH", height);
    Image image{60, 30};
    Figure figure{image};
    SECTION("from their top left corner") {
        figure.words({30 - width / 2, 5}, "HH", {height, white});
    }
    SECTION("from their top right corner") {
        figure.words_before({30 + width / 2, 5}, "HH", {height, white});
    }
    SECTION("around their middle") {
        figure.words_around({30, 15}, "HH", {height, white});
    }
    // The strokes are 3.6 pixels thick, so they reach 1.8 beyond.
    const auto ink_in = [&](int column) { return image.at(column, 8).r; };
    CHECK(ink_in(static_cast<int>(30 - width / 2)) > Real(0.9));
    CHECK(ink_in(static_cast<int>(30 + width / 2)) > Real(0.9));
    CHECK(ink_in(static_cast<int>(30 - width / 2) - 3) == 0);
    CHECK(ink_in(static_cast<int>(30 + width / 2) + 3) == 0);
}

TEST_CASE("words that are too small to be read are left out", "[figure]") {
    Image image{60, 30};
    Figure{image}.words({3, 3}, "TINY", {2, white});
    CHECK(painted(image) == 0);
}

TEST_CASE("no two letters look alike", "[figure]") {
    // Where a letter has ink, on a grid of points that is as wide and high as any letter.
    const auto ink = [](char letter) {
        std::vector<bool> points;
        for (int row = -1; row < 22; ++row)
            for (int column = -1; column < 10; ++column)
                points.push_back(app::distance_to_text(
                                     {static_cast<Real>(column) / 4, static_cast<Real>(row) / 4},
                                     {&letter, 1}) < Real(0.3));
        return points;
    };
    const std::string letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789*-+=/.,:";
    for (const char one : letters) {
        const std::vector<bool> points = ink(one);
        INFO(one);
        CHECK(app::width_of(one) <= 2);
        CHECK(std::count(points.begin(), points.end(), true) > 0);
        for (const char other : letters) {
            if (other <= one) continue;
            int apart = 0;
            const std::vector<bool> more = ink(other);
            for (std::size_t i = 0; i < points.size(); ++i) apart += points[i] != more[i];
            INFO(other);
            CHECK(apart >= 5);
        }
    }
}

TEST_CASE("small letters reach below the line and are drawn whole", "[figure]") {
    Image image{40, 40};
    Figure{image}.words({10, 10}, "gy", {16, white});
    Color below;
    for (int column = 0; column < 40; ++column) below += image.at(column, 29);
    CHECK(below.r > 0);
    CHECK(app::width_of("ii") < app::width_of("mm"));
}
