// The live figures of chapter 05.
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>

#include "controls.hpp"
#include "live.hpp"
#include "scene.hpp"

namespace live {
namespace {

// ---- The chapter's scene ----

using Materials =
    rt::MaterialSet<rt::Lambertian, scene::Tiles, rt::Metal, rt::Dielectric, rt::SchlickDielectric>;

// The scene's materials, with what the controls change.
Materials materials_of(const scene::Scene& evening, const SceneControls& c) {
    Materials changed;
    for (const auto& one : evening.set.materials) {
        auto material = std::visit(
            [](const auto& same) -> decltype(changed.materials)::value_type { return same; }, one);
        if (auto* metal = std::get_if<rt::Metal>(&material))
            metal->fuzz = std::clamp(metal->fuzz + c.fuzz, 0.0, 1.0);
        if (const auto* glass = std::get_if<rt::Dielectric>(&material)) {
            const double index = glass->index > 1 ? c.index : 1 / c.index;  // a bubble's is below 1
            if (c.reflectance > 0)
                material = rt::SchlickDielectric{index};
            else
                material = rt::Dielectric{index};
        }
        changed.materials.push_back(material);
    }
    return changed;
}

}  // namespace

void draw(const SceneControls& c, Drawing& out) {
    const double aspect = out.is_narrow() ? 1.7 : 2.2;
    out.height = out.width / aspect;
    const int columns = static_cast<int>(std::min(out.width * out.pixel_ratio, 560.0)),
              rows = static_cast<int>(columns / aspect);
    const double turn = rt::radians(c.turn), width = 2.46 * std::tan(rt::radians(9.5));
    const rt::Camera camera = rt::make_camera({{12 * std::sin(turn), 2.9, 12 * std::cos(turn)},
                                               {0, 0.85, 0},
                                               {0, 1, 0},
                                               2 * std::atan(width / aspect)},
                                              columns, rows);
    const scene::Scene evening = scene::evening();
    out.refine({0, 0}, {out.width, out.height}, columns, rows, 256,
               [camera, world = evening.world, set = materials_of(evening, c),
                depth = static_cast<int>(c.depth)](int column, int row, int sample) {
                   rt::Rng random = rt::pixel_rng(static_cast<unsigned>(sample), column, row);
                   return path_radiance(primary_ray(camera, column, row, random_place(random)),
                                        world, set, scene::EveningSky{}, rt::SkyEnding{}, depth,
                                        random);
               });
    out.handle_everywhere();
    const double glass = rt::fresnel_reflectance(1, 1 / c.index);
    out.say("Head on, glass of index {} reflects {.1} % of the light.", c.index, 100 * glass);
}

void drag(SceneControls& c, const Drag& to) {
    c.turn -= 90 * to.moved().x / to.width;
}

}  // namespace live
