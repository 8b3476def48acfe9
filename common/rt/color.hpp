#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <rt/portable.hpp>
#include <rt/real.hpp>

namespace rt {

// Linear light in red, green and blue: twice the number means twice the light. 0 is black, and 1 is
// the brightest that an image file can store; light itself has no upper limit.
struct Color {
    Real r = 0, g = 0, b = 0;

    friend constexpr bool operator==(const Color&, const Color&) = default;

    [[nodiscard]] friend constexpr Color operator+(Color p, Color q) {
        return {p.r + q.r, p.g + q.g, p.b + q.b};
    }
    [[nodiscard]] friend constexpr Color operator-(Color p, Color q) {
        return {p.r - q.r, p.g - q.g, p.b - q.b};
    }
    [[nodiscard]] friend constexpr Color operator*(Color p, Color q) {
        return {p.r * q.r, p.g * q.g, p.b * q.b};
    }
    [[nodiscard]] friend constexpr Color operator*(Color c, Real s) {
        return {c.r * s, c.g * s, c.b * s};
    }
    [[nodiscard]] friend constexpr Color operator*(Real s, Color c) { return c * s; }
    [[nodiscard]] friend constexpr Color operator/(Color c, Real s) {
        return {c.r / s, c.g / s, c.b / s};
    }

    constexpr Color& operator+=(Color c) { return *this = *this + c; }
    constexpr Color& operator*=(Color c) { return *this = *this * c; }
    constexpr Color& operator*=(Real s) { return *this = *this * s; }
    constexpr Color& operator/=(Real s) { return *this = *this / s; }

    friend std::ostream& operator<<(std::ostream& out, Color c) {
        return out << "rgb(" << c.r << ", " << c.g << ", " << c.b << ')';
    }
};

inline bool is_finite(Color c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

// Linear interpolation: a at t = 0, b at t = 1.
constexpr Color mix(Color a, Color b, Real t) {
    return (1 - t) * a + t * b;
}

// The sRGB transfer function: linear light in [0, 1] to the value that an image file stores, in
// [0, 1]. Light outside of [0, 1] is clamped. Source: IEC 61966-2-1.
inline Real srgb_encode(Real linear) {
    const Real x = std::clamp(linear, Real(0), Real(1));
    if (x <= Real(0.0031308)) return Real(12.92) * x;
    return Real(1.055) * portable::pow(x, 1 / Real(2.4)) - Real(0.055);
}

// The inverse function: from a stored value in [0, 1] to linear light.
inline Real srgb_decode(Real stored) {
    const Real x = std::clamp(stored, Real(0), Real(1));
    if (x <= Real(0.04045)) return x / Real(12.92);
    return portable::pow((x + Real(0.055)) / Real(1.055), Real(2.4));
}

// The byte, 0 to 255, that stands for this much linear light in an image file. Light outside of
// [0, 1] is clamped.
inline std::uint8_t to_byte(Real linear) {
    return static_cast<std::uint8_t>(std::lround(255 * srgb_encode(linear)));
}

// A color as a designer writes it: sRGB bytes 0xRRGGBB, turned into linear light.
inline Color from_hex(std::uint32_t rrggbb) {
    const auto channel = [&](int shift) {
        return srgb_decode(static_cast<Real>((rrggbb >> shift) & 255) / 255);
    };
    return {channel(16), channel(8), channel(0)};
}

}  // namespace rt
