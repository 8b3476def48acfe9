// libFuzzer's target: whatever bytes a scene file or an image file holds, they make a scene that
// keeps its promises and can be drawn, or one line that says what is wrong.
#include <app/errors.hpp>
#include <cstdint>
#include <rt/image_file.hpp>
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
        // An image file and a scene file begin so differently that one target will do.
        if (!bytes.empty() && bytes[0] == '\x89') {
            rt::decode_image(bytes, limits.image_pixels);
        } else {
            const auto scene = effects::parse_scene(bytes, "scene.json", FUZZ_FOLDER, limits);
            check(scene);
            draw(scene);
        }
    } catch (const app::UsageError& error) {
        must(std::string{error.what()}.size() < 1000);
    } catch (const std::length_error&) {
    } catch (const std::runtime_error&) {
        must(bytes[0] == '\x89');
    }
    return 0;
}
