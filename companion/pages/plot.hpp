#pragma once
#include <companion/pages/measurements.hpp>
#include <string>
#include <vector>

namespace companion {

// A gnuplot script that draws the rows of one study into an SVG file: a color a variant, double
// solid and float dashed. Where x takes three values or more, error and cost are drawn over x side
// by side, or the error alone where the cost does not depend on x; else error against cost. A study
// that timed nothing gets a bar a variant.
std::string plot_script(const std::vector<Measurement>& rows, const std::string& svg_file);

}  // namespace companion
