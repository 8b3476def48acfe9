#include <answer.hpp>
#include <functional>
#include <rt/through_haze.hpp>

namespace answer EXPORTED {

using Distance = std::function<rt::Real()>;

rt::Color through_haze(const rt::Haze& haze, rt::Color color, const Distance& distance) {
    return rt::through_haze(haze, color, distance);
}

rt::Color through_haze(const rt::NoHaze& haze, rt::Color color, const Distance& distance) {
    return rt::through_haze(haze, color, distance);
}

}  // namespace EXPORTED
