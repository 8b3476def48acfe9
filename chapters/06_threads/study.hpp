#pragma once
#include <study/report.hpp>
namespace threads {
inline void study_workers(study::Report&) {}
}  // namespace threads
