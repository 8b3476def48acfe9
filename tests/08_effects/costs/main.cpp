// costs SCENE RENDERER: draws a scene with one of several renderers, and prints the sum of all
// colors with all digits. costs.sh counts the instructions of sum_of().
//   SCENE     the effects that the matte spheres of the scene get, such as glass+lens, or none
//   RENDERER  the effects of the renderer, or hand: the loop written by hand for the scenes none,
//             mirror+fuzz and glass+lens
// costs compiler prints what compiled it, costs effects which effects there are, and costs
// materials, costs lit and costs every those of the renderers that scenes share.

#include <cstdio>
#include <cstdlib>
#include <rt/choose_renderer.hpp>
#include <rt/renderers.hpp>
#include <stdexcept>
#include <string>
#include <study_scene.hpp>

#include "by_hand.hpp"

namespace {

using namespace rt;

const by_hand::Picture picture{48, 27, 4, 8, 1};

std::string name_of(const Effects& effects) {
    std::string name;
    for (const NamedEffect& effect : all_effects)
        if (effects.*effect.member) name += std::string{effect.name} + '+';
    if (name.empty()) return "none";
    name.pop_back();
    return name;
}

Effects effects_named(const std::string& name) {
    Effects effects;
    for (const NamedEffect& effect : all_effects)
        effects.*effect.member =
            ('+' + name + '+').find('+' + std::string{effect.name} + '+') != std::string::npos;
    if (name_of(effects) != name) throw std::invalid_argument("no such effects: " + name);
    return effects;
}

// Not inlined: the instructions that it executes are counted.
template <class Shade>
RT_NOT_INLINED Color sum_of(const Shade& shade) {
    Color sum;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) sum += shade(x, y);
    return sum;
}

// A renderer for each effect alone, for what is compared with loops written by hand, and those that
// scenes share.
constexpr auto measured_effects = [] {
    constexpr std::array by_hand{Effects{}, Effects{.mirror = true, .fuzz = true},
                                 Effects{.glass = true, .lens = true}};
    std::array<Effects, all_effects.size() + by_hand.size() + shared_effects.size()> all;
    auto next = all.begin();
    for (const NamedEffect& effect : all_effects) (next++)->*effect.member = true;
    next = std::copy(by_hand.begin(), by_hand.end(), next);
    std::copy(shared_effects.begin(), shared_effects.end(), next);
    return all;
}();

Color draw_by_hand(const Effects& effects, const SceneDescription& scene) {
    if (effects == Effects{}) return sum_of(by_hand::Matte{scene, picture});
    if (effects == Effects{.mirror = true, .fuzz = true})
        return sum_of(by_hand::MatteAndMetal{scene, picture});
    if (effects == Effects{.glass = true, .lens = true})
        return sum_of(by_hand::GlassAndLens{scene, picture});
    throw std::invalid_argument("no loop by hand for " + name_of(effects));
}

// Not through renderer_makers: those count rays, which the loops by hand do not.
template <std::size_t... number>
Color draw(const Effects& chosen, const SceneDescription& scene, std::index_sequence<number...>) {
    std::optional<Color> sum;
    const auto draw_with = [&]<std::size_t i>() {
        const Quality quality{picture.samples, picture.depth, picture.seed};
        sum = sum_of(Renderer<measured_effects[i]>{scene, picture.width, picture.height, quality});
    };
    ((!sum && chosen == measured_effects[number] ? draw_with.template operator()<number>()
                                                 : void()),
     ...);
    if (!sum) throw std::invalid_argument("no such renderer: " + name_of(chosen));
    return *sum;
}

void print(const std::string& word) {
#ifdef __x86_64__
    const char* const processor = "x86-64";
#else
    const char* const processor = "another processor";
#endif
    if (word == "compiler") std::printf("g++ %s for %s\n", __VERSION__, processor);
    if (word == "materials") std::puts(name_of(shared_effects.front()).c_str());
    if (word == "lit") std::puts(name_of(shared_effects[1]).c_str());
    if (word == "every") std::puts(name_of(every_effect).c_str());
    if (word == "effects")
        for (const NamedEffect& effect : all_effects) std::puts(effect.name);
}

void draw(const std::string& scene_name, const std::string& renderer) {
    const Effects shown = effects_named(scene_name);
    const SceneDescription scene = effects::study_scene(shown);
    if (needed_effects(scene) != shown)
        throw std::logic_error(scene_name + " needs " + name_of(needed_effects(scene)));
    const Color sum = renderer == "hand"
                          ? draw_by_hand(shown, scene)
                          : draw(effects_named(renderer), scene,
                                 std::make_index_sequence<measured_effects.size()>{});
    std::printf("%.17g %.17g %.17g\n", double(sum.r), double(sum.g), double(sum.b));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc == 2)
        print(argv[1]);
    else if (argc == 3)
        draw(argv[1], argv[2]);
    else
        return 2;
} catch (const std::exception& error) {
    std::fprintf(stderr, "costs: %s\n", error.what());
    return 2;
}
