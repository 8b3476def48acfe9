#pragma once
#include <rt/path_record.hpp>
#include <rt/sphere.hpp>

namespace answer {

rt::PackMask hit_pack(const rt::Sphere& sphere, rt::PackInteger number, rt::RayPack& rays);

}  // namespace answer

namespace rt {

using answer::hit_pack;

}  // namespace rt
