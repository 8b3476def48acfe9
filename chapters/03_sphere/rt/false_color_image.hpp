#pragma once
#include <iostream>
#include <rt/for_each_pixel.hpp>
#include <rt/tracer_call.hpp>

namespace rt {

// A tracer's picture in the false colors that --show asks for (given): compute(column, row) gives
// the Shown of each pixel. Prints the words that explain the colors.
template <class Compute>
Image false_color_image(const TracerCall& call, const SceneText& scene, const Compute& compute) {
    std::vector<Shown> pixels;
    for_each_pixel({0, 0, scene.width, scene.height},
                   [&](int x, int y) { pixels.push_back(compute(x, y)); });
    FalseColors made = false_colors(scene.width, scene.height, pixels, shown_words().at(call.show));
    std::cout << made.words;
    return std::move(made.image);
}

}  // namespace rt
