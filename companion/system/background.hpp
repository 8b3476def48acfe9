#pragma once
#include <functional>

namespace companion {

// Does the work in a process of its own, at low priority, for which this one does not wait. The
// process has no terminal. Its work is over, as it can ask, when the terminal closes that is this
// program's standard output. False if the system has no such processes.
bool in_background(const std::function<void(const std::function<bool()>& is_over)>& work);

}  // namespace companion
