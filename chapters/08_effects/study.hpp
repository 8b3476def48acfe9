#pragma once
#include <study/report.hpp>
namespace effects {
inline void study_effects(study::Report&) {}
}  // namespace effects
