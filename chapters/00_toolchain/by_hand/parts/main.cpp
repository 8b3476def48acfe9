#include <iostream>

#include "shade.hpp"

int main() {
    std::cout << "P3\n256 256\n255\n";
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            std::cout << shade(x, y, 0) << ' ' << shade(x, y, 1) << ' ' << shade(x, y, 2) << '\n';
}
