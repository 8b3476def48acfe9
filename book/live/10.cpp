// The live figures of chapter 10. Their spheres have their centers in the plane z = 0.
#include <array>
#include <numeric>
#include <rt/descend.hpp>
#include <rt/hit_pack.hpp>
#include <rt/rng.hpp>
#include <rt/wide_builder.hpp>
#include <rt/wide_tree.hpp>

#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"

namespace live {
namespace {

constexpr std::array<Ink, 6> colors{blue, orange, green, pink, amber, sky};

Ink color_of(std::uint32_t ray) {
    return colors[ray % colors.size()];
}

std::vector<rt::SceneSphere> make_crowd() {
    std::vector<rt::SceneSphere> crowd;
    rt::Rng random{3, 10};
    while (crowd.size() < 120) {
        const double u = random.uniform();
        const rt::Sphere sphere{{random.uniform(-2.9, 4.5), random.uniform(-1.65, 1.65), 0},
                                0.05 + 0.13 * u * u};
        const bool is_free = std::none_of(crowd.begin(), crowd.end(), [&](const auto& other) {
            return distance(in_plane(other.shape.center), in_plane(sphere.center)) <
                   1.05 * (other.shape.radius + sphere.radius);
        });
        if (is_free) crowd.push_back({sphere, 0});
    }
    return crowd;
}

struct Scene {
    std::vector<rt::SceneSphere> spheres = make_crowd();
    rt::WideTree tree = rt::make_wide_tree(spheres);
};
const Scene& scene() {
    static const Scene made;
    return made;
}

// ---- A search with lists, recorded ----

// A list that filter_list made of another one.
struct Filtered {
    std::vector<std::uint32_t> from;
    std::vector<bool> marked;  // of `from`
    std::vector<std::uint32_t> list;
    int node = -1;  // whose child's box was tested; -1: rays of one octant
    unsigned place = 0;
    int leaf = -1;          // the child, if it is a leaf
    std::vector<double> t;  // where each ray ends, after this step
};

// The functions that descend() calls: those of BatchSearch, but lists of a few rays go on, and each
// list is recorded.
class Recorder {
  public:
    std::vector<Filtered> steps;

    explicit Recorder(std::span<rt::PathRecord> paths)
        : paths_{paths}, lists_(64 * paths.size()), masks_(64 * paths.size()) {
        const auto& nodes = scene().tree.nodes;
        at_node_.resize(nodes.size());
        for (const rt::PathRecord& path : paths)
            wide_.push_back(rt::wide_ray<float>({path.origin, path.direction}));
        std::vector<std::uint32_t> all(paths.size());
        std::iota(all.begin(), all.end(), 0u);
        std::vector<std::uint8_t> octants;
        for (const rt::PathRecord& path : paths)
            octants.push_back(static_cast<std::uint8_t>(
                1 << (std::signbit(path.direction.x) + 2 * std::signbit(path.direction.y))));
        for (octant_ = 0; octant_ < 4; ++octant_) {
            const std::size_t count = rt::filter_list(all, octants.data(), octant_, lists_.data());
            if (count == 0) continue;
            record({all, octants}, octant_, {lists_.data(), count});
            rt::descend(*this, 0, {lists_.data(), count}, {lists_.data() + count, masks_.data()});
        }
    }

