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
            for (const Real channel : {c.r, c.g, c.b}) {
                const Real curve = Real(1.055) * std::pow(channel, 1 / Real(2.4)) - Real(0.055);
                const Real stored = channel > Real(0.0031308) ? curve : Real(12.92) * channel;
                out << std::lround(255 * stored) << '\n';
            }
        }
}

}  // namespace rt
