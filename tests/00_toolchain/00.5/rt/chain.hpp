#pragma once
#include <rt/link.hpp>
#include <vector>

namespace answer {

rt::Real sum_along(const rt::Link* first);
std::vector<rt::Link> gathered(const rt::Link* first);

}  // namespace answer

namespace rt {

using answer::gathered;
using answer::sum_along;

}  // namespace rt
