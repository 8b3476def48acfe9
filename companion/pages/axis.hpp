#pragma once
#include <string>
#include <utility>
#include <vector>

namespace companion {

// How the values of one quantity lie along an axis of a plot: as they are, or by their logarithm
// where they span more than a factor of 16. A logarithmic axis has a place for 0 as well, and every
// axis one for values that are infinite or not a number.
class Scale {
  public:
    explicit Scale(const std::vector<double>& values);

    // Where a value lies, between low() and high(). On a logarithmic axis this is its logarithm.
    double place(double value) const;
    // The same as a part of the axis, from 0 at its low end to 1.
    double fraction(double value) const { return (place(value) - low_) / (high_ - low_); }

    double low() const { return low_; }
    double high() const { return high_; }

    // The marks beside the axis: their places, and texts in gnuplot's notation.
    std::vector<std::pair<double, std::string>> marks() const;

  private:
    bool logarithmic_ = false, has_zero_ = false, has_infinite_ = false;
    double smallest_ = 0, largest_ = 1;  // places of the ordinary values
    double zero_ = 0, infinite_ = 0;     // places of the others
    double low_ = 0, high_ = 1;
};

}  // namespace companion
