#include "shade.hpp"

#define BLUE 96

// What it does: its definition.
int shade(int x, int y, int channel) {
    const int color[3] = {x, y, BLUE};
    return color[channel];
}
