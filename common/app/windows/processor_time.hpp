#pragma once
#include <windows.h>

namespace app {

// The processor time that a process or a thread has used, in seconds; 0 if the system does not
// tell. `ask` is GetProcessTimes or GetThreadTimes.
inline double processor_seconds(decltype(::GetProcessTimes)& ask, HANDLE of) {
    FILETIME begin, end, kernel, user;
    if (!ask(of, &begin, &end, &kernel, &user)) return 0;
    const auto seconds = [](const FILETIME& time) {  // counted in steps of 100 ns
        return (4294967296.0 * time.dwHighDateTime + time.dwLowDateTime) / 10'000'000;
    };
    return seconds(kernel) + seconds(user);
}

}  // namespace app
