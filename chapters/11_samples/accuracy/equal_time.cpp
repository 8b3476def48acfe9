#include "equal_time.hpp"

#include <rt/tent_filter.hpp>
#include <study/classic.hpp>

#include "../ways.hpp"
#include "measured.hpp"
#include "subjects.hpp"

namespace accuracy {
namespace {

constexpr int width = 192, height = 108;
constexpr Tile whole{0, 0, width, height};

// The cover without its lens, which the classic recipe lacks, made ready for all ways.
class Cover {
  public:
    struct Way {
        std::string name;
        std::function<Image(int samples, std::uint64_t seed)> draw;
    };

    Cover() {
        cover_.width = width;
        cover_.height = height;
    }

    std::vector<Way> ways() {
        return {{"classic", [this](int n, std::uint64_t) { return draw_classic(n); }},
                {"chapter 08",
                 [this](int n, std::uint64_t seed) {
                     return samples::draw_with(renderer_, JitteredSamples{seed, n}, width, height);
                 }},
                {"Sobol",
                 [this](int n, std::uint64_t seed) {
                     return samples::draw_with(renderer_, SobolSamples{seed, n}, width, height);
                 }},
                {"Sobol in twin halves",
                 [this](int n, std::uint64_t seed) {
                     const auto passes = [this](int count) {
                         return sobol_passes(renderer_, count);
                     };
                     return samples::refine({width, height, 4}, seed, n, passes).image;
                 }},
                {"batches",
                 [this](int n, std::uint64_t seed) {
                     return draw_batches(JitteredPoints{JitteredSamples{seed, n}});
                 }},
                {"Sobol in batches",
                 [this](int n, std::uint64_t seed) {
                     return draw_batches(SobolPoints{{seed, n}});
                 }},
                {"Sobol in batches, tent", [this](int n, std::uint64_t seed) {
                     BatchRenderer<cover_effects, SobolPoints> renderer{ready_, quality()};
                     Image image = Canvas<Color>{width, height};
                     std::uint64_t rays = 0;
                     draw_with_tent(renderer, SobolSamples{seed, n}, whole, image, rays);
                     return image;
                 }}};
    }

  private:
    Quality quality() const { return {1, cover_.depth, 1}; }

    Image draw_classic(int samples) {
        cover_.samples_per_pixel = samples;
        return study::classic::picture(cover_, *classic_);
    }
    template <class Points>
    Image draw_batches(const Points& points) const {
        BatchRenderer<cover_effects, Points> renderer{ready_, quality()};
        Image image = Canvas<Color>{width, height};
        std::uint64_t rays = 0;
        renderer.draw(points, whole, image, rays);
        return image;
    }

    study::Cover cover_ = study::make_cover();
    std::shared_ptr<const study::classic::Hittable> classic_ = study::classic::make_world(cover_);
    SceneDescription scene_ = study::cover_scene(cover_);
    ReadyScene<cover_effects> ready_{scene_, width, height};
    Renderer<cover_effects> renderer_{scene_, width, height, quality()};
};

// The nearest 2^k or 3 * 2^k: with other counts, Sobol's points leave more noise than they need.
int good_count(int count) {
    int power = 1;
    while (2 * power <= count) power *= 2;
    return static_cast<int>(std::lround(2.0 * count / power)) * power / 2;
}

struct Drawn {
    int samples = 1;
    std::vector<Channels> pictures;
    std::vector<double> ms;

    // The noise of each picture: its mean square distance from the mean of all n pictures, times n
    // / (n - 1), because that mean contains the picture itself. A way's bias does not count here.
    std::vector<double> squares() const {
        const auto n = static_cast<double>(pictures.size());
        Channels mean(pictures.front().size());
        for (const Channels& picture : pictures)
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += picture[i] / n;
        std::vector<double> all;
        for (const Channels& picture : pictures)
            all.push_back(n / (n - 1) * mean_square(picture, mean));
        return all;
    }
};

}  // namespace

void study_equal_time(study::Report& report) {
    Cover cover;
    const std::vector<Cover::Way> ways = cover.ways();
    for (const double ms : {200, 600}) {
        std::vector<Drawn> all(ways.size());
        for (std::size_t i = 0; i < ways.size(); ++i) {
            constexpr int few = 8;
            const double sample_ms =
                1e-6 / few *
                study::time_ns([&] { study::keep(ways[i].draw(few, 1)); }, {.rounds = 3});
            const int fits = std::max(1, static_cast<int>(std::lround(ms / sample_ms)));
            all[i].samples = ways[i].name.starts_with("Sobol") ? good_count(fits) : fits;
        }
        for (std::uint64_t seed = 1; seed <= pictures; ++seed)
            for (std::size_t i = 0; i < ways.size(); ++i) {
                Image image;
                const auto draw = [&] { image = ways[i].draw(all[i].samples, seed); };
                all[i].ms.push_back(1e-6 * study::time_ns(draw, {.rounds = 1}));
                all[i].pictures.push_back(linear(image));
            }
        const std::vector<double> classic = all.front().squares();
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const std::vector<double> squares = all[i].squares();
            // A whole number of samples does not take exactly `ms`, so the error is converted to
            // that time.
            const double error = std::sqrt(mean_of(squares) * study::median(all[i].ms) / ms);
            report.add({"equal time", ways[i].name, ms, "time / ms", error, "RMSE in a pixel",
                        static_cast<double>(all[i].samples), "samples per pixel"});
            const Worth times = worth(squares, all[i].ms, classic, all.front().ms);
            report.add({"share of the classic error", ways[i].name, ms, "time / ms",
                        1 / std::sqrt(times.times), "RMSE / classic RMSE", times.percent / 2,
                        "95 % / +-%"});
        }
    }
}

}  // namespace accuracy
