#include <algorithm>
#include <array>
#include <numeric>
#include <rt/descend.hpp>
#include <rt/rng.hpp>
#include <vector>

#include "checkpoint.hpp"
#include "fenced.hpp"

using checkpoint::Fenced;

namespace {

using Rays = std::vector<std::uint32_t>;

// Up to ten of the rays, from this index on.
std::string text(const Rays& rays, std::size_t from = 0) {
    std::string all = from > 0 ? " ..." : "";
    for (std::size_t i = from; i < rays.size() && i < from + 10; ++i)
        all += ' ' + std::to_string(rays[i]);
    return std::to_string(rays.size()) + " rays {" + all +
           (rays.size() > from + 10 ? " ... }" : " }");
}

// A test or visit to a tree: test(number, rays, ...) or leaf(number, rays).
struct Question {
    bool is_leaf;
    std::int32_t number;
    Rays rays;
    bool operator==(const Question&) const = default;
};
using Log = std::vector<Question>;

std::string text(const Log& log, std::size_t i, std::size_t from) {
    if (i >= log.size()) return "nothing more";
    return (log[i].is_leaf ? "leaf(" : "test(") + std::to_string(log[i].number) + ") with " +
           text(log[i].rays, from);
}

// Fails at the first test or visit that is not the expected one.
void check_log(const Log& actual, const Log& expected) {
    for (std::size_t i = 0; i < std::max(expected.size(), actual.size()); ++i) {
        std::size_t from = 0;
        const char* hint =
            "test each node that a ray meets once, when its turn comes, and visit each leaf that a "
            "ray meets once; take the children in the order of tree.order(node)";
        if (i < expected.size() && i < actual.size()) {
            if (expected[i] == actual[i]) continue;
            const Rays &a = expected[i].rays, &b = actual[i].rays;
            const auto other =
                std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
            from = other < 10 ? 0 : static_cast<std::size_t>(other);
            if (expected[i].is_leaf == actual[i].is_leaf && expected[i].number == actual[i].number)
                hint =
                    "a child gets exactly the rays that meet its box. If the lists before were "
                    "right, an earlier child has overwritten this node's list or masks: check "
                    "which memory you passed to it";
        }
        INFO("test or visit " << i << ": " EXPECTED << text(expected, i, from) << ", " ACTUAL
                              << text(actual, i, from));
        INFO("Hint: " << hint);
        REQUIRE(text(actual, i, from) == text(expected, i, from));
    }
}

// A tree of made-up answers, which writes down what it is asked.
struct LoggedTree {
    struct Node {
        std::array<rt::WideChild, 8> child{};
        std::array<std::uint8_t, 8> order{};
        std::uint8_t always = 0;  // children that every ray meets
    };
    std::vector<Node> nodes;
    std::int32_t first_node = 0;  // its number
    std::uint32_t seed = 0;
    std::vector<Question> log;

