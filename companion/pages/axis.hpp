#pragma once
#include <companion/pages/measurements.hpp>
#include <string>
#include <vector>

namespace companion {

using Quantity = double study::Row::*;

// Whether this row measured the quantity: an error or a cost without a name was not measured.
bool measured(const Measurement& row, Quantity quantity);

// A value in the form in which a person writes it, with three digits: "0.021", "19,620",
// "7.3·10⁻¹²", "∞".
std::string shown(double value);

// Digits as they are written in a power: "7" becomes "⁷".
std::string raised(const std::string& digits);

// How many letters a text has.
std::size_t letters(const std::string& text);

// A length in a picture, with one decimal at most.
std::string px(double length);

// The positions in a picture that stand for the values of one quantity. The scale is logarithmic if
// the values span more than a factor of 16. Values that do not fit on such an axis have a separate
// position: 0 on a logarithmic axis; infinity and NaN on any axis.
class Axis {
  public:
    struct Mark {
        double at;
        std::string name;
        bool is_apart;  // has a separate position
    };

    // Where an axis begins: as its values ask for; at zero, and never logarithmic; or near the
    // least value, and never logarithmic.
    enum class From { values, zero, least };

    // The axis runs from left to right, or from bottom to top.
    Axis(const Measurements& rows, Quantity quantity, double from, double to,
         From begins = From::values);

    double from() const { return from_; }
    double to() const { return to_; }
    bool is_logarithmic() const { return is_logarithmic_; }
    double at(double value) const;

    // As many marks as fit beside the axis: at round values, or at all values that x takes.
    std::vector<Mark> marks() const;

  private:
    double place(double value) const;
    std::vector<Mark> named(const std::vector<double>& values) const;
    bool fit(const std::vector<Mark>& marks) const;

    double from_, to_;
    bool is_logarithmic_, has_zero_ = false, has_infinite_ = false;
    double least_, most_;  // their logarithms if the axis is logarithmic
    double zero_, infinite_, low_, high_;
    std::vector<double> values_;  // of x
};

}  // namespace companion
