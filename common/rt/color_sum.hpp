#pragma once
#include <rt/color.hpp>

namespace rt {

// A sum of many colors, kept to compute their mean (given). The sum is in double, whatever Real is.
// In float, the mean of a million equal colors can be off by about 1 %: when a color is added to so
// large a sum, most of its digits are rounded off, many times in a row in the same direction.
class ColorSum {
  public:
    void add(const Color& color) {
        r_ += static_cast<double>(color.r);
        g_ += static_cast<double>(color.g);
        b_ += static_cast<double>(color.b);
    }

    // The mean of the colors that were added. `count`, at least 1, is their number.
    Color mean(int count) const {
        return {static_cast<Real>(r_ / count), static_cast<Real>(g_ / count),
                static_cast<Real>(b_ / count)};
    }

  private:
    double r_ = 0, g_ = 0, b_ = 0;
};

}  // namespace rt
