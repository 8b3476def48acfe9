// The live figures of chapter 07. Their spheres have their centers in the plane z = 0.
#include <array>
#include <numeric>
#include <rt/area_split.hpp>
#include <rt/build.hpp>
#include <rt/find_nearest.hpp>
#include <rt/hit_box.hpp>
#include <rt/rng.hpp>
#include <rt/search.hpp>
#include <rt/slab_ray.hpp>
#include <string>

#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"

namespace live {
namespace {

constexpr std::array<Ink, 6> colors{blue, orange, green, pink, amber, sky};

Ink color_of(std::size_t sphere) {
    return colors[sphere % colors.size()];
}

Frame plane_frame(double width) {
    const double scale = width / 9.4;
    return {{width / 2, 2.06 * scale}, {}, scale};
}

void draw_box(Drawing& out, const Frame& at, const rt::Box& box, Pen pen, double fill) {
    const Point low = at.to_page(in_plane(box.low)), high = at.to_page(in_plane(box.high));
    out.box(low, high, thin(pen.ink, fill));
    out.frame(low, high, pen);
}

std::vector<rt::Box> boxes_of(std::span<const rt::SceneSphere> spheres) {
    std::vector<rt::Box> boxes;
    for (const rt::SceneSphere& sphere : spheres) boxes.push_back(rt::bounds_of(sphere.shape));
    return boxes;
}
std::vector<int> numbers_up_to(std::size_t count) {
    std::vector<int> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

// Adds `count` spheres that touch none of the others, with centers from place() and radii from
// size(). Both are random.
template <class Place, class Size>
void add(std::vector<rt::SceneSphere>& spheres, int count, const Place& place, const Size& size) {
    for (int tries = 0; count > 0 && tries < 5000; ++tries) {
        const rt::Sphere sphere{place(), size()};
        const bool is_free = std::none_of(spheres.begin(), spheres.end(), [&](const auto& other) {
            return distance(in_plane(other.shape.center), in_plane(sphere.center)) <
                   1.1 * (other.shape.radius + sphere.radius);
        });
        if (!is_free) continue;
        spheres.push_back({sphere, 0});
        --count;
    }
}

// ---- A search, test by test ----

struct Test {
    const rt::TreeNode* node = nullptr;  // whose box was tested; none: a sphere
    int sphere = -1;
    bool met = false;
    bool behind = false;   // the ray meets the box, but behind a hit that was found later
    bool nearest = false;  // the nearest hit so far
    double reach = 0;      // the nearest hit before this test
};

// A search that records its tests. find_nearest does the rest.
struct Recorded : rt::Search {
    std::vector<Test> tests = {};

    bool meets_box_of(const rt::TreeNode& node) {
        const auto meets_within = [&](rt::Interval t) {
            const rt::Interval part = rt::hit_box(node.box, slabs, t);
            return part.min <= part.max;
        };
        const bool met = meets_within(within), behind = !met && meets_within({0, rt::infinity});
        tests.push_back({&node, -1, met, behind, false, within.max});
        return met;
    }
    auto children_of(const rt::TreeNode& node) {
        meets_box_of(*node.left);
        meets_box_of(*node.right);
        return rt::Search::children_of(node);
    }
    bool reaches(const rt::MetChild& child) {
        const bool reached = rt::Search::reaches(child);
        if (!reached) tests.push_back({&child.node(), -1, false, true, false, within.max});
        return reached;
    }
    std::optional<rt::Real> meets_shape(int number) {
        const double reach = within.max;
        const auto t = rt::Search::meets_shape(number);
        tests.push_back({nullptr, number, t.has_value(), false, t.has_value(), reach});
        return t;
    }
};

std::vector<rt::SceneSphere> make_crowd() {
    std::vector<rt::SceneSphere> crowd;
    rt::Rng random{11, 7};
    add(
        crowd, 32,
        [&] {
            return rt::Vec3{random.uniform(-3.7, 3.7), random.uniform(-1.7, 1.7), 0};
        },
        [&] {
            const double u = random.uniform();
            return 0.1 + 0.32 * u * u;
        });
    return crowd;
}

// The tree over the crowd.
struct Tree {
    std::vector<rt::SceneSphere> spheres = make_crowd();
    std::vector<int> order = numbers_up_to(spheres.size());
    std::unique_ptr<rt::TreeNode> root;

    explicit Tree(bool by_area) {
        const std::vector<rt::Box> boxes = boxes_of(spheres);
        root = by_area ? rt::build_node(order, 0, boxes, rt::AreaSplit{1})
                       : rt::build_node(order, 0, boxes, rt::split_in_half);
    }
};

int spheres_below(const rt::TreeNode& node) {
    return node.is_leaf() ? node.count : spheres_below(*node.left) + spheres_below(*node.right);
}

constexpr double ray_end = 4.45;

struct RayEnds {
    Point start, tip;
};
RayEnds ray_ends(const SearchControls& c) {
    const double side = c.side > 0 ? -1 : 1;
    return {{-side * ray_end, c.start}, {side * ray_end, c.tip}};
}

// How a test of a box is shown.
Ink ink_of(const Test& test) {
    return test.met ? green : test.behind ? orange : muted;
}

// The tree below the picture: a square for each node, and a dot for each sphere.
class TreeDrawing {
  public:
    TreeDrawing(Drawing& out, const Tree& tree, std::span<const Test> done, double top)
        : out_{out}, tree_{tree}, done_{done}, top_{top} {
        find_depth(*tree.root, 0);
        level_ = std::min(34.0, 150.0 / (depth_ + 1));
        draw_node(*tree.root, 0, false);
    }
    double bottom() const { return sphere_y() + 10; }

  private:
    void find_depth(const rt::TreeNode& node, int level) {
        depth_ = std::max(depth_, level);
        if (node.is_leaf()) return;
        find_depth(*node.left, level + 1);
        find_depth(*node.right, level + 1);
    }
    double sphere_x(double place) const {
        return 10 + (out_.width - 20) * (place + 0.5) / static_cast<double>(tree_.order.size());
    }
    double sphere_y() const { return top_ + level_ * (depth_ + 0.75) + 8; }
    Point place_of(const rt::TreeNode& node, int level) const {
        const rt::TreeNode *first = &node, *last = &node;
        while (!first->is_leaf()) first = first->left.get();
        while (!last->is_leaf()) last = last->right.get();
        return {sphere_x((first->first + last->first + last->count - 1) / 2.0),
                top_ + 8 + level_ * level};
    }
    const Test* test_of(const rt::TreeNode& node) const {
        // The last one: a box that was met may have been skipped later.
        const auto found = std::find_if(done_.rbegin(), done_.rend(),
                                        [&](const Test& test) { return test.node == &node; });
        return found == done_.rend() ? nullptr : &*found;
    }

    void draw_node(const rt::TreeNode& node, int level, bool is_skipped) {
        const Test* const test = test_of(node);
        const Point place = place_of(node, level);
        const double strength = is_skipped ? 0.25 : 1;
        const bool skips = is_skipped || (test && !test->met);
        if (node.is_leaf()) {
            for (int i = node.first; i < node.first + node.count; ++i) {
                const int sphere = tree_.order[static_cast<std::size_t>(i)];
                const Point at{sphere_x(i), sphere_y()};
                const auto tried = std::find_if(done_.begin(), done_.end(), [&](const Test& one) {
                    return one.sphere == sphere;
                });
                const bool is_tried = tried != done_.end();
                out_.line(place, at - Point{0, 6}, {thin(faint, strength), 1.2});
                out_.disc(at, 4.2,
                          thin(color_of(static_cast<std::size_t>(sphere)), skips      ? 0.18
                                                                           : is_tried ? 1
                                                                                      : 0.45));
                if (is_tried && tried->met) out_.circle(at, 6.5, {ink, 1.8});
            }
        } else {
            for (const auto* child : {node.left.get(), node.right.get()}) {
                out_.line(place, place_of(*child, level + 1),
                          {thin(test && test->met ? green : muted, skips ? 0.2 : 0.7), 1.4});
                draw_node(*child, level + 1, skips);
            }
        }
        const bool is_last = !done_.empty() && done_.back().node == &node;
        const Ink color = test ? ink_of(*test) : muted;
        const double half = out_.is_narrow() ? 4 : 6;
        const Point corner{half, half};
        out_.box(place - corner, place + corner, paper);
        out_.box(place - corner, place + corner, thin(color, test ? 0.9 : 0.15 * strength));
        out_.frame(place - corner, place + corner, {thin(color, strength), 1.5});
        if (test && !test->met)
            for (const double side : {-1.0, 1.0})
                out_.line(place + (half / 2) * Point{-1, -side},
                          place + (half / 2) * Point{1, side}, {paper, 1.8});
        if (is_last) out_.circle(place, 11.5, {accent, 2});
    }

    Drawing& out_;
    const Tree& tree_;
    std::span<const Test> done_;
    double top_, level_ = 0;
    int depth_ = 0;
};

void say_step(Drawing& out, const Test& last, std::size_t step, std::size_t count) {
    if (last.node) {
        const int below = spheres_below(*last.node);
        out.say(last.met && last.node->is_leaf()
                    ? "Step {} of {}: the ray meets the box of a leaf. When its turn comes, its "
                      "spheres are tried: {}."
                : last.met    ? "Step {} of {}: the ray meets this box. When its turn comes, the "
                                "boxes of its two children are tested."
                : last.behind ? "Step {} of {}: this box begins behind the nearest hit. What is in "
                                "it is skipped: {} of the spheres."
                              : "Step {} of {}: the ray misses this box. What is in it is skipped: "
                                "{} of the spheres.",
                step, count, below);
    } else {
        out.say(!last.met ? "Step {} of {}: the ray misses this sphere, or hits it only behind the "
                            "nearest hit so far."
                : last.reach < rt::infinity
                    ? "Step {} of {}: a hit, and nearer than the one before. The ray ends here now."
                    : "Step {} of {}: a hit. From now on the ray ends here.",
                step, count);
    }
}

}  // namespace

void draw(const SearchControls& c, Drawing& out) {
    static const std::array trees{Tree{false}, Tree{true}};
    const Tree& tree = trees[c.split > 0 ? 1 : 0];
    const Frame at = plane_frame(out.width);
    const auto [start, tip] = ray_ends(c);
    const rt::Vec3 direction = rt::normalize(rt::Vec3{tip.x - start.x, tip.y - start.y, 0});
    const double length = distance(start, tip);
    Recorded search{
        {tree.spheres, tree.order, {{start.x, start.y, 0}, direction}, {0, rt::infinity}}};
    search.box_tests = 1;
    if (search.meets_box_of(*tree.root)) rt::find_nearest(*tree.root, search);
    const std::size_t count = search.tests.size(),
                      step = std::min(count, static_cast<std::size_t>(c.step));
    const std::span done = std::span{std::as_const(search.tests)}.first(step);

    // The boxes that were tested, the last one on top.
    for (const Test& test : done)
        if (test.node && &test != &done.back())
            draw_box(out, at, test.node->box, {thin(ink_of(test), 0.8), 1.2, test.met ? 0.0 : 4.0},
                     test.met ? 0.05 : 0);
    for (std::size_t i = 0; i < tree.spheres.size(); ++i) {
        const rt::Sphere& sphere = tree.spheres[i].shape;
        const bool is_tried = std::any_of(done.begin(), done.end(), [&](const Test& test) {
            return test.sphere == static_cast<int>(i);
        });
        const Point center = at.to_page(in_plane(sphere.center));
        out.disc(center, at.scale * sphere.radius, thin(color_of(i), is_tried ? 0.95 : 0.35));
        if (is_tried) out.circle(center, at.scale * sphere.radius, {ink, 1.6});
    }
    if (!done.empty() && done.back().node) {
        const Test& last = done.back();
        draw_box(out, at, last.node->box, {ink_of(last), 3, last.met ? 0.0 : 6.0}, 0.12);
    }

    double reach = rt::infinity;
    for (const Test& test : done)
        if (test.nearest)
            reach = *rt::hit_sphere(tree.spheres[static_cast<std::size_t>(test.sphere)].shape,
                                    search.ray, {0, rt::infinity});
    const Point end = reach < length ? start + (reach / length) * (tip - start) : tip;
    out.line(at.to_page(start), at.to_page(tip), {thin(accent, 0.6), 1.5, 3});
    if (reach < length)
        out.line(at.to_page(start), at.to_page(end), {accent, 3});
    else
        out.arrow(at.to_page(start), at.to_page(end), {accent, 3});
    if (reach < length) out.dot(at.to_page(end), accent, 6);
    out.handle(at.to_page(start));
    out.handle(at.to_page(tip));

    const TreeDrawing drawn{out, tree, done, 2 * at.at.y + 6};
    out.height = drawn.bottom() + 4;

    const int spheres = static_cast<int>(tree.spheres.size());
    if (step == 0)
        out.say("The ray has not met anything yet. A list would test all {} spheres.", spheres);
    else if (static_cast<std::size_t>(c.step) > count)
        out.say(
            "Done: {} boxes and {} of the {} spheres were tested. A list would test all of them.",
            search.box_tests, search.shape_tests, spheres);
    else
        say_step(out, done.back(), step, count);
}

void drag(SearchControls& c, const Drag& to) {
    const Frame at = plane_frame(to.width);
    const auto [start, tip] = ray_ends(c);
    const double moved = -to.moved().y / at.scale;
    const bool is_start = distance(at.to_page(start), to.down) < distance(at.to_page(tip), to.down);
    (is_start ? c.start : c.tip) += moved;
}

// ---- A split and its cost ----

namespace {

std::vector<rt::SceneSphere> arrangement(int number) {
    std::vector<rt::SceneSphere> spheres;
    rt::Rng random{5, 7};
    const auto within = [&](double x0, double x1, double y0, double y1) {
        return [&random, x0, x1, y0, y1] {
            return rt::Vec3{random.uniform(x0, x1), random.uniform(y0, y1), 0};
        };
    };
    const auto size = [&](double low, double high) {
        return [&random, low, high] { return random.uniform(low, high); };
    };
    if (number == 0) {  // a crowd, and some on their own
        add(spheres, 15, within(-3.7, -1.9, -1.3, 1.0), size(0.12, 0.24));
        add(spheres, 5, within(0.2, 3.7, -1.6, 1.6), size(0.2, 0.34));
    } else if (number == 1) {  // spread evenly
        add(spheres, 20, within(-3.7, 3.7, -1.6, 1.6), size(0.17, 0.3));
    } else {  // a large one beside small ones
        add(spheres, 1, within(1.9, 1.9, -0.1, -0.1), size(1.6, 1.6));
        add(spheres, 19, within(-3.8, 3.8, -1.7, 1.7), size(0.09, 0.2));
    }
    return spheres;
}

// Splits along one axis: how many spheres are on the left of a plane, and what that costs.
struct Splits {
    std::vector<rt::Box> boxes;
    std::vector<int> order;
    rt::Box whole;
    int axis;
    double boxes_cost;

