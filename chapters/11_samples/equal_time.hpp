#pragma once
#include <study/report.hpp>

namespace samples {

// What each way to draw the cover achieves in the same time.
void study_equal_time(study::Report& report);

}  // namespace samples
