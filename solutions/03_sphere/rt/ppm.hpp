#pragma once
#include <ostream>
#include <rt/image.hpp>

namespace rt {

// Writes the image as a text that any image viewer opens: "P3", width and height, 255, then the
// red, green and blue byte of each pixel, row by row from the top, a line a pixel.
inline void write_ppm(std::ostream& out, const Image& image) {
    out << "P3\n" << image.width() << ' ' << image.height() << "\n255\n";
    for (const Color& c : image.pixels()) {
        // A byte would print as a letter; the + makes it a number.
        out << +to_byte(c.r) << ' ' << +to_byte(c.g) << ' ' << +to_byte(c.b) << '\n';
    }
}

}  // namespace rt
