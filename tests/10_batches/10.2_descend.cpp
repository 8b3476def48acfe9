#include <algorithm>
#include <array>
#include <numeric>
#include <rt/descend.hpp>
#include <rt/rng.hpp>
#include <vector>

#include "checkpoint.hpp"

namespace {

// A tree of made-up answers, which writes down what it is asked.
struct LoggedTree {
    struct Node {
        std::array<std::int32_t, 8> child{};
        std::array<std::uint8_t, 8> order{};
    };
    std::vector<Node> nodes;
    std::uint32_t seed = 0;
    std::vector<std::pair<std::int32_t, std::vector<std::uint32_t>>> tests, leaves;

    // Whether a ray meets a child's box: anything, but always the same.
    std::uint8_t mask(std::int32_t node, std::uint32_t ray) const {
        const std::uint64_t random =
            rt::mix_bits(seed * 1'000'003ull + static_cast<std::uint64_t>(node) * 65'537 + ray);
        return static_cast<std::uint8_t>(random & random >> 8);
    }
    unsigned test(std::int32_t node, rt::PathList list, std::uint8_t* masks) {
        tests.push_back({node, {list.begin(), list.end()}});
        unsigned any = 0;
        for (std::size_t i = 0; i < list.size(); ++i) any |= masks[i] = mask(node, list[i]);
        return any;
    }
    const std::array<std::uint8_t, 8>& order(std::int32_t node) const {
        return nodes[static_cast<std::size_t>(node)].order;
    }
    std::int32_t child(std::int32_t node, unsigned place) const {
        return nodes[static_cast<std::size_t>(node)].child[place];
    }
    void leaf(std::int32_t child, rt::PathList list) {
        leaves.push_back({child, {list.begin(), list.end()}});
    }

    // What should be asked, in which order.
    void expect(LoggedTree& log, std::int32_t node, const std::vector<std::uint32_t>& list) const {
        log.tests.push_back({node, list});
        for (const unsigned place : order(node)) {
            std::vector<std::uint32_t> part;
            for (const std::uint32_t ray : list)
                if (mask(node, ray) >> place & 1) part.push_back(ray);
            if (part.empty()) continue;
            const std::int32_t below = child(node, place);
            if (below < 0)
                log.leaves.push_back({below, part});
            else
                expect(log, below, part);
        }
    }
};

// A tree of up to so many levels below a node; the numbers of leaves are ~0, ~1, ~2 ...
std::int32_t grow(LoggedTree& tree, rt::Rng& rng, int levels, std::int32_t& leaves) {
    const std::size_t place = tree.nodes.size();
    tree.nodes.emplace_back();
    LoggedTree::Node node;
    std::iota(node.order.begin(), node.order.end(), std::uint8_t{0});
    for (std::size_t i = 7; i > 0; --i) std::swap(node.order[i], node.order[rng() % (i + 1)]);
    for (std::int32_t& child : node.child)
        child = levels > 0 && rng() % 3 == 0 ? grow(tree, rng, levels - 1, leaves) : ~leaves++;
    tree.nodes[place] = node;
    return static_cast<std::int32_t>(place);
}

std::string text(const std::vector<std::uint32_t>& list) {
    std::string all;
    for (std::size_t i = 0; i < list.size() && i < 10; ++i) all += ' ' + std::to_string(list[i]);
    return std::to_string(list.size()) + " rays {" + all + (list.size() > 10 ? " ... }" : " }");
}

void check_log(const char* what, const decltype(LoggedTree::tests)& actual,
               const decltype(LoggedTree::tests)& expected, const char* hint) {
    for (std::size_t i = 0; i < std::max(actual.size(), expected.size()); ++i) {
        const auto words = [&](const auto& log) {
            return i < log.size() ? std::to_string(log[i].first) + " with " + text(log[i].second)
                                  : std::string{"none"};
        };
        if (i < actual.size() && i < expected.size() && actual[i] == expected[i]) continue;
        INFO("number " << i << " of the " << what << " that were asked.\nHint: " << hint);
        REQUIRE(words(actual) == words(expected));
    }
}

void check_descend(int levels, std::uint64_t seed, std::size_t rays) {
    rt::Rng rng{102, seed};
    LoggedTree tree;
    tree.seed = rng();
    std::int32_t leaves = 0;
    grow(tree, rng, levels, leaves);
    std::vector<std::uint32_t> list(rays);
    for (std::uint32_t& ray : list) ray = rng() % 100'000;
    const std::vector<std::uint32_t> before = list;
    LoggedTree expected;
    tree.expect(expected, 0, list);
    // As much room as it may need, and no more: a list a level, and one for the leaf.
    const auto room = static_cast<std::size_t>(levels + 1) * rays;
    std::vector<std::uint32_t> lists(room + 1, 0xdeadbeef);
    std::vector<std::uint8_t> masks(room + 1, 0xa5);
    rt::descend(tree, 0, list, {lists.data(), masks.data()});
    check_log("nodes", tree.tests, expected.tests,
              "each node that a ray meets, once, with the rays that meet it, the children in the "
              "tree's order");
    check_log("leaves", tree.leaves, expected.leaves,
              "a negative child is a leaf: it gets the rays that meet its box, and no empty list");
    INFO("Hint: it writes beyond the room that it has");
    REQUIRE(lists[room] == 0xdeadbeef);
    REQUIRE(masks[room] == 0xa5);
    REQUIRE(list == before);
}

}  // namespace

TEST_CASE("10.2 a node whose children are leaves", "[10.2]") {
    for (std::uint64_t seed = 0; seed < 50; ++seed) check_descend(0, seed, 1 + seed % 7);
}

TEST_CASE("10.2 every leaf gets the rays that meet all boxes above it", "[10.2]") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) check_descend(3, 1000 + seed, 40);
}

