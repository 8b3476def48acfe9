// Measures the time of a ray alone, in packets and in batches of several sizes, and how much of it
// each part of the work takes.

#include <app/run.hpp>
#include <numeric>
#include <rt/sort_by_kind.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>

#include "lanes_body.hpp"
#include "packet_search.hpp"

namespace batches {
namespace {

// The rays of a picture, grouped as in batches: the rays of the first bounce of many paths, then
// the rays of their second bounce, and so on.
using Rays = std::vector<std::vector<Ray>>;

struct Recorder {
    const WideTree& world;
    std::vector<Ray>& path;

    std::optional<Hit> hit(const Ray& ray, Interval within) const {
        path.push_back(ray);
        return world.hit(ray, within);
    }
};

struct Recorded {
    Rays camera, bounced;
};

Recorded record(const ReadyScene<scene_effects>& scene) {
    std::vector<std::vector<Ray>> paths;
    for (int y = 0; y < study_height; ++y)
        for (int x = 0; x < study_width; ++x)
            for (int sample = 0; sample < study_quality.samples_per_pixel; ++sample) {
                Rng random = sample_rng(study_quality.seed, x, y, sample);
                const Ray ray = make_ray(scene.camera, x, y, {0, 0}, random);
                path_radiance(ray, Recorder{scene.world, paths.emplace_back()}, scene.materials,
                              scene.sky, SkyEnding{}, study_quality.depth, random);
            }
    Recorded recorded;
    for (std::size_t first = 0; first < paths.size(); first += batch_size)
        for (std::size_t bounce = 0;; ++bounce) {
            std::vector<Ray> batch;
            for (std::size_t i = first; i < std::min(first + batch_size, paths.size()); ++i)
                if (bounce < paths[i].size()) batch.push_back(paths[i][bounce]);
            if (batch.empty()) break;
            (bounce == 0 ? recorded.camera : recorded.bounced).push_back(std::move(batch));
        }
    return recorded;
}

std::size_t count(const Rays& rays) {
    std::size_t sum = 0;
    for (const auto& batch : rays) sum += batch.size();
    return sum;
}

using Found = std::vector<NearestHit>;  // the hit of each ray

// Three ways to search. Each adds the hits of the rays to `found`, unless `found` is null.
void search_singly(const WideTree& tree, const Rays& rays, Found* found) {
    for (const auto& batch : rays)
        for (const Ray& ray : batch) {
            const auto search = tree.search(ray, {});
            study::keep(search);
            if (found) found->push_back({search.within.max, search.nearest});
        }
}

template <std::size_t size>
void search_in_packets(const WideTree& tree, const Rays& rays, Found* found) {
    for (const auto& batch : rays) {
        std::size_t i = 0;
        for (; i + size <= batch.size(); i += size) {
            Packet<size> packet{&batch[i]};
            packet.find_nearest(tree);
            study::keep(packet.best);
            if (found) found->insert(found->end(), packet.best.begin(), packet.best.end());
        }
        search_singly(tree, {{batch.begin() + static_cast<long>(i), batch.end()}}, found);
    }
}

// The rays as path records, ready to be searched in batches.
class Batches {
  public:
    Batches(const WideTree& tree, const Rays& rays) : search_{tree} {
        for (const auto& batch : rays) {
            paths_.emplace_back(batch.size());
            for (std::size_t i = 0; i < batch.size(); ++i) {
                paths_.back()[i].origin = batch[i].origin;
                paths_.back()[i].direction = batch[i].direction;
            }
        }
    }
    // end(i) is the t at which ray i ends.
    template <class End>
    void search(const End& end, Found* found = nullptr) {
        std::size_t number = 0;
        for (auto& batch : paths_) {
            for (PathRecord& path : batch) {
                path.t = end(number++);
                path.sphere = -1;
            }
            search_.make_ready(batch);
            search_.find_nearest(batch);
            if (found)
                for (const PathRecord& path : batch)
                    found->push_back({path.t, static_cast<std::int32_t>(path.sphere)});
        }
    }

