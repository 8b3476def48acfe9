#include <cmath>
#include <rt/binary_tree.hpp>
#include <rt/rng.hpp>
#include <string>

#include "checkpoint.hpp"
#include "own_process.hpp"
#include "watch.hpp"

using namespace checkpoint;

namespace {

using Tree = std::unique_ptr<WatchedNode>;

Tree node(Tree left = {}, Tree right = {}) {
    auto root = std::make_unique<WatchedNode>(0, 1);
    root->left = std::move(left);
    root->right = std::move(right);
    return root;
}

// A tree of any shape with this many nodes: part list, part bush.
Tree random_tree(int count, rt::Rng& rng) {
    if (count == 0) return {};
    const auto any = static_cast<int>(rng() % static_cast<unsigned>(count));
    const int to_left = rng() % 2 ? any : static_cast<int>(rng() % 2) * (count - 1);
    Tree left = random_tree(to_left, rng);
    return node(std::move(left), random_tree(count - 1 - to_left, rng));
}

// The definition, word for word; the tree is not deep.
int plain_depth(const WatchedNode* root) {
    if (!root) return 0;
    return 1 + std::max(plain_depth(root->left.get()), plain_depth(root->right.get()));
}

// The things that the leaves stand for, from left to right.
void collect(const WatchedNode* root, std::vector<int>& things) {
    if (!root) return;
    if (!root->left && !root->right)
        for (int i = root->first; i < root->last; ++i) things.push_back(i);
    collect(root->left.get(), things);
    collect(root->right.get(), things);
}

// The first node whose children are not the halves of what it stands for, or that is not a leaf
// though it stands for one thing; "none" if all are right.
std::string unbalanced(const WatchedNode* root) {
    const int size = root->last - root->first;
    bool right = size == 1 ? !root->left && !root->right : root->left && root->right;
    if (right && size > 1) {
        const int middle = root->first + size / 2;
        right = root->left->first == root->first && root->left->last == middle &&
                root->right->first == middle && root->right->last == root->last;
    }
    if (!right)
        return "the node over " + std::to_string(root->first) + " to " + std::to_string(root->last);
    for (const WatchedNode* child : {root->left.get(), root->right.get()})
        if (child)
            if (const std::string wrong = unbalanced(child); wrong != "none") return wrong;
    return "none";
}

void check_memory() {
    {
        INFO("nodes that were never destroyed: " << Watch::live_objects()
                                                 << ", blocks of memory that were never released: "
                                                 << Watch::live_blocks()
                                                 << ".\nHint: at all times, a unique_ptr must own "
                                                    "each node; release() gives up ownership");
        CHECK(Watch::live_objects() == 0);
        CHECK(Watch::live_blocks() == 0);
    }
    INFO("destroyed twice: " << Watch::released_twice
                             << ".\nHint: a node has one owner. Do not make a second unique_ptr "
                                "from get(); move the existing one");
    CHECK(Watch::released_twice == 0);
}

constexpr int million = 1'000'000;

// A tree a million nodes deep. The way down turns left and right, and for long stretches stays on
// one side. The other side is empty at some nodes, has a leaf at some, and three nodes at some. So
// the tree also catches functions that call themselves for one side only, or only where there are
// two children, and lists that are too short. It is made once and stays.
struct DeepTree {
    DeepTree() {
        Tree tree;
        for (int i = 0; i < million; ++i) {
            Tree parent = node();
            const int stretch = i / 200'000;
            const bool to_left = stretch % 2 == 0 ? i % 2 == 0 : stretch == 1;
            auto& way = to_left ? parent->left : parent->right;
            auto& side = to_left ? parent->right : parent->left;
            way = std::move(tree);
            ++count;
            if (stretch > 0 && i > 10) {
                side = node();
                ++count;
                if (i % 16 == 0) {
                    side->left = node();
                    side->right = node();
                    count += 2;
                }
            }
            tree = std::move(parent);
        }
        root = tree.release();
    }

    WatchedNode* root;
    int count = 0;
};

DeepTree& deep_tree() {
    static DeepTree tree;
    return tree;
}

// Checks what work() returns for the deep tree.
template <class Work>
void check_deep(int expected_number, Work work) {
    const WatchedNode* const root = deep_tree().root;
    const std::string actual = in_own_process([&] { return std::to_string(work(root)); });
    const std::string expected = std::to_string(expected_number);
    INFO(
        "a tree that is a million nodes deep. If the program ended, its stack was full.\nHint: a "
        "function that calls itself for a child needs room on the stack for every level. Keep a "
        "std::vector of the nodes that are still to be visited, which grows as needed");
    CHECK(actual == expected);
}

}  // namespace

