#pragma once
#include <rt/search.hpp>
#include <rt/tree.hpp>

#include "../types.hpp"

namespace answer {

void try_shape(int number, rt::Search& search);
void try_shape(int number, MovedSearch& search);
void find_nearest(const rt::TreeNode& node, rt::Search& search);
void find_nearest(const rt::TreeNode& node, MovedSearch& search);
void find_nearest(const rt::TreeNode& node, ShadowSearch& search);
void find_nearest(const ManyNode& node, ManySearch& search);

}  // namespace answer

namespace rt {

using answer::find_nearest;
using answer::try_shape;

}  // namespace rt
