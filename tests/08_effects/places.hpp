#pragma once
// Sample points of the unit square for the checkpoints of chapter 08: for a lens, or
// for a light's cap.

#include <rt/real.hpp>
#include <rt/vec2.hpp>

namespace checkpoint {

// Calls check(place) for the middles of n times n equal squares.
template <class Check>
void for_each_place(int n, Check check) {
    using rt::Real;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            check(rt::Vec2{(static_cast<Real>(i) + Real(0.5)) / static_cast<Real>(n),
                           (static_cast<Real>(j) + Real(0.5)) / static_cast<Real>(n)});
}

}  // namespace checkpoint
