#pragma once
#define render_pixel render_pixel_unrecorded
#include_next <rt/render_pixel.hpp>
#undef render_pixel
#include <rt/record.hpp>
#include <type_traits>
#include <variant>

namespace rt {
namespace recorder {

template <class AnyCamera>
void note_camera(const AnyCamera& camera) {
    const auto note = [](const char* name, const auto& value) {
        record().note("the camera", name, value);
    };
    if constexpr (requires { camera.lens; }) {
        record().note("the lens", "the aperture", camera.lens.aperture);
        record().note("the lens", "the focus", camera.lens.focus_distance);
        note_camera(camera.camera);
    } else if constexpr (requires { camera.viewport; }) {
        record().note("the lens", "the aperture", 0);
        note("the camera's position", camera.eye);
        note("the camera's u", camera.basis.u);
        note("the camera's v", camera.basis.v);
        note("the camera's w", camera.basis.w);
        note("the viewport's width", camera.viewport.width);
        note("the viewport's height", camera.viewport.height);
    }
}

template <class AnyWorld, class Materials>
void note_world(const AnyWorld& world, const Materials& materials) {
    const auto note_one = [](const std::string& group, const auto& material) {
        if constexpr (requires { std::visit([](const auto&) {}, material); })
            std::visit([&](const auto& one) { note_material(group, one); }, material);
        else
            note_material(group, material);
    };
    const auto note_all = [&](const char* kind, const auto& spheres) {
        record().note("the call", "the world", kind);
        note_spheres(spheres, [&](const std::string& group, const SceneSphere& sphere) {
            if constexpr (requires { materials.materials; }) {
                const auto number = static_cast<std::size_t>(sphere.material);
                if (number < materials.materials.size())
                    note_one(group, materials.materials[number]);
                else
                    record().note(group, "the material", "none");
            }
        });
    };
    if constexpr (requires { world.spheres; }) note_all("a list", world.spheres);
    if constexpr (requires { world.shapes; }) note_all("a tree", world.shapes);
}

}  // namespace recorder

// Draws nothing.
template <class AnyCamera, World AnyWorld, class Materials, class Sky, Ending AnyEnding>
Color render_pixel(const AnyCamera& camera, const AnyWorld& world, const Materials& materials,
                   const Sky& sky, const AnyEnding&, const Quality& quality, int column, int row) {
    recorder::Record& record = recorder::record();
    if (!record.counts_pixel(column, row)) return {};
    recorder::note_camera(camera);
    record.note("the call", "the seed", quality.seed);
    record.note("the paths", "the number of samples", quality.samples_per_pixel);
    record.note("the paths", "the depth", quality.depth);
    record.note("the paths", "the ending",
                std::is_same_v<AnyEnding, BlackEnding> ? "BlackEnding"
                : std::is_same_v<AnyEnding, SkyEnding> ? "SkyEnding"
                                                       : "another");
    record.note("the sky", "the sky's color below", sky(Vec3{0, -1, 0}));
    record.note("the sky", "the sky's color above", sky(Vec3{0, 1, 0}));
    recorder::note_world(world, materials);
    return {};
}

}  // namespace rt
