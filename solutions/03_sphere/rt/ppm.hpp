#pragma once
#include <ostream>
#include <rt/image.hpp>
#include <stdexcept>

namespace rt {

// Writes the image as text that any image viewer opens: "P3", width and height, 255, then the red,
// green and blue byte of each pixel, row by row from the top, one line per pixel. The bytes are
// sRGB; light outside of [0, 1] is clamped. Throws std::logic_error if a color is not finite.
// Source: the "plain" format of https://netpbm.sourceforge.net/doc/ppm.html
inline void write_ppm(std::ostream& out, const Image& image) {
    out << "P3\n" << image.width() << ' ' << image.height() << "\n255\n";
    for (const Color& c : image.pixels()) {
        if (!is_finite(c)) throw std::logic_error("a pixel's color is not finite: this is a bug");
        // A byte would print as a character; the + makes it a number.
        out << +to_byte(c.r) << ' ' << +to_byte(c.g) << ' ' << +to_byte(c.b) << '\n';
    }
}

}  // namespace rt
