#pragma once
#include <study/report.hpp>

namespace samples {

// Measures the cost and the worth of each way to take samples, and of each rule for stopping.
void run_study(study::Report& report);

}  // namespace samples
