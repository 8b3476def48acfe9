#pragma once
// Words in a picture. Letters are made of straight strokes, so that they stay sharp at any size.

#include <algorithm>
#include <cmath>
#include <rt/portable.hpp>
#include <rt/real.hpp>
#include <rt/vec2.hpp>
#include <string_view>

namespace app {

// The strokes of a letter on a grid of 3 columns and 5 rows, whose 15 points are called a, b, c in
// the top row to m, n, o at the bottom. A blank lifts the pen. There are capital letters, digits,
// some signs, and * for the sign of a degree; anything else is a gap.
inline std::string_view strokes(char letter) {
    constexpr std::string_view capitals[] = {
        "mgbio gi", "abfhklnma gh", "camo",     "abilnma",  "camo gh", "cam gh", "camoih",
        "am co gi", "bn",           "conj",     "am cgo",   "amo",     "mahco",  "maoc",
        "acoma",    "macig",        "acoma ko", "macig ho", "cagiom",  "ac bn",  "amoc",
        "anc",      "amhoc",        "ao cm",    "ahc hn",   "acmo"};
    constexpr std::string_view digits[] = {"acoma",  "dbn mo", "acigmo", "acom gi",  "agi co",
                                           "cagiom", "camoig", "acn",    "acoma gi", "igacom"};
    if ('A' <= letter && letter <= 'Z') return capitals[letter - 'A'];
    if ('0' <= letter && letter <= '9') return digits[letter - '0'];
    switch (letter) {
        case '*':
            return "abeda";
        case '-':
            return "gi";
        case '+':
            return "gi ek";
        case '=':
            return "df jl";
        case '/':
            return "mc";
        case '.':
            return "nn";
        case ':':
            return "ee kk";
        default:
            return "";
    }
}

inline rt::Real distance_to_segment(rt::Vec2 p, rt::Vec2 a, rt::Vec2 b) {
    const rt::Vec2 along{b.x - a.x, b.y - a.y}, to_p{p.x - a.x, p.y - a.y};
    const rt::Real squared = along.x * along.x + along.y * along.y;
    const rt::Real t = squared > 0 ? (to_p.x * along.x + to_p.y * along.y) / squared : 0;
    const rt::Real s = std::clamp(t, rt::Real(0), rt::Real(1));
    return rt::portable::hypot(to_p.x - s * along.x, to_p.y - s * along.y);
}

inline constexpr rt::Real letter_advance = rt::Real(3.4);  // from one letter to the next

// The distance from p to the nearest stroke of a text. The first letter's box reaches from (0, 0)
// at its top left to (2, 4); y grows downward.
inline rt::Real distance_to_text(rt::Vec2 p, std::string_view text) {
    const auto corner = [](char name, rt::Real left) {
        const int i = name - 'a';
        return rt::Vec2{left + static_cast<rt::Real>(i % 3), static_cast<rt::Real>(i / 3)};
    };
    rt::Real nearest = rt::infinity, left = 0;
    for (const char letter : text) {
        const std::string_view path = strokes(letter);
        for (std::size_t i = 1; i < path.size(); ++i)
            if (path[i - 1] != ' ' && path[i] != ' ')
                nearest = std::min(nearest, distance_to_segment(p, corner(path[i - 1], left),
                                                                corner(path[i], left)));
        left += letter_advance;
    }
    return nearest;
}

}  // namespace app
