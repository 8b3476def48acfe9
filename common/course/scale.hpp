#pragma once
#include <string>
#include <utility>
#include <vector>

namespace course {

// How the values of one quantity lie along an axis of a plot: linear, or logarithmic where they
// span more than a factor of 16. A logarithmic axis has a place for 0, and each has one for values
// that are infinite or not a number.
class Scale {
  public:
    explicit Scale(const std::vector<double>& values);

    // Where a value is drawn, in the numbers of the axis.
    double place(double value) const;
    // The same as a part of the axis, from 0 at its low end to 1.
    double fraction(double value) const;

    bool is_logarithmic() const { return logarithmic_; }
    double low() const { return low_; }
    double high() const { return high_; }

    // The marks beside the axis: where, and the text in gnuplot's notation.
    std::vector<std::pair<double, std::string>> marks() const;

  private:
    bool logarithmic_ = false, has_zero_ = false, has_infinite_ = false;
    double smallest_ = 0, largest_ = 0;  // of the ordinary values
    double zero_ = 0, infinite_ = 0;     // the places of the others
    double low_ = 0, high_ = 1;          // the ends of the axis
};

}  // namespace course
