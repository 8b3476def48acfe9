// This file is compiled with Real = float and with another name for the namespace rt: see
// 03.float.cpp.
#include "12.float.hpp"

#include "triangle_ways.hpp"

static_assert(sizeof(rt::Real) == sizeof(float));

namespace live {
namespace {

rt::Vec3 in_float(Triple p) {
    return {static_cast<rt::Real>(p.x), static_cast<rt::Real>(p.y), static_cast<rt::Real>(p.z)};
}

}  // namespace

EdgeHits hits_in_float(const std::array<std::array<Triple, 3>, 2>& pair, Triple origin,
                       Triple direction) {
    const rt::Ray ray{in_float(origin), in_float(direction)};
    EdgeHits hits;
    for (unsigned i = 0; i < 2; ++i) {
        const auto& [a, b, c] = pair[i];
        const rt::Triangle triangle{in_float(a), in_float(b), in_float(c)};
        if (triangles::Plain{triangle}.hit(ray, {})) hits.plain |= 1u << i;
        if (rt::hit_triangle(triangle, ray, {})) hits.exercise |= 1u << i;
    }
    return hits;
}

}  // namespace live
