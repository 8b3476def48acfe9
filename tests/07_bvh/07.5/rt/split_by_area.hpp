#pragma once
#include <rt/box.hpp>
#include <span>

namespace answer {

rt::Real surface_area(const rt::Box& box);
int split_by_area(std::span<int> order, std::span<const rt::Box> boxes);

}  // namespace answer

namespace rt {

using answer::split_by_area;
using answer::surface_area;

}  // namespace rt
