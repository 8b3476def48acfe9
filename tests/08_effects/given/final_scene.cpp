// The final scene is what the course promises.
#include <final_scene.hpp>

#include <array>

#include "checkpoint.hpp"

TEST_CASE("the final scene has more than ten thousand spheres and all its effects",
          "[final_scene]") {
    const rt::SceneDescription scene = effects::final_scene();
    CHECK(scene.spheres.size() > 10'000);
    CHECK(scene.camera.lens.aperture > 0);
    // How many spheres are made of each kind of material, by its index in the variant.
    std::array<int, std::variant_size_v<rt::MaterialDescription>> spheres{};
    for (const rt::SphereDescription& sphere : scene.spheres) {
        CHECK(sphere.shape.radius > 0);
        const auto& material = scene.materials.at(static_cast<std::size_t>(sphere.material));
        ++spheres[material.index()];
    }
    const auto made_of = [&](const rt::MaterialDescription& material) {
        return spheres[material.index()];
    };
    CHECK(scene.maps.size() >= 10);
    CHECK(made_of(rt::Lambertian{}) > 5'000);
    CHECK(made_of(rt::Metal{}) > 1'000);
    CHECK(made_of(rt::Dielectric{}) > 100);
    CHECK(made_of(rt::Emitter{}) >= 5);
    CHECK(made_of(rt::Emitter{}) <= 12);  // each light takes samples from the others
}
