#pragma once
#include <companion/pages/measurements.hpp>
#include <string>
#include <vector>

namespace companion {

using Quantity = double study::Row::*;

// Whether this row measured the quantity: an error or a cost without a name was not measured.
bool measured(const Measurement& row, Quantity quantity);

// A value as a person writes it, with three digits: "0.021", "19,620", "7.3·10⁻¹²", "∞".
std::string shown(double value);

// How many letters a text has.
std::size_t letters(const std::string& text);

// A length in a picture, with one decimal at most.
std::string px(double length);

// Where a picture shows the values of one quantity: by their logarithm if they span more than a
// factor of 16. Values that do not fit such an axis have places of their own: 0 on a logarithmic
// axis; infinity and NaN on any.
class Axis {
  public:
    struct Mark {
        double at;
        std::string name;
        bool is_apart;  // a place of its own
    };

    // From left to right, or from the bottom up to the top.
    Axis(const Measurements& rows, Quantity quantity, double from, double to);

    double from() const { return from_; }
    double to() const { return to_; }
    double at(double value) const;

    // As many values as fit beside the axis: round ones, or all that an x takes.
    std::vector<Mark> marks() const;

  private:
    double place(double value) const;
    std::vector<Mark> named(const std::vector<double>& values) const;
    bool fit(const std::vector<Mark>& marks) const;

    double from_, to_;
    bool is_logarithmic_, has_zero_ = false, has_infinite_ = false;
    double least_, most_;  // on a logarithmic axis their logarithms
    double zero_, infinite_, low_, high_;
    std::vector<double> values_;  // of x
};

}  // namespace companion
