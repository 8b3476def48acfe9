#pragma once
#include <rt/arrival.hpp>

namespace answer {

rt::Vec3Pack cosine_direction(const rt::Vec3Pack& normal, const rt::PlacePack& place,
                              rt::PackBits active);

}  // namespace answer

namespace rt {

using answer::cosine_direction;

}  // namespace rt
