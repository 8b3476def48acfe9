#include <rt/lambertian.hpp>
#include <rt/sky.hpp>
#include <rt/sky_scene.hpp>
#include <rt/sphere_list.hpp>
#include <statistics.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;
using rt::Color;
using rt::Image;
using rt::Ways;

namespace {

using Materials = rt::MaterialSet<rt::Lambertian, rt::Mirror>;

// The light of a path, and its mean over many. A ball of radius 1 stands at the origin, and a ray
// meets its top from above.
struct Ball {
    rt::SphereList world;
    Materials materials;
    rt::SceneSky sky;
    rt::NoFog fog;

    explicit Ball(const Image& picture, Real turn = 0, Real scale = 1)
        : sky{{}, rt::PictureSky{picture, turn, scale}} {
        world.spheres.push_back({{{0, 0, 0}, 1}, 0});
        materials.materials = {rt::Lambertian{{Real(0.5), Real(0.5), Real(0.5)}}};
    }

    Mean mean(Ways ways, int depth, int count, rt::MeshLights lamps = {}) const {
        const rt::LightsByWays<rt::SkyLights> lights{{std::move(lamps), sky}, ways};
        rt::Rng random{14, static_cast<std::uint64_t>(ways)};
        Mean mean;
        const rt::Ray ray{{Real(0.3), 5, Real(0.2)}, {0, -1, 0}};
        for (int i = 0; i < count; ++i)
            mean.add(static_cast<double>(rt::lit_path_radiance(ray, world, materials, sky, lights,
                                                               fog, rt::SkyEnding{}, depth, random)
                                             .g));
        return mean;
    }
};

void check_mean(const Mean& mean, double expected) {
    INFO("mean " << mean.mean() << ", " EXPECTED << expected << ", standard error "
                 << mean.standard_error());
    CHECK(std::abs(mean.mean() - expected) <=
          4 * mean.standard_error() + 64 * static_cast<double>(rt::epsilon) * expected);
}

// Bright in one corner of the sky, black in another, and with a sun.
Image some_sky() {
    Image picture = rt::make_image(16, 8, [](int x, int y) {
        return y < 2 ? Color{} : Color{1, Real(x), Real(0.5)};
    });
    picture.at(3, 1) = {500, 500, 500};
    return picture;
}

}  // namespace

TEST_CASE("a white sky lights a matte ball as its albedo says, in every way to find it") {
    const Image white{5, 4, {2, 2, 2}};
    const Ball ball{white};
    for (const Ways ways : {Ways::samples, Ways::bounces, Ways::balance, Ways::power})
        for (const int depth : {1, 8}) check_mean(ball.mean(ways, depth, 20'000), 1);
    // Half of the light, since the sky is multiplied.
    check_mean(Ball{white, Real(0.3), Real(0.5)}.mean(Ways::power, 3, 1000), 0.5);
    check_mean(Ball{Image{3, 3}}.mean(Ways::power, 3, 100), 0);
}

TEST_CASE("all ways to find a sky with a sun agree") {
    const Image picture = some_sky();
    for (const Real turn : {Real(0), Real(0.37)}) {
        const Ball ball{picture, turn};
        const Mean bounces = ball.mean(Ways::bounces, 4, 400'000);
        for (const Ways ways : {Ways::samples, Ways::balance, Ways::power})
            for (const int depth : {1, 4}) {
                const Mean mean = ball.mean(ways, depth, 40'000);
                const double error = std::hypot(mean.standard_error(), bounces.standard_error());
                INFO(mean.mean() << " and " << bounces.mean() << ", standard error " << error);
                CHECK(std::abs(mean.mean() - bounces.mean()) <= 4 * error);
                CHECK(mean.standard_error() * std::sqrt(40'000) <
                      bounces.standard_error() * std::sqrt(400'000) / 2);
            }
    }
}

TEST_CASE("a mirror shows the sky turned counterclockwise") {
    Image picture{4, 2};
    for (int x = 0; x < 4; ++x) picture.at(x, 0) = picture.at(x, 1) = {Real(x), 0, 0};
    // Ahead and a little to the right is column 2; after a quarter turn, what was there is on the
    // left.
    const rt::PictureSky as_it_is{picture, 0, 1}, turned{picture, Real(0.25), 1};
    const rt::Vec3 ahead = rt::normalize(rt::Vec3{Real(0.1), 0, -1});
    const rt::Vec3 left = rt::normalize(rt::Vec3{-1, 0, Real(-0.1)});
    CHECK(as_it_is(ahead).r == 2);
    CHECK(turned(left).r == 2);
    CHECK(as_it_is(left).r == 1);
    CHECK(turned(ahead).r == 3);
}

TEST_CASE("the lamps and the sky share the samples") {
    const Image picture = some_sky();
    rt::MeshLights lamps{{}, {{{{-1, 3, -1}, {1, 3, -1}, {0, 3, 1}}, {5, 5, 5}, 0}}};
    const rt::SceneSky sky{{}, rt::PictureSky{picture, 0, 1}};
    const rt::SkyLights lights{lamps, sky};
    rt::Rng random{14, 9};
    int of_sky = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto chosen = lights.choose({0, 0, 0}, random);
        REQUIRE(chosen);
        const bool is_sky = chosen->sample.distance == rt::infinity;
        of_sky += is_sky ? 1 : 0;
        const auto direction = chosen->sample.direction;
        const Real density =
            is_sky ? lights.sky_density(direction)
                   : lights.density(*chosen->light, {0, 0, 0}, chosen->sample.distance * direction);
        CHECK(std::abs(chosen->sample.density - density) <=
              for_this_precision(real(1e-3), real(1e-10)) * density);
    }
    CHECK(400 < of_sky);
    CHECK(of_sky < 600);
}
