#include <algorithm>
#include <cmath>
#include <course/scale.hpp>
#include <cstdio>

namespace course {
namespace {

std::string text(double value, const char* format = "%g") {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

// Marks at 1, 2 and 5 times the powers of ten, or at powers alone where there are many.
std::vector<double> logarithmic_marks(double low, double high) {
    const double decades = std::log10(high / low);
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::ceil(std::log10(high)));
    const int step = std::max(1, static_cast<int>(std::ceil(decades / 7)));
    std::vector<double> marks;
    for (int power = first; power <= last; ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
            if (decades > 3 && (digit != 1 || power % step != 0)) continue;
            const double mark = digit * std::pow(10.0, power);
            if (low <= mark && mark <= high) marks.push_back(mark);
        }
    return marks;
}

// About six marks at round numbers.
std::vector<double> linear_marks(double low, double high) {
    const double rough = (high - low) / 6;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / power;
    const double step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
    std::vector<double> marks;
    for (double k = std::ceil(low / step); k * step <= high; ++k) marks.push_back(k * step);
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
        smallest_ = *smallest;
        largest_ = *largest;
    }
    logarithmic_ = smallest_ > 0 && largest_ / smallest_ > 16;
    if (logarithmic_) {
        const double margin = std::pow(largest_ / smallest_, 0.07);
        low_ = smallest_ / margin;
        high_ = largest_ * margin;
        zero_ = low_ / margin;
        infinite_ = high_ * margin;
        if (has_zero_) low_ = zero_ / margin;
        if (has_infinite_) high_ = infinite_ * margin;
    } else {
        smallest_ = std::min(smallest_, 0.0);
        if (largest_ <= smallest_) largest_ = smallest_ + 1;
        const double margin = 0.07 * (largest_ - smallest_);
        low_ = smallest_ < 0 || has_zero_ ? smallest_ - margin : 0;
        infinite_ = largest_ + 2 * margin;
        high_ = has_infinite_ ? infinite_ + margin : largest_ + margin;
    }
}

double Scale::place(double value) const {
    if (!std::isfinite(value)) return infinite_;
    return value == 0 ? zero_ : value;
}

double Scale::fraction(double value) const {
    const double at = place(value);
    if (logarithmic_) return std::log(at / low_) / std::log(high_ / low_);
    return (at - low_) / (high_ - low_);
}

std::vector<std::pair<double, std::string>> Scale::marks() const {
    std::vector<std::pair<double, std::string>> marks;
    if (logarithmic_) {
        const double margin = std::pow(largest_ / smallest_, 0.02);
        const bool powers = largest_ / smallest_ > 1e3;
        for (const double at : logarithmic_marks(smallest_ / margin, largest_ * margin))
            marks.emplace_back(at, powers ? text(std::round(std::log10(at)), "10^{%g}") : text(at));
        if (has_zero_) marks.emplace_back(zero_, "0");
    } else {
        for (const double at : linear_marks(smallest_, largest_)) marks.emplace_back(at, text(at));
    }
    if (has_infinite_) marks.emplace_back(infinite_, "∞");
    return marks;
}

}  // namespace course
