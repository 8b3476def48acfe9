#pragma once
// Programs that may not start others.

namespace companion {

// From now on, this process may start threads, and may become the program at this address. If it,
// or that program, starts anything else, SIGSYS ends it. Where the system has no such means,
// nothing happens. Calls only the system, so it may be called between fork and exec.
void confine_to(const char* program);

}  // namespace companion
