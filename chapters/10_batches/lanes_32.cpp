// Compiled for narrower registers than the rest: see CMakeLists.txt. All of this file is in
// namespaces of its own, so that no linker mixes up code for different widths.

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
