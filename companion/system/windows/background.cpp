#include <companion/system/background.hpp>

namespace companion {

// A window of MSYS2 is no console, so a process could not tell when it closes.
bool in_background(const std::function<void(const std::function<bool()>&)>&) {
    return false;
}

}  // namespace companion
