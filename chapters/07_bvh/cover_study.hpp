#pragma once
// The whole picture against the classic way, and with no more materials than it needs.

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <rt/split_by_area.hpp>
#include <rt/wide_builder.hpp>
#include <study/report.hpp>
#include <vector>

#include "cover.hpp"
#include "variants.hpp"

namespace bvh {

// Times all by turns, so that what else the machine does slows all alike, and returns the shortest
// time of each, in milliseconds.
inline std::vector<double> by_turns_ms(const std::vector<std::function<void()>>& works,
                                       int turns = 5) {
    std::vector<double> times(works.size(), std::numeric_limits<double>::infinity());
    for (int turn = 0; turn < turns; ++turn)
        for (std::size_t i = 0; i < works.size(); ++i)
            times[i] = std::min(times[i], study::once_ns(works[i], 1) * 1e-6);
    return times;
}

// Writes down every ray that it is asked for, and what it answered.
struct Recorder {
    struct Answer {
        Ray ray;
        std::optional<Hit> hit;
    };
    const WideTree& world;
    std::vector<Answer>& answers;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& any_ray, Interval within) const {
        const Ray ray{any_ray.origin, any_ray.direction};
        answers.push_back({ray, world.hit(ray, within)});
        return answers.back().hit;
    }
};

// Gives the same answers again, without any search.
struct Player {
    const std::vector<Recorder::Answer>& answers;
    std::size_t& next;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay&, Interval) const {
        return answers[next++].hit;
    }
};

// What a ray of the cover scene costs: the search alone, with its hit, and the shading alone.
inline void study_parts(study::Report& report, const Cover& cover, const WideTree& world) {
    std::vector<Recorder::Answer> answers;
    study::keep(render_cover(cover, Recorder{world, answers}, cover.materials));
    const auto rays = static_cast<double>(answers.size());
    double tests = 0;
    for (const auto& answer : answers) {
        const auto found = world.search(answer.ray, {});
        tests += (found.box_tests + found.sphere_tests) / rays;
    }
    const auto part = [&](const char* name, const auto& work) {
        report.add({"cover-parts", name, rays, "rays", tests, "wide tests per ray",
                    study::once_ns(work, 5) / rays, "time per ray / ns"});
    };
    part("all", [&] { study::keep(render_cover(cover, world, cover.materials)); });
    part("search", [&] {
        for (const auto& answer : answers) study::keep(world.search(answer.ray, {}));
    });
    part("hit", [&] {
        for (const auto& answer : answers) study::keep(world.hit(answer.ray, {}));
    });
    part("shading", [&] {
        std::size_t next = 0;
        study::keep(render_cover(cover, Player{answers, next}, cover.materials));
    });
}

inline void study_cover(study::Report& report) {
    const Cover cover = make_cover();
    const auto classic = make_classic(cover);
    const SphereTree by_area = make_tree(cover.spheres, split_by_area);
    const WideTreeOf<Real> wide = make_wide_tree<Real>(cover.spheres);
    const WideTree best = make_wide_tree<float>(cover.spheres);

    // That the mean colors agree shows that all draw the same.
    constexpr std::array<const char*, 4> names{"classic", "tree by area", "8-wide",
                                               "8-wide float boxes"};
    std::array<double, 4> greens{};
    const auto green = [](const auto& mean) { return static_cast<double>(mean.g); };
    const std::vector<double> whole =
        by_turns_ms({[&] { greens[0] = green(render_cover(cover, classic)); },
                     [&] { greens[1] = green(render_cover(cover, by_area, cover.materials)); },
                     [&] { greens[2] = green(render_cover(cover, wide, cover.materials)); },
                     [&] { greens[3] = green(render_cover(cover, best, cover.materials)); }});
    for (std::size_t i = 0; i < names.size(); ++i)
        report.add({"cover", names[i], whole[0] / whole[i], "times as fast", greens[i],
                    "mean green", whole[i], "time / ms"});
    study_parts(report, cover, best);

    // The same spheres, all matte: once with metal and glass compiled in, once without.
    CoverMaterials all;
    MaterialList<Lambertian> matte;
    for (std::size_t i = 0; i < cover.spheres.size(); ++i) {
        matte.materials.push_back({{Real(0.5), Real(0.5), Real(0.5)}});
        all.materials.push_back(matte.materials.back());
    }
    const std::vector<double> times =
        by_turns_ms({[&] { greens[0] = green(render_cover(cover, best, all)); },
                     [&] { greens[1] = green(render_cover(cover, best, matte)); }});
    constexpr std::array<const char*, 2> kinds{"matte, metal and glass", "matte alone"};
    for (std::size_t i = 0; i < kinds.size(); ++i)
        report.add({"materials", kinds[i], times[0] / times[i], "times as fast", greens[i],
                    "mean green", times[i], "time / ms"});
}

}  // namespace bvh
