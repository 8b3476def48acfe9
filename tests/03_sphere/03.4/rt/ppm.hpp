#pragma once
#include <ostream>
#include <rt/image.hpp>

namespace answer {

void write_ppm(std::ostream& out, const rt::Image& image);

}  // namespace answer

namespace rt {

using answer::write_ppm;

}  // namespace rt