    unsigned test(std::int32_t number, rt::PathList list, std::uint8_t* masks) {
        const auto node = static_cast<std::size_t>(number);
        if (node != 0) record_child(list);
        unsigned any = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const rt::WideRay<float>& ray = wide_[list[i]];
            const auto end = static_cast<float>(paths_[list[i]].t * ray.scale);
            const unsigned met = rt::hit_boxes(scene().tree.nodes[node], ray, 0.0F, end).met;
            masks[i] = static_cast<std::uint8_t>(met);
            any |= met;
        }
        at_node_[node] = {{list.begin(), list.end()}, {masks, masks + list.size()}};
        return any;
    }
    std::array<std::uint8_t, rt::lanes> order(std::int32_t number) const {
        const auto& planes = scene().tree.nodes[static_cast<std::size_t>(number)].planes;
        std::array<std::uint8_t, rt::lanes> order;
        std::iota(order.begin(), order.end(), std::uint8_t{0});
        const auto along = [&](std::uint8_t i) {
            float sum = 0;
            for (const std::size_t axis : {0u, 1u}) {
                const float middle = planes[0][axis][i] + planes[1][axis][i];
                sum += octant_ >> axis & 1 ? -middle : middle;
            }
            return sum == sum ? sum : std::numeric_limits<float>::infinity();  // no box
        };
        std::sort(order.begin(), order.end(),
                  [&](std::uint8_t a, std::uint8_t b) { return along(a) < along(b); });
        return order;
    }
    rt::WideChild child(std::int32_t node, unsigned place) {
        parent_ = node, place_ = place;
        return scene().tree.nodes[static_cast<std::size_t>(node)].child[place];
    }
    void leaf(std::int32_t number, rt::PathList list) {
        record_child(list);
        const rt::SphereLeaf& spheres = scene().tree.leaves[static_cast<std::size_t>(number)];
        for (std::size_t first = 0; first < list.size(); first += rt::pack_size) {
            const rt::PathPack pack{list.subspan(first)};
            rt::RayPack rays = rt::load_rays(paths_.data(), pack);
            for (std::size_t i = 0; i < rt::lanes && spheres.is_used(i); ++i)
                rt::hit_pack(spheres.sphere(i), spheres.number[i], rays);
            for (std::size_t i = 0; i < pack.size; ++i) paths_[pack[i]].t = rays.t[i];
        }
        steps.back().leaf = number;
        steps.back().t = ends();
    }

  private:
    struct Masked {
        std::vector<std::uint32_t> list;
        std::vector<std::uint8_t> masks;
    };

    std::vector<double> ends() const {
        std::vector<double> all;
        for (const rt::PathRecord& path : paths_) all.push_back(path.t);
        return all;
    }
    void record(const Masked& from, unsigned bit, rt::PathList list) {
        Filtered step;
        step.from = from.list;
        for (const std::uint8_t mask : from.masks) step.marked.push_back(mask >> bit & 1);
        step.list.assign(list.begin(), list.end());
        step.t = ends();
        steps.push_back(step);
    }
    void record_child(rt::PathList list) {
        record(at_node_[static_cast<std::size_t>(parent_)], place_, list);
        steps.back().node = parent_, steps.back().place = place_;
    }

