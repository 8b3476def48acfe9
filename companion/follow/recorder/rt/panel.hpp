#pragma once
#include <app/figure.hpp>
#include <rt/trail.hpp>

namespace app {

inline void begin_panel(const Figure& panel) {
    rt::follow::trail().begin_panel(panel.left(), panel.top());
}

}  // namespace app
