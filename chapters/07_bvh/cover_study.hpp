#pragma once
// Measures how long the whole cover picture takes, in the classic way and with this chapter's
// trees, and how much time is added by materials that are compiled in but not used.

#include <array>
#include <optional>
#include <rt/area_split.hpp>
#include <rt/dielectric.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/render_pixel.hpp>
#include <rt/shape_tree.hpp>
#include <rt/sky.hpp>
#include <rt/wide_builder.hpp>
#include <study/classic.hpp>
#include <study/cover.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>
#include <vector>

namespace bvh {

using namespace rt;

// The glass has Schlick's reflectance, as in the classic way.
using CoverMaterials = MaterialSet<Lambertian, Metal, SchlickDielectric>;

inline std::vector<SceneSphere> spheres_of(const study::Cover& cover) {
    std::vector<SceneSphere> spheres;
    for (const study::CoverSphere& s : cover.spheres)
        spheres.push_back({{s.center, s.radius}, static_cast<int>(spheres.size())});
    return spheres;
}

inline CoverMaterials materials_of(const study::Cover& cover) {
    CoverMaterials all;
    for (const study::CoverSphere& s : cover.spheres) switch (s.material) {
            case study::CoverMaterial::matte:
                all.materials.push_back(Lambertian{s.color});
                break;
            case study::CoverMaterial::metal:
                all.materials.push_back(Metal{s.color, s.fuzz});
                break;
            case study::CoverMaterial::glass:
                all.materials.push_back(SchlickDielectric{study::cover_glass_index});
                break;
        }
    return all;
}

// Renders the picture, and returns the mean of its green channel.
template <class World, class Materials>
double render(const study::Cover& cover, const World& world, const Materials& materials) {
    const Camera camera = make_camera(cover.view, cover.width, cover.height);
    const GradientSky sky{cover.horizon, cover.above};
    const Quality quality{cover.samples_per_pixel, cover.depth, 1};
    const Color mean = study::mean_color(cover, [&](int x, int y) {
        return render_pixel(camera, world, materials, sky, BlackEnding{}, quality, x, y);
    });
    return static_cast<double>(mean.g);
}

// A world that records every ray that it is asked about, and the answer.
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

// A world that gives a Recorder's answers again, in the same order, without any search.
struct Player {
    const std::vector<Recorder::Answer>& answers;
    std::size_t& next;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay&, Interval) const {
        return answers[next++].hit;
    }
};

// What a ray of the cover scene costs: in all, for the search alone, for the search and its Hit,
// and for the shading alone.
inline void study_parts(study::Report& report, const study::Cover& cover, const WideTree& world,
                        const CoverMaterials& materials) {
    std::vector<Recorder::Answer> answers;
    study::keep(render(cover, Recorder{world, answers}, materials));
    const auto rays = static_cast<double>(answers.size());
    double tests = 0;
    for (const auto& answer : answers) {
        const auto found = world.search(answer.ray, {});
        tests += (found.box_tests + found.shape_tests) / rays;
    }
    constexpr std::array<const char*, 4> names{"all", "search", "hit", "shading"};
    const auto ns =
        study::in_turns_ns({[&] { study::keep(render(cover, world, materials)); },
                            [&] {
                                for (const auto& answer : answers)
                                    study::keep(world.search(answer.ray, {}));
                            },
                            [&] {
                                for (const auto& answer : answers)
                                    study::keep(world.hit(answer.ray, {}));
                            },
                            [&] {
                                std::size_t next = 0;
                                study::keep(render(cover, Player{answers, next}, materials));
                            }});
    for (std::size_t i = 0; i < names.size(); ++i)
        report.add({"cover-parts", names[i], rays, "rays", tests, "wide tests per ray",
                    ns[i] / rays, "time per ray / ns"});
}

// Adds a row for each way to draw the cover, with its speed as a multiple of the first way's. The
// rows also show the mean green, which agrees if all ways draw the same picture.
template <std::size_t count>
void add_rows(study::Report& report, const char* study, const study::Cover& cover,
              const std::array<const char*, count>& names, const std::array<double, count>& greens,
              const std::vector<double>& ns) {
    for (std::size_t i = 0; i < count; ++i)
        report.add({study, names[i], ns[0] / ns[i], "times as fast", greens[i], "mean green",
                    cover.whole_ms(ns[i]), "time / ms"});
}

inline void study_cover(study::Report& report) {
    const study::Cover cover = study::make_cover();
    const std::vector<SceneSphere> spheres = spheres_of(cover);
    const CoverMaterials materials = materials_of(cover);
    const auto classic = study::classic::make_world(cover);
    const SphereTree by_area = make_tree(spheres, AreaSplit{});
    const WideTreeOf<SceneSphere, Real> wide = make_wide_tree<Real>(spheres);
    const WideTree best = make_wide_tree<float>(spheres);

    std::array<double, 4> greens{};
    const auto whole = study::in_turns_ns(
        {[&] { greens[0] = static_cast<double>(study::classic::mean_color(cover, *classic).g); },
         [&] { greens[1] = render(cover, by_area, materials); },
         [&] { greens[2] = render(cover, wide, materials); },
         [&] { greens[3] = render(cover, best, materials); }});
    add_rows<4>(report, "cover", cover, {"classic", "tree by area", "8-wide", "8-wide float boxes"},
                greens, whole);
    study_parts(report, cover, best, materials);

    // The same spheres, all matte: once with metal and glass compiled in, once without.
    CoverMaterials all;
    MaterialList<Lambertian> matte;
    matte.materials.assign(spheres.size(), {{Real(0.5), Real(0.5), Real(0.5)}});
    all.materials.assign(matte.materials.begin(), matte.materials.end());
    std::array<double, 2> same{};
    const auto times = study::in_turns_ns({[&] { same[0] = render(cover, best, all); },
                                           [&] { same[1] = render(cover, best, matte); }});
    add_rows<2>(report, "materials", cover, {"matte, metal and glass", "matte alone"}, same, times);
}

}  // namespace bvh
