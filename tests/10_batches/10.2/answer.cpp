#include <answer.hpp>
#include <rt/descend.hpp>

#include "types.hpp"

namespace answer EXPORTED {

void descend(Tree& tree, std::int32_t node, rt::PathList list, rt::Scratch scratch) {
    rt::descend(tree, node, list, scratch);
}

}  // namespace EXPORTED
