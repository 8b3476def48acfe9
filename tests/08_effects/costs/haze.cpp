// Two calls of through_haze, whose instructions you count in 08.6.

#include <rt/through_haze.hpp>

void with_haze(rt::Color& color, const rt::Haze& haze, rt::Real distance) {
    color = rt::through_haze(haze, color, [&] { return distance; });
}

void without_haze(rt::Color& color, const rt::NoHaze& haze, rt::Real distance) {
    color = rt::through_haze(haze, color, [&] { return distance; });
}
