#pragma once
#include <study/report.hpp>

namespace threads {

// What it costs to use several threads: workers that wait, tiles that are too small or too large,
// memory that two workers write to in turn, a counter that all share.
void run_study(study::Report& report);

}  // namespace threads
