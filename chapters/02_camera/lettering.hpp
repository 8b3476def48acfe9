#pragma once
// Letters made of straight strokes, so that they stay sharp at any size.

#include <algorithm>
#include <cmath>
#include <rt/real.hpp>
#include <rt/vec2.hpp>
#include <string_view>

namespace lettering {

using rt::Real;
using rt::Vec2;

// The strokes of a letter on a grid of 3 columns and 5 rows, whose 15 points are called a, b, c in
// the top row to m, n, o at the bottom. A blank lifts the pen.
inline std::string_view strokes(char letter) {
    switch (letter) {
        case '0':
            return "acoma";
        case '1':
            return "dbn mo";
        case '2':
            return "acigmo";
        case '3':
            return "acom gi";
        case '4':
            return "agi co";
        case '5':
            return "cagiom";
        case '6':
            return "camoig";
        case '7':
            return "acn";
        case '8':
            return "acoma gi";
        case '9':
            return "igacom";
        case '*':
            return "abeda";  // stands for the sign of a degree
        case 'A':
            return "mgbio gi";
        case 'D':
            return "abilnma";
        case 'E':
            return "camo gh";
        case 'F':
            return "cam gh";
        case 'G':
            return "camoih";
        case 'H':
            return "am co gi";
        case 'I':
            return "bn";
        case 'L':
            return "amo";
        case 'N':
            return "maoc";
        case 'O':
            return "acoma";
        case 'P':
            return "macig";
        case 'R':
            return "macig ho";
        case 'S':
            return "cagiom";
        case 'T':
            return "ac bn";
        case 'U':
            return "amoc";
        case 'V':
            return "anc";
        case 'W':
            return "amhoc";
        default:
            return "";
    }
}

inline Real distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along{b.x - a.x, b.y - a.y}, to_p{p.x - a.x, p.y - a.y};
    const Real t = (to_p.x * along.x + to_p.y * along.y) / (along.x * along.x + along.y * along.y);
    const Real s = std::clamp(t, Real(0), Real(1));
    return std::hypot(to_p.x - s * along.x, to_p.y - s * along.y);
}

inline constexpr Real advance = Real(3.4);  // from one letter to the next

// The distance from p to the nearest stroke of a text. The first letter's box reaches from (0, 0)
// at its top left to (2, 4); y grows downwards.
inline Real distance_to_text(Vec2 p, std::string_view text) {
    const auto corner = [](char name, Real left) {
        const int i = name - 'a';
        return Vec2{left + static_cast<Real>(i % 3), static_cast<Real>(i / 3)};
    };
    Real nearest = rt::infinity, left = 0;
    for (const char letter : text) {
        const std::string_view path = strokes(letter);
        for (std::size_t i = 1; i < path.size(); ++i)
            if (path[i - 1] != ' ' && path[i] != ' ')
                nearest = std::min(nearest, distance_to_segment(p, corner(path[i - 1], left),
                                                                corner(path[i], left)));
        left += advance;
    }
    return nearest;
}

}  // namespace lettering
