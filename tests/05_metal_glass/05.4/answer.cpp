#include <answer.hpp>
#include <rt/fresnel.hpp>

namespace answer EXPORTED {

std::optional<rt::Real> refracted_cosine(rt::Real cosine, rt::Real eta) {
    return rt::refracted_cosine(cosine, eta);
}

rt::Real fresnel_reflectance(rt::Real cosine, rt::Real eta) {
    return rt::fresnel_reflectance(cosine, eta);
}

rt::Real schlick_reflectance(rt::Real cosine, rt::Real eta) {
    return rt::schlick_reflectance(cosine, eta);
}

}  // namespace EXPORTED
