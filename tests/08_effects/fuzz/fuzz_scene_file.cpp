// libFuzzer's target: whatever bytes a scene file or an image file holds, they make a scene that
// keeps its promises and can be drawn, or one line that says what is wrong.
#include <app/errors.hpp>
#include <cstdint>
#include <rt/image_file.hpp>
#include <rt/light_file.hpp>
#include <rt/renderer.hpp>
#include <scene_file.hpp>

#include "../../support/fuzzing.hpp"

namespace {

using fuzzing::must, fuzzing::is_index_of;

void check(const rt::SceneDescription& scene) {
    for (const rt::SphereDescription& sphere : scene.spheres) {
        must(is_finite(sphere.shape.center) && is_finite(sphere.velocity));
        must(sphere.shape.radius > 0 && sphere.shape.radius < rt::infinity);
        must(is_index_of(scene.materials, sphere.material));
    }
    for (const rt::MaterialDescription& material : scene.materials)
        if (const auto* const picture = std::get_if<rt::PictureMatte>(&material))
            must(is_index_of(scene.images, picture->image));
    must(is_finite(scene.sky.below) && is_finite(scene.sky.above));
    must(scene.settings.width >= 1 && scene.settings.height >= 1);
}

// Image files and scene files begin so differently that one target will do.
bool is_png(const std::string& bytes) {
    return bytes.rfind('\x89', 0) == 0;
}
bool is_light(const std::string& bytes) {
    return bytes.rfind("#?", 0) == 0 || bytes.rfind('P', 0) == 0;
}

void check_light(const rt::Image& image) {
    for (const rt::Color& color : image.pixels())
        for (const rt::Real channel : {color.r, color.g, color.b})
            must(0 <= channel && channel <= static_cast<rt::Real>(rt::brightest));
}

// A few samples by the renderer that has everything. Many spheres would take long.
void draw(const rt::SceneDescription& scene) {
    constexpr int side = 8;
    if (scene.spheres.size() > 50) return;
    const rt::Renderer<rt::every_effect> renderer{scene, side, side, {2, 4, scene.settings.seed}};
    fuzzing::draw(renderer, side);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    // Small limits: the faults to be found are in the rules, not in large numbers.
    const effects::Limits limits{.spheres = 500, .image_pixels = 1 << 14};
    try {
        if (is_png(bytes)) {
            rt::decode_image(bytes, limits.image_pixels);
        } else if (is_light(bytes)) {
            check_light(rt::decode_light(bytes, limits.image_pixels));
        } else {
            const auto scene = effects::parse_scene(bytes, "scene.json", FUZZ_FOLDER, limits);
            check(scene);
            draw(scene);
        }
    } catch (const app::UsageError& error) {
        must(std::string{error.what()}.size() < 1000);
    } catch (const std::length_error&) {
    } catch (const std::runtime_error&) {
        must(is_png(bytes) || is_light(bytes));
    }
    return 0;
}
