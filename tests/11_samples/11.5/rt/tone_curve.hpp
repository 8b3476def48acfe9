#pragma once
#include <rt/color.hpp>

namespace answer {

rt::Color exposed(const rt::Color& color, rt::Real stops);
rt::Real luminance(const rt::Color& color);
rt::Real tone_curve(rt::Real luminance, rt::Real white);
rt::Color tone_mapped(const rt::Color& color, rt::Real white);

}  // namespace answer

namespace rt {

using answer::exposed;
using answer::luminance;
using answer::tone_curve;
using answer::tone_mapped;

}  // namespace rt
