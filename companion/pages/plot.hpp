#pragma once
#include <companion/pages/measurements.hpp>
#include <map>
#include <string>
#include <vector>

namespace companion {

// An SVG picture of the rows of one study: one color per variant, double solid and float dashed. If
// x takes three values or more, error and cost are drawn over x side by side, or the error alone if
// the cost does not depend on x; otherwise error over cost. Where only one of the two was measured,
// it is drawn over x, or as bars if each variant has a single value in each precision.
std::string plot_svg(const Measurements& rows);

// What an error costs in several studies of the same variants: a panel each, error over cost, with
// the frontier, the rows that no other beats in both.
std::string trade_svg(const std::vector<Measurements>& studies);

// The file for the plot of a study: NN_topic-STUDY.svg for one of NN_topic.csv.
std::string plot_file(const std::filesystem::path& table, const std::string& study);

// The plots of a table, by their files: one for each study, but a single one for accuracy.csv,
// which compares all settings on three scenes.
std::map<std::string, std::string> plots_of(const std::filesystem::path& table);

}  // namespace companion
