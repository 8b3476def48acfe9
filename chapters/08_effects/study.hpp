#pragma once
#include <study/report.hpp>

namespace effects {

// How well each way finds light, how many digits the formulas lose, and what each effect costs.
void run_study(study::Report& report);

}  // namespace effects