    Splits(std::span<const rt::SceneSphere> spheres, int along_axis, double cost_of_boxes)
        : boxes{boxes_of(spheres)},
          order{numbers_up_to(spheres.size())},
          axis{along_axis},
          boxes_cost{cost_of_boxes} {
        std::sort(order.begin(), order.end(), [&](int a, int b) { return middle(a) < middle(b); });
        whole = part(0, count());
    }
    int count() const { return static_cast<int>(order.size()); }
    double middle(int sphere) const {
        return rt::along(boxes[static_cast<std::size_t>(sphere)].center(), axis);
    }
    int left_of(double plane) const {
        return static_cast<int>(std::count_if(order.begin(), order.end(),
                                              [&](int sphere) { return middle(sphere) < plane; }));
    }
    // A plane that has this many on its left.
    double plane_after(int left) const {
        const auto k = static_cast<std::size_t>(left);
        return (middle(order[k - 1]) + middle(order[k])) / 2;
    }
    rt::Box part(int from, int to) const {
        rt::Box box;
        for (int i = from; i < to; ++i)
            box =
                rt::join(box, boxes[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])]);
        return box;
    }
    double area_share(int from, int to) const {
        return rt::surface_area(part(from, to)) / rt::surface_area(whole);
    }
    double cost(int left) const {
        // The formula of docs/07-bvh.md; split_by_area finds only the lowest cost.
        if (left == 0 || left == count()) return count();  // no split: a leaf
        return boxes_cost + area_share(0, left) * left +
               area_share(left, count()) * (count() - left);
    }
};

// The number of spheres on the left of the best split; 0 if that is not along this axis.
int best_left(const Splits& splits) {
    std::vector<int> order = numbers_up_to(splits.order.size());
    const int left = rt::split_by_area(order, splits.boxes, splits.boxes_cost);
    std::sort(order.begin(), order.begin() + left);
    std::vector<int> here(splits.order.begin(), splits.order.begin() + left);
    std::sort(here.begin(), here.end());
    return std::equal(here.begin(), here.end(), order.begin()) ? left : 0;
}

struct SplitLayout {
    Frame plane;
    double plot_top, plot_bottom, low, high;  // the plane's positions from the left to the right

