#pragma once
#include <cstdint>
#include <rt/tile.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 06.1. The rows of a picture of this height, 0 or more, that worker 0 ... workers - 1
// renders: in the order of the workers, each row once, and no worker has more than one row more
// than another. A worker without rows has begin equal to end. Any height and any number of
// workers, 1 or more, will do that fits an int.
inline Rows slice_rows(int height, int workers, int worker) {
    return rt::todo("06.1", height, workers, worker);
}

}  // namespace rt
