#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

// The sine, the exponential and the other functions of <cmath> that libraries round differently.
//
// IEEE 754 fixes every bit of the result of +, -, *, /, std::sqrt and std::fma. It does not fix the
// bits of std::sin or std::exp: each library returns a number close to the true value, and may
// return another one on another processor. So a picture that is drawn with them depends on the
// library. The functions here use only operations whose bits are fixed, so they return the same
// bits everywhere.
//
// They take and return what their namesakes in <cmath> do, infinity and NaN included. Results in
// double are accurate to 5 units in the last place; results in float are computed in double and
// then rounded. The exceptions:
//
// - If |x| is 2^20 or more, sin, cos and tan of x are those of an angle that differs from x by less
//   than half a unit in the last place.
// - pow takes x >= 0 only, and is accurate to 5 + |y ln x| / 10 units: huge and tiny powers lose
//   digits.
// - The sign of a zero counts only for atan2, atan, asin and cbrt: sin(-0) is 0.

namespace rt::portable {

namespace detail {

// The number high + low, where low is the part that did not fit into high.
struct Sum {
    double high = 0, low = 0;
};

inline Sum product(Sum a, Sum b) {
    const double high = a.high * b.high;
    if (!std::isfinite(high)) return {high, 0};
    return {high, std::fma(a.high, b.high, -high) + (a.high * b.low + a.low * b.high)};
}

// 2^k, for k from -1022 to 1023.
constexpr double power_of_2(int k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

// The nearest whole number, for |x| < 2^51.
constexpr double nearest(double x) {
    constexpr double shift = 0x1.8p52;
    return (x + shift) - shift;
}

// c[0] + c[1] x + c[2] x^2 ... The even and the odd terms are summed separately, so that a
// processor can work on both sums at once.
template <std::size_t terms>
constexpr double polynomial(const std::array<double, terms>& c, double x) {
    const double square = x * x;
    double even = 0, odd = 0;
    for (std::size_t i = terms; i-- > 0;)
        (i % 2 == 0 ? even : odd) = (i % 2 == 0 ? even : odd) * square + c[i];
    return even + odd * x;
}

// Coefficients of Taylor series, without the first terms: e^x in powers of x; sin x / x, cos x,
// arctan x / x and ln((1 + x) / (1 - x)) / x in powers of x^2.
inline constexpr std::array exponential_series = [] {
    std::array<double, 13> c{};
    double factorial = 1;
    for (int i = 0; double& term : c) term = 1 / (factorial *= 2 + i++);
    return c;
}();
inline constexpr std::array sine_series = [] {
    std::array<double, 9> c{};
    double factorial = 1, n = 2;
    for (double& term : c) term = 1 / (factorial *= -n * (n + 1)), n += 2;
    return c;
}();
inline constexpr std::array cosine_series = [] {  // from x^4 on
    std::array<double, 8> c{};
    double factorial = -2, n = 3;
    for (double& term : c) term = 1 / (factorial *= -n * (n + 1)), n += 2;
    return c;
}();
inline constexpr std::array arctangent_series = [] {
    std::array<double, 10> c{};
    double n = 3;
    for (double sign = -1; double& term : c) term = sign / n, n += 2, sign = -sign;
    return c;
}();
inline constexpr std::array logarithm_series = [] {
    std::array<double, 11> c{};
    for (double n = 3; double& term : c) term = 2 / n, n += 2;
    return c;
}();

// ln 2. The high part ends in zeros: its product with a whole number is exact.
inline constexpr Sum ln_2{0x1.62e42feep-1, 0x1.a39ef35793c76p-33};

inline double exponential(Sum x) {
    if (!(x.high < 710)) return x.high + std::numeric_limits<double>::infinity();
    if (x.high < -746) return 0;
    // e^x = 2^k e^r, with |r| at most ln(2) / 2.
    const double k = nearest(x.high * (1 / std::numbers::ln2));
    const double r = ((x.high - k * ln_2.high) - k * ln_2.low) + x.low;
    const double power = 1 + (r + r * r * polynomial(exponential_series, r));
    // In two steps: 2^k alone may overflow or underflow.
    const int half = static_cast<int>(k) / 2;
    return power * power_of_2(half) * power_of_2(static_cast<int>(k) - half);
}

inline Sum logarithm(double x) {
    if (x == 0) return {-std::numeric_limits<double>::infinity(), 0};
    if (!(x > 0)) return {std::numeric_limits<double>::quiet_NaN(), 0};
    if (x > std::numeric_limits<double>::max()) return {x, 0};
    // x = 2^k m, with m from sqrt(1/2) to sqrt(2).
    const bool is_subnormal = x < std::numeric_limits<double>::min();
    const auto bits = std::bit_cast<std::uint64_t>(is_subnormal ? x * 0x1p54 : x);
    constexpr auto one = std::bit_cast<std::uint64_t>(1.0);
    constexpr auto least = std::bit_cast<std::uint64_t>(std::numbers::sqrt2 / 2);
    const std::uint64_t exponent = ((bits + (one - least)) >> 52) - (one >> 52);
    const auto m = std::bit_cast<double>(bits - (exponent << 52));
    const double k =
        static_cast<double>(static_cast<std::int64_t>(exponent)) - (is_subnormal ? 54 : 0);
    // ln m = ln((1 + s) / (1 - s)). The division's remainder gives the rounding error of s.
    const double f = m - 1, divisor = f + 2, s = f / divisor, square = s * s;
    const double remainder = std::fma(-s, divisor, f) - s * (f - (divisor - 2));
    const double tail = 2 * remainder / divisor + s * square * polynomial(logarithm_series, square);
    // The sum k ln 2 + 2 s + tail. Its first term is the largest or, if k = 0, exactly 0.
    const double large = k * ln_2.high, sum = large + 2 * s;
    const double rest = ((large - sum) + 2 * s) + (k * ln_2.low + tail);
    const double high = sum + rest;
    return {high, (sum - high) + rest};
}

// What sine_cosine returns. The function in rt/sine_cosine.hpp is faster and also works for packs,
// but takes the angle in turns.
struct SineCosine {
    double sine = 0, cosine = 0;
};

inline SineCosine sine_cosine(double angle) {
    constexpr double most = 0x1p20;
    if (!(std::abs(angle) < most)) {
        // std::fmod is exact, but 2 pi is rounded, with a relative error below 2^-54. The effect is
        // the same as if the angle had a relative error below 2^-54.
        angle = std::fmod(angle, 2 * std::numbers::pi);
        if (std::isnan(angle)) return {angle, angle};
    }
    // pi/2 in three parts. The first two end in zeros: their products with a whole number are
    // exact.
    const double quarters = nearest(angle * (2 / std::numbers::pi));
    const double first = angle - quarters * 0x1.921fb544p0;
    const double second = quarters * 0x1.0b4611a6p-34, third = quarters * 0x1.3198a2e037073p-69;
    const double near = first - second, lost = ((first - near) - second) - third;
    const double x = near + lost, rest = (near - x) + lost;
    const double square = x * x, half = square / 2, large = 1 - half;
    const double sine = x + (x * square * polynomial(sine_series, square) + rest);
    const double tail = square * square * polynomial(cosine_series, square) - x * rest;
    const double cosine = large + (((1 - large) - half) + tail);
    switch (static_cast<int>(quarters) & 3) {
        case 0:
            return {sine, cosine};
        case 1:
            return {cosine, -sine};
        case 2:
            return {-sine, -cosine};
        default:
            return {-cosine, sine};
    }
}

// The arctangent of a number from 0 to 1.
inline double arctangent(double x) {
    constexpr Sum known[] = {{0, 0},  // of 0, 1/4, 1/2, 3/4 and 1
                             {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                             {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                             {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                             {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
    const double quarters = nearest(4 * x), c = quarters / 4;
    const Sum& of_c = known[static_cast<int>(quarters)];
    // arctan x = arctan c + arctan u
    const double u = (x - c) / (1 + c * x), square = u * u;
    return of_c.high + (u + (of_c.low + u * square * polynomial(arctangent_series, square)));
}

inline double arctangent(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return x + y;
    const double across = std::abs(x), up = std::abs(y);
    const double larger = std::max(across, up), smaller = std::min(across, up);
    // x and y may both be 0, or both be infinite.
    const double angle = arctangent(larger == 0 ? 0 : smaller == larger ? 1 : smaller / larger);
    // The angle is measured from the x axis or from the y axis, whichever is nearer.
    constexpr Sum quarter_turn{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
    const bool is_steep = up > across, is_left = std::signbit(x);
    const double quarters = is_steep ? 1 : is_left ? 2 : 0;
    const double away = is_steep != is_left ? -angle : angle;
    return std::copysign(quarters * quarter_turn.high + (quarters * quarter_turn.low + away), y);
}

}  // namespace detail

template <std::floating_point N>
N sin(N x) {
    return static_cast<N>(detail::sine_cosine(static_cast<double>(x)).sine);
}
template <std::floating_point N>
N cos(N x) {
    return static_cast<N>(detail::sine_cosine(static_cast<double>(x)).cosine);
}
template <std::floating_point N>
N tan(N x) {
    const auto [sine, cosine] = detail::sine_cosine(static_cast<double>(x));
    return static_cast<N>(sine / cosine);
}

template <std::floating_point N>
N atan2(N y, N x) {
    return static_cast<N>(detail::arctangent(static_cast<double>(y), static_cast<double>(x)));
}
template <std::floating_point N>
N atan(N x) {
    return static_cast<N>(detail::arctangent(static_cast<double>(x), 1));
}
template <std::floating_point N>
N asin(N x) {
    const auto sine = static_cast<double>(x);
    return static_cast<N>(detail::arctangent(sine, std::sqrt((1 - sine) * (1 + sine))));
}
template <std::floating_point N>
N acos(N x) {
    const auto cosine = static_cast<double>(x);
    return static_cast<N>(detail::arctangent(std::sqrt((1 - cosine) * (1 + cosine)), cosine));
}

template <std::floating_point N>
N exp(N x) {
    return static_cast<N>(detail::exponential({static_cast<double>(x), 0}));
}
template <std::floating_point N>
N pow(N x, N y) {
    if (x == 1 || y == 0) return 1;  // even if the other argument is NaN
    const detail::Sum of_x = detail::logarithm(static_cast<double>(x));
    return static_cast<N>(detail::exponential(detail::product(of_x, {static_cast<double>(y), 0})));
}
template <std::floating_point N>
N exp2(N x) {
    return pow(N(2), x);
}
template <std::floating_point N>
N cbrt(N x) {
    constexpr detail::Sum third{0x1.5555555555555p-2, 0x1.5555555555555p-56};
    const detail::Sum of_x = detail::logarithm(std::abs(static_cast<double>(x)));
    return std::copysign(static_cast<N>(detail::exponential(detail::product(of_x, third))), x);
}
template <std::floating_point N>
N log2(N x) {
    constexpr detail::Sum one_by_ln_2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
    const detail::Sum of_x = detail::logarithm(static_cast<double>(x));
    const detail::Sum result = detail::product(of_x, one_by_ln_2);
    return static_cast<N>(result.high + result.low);
}
template <std::floating_point N>
N log10(N x) {
    constexpr detail::Sum one_by_ln_10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
    const detail::Sum of_x = detail::logarithm(static_cast<double>(x));
    const detail::Sum result = detail::product(of_x, one_by_ln_10);
    return static_cast<N>(result.high + result.low);
}
// ln(1 + x)
template <std::floating_point N>
N log1p(N x) {
    const auto number = static_cast<double>(x);
    const double sum = 1 + number, lost = number < 1 ? number - (sum - 1) : 1 - (sum - number);
    const detail::Sum of_sum = detail::logarithm(sum);
    if (!std::isfinite(of_sum.high)) return static_cast<N>(of_sum.high);
    return static_cast<N>(of_sum.high + (of_sum.low + lost / sum));
}

template <std::floating_point N>
N hypot(N x, N y) {
    const auto across = std::abs(static_cast<double>(x)), up = std::abs(static_cast<double>(y));
    const double larger = std::max(across, up), smaller = std::min(across, up);
    if (std::isinf(across) || std::isinf(up)) return std::numeric_limits<N>::infinity();
    if (larger == 0 || std::isnan(across + up)) return static_cast<N>(across + up);
    const double ratio = smaller / larger;
    return static_cast<N>(larger * std::sqrt(1 + ratio * ratio));
}

}  // namespace rt::portable