    double page_x(double position) const {
        return plane.at.x + 4.3 * plane.scale * position / high;
    }
};

SplitLayout split_layout(const SplitControls& c, double width) {
    const Frame plane = plane_frame(width);
    const double top = 2 * plane.at.y + 24, most = c.axis > 0 ? 2 : 4.3;
    return {plane, top, top + 140, -most, most};
}

Point on_plane(const SplitControls& c, double position) {
    return c.axis > 0 ? Point{4.35, position} : Point{position, -1.78};
}

void draw_costs(const SplitControls& c, const SplitLayout& layout, const Splits& splits,
                Drawing& out) {
    const double most = 1.08 * (splits.count() + splits.boxes_cost - 1);
    const auto place = [&](double position, double cost) {
        return Point{layout.page_x(position),
                     layout.plot_bottom - cost / most * (layout.plot_bottom - layout.plot_top)};
    };
    for (const double cost : {0.0, 5.0, 10.0, 15.0, 20.0}) {
        out.line(place(layout.low, cost), place(layout.high, cost),
                 {cost == splits.count() ? muted : faint, 1, cost == splits.count() ? 4.0 : 0.0});
        const Point mark = place(layout.low, cost);
        out.text({std::max(mark.x - 8, 22.0), mark.y}, "{}", muted, Align::right, cost);
    }
    std::vector<Point> steps{place(layout.low, splits.count())};
    for (int left = 0; left < splits.count(); ++left) {
        const double at = splits.middle(splits.order[static_cast<std::size_t>(left)]);
        steps.push_back(place(at, splits.cost(left)));
        steps.push_back(place(at, splits.cost(left + 1)));
    }
    steps.push_back(place(layout.high, splits.count()));
    out.path(steps, {accent, 2});
    std::vector<Point> below = steps;
    below.push_back(place(layout.high, 0)), below.push_back(place(layout.low, 0));
    out.polygon(below, thin(accent, 0.12));
    out.text_size = 12;
    const auto mark = [&](int left, std::string_view name, Ink color) {
        const Point at = place(splits.plane_after(left), splits.cost(left));
        out.dot(at, color, 5);
        out.text(at + Point{0, 17}, name, color);
    };
    mark(splits.count() / 2, "half", muted);
    if (const int best = best_left(splits)) mark(best, "best", green);
    out.text_size = 13;
    out.text(place(layout.high, splits.count()) + Point{0, -11}, "a leaf", muted, Align::right);
    out.bold = true;
    out.text({10, layout.plot_top - 12}, "Cost of a split, in sphere tests", ink, Align::left);
    out.bold = false;
    const Point now = place(c.plane, splits.cost(splits.left_of(c.plane)));
    out.line(place(c.plane, 0), place(c.plane, most), {accent, 1.5, 4});
    out.handle(now);
    out.dot(now, accent, 5);
}

}  // namespace

