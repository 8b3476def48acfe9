#pragma once
#include <functional>
#include <rt/lens_and_haze.hpp>

namespace answer {

using Distance = std::function<rt::Real()>;

rt::Color through_haze(const rt::Haze& haze, rt::Color color, const Distance& distance);
rt::Color through_haze(const rt::NoHaze& haze, rt::Color color, const Distance& distance);

}  // namespace answer

namespace rt {

using answer::through_haze;

}  // namespace rt
