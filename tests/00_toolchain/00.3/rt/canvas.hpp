#pragma once
#include <concepts>
#include <cstddef>
#include <memory>

#include "../../watched.hpp"

namespace answer {

using checkpoint::WatchedPixel;

// The learner's canvas, and a std::vector of such.
struct Own;
struct OwnVector;

Own* make(int width, int height);
Own* make(int width, int height, const WatchedPixel& fill);
Own* make_copy(const Own& other);
Own* make_moved(Own& other);
void destroy(Own* canvas);
bool assign(Own& to, const Own& from);  // whether the result is `to` itself
bool assign_moved(Own& to, Own& from);

int width(const Own& canvas);
int height(const Own& canvas);
std::size_t size(const Own& canvas);
WatchedPixel& at(Own& canvas, int x, int y);
const WatchedPixel& at(const Own& canvas, int x, int y);
WatchedPixel* begin(Own& canvas);
const WatchedPixel* begin(const Own& canvas);
WatchedPixel* end(Own& canvas);
const WatchedPixel* end(const Own& canvas);

Own* flipped(const Own& canvas);
Own* flipped_moved(Own& canvas);
const WatchedPixel* largest(Own& canvas);

OwnVector* make_vector();
void destroy_vector(OwnVector* canvases);
void push_back_moved(OwnVector& canvases, Own& canvas);
Own& element(OwnVector& canvases, std::size_t i);

// A canvas of watched pixels, as the test cases use it. Whatever they do to it is done to the
// learner's.
class Canvas {
  public:
    explicit Canvas(Own* own, void (*give_back)(Own*) = destroy) : own_{own, give_back} {}
    Canvas(int width, int height) : Canvas{make(width, height)} {}
    Canvas(int width, int height, const WatchedPixel& fill) : Canvas{make(width, height, fill)} {}
    Canvas(const Canvas& other) : Canvas{make_copy(other.own())} {}
    Canvas(Canvas&& other) : Canvas{make_moved(other.own())} {}
    Canvas& operator=(const Canvas& other) { return result(assign(own(), other.own())); }
    Canvas& operator=(Canvas&& other) { return result(assign_moved(own(), other.own())); }

    int width() const { return answer::width(own()); }
    int height() const { return answer::height(own()); }
    std::size_t size() const { return answer::size(own()); }
    WatchedPixel& at(int x, int y) { return answer::at(own(), x, y); }
    const WatchedPixel& at(int x, int y) const { return answer::at(own(), x, y); }
    WatchedPixel* begin() { return answer::begin(own()); }
    const WatchedPixel* begin() const { return answer::begin(own()); }
    WatchedPixel* end() { return answer::end(own()); }
    const WatchedPixel* end() const { return answer::end(own()); }

    Own& own() { return *own_; }
    const Own& own() const { return *own_; }

  private:
    Canvas& result(bool is_itself) {
        if (is_itself) return *this;
        static Canvas another{nullptr};
        return another;
    }

    std::unique_ptr<Own, void (*)(Own*)> own_;
};

inline Canvas flipped(const Canvas& canvas) {
    return Canvas{flipped(canvas.own())};
}
inline Canvas flipped(Canvas&& canvas) {
    return Canvas{flipped_moved(canvas.own())};
}
inline const WatchedPixel& largest(Canvas& canvas) {
    return *largest(canvas.own());
}

// How the vector brings its canvases to more memory depends on the learner's type.
class CanvasVector {
  public:
    void push_back(Canvas&& canvas) { push_back_moved(*own_, canvas.own()); }
    Canvas operator[](std::size_t i) const {
        return Canvas{&element(*own_, i), [](Own*) {}};  // it stays in the vector
    }

  private:
    std::unique_ptr<OwnVector, void (*)(OwnVector*)> own_{make_vector(), destroy_vector};
};

}  // namespace answer

namespace rt {

template <std::same_as<answer::WatchedPixel> Pixel>
using Canvas = answer::Canvas;
using answer::flipped;
using answer::largest;

}  // namespace rt
