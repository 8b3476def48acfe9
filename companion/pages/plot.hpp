#pragma once
#include <companion/pages/captions.hpp>
#include <companion/pages/measurements.hpp>
#include <map>
#include <string>
#include <vector>

namespace companion {

// An SVG picture of the rows of one study: a color and a shape of dots per variant, whose name
// stands at the end of its line; solid lines for double and dashed lines for float. If x takes
// three values or more, error and cost are drawn over x, one above the other, or only the error if
// the cost does not depend on x; otherwise error is drawn over cost. If only one of the two was
// measured, it is drawn over x, or as bars if x takes fewer values or each variant has a single one
// in each precision. The caption may choose otherwise.
std::string plot_svg(const Measurements& rows, const Caption& caption = {});

// What a smaller error costs in several studies of the same variants: one panel for each study,
// error over cost, with the frontier, which is made of the rows that no other row beats in both.
// The named variants have colors, all others are gray.
std::string trade_svg(const std::vector<Measurements>& studies,
                      const std::vector<std::string>& named, const Caption& caption = {});

// The name of the file for a study's plot: NN_topic-STUDY.svg for a study in NN_topic.csv.
std::string plot_file(const std::filesystem::path& table, const std::string& study);

// The plots of a table, by file name: one for each study, but only one for accuracy.csv, which
// compares all settings on several scenes.
std::map<std::string, std::string> plots_of(const std::filesystem::path& table,
                                            const Captions& captions);

}  // namespace companion
