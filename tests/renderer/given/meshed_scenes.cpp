// Scenes with meshes: what they need, and how their files are read.

#include <open_meshed.hpp>
#include <rt/choose_renderer.hpp>

#include "../../08_effects/scenes.hpp"
#include "temporary_folder.hpp"

using namespace checkpoint;
using rt::Effects;

TEST_CASE("a mesh calls for the same effects as a sphere of its material") {
    for (const rt::NamedEffect& effect : rt::all_effects) {
        Effects one;
        one.*effect.member = true;
        rt::MeshedDescription scene{scene_with(one), {}};
        std::erase_if(scene.spheres, [&](const rt::SphereDescription& sphere) {
            const auto& material = scene.materials[static_cast<std::size_t>(sphere.material)];
            const bool can_be_mesh = sphere.map < 0 && sphere.velocity == rt::Vec3{} &&
                                     !std::holds_alternative<rt::Emitter>(material);
            if (can_be_mesh) scene.meshes.push_back({nullptr, {}, sphere.material});
            return can_be_mesh;
        });
        INFO(effect.name << ": found to be " << names(needed_effects(scene)));
        CHECK((needed_effects(scene) == one));
    }
}

TEST_CASE("a mesh file is read once, however often it is placed") {
    const TemporaryFolder folder;
    write_file(folder / "one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write_file(folder / "scene.json",
               R"({"camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0]},
                   "materials": {"m": {"type": "matte", "color": "#ffffff"}}, "meshes": [
            {"file": "one.obj", "material": "m"},
            {"file": "one.obj", "material": "m", "center": [1, 0, 0]},
            {"file": "one.obj", "material": "m", "smooth": true}]})");
    const auto scene = full_renderer::read_scene(folder / "scene.json");
    REQUIRE(scene.meshes.size() == 3);
    CHECK(scene.meshes[0].mesh == scene.meshes[1].mesh);
    CHECK(scene.meshes[0].mesh->normals.empty());
    CHECK(scene.meshes[1].object_to_world(0, 3) == 1);
    CHECK(scene.meshes[2].mesh->normals.size() == 3);
}
