#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <rt/real.hpp>

namespace rt {

template <class Number>
struct SineCosine {
    Number sine{}, cosine{};
};

// The Taylor coefficients of the sine and the cosine of 2 pi x: (2 pi)^n / n! with alternating
// signs. For |x| <= 1/8, the terms that are left out add up to less than a rounding error.
inline constexpr std::size_t sine_terms = std::numeric_limits<Real>::digits <= 24 ? 6 : 10;
inline constexpr std::array sine_series{6.28318530717958647693,  -41.3417022403997602340,
                                        81.6052492760750542034,  -76.7058597530613858416,
                                        42.0586939448976531450,  -15.0946425768229903918,
                                        3.81995258484828212773,  -0.718122301778500512232,
                                        0.104229162208139841173, -0.0120315859421206272332};
inline constexpr std::array cosine_series{1.0,
                                          -19.7392088021787172377,
                                          64.9393940226682914910,
                                          -85.4568172066937277360,
                                          60.2446413718766603627,
                                          -26.4262567833743974529,
                                          7.90353637131846880421,
                                          -1.71439071108867206542,
                                          0.282005968455791215070,
                                          -0.0363828411425456707718};

// The sine and the cosine of 2 pi * turn, for a turn in [0, 1), to within epsilon. They are
// computed with sums and products alone, so they have the same bits with every compiler and
// library. If Number is a Pack of chapter 10, many turns are computed at once.
template <class Number>
constexpr SineCosine<Number> sine_cosine_of_turn(Number turn) {
    // Adding this number to 4 * turn and subtracting it again leaves the nearest whole number.
    constexpr Real shift = Real(1.5) / epsilon;
    const Number quarter = (4 * turn + shift) - shift;
    const Number rest = turn - Real(0.25) * quarter, square = rest * rest;
    Number sine{}, cosine{};
    for (std::size_t i = sine_terms; i-- > 0;) {
        sine = sine * square + static_cast<Real>(sine_series[i]);
        cosine = cosine * square + static_cast<Real>(cosine_series[i]);
    }
    sine = sine * rest;
    // Adding a quarter turn turns the sine into the cosine, and the cosine into minus the sine.
    const auto one = quarter == Real(1), two = quarter == Real(2), three = quarter == Real(3);
    return {one ? cosine : (two ? -sine : (three ? -cosine : sine)),
            one ? -sine : (two ? -cosine : (three ? sine : cosine))};
}

}  // namespace rt
