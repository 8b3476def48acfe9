#include <cmath>
#include <rt/binary_tree.hpp>
#include <rt/range_node.hpp>

#include "checkpoint.hpp"
#include "watched.hpp"

using namespace checkpoint;

namespace {

using Tree = std::unique_ptr<WatchedNode>;

Tree node(Tree left = {}, Tree right = {}) {
    auto root = std::make_unique<WatchedNode>(0, 1);
    root->left = std::move(left);
    root->right = std::move(right);
    return root;
}

// The things that the leaves stand for, from left to right.
template <class Node>
void collect(const Node* root, std::vector<int>& things) {
    if (!root) return;
    if (!root->left && !root->right)
        for (int i = root->first; i < root->last; ++i) things.push_back(i);
    collect(root->left.get(), things);
    collect(root->right.get(), things);
}

// Whether every node has two halves of what it stands for, or is a leaf with one thing.
template <class Node>
bool is_balanced(const Node* root) {
    if (!root->left != !root->right) return false;
    if (!root->left) return root->last - root->first == 1;
    const auto size = [](const auto& n) { return n->last - n->first; };
    return root->left->first == root->first && root->left->last == root->right->first &&
           root->right->last == root->last && size(root->left) == size(root) / 2 &&
           is_balanced(root->left.get()) && is_balanced(root->right.get());
}

void check_memory() {
    {
        INFO("nodes that were never destroyed: "
             << Watch::live_objects()
             << ", pieces of memory that were never released: " << Watch::live_blocks()
             << ".\nHint: a node lives in a unique_ptr all the time; release() gives up what you "
                "own");
        CHECK(Watch::live_objects() == 0);
        CHECK(Watch::live_blocks() == 0);
    }
    INFO("destroyed twice: " << Watch::released_twice
                             << ".\nHint: a node has one owner. Do not make a second unique_ptr "
                                "from get(); move the one that there is");
    CHECK(Watch::released_twice == 0);
}

// A node like any other, and quickly made.
struct PlainNode {
    std::unique_ptr<PlainNode> left, right;
};

// A way down without a branch, by turns to the left and to the right: whoever calls himself for one
// of the two sides only is found out as well.
std::unique_ptr<PlainNode> deep_tree(int depth) {
    std::unique_ptr<PlainNode> root;
    for (int i = 0; i < depth; ++i) {
        auto parent = std::make_unique<PlainNode>();
        (i % 2 == 0 ? parent->left : parent->right) = std::move(root);
        root = std::move(parent);
    }
    return root;
}

// Destroys it without a tower of destructors.
void remove(std::unique_ptr<PlainNode> root) {
    while (root) {
        auto child = std::move(root->left ? root->left : root->right);
        root = std::move(child);
    }
}

constexpr int million = 1'000'000;

template <class Work>
void check_deep(const char* what, Work work) {
    auto root = deep_tree(million);
    const bool fine = survives([&] { return work(root.get()) == million; });
    remove(std::move(root));
    INFO(what << " of a tree that is a million nodes deep did not come out as a million, or the "
                 "stack was full.\nHint: a function that calls itself for each child needs room "
                 "on the stack for every level. Keep a std::vector of the nodes that are still to "
                 "be visited");
    CHECK(fine);
}

}  // namespace

TEST_CASE("00.3 the nodes of small trees are counted", "[00.3]") {
    const Watch watch;
    {
        INFO(
            "Hint: count every node, inner ones and leaves; an empty tree has none. With a list: "
            "not `for (... : to_do)`, which does not see what is added, but while "
            "(!to_do.empty())");
        CHECK(rt::count_nodes<WatchedNode>(nullptr) == 0);
        CHECK(rt::count_nodes(node().get()) == 1);
        CHECK(rt::count_nodes(node(node()).get()) == 2);
        CHECK(rt::count_nodes(node({}, node()).get()) == 2);
        CHECK(rt::count_nodes(node(node(node(), node()), node()).get()) == 5);
    }
    check_memory();
}

TEST_CASE("00.3 the depth of small trees", "[00.3]") {
    const Watch watch;
    {
        INFO("Hint: nodes on the longest way down, the root among them; the larger child counts");
        CHECK(rt::depth_of<WatchedNode>(nullptr) == 0);
        CHECK(rt::depth_of(node().get()) == 1);
        CHECK(rt::depth_of(node(node()).get()) == 2);
        CHECK(rt::depth_of(node({}, node()).get()) == 2);
        CHECK(rt::depth_of(node(node(), node()).get()) == 2);
        CHECK(rt::depth_of(node(node(node(), node({}, node())), node()).get()) == 4);
    }
    check_memory();
}

