#pragma once
#include <study/report.hpp>

namespace cluster {

// What keeps the bytes when the samples of a pixel are shared out, and what that costs; and how far
// tiles go, by a simulation of up to 10,000 machines.
void run_study(study::Report& report);

}  // namespace cluster
