#pragma once
// The time that a computation takes, whatever else the machine does.

#include <time.h>

namespace checkpoint {

// The processor time of this thread so far, in seconds. (std::clock counts in steps of a few
// milliseconds while the process has a timer or a limit of processor time, as checkpoints have.)
inline double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace checkpoint
