#include <answer.hpp>
#include <rt/matte_pack.hpp>

namespace answer EXPORTED {

rt::Vec3Pack cosine_direction(const rt::Vec3Pack& normal, const rt::PlacePack& place,
                              rt::PackBits active) {
    return rt::cosine_direction(normal, place, active);
}

}  // namespace EXPORTED
