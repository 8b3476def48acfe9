#include <answer.hpp>
#include <rt/find_nearest.hpp>
#include <rt/hit_box.hpp>

#include "types.hpp"

namespace answer EXPORTED {

rt::Interval hit_box(const rt::Box& box, const rt::SlabRay& ray, rt::Interval within) {
    return rt::hit_box(box, ray, within);
}

void try_shape(int number, rt::Search& search) {
    rt::try_shape(number, search);
}

void try_shape(int number, MovedSearch& search) {
    rt::try_shape(number, search);
}

void find_nearest(const rt::TreeNode& node, rt::Search& search) {
    rt::find_nearest(node, search);
}

void find_nearest(const rt::TreeNode& node, MovedSearch& search) {
    rt::find_nearest(node, search);
}

void find_nearest(const rt::TreeNode& node, ShadowSearch& search) {
    rt::find_nearest(node, search);
}

void find_nearest(const ManyNode& node, ManySearch& search) {
    rt::find_nearest(node, search);
}

}  // namespace EXPORTED
