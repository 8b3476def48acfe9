#pragma once
#include <cstddef>
#include <cstdint>
#include <rt/copy_marked.hpp>
#include <rt/path_list.hpp>

namespace rt {

// Copies to `to` those paths of a list whose mask has bit number `bit` set, in the same order, and
// returns how many there are. masks[i] is the mask of list[i]. `to` has room for the whole list. No
// mask decides a branch, because no processor can predict whether a ray meets a box.
inline std::size_t filter_list(PathList list, const std::uint8_t* masks, unsigned bit,
                               std::uint32_t* to) {
    std::size_t count = 0, i = 0;
    for (; i + 8 <= list.size(); i += 8) count += copy_marked(&list[i], masks + i, bit, to + count);
    for (; i < list.size(); ++i) {
        to[count] = list[i];
        count += masks[i] >> bit & 1;
    }
    return count;
}

}  // namespace rt
