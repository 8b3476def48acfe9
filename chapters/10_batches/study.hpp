#pragma once
#include <study/report.hpp>

namespace batches {

// What a ray costs in batches of any size, in packets and alone, and where the time goes.
void run_study(study::Report& report);

}  // namespace batches
