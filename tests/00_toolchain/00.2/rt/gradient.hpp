#pragma once
#include <rt/corners.hpp>

namespace answer {

rt::Color gradient(const rt::Corners& corners, rt::Real across, rt::Real down);

}  // namespace answer

namespace rt {

using answer::gradient;

}  // namespace rt
