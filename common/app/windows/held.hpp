#pragma once
// A viewer, a backup, a virus scanner or OneDrive may hold a file for a moment.

#include <windows.h>

#include <chrono>
#include <thread>

namespace app {

// Whether a function of Windows that failed with this error may succeed a moment later.
inline bool is_held(DWORD error) {
    return error == ERROR_ACCESS_DENIED || error == ERROR_SHARING_VIOLATION ||
           error == ERROR_LOCK_VIOLATION;
}

// Calls attempt() again and again until it returns true, which means that no further attempt is
// needed, but for 3 s at most.
template <class Attempt>
void until_released(const Attempt& attempt) {
    for (int tries = 300; !attempt() && tries > 0; --tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

}  // namespace app
