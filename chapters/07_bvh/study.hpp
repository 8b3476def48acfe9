#pragma once
#include <study/report.hpp>

namespace bvh {

// What a ray costs in each structure, how that grows, what a good tree costs to build, and how the
// whole compares with the classic way.
void run_study(study::Report& report);

}  // namespace bvh
