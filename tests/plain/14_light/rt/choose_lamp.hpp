#pragma once
#include <cstddef>
#include <rt/lamp_tree.hpp>
#include <rt/pick.hpp>

namespace rt {

// The plain answer: by power alone.
inline Pick choose_lamp(const LampTree& tree, Vec3, Real number) {
    return pick(tree.shares, number);
}

inline Real lamp_probability(const LampTree& tree, Vec3, std::size_t lamp) {
    return probability_of(tree.shares, lamp);
}

}  // namespace rt
