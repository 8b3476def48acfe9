#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <rt/interval.hpp>
#include <rt/ray.hpp>
#include <rt/sphere_shape.hpp>
#include <rt/vector_registers.hpp>
#include <rt/wide.hpp>

namespace rt {

// A leaf with up to eight shapes, and everything that a hit needs (given). This plain version is
// for any type of shape; the version for spheres follows.
template <class Shape>
struct WideLeaf {
    Lanes<Shape> shapes{};
    Lanes<std::int32_t> number{};  // of each shape in the scene
    std::size_t count = 0;

    // Shapes are added in order, from place 0 on.
    void set(std::size_t place, const Shape& shape, std::int32_t its_number) {
        shapes[place] = shape;
        number[place] = its_number;
        count = place + 1;
    }

    // The Hit of a ray that meets shape number `place` of the leaf at t.
    Hit hit(std::int32_t place, const Ray& ray, Real t) const {
        return surface_hit(shapes[static_cast<std::size_t>(place)], ray, t);
    }
};

// The same for spheres, which are tested all at once.
template <>
struct alignas(64) WideLeaf<SceneSphere> {
    static constexpr Real nothing = std::numeric_limits<Real>::quiet_NaN();

    // Unused lanes have NaN as their radius: no ray hits them.
    Lanes<Real> x{}, y{}, z{}, radius;
    Lanes<std::int32_t> number{};
    Lanes<std::int32_t> material{}, light{};

    WideLeaf() { radius.fill(nothing); }

    void set(std::size_t place, const SceneSphere& sphere, std::int32_t its_number) {
        x[place] = sphere.shape.center.x;
        y[place] = sphere.shape.center.y;
        z[place] = sphere.shape.center.z;
        radius[place] = sphere.shape.radius;
        number[place] = its_number;
        material[place] = sphere.material;
        light[place] = sphere.light;
    }
    bool is_used(std::size_t i) const { return !std::isnan(radius[i]); }
    Sphere sphere(std::size_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }

    RT_INLINED Hit hit(std::int32_t place, const Ray& ray, Real t) const {
        const auto i = static_cast<std::size_t>(place);
        return surface_hit(SceneSphere{sphere(i), material[i], light[i]}, ray, t);
    }
};
using SphereLeaf = WideLeaf<SceneSphere>;

// The nearest hit so far.
struct WideHit {
    Real t = infinity;
    std::int32_t number = -1;  // of the shape that is hit there; -1 before any hit
    std::int32_t place = 0;    // the shape's place in its leaf
};

// A part of a leaf's spheres, as seen from a ray (given). It computes what hit_sphere and
// roots_from_discriminant compute, with the same operations in the same order, so each t has the
// same bits. The names are the same, too.
struct LeafPart {
    Vec3 d;  // the ray's direction
    Real a;  // its squared length
    Reals fx, fy, fz, r_squared;

    RT_INLINED LeafPart(const SphereLeaf& leaf, std::size_t first, const Ray& ray)
        : d{ray.direction},
          a{d.x * d.x + d.y * d.y + d.z * d.z},
          fx{ray.origin.x - load<Reals>(&leaf.x[first])},
          fy{ray.origin.y - load<Reals>(&leaf.y[first])},
          fz{ray.origin.z - load<Reals>(&leaf.z[first])},
          r_squared{load<Reals>(&leaf.radius[first]) * load<Reals>(&leaf.radius[first])} {}

    // A quarter of each discriminant: 0 or more if the ray's line meets the sphere.
    RT_INLINED Reals quarter() const {
        const Reals mx = fy * d.z - fz * d.y, my = fz * d.x - fx * d.z, mz = fx * d.y - fy * d.x;
        return a * r_squared - (mx * mx + my * my + mz * mz);
    }

    // The spheres that the ray meets within the interval, as bits, and the t of each. Only spheres
    // whose bit is set in `met` are tested; `a` must be greater than 0.
    RT_INLINED unsigned hits(Reals quarter, unsigned met, Interval within, Reals& t) const {
        const Reals half_b = fx * d.x + fy * d.y + fz * d.z;
        const Reals b = 2 * half_b, c = fx * fx + fy * fy + fz * fz - r_squared;
        // If a ray starts outside a sphere and runs away from its center, the whole sphere is
        // behind the ray: both solutions are negative. This holds for half of the spheres that the
        // line of a ray meets.
        if (within.min >= 0) met &= ~RT_VECTOR_BITS((half_b > 0) & (c > 0));
        if (met == 0) return 0;

        const Reals q = -(b + copysign(sqrt(4 * quarter), b)) / 2;
        const auto at_origin = q == 0;  // both solutions are 0
        const Reals one = at_origin ? Reals{} : c / q, other = at_origin ? Reals{} : q / a;
        const Reals low = one < other ? one : other, high = one < other ? other : one;
        const auto low_counts = (low >= within.min) & (low <= within.max);
        const auto high_counts = (high >= within.min) & (high <= within.max);
        t = low_counts ? low : high;
        return met & RT_VECTOR_BITS(low_counts | high_counts);
    }
};

// Tries the spheres of a leaf between min and best.t, and returns whether best has changed. Of
// equally near spheres, the one with the highest number counts.
RT_INLINED bool hit_leaf(const SphereLeaf& leaf, const Ray& ray, Real min, WideHit& best) {
    constexpr std::size_t size = part_size<Real>;
    std::array<Reals, lanes / size> quarters;
    std::array<unsigned, lanes / size> met;
    unsigned any = 0;
    for (std::size_t p = 0; p < quarters.size(); ++p) {
        quarters[p] = LeafPart{leaf, p * size, ray}.quarter();
        met[p] = RT_VECTOR_BITS(quarters[p] >= 0);
        any |= met[p];
    }
    // If the line misses all spheres, the leaf is done. The roots need `fx`, `fy` and `fz` again.
    // They are computed once more: keeping them for all eight spheres would take more registers
    // than the processor has.
    const Vec3 d = ray.direction;
    if (any == 0 || !(d.x * d.x + d.y * d.y + d.z * d.z > 0)) return false;

    Lanes<Real> t;
    unsigned hits = 0;
    for (std::size_t p = 0; p < quarters.size(); ++p) {
        Reals some{};
        hits |= LeafPart{leaf, p * size, ray}.hits(quarters[p], met[p], {min, best.t}, some)
                << p * size;
        store(some, &t[p * size]);
    }
    bool changed = false;
    for (; hits; hits &= hits - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(hits));
        if (t[i] > best.t || (t[i] == best.t && leaf.number[i] < best.number)) continue;
        best = {t[i], leaf.number[i], static_cast<std::int32_t>(i)};
        changed = true;
    }
    return changed;
}

// The same for other shapes, one by one.
template <class Shape>
bool hit_leaf(const WideLeaf<Shape>& leaf, const Ray& ray, Real min, WideHit& best) {
    bool changed = false;
    for (std::size_t i = 0; i < leaf.count; ++i) {
        const auto t = hit_shape(leaf.shapes[i], ray, {min, best.t});
        if (!t || (*t == best.t && leaf.number[i] < best.number)) continue;
        best = {*t, leaf.number[i], static_cast<std::int32_t>(i)};
        changed = true;
    }
    return changed;
}

// True if a shape of the leaf is hit before `end`, according to the rules of hit_leaf. The shape
// that is hit at `end` itself does not count.
template <class Shape>
RT_INLINED bool any_in_leaf(const WideLeaf<Shape>& leaf, const Ray& ray, Real min,
                            const WideHit& end) {
    WideHit best = end;
    return hit_leaf(leaf, ray, min, best) && best.number != end.number;
}

}  // namespace rt
