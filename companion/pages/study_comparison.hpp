#pragma once
#include <companion/pages/measurements.hpp>
#include <string>
#include <vector>

namespace companion {

// Compares a table that was measured on the learner's code with one measured on the solution's.
// Returns a table of the variants whose worst error differs by a tenth or more, or whose cost
// differs by half, and by more than two runs of the solution differ from each other. If there is
// none, says so.
std::string study_comparison(const std::vector<Measurement>& mine,
                             const std::vector<Measurement>& solution,
                             const std::vector<Measurement>& solution_again);

}  // namespace companion