    std::span<rt::PathRecord> paths_;
    std::vector<rt::WideRay<float>> wide_;
    std::vector<std::uint32_t> lists_;
    std::vector<std::uint8_t> masks_;
    std::vector<Masked> at_node_;
    std::int32_t parent_ = 0;
    unsigned octant_ = 0, place_ = 0;
};

rt::Ray camera_ray(const LanesControls& c, double across) {
    return {{-4.5, c.height, 0}, rt::normalize({1, 0.5 * (across - 0.5) - 0.12 * c.height, 0})};
}

std::vector<rt::PathRecord> rays_of(const LanesControls& c) {
    const int count = static_cast<int>(c.count);
    std::vector<rt::Ray> rays;
    if (c.kind == 0) {
        for (int i = 0; i < count; ++i) rays.push_back(camera_ray(c, (i + 0.5) / count));
    } else {
        // Those that hit something leave it in any direction.
        rt::Rng random{1, 10};
        for (int i = 0; static_cast<int>(rays.size()) < count; ++i) {
            const rt::Ray ray = camera_ray(c, random.uniform());
            const auto hit = scene().tree.hit(ray, {0, rt::infinity});
            if (!hit && i < 1000) continue;
            const rt::Vec3 normal = hit ? hit->normal : -ray.direction;
            const double sine = random.uniform(-1, 1), cosine = std::sqrt(1 - sine * sine);
            const rt::Vec3 start = hit ? hit->point : ray.origin;
            rays.push_back({start + 0.004 * normal,
                            cosine * normal + sine * rt::Vec3{-normal.y, normal.x, 0}});
        }
    }
    std::vector<rt::PathRecord> paths(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        paths[i].origin = rays[i].origin, paths[i].direction = rays[i].direction;
    return paths;
}

// ---- Drawn ----

Frame lanes_frame(double width) {
    const double scale = width / 9.4;
    return {{width / 2, 1.85 * scale}, {}, scale};
}

void draw_box(Drawing& out, const Frame& at, const Filtered& step) {
    if (step.node < 0) return;
    const auto& planes = scene().tree.nodes[static_cast<std::size_t>(step.node)].planes;
    const auto corner = [&](std::size_t side) {
        return at.to_page({planes[side][0][step.place], planes[side][1][step.place]});
    };
    out.box(corner(0), corner(1), thin(accent, 0.1));
    out.frame(corner(0), corner(1), {accent, 2});
}

// Where a ray leaves the picture.
double leaves(const rt::PathRecord& path) {
    const double right = path.direction.x > 0 ? 4.7 : -4.7,
                 up = path.direction.y > 0 ? 1.83 : -1.83;
    return std::min((right - path.origin.x) / path.direction.x,
                    (up - path.origin.y) / path.direction.y);
}

void draw_rays(Drawing& out, const Frame& at, std::span<const rt::PathRecord> paths,
               const Filtered& step) {
    const auto is_in = [](std::span<const std::uint32_t> list, std::uint32_t ray) {
        return std::find(list.begin(), list.end(), ray) != list.end();
    };
    for (std::uint32_t ray = 0; ray < paths.size(); ++ray) {
        const rt::PathRecord& path = paths[ray];
        const bool goes_on = is_in(step.list, ray);
        const double t = step.t[ray], shown = std::min(t, leaves(path));
        const Point from = at.to_page(in_plane(path.origin)),
                    to = at.to_page(in_plane(path.origin + shown * path.direction));
        const Ink color = goes_on ? color_of(ray) : thin(color_of(ray), 0.3);
        out.line(from, to, {color, goes_on ? 2.2 : 1.0});
        if (t < rt::infinity) out.dot(to, color_of(ray), goes_on ? 3.5 : 2.2);
    }
}

// Cells in rows of 16.
struct Cells {
    double left, top, side;

    Point at(std::size_t i) const {
        return {left + side * static_cast<double>(i % 16),
                top + (side + 4) * static_cast<double>(i / 16)};
    }
    Point middle(std::size_t i) const { return at(i) + Point{side / 2, side / 2}; }
    double bottom(std::size_t count) const { return at(count - 1).y + side; }
};

void draw_cell(Drawing& out, const Cells& cells, std::size_t i, std::uint32_t ray, bool works) {
    const Point corner = cells.at(i) + Point{1, 1},
                opposite = cells.at(i) + Point{cells.side - 1, cells.side - 1};
    if (works) out.box(corner, opposite, thin(color_of(ray), 0.25));
    out.frame(corner, opposite, {works ? color_of(ray) : faint, 1.4});
    out.text(cells.middle(i), "{}", works ? ink : muted, Align::middle, ray);
}

void draw_idle(Drawing& out, Point corner, Point opposite) {
    out.frame(corner, opposite, {faint, 1});
    out.line({corner.x, opposite.y}, {opposite.x, corner.y}, {faint, 1});
}

}  // namespace

void draw(const LanesControls& c, Drawing& out) {
    const Frame at = lanes_frame(out.width);
    const std::vector<rt::PathRecord> paths = rays_of(c);
    std::vector<rt::PathRecord> searched = paths;
    const std::vector<Filtered> steps = Recorder{searched}.steps;
    const std::size_t count = steps.size(),
                      step = std::min(count, static_cast<std::size_t>(c.step)),
                      lanes = std::size_t{4} << static_cast<int>(c.lanes);
    Filtered begin;  // before the first step: all rays
    for (std::uint32_t ray = 0; ray < paths.size(); ++ray) begin.list.push_back(ray);
    begin.t.assign(paths.size(), rt::infinity);
    const Filtered& now = step > 0 ? steps[step - 1] : begin;

    draw_box(out, at, now);
    for (std::size_t i = 0; i < scene().spheres.size(); ++i) {
        const rt::Sphere& sphere = scene().spheres[i].shape;
        bool is_tested = false;
        if (now.leaf >= 0) {
            const auto& leaf = scene().tree.leaves[static_cast<std::size_t>(now.leaf)];
            for (std::size_t k = 0; k < rt::lanes; ++k)
                is_tested |= leaf.is_used(k) && leaf.number[k] == static_cast<int>(i);
        }
        const Point center = at.to_page(in_plane(sphere.center));
        out.disc(center, at.scale * sphere.radius, thin(gray, is_tested ? 0.9 : 0.35));
        if (is_tested) out.circle(center, at.scale * sphere.radius, {ink, 1.4});
    }
    draw_rays(out, at, paths, now);
    if (c.kind == 0)
        out.handle(at.to_page({-4.5, c.height}));
    else
        out.handle_everywhere();

    // The list at the node, and what its filter makes of it.
    const double side = std::min(30.0, (out.width - 4) / 16);
    out.text_size = side < 24 ? 11 : 13;
    const bool is_leaf = now.leaf >= 0;
    const Cells before{2, 2 * at.at.y + 30, side};
    out.text({2, before.top - 12},
             now.node < 0 ? "all rays; marked: those of one octant"
                          : "list at the node; marked: rays that met the box",
             muted, Align::left);
    for (std::size_t i = 0; i < now.from.size(); ++i)
        draw_cell(out, before, i, now.from[i], now.marked[i]);
    const std::size_t rows = (paths.size() + 15) / 16;
    const Cells after{2, before.bottom(16 * rows) + 34, side};
    std::size_t place = 0;
    for (std::size_t i = 0; i < now.from.size(); ++i) {
        if (!now.marked[i]) continue;
        out.line(before.middle(i) + Point{0, side / 2}, after.middle(place++) - Point{0, side / 2},
                 {thin(color_of(now.from[i]), 0.8), 1.2});
    }
    out.text({2, after.bottom(16 * rows) + 12},
             is_leaf ? "the leaf’s list, in packs" : "the list that goes on", muted, Align::left);
    for (std::size_t i = 0; i < now.list.size(); ++i) draw_cell(out, after, i, now.list[i], true);
    if (is_leaf)
        for (std::size_t i = now.list.size(); i % lanes != 0; ++i)
            draw_idle(out, after.at(i) + Point{1, 1}, after.at(i) + Point{side - 1, side - 1});
    out.text_size = 13;

    // The packs of all leaves so far, each an upright bar of lanes.
    const double top = after.bottom(16 * rows) + 52;
    const double lane = lanes == 16 ? 4 : lanes == 8 ? 6 : 10;
    std::size_t packs = 0, working = 0, all_packs = 0;
    for (const Filtered& one : steps)
        if (one.leaf >= 0) all_packs += (one.list.size() + lanes - 1) / lanes;
    const double wide =
        std::min(18.0, out.width / static_cast<double>(std::max<std::size_t>(1, all_packs)));
    for (std::size_t i = 0; i < step; ++i) {
        if (steps[i].leaf < 0) continue;
        working += steps[i].list.size();
        for (std::size_t first = 0; first < steps[i].list.size(); first += lanes) {
            const double x = wide * static_cast<double>(packs++);
            for (std::size_t k = 0; k < lanes; ++k) {
                const double y = top + lane * static_cast<double>(lanes - k);
                const Point corner{x + 1, y - 1}, opposite{x + wide - 1, y - lane};
                if (first + k < steps[i].list.size())
                    out.box(corner, opposite, color_of(steps[i].list[first + k]));
                else
                    out.box(corner, opposite, faint);
            }
        }
    }
    out.text({2, top - 12}, "packs of {} lanes in the leaves so far", muted, Align::left, lanes);
    out.height = top + lane * static_cast<double>(lanes) + 6;

    const auto percent = 100.0 * static_cast<double>(working) /
                         static_cast<double>(std::max<std::size_t>(1, packs * lanes));
    if (step == 0)
        out.say("A batch of {} rays. The first step makes a list of those that go the same way.",
                paths.size());
    else if (static_cast<std::size_t>(c.step) > count)
        out.say("Done: {} packs in leaves, and {} of their {} lanes worked: {.0} %.", packs,
                working, packs * lanes, percent);
    else if (now.node < 0)
        out.say("Step {} of {}: rays of this octant: {} of {}. Their list begins at the root.",
                step, count, now.list.size(), now.from.size());
    else if (!is_leaf)
        out.say(
            "Step {} of {}: rays that met this box when its node was tested: {} of {}. Their list "
            "goes on to its node.",
            step, count, now.list.size(), now.from.size());
    else
        out.say(
            "Step {} of {}: rays that met this leaf’s box: {} of {}. Packs so far: {}; {.0} % of "
            "their lanes worked.",
            step, count, now.list.size(), now.from.size(), packs, percent);
}

void drag(LanesControls& c, const Drag& to) {
    if (c.kind == 0)
        c.height -= to.moved().y / lanes_frame(to.width).scale;
    else
        c.step += 40 * to.moved().x / to.width;
}

}  // namespace live
