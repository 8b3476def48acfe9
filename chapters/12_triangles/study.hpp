#pragma once
#include <study/report.hpp>

namespace triangles {

// Measures three tests for a ray and a triangle: what each costs, how many rays slip through a
// closed mesh, and how far off t is.
void run_study(study::Report& report);

}  // namespace triangles