TEST_CASE("00.3 a tree is made of halves", "[00.3]") {
    const Watch watch;
    for (int count = 1; count <= 33; ++count) {
        {
            const Tree root = rt::make_tree<WatchedNode>(100, 100 + count);
            INFO("a tree over " << count << " things, from 100 on");
            REQUIRE((root != nullptr));
            CHECK(root->first == 100);
            CHECK(root->last == 100 + count);
            std::vector<int> things;
            collect(root.get(), things);
            std::vector<int> expected;
            for (int i = 0; i < count; ++i) expected.push_back(100 + i);
            {
                INFO(
                    "the leaves must stand for each thing once, in order.\nHint: the left child "
                    "has first to middle, the right one middle to last: `last` itself is not among "
                    "the things");
                REQUIRE(things == expected);
            }
            INFO(
                "each thing is there, but not in halves.\nHint: middle = first + (last - first) / "
                "2; of an odd number the right half is the larger one, and one thing alone is a "
                "leaf");
            REQUIRE(is_balanced(root.get()));
        }
        check_memory();
    }
}

TEST_CASE("00.3 a tree of nothing is empty", "[00.3]") {
    const Watch watch;
    CHECK((rt::make_tree<WatchedNode>(5, 5) == nullptr));
    INFO("Hint: the root of an empty tree is nullptr; no node may be made for it");
    CHECK(Watch::made == 0);
}

TEST_CASE("00.3 taking apart destroys every node once", "[00.3]") {
    const Watch watch;
    rt::take_apart(Tree{});
    rt::take_apart(node(node(node(), node({}, node())), node()));
    INFO("Hint: move the children out into a list, then let the node go");
    CHECK(Watch::made == 6);
    check_memory();
}

TEST_CASE("00.3 no destructor runs inside of another", "[00.3][hard]") {
    const Watch watch;
    for (const bool to_left : {true, false}) {
        Tree root;
        for (int i = 0; i < 1000; ++i)
            root = to_left ? node(std::move(root)) : node({}, std::move(root));
        rt::take_apart(std::move(root));
        INFO("destructors that ran inside of each other: "
             << Watch::deepest_destructor << ", in a tree 1000 nodes deep.\nHint: take both "
             << "children away from a node before it goes");
        CHECK(Watch::deepest_destructor == 1);
    }
    check_memory();
}

TEST_CASE("00.3 a tree a million nodes deep can be counted", "[00.3][hard]") {
    rt::count_nodes<PlainNode>(nullptr);
    check_deep("the count", [](const PlainNode* root) { return rt::count_nodes(root); });
}

TEST_CASE("00.3 a tree a million nodes deep has its depth measured", "[00.3][hard]") {
    rt::depth_of<PlainNode>(nullptr);
    check_deep("the depth", [](const PlainNode* root) { return rt::depth_of(root); });
}

TEST_CASE("00.3 a tree a million nodes deep is taken apart", "[00.3][hard]") {
    rt::take_apart(std::unique_ptr<PlainNode>{});
    auto root = deep_tree(million);
    const bool fine = survives([&] {
        rt::take_apart(std::move(root));
        return true;
    });
    remove(std::move(root));
    INFO(
        "the stack was full.\nHint: does take_apart call itself? Each call that waits takes room "
        "on the stack, also where no destructor runs inside of another. Keep a std::vector of "
        "unique_ptr, step 5 of the text");
    CHECK(fine);
}

TEST_CASE("00.3 things may be numbered up to the largest int", "[00.3][hard]") {
    rt::make_tree<rt::RangeNode>(0, 0);
    const int largest = std::numeric_limits<int>::max();
    const bool fine = survives([&] {
        const auto root = rt::make_tree<rt::RangeNode>(largest - 100, largest);
        const auto low = rt::make_tree<rt::RangeNode>(-largest, 100 - largest);
        return is_balanced(root.get()) && is_balanced(low.get());
    });
    INFO("a tree over " << largest - 100 << " to " << largest
                        << " is wrong, or the program ended.\nHint: first + last does not fit an "
                           "int; first + (last - first) / 2 does");
    CHECK(fine);
}

TEST_CASE("00.3 a balanced tree is as deep as the logarithm says", "[00.3][hard]") {
    for (const int count : {1, 2, 3, 4, 5, 8, 9, 1000, 1024, 1025, 100'000}) {
        const auto root = rt::make_tree<rt::RangeNode>(0, count);
        const int expected = 1 + static_cast<int>(std::ceil(std::log2(count)));
        INFO(count << " things");
        CHECK(rt::count_nodes(root.get()) == 2 * count - 1);
        CHECK(rt::depth_of(root.get()) == expected);
    }
}
