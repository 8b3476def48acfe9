#pragma once
// The time that a computation takes, whatever else the machine does.

namespace checkpoint {

// The processor time of this thread so far, in seconds. (std::clock counts in steps of a few
// milliseconds while the process has a timer or a limit of processor time, as checkpoints have.)
double processor_seconds();

}  // namespace checkpoint
