#include <answer.hpp>
#include <rt/pixel.hpp>

namespace answer EXPORTED {

rt::Vec2 pixel_to_viewport(const rt::Camera& camera, const int column, const int row,
                           const rt::Vec2& offset) {
    return rt::pixel_to_viewport(camera, column, row, offset);
}

}  // namespace EXPORTED