  private:
    BatchSearch search_;
    std::vector<std::vector<PathRecord>> paths_;
};

constexpr auto far_away = [](std::size_t) { return infinity; };

// How the time of a search changes with the number of rays that go down the tree together.
void study_search(study::Report& report, const WideTree& tree, const Recorded& recorded) {
    const auto rows = [&](const char* variant, const Rays& rays) {
        Batches batches{tree, rays};
        const std::vector<std::function<void(Found*)>> ways{
            [&](Found* found) { search_singly(tree, rays, found); },
            [&](Found* found) { search_in_packets<8>(tree, rays, found); },
            [&](Found* found) { search_in_packets<16>(tree, rays, found); },
            [&](Found* found) { batches.search(far_away, found); }};
        std::vector<study::Work> works;
        std::vector<Found> found(ways.size());
        for (std::size_t i = 0; i < ways.size(); ++i) {
            ways[i](&found[i]);
            works.push_back([&ways, i] { ways[i](nullptr); });
        }
        const auto ns = study::in_turns_ns(works);
        constexpr double together[]{1, 8, 16, batch_size};
        for (std::size_t i = 0; i < ways.size(); ++i) {
            int differ = 0;
            for (std::size_t ray = 0; ray < found[0].size(); ++ray)
                differ += found[i][ray].t != found[0][ray].t ||
                          found[i][ray].number != found[0][ray].number;
            report.add({"search", variant, together[i], "rays together",
                        static_cast<double>(differ), "rays that find another hit",
                        ns[i] / static_cast<double>(count(rays)), "time per ray / ns"});
        }
    };
    rows("camera rays", recorded.camera);
    rows("bounced rays", recorded.bounced);
}

// A copy of the tree in which no ray meets the box of a leaf.
WideTree without_leaves(WideTree tree) {
    for (WideNode<float>& node : tree.nodes)
        for (std::size_t child = 0; child < lanes; ++child)
            if (node.child[child].is_leaf())
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    node.planes[0][axis][child] = std::numeric_limits<float>::infinity();
                    node.planes[1][axis][child] = -std::numeric_limits<float>::infinity();
                }
    return tree;
}

// How much time each part of the work takes. Each of four searches does less than the one before
// it, and the differences between their times are the times of three parts of a search: the first
// is a whole search, the second knows in advance where its rays end, the third tests only boxes,
// and in the fourth all rays end before they begin, so that its own time is that of making the rays
// ready.
void study_parts(study::Report& report, const StudyScene& scene, const Recorded& recorded) {
    const WideTree &tree = scene.ready.world, boxes = without_leaves(tree);
    Rays rays = recorded.camera;
    rays.insert(rays.end(), recorded.bounced.begin(), recorded.bounced.end());
    Found found;
    search_singly(tree, rays, &found);
    const auto known = [&](std::size_t i) { return found[i].t; };
    const auto nowhere = [](std::size_t) { return Real(-1); };
    const auto singly = [&](const WideTree& in, const auto& end) {
        std::size_t number = 0;
        for (const auto& batch : rays)
            for (const Ray& ray : batch) study::keep(in.search(ray, {0, end(number++)}));
    };
    Batches all{tree, rays}, box_tests{boxes, rays};
    Image image = Canvas<Color>{study_width, study_height};
    BatchRenderer<scene_effects> renderer{scene.ready, study_quality};
    std::uint64_t drawn = 0;
    Rng random{10, 2};
    std::vector<std::uint8_t> kinds;  // as masks
    while (kinds.size() < batch_size)
        kinds.push_back(static_cast<std::uint8_t>(1u << random() % 4));
    std::vector<std::uint32_t> list(batch_size), sorted(2 * batch_size);
    std::iota(list.begin(), list.end(), 0u);
    const auto rays_count = static_cast<double>(found.size());
    auto ns = study::in_turns_ns(
        {[&] { drawn = draw_singly(scene, image); }, [&] { singly(tree, far_away); },
         [&] { singly(tree, known); }, [&] { singly(boxes, known); },
         [&] { singly(boxes, nowhere); }, [&] { drawn = draw_in_batches(renderer, image); },
         [&] { all.search(far_away); }, [&] { all.search(known); },
         [&] { box_tests.search(known); }, [&] { box_tests.search(nowhere); },
         [&] {
             for (std::size_t i = 0; i < found.size(); i += batch_size)
                 study::keep(sort_by_kind<4>(list, kinds.data(), sorted.data()));
         },
         [&] {
             for (std::size_t i = 0; i < found.size(); ++i)
                 study::keep(random.uniform() + random.uniform());
         }});
    for (std::size_t i = 0; i < ns.size(); ++i)
        ns[i] /= i % 5 == 0 && i < 10 ? static_cast<double>(drawn) : rays_count;
    const double sort = ns[10], draws = ns[11];
    for (const bool batch : {false, true}) {
        const double* const of = &ns[batch ? 5 : 0];
        const double sorting = batch ? sort : 0;
        const std::array<double, 7> parts{of[4],
                                          of[3] - of[4],
                                          of[2] - of[3],
                                          of[1] - of[2],
                                          sorting,
                                          draws,
                                          of[0] - of[1] - sorting - draws};
        for (std::size_t i = 0; i < parts.size(); ++i)
            report.add({"parts", batch ? "batches" : "single rays", static_cast<double>(i + 1),
                        "1 make ready, 2 boxes, 3 leaves, 4 until the end is known, 5 sort, "
                        "6 random numbers, 7 the rest",
                        0, "", parts[i], "time per ray / ns"});
    }
}

void study_batch_size(study::Report& report, const StudyScene& scene) {
    Image image = Canvas<Color>{study_width, study_height};
    std::vector<BatchRenderer<scene_effects>> renderers;
    std::vector<std::size_t> sizes;
    for (std::size_t size = 16; size <= 16384; size *= size < 1024 ? 4 : 2) sizes.push_back(size);
    for (const std::size_t size : sizes) renderers.emplace_back(scene.ready, study_quality, size);
    std::uint64_t rays = 1;
    std::vector<study::Work> works;
    for (auto& renderer : renderers)
        works.push_back([&] { rays = draw_in_batches(renderer, image); });
    const auto ns = study::in_turns_ns(works);
    for (std::size_t i = 0; i < ns.size(); ++i)
        report.add({"batch-size", "batches", static_cast<double>(sizes[i]), "paths in a batch", 0,
                    "", ns[i] / static_cast<double>(rays), "time per ray / ns"});
}

// Draws the picture path by path and in batches, with ever more and ever smaller spheres.
void study_growth(study::Report& report) {
    for (int spheres = 100; spheres <= 1'000'000; spheres *= 10) {
        const StudyScene scene{spheres};
        BatchRenderer<scene_effects> renderer{scene.ready, study_quality};
        Image image = Canvas<Color>{study_width, study_height};
        std::uint64_t rays = 1;
        const auto ns = study::in_turns_ns({[&] { rays = draw_singly(scene, image); },
                                            [&] { rays = draw_in_batches(renderer, image); }});
        for (const bool batch : {false, true})
            report.add({"growth", batch ? "batches" : "single rays", static_cast<double>(spheres),
                        "spheres", 0, "", ns[batch] / static_cast<double>(rays),
                        "time per ray / ns"});
    }
}

void study_lanes(study::Report& report) {
    std::vector<Width> widths;
    for (auto& width :
         {registers_of_16_bytes(), registers_of_32_bytes(), registers_of_this_program()})
        if (widths.empty() || widths.back().lanes != width.lanes) widths.push_back(width);
    std::uint64_t rays = 1;
    std::vector<study::Work> works;
    for (const Width& width : widths) {
        works.push_back([&] { rays = width.singly(); });
        works.push_back([&] { rays = width.in_batches(); });
    }
    const auto ns = study::in_turns_ns(works);
    for (std::size_t i = 0; i < ns.size(); ++i)
        report.add({"lanes", i % 2 ? "batches" : "single rays",
                    static_cast<double>(widths[i / 2].lanes), "numbers in a register", 0, "",
                    ns[i] / static_cast<double>(rays), "time per ray / ns"});
}

void run_study(study::Report& report) {
    const StudyScene scene{100'000};
    const Recorded recorded = record(scene.ready);
    study_search(report, scene.ready.world, recorded);
    study_parts(report, scene, recorded);
    study_batch_size(report, scene);
    study_growth(report);
    study_lanes(report);
}

}  // namespace

Width registers_of_this_program() {
    return make_width();
}

}  // namespace batches

void (*const app::program_study)(study::Report&) = batches::run_study;
