#pragma once
// For a file that is compiled for narrower registers than the rest of the program: see
// CMakeLists.txt. All of its code is in namespaces of its own, OWN_RT and OWN_BATCHES, so that the
// linker does not mix up code for different widths.

#include <rt/todo.hpp>

#include "lanes.hpp"

namespace OWN_RT {
using rt::todo;
}
namespace OWN_BATCHES {
using batches::Width;
}
#define rt OWN_RT
#define batches OWN_BATCHES
#include "lanes_body.hpp"
#undef batches
#undef rt
