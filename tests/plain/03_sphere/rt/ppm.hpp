#pragma once
#include <ostream>
#include <rt/image.hpp>
#include <stdexcept>

namespace rt {

inline void write_ppm(std::ostream& out, const Image& image) {
    out << "P3\n" << image.width() << ' ' << image.height() << "\n255\n";
    for (const Color& c : image.pixels()) {
        out << +to_byte(c.r) << ' ' << +to_byte(c.g) << ' ' << +to_byte(c.b) << '\n';
    }
}

}  // namespace rt
