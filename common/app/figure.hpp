#pragma once
// Drawing a chapter's figure: panels, lines, boxes and words on an image, with smooth edges.

#include <algorithm>
#include <app/lettering.hpp>
#include <functional>
#include <rt/image.hpp>
#include <rt/tile.hpp>
#include <string_view>

namespace app {

class Progress;

// Positions and lengths are in units of the figure; y grows downward.
struct Box {
    rt::Real left = 0, top = 0, width = 0, height = 0;

    rt::Real right() const { return left + width; }
    rt::Real bottom() const { return top + height; }
    rt::Vec2 center() const { return {left + width / 2, top + height / 2}; }
};

// A box of whole pixels, for figures whose unit is a pixel.
Box pixel_box(int left, int top, int width, int height);

// How words are written: `height` is that of capital letters, and `weight` is half the thickness of
// a stroke, in quarters of the height.
struct Lettering {
    rt::Real height;
    rt::Color color;
    rt::Real weight = rt::Real(0.36);
};

// How wide a text is, from the first letter's left edge to the last one's right edge.
rt::Real width_of(std::string_view text, rt::Real letter_height);

// The average of shade(x, y) at nine points of a pixel, with x and y in pixels. It gives any
// drawing smooth edges.
rt::Color average_of_nine(int column, int row,
                          const std::function<rt::Color(rt::Real x, rt::Real y)>& shade);

// An image, or a part of it, to draw on. A figure does not own its image, which must outlive the
// figure. Colors are mixed in according to a `share`: 1 covers what is there, 0 leaves it as it is.
class Figure {
  public:
    // All of the image; a unit is a pixel.
    explicit Figure(rt::Image& image);
    // A figure of width x height units, in the middle of the image and as large as fits into it.
    Figure(rt::Image& image, rt::Real width, rt::Real height);

    // A part of the figure, with (0, 0) at its own top left corner. Drawing in it changes nothing
    // outside of it.
    Figure part(const Box& box) const;

    // How many columns, and how many rows, of pixels have their middles inside the figure. The
    // result is at least 1, because a camera needs a pixel.
    int columns() const { return std::max(1, columns_); }
    int rows() const { return std::max(1, rows_); }

    // Where the figure's first pixel is in the image.
    int left() const { return left_; }
    int top() const { return top_; }

    // The figure's pixels, for app::fill, which sets one pixel at a time. Pixels outside of the
    // image are ignored.
    rt::Tile pixels() const { return {0, 0, columns_, rows_}; }
    void set(int column, int row, rt::Color color) {
        const int x = left_ + column, y = top_ + row;
        if (x < image_->width() && y < image_->height()) image_->at(x, y) = color;
    }

    // Paints every pixel: shade(column, row) gives the color. Advances the progress with each row.
    void fill(const std::function<rt::Color(int column, int row)>& shade,
              Progress* progress = nullptr);

    // Mixes in color_at(point), with the share share_at(point). Only points in `around`, and one
    // pixel beyond, are visited.
    void blend(const Box& around, const std::function<rt::Real(rt::Vec2)>& share_at,
               const std::function<rt::Color(rt::Vec2)>& color_at);
    // Mixes in color_at(point) wherever distance(point), in units, is below 0. The edge is smooth.
    void paint(const Box& around, const std::function<rt::Real(rt::Vec2)>& distance,
               const std::function<rt::Color(rt::Vec2)>& color_at, rt::Real share = 1);

    // A filled box with round corners; the edge of such a box; a straight line with round ends; a
    // disk.
    void box(const Box& box, rt::Color color, rt::Real share = 1, rt::Real radius = 0);
    void frame(const Box& box, rt::Color color, rt::Real share = 1, rt::Real radius = 0,
               rt::Real thickness = 1);
    void line(rt::Vec2 a, rt::Vec2 b, rt::Color color, rt::Real thickness = 1, rt::Real share = 1);
    void dot(rt::Vec2 center, rt::Real radius, rt::Color color, rt::Real share = 1);

    // An arrow: a dot at `from` and a curve to an arrowhead at `to`. The curve starts toward
    // `leave` and comes in from `arrive`.
    void arrow(rt::Vec2 from, rt::Vec2 leave, rt::Vec2 arrive, rt::Vec2 to, rt::Color color,
               rt::Real thickness = rt::Real(1.6));

    // Words, positioned by their top left corner, top right corner, or middle. Words too
    // small to read are left out.
    void words(rt::Vec2 top_left, std::string_view text, const Lettering& letters);
    void words_before(rt::Vec2 top_right, std::string_view text, const Lettering& letters);
    void words_around(rt::Vec2 middle, std::string_view text, const Lettering& letters);

  private:
    rt::Image* image_;
    rt::Real scale_ = 1;                       // pixels per unit
    rt::Vec2 origin_{};                        // where (0, 0) is, in pixels
    int left_ = 0, top_ = 0, columns_, rows_;  // the figure's pixels; the counts may be 0 or less
};

}  // namespace app