TEST_CASE("10.2 deep trees and lists of one ray or none that goes on", "[10.2][hard]") {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        check_descend(5, 2000 + seed, 1);
        check_descend(5, 3000 + seed, 3);
    }
    for (std::uint64_t seed = 0; seed < 6; ++seed) check_descend(4, 4000 + seed, 500);
}

TEST_CASE("10.2 what a leaf finds shortens the rays for the nodes that come later",
          "[10.2][hard]") {
    // A chain of nodes, each with a leaf first. Once a ray was in a leaf it meets no box any more.
    struct Shortened {
        std::vector<char> done = std::vector<char>(8, 0);
        std::array<std::uint8_t, 8> places{0, 1, 2, 3, 4, 5, 6, 7};
        int asked = 0;
        std::vector<std::size_t> lengths;

        unsigned test(std::int32_t, rt::PathList list, std::uint8_t* masks) {
            ++asked;
            lengths.push_back(list.size());
            unsigned any = 0;
            for (std::size_t i = 0; i < list.size(); ++i)
                any |= masks[i] = static_cast<std::uint8_t>(done[list[i]]  ? 0
                                                            : list[i] == 0 ? 3
                                                                           : 2);
            return any;
        }
        const std::array<std::uint8_t, 8>& order(std::int32_t) const { return places; }
        std::int32_t child(std::int32_t node, unsigned place) const {
            return place == 0 ? ~0 : node + 1 < 4 ? node + 1 : ~1;
        }
        void leaf(std::int32_t, rt::PathList list) {
            for (const std::uint32_t ray : list) done[ray] = 1;
        }
    } tree;
    const std::vector<std::uint32_t> rays{0, 1, 2};
    std::vector<std::uint32_t> lists(100);
    std::vector<std::uint8_t> masks(100);
    rt::descend(tree, 0, rays, {lists.data(), masks.data()});
    INFO("Hint: a node is asked when its turn has come, not before its neighbor's leaves were");
    CHECK(tree.lengths == std::vector<std::size_t>{3, 3, 2, 2});
}
