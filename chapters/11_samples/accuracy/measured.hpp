#pragma once
// Ways to draw a scene: each way draws eight pictures, in turns with the other ways, and the
// pictures tell its error.

#include <array>
#include <cmath>
#include <functional>
#include <rt/image.hpp>
#include <string>
#include <study/median.hpp>
#include <study/timing.hpp>
#include <vector>

namespace accuracy {

using namespace rt;

constexpr int pictures = 8;
// In 95 % of cases, the mean of eight numbers is at most this many standard errors away from the
// true mean (Student's t).
constexpr double t_95 = 2.365;

inline double mean_of(const std::vector<double>& numbers) {
    double sum = 0;
    for (const double number : numbers) sum += number;
    return sum / static_cast<double>(numbers.size());
}
// Half the width of the 95 % confidence interval around the mean of eight numbers.
inline double interval_of(const std::vector<double>& numbers) {
    const double mean = mean_of(numbers);
    double squares = 0;
    for (const double number : numbers) squares += (number - mean) * (number - mean);
    const auto n = static_cast<double>(numbers.size());
    return t_95 * std::sqrt(squares / (n - 1) / n);
}

// All channels of a picture, one after the other.
using Channels = std::vector<double>;

// The channels in linear light, where white is 1.
inline Channels linear(const Image& image) {
    Channels all;
    for (const Color& color : image.pixels())
        for (const Real channel : {color.r, color.g, color.b})
            all.push_back(static_cast<double>(channel));
    return all;
}
// The channels as a screen shows them: in sRGB, and no brighter than white, which is 1.
inline Channels displayed(const Image& image) {
    Channels all = linear(image);
    for (double& channel : all)
        channel = static_cast<double>(srgb_encode(static_cast<Real>(channel)));
    return all;
}
inline double mean_square(const Channels& a, const Channels& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

// A converged picture, linear or displayed: the mean of two halves, which also tell how far off
// this mean still is (chapter 11).
struct Truth {
    Channels mean;
    double square = 0;  // the mean square error of `mean`, estimated

    Truth() = default;
    Truth(const Channels& a, const Channels& b) : mean{a}, square{mean_square(a, b) / 4} {
        for (std::size_t i = 0; i < a.size(); ++i) mean[i] = (a[i] + b[i]) / 2;
    }
};

// The errors of pictures with different seeds, compared with a converged picture. The mean square
// error is the sum of two parts: the noise, which is the variance of the pictures, and the square
// of the bias, which is how far the pictures' mean is off.
class Errors {
  public:
    explicit Errors(const Truth& truth) : truth_{&truth}, sum_(truth.mean.size()) {}

    void add(const Channels& picture) {
        double all = 0;
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const double off = picture[i] - truth_->mean[i];
            sum_[i] += off;
            all += off * off;
        }
        // `all` also contains the truth's own error, which is subtracted.
        squares.push_back(all / static_cast<double>(picture.size()) - truth_->square);
    }

    double rmse() const { return std::sqrt(mean_of(squares)); }
    // How far the pictures' mean would be off without noise. The square error of the mean of n
    // pictures is bias^2 + noise / n, and the mean square error of one picture is bias^2 + noise;
    // the bias follows from both.
    double bias() const {
        const auto n = static_cast<double>(squares.size());
        double all = 0;
        for (const double sum : sum_) all += (sum / n) * (sum / n);
        const double of_mean = all / static_cast<double>(sum_.size()) - truth_->square;
        return std::sqrt(std::max(0.0, (n * of_mean - mean_of(squares)) / (n - 1)));
    }

    std::vector<double> squares;  // the mean square error of each picture

  private:
    const Truth* truth_;
    Channels sum_;
};

// A way to draw, with this many samples in a pixel.
struct Way {
    std::string setting;
    int samples = 1;
    std::function<Image(std::uint64_t seed)> draw;
};

// A way to draw, with the errors and the times of its eight pictures.
struct Measured {
    Way way;
    Errors linear, displayed;
    std::vector<double> ms;  // processor time of each picture
};

// Draws eight pictures of each way, all ways in turns.
inline void measure(std::vector<Measured>& all) {
    for (std::uint64_t seed = 1; seed <= pictures; ++seed)
        for (Measured& one : all) {
            Image image;
            const auto draw = [&] { image = one.way.draw(seed); };
            one.ms.push_back(1e-6 * study::time_ns(draw, {.rounds = 1}));
            one.linear.add(linear(image));
            one.displayed.add(displayed(image));
        }
}

// A way's 1 / (error^2 time) as a multiple of another way's, and half the width of this multiple's
// 95 % confidence interval, in percent.
struct Worth {
    double times = 1, percent = 0;
};
inline Worth worth(const std::vector<double>& squares, const std::vector<double>& ms,
                   const std::vector<double>& other_squares, const std::vector<double>& other_ms) {
    std::vector<double> logs;
    for (std::size_t i = 0; i < squares.size(); ++i)
        logs.push_back(std::log(other_squares[i] * other_ms[i] / (squares[i] * ms[i])));
    return {
        mean_of(other_squares) * study::median(other_ms) / (mean_of(squares) * study::median(ms)),
        100 * interval_of(logs)};
}

}  // namespace accuracy
