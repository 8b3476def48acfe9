#pragma once
#include <algorithm>
#include <any>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <rt/color.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rt {

// A picture as a value: width x height colors in linear light. Pixel (0, 0) is at the top left, x
// grows to the right and y grows downward. Copying copies all the pixels.
//
// The pixels belong to the object that the image was made from, such as the Canvas<Color> of
// exercise 00.3. The image keeps that object, copies it when the image is copied, and destroys it
// when the image is destroyed.
class Image {
  public:
    Image() = default;

    // Throws std::invalid_argument unless both sides are at least 1.
    Image(int width, int height, Color fill = {}) : width_{width}, height_{height} {
        if (width < 1 || height < 1)
            throw std::invalid_argument("an image needs at least 1x1 pixels, not " +
                                        std::to_string(width) + "x" + std::to_string(height));
        own(std::vector<Color>(size(), fill));
    }

    // Takes over a canvas of colors by moving it: no pixel is copied.
    template <class Canvas>
    requires(!std::same_as<Canvas, Image> &&
             requires(Canvas canvas) {
                 { canvas.width() } -> std::same_as<int>;
                 { canvas.begin() } -> std::same_as<Color*>;
             }) Image(Canvas canvas)
        : width_{canvas.width()}, height_{canvas.height()} {
        own(std::move(canvas));
    }

    Image(const Image& other)
        : width_{other.width_}, height_{other.height_}, owner_{other.owner_}, find_{other.find_} {
        if (find_) pixels_ = find_(owner_);
    }
    Image(Image&& other) noexcept
        : width_{std::exchange(other.width_, 0)},
          height_{std::exchange(other.height_, 0)},
          owner_{std::move(other.owner_)},
          find_{std::exchange(other.find_, nullptr)} {
        other.pixels_ = nullptr;
        if (find_) pixels_ = find_(owner_);
    }
    Image& operator=(Image other) noexcept {
        width_ = other.width_;
        height_ = other.height_;
        owner_.swap(other.owner_);
        find_ = other.find_;
        pixels_ = find_ ? find_(owner_) : nullptr;
        return *this;
    }
    ~Image() = default;

    int width() const { return width_; }
    int height() const { return height_; }

    // The pixel in column x of row y. It must lie inside the image (the debug build checks that).
    Color& at(int x, int y) { return pixels_[index(x, y)]; }
    const Color& at(int x, int y) const { return pixels_[index(x, y)]; }

    // All pixels, row by row from the top.
    std::span<const Color> pixels() const { return {pixels_, size()}; }

    friend bool operator==(const Image& a, const Image& b) {
        const auto one = a.pixels(), other = b.pixels();
        return a.width_ == b.width_ && a.height_ == b.height_ &&
               std::equal(one.begin(), one.end(), other.begin());
    }

  private:
    template <class Owner>
    void own(Owner owner) {
        owner_ = std::move(owner);
        find_ = [](std::any& any) { return &*std::any_cast<Owner&>(any).begin(); };
        pixels_ = find_(owner_);
    }

    std::size_t size() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }
    std::size_t index(int x, int y) const {
        assert(0 <= x && x < width_ && 0 <= y && y < height_);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    int width_ = 0, height_ = 0;
    std::any owner_;                       // holds the pixels
    Color* (*find_)(std::any&) = nullptr;  // finds the pixels in the owner
    Color* pixels_ = nullptr;
};

// Calls shade(x, y) for every pixel and stores the color that it returns. Pixels is the type that
// holds the pixels, such as Canvas<Color>.
template <class Pixels = Image, class Shade>
Image make_image(int width, int height, Shade shade) {
    Image image = Pixels(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = shade(x, y);
            assert(is_finite(image.at(x, y)));
        }
    return image;
}

}  // namespace rt
