#include <rt/lambertian.hpp>
#include <rt/sky.hpp>
#include <rt/sky_scene.hpp>
#include <rt/sphere_list.hpp>
#include <statistics.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color;
using rt::RoughMetal;
using rt::Ways;

namespace {

using Others = rt::MaterialSet<rt::Lambertian, rt::Mirror>;

// A ball of rough metal around the origin, of radius 1.
struct Ball {
    rt::SphereList world;
    rt::RoughMaterials<Others> materials;
    rt::SceneSky sky;
    rt::NoFog fog;

    Ball(const rt::Image& picture, Color color, Real roughness)
        : sky{{}, rt::PictureSky{picture, 0, 1}} {
        world.spheres.push_back({{{0, 0, 0}, 1}, 0});
        materials.others.materials = {rt::Lambertian{}};
        materials.metals = {rt::make_rough_metal(color, roughness)};
        materials.metal_of = {0};
    }

    // The light of a ray that meets the ball at this distance from its middle.
    Mean mean(Ways ways, Real aside, int depth, int count) const {
        const rt::LightsByWays<rt::SkyLights> lights{{{}, sky}, ways};
        rt::Rng random{14, static_cast<std::uint64_t>(ways)};
        Mean mean;
        const rt::Ray ray{{aside, 5, 0}, {0, -1, 0}};
        for (int i = 0; i < count; ++i)
            mean.add(static_cast<double>(rt::lit_path_radiance(ray, world, materials, sky, lights,
                                                               fog, rt::SkyEnding{}, depth, random)
                                             .g));
        return mean;
    }
};

// Bright ahead, dark behind, with a lamp of some pixels above.
rt::Image some_sky() {
    return rt::make_image(32, 16, [](int x, int y) {
        const Real light = y < 2 ? Real(40) : Real(x) / 16;
        return Color{light, light, light};
    });
}

}  // namespace

TEST_CASE("a ball of white rough metal vanishes in a white furnace") {
    const rt::Image white{4, 2, {1, 1, 1}};
    for (const Real roughness : {real(0.1), real(0.4), Real(1)}) {
        const Ball ball{white, {1, 1, 1}, roughness};
        for (const Ways ways : {Ways::power, Ways::samples, Ways::bounces})
            for (const Real aside : {Real(0), real(0.7), real(0.97)}) {
                // Samples of a sharp lobe are few and bright.
                if (ways == Ways::samples && roughness < real(0.3)) continue;
                const Mean mean = ball.mean(ways, aside, 3, 40'000);
                INFO("roughness " << roughness << ", way " << static_cast<int>(ways) << ", aside "
                                  << aside << ": " << mean.mean() << ", standard error "
                                  << mean.standard_error());
                CHECK(std::abs(mean.mean() - 1) <= 4 * mean.standard_error() + 0.005);
            }
    }
}

TEST_CASE("all ways to find a sky agree on rough gold") {
    const rt::Image picture = some_sky();
    for (const Real roughness : {real(0.3), real(0.7)}) {
        const Ball ball{picture, {1, real(0.7), real(0.3)}, roughness};
        for (const Real aside : {real(0.2), real(0.8)})
            for (const int depth : {1, 4}) {
                const Mean bounces = ball.mean(Ways::bounces, aside, 4, 100'000);
                for (const Ways ways : {Ways::samples, Ways::balance, Ways::power}) {
                    const Mean mean = ball.mean(ways, aside, depth, 60'000);
                    const double error =
                        std::hypot(mean.standard_error(), bounces.standard_error());
                    INFO("roughness " << roughness << ", way " << static_cast<int>(ways) << ": "
                                      << mean.mean() << " and " << bounces.mean()
                                      << ", standard error " << error);
                    CHECK(std::abs(mean.mean() - bounces.mean()) <= 4.5 * error);
                }
            }
    }
}

TEST_CASE("a bounce of rough metal stays above the surface or ends") {
    rt::Rng rng{14, 3};
    for (int i = 0; i < 20'000; ++i) {
        RoughMetal metal{{1, 1, 1}, any_size(rng, -4, 0), {}};
        metal.kept.fill(1);
        rt::Hit hit;
        hit.normal = any_direction(rng);
        const rt::Vec3 incoming = any_direction(rng);
        hit.front = rt::dot(incoming, hit.normal) <= 0;
        const auto bounce = rt::scatter(metal, incoming, hit, rng);
        REQUIRE(bounce);
        const Real density = rt::scatter_density(metal, incoming, hit, bounce->direction);
        CHECK(rt::dot(bounce->direction, facing_normal(hit)) > 0);
        if (bounce->attenuation == Color{}) continue;
        CHECK(std::isfinite(bounce->attenuation.r));
        CHECK(density > 0);
        CHECK(std::isfinite(density));
    }
}
