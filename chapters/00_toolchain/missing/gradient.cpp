// The linker uses this definition while the learner's gradient.cpp has none: this file is in a
// library, and from a library the linker takes only what all other files leave undefined.

#include <rt/gradient.hpp>
#include <rt/todo.hpp>

namespace rt {

Color gradient(const Corners& corners, Real across, Real down) {
    return todo({"00.2", "exercises/00_toolchain/rt/gradient.cpp", 18}, corners, across, down);
}

}  // namespace rt
