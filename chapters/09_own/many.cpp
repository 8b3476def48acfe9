// Prints a scene of 10,000 spheres: a nautilus shell of beads on dark, smooth ground, and pearls
// around it. It has a loop for the beads and a loop for the pearls. Change them to make a scene of
// your own:
//
//     g++ -std=c++20 many.cpp -o many && ./many >many.txt

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

constexpr double pi = std::numbers::pi;

struct Color {
    double red, green, blue;
};

Color mix(Color a, Color b, double share) {
    const double rest = 1 - share;
    return {rest * a.red + share * b.red, rest * a.green + share * b.green,
            rest * a.blue + share * b.blue};
}

int main() {
    std::puts(
        "# 10,000 spheres: a nautilus shell of beads, and pearls around it.\n"
        "picture 640 360 32 50\n"
        "camera -21 10.5 62.7  1.9 9.6 0.5  0 1 0  25.5 1.5 61\n"
        "sky     1 0.8 0.6  0.2 0.5 1\n"
        "metal   0.2 0.25 0.36 0.01\n"
        "sphere  0 -20000 0 20000\n"
        "metal   1 0.8 0.5 0\n"
        "sphere  9.9 3 14 3");

    // A turn by the golden angle from one sphere to the next spreads them evenly, as in a
    // sunflower.
    const double golden_angle = pi * (3 - std::sqrt(5.0));
    constexpr int beads = 9000;
    for (int i = 0; i < beads; ++i) {
        // The beads cover a tube. It winds in a logarithmic spiral, and grows to three times its
        // size with each turn.
        const double age = static_cast<double>(i) / beads, turns = 2.6 * (age - 1);
        const double size = 10 * std::pow(3, turns), spiral = 2 * pi * turns + 0.26;
        const double around = i * golden_angle, out = 1 + 0.88 * std::cos(around);
        const double x = size * out * std::cos(spiral), y = size * out * std::sin(spiral) + 14.4;
        const double z = 0.8 * size * std::sin(around), radius = 0.052 * size * std::sqrt(out);

        // Each turn of the spiral has ten bands, warm and cool in turns, curved like the growing
        // edge of a shell.
        const double band = std::cos(2 * pi * (10 * turns - 0.4 * std::cos(around)));
        const double late = std::max(0.0, 2 * age - 1);
        const Color warm = mix({0.8, 0.02, 0.15}, {1, 0.6, 0.1}, late);
        const Color cool = mix({0.08, 0.03, 0.4}, {0, 0.6, 0.6}, late);
        const Color color = mix(warm, cool, std::clamp(0.5 + 1.5 * band, 0.0, 1.0));
        if (i % 3 == 0) {
            const Color bright = mix(color, {1, 1, 1}, 0.2);
            std::printf("metal %.3f %.3f %.3f 0.08\n", bright.red, bright.green, bright.blue);
        } else {
            std::printf("matte %.3f %.3f %.3f\n", color.red, color.green, color.blue);
        }
        std::printf("sphere %.3f %.3f %.3f %.3f\n", x, y, z, radius);
    }

    constexpr int pearls = 998;
    for (int i = 0; i < pearls; ++i) {
        const char* materials[] = {"glass 1.5", "metal 0.98 0.72 0.4 0", "metal 0.9 0.92 1 0.05",
                                   "matte 0.85 0.25 0.1", "matte 0.03 0.35 0.45"};
        const double out = 3 * std::sqrt(i + 60), around = i * golden_angle;
        // A sequence that looks random; its fourth power makes most pearls small.
        const double radius = 0.2 + 1.5 * std::pow(std::fmod(0.7548 * i, 1), 4);
        std::printf("%s\nsphere %.3f %.3f %.3f %.3f\n", materials[i % 5], out * std::cos(around),
                    radius, out * std::sin(around), radius);
    }
}
