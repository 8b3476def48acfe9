#pragma once
#include <study/report.hpp>

namespace bvh {

// What a ray costs in each structure, how that grows, what a good tree costs to build, and the
// whole against the classic way.
void run_study(study::Report& report);

}  // namespace bvh
