#pragma once
// How worker.js calls the figures of a chapter. book/live.mjs makes a source that includes the
// chapter's figures, then this, and defines live_figures.

#include <array>
#include <cstddef>
#include <cstdlib>
#include <rt/todo.hpp>

#include "live.hpp"

namespace live {

constexpr std::size_t most_controls = 32;
using Values = std::array<double, most_controls>;

struct Figure {
    void (*draw)(const Values&, Drawing&);
    void (*drag)(Values&, const Drag&);
};

// The controls are a struct of nothing but numbers.
template <class Controls>
Controls from_values(const Values& values) {
    static_assert(sizeof(Controls) <= sizeof(Values));
    Controls controls;
    std::copy_n(values.begin(), sizeof(Controls) / sizeof(double),
                reinterpret_cast<double*>(&controls));
    return controls;
}

template <class Controls>
constexpr Figure figure() {
    return {[](const Values& values, Drawing& out) { draw(from_values<Controls>(values), out); },
            [](Values& values, const Drag& to) {
                if constexpr (requires(Controls controls) { drag(controls, to); }) {
                    Controls controls = from_values<Controls>(values);
                    drag(controls, to);
                    std::copy_n(reinterpret_cast<const double*>(&controls),
                                sizeof(Controls) / sizeof(double), values.begin());
                }
            }};
}

}  // namespace live

extern const live::Figure live_figures[];
extern const int live_count;

namespace live {
inline Drawing& drawing(int figure) {
    static std::vector<Drawing> all(static_cast<std::size_t>(live_count));
    return all[static_cast<std::size_t>(figure)];
}
inline Values values;
}  // namespace live

#ifdef __EMSCRIPTEN__
#define LIVE_EXPORT(name) __attribute__((export_name(#name))) name
#else
#define LIVE_EXPORT(name) name
#endif

extern "C" {
double* LIVE_EXPORT(live_values)() {
    return live::values.data();
}
void LIVE_EXPORT(live_draw)(int figure, double width, double pixel_ratio) {
    live::Drawing& out = live::drawing(figure);
    out.start(width, pixel_ratio);
    live_figures[figure].draw(live::values, out);
}
void LIVE_EXPORT(live_drag)(int figure, double x0, double y0, double x, double y, double width) {
    live_figures[figure].drag(live::values, {{x0, y0}, {x, y}, width});
}
// After live_draw: of `parts` workers that refine the same picture, this is number `part`.
void LIVE_EXPORT(live_take)(int figure, int part, int parts) {
    if (live::Refinement* refinement = live::drawing(figure).refinement())
        refinement->take(part, parts);
}
// Where the picture is that gets better.
const std::uint8_t* LIVE_EXPORT(live_refined)(int figure) {
    const live::Refinement* refinement = live::drawing(figure).refinement();
    return refinement ? refinement->bytes().rgba.data() : nullptr;
}
int LIVE_EXPORT(live_more)(int figure) {
    live::Refinement* refinement = live::drawing(figure).refinement();
    return refinement && refinement->more();
}
int LIVE_EXPORT(live_done)(int figure) {
    const live::Refinement* refinement = live::drawing(figure).refinement();
    return refinement ? refinement->done() : 0;
}
int LIVE_EXPORT(live_samples)(int figure) {
    const live::Refinement* refinement = live::drawing(figure).refinement();
    return refinement ? refinement->samples() : 0;
}
// The mean light of a refined picture, in green only.
double LIVE_EXPORT(live_mean)(int figure) {
    return static_cast<double>(live::drawing(figure).refinement()->mean().g);
}
double LIVE_EXPORT(live_height)(int figure) {
    return live::drawing(figure).height;
}
const double* LIVE_EXPORT(live_list)(int figure) {
    return live::drawing(figure).list().data();
}
std::size_t LIVE_EXPORT(live_list_size)(int figure) {
    return live::drawing(figure).list().size();
}
const char* LIVE_EXPORT(live_words)(int figure) {
    return live::drawing(figure).words().data();
}
std::size_t LIVE_EXPORT(live_words_size)(int figure) {
    return live::drawing(figure).words().size();
}
}

// A program would name the exercise that is not written yet. Here the page keeps the still picture.
[[noreturn]] void rt::detail::throw_not_implemented(const ExerciseId&) {
    std::abort();
}
