#include "equal_time.hpp"

#include <functional>
#include <rt/batch_renderer.hpp>
#include <rt/cover_scene.hpp>
#include <string>
#include <study/classic.hpp>
#include <study/pixel_error.hpp>
#include <study/timing.hpp>

#include "ways.hpp"

namespace samples {
namespace {

constexpr Effects cover_effects{.mirror = true, .fuzz = true, .glass = true};
constexpr int width = 192, height = 108;

// The cover, made ready for all ways. Each draws it with some samples in a pixel.
class Cover {
  public:
    using Draw = std::function<Image(int samples, std::uint64_t seed)>;
    struct Way {
        std::string name;
        Draw draw;
    };

    Cover() {
        cover_.width = width;
        cover_.height = height;
    }

    std::vector<Way> ways() {
        return {{"classic", [this](int n, std::uint64_t) { return draw_classic(n); }},
                {"chapter 08",
                 [this](int n, std::uint64_t seed) {
                     return draw_with(renderer_, JitteredSamples{seed, n}, width, height);
                 }},
                {"Sobol",
                 [this](int n, std::uint64_t seed) {
                     return draw_with(renderer_, SobolSamples{seed, n}, width, height);
                 }},
                {"twin halves",
                 [this](int n, std::uint64_t seed) {
                     return refine(grid(), seed, n,
                                   [this](int count) { return jittered_passes(renderer_, count); })
                         .image;
                 }},
                {"Sobol in twin halves",
                 [this](int n, std::uint64_t seed) {
                     return refine(grid(), seed, n,
                                   [this](int count) { return sobol_passes(renderer_, count); })
                         .image;
                 }},
                {"batches", [this](int n, std::uint64_t seed) { return draw_batches(n, seed); }},
                {"batches in twin halves", [this](int n, std::uint64_t seed) {
                     return refine(grid(16), seed, n,
                                   [this](int count) { return batch_pass(count); })
                         .image;
                 }}};
    }

  private:
    static TileGrid grid(int tile_side = 4) { return {width, height, tile_side}; }
    static Image blank() { return Canvas<Color>{width, height}; }

    Image draw_classic(int samples) {
        cover_.samples_per_pixel = samples;
        return study::classic::picture(cover_, *classic_);
    }
    Image draw_batches(int samples, std::uint64_t seed) const {
        BatchRenderer<cover_effects> renderer{ready_, {samples, cover_.depth, seed}};
        Image image = blank();
        std::uint64_t rays = 0;
        renderer.draw({0, 0, width, height}, image, rays);
        return image;
    }
    DrawPass batch_pass(int count) const {
        return [count, renderer = BatchRenderer<cover_effects>{ready_, {count, cover_.depth, 1}}](
                   const Tile& tile, const Pass& pass, Image& image, std::uint64_t& rays) mutable {
            renderer.draw(JitteredPoints{{seed_of(pass), count}}, tile, image, rays);
        };
    }

    study::Cover cover_ = study::make_cover();
    std::shared_ptr<const study::classic::Hittable> classic_ = study::classic::make_world(cover_);
    SceneDescription scene_ = study::cover_scene(cover_);
    ReadyScene<cover_effects> ready_{scene_, width, height};
    Renderer<cover_effects> renderer_{scene_, width, height, {1, cover_.depth, 1}};
};

// The error, measured against the way's own converged picture: two independent pictures
// differ by sqrt(2) times it.
struct Measured {
    double error = 0, ms = 0;
};
Measured measure(const Cover::Way& way, int samples) {
    std::array<Image, 2> images;
    std::uint64_t seed = 0;
    const double ns = study::time_ns(
        [&] { images[seed % 2] = way.draw(samples, seed + 1), ++seed; }, {.rounds = 2});
    return {study::root_mean_square_error(images[0].pixels(), images[1].pixels()) / std::sqrt(2.0),
            1e-6 * ns};
}

}  // namespace

void study_equal_time(study::Report& report) {
    Cover cover;
    std::vector<double> classic;
    for (const Cover::Way& way : cover.ways()) {
        const double sample_ms = measure(way, 8).ms / 8;
        std::size_t row = 0;
        for (const double ms : {80, 200, 600}) {
            const int samples = std::max(1, static_cast<int>(std::lround(ms / sample_ms)));
            const Measured measured = measure(way, samples);
            // A whole number of samples does not take exactly that time.
            const double error = measured.error * std::sqrt(measured.ms / ms);
            if (way.name == "classic") classic.push_back(error);
            report.add({"Equal time", way.name, ms, "time / ms", error, "RMSE in a pixel",
                        static_cast<double>(samples), "samples per pixel"});
            report.add({"Share of the classic error", way.name, ms, "time / ms",
                        error / classic[row++], "RMSE / classic RMSE", static_cast<double>(samples),
                        "samples per pixel"});
        }
    }
}

}  // namespace samples
