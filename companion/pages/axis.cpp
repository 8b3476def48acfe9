#include <algorithm>
#include <cmath>
#include <companion/pages/axis.hpp>
#include <cstdio>

namespace companion {
namespace {

using Marks = std::vector<std::pair<double, std::string>>;

std::string text(double value, const char* format = "%g") {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

// Marks for logarithms from low to high: at powers of ten where there are many, else also at 2 and
// 5 times those. Long numbers need more room.
Marks logarithmic_marks(double low, double high) {
    Marks marks;
    const double step = std::max(1.0, std::ceil((high - low) / 7));
    for (double power = std::floor(low / step) * step; power <= high; power += step)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double place = power + std::log10(digit);
            const bool short_number = -3 <= low && high <= 4;
            const double dense = short_number ? 3.2 : 1.6;
            if (place < low || place > high || (digit != 1 && high - low > dense)) continue;
            marks.emplace_back(place, short_number ? text(digit * std::pow(10.0, power))
                                      : digit == 1 ? text(power, "10^{%g}")
                                                   : text(digit) + text(power, "·10^{%g}"));
        }
    return marks;
}

// About six marks at round numbers.
Marks linear_marks(double low, double high) {
    const double rough = (high - low) / 6;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / power;
    const double step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
    Marks marks;
    for (double k = std::ceil(low / step); k * step <= high; ++k)
        marks.emplace_back(k * step, text(k * step));
    return marks;
}

}  // namespace

Scale::Scale(const std::vector<double>& values) {
    std::vector<double> ordinary;
    for (const double value : values) {
        has_infinite_ |= !std::isfinite(value);
        has_zero_ |= value == 0;
        if (std::isfinite(value) && value != 0) ordinary.push_back(value);
    }
    if (!ordinary.empty()) {
        const auto [smallest, largest] = std::minmax_element(ordinary.begin(), ordinary.end());
        logarithmic_ = *smallest > 0 && *largest / 16 > *smallest;
        smallest_ = logarithmic_ ? std::log10(*smallest) : std::min(*smallest, 0.0);
        largest_ = logarithmic_ ? std::log10(*largest) : std::max(*largest, 0.0);
    }
    const double margin = 0.07 * (largest_ - smallest_);
    low_ = smallest_ == 0 && !logarithmic_ ? 0 : smallest_ - margin;
    high_ = largest_ + margin;
    if (logarithmic_ && has_zero_) {
        zero_ = low_ - margin;
        low_ = zero_ - margin;
    }
    if (has_infinite_) {
        infinite_ = high_ + margin;
        high_ = infinite_ + margin;
    }
}

double Scale::place(double value) const {
    if (!std::isfinite(value)) return infinite_;
    if (value == 0) return zero_;
    return logarithmic_ ? std::log10(value) : value;
}

std::vector<std::pair<double, std::string>> Scale::marks() const {
    const double margin = 0.02 * (largest_ - smallest_);
    Marks marks = logarithmic_ ? logarithmic_marks(smallest_ - margin, largest_ + margin)
                               : linear_marks(smallest_, largest_);
    if (logarithmic_ && has_zero_) marks.emplace_back(zero_, "0");
    if (has_infinite_) marks.emplace_back(infinite_, "∞");
    return marks;
}

}  // namespace companion
