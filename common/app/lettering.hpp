#pragma once
// Words in a picture. Letters are made of straight strokes, so that they stay sharp at any size.

#include <algorithm>
#include <cmath>
#include <rt/portable.hpp>
#include <rt/real.hpp>
#include <rt/vec2.hpp>
#include <string_view>

namespace app {

// The strokes of a letter. Each point is written as a digit, its column, and a letter, its row.
// Capitals reach from row a to row q; small letters such as x reach from row f to row q, and those
// such as p down to row u. A blank lifts the pen. There are letters, digits, some signs, and * for
// the degree sign; anything else is a gap.
inline std::string_view strokes(char letter) {
    constexpr std::string_view capitals[] = {"0q4a8q 1l7l",
                                             "0a0q5q7p8n8l7j5i0i 5i6h7f7d6b5a0a",
                                             "8d7b5a3a1b0e0m1p3q5q7p8n",
                                             "0a0q4q7o8m8e7c4a0a",
                                             "7a0a0q7q 0i6i",
                                             "7a0a0q 0i6i",
                                             "8d7b5a3a1b0e0m1p3q5q7p8m8j5j",
                                             "0a0q 8a8q 0i8i",
                                             "0a4a 2a2q 0q4q",
                                             "6a6n5p4q2q1p0n",
                                             "0a0q 8a0k 3g8q",
                                             "0a0q7q",
                                             "0q0a4k8a8q",
                                             "0q0a8q8a",
                                             "3a5a7b8e8m7p5q3q1p0m0e1b3a",
                                             "0q0a5a7b8d8f7h5i0i",
                                             "3a5a7b8e8m7p5q3q1p0m0e1b3a 5m8q",
                                             "0q0a5a7b8d8f7h5i0i 4i8q",
                                             "8d7b5a3a1b0d0f1h7j8l8n7p5q3q1p0n",
                                             "0a8a 4a4q",
                                             "0a0m1p3q5q7p8m8a",
                                             "0a4q8a",
                                             "0a2q4f6q8a",
                                             "0a8q 8a0q",
                                             "0a4i8a 4i4q",
                                             "0a8a0q8q"};
    constexpr std::string_view small[] = {"1g2f5f6g7i7q 7k2k1l0m0o1p2q5q7o",
                                          "0a0q 0h2f5f6g7i7n6p5q2q0o",
                                          "7h5f2f1g0i0n1p2q5q7o",
                                          "7a7q 7h5f2f1g0i0n1p2q5q7o",
                                          "0k7k7i6g5f2f1g0i0n1p2q5q7o",
                                          "5a4a3b2d2q 0f5f",
                                          "7f7s6t5u2u0t 7h5f2f1g0i0m1o2p5p7n",
                                          "0a0q 0h2f5f6g7i7q",
                                          "1f1q 1b1b",
                                          "3f3s2u0u 3b3b",
                                          "0a0q 6f0m 2k7q",
                                          "1a1o2q3q",
                                          "0f0q 0h2f3f4h4q 4h6f7f8h8q",
                                          "0f0q 0h2f5f6g7i7q",
                                          "2f5f6g7i7n6p5q2q1p0n0i1g2f",
                                          "0f0u 0h2f5f6g7i7n6p5q2q0o",
                                          "7f7u 7h5f2f1g0i0n1p2q5q7o",
                                          "0f0q 0i2f4f5g",
                                          "7h6f2f0g0i1k6l7m7o5q2q0o",
                                          "2b2o3q5q 0f5f",
                                          "0f0n1p2q5q7o 7f7q",
                                          "0f4q8f",
                                          "0f2q4h6q8f",
                                          "0f7q 7f0q",
                                          "0f4q 8f4q3t2u0u",
                                          "0f7f0q7q"};
    constexpr std::string_view digits[] = {"2a5a6b7e7m6p5q2q1p0m0e1b2a",
                                           "1d4a4q 1q7q",
                                           "0d1b2a5a6b7d7f6h0q7q",
                                           "0c2a5a6b7d7f6h5i2i 5i6j7l7n6p5q2q0o",
                                           "5q5a0l8l",
                                           "7a1a0i2g5g6h7j7n6p5q2q0o",
                                           "6b5a2a1b0e0n1p2q5q6p7n7j6h5g2g0i",
                                           "0a7a3q",
                                           "2a5a6b7d7f5i2i0f0d1b2a 2i0l0n1p2q5q6p7n7l5i",
                                           "1p2q5q6p7m7d6b5a2a1b0d0h1j2k5k7i"};
    if ('A' <= letter && letter <= 'Z') return capitals[letter - 'A'];
    if ('a' <= letter && letter <= 'z') return small[letter - 'a'];
    if ('0' <= letter && letter <= '9') return digits[letter - '0'];
    switch (letter) {
        case '*':
            return "1a3a4b4d3e1e0d0b1a";
        case '-':
            return "0j5j";
        case '+':
            return "0j6j 3g3m";
        case '=':
            return "0h6h 0l6l";
        case '/':
            return "0q6a";
        case '.':
            return "1q1q";
        case ',':
            return "1q0s";
        case ':':
            return "1h1h 1q1q";
        default:
            return "";
    }
}

// A point of strokes(). Capitals are 4 units high, so rows and columns are a quarter of a unit
// apart.
inline rt::Vec2 stroke_point(std::string_view strokes, std::size_t i) {
    return {static_cast<rt::Real>(strokes[i] - '0') / 4,
            static_cast<rt::Real>(strokes[i + 1] - 'a') / 4};
}

inline constexpr rt::Real letter_gap = rt::Real(1.3), descent = 1;

// How wide a letter is, up to 2.
inline rt::Real width_of(char letter) {
    int last = letter == ' ' ? 2 : 0;
    for (const char c : strokes(letter))
        if ('0' <= c && c <= '9') last = std::max(last, c - '0');
    return static_cast<rt::Real>(last) / 4;
}

// How wide a text is: from the first letter's left edge to the last one's right edge.
inline rt::Real width_of(std::string_view text) {
    rt::Real width = text.empty() ? 0 : -letter_gap;
    for (const char letter : text) width += width_of(letter) + letter_gap;
    return width;
}

// The vector to p from the nearest point of the line from a to b.
inline rt::Vec2 from_segment(rt::Vec2 p, rt::Vec2 a, rt::Vec2 b) {
    const rt::Vec2 along{b.x - a.x, b.y - a.y}, to_p{p.x - a.x, p.y - a.y};
    const rt::Real squared = along.x * along.x + along.y * along.y;
    const rt::Real t = squared > 0 ? (to_p.x * along.x + to_p.y * along.y) / squared : 0;
    const rt::Real s = std::clamp(t, rt::Real(0), rt::Real(1));
    return {to_p.x - s * along.x, to_p.y - s * along.y};
}
inline rt::Real distance_to_segment(rt::Vec2 p, rt::Vec2 a, rt::Vec2 b) {
    const rt::Vec2 apart = from_segment(p, a, b);
    return rt::portable::hypot(apart.x, apart.y);
}

// The distance from p to the nearest stroke of a text. The first letter begins at x = 0. Capitals
// reach from y = 0 to y = 4; y grows downward.
inline rt::Real distance_to_text(rt::Vec2 p, std::string_view text) {
    rt::Real nearest = rt::infinity;  // squared
    for (const char letter : text) {
        const rt::Real width = width_of(letter);
        const rt::Real beside = std::max({-p.x, p.x - width, rt::Real(0)});
        const std::string_view path = strokes(letter);
        if (beside * beside < nearest)
            for (std::size_t i = 0; i + 4 <= path.size(); i += 2) {
                if (path[i] == ' ') ++i;
                if (path[i + 2] == ' ') continue;
                const rt::Vec2 apart =
                    from_segment(p, stroke_point(path, i), stroke_point(path, i + 2));
                nearest = std::min(nearest, apart.x * apart.x + apart.y * apart.y);
            }
        p.x -= width + letter_gap;
    }
    return std::sqrt(nearest);
}

}  // namespace app
