#pragma once
// Programs that may not start others.

namespace companion {

// From here on this process may become the program at this address, and start threads. What else
// it starts, it or that program, ends it with SIGSYS. Where the system has no such means, nothing
// happens. Calls nothing but the system, so it may stand between fork and exec.
void confine_to(const char* program);

}  // namespace companion
