#pragma once
// Numbers with twice the precision of double, for the reference values against which errors are
// measured. They are slow, and no picture is drawn with them.

#include <cmath>
#include <type_traits>

namespace study {

// The number high + low, where low is the part that did not fit into high: about 106 bits.
// Results have a relative error of at most 2^-98, as long as nothing overflows or underflows.
// Source: Dekker, "A floating-point technique for extending the available precision", 1971; bounds
// by Joldes, Muller and Popescu, ACM TOMS 44 (2017).
struct DoubleDouble {
    double high = 0, low = 0;

    constexpr DoubleDouble() = default;
    template <class Number>
    requires std::is_arithmetic_v<Number>
    constexpr DoubleDouble(Number value) : high{static_cast<double>(value)} {}
    constexpr DoubleDouble(double h, double l) : high{h}, low{l} {}

    // Knuth's two-sum: a + b exactly, for any a and b.
    static DoubleDouble sum(double a, double b) {
        const double s = a + b;
        const double b_part = s - a;
        return {s, (a - (s - b_part)) + (b - b_part)};
    }
    static DoubleDouble product(double a, double b) {
        const double p = a * b;
        return {p, std::fma(a, b, -p)};
    }

    friend DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }
    friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
        const DoubleDouble highs = sum(a.high, b.high);
        const DoubleDouble lows = sum(a.low, b.low);
        const DoubleDouble t = sum(highs.high, highs.low + lows.high);
        return sum(t.high, t.low + lows.low);
    }
    friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
    friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
        const DoubleDouble p = product(a.high, b.high);
        return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
    }
    friend DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
        const double q1 = a.high / b.high;
        DoubleDouble rest = a - b * q1;
        const double q2 = rest.high / b.high;
        rest = rest - b * q2;
        return sum(q1, q2) + rest.high / b.high;
    }
    friend bool operator<(DoubleDouble a, DoubleDouble b) {
        return a.high < b.high || (a.high == b.high && a.low < b.low);
    }
};

// The square root of x >= 0: one step of Newton's method from the root in double.
inline DoubleDouble sqrt(DoubleDouble x) {
    if (x.high <= 0) return {};
    const double root = std::sqrt(x.high);
    const DoubleDouble rest = x - DoubleDouble::product(root, root);
    return DoubleDouble::sum(root, rest.high / (2 * root));
}

}  // namespace study
