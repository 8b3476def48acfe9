#pragma once
#include <rt/dielectric.hpp>
#include <rt/lambertian.hpp>
#include <rt/lit_path.hpp>
#include <rt/metal.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>
#include <rt/textures.hpp>
#include <statistics.hpp>

#include "checkpoint.hpp"

// Scenes with lights, and the mean light of their paths.
namespace checkpoint {

using rt::Color;
using rt::Ray;

using Materials = rt::MaterialSet<rt::Lambertian, rt::Mirror, rt::Metal, rt::Dielectric,
                                  rt::CheckeredMatte, rt::ImageMatte>;

// Checks a mean. Right code misses it in one of 10000 runs: 3.89 standard errors.
inline constexpr double limit = 3.89;

inline double gray(Color color) {
    return static_cast<double>(color.r + color.g + color.b) / 3;
}

struct Lit {
    rt::SphereList world;
    Materials materials;
    rt::SceneLights lights;
    rt::FogBall fog;
    rt::UniformSky sky{{0, 0, 0}};

    void add(const rt::Sphere& sphere, decltype(Materials::materials)::value_type material) {
        world.spheres.push_back({sphere, static_cast<int>(materials.materials.size())});
        materials.materials.push_back(material);
    }
    void add_light(const rt::Sphere& sphere, Color radiance) {
        const auto number = static_cast<int>(lights.all().size());
        add(sphere, rt::Lambertian{});
        world.spheres.back().light = number;
        lights.add({sphere, radiance, number});
    }
    template <class Lights, class Ending>
    Mean mean(const Ray& ray, const Lights& found, const Ending& ending, int depth, int count,
              std::uint64_t seed) const {
        Mean mean;
        rt::Rng random{seed, 8};
        for (int i = 0; i < count; ++i)
            mean.add(gray(rt::lit_path_radiance(ray, world, materials, sky, found, fog, ending,
                                                depth, random)));
        return mean;
    }
};

inline void check_mean(const Mean& mean, double expected) {
    INFO("mean " << mean.mean() << ", " EXPECTED << expected << ", standard error "
                 << mean.standard_error());
    // If every sample is the same, only rounding is left.
    CHECK(std::abs(mean.mean() - expected) <=
          limit * mean.standard_error() + 64 * static_cast<double>(rt::epsilon) * expected);
}

inline void check_same(const Mean& a, const Mean& b) {
    const double error = std::hypot(a.standard_error(), b.standard_error());
    INFO("means " << a.mean() << " and " << b.mean() << ", standard error of the difference "
                  << error);
    CHECK(std::abs(a.mean() - b.mean()) <= limit * error);
}

inline const rt::Lambertian white{{1, 1, 1}}, gray_matte{{Real(0.5), Real(0.5), Real(0.5)}};

}  // namespace checkpoint
