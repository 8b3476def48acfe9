#pragma once
#include <study/report.hpp>

namespace samples {

// What each way to draw the cover makes of the same time.
void study_equal_time(study::Report& report);

}  // namespace samples
