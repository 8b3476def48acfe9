#include <answer.hpp>
#include <rt/directions.hpp>
#include <rt/rng.hpp>

namespace answer EXPORTED {

rt::Vec3 cosine_direction(rt::Vec3 normal, rt::Vec2 place) {
    return rt::cosine_direction(normal, place);
}

rt::Vec2 random_place(rt::Rng& random) {
    return rt::random_place(random);
}

}  // namespace EXPORTED
