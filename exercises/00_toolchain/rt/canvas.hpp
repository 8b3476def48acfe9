#pragma once
#include <algorithm>
#include <cstddef>
#include <rt/todo.hpp>
#include <stdexcept>
#include <utility>

namespace rt {

// Exercise 00.3. A picture as a value. The object itself has three members: two numbers and the
// address of its pixels, which are on the heap, row by row from the top. A canvas owns its pixels:
// it alone allocates and releases them, and a copy has pixels of its own. Pixel is any type that
// has a default value and can be copied without throwing an exception.
template <class Pixel>
class Canvas {
  public:
    // Exercise 00.3, the constructor. Allocate size() pixels on the heap and give all of them the
    // color `fill`.
    // Star: throw std::invalid_argument unless both sides are at least 1.
    Canvas(int width, int height, const Pixel& fill = {}) { rt::todo("00.3", width, height, fill); }

    // Exercise 00.3, the destructor. Release the pixels. (A destructor must not throw, so there is
    // no todo in it. Left empty, it leaks memory.)
    ~Canvas() {}

    // Exercise 00.3, the copy constructor. Allocate as many pixels as the other canvas has, and
    // give them the same colors.
    Canvas(const Canvas& other) { rt::todo("00.3", other); }

    // Exercise 00.3, the move constructor. Take over the other canvas's pixels without copying any,
    // and leave that canvas without pixels, 0 wide and 0 high.
    // Star: when this works, write noexcept before the {; the text explains why.
    Canvas(Canvas&& other) { rt::todo("00.3", other); }

    // Exercise 00.3, assignment. `other` is a value: the caller has already copied or moved a
    // canvas into it. Swap its three members with those of this canvas, and return *this, the
    // canvas itself.
    Canvas& operator=(Canvas other) { rt::todo("00.3", other); }

    // Everything from here on is given.
    int width() const { return width_; }
    int height() const { return height_; }
    // Width times height, in a type that has room for it.
    std::size_t size() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }

    // The pixel in column x of row y, which must lie inside the canvas.
    Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

    // These let a loop go over all pixels: for (const Pixel& pixel : canvas).
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

// Exercise 00.3. The canvas upside down: its first row becomes the last. The function takes a
// canvas by value and returns one by value. If a canvas is moved into it, the result has the same
// memory; no other row or canvas is made on the way. std::swap(a, b) exchanges two pixels.
// Star: an empty canvas stays empty.
template <class Pixel>
Canvas<Pixel> flipped(Canvas<Pixel> canvas) {
    return rt::todo("00.3", canvas);
}

// Exercise 00.3. The largest pixel, compared by <, of a canvas that is not empty. The result is a
// reference: the pixel itself, not a copy, valid for as long as the canvas lives.
// Star: if several pixels are equally large, return the first of them.
template <class Pixel>
const Pixel& largest(const Canvas<Pixel>& canvas) {
    rt::todo("00.3", canvas);
}

}  // namespace rt
