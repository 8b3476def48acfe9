#pragma once
#include <companion/pages/measurements.hpp>
#include <string>
#include <vector>

namespace companion {

// Where a table measured on the learner's code differs from one measured on the solution's: a table
// of the variants whose worst error differs by a tenth or more, or whose cost differs by half, and
// by more than two runs of the solution differ from each other. If none differs, says so.
std::string study_comparison(const std::vector<Measurement>& mine,
                             const std::vector<Measurement>& solution,
                             const std::vector<Measurement>& solution_again);

}  // namespace companion
