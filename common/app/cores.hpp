#pragma once

namespace app {

// The number of physical cores, at least 1. Two threads on one core share its arithmetic units, so
// the number of logical cores would promise too much. If the system does not tell, the result is
// the number of threads that can run at once.
int physical_cores();

}  // namespace app
