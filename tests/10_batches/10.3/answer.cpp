#include <answer.hpp>
#include <rt/hit_pack.hpp>

namespace answer EXPORTED {

rt::PackMask hit_pack(const rt::Sphere& sphere, rt::PackInteger number, rt::RayPack& rays) {
    return rt::hit_pack(sphere, number, rays);
}

}  // namespace EXPORTED
