#include <algorithm>
#include <cstdlib>
#include <functional>
#include <new>
#include <numeric>
#include <rt/compiler.hpp>
#include <rt/shape_tree.hpp>

#include "scenes.hpp"
#include "tree_checks.hpp"

using namespace checkpoint;

// Counts the memory that is taken from the heap.
namespace {
std::size_t allocations = 0, allocated_bytes = 0;
}
RT_NOT_INLINED void* operator new(std::size_t size) {
    ++allocations;
    allocated_bytes += size;
    if (void* const memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc{};
}
RT_NOT_INLINED void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return std::malloc(size ? size : 1);
}
RT_NOT_INLINED void operator delete(void* memory) noexcept {
    std::free(memory);
}
RT_NOT_INLINED void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

std::vector<int> numbers(std::size_t count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    return order;
}

std::vector<Box> boxes_at(const std::vector<Vec3>& middles) {
    std::vector<Box> boxes;
    for (const Vec3 m : middles) boxes.push_back({m - Vec3{1, 1, 1}, m + Vec3{1, 1, 1}});
    return boxes;
}

// What a learner sees if the program crashes in one of these two.
int split_in_half(std::span<int> order, const std::vector<Box>& boxes) {
    INFO(IF_IT_CRASHES
         "a and b of the lambda are already IDs of spheres, so write boxes[a] and not "
         "boxes[order[a]]; and compare with <, never with <= or a difference");
    return rt::split_in_half(order, boxes);
}

std::unique_ptr<rt::TreeNode> tree_of(std::vector<int>& order, const std::vector<Box>& boxes) {
    INFO(IF_IT_CRASHES
         "does split_in_half pass? If so: pass on all of boxes, but only a part of the order; and "
         "a leaf has no children to build");
    return rt::build_node(std::span{order}, 0, std::span{boxes}, rt::split_in_half);
}

std::vector<int> first_sorted(std::span<const int> order, std::size_t count) {
    std::vector<int> first(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    std::sort(first.begin(), first.end());
    return first;
}

const std::string ascending = "ascending";

// How the numbers are ordered along the axis along which their centers lie farthest apart. Centers
// may be rounded in more than one way: if they differ only by that, they count as equal.
std::string order_of_middles(std::span<const int> order, const std::vector<Box>& boxes) {
    Box middles;
    Real largest = 0;
    for (const int number : order) {
        const Box& box = boxes[static_cast<std::size_t>(number)];
        middles = rt::join(middles, {box.center(), box.center()});
        largest = std::max({largest, max_component(box.low), max_component(box.high)});
    }
    const Real rounding = 2 * rt::epsilon * largest, longest = max_component(middles.size());
    const char* const along_axis[]{"along x", "along y", "along z"};
    std::string wrong;
    for (int axis = 0; axis < 3; ++axis) {
        if (rt::along(middles.size(), axis) < longest - 2 * rounding) continue;
        const auto middle = [&](int number) {
            return rt::along(boxes[static_cast<std::size_t>(number)].center(), axis);
        };
        const auto before = [&](int a, int b) { return middle(a) < middle(b) - rounding; };
        const auto out = std::is_sorted_until(order.begin(), order.end(), before);
        if (out == order.end()) return ascending;
        wrong = along_axis[axis] + (" a center at " + text(middle(*(out - 1)))) +
                " comes before one at " + text(middle(*out));
    }
    return wrong;
}

// Walks down a learner's tree and builds it again beside it, on a list of its own. A split returns
// the same result for the same part.
template <class Split>
void follow(const rt::TreeNode& node, std::span<int> order, int first,
            const std::vector<Box>& boxes, const Split& split, int level) {
    Box around;
    for (const int number : order)
        around = rt::join(around, boxes[static_cast<std::size_t>(number)]);
    const int left =
        level < rt::most_levels ? split(order, boxes) : rt::split_in_half(order, boxes);
    const std::string where = "a node at level " + std::to_string(level) + " over " +
                              std::to_string(order.size()) + " IDs from index " +
                              std::to_string(first) + " on, " + std::to_string(left) +
                              " of them to the left";
    if (!(node.box == around)) {
        INFO(where);
        INFO("Hint: "
             << (level > rt::most_levels
                     ? "check which part of the order you pass on. From level most_levels on, call "
                       "split_in_half; each child is one level deeper than its parent"
                     : "join boxes[id] for the IDs in order, and no others"));
        REQUIRE(checkpoint::text(node.box) == checkpoint::text(around));
    }
    const char* const expected = left == 0 ? "a leaf" : "a node with two children";
    const char* const actual = node.left && node.right   ? "a node with two children"
                               : node.left || node.right ? "a node with one child"
                                                         : "a leaf";
    if (std::string{expected} != actual) {
        INFO(where);
        INFO(
            "Hint: call split for each part, or split_in_half at level most_levels and deeper: "
            "only a result of 0 makes a leaf. Both children are one level deeper");
        REQUIRE(std::string{actual} == expected);
    }
    if (left == 0) {
        INFO(where);
        INFO(
            "Hint: a leaf's count is order.size(), and its member first is the argument first of "
            "build_node. The right part begins where the left one ends, at first + left");
        REQUIRE(node.first == first);
        REQUIRE(node.count == static_cast<int>(order.size()));
        return;
    }
    const auto cut = static_cast<std::size_t>(left);
    follow(*node.left, order.first(cut), first, boxes, split, level + 1);
    follow(*node.right, order.subspan(cut), first + left, boxes, split, level + 1);
}

int largest_leaf(const rt::TreeNode& node) {
    if (node.is_leaf()) return node.count;
    return std::max(largest_leaf(*node.left), largest_leaf(*node.right));
}

}  // namespace

