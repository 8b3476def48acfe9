#pragma once
#include <study/report.hpp>

namespace cluster {

// Compares ways to share out the samples of a pixel: which of them keep the picture's bytes, and
// what they cost. Then simulates up to 10,000 machines that share out tiles.
void run_study(study::Report& report);

}  // namespace cluster
