#pragma once
// What descend is written over, as a type that both sides know.

#include <array>
#include <cstdint>
#include <rt/path_list.hpp>
#include <rt/wide_child.hpp>

namespace answer {

struct Tree {
    virtual ~Tree() = default;
    virtual unsigned test(std::int32_t node, rt::PathList list, std::uint8_t* masks) = 0;
    virtual const std::array<std::uint8_t, 8>& order(std::int32_t node) const = 0;
    virtual rt::WideChild child(std::int32_t node, unsigned place) const = 0;
    virtual void leaf(std::int32_t number, rt::PathList list) = 0;
};

}  // namespace answer
