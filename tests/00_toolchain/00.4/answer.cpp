#include <answer.hpp>
#include <rt/binary_tree.hpp>
#include <rt/range_node.hpp>

#include "watched.hpp"

// They take nodes of any type. One is compiled, since each takes a tenth of a second; calls with
// that of the program must be right, too.
static_assert(requires(std::unique_ptr<rt::RangeNode> tree, const rt::RangeNode* root) {
    tree = rt::make_tree<rt::RangeNode>(0, 1);
    rt::count_nodes(root) + rt::depth_of(root);
    rt::take_apart(std::move(tree));
});

namespace answer EXPORTED {

using checkpoint::WatchedNode;

void report_to(const checkpoint::Listener& listener) {
    checkpoint::listener = listener;
}

std::unique_ptr<WatchedNode> make_tree(int first, int last) {
    return rt::make_tree<WatchedNode>(first, last);
}

int count_nodes(const WatchedNode* root) {
    return rt::count_nodes(root);
}

int depth_of(const WatchedNode* root) {
    return rt::depth_of(root);
}

void take_apart(std::unique_ptr<WatchedNode> root) {
    rt::take_apart(std::move(root));
}

}  // namespace EXPORTED
