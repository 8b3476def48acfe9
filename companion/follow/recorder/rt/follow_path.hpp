#pragma once
// What a path loop is given, in front of the program's own: it says what happens, and otherwise
// does the same. None of these functions is inlined, or chapter 08 would take minutes to compile.

#include <cstring>
#include <optional>
#include <rt/compiler.hpp>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/path_end.hpp>
#include <rt/scatter.hpp>
#include <rt/surface_hit.hpp>
#include <rt/trail.hpp>
#include <variant>

namespace rt::follow {

constexpr int most_segments = 200;

struct Path {
    explicit Path(int depth) {
        here.in_path = true;
        trail().step("path", "depth", depth);
    }
    ~Path() { here.in_path = false; }
    Path(const Path&) = delete;
    Path& operator=(const Path&) = delete;
};

// A generator that keeps what it has given.
template <class Random>
struct Numbers : Random {
    explicit Numbers(const Random& random) : Random{random} {}
    Real uniform() {
        drawn.push_back(Random::uniform());
        return drawn.back();
    }
    Real uniform(Real low, Real high) { return low + (high - low) * uniform(); }

    std::vector<Real> drawn;
};
template <class Random>
void note_numbers(Numbers<Random>& random) {
    if (!random.drawn.empty()) trail().step("random", "numbers", random.drawn);
    random.drawn.clear();
}

template <class World>
struct Scene {
    const World& world;

    template <class AnyRay>
    RT_NOT_INLINED std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        if (++here.segments > most_segments) {
            trail().step("endless", "segments", most_segments);
            trail().end();
        }
        if (here.segments > 1)
            trail().step("ray", "origin", ray.origin, "direction", ray.direction);
        const std::optional<Hit> found = world.hit(ray, within);
        if (!found) {
            trail().step("miss");
        } else if (std::memcmp(&last_hit.point, &found->point, sizeof(Vec3)) == 0) {  // NaN, too
            trail().step("hit", "t", found->t, "point", found->point, "normal", found->normal,
                         "front", found->front, "lamp", found->light, "number", found->shape,
                         "center", last_hit.sphere.center, "radius", last_hit.sphere.radius);
        } else {  // it is no sphere
            trail().step("hit", "t", found->t, "point", found->point, "normal", found->normal,
                         "front", found->front, "lamp", found->light);
        }
        return found;
    }
};

// A material's type and its numbers.
template <class Material>
void note_material(const Material& material) {
    const std::string_view words = __PRETTY_FUNCTION__;  // "... [with Material = rt::Metal]"
    const auto end = words.find_first_of(";]", words.find("Material = "));
    const auto begin = words.find_last_of(": ", end) + 1;
    trail().step("material", "name", words.substr(begin, end - begin));
    if constexpr (requires { material.albedo; }) trail().step("of", "albedo", material.albedo);
    if constexpr (requires { material.fuzz; }) trail().step("of", "fuzz", material.fuzz);
    if constexpr (requires { material.index; }) trail().step("of", "index", material.index);
    // Of the learner's own, 05.6.
    if constexpr (requires { material.color; }) trail().step("of", "color", material.color);
    if constexpr (requires { material.amount; }) trail().step("of", "amount", material.amount);
}

// That of a set, if it shows it.
template <class Set>
void note_material_of(const Set& set, std::size_t number) {
    if constexpr (requires { set.materials[number].index(); }) {
        if (number < set.materials.size())
            std::visit([](const auto& one) { note_material(one); }, set.materials[number]);
    } else if constexpr (requires { set.materials[number]; }) {
        if (number < set.materials.size()) note_material(set.materials[number]);
    } else if constexpr (requires { set.materials; }) {
        note_material_of(set.materials, number);
    }
}

template <class Materials>
struct Surfaces {
    const Materials& set;

    template <class Random>
    RT_NOT_INLINED std::optional<Scatter> operator()(Vec3 incoming, const Hit& hit,
                                                     Random& random) const {
        note_material_of(set, static_cast<std::size_t>(hit.material));
        random.drawn.clear();
        const std::optional<Scatter> bounce = set(incoming, hit, random);
        note_numbers(random);
        if (bounce)
            trail().step("scatter", "direction", bounce->direction, "attenuation",
                         bounce->attenuation);
        else
            trail().step("absorbed");
        return bounce;
    }
};

template <class Sky>
struct Far {
    const Sky& sky;

    RT_NOT_INLINED Color operator()(Vec3 direction) const {
        const Color light = sky(direction);
        trail().step("sky", "direction", direction, "color", light);
        return light;
    }
};

template <class Ending>
struct Limit {
    const Ending& ending;

    template <class Random>
    RT_NOT_INLINED PathEnd operator()(Color& throughput, Random& random) const {
        random.drawn.clear();
        const PathEnd end = ending(throughput, random);
        note_numbers(random);
        constexpr const char* names[] = {"sky", "black", "none"};
        trail().step("limit", "ends", names[static_cast<int>(end)], "throughput", throughput);
        return end;
    }
};

}  // namespace rt::follow