void draw(const SplitControls& given, Drawing& out) {
    SplitControls c = given;
    const SplitLayout layout = split_layout(c, out.width);
    c.plane = std::clamp(c.plane, layout.low, layout.high);
    const Frame& at = layout.plane;
    out.height = layout.plot_bottom + 14;
    const auto spheres = arrangement(static_cast<int>(c.scene));
    const Splits splits{spheres, c.axis > 0 ? 1 : 0, c.boxes};
    const int left = splits.left_of(c.plane), count = splits.count();

    draw_box(out, at, splits.whole, {muted, 1.2, 4}, 0.03);
    if (left > 0) draw_box(out, at, splits.part(0, left), {blue, 2.5}, 0.14);
    if (left < count) draw_box(out, at, splits.part(left, count), {orange, 2.5}, 0.14);
    for (int i = 0; i < count; ++i) {
        const rt::Sphere& sphere =
            spheres[static_cast<std::size_t>(splits.order[static_cast<std::size_t>(i)])].shape;
        const Ink color = i < left ? blue : orange;
        out.disc(at.to_page(in_plane(sphere.center)), at.scale * sphere.radius, thin(color, 0.75));
        out.disc(at.to_page(in_plane(sphere.center)), 1.8, paper);
    }
    const auto name_box = [&](const rt::Box& box, double x, double y, std::string_view letter,
                              Ink color) {
        const Point low = at.to_page(in_plane(box.low)), high = at.to_page(in_plane(box.high));
        out.text({x < 0 ? high.x - 12 : low.x + 12, y < 0 ? low.y + 12 : high.y - 11}, letter,
                 color);
    };
    out.bold = true;
    name_box(splits.whole, 1, 1, "A", muted);
    if (left > 0) name_box(splits.part(0, left), 1, -1, "B₁", blue);
    if (left < count) name_box(splits.part(left, count), -1, -1, "B₂", orange);
    out.bold = false;
    const Point grip = on_plane(c, c.plane),
                far = c.axis > 0 ? Point{-4.6, c.plane} : Point{c.plane, -2.0};
    out.line(at.to_page(far), at.to_page(c.axis > 0 ? Point{4.6, c.plane} : Point{c.plane, 2.0}),
             {accent, 3});
    out.handle(at.to_page(grip), 22);
    draw_costs(c, layout, splits, out);

    if (left == 0 || left == count)
        out.say("All {} spheres are on one side: that is no split, and costs {} tests.", count,
                count);
    else
        out.say(
            "{} spheres in {.0} % of the area and {} in {.0} %: {} + {.2} · {} + {.2} · {} = "
            "{.1} tests. A leaf costs {}.",
            left, 100 * splits.area_share(0, left), count - left,
            100 * splits.area_share(left, count), splits.boxes_cost, splits.area_share(0, left),
            left, splits.area_share(left, count), count - left, splits.cost(left), count);
}

