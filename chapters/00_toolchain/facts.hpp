#pragma once
// Lines of text that show, with the values of this run, what the chapter explains.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <rt/binary_tree.hpp>
#include <rt/canvas.hpp>
#include <rt/color.hpp>
#include <rt/range_node.hpp>
#include <string>

#include "address_map.hpp"

namespace toolchain {

using namespace rt;

// A type that counts how many of its objects exist.
struct Counted {
    inline static int alive = 0;
    Counted() { ++alive; }
    Counted(const Counted&) { ++alive; }
    Counted& operator=(const Counted&) = default;
    ~Counted() { --alive; }
};

inline Canvas<Real> lightness(const Canvas<Color>& canvas) {
    Canvas<Real> light{canvas.width(), canvas.height()};
    std::transform(canvas.begin(), canvas.end(), light.begin(),
                   [](const Color& c) { return c.r + c.g + c.b; });
    return light;
}

inline std::string printed(const char* format, auto... values) {
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

// Lines of text about a reference, values that are destroyed at the end of their block, a
// unique_ptr, and a tree.
inline std::string facts(std::unique_ptr<RangeNode> root, const Canvas<Color>& canvas) {
    std::string text;
    const Canvas<Real> light = lightness(canvas);
    const Real& lightest = largest(light);
    const auto index = static_cast<int>(&lightest - light.begin());
    text += printed(
        "A reference   lightest is another name for pixel (%d, %d): its address is the "
        "pixel's, %s\n",
        index % light.width(), index / light.width(), hex(&lightest).c_str());
    const int before = Counted::alive;
    int inside = 0;
    {
        const Canvas<Counted> twelve{4, 3};
        inside = Counted::alive;
    }
    text += printed(
        "RAII          pixels alive: %d before the block, %d inside, %d after its "
        "closing brace\n",
        before, inside, Counted::alive);
    const void* const held = root.get();
    const std::unique_ptr<RangeNode> owner = std::move(root);
    text += printed("A unique_ptr  root held %s; moved from, it holds %s, and its new owner %s\n",
                    hex(held).c_str(), hex(root.get()).c_str(), hex(owner.get()).c_str());
    text += printed("A tree        over %d things has %d nodes and is %d deep\n",
                    owner ? owner->last - owner->first : 0, count_nodes(owner.get()),
                    depth_of(owner.get()));
    return text;
}

}  // namespace toolchain
