// One file, one program: it prints a picture, as a text that image viewers understand.
#include <iostream>

#define SIDE 256

// Red grows to the right, green grows downward, blue is constant.
int shade(int x, int y, int channel) {
    const int color[3] = {x, y, 96};
    return color[channel];
}

int main() {
    std::cout << "P3\n" << SIDE << ' ' << SIDE << "\n255\n";
    for (int y = 0; y < SIDE; ++y)
        for (int x = 0; x < SIDE; ++x)
            std::cout << shade(x, y, 0) << ' ' << shade(x, y, 1) << ' ' << shade(x, y, 2) << '\n';
}
