#pragma once
// A type that both sides know.

#include <rt/search.hpp>

namespace answer {

// A search of another type: it meets spheres that have been moved.
struct MovedSearch : rt::Search {
    std::span<const rt::Vec3> motions;

    std::optional<rt::Real> meets_shape(int number) {
        ++shape_tests;
        const auto i = static_cast<std::size_t>(number);
        return rt::hit_sphere(rt::moved(shapes[i].shape, motions[i]), ray, within);
    }
};

}  // namespace answer
