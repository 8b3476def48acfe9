#pragma once
#include <ostream>
#include <rt/image.hpp>
#include <stdexcept>

namespace rt {

inline void write_ppm(std::ostream& out, const Image& image) {
    out << "P3\n" << image.width() << ' ' << image.height() << "\n255\n";
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Color& c = image.at(x, y);
            if (!is_finite(c)) throw std::logic_error("not finite");
            out << +to_byte(c.b) << ' ' << +to_byte(c.g) << ' ' << +to_byte(c.r) << '\n';
        }
}

}  // namespace rt
