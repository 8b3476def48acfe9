// This file is compiled for narrower registers than the rest of the program: see CMakeLists.txt.
// All of its code is in namespaces of its own, so that the linker does not mix up code for
// different widths.

#include <rt/todo.hpp>

#include "lanes.hpp"

namespace rt_16 {
using rt::todo;
}
namespace batches_16 {
using batches::Width;
}
#define rt rt_16
#define batches batches_16
#include "lanes_body.hpp"
#undef batches
#undef rt

batches::Width batches::registers_of_16_bytes() {
    return batches_16::make_width();
}
