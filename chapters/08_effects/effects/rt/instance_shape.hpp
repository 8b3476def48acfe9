#pragma once
#include <optional>
#include <rt/instance.hpp>
#include <rt/shape_tree.hpp>

namespace rt {

// A tree also needs this function for instances, in addition to bounds_of and surface_hit of 08.5
// and to margin_factor (given).
inline std::optional<Real> hit_shape(const Instance& instance, const Ray& ray, Interval within) {
    return hit_instance(instance, ray, within);
}

}  // namespace rt