TEST_CASE("07.3 up to leaf_size spheres stay together in one leaf", "[07.3]") {
    for (int count = 1; count <= 12; ++count) {
        const auto boxes = boxes_at(std::vector<Vec3>(static_cast<std::size_t>(count)));
        auto order = numbers(boxes.size());
        const int left = split_in_half(order, boxes);
        INFO(count << " spheres in one place");
        INFO(
            "Hint: up to leaf_size spheres stay together: return 0. If there are more, half go to "
            "the left, wherever they are");
        CHECK(left == (count <= rt::leaf_size ? 0 : count / 2));
    }
}

TEST_CASE("07.3 half of the spheres go to the left", "[07.3]") {
    for (const int axis : {0, 1, 2}) {
        rt::Rng rng{73, static_cast<std::uint64_t>(axis)};
        std::vector<Vec3> middles;
        for (int i = 0; i < 41; ++i) {
            Vec3 m = in_cube(rng);
            (axis == 0 ? m.x : axis == 1 ? m.y : m.z) *= 8;
            middles.push_back(m);
        }
        const auto boxes = boxes_at(middles);
        auto order = numbers(boxes.size());
        const int left = split_in_half(order, boxes);
        INFO("41 spheres, farthest apart along axis "
             << axis << "; IDs that your split puts to the left: " << left);
        REQUIRE(left == 20);
        CHECK(from_smallest(order) == numbers(41));
        INFO("along this axis, the centers must be in ascending order");
        CHECK(order_of_middles(order, boxes) == ascending);
    }
}

// At all scales and far from the origin, with other boxes in between. Often one axis is hardly
// longer than the next, and often most of the centers are close together.
TEST_CASE("07.3 spheres are sorted along the axis on which their centers extend farthest",
          "[07.3][hard]") {
    rt::Rng rng{73, 9};
    for (int i = 0; i < 1500; ++i) {
        const Real size = any_size(rng, -15, 15);
        const Vec3 origin =
            size * any_size(rng, 0, for_this_precision(Real(3), Real(10))) * in_cube(rng);
        Vec3 spread = abs(in_cube(rng)) + Vec3{1, 1, 1} * Real(i % 2);
        const bool crowded[3] = {rng() % 2 == 0, rng() % 2 == 0, rng() % 2 == 0};
        const auto crowd = [&](Real x, int axis) { return crowded[axis] ? x * x * x * x * x : x; };
        std::vector<Box> boxes;
        std::vector<int> order;
        const unsigned others = rng() % 3;
        for (int count = 5 + static_cast<int>(rng() % 40); count > 0;) {
            if (rng() % 3 < others) {
                boxes.push_back({origin - size * abs(in_cube(rng)) * 50, origin});
                continue;
            }
            const Vec3 p = in_cube(rng), half = size * any_size(rng, -2, 1) * abs(in_cube(rng));
            const Vec3 m =
                origin + size * spread * Vec3{crowd(p.x, 0), crowd(p.y, 1), crowd(p.z, 2)};
            order.push_back(static_cast<int>(boxes.size()));
            boxes.push_back({m - half, m + half});
            --count;
        }
        for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[rng() % k]);
        auto sorted = order;
        const int left = split_in_half(sorted, boxes);
        const bool right = left == static_cast<int>(order.size()) / 2 &&
                           order_of_middles(sorted, boxes) == ascending &&
                           std::is_permutation(sorted.begin(), sorted.end(), order.begin());
        if (right) {
            CHECK(right);
            continue;
        }
        INFO(order.size() << " IDs of " << boxes.size() << " boxes, whose size is about "
                          << checkpoint::text(size) << ", around " << checkpoint::text(origin));
        REQUIRE(left == static_cast<int>(order.size()) / 2);
        REQUIRE(from_smallest(sorted) == from_smallest(order));
        INFO(
            "Hint: only the IDs in order count. Join their centers, take the longest axis of "
            "the result, and sort all of them by the same centers along this axis");
        REQUIRE(order_of_middles(sorted, boxes) == ascending);
    }
}

