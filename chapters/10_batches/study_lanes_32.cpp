// This file is compiled for narrower registers than the rest of the program: see CMakeLists.txt.
// All of its code is in namespaces of its own, so that the linker does not mix up code for
// different widths.

#include <rt/todo.hpp>

#include "lanes.hpp"

namespace rt_32 {
using rt::todo;
}
namespace batches_32 {
using batches::Width;
}
#define rt rt_32
#define batches batches_32
#include "lanes_body.hpp"
#undef batches
#undef rt

batches::Width batches::registers_of_32_bytes() {
    return batches_32::make_width();
}
