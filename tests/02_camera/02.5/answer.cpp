#include <answer.hpp>
#include <rt/for_each_pixel.hpp>

#include "types.hpp"

namespace answer EXPORTED {

void for_each_pixel(const rt::Tile& tile, Visit visit) {
    rt::for_each_pixel(tile, std::move(visit));
}

void for_each_pixel(const rt::Tile& tile, OneVisit visit) {
    rt::for_each_pixel(tile, std::move(visit));
}

}  // namespace EXPORTED
