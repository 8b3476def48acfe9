// Prints a scene of 10,000 spheres, coiled into a snail shell: the loop is main(). Change it, and
// make a scene of your own:
//
//     g++ -std=c++20 many.cpp -o many && ./many >many.txt

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

constexpr double pi = std::numbers::pi;

// The scene was first made with random.Random(9) of Python. This is the same generator, the
// Mersenne Twister, with Python's way to begin and to make numbers from its bits: so the scene and
// its picture stay the same.
class Chance {
  public:
    // From 0 to below 1, in steps of 2^-53.
    double uniform() {
        const double high = static_cast<double>(bits_() >> 5),
                     low = static_cast<double>(bits_() >> 6);
        return (high * 67108864 + low) / 9007199254740992;
    }

    // Normal, with mean 0 and deviation 1. Source: Box and Muller, 1958. Two come at once; one
    // waits.
    double normal() {
        if (const auto waiting = std::exchange(next_, {})) return *waiting;
        const double angle = 2 * pi * uniform(), length = std::sqrt(-2 * std::log(1 - uniform()));
        next_ = std::sin(angle) * length;
        return std::cos(angle) * length;
    }

    // 0, 1 or 2.
    unsigned one_of_three() {
        std::uint32_t two_bits = bits_() >> 30;
        while (two_bits == 3) two_bits = bits_() >> 30;
        return two_bits;
    }

  private:
    // Source: Matsumoto and Nishimura, mt19937ar.c, init_by_array() with the one key 9.
    struct Seeds {
        using result_type = std::uint32_t;

        template <class Word>
        void generate(Word first, Word last) const {
            const auto count = static_cast<std::uint32_t>(last - first);
            first[0] = 19650218;
            for (std::uint32_t i = 1; i < count; ++i)
                first[i] = 1812433253 * mixed(first[i - 1]) + i;
            std::uint32_t i = 1;
            const auto step = [&](std::uint32_t factor, std::uint32_t add) {
                first[i] = (first[i] ^ mixed(first[i - 1]) * factor) + add;
                if (++i < count) return;
                first[0] = first[count - 1];
                i = 1;
            };
            for (std::uint32_t k = 0; k < count; ++k) step(1664525, 9);
            for (std::uint32_t k = 1; k < count; ++k) step(1566083941, -i);
            first[0] = 1u << 31;
        }

        static std::uint32_t mixed(std::uint32_t word) { return word ^ word >> 30; }
    };

    Seeds seeds_;
    std::mt19937 bits_{seeds_};
    std::optional<double> next_;
};

int main() {
    std::puts(
        "# 10,000 spheres, coiled into a snail shell.\n"
        "picture 640 360 32 50\n"
        "camera -4 8.5 22  0 0 0  0 1 0  34 0.25 20\n"
        "sky     1 0.8 0.6  0.35 0.55 1\n"
        "matte   0.6 0.58 0.56\n"
        "sphere  0 -1003 0 1000");
    Chance chance;
    constexpr int count = 9999;
    for (int i = 0; i < count; ++i) {
        // The coil winds outward and down, in 14 turns; the spheres lie around it by chance.
        const double t = static_cast<double>(i) / count, turn = 14 * 2 * pi * t, out = 0.6 + 13 * t;
        const double spread = 0.175 + 0.25 * t, top = -2.8 + 5.5 * (1 - t) * (1 - t);
        const double x = out * std::cos(turn) + spread * chance.normal();
        const double z = out * std::sin(turn) + spread * chance.normal();
        const double y = top + std::abs(0.35 * chance.normal());
        const double radius = (0.05 + 0.09 * chance.uniform()) * (1 + 0.6 * t);

        const double kind = chance.uniform();
        std::array<double, 3> color;
        for (int c = 0; c < 3; ++c) color[c] = 0.55 + 0.4 * std::cos(3 * pi * t + 2.1 * c);
        if (kind < 0.75) {
            std::printf("matte %.3f %.3f %.3f\n", color[0], color[1], color[2]);
        } else if (kind < 0.92) {
            for (double& one : color) one = 0.6 + 0.4 * one;
            const double fuzz = std::array{0.0, 0.1, 0.3}[chance.one_of_three()];
            std::printf("metal %.3f %.3f %.3f %.2f\n", color[0], color[1], color[2], fuzz);
        } else {
            std::puts("glass 1.5");
        }
        std::printf("sphere %.3f %.3f %.3f %.3f\n", x, y, z, radius);
    }
}
