#pragma once
#include <cstdint>
#include <rt/tile.hpp>

namespace answer {

rt::Rows slice_rows(int height, int workers, int worker);

}  // namespace answer

namespace rt {

using answer::slice_rows;

}  // namespace rt
