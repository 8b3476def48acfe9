#include <answer.hpp>
#include <rt/filter_list.hpp>

namespace answer EXPORTED {

std::size_t filter_list(rt::PathList list, const std::uint8_t* masks, unsigned bit,
                        std::uint32_t* to) {
    return rt::filter_list(list, masks, bit, to);
}

}  // namespace EXPORTED
