#pragma once
#include <companion/pages/axis.hpp>
#include <companion/pages/captions.hpp>
#include <string>
#include <vector>

namespace companion {

// The names of the values 1, 2, ... or 0, 1, ... that x takes, if the name of x lists them:
// "absent, present" or "1 boxes, 2 leaves". Otherwise none.
std::vector<std::string> values_of_x(const std::string& x_name);

// A single quantity as bars, or as dots on a logarithmic axis: the largest on top, double above
// float. With `with_x`, x is a part of the names.
std::string bars_svg(const Measurements& rows, Quantity quantity, bool with_x,
                     const Caption& caption);

// A quantity where x stands for things that have names, in double. If there are more variants than
// names, each variant is a row with a dot for each name; otherwise each name is a row with a bar
// for each variant.
std::string named_values_svg(const Measurements& rows, Quantity quantity, const Caption& caption);

}  // namespace companion
