#include <answer.hpp>
#include <rt/split_by_area.hpp>

namespace answer EXPORTED {

rt::Real surface_area(const rt::Box& box) {
    return rt::surface_area(box);
}

int split_by_area(std::span<int> order, std::span<const rt::Box> boxes) {
    return rt::split_by_area(order, boxes);
}

}  // namespace EXPORTED
