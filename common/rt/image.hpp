#pragma once
#include <cassert>
#include <cstddef>
#include <rt/color.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt {

// A picture as a value: width x height colors in linear light. Pixel (0, 0) is the top left one,
// x grows to the right and y grows downwards. Copying copies all the pixels.
class Image {
  public:
    Image() = default;

    // Throws std::invalid_argument unless both sides are at least 1.
    Image(int width, int height, Color fill = {}) : width_{width}, height_{height} {
        if (width < 1 || height < 1)
            throw std::invalid_argument("an image needs at least 1x1 pixels, not " +
                                        std::to_string(width) + "x" + std::to_string(height));
        pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill);
    }

    int width() const { return width_; }
    int height() const { return height_; }

    // The pixel in column x of row y; both must lie inside (the debug build checks).
    Color& at(int x, int y) { return pixels_[index(x, y)]; }
    const Color& at(int x, int y) const { return pixels_[index(x, y)]; }

    // All pixels, row by row from the top.
    const std::vector<Color>& pixels() const { return pixels_; }

    friend bool operator==(const Image&, const Image&) = default;

  private:
    std::size_t index(int x, int y) const {
        assert(0 <= x && x < width_ && 0 <= y && y < height_);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    int width_ = 0, height_ = 0;
    std::vector<Color> pixels_;
};

// Calls shade(x, y) for every pixel and stores the color that it returns.
template <class Shade>
Image make_image(int width, int height, Shade shade) {
    Image image{width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = shade(x, y);
            assert(is_finite(image.at(x, y)));
        }
    return image;
}

}  // namespace rt
