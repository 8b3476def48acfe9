#include <answer.hpp>
#include <rt/viewport.hpp>

namespace answer EXPORTED {

rt::Viewport viewport_size(const rt::Real vertical_fov, const rt::Real aspect_ratio) {
    return rt::viewport_size(vertical_fov, aspect_ratio);
}

}  // namespace EXPORTED
