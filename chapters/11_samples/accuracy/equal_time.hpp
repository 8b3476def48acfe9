#pragma once
#include <study/report.hpp>

namespace accuracy {

// Measures what each way to draw the cover scene achieves in the same time, compared with the
// classic recipe.
void study_equal_time(study::Report& report);

}  // namespace accuracy
