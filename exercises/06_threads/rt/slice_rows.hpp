#pragma once
#include <cstdint>
#include <rt/tile.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 06.1. The rows of a picture that `worker`, 0 ... workers - 1, renders. The workers take
// the rows in order, each row once, and their numbers of rows differ by at most 1. For a worker
// without rows, begin equals end. The height is 0 or more, and there is 1 worker or more.
// Star: it works for every height and number of workers that fit into an int.
inline Rows slice_rows(int height, int workers, int worker) {
    return rt::todo("06.1", height, workers, worker);
}

}  // namespace rt