TEST_CASE("00.4 the nodes of small trees are counted", "[00.4]") {
    const Watch watch;
    {
        INFO(
            "Hint: count every node, both inner nodes and leaves; an empty tree has none. If you "
            "keep a list, loop with while (!to_do.empty()), because a vector must not grow inside "
            "`for (... : to_do)`");
        CHECK(rt::count_nodes<WatchedNode>(nullptr) == 0);
        CHECK(rt::count_nodes(node().get()) == 1);
        CHECK(rt::count_nodes(node(node()).get()) == 2);
        CHECK(rt::count_nodes(node({}, node()).get()) == 2);
        CHECK(rt::count_nodes(node(node(node(), node()), node()).get()) == 5);
    }
    check_memory();
}

TEST_CASE("00.4 the depth of small trees is measured", "[00.4]") {
    const Watch watch;
    {
        INFO(
            "Hint: count the nodes on the longest path down, including the root: of two children, "
            "the deeper one counts");
        CHECK(rt::depth_of<WatchedNode>(nullptr) == 0);
        CHECK(rt::depth_of(node().get()) == 1);
        CHECK(rt::depth_of(node(node()).get()) == 2);
        CHECK(rt::depth_of(node({}, node()).get()) == 2);
        CHECK(rt::depth_of(node(node(), node()).get()) == 2);
        CHECK(rt::depth_of(node(node(node(), node({}, node())), node()).get()) == 4);
    }
    check_memory();
}

TEST_CASE("00.4 trees of any shape are counted and measured", "[00.4]") {
    const Watch watch;
    rt::Rng rng{3, 3};
    for (int i = 0; i < 300; ++i) {
        const int count = static_cast<int>(rng() % 40);
        const Tree root = random_tree(count, rng);
        INFO("a tree of " << count
                          << " nodes, of any shape.\nHint: each call starts from zero, and every "
                          << "node is visited, whichever children it has");
        REQUIRE(rt::count_nodes(root.get()) == count);
        REQUIRE(rt::depth_of(root.get()) == plain_depth(root.get()));
    }
}

TEST_CASE("00.4 each node is split in half", "[00.4]") {
    const Watch watch;
    for (const int first : {100, -1, -10, -77})
        for (int count = 1; count <= 40; ++count) {
            {
                const int made = Watch::made;
                const Tree root = rt::make_tree<WatchedNode>(first, first + count);
                INFO("a tree over " << count << " things, from " << first << " on");
                REQUIRE(root);
                CHECK(root->first == first);
                CHECK(root->last == first + count);
                std::vector<int> things;
                collect(root.get(), things);
                std::vector<int> expected;
                for (int i = 0; i < count; ++i) expected.push_back(first + i);
                {
                    INFO(
                        "the leaves must stand for each number once, in order.\nHint: the left "
                        "child goes from first to middle, the right child from middle to last: "
                        "`last` itself is not one of the numbers");
                    REQUIRE(things == expected);
                }
                {
                    INFO(
                        "every number is in the tree, but the children of this node are not its "
                        "two halves.\nHint: middle = first + (last - first) / 2; if the count is "
                        "odd, "
                        "the right half is larger, and a single number is a leaf. For negative "
                        "numbers, (first + last) / 2 is rounded in the other direction");
                    REQUIRE(unbalanced(root.get()) == "none");
                }
                INFO("the number of nodes that were made: make each node once");
                REQUIRE(Watch::made - made == 2 * count - 1);
            }
            check_memory();
        }
}

TEST_CASE("00.4 a tree over no things is empty", "[00.4]") {
    const Watch watch;
    for (const int first : {0, 5, -5}) {
        INFO("Hint: the root of an empty tree is nullptr: make no node for it");
        const Tree root = rt::make_tree<WatchedNode>(first, first);
        const std::string actual = root ? "a node" : "nullptr";
        CHECK(actual == "nullptr");
        CHECK(Watch::made == 0);
    }
}

