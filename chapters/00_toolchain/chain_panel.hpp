#pragma once
// The panel that shows one chain of links twice: scattered in memory, and gathered.

#include <functional>
#include <rt/portable.hpp>
#include <vector>

#include "chains.hpp"
#include "panel.hpp"

namespace toolchain {

// A color that goes from blue through green and gold to rose as t goes from 0 to 1.
inline Color along_rainbow(Real t) {
    const Color colors[] = {sky_blue, mint, gold, rose};
    const Real place = std::clamp(t, Real(0), Real(1)) * 3;
    const int i = std::min(2, static_cast<int>(place));
    return mix(colors[i], colors[i + 1], place - static_cast<Real>(i));
}

// Draws the upper half of an ellipse from (from, base) to (to, base), or, if `height` is negative,
// the lower half.
inline void draw_arc(Figure& figure, Real from, Real to, Real base, Real height, Color color,
                     Real thickness, Real share) {
    const Real middle = (from + to) / 2, a = std::abs(to - from) / 2, b = std::abs(height);
    const app::Box around{middle - a - thickness, height > 0 ? base - b - thickness : base,
                          2 * (a + thickness), b + thickness};
    const auto distance = [&](Vec2 p) {
        // The distance from the ellipse, to first order: x^2 + y^2 - 1 divided by the length of its
        // gradient.
        const Real x = (p.x - middle) / a, y = (p.y - base) / b;
        const Real slope = rt::portable::hypot(x / a, y / b);
        return slope > 0 ? std::abs(x * x + y * y - 1) / (2 * slope) - thickness / 2 : infinity;
    };
    figure.paint(
        around, distance, [&](Vec2) { return color; }, share);
}

// Draws each step of the chain as an arc from one link's position in memory to the next link's.
inline void draw_chain(Figure& figure, const app::Box& box) {
    draw_panel(figure, box, "One chain in two memories");
    const ScatteredChain chain{48};
    const std::vector<Link> links = gathered(chain.first());
    const Real left = box.left + 18, pitch = (box.width - 36) / 47, base = box.top + 152,
               lower = base + 30;
    const auto draw = [&](const std::vector<Link>& memory, Real line, Real sign) {
        // The positions of the chain's links, up to the first link that lies outside `memory`.
        std::vector<Real> places;
        const Link* link = memory.data();
        const std::less<const Link*> before;
        while (places.size() < memory.size() && link && !before(link, memory.data()) &&
               before(link, memory.data() + memory.size())) {
            places.push_back(left + pitch * static_cast<Real>(link - memory.data()));
            link = link->next;
        }
        const auto color = [&](std::size_t i) { return along_rainbow(static_cast<Real>(i) / 47); };
        for (std::size_t i = 1; i < places.size(); ++i) {
            const Real height = std::max<Real>(5, std::abs(places[i] - places[i - 1]) * Real(0.3));
            draw_arc(figure, places[i - 1], places[i], line, sign * height, color(i - 1), Real(1.2),
                     Real(0.85));
        }
        for (std::size_t i = 0; i < memory.size(); ++i)
            figure.box(
                {left + pitch * static_cast<Real>(i) - 3, sign > 0 ? line + 2 : line - 8, 6, 6},
                faint, Real(0.5), 1);
        for (std::size_t i = 0; i < places.size(); ++i)
            figure.box({places[i] - 3, sign > 0 ? line + 2 : line - 8, 6, 6}, color(i), 1, 1);
    };
    draw(chain.links, base, 1);
    draw(links, lower, -1);
    figure.words({left - 4, box.top + 28}, "Scattered", {6, ink});
    figure.words({left - 4, lower + 14}, "Gathered", {6, ink});
}

}  // namespace toolchain