TEST_CASE("07.3 spheres are sorted by the centers of their boxes", "[07.3]") {
    // The corners are far apart along x, but all centers are at x = 0; they are apart along y.
    std::vector<Box> boxes;
    for (int i = 0; i < 8; ++i) {
        const Real y = static_cast<Real>((i * 5) % 8) * 3;
        const Real wide = static_cast<Real>(40 + 10 * i);
        boxes.push_back({{-wide, y, 0}, {wide, y + 1, 1}});
    }
    auto order = numbers(8);
    REQUIRE(split_in_half(order, boxes) == 4);
    {
        INFO("the boxes are longest along x, but all their centers have the same x: sort along y");
        CHECK(first_sorted(order, 4) == std::vector<int>{0, 2, 5, 7});
    }
    // All are apart along x, but every second one is so wide that its corners are out of order.
    boxes.clear();
    for (int i = 0; i < 8; ++i) {
        const Real x = static_cast<Real>(3 * i), wide = i % 2 == 0 ? Real(1) : Real(100);
        boxes.push_back({{x - wide, 0, 0}, {x + wide, 1, 1}});
    }
    order = {7, 2, 5, 0, 3, 6, 1, 4};
    REQUIRE(split_in_half(order, boxes) == 4);
    INFO("the centers are at x = 0, 3, 6 ... 21: sort by box.center(), not by a corner");
    CHECK(first_sorted(order, 4) == std::vector<int>{0, 1, 2, 3});
}

TEST_CASE("07.3 the axis depends on the first and the last of the IDs as well", "[07.3]") {
    for (const std::size_t far : {0u, 7u}) {
        std::vector<Vec3> middles;
        for (int i = 0; i < 8; ++i) middles.push_back({0, static_cast<Real>((i * 5) % 8), 0});
        middles[far].x = 100;
        const auto boxes = boxes_at(middles);
        auto order = numbers(8);
        split_in_half(order, boxes);
        INFO("ID " << far << " alone has its center at x = 100, the others at x = 0");
        CHECK(order_of_middles(order, boxes) == ascending);
    }
}

TEST_CASE("07.3 no sphere is lost if the centers are equal", "[07.3]") {
    checkpoint::check_equal_centers(
        [](auto order, auto boxes) { rt::split_in_half(order, boxes); });
}

TEST_CASE("07.3 the axis depends only on the boxes of the part that is split", "[07.3]") {
    // Eight boxes far apart along x that do not belong to this part; its own boxes
    // are apart along y.
    std::vector<Vec3> middles;
    for (int i = 0; i < 8; ++i) middles.push_back({static_cast<Real>(100 * i), 0, 0});
    for (int i = 0; i < 8; ++i) middles.push_back({500, static_cast<Real>((i * 5) % 8) * 3, 0});
    const auto boxes = boxes_at(middles);
    auto order = numbers(16);
    REQUIRE(split_in_half(std::span{order}.subspan(8), boxes) == 4);
    INFO(
        "boxes has 16 boxes, but order has only the IDs 8 to 15, whose centers have the same "
        "x: sort along y");
    INFO(
        "Hint: for (int id : order) take boxes[id]; start from the empty box, Box{}, "
        "because a box at (0, 0, 0) does not belong to this part");
    CHECK(first_sorted(std::span{order}.subspan(8), 4) == std::vector<int>{8, 10, 13, 15});
}

TEST_CASE("07.3 the box of a node encloses only its own spheres", "[07.3]") {
    std::vector<Vec3> middles;
    for (int i = 0; i < 9; ++i) middles.push_back({static_cast<Real>(10 * i), 5, 5});
    const auto boxes = boxes_at(middles);
    std::vector<int> order{0, 2, 4, 6, 1, 8, 7, 5, 3};
    const auto root =
        rt::build_node(std::span{order}.subspan(5), 5, std::span{boxes}, rt::split_in_half);
    const Box expected{{29, 4, 4}, {81, 6, 6}};
    INFO("the IDs 8, 7, 5, 3: " EXPECTED "a " << checkpoint::text(expected) << ", " ACTUAL "a "
                                              << checkpoint::text(root->box));
    INFO("Hint: for (int id : order) join boxes[id] to the node's box, which starts empty");
    CHECK(checkpoint::text(root->box) == checkpoint::text(expected));
}

