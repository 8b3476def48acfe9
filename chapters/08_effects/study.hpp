#pragma once
#include <study/report.hpp>

namespace effects {

// What it takes to find light, what the formulas lose, and what each effect costs.
void run_study(study::Report& report);

}  // namespace effects
