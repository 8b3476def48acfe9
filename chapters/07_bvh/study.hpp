#pragma once
#include <study/report.hpp>

namespace bvh {

// What a ray costs in each structure, how this cost grows with the number of spheres, how long a
// good tree takes to build, and how the time of a whole picture compares with the classic way.
void run_study(study::Report& report);

}  // namespace bvh
