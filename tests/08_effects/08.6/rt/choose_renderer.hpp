#pragma once
#include <cstddef>
#include <rt/effects.hpp>
#include <span>
#include <stdexcept>

namespace answer {

std::size_t narrowest(const rt::Effects& needed, std::span<const rt::Effects> renderers);

}  // namespace answer

namespace rt {

using answer::narrowest;

}  // namespace rt
