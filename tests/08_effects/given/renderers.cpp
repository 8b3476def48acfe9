// The narrow renderers draw what the full one draws, bit for bit.

#include <filesystem>
#include <final_scene.hpp>
#include <map>
#include <rt/choose_renderer.hpp>
#include <rt/renderers.hpp>
#include <scene_file.hpp>
#include <set>

#include "../scenes.hpp"

using namespace checkpoint;
using rt::Effects;

namespace {

constexpr int width = 9, height = 6;
const rt::Quality quality{3, 6, 5};

// All pixels of a scene, and how many rays they took.
struct Drawn {
    std::vector<rt::Color> pixels;
    std::uint64_t rays = 0;
};

Drawn draw(const rt::SceneDescription& scene, std::size_t renderer) {
    const rt::DrawTile draw_tile =
        pixel_by_pixel(rt::renderer_makers[renderer](scene, width, height, quality));
    rt::Image image = rt::Canvas<rt::Color>{width, height};
    Drawn drawn;
    draw_tile({0, 0, width, height}, image, drawn.rays);
    drawn.pixels.assign(image.pixels().begin(), image.pixels().end());
    return drawn;
}

}  // namespace

TEST_CASE("a test scene has the effects that it says") {
    for (unsigned bits = 0; bits < sets_of_effects; ++bits) {
        const Effects effects = numbered_effects(bits);
        INFO(names(effects) << " is found to be " << names(needed_effects(scene_with(effects))));
        REQUIRE((needed_effects(scene_with(effects)) == effects));
    }
}

TEST_CASE("each scene's narrowest renderer draws what the full one draws") {
    const std::size_t full = rt::narrowest(rt::every_effect, rt::renderer_effects);
    std::set<std::size_t> used;
    for (unsigned bits = 0; bits < sets_of_effects; ++bits) {
        const rt::SceneDescription scene = scene_with(numbered_effects(bits));
        const std::size_t narrow = rt::narrowest(needed_effects(scene), rt::renderer_effects);
        used.insert(narrow);
        const Drawn by_narrow = draw(scene, narrow), by_full = draw(scene, full);
        INFO("scene: " << names(needed_effects(scene)));
        INFO("renderer: " << names(rt::renderer_effects[narrow]));
        REQUIRE(by_narrow.rays == by_full.rays);
        for (std::size_t i = 0; i < by_narrow.pixels.size(); ++i) {
            REQUIRE(rt::is_finite(by_narrow.pixels[i]));
            REQUIRE(same_color(by_narrow.pixels[i], by_full.pixels[i]));
        }
    }
    INFO("a renderer that no scene chooses would be compiled for nothing");
    CHECK(used.size() == rt::renderer_effects.size());
}

TEST_CASE("the renderers of the final scene and of the chapter's scenes have no other effects") {
    std::map<std::string, rt::SceneDescription> scenes{{"final", effects::final_scene()}};
    const std::filesystem::path folder = COURSE_ROOT "/chapters/08_effects/scenes";
    for (const auto& file : std::filesystem::directory_iterator{folder})
        if (file.path().extension() == ".json")
            scenes.emplace(file.path().filename().string(), effects::read_scene(file));
    std::set<std::size_t> used;
    for (const auto& [name, scene] : scenes) {
        const Effects needed = needed_effects(scene);
        const std::size_t number = rt::narrowest(needed, rt::renderer_effects);
        const Effects unused = without(rt::renderer_effects[number], needed);
        INFO(name << " needs: " << names(needed));
        INFO("its renderer has also: " << names(unused));
        CHECK((unused == Effects{}));
        used.insert(number);
    }
    INFO("a set of exact_effects that none of these scenes has");
    CHECK(used.size() == rt::exact_effects.size());
}

TEST_CASE("every renderer that has what a scene needs draws the same") {
    for (const Effects effects : {Effects{}, Effects{.mirror = true}, Effects{.lens = true},
                                  Effects{.glass = true, .lights = true}}) {
        const rt::SceneDescription scene = scene_with(effects);
        const Drawn expected = draw(scene, rt::narrowest(effects, rt::renderer_effects));
        for (std::size_t i = 0; i < rt::renderer_effects.size(); ++i) {
            if (!covers(rt::renderer_effects[i], effects)) continue;
            INFO("scene: " << names(effects));
            INFO("renderer: " << names(rt::renderer_effects[i]));
            const Drawn drawn = draw(scene, i);
            CHECK(drawn.rays == expected.rays);
            CHECK(std::equal(drawn.pixels.begin(), drawn.pixels.end(), expected.pixels.begin(),
                             same_color));
        }
    }
}

TEST_CASE("an effect that is there changes the picture") {
    const Drawn plain = draw(scene_with({}), rt::narrowest({}, rt::renderer_effects));
    for (const rt::NamedEffect& effect : rt::all_effects) {
        Effects one;
        one.*effect.member = true;
        const Drawn drawn = draw(scene_with(one), rt::narrowest(one, rt::renderer_effects));
        INFO(effect.name);
        CHECK_FALSE(
            std::equal(drawn.pixels.begin(), drawn.pixels.end(), plain.pixels.begin(), same_color));
    }
}

TEST_CASE("what cannot be seen changes nothing") {
    const Drawn expected = draw(scene_with({}), rt::narrowest({}, rt::renderer_effects));
    rt::SceneDescription scene = scene_with({});
    scene.camera.lens = {0, 3};
    scene.fog = rt::Fog{{{0, 0, 0}, 8}, 0};
    scene.haze = rt::Haze{0, {1, 1, 1}};
    scene.spheres[1].velocity = {1, 1, 1};  // with a closed shutter
    REQUIRE((needed_effects(scene) == Effects{}));
    const std::size_t full = rt::narrowest(rt::every_effect, rt::renderer_effects);
    for (const std::size_t renderer : {rt::narrowest({}, rt::renderer_effects), full}) {
        const Drawn drawn = draw(scene, renderer);
        CHECK(std::equal(drawn.pixels.begin(), drawn.pixels.end(), expected.pixels.begin(),
                         same_color));
    }
}
