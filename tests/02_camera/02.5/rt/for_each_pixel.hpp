#pragma once
#include <rt/tile.hpp>
#include <type_traits>

#include "../types.hpp"

namespace answer {

void for_each_pixel(const rt::Tile& tile, Visit visit);
void for_each_pixel(const rt::Tile& tile, OneVisit visit);

}  // namespace answer

namespace rt {

template <class Visit>
void for_each_pixel(const Tile& tile, Visit visit) {
    if constexpr (std::is_copy_constructible_v<Visit>)
        answer::for_each_pixel(tile, answer::Visit{visit});
    else
        answer::for_each_pixel(tile, answer::OneVisit{std::ref(visit)});
}

}  // namespace rt