TEST_CASE("07.3 every sphere is in exactly one leaf", "[07.3]") {
    for (const int count : {1, 2, 3, 4, 5, 10, 1000}) {
        const auto boxes = rt::bounds_of(random_spheres(count));
        auto order = numbers(boxes.size());
        const auto root = tree_of(order, boxes);
        INFO(count << " spheres");
        check_tree(*root, order, boxes);
        const int levels = levels_of(*root);
        int expected = 1;
        for (int n = count; n > rt::leaf_size; n = n - n / 2) ++expected;
        HINT(static_cast<Real>(expected), static_cast<Real>(levels),
             "each level halves the number of spheres, down to leaf_size");
        CHECK(levels == expected);
    }
}

TEST_CASE("07.3 the function split decides how many spheres go to the left", "[07.3]") {
    const auto boxes = rt::bounds_of(random_spheres(12));
    auto order = numbers(boxes.size());
    const auto split = [](std::span<int> part, std::span<const Box>) {
        return static_cast<int>(part.size()) <= rt::leaf_size ? 0 : 2;
    };
    const auto root = rt::build_node(std::span{order}, 0, std::span{boxes}, split);
    std::vector<int> counts;
    const rt::TreeNode* node = root.get();
    for (; node->left && node->right; node = node->right.get())
        counts.push_back(node->left->is_leaf() ? node->left->count : -1);
    counts.push_back(node->count);
    INFO(
        "12 spheres, and a split that always puts 2 to the left, until 4 are left; the values are "
        "how many spheres the leaves hold, from left to right, or -1 for a node that is no leaf.\n"
        "Hint: call split, the argument of build_node, and pass it on to both children; another "
        "function than split_in_half may stand behind it");
    CHECK(counts == std::vector<int>{2, 2, 2, 2, 4});
}

TEST_CASE("07.3 split is called once for each node and decides which nodes are leaves", "[07.3]") {
    const auto boxes = rt::bounds_of(random_spheres(40));
    for (const int largest : {1, 2, 10}) {
        auto order = numbers(boxes.size());
        int calls = 0;
        const auto split = [&](std::span<int> part, std::span<const Box>) {
            ++calls;
            const auto n = static_cast<int>(part.size());
            return n <= largest ? 0 : n / 2;
        };
        const auto root = rt::build_node(std::span{order}, 0, std::span{boxes}, split);
        INFO("40 spheres, and a split that leaves up to " << largest << " of them together");
        {
            INFO(
                "the number of spheres in the largest leaf.\nHint: a node is a leaf if, and only "
                "if, split returns 0; do not look at the number of spheres");
            CHECK(largest_leaf(*root) == largest);
        }
        INFO(
            "the number of nodes, and how often split was called.\nHint: keep what split returns "
            "in a variable");
        CHECK(nodes_of(*root) >= calls);
    }
}

TEST_CASE("07.3 the tree follows the results of any split", "[07.3][hard]") {
    const auto boxes = rt::bounds_of(random_spheres(400));
    for (int shape = 0; shape < 6; ++shape)
        for (const int level : {0, 1, 40, 63, 64, 65, 100}) {
            long asked = 0;
            const auto split = [&](std::span<int> part, std::span<const Box> all) {
                ++asked;
                if (all.data() != boxes.data() || all.size() != boxes.size())
                    FAIL("split got " << all.size() << " boxes; " EXPECTED << boxes.size()
                                      << ".\nHint: pass boxes on as it is, all of it");
                const auto n = static_cast<unsigned>(part.size());
                if (n == 1 || (shape == 5 && n < (level == 0 ? 400u : 20u))) return 0;
                std::reverse(part.begin(), part.end());
                if (shape == 0) return 1;
                if (shape == 1) return static_cast<int>(n) - 1;
                // Any number of them, but the same one for the same part.
                const auto chance = static_cast<unsigned>(
                    rt::mix_bits(n * 1000 + static_cast<unsigned>(part[0])) >> 32);
                if (shape == 2) return chance % 2 ? 1 : static_cast<int>(n) - 1;
                if (chance % 8 == 0 && n < 7) return 0;
                return static_cast<int>(1 + chance % (n - 1));
            };
            const int first = 20, count = 300;
            auto order = numbers(boxes.size()), again = order;
            const auto part = [&](std::vector<int>& of) {
                return std::span{of}.subspan(static_cast<std::size_t>(first),
                                             static_cast<std::size_t>(count));
            };
            INFO("a part of " << count << " IDs, from level " << level
                              << " on, split by a function of the test");
            const auto root = rt::build_node(part(order), first, std::span{boxes}, split, level);
            const long yours = asked;
            asked = 0;
            follow(*root, part(again), first, boxes, split, level);
            CHECK(order == again);
            INFO("Hint: call split once for each node, and split_in_half from most_levels on");
            CHECK(yours <= asked);
        }
}

