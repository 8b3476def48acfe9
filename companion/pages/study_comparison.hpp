#pragma once
#include <companion/pages/measurements.hpp>
#include <string>
#include <vector>

namespace companion {

// Where a table that was measured on the learner's code differs from one on the solution's: a table
// of the variants whose worst error differs by a tenth or more, or whose cost does by half, and by
// more than two runs of the solution differ from each other. Says so where none differs.
std::string study_comparison(const std::vector<Measurement>& mine,
                             const std::vector<Measurement>& solution,
                             const std::vector<Measurement>& solution_again);

}  // namespace companion
