#include <answer.hpp>
#include <rt/quadratic.hpp>

namespace answer EXPORTED {

std::optional<rt::Roots> roots_from_discriminant(rt::Real a, rt::Real b, rt::Real c,
                                                 rt::Real discriminant) {
    return rt::roots_from_discriminant(a, b, c, discriminant);
}

std::optional<rt::Roots> solve_quadratic(rt::Real a, rt::Real b, rt::Real c) {
    return rt::solve_quadratic(a, b, c);
}

}  // namespace EXPORTED
