#pragma once
#include <study/report.hpp>

namespace triangles {

// What three ways to meet a triangle cost, how many rays slip through a closed mesh, and how far
// off t is.
void run_study(study::Report& report);

}  // namespace triangles
