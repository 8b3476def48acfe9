#include <algorithm>
#include <cmath>
#include <companion/pages/axis.hpp>
#include <cstdio>

namespace companion {
namespace {

std::string printed(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string power_of_ten(int exponent) {
    return (exponent < 0 ? "10⁻" : "10") + raised(std::to_string(std::abs(exponent)));
}

// The multiples of a step from `least` to `most`.
std::vector<double> multiples(double step, double least, double most) {
    std::vector<double> all;
    const double slack = 1e-9 * (most - least);
    for (double k = std::ceil((least - slack) / step); k * step <= most + slack; ++k)
        all.push_back(k * step);
    return all;
}

}  // namespace

bool measured(const Measurement& row, Quantity quantity) {
    if (quantity == &study::Row::error) return !row.error_name.empty();
    return quantity != &study::Row::cost || !row.cost_name.empty();
}

std::string shown(double value) {
    if (std::isnan(value)) return "not a number";
    if (value == 0) return "0";
    if (value < 0) return "−" + shown(-value);
    if (std::isinf(value)) return "∞";
    const std::string digits = printed("%.2e", value);  // "7.30e-12"
    const int exponent = std::stoi(digits.substr(5));
    if (-5 < exponent && exponent < 3) return printed("%.3g", value);
    if (3 <= exponent && exponent < 5) {
        std::string whole = printed("%.0f", value);
        return whole.insert(whole.size() - 3, ",");
    }
    const std::string mantissa = printed("%g", std::stod(digits.substr(0, 4)));
    return (mantissa == "1" ? "" : mantissa + "·") + power_of_ten(exponent);
}

std::string raised(const std::string& digits) {
    static const char* const raised_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : digits) text += raised_digits[c - '0'];
    return text;
}

std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string px(double length) {
    // Not simply the nearest: this way a half is rounded up on every machine.
    return printed("%g", std::floor(10 * length + 0.500001) / 10);
}

Axis::Axis(const Measurements& rows, Quantity quantity, double from, double to, From begins)
    : from_{from}, to_{to} {
    std::vector<double> ordinary;
    for (const Measurement& row : rows) {
        if (!measured(row, quantity)) continue;
        const double value = row.*quantity;
        has_infinite_ |= !std::isfinite(value);
        has_zero_ |= value == 0;
        if (std::isfinite(value) && value != 0) ordinary.push_back(value);
        if (quantity == &study::Row::x && std::isfinite(value)) values_.push_back(value);
    }
    std::sort(values_.begin(), values_.end());
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
    if (ordinary.empty()) {
        ordinary.push_back(1);
        values_ = {0};  // there is nothing else to mark
    }
    const auto [least, most] = std::minmax_element(ordinary.begin(), ordinary.end());
    is_logarithmic_ = begins == From::values && *least > 0 && *most / 16 > *least;
    least_ = is_logarithmic_ ? std::log10(*least) : *least;
    most_ = is_logarithmic_ ? std::log10(*most) : *most;
    const bool may_begin_anywhere = quantity == &study::Row::x || begins == From::least;
    if (!is_logarithmic_ && (!may_begin_anywhere || has_zero_ || least_ == most_)) {
        least_ = std::min(least_, 0.0);
        most_ = std::max(most_, 0.0);
    }
    const double span = most_ - least_, margin = 0.05 * span;
    zero_ = is_logarithmic_ ? least_ - 0.15 * span : 0;
    infinite_ = most_ + 0.15 * span;
    low_ = is_logarithmic_ && has_zero_ ? zero_ - margin : least_;
    if (!has_zero_ && least_ != 0) low_ -= margin;
    high_ = (has_infinite_ ? infinite_ : most_) + margin;
}

double Axis::place(double value) const {
    if (!std::isfinite(value)) return infinite_;
    if (!is_logarithmic_) return value;
    return value == 0 ? zero_ : std::log10(value);
}

double Axis::at(double value) const {
    return from_ + (to_ - from_) * ((place(value) - low_) / (high_ - low_));
}

std::vector<Axis::Mark> Axis::named(const std::vector<double>& values) const {
    std::vector<Mark> marks;
    // On a long axis all names are powers of ten, so that it looks the same from end to end.
    const bool as_powers = is_logarithmic_ && values_.empty() && most_ - least_ > 5;
    for (const double value : values) {
        const int exponent = as_powers ? static_cast<int>(std::lround(std::log10(value))) : 0;
        marks.push_back({at(value), exponent == 0 ? shown(value) : power_of_ten(exponent),
                         is_logarithmic_ && value == 0});
    }
    if (is_logarithmic_ && has_zero_ && std::count(values.begin(), values.end(), 0.0) == 0)
        marks.push_back({at(0), "0", true});
    if (has_infinite_) marks.push_back({at(INFINITY), "∞", true});
    return marks;
}

bool Axis::fit(const std::vector<Mark>& marks) const {
    const bool is_upright = to_ < from_;
    std::vector<std::pair<double, double>> ends;
    for (const Mark& mark : marks) {
        const double half = is_upright ? 13 : 3.75 * static_cast<double>(letters(mark.name)) + 8;
        ends.emplace_back(mark.at - half, mark.at + half);
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i)
        if (ends[i].first < ends[i - 1].second) return false;
    return true;
}

std::vector<Axis::Mark> Axis::marks() const {
    std::vector<Mark> marks = named(values_);
    if (!values_.empty() && fit(marks)) return marks;
    const double span = most_ - least_;
    if (is_logarithmic_ && span < 2.5) {
        std::vector<double> values;
        for (const double power : multiples(1, std::floor(least_), most_))
            for (const double digit : {1, 2, 5})
                if (const double value = digit * std::pow(10, power);
                    std::log10(value) > least_ - 0.01 && std::log10(value) < most_ + 0.01)
                    values.push_back(value);
        if (marks = named(values); fit(marks)) return marks;
    }
    // Steps of 1, 2 or 5 times a power of ten, of exponents on a logarithmic axis.
    double power = is_logarithmic_ ? 1 : std::pow(10, std::floor(std::log10(span / 20)));
    for (;; power *= 10)
        for (const double step : {power, 2 * power, 5 * power}) {
            std::vector<double> values = multiples(step, least_, most_);
            if (is_logarithmic_)
                for (double& value : values) value = std::pow(10, value);
            if (marks = named(values); fit(marks)) return marks;
        }
}

}  // namespace companion
