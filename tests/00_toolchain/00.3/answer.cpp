#include <answer.hpp>
#include <rt/canvas.hpp>

#include "watched.hpp"

namespace answer {

using checkpoint::WatchedPixel;

struct Own {
    rt::Canvas<WatchedPixel> canvas;
};
struct OwnVector {
    std::vector<Own> canvases;
};

}  // namespace answer

namespace answer EXPORTED {

void report_to(const checkpoint::Listener& listener) {
    checkpoint::listener = listener;
}

Own* make(int width, int height) {
    return new Own{rt::Canvas<WatchedPixel>{width, height}};
}
Own* make(int width, int height, const WatchedPixel& fill) {
    return new Own{rt::Canvas<WatchedPixel>{width, height, fill}};
}
Own* make_copy(const Own& other) {
    return new Own{other.canvas};
}
Own* make_moved(Own& other) {
    return new Own{std::move(other.canvas)};
}
void destroy(Own* canvas) {
    delete canvas;
}
bool assign(Own& to, const Own& from) {
    return &(to.canvas = from.canvas) == &to.canvas;
}
bool assign_moved(Own& to, Own& from) {
    return &(to.canvas = std::move(from.canvas)) == &to.canvas;
}

int width(const Own& canvas) {
    return canvas.canvas.width();
}
int height(const Own& canvas) {
    return canvas.canvas.height();
}
std::size_t size(const Own& canvas) {
    return canvas.canvas.size();
}
WatchedPixel& at(Own& canvas, int x, int y) {
    return canvas.canvas.at(x, y);
}
const WatchedPixel& at(const Own& canvas, int x, int y) {
    return canvas.canvas.at(x, y);
}
WatchedPixel* begin(Own& canvas) {
    return canvas.canvas.begin();
}
const WatchedPixel* begin(const Own& canvas) {
    return canvas.canvas.begin();
}
WatchedPixel* end(Own& canvas) {
    return canvas.canvas.end();
}
const WatchedPixel* end(const Own& canvas) {
    return canvas.canvas.end();
}

Own* flipped(const Own& canvas) {
    return new Own{rt::flipped(canvas.canvas)};
}
Own* flipped_moved(Own& canvas) {
    return new Own{rt::flipped(std::move(canvas.canvas))};
}
const WatchedPixel* largest(Own& canvas) {
    return &rt::largest(canvas.canvas);
}

OwnVector* make_vector() {
    return new OwnVector;
}
void destroy_vector(OwnVector* canvases) {
    delete canvases;
}
void push_back_moved(OwnVector& canvases, Own& canvas) {
    canvases.canvases.push_back(std::move(canvas));
}
Own& element(OwnVector& canvases, std::size_t i) {
    return canvases.canvases[i];
}

}  // namespace EXPORTED
