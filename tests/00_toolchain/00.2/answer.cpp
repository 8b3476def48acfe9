#include <answer.hpp>
#include <rt/gradient.hpp>

namespace answer EXPORTED {

rt::Color gradient(const rt::Corners& corners, rt::Real across, rt::Real down) {
    return rt::gradient(corners, across, down);
}

}  // namespace EXPORTED
