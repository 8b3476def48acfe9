#include <answer.hpp>
#include <rt/bilinear.hpp>

namespace answer EXPORTED {

rt::Color bilinear(const rt::Image& image, rt::Vec2 place) {
    return rt::bilinear(image, place);
}

}  // namespace EXPORTED
