#pragma once
#include <ostream>
#include <rt/image.hpp>
#include <rt/todo.hpp>
#include <stdexcept>

namespace rt {

// Exercise 03.4. Writes the image as text that any image viewer opens: "P3", width and
// height, 255, then the red, green and blue byte of each pixel, row by row from the top, in
// lines of at most 70 characters. The bytes are sRGB, as rt::to_byte gives them; light
// outside of [0, 1] is clamped.
// Star: throws std::logic_error if a color is not finite. Source: the "plain" format of
// https://netpbm.sourceforge.net/doc/ppm.html
inline void write_ppm(std::ostream& out, const Image& image) {
    rt::todo("03.4", out, image);
}

}  // namespace rt
