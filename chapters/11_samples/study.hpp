#pragma once
#include <study/report.hpp>

namespace samples {

// What each way of taking samples, and of stopping, costs and is worth.
void run_study(study::Report& report);

}  // namespace samples
