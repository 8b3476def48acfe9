#pragma once
#include <cstddef>
#include <rt/real.hpp>

namespace rt {

// Which sphere of a list a ray meets, and at which t.
struct NearestSphere {
    std::size_t number = 0;  // the first sphere of the list has number 0
    Real t = 0;

    friend bool operator==(const NearestSphere&, const NearestSphere&) = default;
};

}  // namespace rt
