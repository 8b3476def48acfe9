// Chapter 11: one scene in four strips of equal cost, each of which shows one step of the chapter.

#include <app/figure.hpp>
#include <app/run.hpp>
#include <atomic>
#include <iomanip>
#include <rt/canvas.hpp>
#include <rt/denoise.hpp>
#include <rt/portable.hpp>
#include <rt/show_description.hpp>
#include <rt/standard_error.hpp>
#include <rt/tone_curve.hpp>
#include <sstream>
#include <thread>

#include "denoise_halves.hpp"
#include "features.hpp"
#include "scene.hpp"
#include "ways.hpp"

namespace {

using namespace samples;

// The exposure of the picture, in stops, and the luminance that becomes white in it.
constexpr Real stops = Real(3.2), white = 24;

// Some columns of the picture.
struct Strip {
    int left = 0, width = 0;
};

struct Sampling {
    const Renderer<scene_effects>& renderer;
    const app::Settings& settings;
    app::Progress& progress;
    std::atomic<std::uint64_t> rays = 0;

    TileGrid grid(const Strip& strip) const { return {strip.width, settings.height, 16}; }
};

// The light of a strip, and the root mean square error, estimated from its samples.
struct Drawn {
    Image light;
    Real error = infinity;
    Halves<Image> half = {};  // if the strip is drawn in two halves
};

Drawn draw_jittered(Sampling& sampling, const Strip& strip) {
    if (strip.width == 0) return {};
    const app::Settings& settings = sampling.settings;
    Drawn drawn{Canvas<Color>{strip.width, settings.height}};
    Canvas<Real> squares{strip.width, settings.height};  // of the pixels' errors
    render_tiles(sampling.grid(strip), settings.threads, [&](const Tile& tile, int) {
        std::uint64_t rays = 0;
        for_each_pixel(tile, [&](int x, int y) {
            std::array<RunningVariance, 3> known;
            const WatchedSamples<JitteredSamples> watched{{*settings.seed, settings.spp}, known};
            drawn.light.at(x, y) = sampling.renderer(watched, strip.left + x, y, rays);
            for (const RunningVariance& channel : known) {
                const Real error = standard_error(channel);
                squares.at(x, y) += error * error / 3;
            }
        });
        sampling.rays += rays;
        sampling.progress.step();
    });
    double sum = 0;
    for (const Real square : squares) sum += static_cast<double>(square);
    drawn.error = static_cast<Real>(std::sqrt(sum / static_cast<double>(squares.size())));
    return drawn;
}

// Draws a strip with Sobol's points, in two halves. The pilot takes `pilot` samples of each pixel
// in each half; the remaining samples go to the tiles where they reduce the error most. `counts`
// gets the number of samples in each pixel.
Drawn draw_halves(Sampling& sampling, const Strip& strip, int pilot, Canvas<int>& counts) {
    if (strip.width == 0) return {};
    const app::Settings& settings = sampling.settings;
    RefinementPlan plan;
    plan.grid = sampling.grid(strip);
    plan.threads = settings.threads;
    plan.seed = *settings.seed;
    plan.make_worker = [&] { return sobol_passes(sampling.renderer, 1, strip.left); };
    Refinement refinement{plan};
    refinement.draw_pilot(pilot);
    refinement.refine_with(std::int64_t{tile_count(plan.grid)} * settings.spp);
    for_each_pixel({0, 0, strip.width, settings.height},
                   [&](int x, int y) { counts.at(x, y) = refinement.passes_at(x, y); });
    sampling.rays += refinement.rays();
    for (int i = 0; i < tile_count(plan.grid); ++i) sampling.progress.step();
    return {refinement.picture(Canvas<Color>{strip.width, settings.height}), refinement.error(),
            refinement.halves()};
}

// Denoises the last strip, which is the right part of the picture with the halves `half`.
Denoised denoise_strip(const Sampling& sampling, const ReadyScene<scene_effects>& scene,
                       const Halves<Image>& half, const Strip& strip) {
    const int height = half.first.height(), skipped = half.first.width() - strip.width;
    Halves<Image> part{Canvas<Color>{strip.width, height}, Canvas<Color>{strip.width, height}};
    Canvas<Features> features{strip.width, height};
    render_tiles(sampling.grid(strip), sampling.settings.threads, [&](const Tile& tile, int) {
        for_each_pixel(tile, [&](int x, int y) {
            part.first.at(x, y) = half.first.at(skipped + x, y);
            part.second.at(x, y) = half.second.at(skipped + x, y);
            // The features take samples of their own: the filter must not follow the noise of the
            // halves.
            features.at(x, y) = features_at(scene, {mix_bits(*sampling.settings.seed), 4},
                                            strip.left + x, y, rt::portable::exp2(-stops));
        });
    });
    return denoise_halves(part, features);
}

// Draws how many samples each pixel of a strip got: the more, the brighter.
void draw_counts(app::Figure map, const Canvas<int>& counts, const Strip& strip, int mean) {
    constexpr std::array<std::uint32_t, 4> colors{0x0b1026, 0x4b2e83, 0xd1495b, 0xffe08a};
    map.fill([&](int column, int row) {
        const int x = column * strip.width / map.columns();
        const int y = row * counts.height() / map.rows();
        const Real ratio = static_cast<Real>(counts.at(x, y)) / static_cast<Real>(mean);
        const Real place =
            std::clamp((rt::portable::log2(ratio) + 2) / 4, Real(0), Real(0.999)) * 3;
        const auto step = static_cast<std::size_t>(place);
        return mix(from_hex(colors[step]), from_hex(colors[step + 1]),
                   place - static_cast<Real>(step));
    });
}

std::string error_text(Real error) {
    std::ostringstream out;
    out << "Error " << std::fixed << std::setprecision(3) << error;
    return std::isfinite(error) ? out.str() : "";
}

// Says how many independent samples per pixel would reach the third strip's error. The number
// follows from the standard error of the jittered strip, which is computed as if its samples were
// independent.
std::string comparison(const Drawn& jittered, const Drawn& worth, int samples) {
    if (!std::isfinite(jittered.error) || !(worth.error > 0)) return "";
    const Real variance = jittered.error * jittered.error * static_cast<Real>(samples);
    return "For the error of the third strip, independent samples would need " +
           std::to_string(samples_for(variance, worth.error, 1'000'000)) + " in each pixel.\n";
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const SceneDescription description = make_scene(*settings.view);
    if (!settings.show.empty())
        return show_description<scene_effects>(description, settings, progress);
    const ReadyScene<scene_effects> scene{description, settings.width, settings.height};
    const Quality quality{settings.spp, settings.depth, *settings.seed};
    const Renderer<scene_effects> renderer{description, settings.width, settings.height, quality};
    Sampling sampling{renderer, settings, progress};

    std::array<Strip, 4> strips;
    for (int i = 0; i < 4; ++i) {
        const auto edge = [&](int k) {
            return static_cast<int>(std::int64_t{settings.width} * k / 4);
        };
        strips[static_cast<std::size_t>(i)] = {edge(i), edge(i + 1) - edge(i)};
    }
    const Strip both{strips[2].left, strips[2].width + strips[3].width};

    Image image = Canvas<Color>{settings.width, settings.height};
    const auto put = [&](const Image& light, int left) {
        for_each_pixel({0, 0, light.width(), light.height()}, [&](int x, int y) {
            image.at(left + x, y) = tone_mapped(exposed(light.at(x, y), stops), white);
        });
    };
    progress.start(tile_count(sampling.grid(strips[0])) + tile_count(sampling.grid(strips[1])) +
                   tile_count(sampling.grid(both)));
    Canvas<int> counts{both.width, settings.height};
    const Drawn jittered = draw_jittered(sampling, strips[0]);
    const Drawn sobol = draw_halves(sampling, strips[1], std::max(1, settings.spp / 2), counts);
    const Drawn worth =
        draw_halves(sampling, both, settings.spp < 4 ? 1 : std::max(2, settings.spp / 4), counts);
    put(jittered.light, strips[0].left);
    put(sobol.light, strips[1].left);
    put(worth.light, both.left);
    const Denoised smooth = denoise_strip(sampling, scene, worth.half, strips[3]);
    put(smooth.picture, strips[3].left);

    app::Figure figure{image, 960, 540};
    const std::string number = std::to_string(settings.spp);
    const std::array<std::array<std::string, 2>, 4> words{
        {{number + " jittered", error_text(jittered.error)},
         {number + " Sobol", error_text(sobol.error)},
         {number + " on average", error_text(worth.error)},
         {"Denoised", error_text(smooth.error)}}};
    const Color ink = from_hex(0xf4ead5);
    for (int i = 0; i < 4; ++i) {
        const Real left = static_cast<Real>(240 * i);
        const auto& lines = words[static_cast<std::size_t>(i)];
        figure.box({left, 500, 240, 40}, {}, Real(0.6));
        if (i > 0) figure.box({left - 1, 0, 2, 540}, {});
        figure.words_around({left + 120, 513}, lines[0], {10, ink});
        figure.words_around({left + 120, 530}, lines[1], {7, ink});
    }
    draw_counts(figure.part({640, 8, 56, 126}), counts, strips[2], settings.spp);
    figure.frame({640, 8, 56, 126}, ink);
    app::Picture picture{std::move(image), sampling.rays};
    picture.words = [words = comparison(jittered, worth, settings.spp)] { return words; };
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.spp = 16;
    defaults.depth = 8;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = 1;
    defaults.view = scene_view();
    return app::run(argc, argv,
                    {.name = "11_samples",
                     .about = "one scene in four strips: jittered samples, Sobol's points, as "
                              "many where they are worth it, and without noise",
                     .defaults = defaults,
                     .render = render,
                     .study = app::program_study,
                     .shows = shown_of_paths()});
}
