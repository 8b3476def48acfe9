#pragma once
#include <functional>
#include <rt/box.hpp>
#include <span>

namespace answer {

// How build_node splits: a function like split_in_half.
using Split = std::function<int(std::span<int>, std::span<const rt::Box>)>;

}  // namespace answer