TEST_CASE("07.3 the order is not copied", "[07.3]") {
    const auto boxes = rt::bounds_of(random_spheres(2000));
    auto order = numbers(boxes.size());
    const std::size_t before = allocations, bytes_before = allocated_bytes;
    // Not by tree_of, whose hint takes memory, too.
    const auto root = rt::build_node(std::span{order}, 0, std::span{boxes}, rt::split_in_half);
    const std::size_t taken = allocations - before, bytes = allocated_bytes - bytes_before;
    const std::size_t nodes = static_cast<std::size_t>(nodes_of(*root));
    INFO(nodes << " nodes, but your code took memory from the heap " << taken << " times, " << bytes
               << " bytes in all.\nHint: work on the span itself, first(n) and subspan(n) of it; "
                  "std::vector and std::stable_sort take memory of their own");
    CHECK(taken == nodes);
    CHECK(bytes == nodes * sizeof(rt::TreeNode));
}

TEST_CASE("07.3 the member first of a leaf counts from the start of the whole order", "[07.3]") {
    const auto boxes = rt::bounds_of(random_spheres(9));
    std::vector<int> order = numbers(9);
    const auto root =
        rt::build_node(std::span{order}.subspan(5), 5, std::span{boxes}, rt::split_in_half);
    INFO("a leaf over the part of the order from index 5 on has first = 5");
    REQUIRE(root->is_leaf());
    CHECK(root->first == 5);
    CHECK(root->count == 4);
}

TEST_CASE("07.3 the trees of hard scenes are valid", "[07.3][hard]") {
    for (const NamedScene& scene : hard_scenes()) {
        const auto boxes = rt::bounds_of(scene.spheres);
        auto order = numbers(boxes.size());
        INFO(scene.name);
        check_tree(*tree_of(order, boxes), order, boxes);
    }
}

TEST_CASE("07.3 bad splits do not make the tree deep", "[07.3][hard]") {
    const auto boxes = rt::bounds_of(random_spheres(2000));
    auto order = numbers(boxes.size());
    const auto one_goes_left = [](std::span<int> part, std::span<const Box>) {
        return part.size() > 1 ? 1 : 0;
    };
    const auto root = rt::build_node(std::span{order}, 0, std::span{boxes}, one_goes_left);
    check_tree(*root, order, boxes);
    const int levels = levels_of(*root), largest = largest_leaf(*root);
    {
        INFO(
            "the split separates only one sphere at a time; your largest leaf has "
            << largest << " spheres, " EXPECTED << rt::leaf_size << " at most.\nHint: at level "
            << "most_levels and deeper call split_in_half, and go on while it returns more than 0");
        CHECK(largest <= rt::leaf_size);
    }
    INFO("the split separates only one sphere at a time; your tree has "
         << levels << " levels.\nHint: at level most_levels and deeper call split_in_half instead");
    CHECK(levels >= rt::most_levels);
    // 64 are taken off, and halves of the other 1936 have 4 or fewer after 9 levels.
    CHECK(levels <= rt::most_levels + 10);
}

TEST_CASE("07.3 a scene may have many spheres", "[07.3]") {
    auto boxes = rt::bounds_of(random_spheres(70'040));
    for (std::size_t i = 0; i < 40; ++i) boxes[i] = boxes[100];  // what short numbers would find
    std::vector<int> order;
    for (int number = 70'000; number < 70'040; ++number) order.push_back(number);
    const auto root = rt::build_node(std::span{order}, 70'000, std::span{boxes}, rt::split_in_half);
    std::function<int(const rt::TreeNode&)> first = [&](const rt::TreeNode& node) {
        return node.is_leaf() ? node.first : first(*node.left);
    };
    CHECK(first(*root) == 70'000);
    CHECK(first(*root->right) == 70'020);
    Box around;
    for (std::size_t i = 0; i < 20; ++i)
        around = rt::join(around, boxes[static_cast<std::size_t>(order[i])]);
    CHECK(checkpoint::text(root->left->box) == checkpoint::text(around));
    rt::split_in_half(std::span{order}, std::span{boxes});
    CHECK(order_of_middles(std::span{order}, boxes) == ascending);
}
