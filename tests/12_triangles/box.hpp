#pragma once
#include <array>
#include <rt/mesh.hpp>

namespace checkpoint {

// A box with sides of length 1 around the origin.
inline rt::Mesh make_box() {
    using rt::Corner, rt::Real;
    rt::Mesh box;
    for (int i = 0; i < 8; ++i)
        box.points.push_back({static_cast<Real>(i % 2) - Real(0.5),
                              static_cast<Real>(i / 2 % 2) - Real(0.5),
                              static_cast<Real>(i / 4) - Real(0.5)});
    for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1},
                                     {4, 5, 7, 6},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 4, 6, 2},
                                     {1, 3, 7, 5}}) {
        box.triangles.push_back({Corner{a}, Corner{b}, Corner{c}});
        box.triangles.push_back({Corner{a}, Corner{c}, Corner{d}});
    }
    return box;
}

}  // namespace checkpoint
