#include <rt/rng.hpp>
#include <study/cover.hpp>

namespace study {

using rt::Color, rt::Real, rt::Vec3;

Cover make_cover() {
    Cover cover;
    rt::Rng rng{1, 7};
    // A random number with as many bits as float has: then the scene is the same in both
    // precisions.
    const auto uniform = [&] { return static_cast<Real>(rng() >> 8) / Real(1 << 24); };
    const auto add = [&](const CoverSphere& sphere) { cover.spheres.push_back(sphere); };
    using enum CoverMaterial;
    add({{0, -1000, 0}, 1000, matte, {Real(0.5), Real(0.5), Real(0.5)}});
    add({{0, 1, 0}, 1, glass});
    add({{-4, 1, 0}, 1, matte, {Real(0.4), Real(0.2), Real(0.1)}});
    add({{4, 1, 0}, 1, metal, {Real(0.7), Real(0.6), Real(0.5)}});
    for (int i = 0; cover.spheres.size() < 486; ++i) {
        const auto row = static_cast<Real>(i / 22 % 22 - 11),
                   column = static_cast<Real>(i % 22 - 11);
        const Real x = uniform(), z = uniform();
        const Vec3 center{row + Real(0.9) * x, Real(0.2), column + Real(0.9) * z};
        // Written component by component, because common/ has no operators for Vec3: the learner
        // writes them (01.1).
        const Real to_metal = center.x - 4;
        if (to_metal * to_metal + center.z * center.z <= Real(0.81)) continue;
        // Four in five are matte, and most of the others are metal.
        const Real kind = uniform(), r = uniform(), g = uniform(), b = uniform();
        if (kind < Real(0.8))
            add({center, Real(0.2), matte, {r * r, g * g, b * b}});
        else if (kind < Real(0.95))
            add({center, Real(0.2), metal, {(1 + r) / 2, (1 + g) / 2, (1 + b) / 2}, uniform() / 2});
        else
            add({center, Real(0.2), glass});
    }
    return cover;
}

}  // namespace study
