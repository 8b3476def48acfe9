// Runs the exercises on plain memory under the address sanitizer, which is silent on the solution
// and reports the mistakes.

#include <cstdio>
#include <rt/binary_tree.hpp>
#include <rt/canvas.hpp>
#include <rt/range_node.hpp>

int main() {
    {
        const rt::Canvas<int> canvas{30, 20, 1};
        const rt::Canvas<int> copy = canvas;
    }
    {
        rt::Canvas<int> copy{30, 20, 1};
        copy = static_cast<const rt::Canvas<int>&>(copy);
        copy.at(3, 4) = 7;
        rt::Canvas<int> moved = std::move(copy);
        copy = rt::flipped(std::move(moved));
        const int& pixel = rt::largest(copy);
        if (pixel != 7) return 1;
    }
    {
        auto root = rt::make_tree<rt::RangeNode>(0, 100);
        if (rt::count_nodes(root.get()) != 199 || rt::depth_of(root.get()) != 8) return 1;
        rt::take_apart(std::move(root));
    }
    std::puts("all memory is released, if nothing follows");
}
