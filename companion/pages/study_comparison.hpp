#pragma once
#include <companion/pages/measurements.hpp>
#include <string>
#include <vector>

namespace companion {

// Where a table that was measured on the learner's code differs from one on the solution's: a line
// a variant whose worst error differs by a tenth or more, or whose cost does by half. Times of one
// machine in use differ by less. Says so where none differs.
std::string study_comparison(const std::vector<Measurement>& mine,
                             const std::vector<Measurement>& solution);

}  // namespace companion