TEST_CASE("00.4 take_apart destroys every node once", "[00.4]") {
    const Watch watch;
    rt::take_apart(Tree{});
    rt::take_apart(node(node(node(), node({}, node())), node()));
    check_memory();
    rt::Rng rng{4, 4};
    for (int i = 0; i < 100; ++i) rt::take_apart(random_tree(static_cast<int>(rng() % 40), rng));
    INFO("Hint: move the children out into a list, then destroy the node");
    check_memory();
}

TEST_CASE("00.4 no destructor runs inside another", "[00.4][hard]") {
    const Watch watch;
    rt::Rng rng{5, 5};
    for (int kind = 0; kind < 6; ++kind) {
        Tree root = kind == 0 ? random_tree(1000, rng) : Tree{};
        // To the left, to the right, or in turns; with leaves on the other side, or without.
        for (int i = 0; i < 1000; ++i) {
            Tree side = kind >= 3 ? node() : Tree{};
            const bool to_left = kind % 3 == 0 ? i % 2 == 0 : kind % 3 == 1;
            root = to_left ? node(std::move(root), std::move(side))
                           : node(std::move(side), std::move(root));
        }
        rt::take_apart(std::move(root));
        INFO("destructors that ran inside each other, in a tree 1000 nodes deep.\nHint: take both "
             << "children from a node before it is destroyed");
        CHECK(Watch::deepest_destructor == 1);
    }
    check_memory();
}

TEST_CASE("00.4 a tree a million nodes deep can be counted", "[00.4][hard]") {
    const Watch watch{Watch::destructors_only};
    rt::count_nodes<WatchedNode>(nullptr);
    check_deep(deep_tree().count, [](const WatchedNode* root) { return rt::count_nodes(root); });
}

TEST_CASE("00.4 the depth of a tree a million nodes deep can be measured", "[00.4][hard]") {
    const Watch watch{Watch::destructors_only};
    rt::depth_of<WatchedNode>(nullptr);
    check_deep(million, [](const WatchedNode* root) { return rt::depth_of(root); });
}

TEST_CASE("00.4 a tree a million nodes deep can be taken apart", "[00.4][hard]") {
    const Watch watch{Watch::destructors_only};
    rt::take_apart(Tree{});
    WatchedNode* const root = deep_tree().root;
    // In a process of its own, on a copy of the tree.
    const std::string actual = in_own_process([&] {
        rt::take_apart(Tree{root});
        return std::to_string(Watch::deepest_destructor) + " destructor at a time";
    });
    INFO(
        "if the program ended, its stack was full.\nHint: take_apart must not call itself: each "
        "waiting call takes room on the stack, even if no destructor runs inside another. Keep "
        "a std::vector of unique_ptr, as in step 5 of the text");
    CHECK(actual == "1 destructor at a time");
}

TEST_CASE("00.4 things may be numbered up to the largest int", "[00.4][hard]") {
    const Watch watch{Watch::destructors_only};
    rt::make_tree<WatchedNode>(0, 0);
    using limits = std::numeric_limits<int>;
    for (const int first : {limits::max() - 100, limits::max() - 1, limits::min(), -50}) {
        const int last = first + (first == limits::max() - 1 ? 1 : 100);
        const std::string actual = in_own_process([&] {
            const auto root = rt::make_tree<WatchedNode>(first, last);
            const bool is_root = root && root->first == first && root->last == last;
            return is_root ? unbalanced(root.get()) : "the root";
        });
        INFO("the node whose children are not its two halves, in a tree over "
             << first << " to " << last
             << ".\nHint: first + last does not fit into an int; first + (last - first) / 2 does");
        CHECK(actual == "none");
    }
}

TEST_CASE("00.4 the depth of a balanced tree grows as the logarithm of its size", "[00.4][hard]") {
    const Watch watch{Watch::destructors_only};
    for (const int count : {1, 2, 3, 4, 5, 8, 9, 1000, 1024, 1025, 100'000}) {
        const auto root = rt::make_tree<WatchedNode>(-count / 3, count - count / 3);
        const int expected = 1 + static_cast<int>(std::ceil(std::log2(count)));
        INFO(count << " things");
        REQUIRE(root);
        CHECK(unbalanced(root.get()) == "none");
        CHECK(rt::count_nodes(root.get()) == 2 * count - 1);
        REQUIRE(rt::depth_of(root.get()) == expected);
    }
}