    const Node& at(std::int32_t node) const {
        return nodes.at(static_cast<std::size_t>(node - first_node));
    }
    // Whether a ray meets a child's box: arbitrary, but always the same.
    std::uint8_t mask(std::int32_t node, std::uint32_t ray) const {
        const std::uint64_t random =
            rt::mix_bits(seed * 1'000'003ull + static_cast<std::uint64_t>(node) * 65'537 + ray);
        return static_cast<std::uint8_t>((random & random >> 8) | at(node).always);
    }
    unsigned test(std::int32_t node, rt::PathList list, std::uint8_t* masks) {
        log.push_back({false, node, {list.begin(), list.end()}});
        unsigned any = 0;
        for (std::size_t i = 0; i < list.size(); ++i) any |= masks[i] = mask(node, list[i]);
        return any;
    }
    const std::array<std::uint8_t, 8>& order(std::int32_t node) const { return at(node).order; }
    rt::WideChild child(std::int32_t node, unsigned place) const {
        return at(node).child.at(place);
    }
    void leaf(std::int32_t number, rt::PathList list) {
        log.push_back({true, number, {list.begin(), list.end()}});
    }

    // What should be asked, and in which order.
    void expect(Log& questions, std::int32_t node, const Rays& rays) const {
        questions.push_back({false, node, rays});
        for (const unsigned place : order(node)) {
            Rays part;
            for (const std::uint32_t ray : rays)
                if (mask(node, ray) >> place & 1) part.push_back(ray);
            if (part.empty()) continue;
            const rt::WideChild below = child(node, place);
            if (below.is_leaf())
                questions.push_back({true, below.number(), part});
            else
                expect(questions, below.number(), part);
        }
    }
};

struct Shape {
    int levels;              // of nodes below the first one, at most
    bool is_chain = false;   // one child of each node is a node, and every ray goes there
    bool root_last = false;  // children have lower numbers than their parent; one of them is node 0
};

// The number of a node of this shape. The leaves are numbered, too.
std::int32_t grow(LoggedTree& tree, rt::Rng& rng, Shape shape, std::int32_t& leaves) {
    std::size_t number = tree.nodes.size();
    if (!shape.root_last) tree.nodes.emplace_back();
    LoggedTree::Node node;
    std::iota(node.order.begin(), node.order.end(), std::uint8_t{0});
    for (std::size_t i = 7; i > 0; --i) std::swap(node.order[i], node.order[rng() % (i + 1)]);
    const std::size_t next = rng() % 8;
    if (shape.is_chain) node.always = static_cast<std::uint8_t>(1u << next);
    Shape below = shape;
    --below.levels;
    for (std::size_t i = 0; i < 8; ++i) {
        const bool is_node = shape.levels > 0 && (shape.is_chain ? i == next : rng() % 3 == 0);
        node.child[i] = is_node ? rt::WideChild::node(grow(tree, rng, below, leaves))
                                : rt::WideChild::leaf(leaves++);
    }
    if (shape.root_last) {
        number = tree.nodes.size();
        tree.nodes.emplace_back();
    }
    tree.nodes[number] = node;
    return tree.first_node + static_cast<std::int32_t>(number);
}

void check_descend(int levels, std::uint64_t seed, std::size_t rays, bool is_chain = false) {
    rt::Rng rng{102, seed};
    LoggedTree tree;
    tree.seed = rng();
    std::int32_t leaves = 0;
    if (seed % 4 > 1) leaves = tree.first_node = 1'000'000;  // more than 16 bits can count
    const std::int32_t root = grow(tree, rng, {levels, is_chain, seed % 2 == 1}, leaves);
    Rays list(rays);
    for (std::uint32_t& ray : list) ray = rng() % 100'000;
    Log expected;
    tree.expect(expected, root, list);
    // As much room as it may need, and no more: a list and its masks for each level of nodes, where
    // the last level's lists go to leaves.
    const std::size_t room = static_cast<std::size_t>(levels + 1) * rays;
    Fenced<std::uint32_t> lists{room, 0xdeadbeef, 0xdeadbeef, 10 * room + 100};
    Fenced<std::uint8_t> masks{room, 0xa5, 0xa5, 10 * room + 100};
    rt::descend(tree, root, list, {lists.data(), masks.data()});

    INFO("the descent begins at node " << root << " with " << text(list));
    check_log(tree.log, expected);
    INFO("Hint: there is room for " << levels + 1 << " lists of " << rays
                                    << " rays and their masks, but your code writes outside of it");
    REQUIRE(lists.stands());
    REQUIRE(masks.stands());
}

}  // namespace

TEST_CASE("10.2 leaves are visited in order with the rays that meet their boxes", "[10.2]") {
    for (std::uint64_t seed = 0; seed < 50; ++seed) check_descend(0, seed, 1 + seed % 7);
}

TEST_CASE("10.2 every leaf gets the rays that meet all boxes above it", "[10.2]") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) check_descend(3, 1000 + seed, 40);
}

TEST_CASE("10.2 rays descend deep trees even where one or none goes on", "[10.2][hard]") {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        check_descend(5, 2000 + seed, 1);
        check_descend(5, 3000 + seed, 3);
    }
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        check_descend(4, 4000 + seed, 300);
        check_descend(90, 5000 + seed, 1 + seed, true);
    }
}

TEST_CASE("10.2 a hundred thousand rays reach the right leaves", "[10.2][hard]") {
    check_descend(1, 6000, 100'000, true);
}

TEST_CASE("10.2 hits in a leaf shorten the rays for the nodes that come later", "[10.2][hard]") {
    // A chain of nodes, each with a leaf first. Once a ray has been in a leaf, it no
    // longer meets any box.
    struct Shortened {
        std::vector<char> done = std::vector<char>(8, 0);
        std::array<std::uint8_t, 8> places{0, 1, 2, 3, 4, 5, 6, 7};
        std::vector<std::size_t> lengths;

        unsigned test(std::int32_t, rt::PathList list, std::uint8_t* masks) {
            lengths.push_back(list.size());
            unsigned any = 0;
            for (std::size_t i = 0; i < list.size(); ++i)
                any |= masks[i] = static_cast<std::uint8_t>(done[list[i]]  ? 0
                                                            : list[i] == 0 ? 3
                                                                           : 2);
            return any;
        }
        const std::array<std::uint8_t, 8>& order(std::int32_t) const { return places; }
        rt::WideChild child(std::int32_t node, unsigned place) const {
            if (place == 0) return rt::WideChild::leaf(0);
            return node + 1 < 4 ? rt::WideChild::node(node + 1) : rt::WideChild::leaf(1);
        }
        void leaf(std::int32_t, rt::PathList list) {
            for (const std::uint32_t ray : list) done[ray] = 1;
        }
    } tree;
    const Rays rays{0, 1, 2};
    std::vector<std::uint32_t> lists(100);
    std::vector<std::uint8_t> masks(100);
    rt::descend(tree, 0, rays, {lists.data(), masks.data()});
    INFO("a chain of four nodes: " EXPECTED
         "tests with 3, 3, 2 and 2 rays\nHint: test a node only after all leaves of the children "
         "before it have been visited");
    CHECK(tree.lengths == std::vector<std::size_t>{3, 3, 2, 2});
}
