#include <answer.hpp>
#include <rt/lens_ray.hpp>

namespace answer EXPORTED {

rt::Ray lens_ray(const rt::Camera& camera, const rt::Lens& lens, int column, int row,
                 rt::Vec2 offset, rt::Vec2 place) {
    return rt::lens_ray(camera, lens, column, row, offset, place);
}

}  // namespace EXPORTED
