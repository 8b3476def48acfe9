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

// Places and lengths are in units of the figure; y grows downwards.
struct Box {
    rt::Real left = 0, top = 0, width = 0, height = 0;

    rt::Real right() const { return left + width; }
    rt::Real bottom() const { return top + height; }
    rt::Vec2 center() const { return {left + width / 2, top + height / 2}; }
};

// For figures whose unit is a pixel.
Box pixel_box(int left, int top, int width, int height);

// How words are written: with capital letters of this height. Half the thickness of a stroke is
// `weight` quarters of it.
struct Lettering {
    rt::Real height;
    rt::Color color;
    rt::Real weight = rt::Real(0.36);
};

// How wide a text is, from the first letter's left edge to the last one's right edge.
rt::Real width_of(std::string_view text, rt::Real letter_height);

// The average of shade(x, y) at nine places in a pixel, in pixels: smooth edges for any drawing.
rt::Color average_of_nine(int column, int row,
                          const std::function<rt::Color(rt::Real x, rt::Real y)>& shade);

// An image, or a part of it, to draw on. It does not own the image, which must outlive it. Colors
// are mixed in by their `share`: 1 covers what is there, 0 leaves it as it is.
class Figure {
  public:
    // All of the image; a unit is a pixel.
    explicit Figure(rt::Image& image);
    // So many units wide and high, as large as the image has room for, in its middle.
    Figure(rt::Image& image, rt::Real width, rt::Real height);

    // A part whose own top left corner is (0, 0). What is drawn in it does not reach beyond it.
    Figure part(const Box& box) const;

    // The pixels whose middles lie within; for a camera's sake at least one, even where none does.
    int columns() const { return std::max(1, columns_); }
    int rows() const { return std::max(1, rows_); }

    // Its pixels, for app::fill; one of them, where the image has it.
    rt::Tile pixels() const { return {0, 0, columns_, rows_}; }
    void set(int column, int row, rt::Color color) {
        const int x = left_ + column, y = top_ + row;
        if (x < image_->width() && y < image_->height()) image_->at(x, y) = color;
    }

    // Paints every pixel: shade(column, row) gives the color. Steps the progress with each row.
    void fill(const std::function<rt::Color(int column, int row)>& shade,
              Progress* progress = nullptr);

    // Mixes in colors by a share of their own at each place. Only places in `around` are looked at,
    // and one pixel beyond.
    void blend(const Box& around, const std::function<rt::Real(rt::Vec2)>& share_at,
               const std::function<rt::Color(rt::Vec2)>& color_at);
    // Mixes in colors wherever `distance`, in units, is below 0, with a smooth edge.
    void paint(const Box& around, const std::function<rt::Real(rt::Vec2)>& distance,
               const std::function<rt::Color(rt::Vec2)>& color_at, rt::Real share = 1);

    // A box with round corners, filled or only its edge; a straight line with round ends; a disk.
    void box(const Box& box, rt::Color color, rt::Real share = 1, rt::Real radius = 0);
    void frame(const Box& box, rt::Color color, rt::Real share = 1, rt::Real radius = 0,
               rt::Real thickness = 1);
    void line(rt::Vec2 a, rt::Vec2 b, rt::Color color, rt::Real thickness = 1, rt::Real share = 1);
    void dot(rt::Vec2 center, rt::Real radius, rt::Color color, rt::Real share = 1);

    // A dot, a curve that starts toward `leave` and comes in from `arrive`, and the head of an
    // arrow.
    void arrow(rt::Vec2 from, rt::Vec2 leave, rt::Vec2 arrive, rt::Vec2 to, rt::Color color,
               rt::Real thickness = rt::Real(1.6));

    // Words by the place of their top left corner, top right corner, or middle. What is too small
    // to be read is left out.
    void words(rt::Vec2 top_left, std::string_view text, const Lettering& letters);
    void words_before(rt::Vec2 top_right, std::string_view text, const Lettering& letters);
    void words_around(rt::Vec2 middle, std::string_view text, const Lettering& letters);

  private:
    rt::Image* image_;
    rt::Real scale_ = 1;                       // pixels of a unit
    rt::Vec2 origin_{};                        // where (0, 0) is, in pixels
    int left_ = 0, top_ = 0, columns_, rows_;  // its pixels; none or fewer if it is too small
};

}  // namespace app
