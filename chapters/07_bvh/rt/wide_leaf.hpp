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

// A leaf with up to eight shapes (given). This plain version is for any type of shape; the version
// for spheres follows.
template <class Shape>
struct WideLeaf {
    using ReadyRay = Ray;  // a Ray with what the leaves' tests need of it, computed once
    // How many bytes of a node or a leaf a search asks for before it needs them. If any, it also
    // tests the shapes in the leaves, rather than by their numbers. It pays in large trees.
    static constexpr std::size_t read_ahead = 0;
    Lanes<Shape> shapes{};
    Lanes<std::int32_t> number{};  // of each shape in the scene
    std::size_t count = 0;

    // Shapes are added in order, from place 0 on.
    void set(std::size_t place, const Shape& shape, std::int32_t its_number) {
        shapes[place] = shape;
        number[place] = its_number;
        count = place + 1;
    }
    const Shape& shape(std::size_t place) const { return shapes[place]; }
};

// The same for spheres, which are tested all at once.
template <>
struct alignas(64) WideLeaf<SceneSphere> {
    using ReadyRay = Ray;
    static constexpr std::size_t read_ahead = 0;
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
    SceneSphere shape(std::size_t i) const { return {sphere(i), material[i], light[i]}; }
};
using SphereLeaf = WideLeaf<SceneSphere>;

// The shapes of a leaf that the ray may meet within the interval, as bits: here all of them.
template <class Shape>
unsigned may_meet(const WideLeaf<Shape>& leaf, const Ray&, Interval) {
    return (1u << leaf.count) - 1;
}

// A part of a leaf's spheres, as seen from a ray (given). It computes what hit_sphere computes
// first, with the same operations in the same order, so it has the same bits. The names are the
// same, too.
struct LeafPart {
    Vec3 d;  // the ray's direction
    Reals fx, fy, fz, r_squared;

    RT_INLINED LeafPart(const SphereLeaf& leaf, std::size_t first, const Ray& ray)
        : d{ray.direction},
          fx{ray.origin.x - load<Reals>(&leaf.x[first])},
          fy{ray.origin.y - load<Reals>(&leaf.y[first])},
          fz{ray.origin.z - load<Reals>(&leaf.z[first])},
          r_squared{load<Reals>(&leaf.radius[first]) * load<Reals>(&leaf.radius[first])} {}

    // The spheres that the ray's line meets, as bits: a quarter of the discriminant is 0 or more.
    RT_INLINED unsigned line_meets() const {
        const Real a = d.x * d.x + d.y * d.y + d.z * d.z;
        const Reals mx = fy * d.z - fz * d.y, my = fz * d.x - fx * d.z, mz = fx * d.y - fy * d.x;
        return RT_VECTOR_BITS(a * r_squared - (mx * mx + my * my + mz * mz) >= 0);
    }
    // The spheres that lie behind the ray, as bits: it starts outside and runs away from the
    // center, so both solutions are negative.
    RT_INLINED unsigned behind() const {
        const Reals half_b = fx * d.x + fy * d.y + fz * d.z;
        const Reals c = fx * fx + fy * fy + fz * fz - r_squared;
        return RT_VECTOR_BITS((half_b > 0) & (c > 0));
    }
};

// The spheres of a leaf that hit_sphere (03.2) must test. These are few: most lines pass beside all
// spheres of a leaf, and half of the spheres that a line meets lie behind the ray.
RT_INLINED unsigned may_meet(const SphereLeaf& leaf, const Ray& ray, Interval within) {
    unsigned met = 0, behind = 0;
    for (std::size_t first = 0; first < lanes; first += part_size<Real>)
        met |= LeafPart{leaf, first, ray}.line_meets() << first;
    if (met == 0 || within.min < 0) return met;
    // The differences are computed once more: keeping them for all eight spheres would take more
    // registers than the processor has.
    for (std::size_t first = 0; first < lanes; first += part_size<Real>)
        behind |= LeafPart{leaf, first, ray}.behind() << first;
    return met & ~behind;
}

// The numbers of some of a leaf's shapes, those whose bits are set (given).
class SomeOfLeaf {
  public:
    RT_INLINED SomeOfLeaf(const Lanes<std::int32_t>& numbers, unsigned bits)
        : numbers_{numbers.data()}, bits_{bits} {}
    struct End {};
    struct Iterator {
        const std::int32_t* numbers;
        unsigned bits;

        int operator*() const { return numbers[std::countr_zero(bits)]; }
        Iterator& operator++() {
            bits &= bits - 1;
            return *this;
        }
        bool operator!=(End) const { return bits != 0; }
    };
    Iterator begin() const { return {numbers_, bits_}; }
    End end() const { return {}; }

  private:
    const std::int32_t* numbers_;
    unsigned bits_;
};

}  // namespace rt
