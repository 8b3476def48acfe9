// Compiled for narrower registers than the rest: see cmake/Chapter.cmake. So that no linker takes
// one's code for the other's, all of this file lives in namespaces of its own.

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
