#pragma once
#include <study/report.hpp>

namespace accuracy {

// What each way to draw the cover achieves in the same time, against the classic recipe.
void study_equal_time(study::Report& report);

}  // namespace accuracy
