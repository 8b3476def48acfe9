#pragma once
// The classic way, to compare with MaterialSet: a material is an object of a class derived from
// Material, reached by a pointer, and its scatter() is looked up in a table at run time.

#include <memory>
#include <optional>
#include <rt/hit.hpp>
#include <rt/lambertian.hpp>
#include <rt/rng.hpp>
#include <rt/scatter.hpp>
#include <utility>
#include <vector>

namespace classic {

using rt::Vec3, rt::Hit, rt::Rng, rt::Scatter;

class Material {
  public:
    virtual ~Material() = default;
    // A virtual function cannot be a template, so this one takes only one type of random generator.
    virtual std::optional<Scatter> scatter(Vec3 incoming, const Hit& hit, Rng& random) const = 0;
};

// Turns each of our material types into a class derived from Material. Once a material is chosen,
// both ways of choosing run the same code.
template <class Value>
class Derived : public Material {
  public:
    explicit Derived(const Value& value) : value_{value} {}
    std::optional<Scatter> scatter(Vec3 incoming, const Hit& hit, Rng& random) const override {
        using rt::scatter;
        return scatter(value_, incoming, hit, random);
    }

  private:
    Value value_;
};

struct Materials {
    std::vector<std::unique_ptr<Material>> materials;

    std::optional<Scatter> operator()(Vec3 incoming, const Hit& hit, Rng& random) const {
        return materials[static_cast<std::size_t>(hit.material)]->scatter(incoming, hit, random);
    }
};

// The materials of a MaterialSet, as objects of such classes.
template <class Set>
Materials from_values(const Set& set) {
    Materials all;
    for (const auto& material : set.materials)
        std::visit(
            [&](const auto& value) {
                all.materials.push_back(
                    std::make_unique<Derived<std::decay_t<decltype(value)>>>(value));
            },
            material);
    return all;
}

}  // namespace classic