void drag(SplitControls& c, const Drag& to) {
    const SplitLayout layout = split_layout(c, to.width);
    const Frame& at = layout.plane;
    c.plane = std::clamp(c.plane, layout.low, layout.high);
    if (to.down.y > layout.plot_top - 10)
        c.plane += to.moved().x / (layout.page_x(1) - layout.page_x(0));
    else
        c.plane += (c.axis > 0 ? -to.moved().y : to.moved().x) / at.scale;
    c.plane = std::clamp(c.plane, layout.low, layout.high);
}

// ---- The slab test ----

namespace {

struct SlabLayout {
    Frame plane;
    double top, left, right;                                 // of the rows with the bars
    static constexpr double row = 44, first = -1, last = 4;  // the number line's ends

    double page_x(double t) const { return left + (right - left) * (t - first) / (last - first); }
};

SlabLayout slab_layout(double width) {
    const double scale = width / 9.4, height = 4.2 * scale;
    return {{{width / 2, height / 2}, {2, 1.4}, scale}, height + 8, 10, width - 10};
}

// The part of an interval in which a ray is in a box, according to hit_box. It is not asked about
// infinity, where a ray beside a slab and parallel to it has both its entry and its exit.
rt::Interval when_inside(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within) {
    constexpr double far = 1000;
    const rt::Interval near{std::max(within.min, -far), std::min(within.max, far)};
    const rt::Interval part = rt::hit_box(box, ray, near);
    if (part.is_empty()) return {rt::infinity, -rt::infinity};
    return {part.min == near.min ? within.min : part.min,
            part.max == near.max ? within.max : part.max};
}

// A bar on the number line, with a point where it goes on beyond the line's end.
void draw_bar(Drawing& out, const SlabLayout& layout, double y, rt::Interval t, Ink color) {
    if (t.is_empty()) return;
    const double from = std::clamp(t.min, layout.first, layout.last),
                 to = std::clamp(t.max, layout.first, layout.last);
    const Point low{layout.page_x(from), y - 6}, high{layout.page_x(to), y + 6};
    out.box(low, high, thin(color, 0.75));
    out.frame(low, high, {color, 1.5});
    for (const double side : {-1.0, 1.0})
        if (side < 0 ? t.min < layout.first : t.max > layout.last) {
            const Point end{side < 0 ? layout.left : layout.right, y};
            out.polygon({end + Point{8 * side, 0}, end + Point{0, 9}, end - Point{0, 9}}, color);
        }
}

}  // namespace

