#pragma once
// The whole picture against the classic way, and with no more materials than it needs.

#include <optional>
#include <rt/split_by_area.hpp>
#include <rt/wide_builder.hpp>
#include <study/report.hpp>

#include "cover.hpp"
#include "variants.hpp"

namespace bvh {

// Times both by turns, so that what else the machine does slows both alike, and returns the
// shortest time of each, in milliseconds.
template <class One, class Other>
std::pair<double, double> by_turns_ms(One one, Other other, int turns = 5) {
    double of_one = 1e300, of_other = 1e300;
    for (int i = 0; i < turns; ++i) {
        of_one = std::min(of_one, study::once_ns(one, 1) * 1e-6);
        of_other = std::min(of_other, study::once_ns(other, 1) * 1e-6);
    }
    return {of_one, of_other};
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
    const WideTree best = make_wide_tree<float>(cover.spheres);

    // That the mean colors agree shows that both draw the same.
    const auto classic_world = make_classic(cover);
    Color mean;
    double classic_ms = 0, classic_mean = 0;
    const auto row = [&](const char* name, double times, double green, double ms) {
        report.add({"cover", name, times, "times as fast", green, "mean green", ms, "time / ms"});
    };
    const auto whole = [&](const char* name, const auto& world) {
        const auto [theirs, ours] = by_turns_ms(
            [&] { classic_mean = static_cast<double>(render_cover(cover, classic_world).g); },
            [&] { mean = render_cover(cover, world, cover.materials); });
        if (classic_ms == 0) row("classic", 1, classic_mean, classic_ms = theirs);
        row(name, theirs / ours, static_cast<double>(mean.g), ours);
    };
    whole("8-wide float boxes", best);
    whole("8-wide", make_wide_tree<Real>(cover.spheres));
    whole("tree by area", make_tree(cover.spheres, split_by_area));
    study_parts(report, cover, best);

    // The same spheres, all matte: once with metal and glass compiled in, once without.
    CoverMaterials all;
    MaterialList<Lambertian> matte;
    for (std::size_t i = 0; i < cover.spheres.size(); ++i) {
        matte.materials.push_back({{Real(0.5), Real(0.5), Real(0.5)}});
        all.materials.push_back(matte.materials.back());
    }
    const auto times = by_turns_ms([&] { mean = render_cover(cover, best, all); },
                                   [&] { mean = render_cover(cover, best, matte); });
    const auto materials = [&](const char* name, double ms) {
        report.add({"materials", name, times.first / ms, "times as fast",
                    static_cast<double>(mean.g), "mean green", ms, "time / ms"});
    };
    materials("matte, metal and glass", times.first);
    materials("matte alone", times.second);
}

}  // namespace bvh
