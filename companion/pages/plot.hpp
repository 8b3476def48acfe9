#pragma once
#include <companion/pages/measurements.hpp>
#include <string>
#include <vector>

namespace companion {

// A gnuplot script that draws the rows of one study into an SVG file: one color per variant, double
// solid and float dashed. If x takes three values or more, error and cost are drawn over x side by
// side, or the error alone if the cost does not depend on x; otherwise error over cost. A study
// that timed nothing gets one bar per variant.
std::string plot_script(const std::vector<Measurement>& rows, const std::string& svg_file);

}  // namespace companion
