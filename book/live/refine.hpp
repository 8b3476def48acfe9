#pragma once
// A picture that gets better while one waits: first a coarse one, at once; then a sample of every
// pixel, over and over, and what is shown is their average.

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
        for (int row = 0; row < rows; row += coarse)
            for (int column = 0; column < columns; column += coarse) fill(column, row);
    }

    // Draws one more row. False when there is nothing left to do.
    bool more() {
        if (done_ == samples_) return false;
        for (int column = 0; column < bytes_.columns; ++column) {
            rt::ColorSum& sum = sums_[static_cast<std::size_t>(row_ * bytes_.columns + column)];
            sum.add(shade_(column, row_, done_));
            bytes_.set(column, row_, sum.mean(done_ + 1));
        }
        if (++row_ == bytes_.rows) row_ = 0, ++done_;
        return done_ < samples_;
    }

    int done() const { return done_; }  // samples of every pixel
    int samples() const { return samples_; }
    const Bytes& bytes() const { return bytes_; }

    // The average light of the whole picture, of the samples so far.
    rt::Color mean() const {
        rt::ColorSum sum;
        for (const rt::ColorSum& pixel : sums_) sum.add(pixel.mean(std::max(1, done_)));
        return sum.mean(static_cast<int>(sums_.size()));
    }

  private:
    static constexpr int coarse = 4;

    // A square of the coarse picture: its middle pixel's color.
    void fill(int column, int row) {
        const int right = std::min(column + coarse, bytes_.columns),
                  bottom = std::min(row + coarse, bytes_.rows);
        const rt::Color color = shade_((column + right) / 2, (row + bottom) / 2, 0);
        for (int y = row; y < bottom; ++y)
            for (int x = column; x < right; ++x) bytes_.set(x, y, color);
    }

    Bytes bytes_;
    std::vector<rt::ColorSum> sums_;
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
    text_size = 13, bold = on_picture = false;
    list_.clear(), words_.clear(), pictures_.clear();
    count_ = 0;
    refinement_.reset();
}

}  // namespace live
