#pragma once
// A picture as a program wrote it to a file: 8 bits per channel, sRGB.

#include <cstdint>
#include <rt/image.hpp>
#include <string>
#include <vector>

namespace companion {

struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes = {};  // red, green and blue of each pixel, from the top left

    long pixels() const { return static_cast<long>(width) * height; }
    friend bool operator==(const Picture&, const Picture&) = default;
};

inline bool same_size(const Picture& a, const Picture& b) {
    return a.width == b.width && a.height == b.height;
}

// Reads the text of a .ppm file, with decimal numbers (P3) or binary (P6), and values up to 255.
// Chapter 03 writes P3; other programs may write either. Throws app::Failure, which says what is
// wrong.
Picture parse_ppm(const std::string& text);

// The linear light, 0 to 1, that a byte stands for.
double light_of(std::uint8_t byte);

// The mean of pictures, in linear light. Throws app::Failure if their sizes differ.
rt::Image mean_of(const std::vector<Picture>& pictures);

}  // namespace companion
