#pragma once
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace rt {

// A picture as a value. The object itself has three members: two numbers and the address of its
// pixels, which are on the heap, row by row from the top. A canvas owns its pixels: it alone
// allocates and releases them, and a copy has pixels of its own. Pixel is any type that has a
// default value and can be copied without throwing an exception.
template <class Pixel>
class Canvas {
  public:
    // All pixels have the color `fill`. Throws std::invalid_argument unless both sides are at
    // least 1.
    Canvas(int width, int height, const Pixel& fill = {}) {
        // Checked before any memory is allocated: if a constructor throws, no destructor runs.
        if (width < 1 || height < 1)
            throw std::invalid_argument("a canvas needs at least 1x1 pixels");
        width_ = width;
        height_ = height;
        pixels_ = new Pixel[size()];
        std::fill(begin(), end(), fill);
    }

    ~Canvas() { delete[] pixels_; }

    // A copy, with pixels of its own: as many as the other has, in the same colors.
    Canvas(const Canvas& other)
        : width_{other.width_}, height_{other.height_}, pixels_{new Pixel[other.size()]} {
        std::copy(other.begin(), other.end(), begin());
    }

    // A move: the pixels change owners, none is copied, and the other canvas is left with no
    // pixels, 0 wide and 0 high. A move cannot fail, and noexcept tells other code so. Without
    // noexcept, std::vector would copy instead.
    Canvas(Canvas&& other) noexcept
        : width_{std::exchange(other.width_, 0)},
          height_{std::exchange(other.height_, 0)},
          pixels_{std::exchange(other.pixels_, nullptr)} {}

    // Assignment. `other` is a value: the caller has already copied or moved into it. In exchange,
    // `other` gets this canvas's old pixels, and releases them at the end of the function.
    Canvas& operator=(Canvas other) noexcept {
        std::swap(width_, other.width_);
        std::swap(height_, other.height_);
        std::swap(pixels_, other.pixels_);
        return *this;
    }

    int width() const { return width_; }
    int height() const { return height_; }
    // Width times height, in a type that has room for it.
    std::size_t size() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }

    // The pixel in column x of row y, which must lie inside the canvas.
    Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

    // All pixels, for loops: for (const Pixel& pixel : canvas).
    Pixel* begin() { return pixels_; }
    Pixel* end() { return pixels_ + size(); }
    const Pixel* begin() const { return pixels_; }
    const Pixel* end() const { return pixels_ + size(); }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    int width_ = 0, height_ = 0;
    Pixel* pixels_ = nullptr;
};

// The canvas upside down: its first row becomes the last. The function takes a canvas by value and
// returns one by value. If the caller moves a canvas into the function, the result has that
// canvas's memory; no other row or canvas is made on the way.
template <class Pixel>
Canvas<Pixel> flipped(Canvas<Pixel> canvas) {
    for (int y = 0; y < canvas.height() / 2; ++y)
        for (int x = 0; x < canvas.width(); ++x)
            std::swap(canvas.at(x, y), canvas.at(x, canvas.height() - 1 - y));
    return canvas;
}

// The largest pixel, compared by <, or the first of several that are equally large. The result is a
// reference: the pixel itself, not a copy, valid for as long as the canvas lives. The canvas must
// not be empty.
template <class Pixel>
const Pixel& largest(const Canvas<Pixel>& canvas) {
    const Pixel* found = canvas.begin();
    for (const Pixel& pixel : canvas)
        if (*found < pixel) found = &pixel;
    return *found;
}

}  // namespace rt
