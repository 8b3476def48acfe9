#include <answer.hpp>
#include <rt/tone_curve.hpp>

namespace answer EXPORTED {

rt::Color exposed(const rt::Color& color, rt::Real stops) {
    return rt::exposed(color, stops);
}

rt::Real luminance(const rt::Color& color) {
    return rt::luminance(color);
}

rt::Real tone_curve(rt::Real luminance, rt::Real white) {
    return rt::tone_curve(luminance, white);
}

rt::Color tone_mapped(const rt::Color& color, rt::Real white) {
    return rt::tone_mapped(color, white);
}

}  // namespace EXPORTED
