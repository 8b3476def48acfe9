#pragma once
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace rt {

template <class Pixel>
class Canvas {
  public:
    Canvas(int width, int height, const Pixel& fill = {}) {
        width_ = width;
        height_ = height;
        pixels_ = new Pixel[size()];
        std::fill(begin(), end(), fill);
    }

    ~Canvas() { delete[] pixels_; }

    Canvas(const Canvas& other)
        : width_{other.width_}, height_{other.height_}, pixels_{new Pixel[other.size()]} {
        std::copy(other.begin(), other.end(), begin());
    }

    Canvas(Canvas&& other) noexcept
        : width_{std::exchange(other.width_, 0)},
          height_{std::exchange(other.height_, 0)},
          pixels_{std::exchange(other.pixels_, nullptr)} {}

    Canvas& operator=(Canvas other) noexcept {
        std::swap(width_, other.width_);
        std::swap(height_, other.height_);
        std::swap(pixels_, other.pixels_);
        return *this;
    }

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t size() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }

    Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

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

template <class Pixel>
Canvas<Pixel> flipped(Canvas<Pixel> canvas) {
    for (int y = 0; y < canvas.height() / 2; ++y)
        for (int x = 0; x < canvas.width(); ++x)
            std::swap(canvas.at(x, y), canvas.at(x, canvas.height() - 1 - y));
    return canvas;
}

template <class Pixel>
const Pixel& largest(const Canvas<Pixel>& canvas) {
    const Pixel* found = canvas.begin();
    for (const Pixel& pixel : canvas)
        if (*found < pixel) found = &pixel;
    return *found;
}

}  // namespace rt