void draw(const SlabControls& c, Drawing& out) {
    const SlabLayout layout = slab_layout(out.width);
    const Frame& at = layout.plane;
    const double bottom = layout.top + 3 * layout.row;
    out.height = bottom + 22;
    const rt::Box box{{1, 1, -1}, {3, 2, 1}};
    const rt::Vec3 origin{c.ox, c.oy, 0}, direction{c.px - c.ox, c.py - c.oy, 0};
    // Without a margin, so that the numbers are those of the box itself.
    const rt::SlabRay ray{origin, {1 / direction.x, 1 / direction.y, 1 / direction.z}};
    const rt::Ray line{origin, direction};
    const double length = rt::length(direction);
    const Point o = at.to_page(in_plane(origin)), p = at.to_page({c.px, c.py});
    const auto in_view = [&](Point q) {
        return q.x > 0 && q.x < out.width && q.y > 0 && q.y < layout.top - 8;
    };

    struct Slab {
        rt::Box box;
        Ink color;
        bool is_parallel, on_plane;
        rt::Interval t = {};
    };
    constexpr double all = rt::infinity;
    std::array slabs{Slab{{{1, -all, -all}, {3, all, all}},
                          blue,
                          direction.x == 0,
                          c.ox == box.low.x || c.ox == box.high.x},
                     Slab{{{-all, 1, -all}, {all, 2, all}},
                          orange,
                          direction.y == 0,
                          c.oy == box.low.y || c.oy == box.high.y}};
    for (Slab& slab : slabs) slab.t = when_inside(slab.box, ray, {-all, all});
    const auto& [x, y] = slabs;
    const rt::Interval both = when_inside(box, ray, {0, all});
    const bool hit = length > 0 && !both.is_empty();

    // The slabs, the box where they cross, and the ray.
    const Point low = at.to_page(in_plane(box.low)), high = at.to_page(in_plane(box.high));
    const double floor = layout.top - 8;
    out.box({low.x, 0}, {high.x, floor}, thin(blue, 0.13));
    out.box({0, high.y}, {out.width, low.y}, thin(orange, 0.13));
    for (const double side : {low.x, high.x}) out.line({side, 0}, {side, floor}, {blue, 1.5});
    for (const double side : {low.y, high.y}) out.line({0, side}, {out.width, side}, {orange, 1.5});
    draw_box(out, at, box, {hit ? green : muted, 3}, hit ? 0.2 : 0.1);
    out.text({high.x + 8, 12}, "slab of x", blue, Align::left);
    out.text({8, high.y + 12}, "slab of y", orange, Align::left);
    Point o_name = o - Point{18, 0}, p_name = p + Point{18, 0};
    if (length > 0) {
        const auto place = [&](double t) { return at.to_page(in_plane(line.at(t))); };
        double end = 1;
        while (in_view(place(end + 0.1 / length))) end += 0.1 / length;
        double before = 0;
        while (in_view(place(before - 0.1 / length))) before -= 0.1 / length;
        out.line(place(before), o, {muted, 1.5, 4});
        out.arrow(o, place(end), {accent, 2.5});
        if (hit) out.line(place(both.min), place(both.max), {green, 6});
        // The t of x on one side of the ray, those of y on the other.
        const Point along = (1 / distance(o, p)) * (p - o), aside{along.y, -along.x};
        p_name = p - 24 * along + 10 * aside;
        o_name = o - 20 * along + 10 * aside;
        const double away = 17 + 8 * std::abs(aside.x);  // words are wide
        for (const Slab& slab : slabs)
            for (const double t : {slab.t.min, slab.t.max}) {
                if (!(std::abs(t) < all) || !in_view(place(t))) continue;
                const Ink color = thin(slab.color, t < 0 ? 0.6 : 1);
                const Point outward = (t == slab.t.min ? -9 : 9) * along;
                out.dot(place(t), color, 4.5);
                out.text(place(t) + outward + (&slab == &x ? away : -away) * aside, "{.2}", color,
                         Align::middle, t);
            }
    }
    out.handle(o);
    out.handle(p);
    out.bold = true;
    out.text(o_name, "O", ink);
    out.text(p_name, "P", ink);
    out.bold = false;

    // The number line.
    for (int t = static_cast<int>(layout.first); t <= layout.last; ++t) {
        out.line({layout.page_x(t), layout.top}, {layout.page_x(t), bottom},
                 {t == 0 ? muted : faint, t == 0 ? 1.5 : 1});
        out.text({layout.page_x(t), bottom + 11}, t == 0 ? "t = 0" : "{}", muted, Align::middle, t);
    }
    if (length == 0) {
        out.say("P is at O: the ray has no direction.");
        return;
    }
    const double latest = std::max({0.0, x.t.min, y.t.min}),
                 earliest = std::min({all, x.t.max, y.t.max});
    for (const double t : {latest, earliest})
        if (t >= layout.first && t <= layout.last)
            out.line({layout.page_x(t), layout.top}, {layout.page_x(t), bottom},
                     {hit ? green : pink, 1.5, 4});
    const auto draw_row = [&](int number, std::string_view some, std::string_view none,
                              rt::Interval t, Ink color) {
        const Point words{layout.left, layout.top + 11 + number * layout.row};
        draw_bar(out, layout, words.y + 18, t, color);
        out.text(words, t.is_empty() ? none : some, color, Align::left, t.min, t.max);
    };
    out.bold = true;
    draw_row(0, "in x from {.2} to {.2}", "in x at no t", x.t, x.color);
    draw_row(1, "in y from {.2} to {.2}", "in y at no t", y.t, y.color);
    draw_row(2, "in the box from {.2} to {.2}", "in the box at no t ≥ 0", both,
             hit ? green : muted);
    out.bold = false;

    // What a parallel slab does, then the answer.
    const Slab& slab = x.is_parallel ? x : y;
    const bool never = slab.t.is_empty();
    std::string said;
    if (slab.is_parallel && slab.on_plane)
        said = never ? "The ray is in a plane: 0 · ∞ is NaN, and the slab is lost. "
                     : "The ray is in a plane: 0 · ∞ is NaN, and this plane does not count. ";
    else if (slab.is_parallel)
        said = slab.box.contains(origin)
                   ? "The ray is parallel to a slab, in it: entry −∞, exit ∞. "
                   : "The ray is beside a slab: its entry and exit are the same infinity. ";
    if (!hit && never)
        out.say(said + "A miss.");
    else if (hit && latest == 0)
        out.say(said + "A hit: O is in the box, and the earliest exit is {.2}.", earliest);
    else if (!hit && earliest < 0 && std::max(x.t.min, y.t.min) <= earliest)
        out.say(said + "A miss: the box is behind O, and the earliest exit is {.2}.", earliest);
    else
        out.say(said + (hit ? "A hit" : "A miss") +
                    ": the latest entry is {.2}, the earliest exit {.2}.",
                latest, earliest);
}

void drag(SlabControls& c, const Drag& to) {
    const Frame at = slab_layout(to.width).plane;
    const std::array places{at.to_page({c.ox, c.oy}), at.to_page({c.px, c.py})};
    const std::size_t moved = nearest_of(places, to.down);
    const Point now = at.to_plane(places[moved] + to.moved());
    // In steps, so that rays along an axis and on a plane are easy to find.
    (moved == 0 ? c.ox : c.px) = std::round(10 * now.x) / 10;
    (moved == 0 ? c.oy : c.py) = std::round(10 * now.y) / 10;
}

}  // namespace live
