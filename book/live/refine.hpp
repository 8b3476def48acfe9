#pragma once
// A picture that gets better while you wait: first in coarse squares, at once; then in smaller
// ones; then with one more sample of every pixel, over and over. It shows their average.

#include <rt/color_sum.hpp>
#include <utility>

#include "live.hpp"

namespace live {

class Refinement {
  public:
    Refinement(int columns, int rows, int samples, Drawing::Shade shade)
        : bytes_{columns, rows},
          sums_(static_cast<std::size_t>(columns * rows)),
          samples_{samples},
          shade_{std::move(shade)} {
        for (int row = 0; row < rows; row += square_) fill_row(row);
        square_ /= 2;
    }

    // Of several workers that draw the same picture, number `part` draws every so many bands of
    // rows. Call it before more().
    void take(int part, int parts) {
        part_ = part, parts_ = parts;
        row_ = first_row();
        if (row_ >= bytes_.rows) done_ = samples_;  // there are fewer bands than workers
    }

    // Draws one more row. False when the picture is done.
    bool more() {
        if (done_ == samples_) return false;
        if (square_ > 1) {
            fill_row(row_);
            if (!advance(square_)) square_ /= 2;
            return true;
        }
        for (int column = 0; column < bytes_.columns; ++column) {
            rt::ColorSum& sum = sums_[static_cast<std::size_t>(row_ * bytes_.columns + column)];
            sum.add(shade_(column, row_, done_));
            bytes_.set(column, row_, sum.mean(done_ + 1));
        }
        if (!advance(1)) ++done_;
        return done_ < samples_;
    }

    int done() const { return done_; }  // samples of every pixel
    int samples() const { return samples_; }
    const Bytes& bytes() const { return bytes_; }

    // The average light of the whole picture over the samples so far.
    rt::Color mean() const {
        rt::ColorSum sum;
        for (const rt::ColorSum& pixel : sums_) sum.add(pixel.mean(std::max(1, done_)));
        return sum.mean(static_cast<int>(sums_.size()));
    }

  private:
    static constexpr int band = 8;  // rows: those of the first squares, and as page.js has it

    int first_row() const { return band * part_; }
    // To the next row of this worker's bands; false at their end, and then back to the first.
    bool advance(int rows) {
        do row_ += rows;
        while (row_ < bytes_.rows && row_ / band % parts_ != part_);
        if (row_ < bytes_.rows) return true;
        row_ = first_row();
        return false;
    }

    // A row of squares, each in its middle pixel's color.
    void fill_row(int row) {
        const int bottom = std::min(row + square_, bytes_.rows);
        for (int column = 0; column < bytes_.columns; column += square_) {
            const int right = std::min(column + square_, bytes_.columns);
            const rt::Color color = shade_((column + right) / 2, (row + bottom) / 2, 0);
            for (int y = row; y < bottom; ++y)
                for (int x = column; x < right; ++x) bytes_.set(x, y, color);
        }
    }

    Bytes bytes_;
    std::vector<rt::ColorSum> sums_;
    int square_ = band;  // a side of the squares, in pixels
    int part_ = 0, parts_ = 1;
    int samples_, done_ = 0, row_ = 0;
    Drawing::Shade shade_;
};

inline void Drawing::refine(Point corner, Point opposite, int columns, int rows, int samples,
                            Shade shade) {
    refinement_ = std::make_unique<Refinement>(columns, rows, samples, std::move(shade));
    show(refinement_->bytes(), corner, opposite);
}

inline void Drawing::start(double page_width, double ratio) {
    width = page_width, pixel_ratio = ratio;
    text_size = 13, bold = code = on_picture = false;
    list_.clear(), words_.clear(), pictures_.clear();
    count_ = 0;
    refinement_.reset();
}

}  // namespace live
