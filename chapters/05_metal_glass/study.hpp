#pragma once
#include <study/report.hpp>
namespace metal_glass_study {
inline void run(study::Report&) {}
}  // namespace metal_glass_study
