#pragma once
#include <study/report.hpp>

namespace batches {

// Measures the time of a ray alone, in packets and in batches of several sizes, and how much of it
// each part of the work takes.
void run_study(study::Report& report);

}  // namespace batches
