// The test cases compare with the pixel_to_viewport that the answer calls.
#include "02.1/answer.cpp"

#include <answer.hpp>
#include <rt/primary_ray.hpp>

namespace answer EXPORTED {

rt::Ray primary_ray(const rt::Camera& camera, const int column, const int row,
                    const rt::Vec2& offset) {
    return rt::primary_ray(camera, column, row, offset);
}

}  // namespace EXPORTED
