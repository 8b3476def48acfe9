// Chapter 11: the same part of a scene in four strips, each of which shows one step of the chapter.
// All take the same number of samples.

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
struct Columns {
    int left = 0, width = 0;
};

struct Sampling {
    const Renderer<scene_effects>& renderer;
    const app::Settings& settings;
    app::Progress& progress;
    std::atomic<std::uint64_t> rays = 0;

    TileGrid grid(const Columns& columns) const { return {columns.width, settings.height, 16}; }
};

// The light in some columns, and the root mean square error, estimated from their samples.
struct Drawn {
    Image light;
    Real error = infinity;
    Halves<Image> half = {};  // if they are drawn in two halves
};

Drawn draw_jittered(Sampling& sampling, const Columns& columns) {
    const app::Settings& settings = sampling.settings;
    Drawn drawn{Canvas<Color>{columns.width, settings.height}};
    Canvas<Real> squares{columns.width, settings.height};  // of the pixels' errors
    render_tiles(sampling.grid(columns), settings.threads, [&](const Tile& tile, int) {
        std::uint64_t rays = 0;
        for_each_pixel(tile, [&](int x, int y) {
            std::array<RunningVariance, 3> known;
            const WatchedSamples<JitteredSamples> watched{{*settings.seed, settings.spp}, known};
            drawn.light.at(x, y) = sampling.renderer(watched, columns.left + x, y, rays);
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

// Draws some columns with Sobol's points, in two halves. The pilot takes `pilot` samples of each
// pixel in each half; the remaining samples go to the tiles where they reduce the error most.
// `counts` gets the number of samples in each pixel.
Drawn draw_halves(Sampling& sampling, const Columns& columns, int pilot, Canvas<int>& counts) {
    const app::Settings& settings = sampling.settings;
    RefinementPlan plan;
    plan.grid = sampling.grid(columns);
    plan.threads = settings.threads;
    plan.seed = *settings.seed;
    plan.make_worker = [&] { return sobol_passes(sampling.renderer, 1, columns.left); };
    Refinement refinement{plan};
    refinement.draw_pilot(pilot);
    refinement.refine_with(std::int64_t{tile_count(plan.grid)} * settings.spp);
    for_each_pixel({0, 0, columns.width, settings.height},
                   [&](int x, int y) { counts.at(x, y) = refinement.passes_at(x, y); });
    sampling.rays += refinement.rays();
    for (int i = 0; i < tile_count(plan.grid); ++i) sampling.progress.step();
    return {refinement.picture(Canvas<Color>{columns.width, settings.height}), refinement.error(),
            refinement.halves()};
}

// Removes the noise of two halves of some columns.
Denoised without_noise(const Sampling& sampling, const ReadyScene<scene_effects>& scene,
                       const Halves<Image>& half, const Columns& columns) {
    Canvas<Features> features{columns.width, half.first.height()};
    render_tiles(sampling.grid(columns), sampling.settings.threads, [&](const Tile& tile, int) {
        for_each_pixel(tile, [&](int x, int y) {
            // The features take samples of their own: the filter must not follow the noise of the
            // halves.
            features.at(x, y) = features_at(scene, {mix_bits(*sampling.settings.seed), 4},
                                            columns.left + x, y, rt::portable::exp2(-stops));
        });
    });
    return denoise_halves(half, features);
}

// Draws how many samples each pixel got: the more, the brighter.
void draw_counts(app::Figure map, const Canvas<int>& counts, int mean) {
    constexpr std::array<std::uint32_t, 4> colors{0x0b1026, 0x4b2e83, 0xd1495b, 0xffe08a};
    map.fill([&](int column, int row) {
        const int x = column * counts.width() / map.columns();
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

    const auto edge = [&](int k) { return static_cast<int>(std::int64_t{settings.width} * k / 4); };
    const Columns part{edge(2), settings.width - edge(3)};
    Image image = Canvas<Color>{settings.width, settings.height};
    const auto put = [&](const Image& light, int strip) {
        for_each_pixel({0, 0, edge(strip + 1) - edge(strip), settings.height}, [&](int x, int y) {
            image.at(edge(strip) + x, y) = tone_mapped(exposed(light.at(x, y), stops), white);
        });
    };
    progress.start(3 * tile_count(sampling.grid(part)));
    Canvas<int> counts{part.width, settings.height};
    const Drawn jittered = draw_jittered(sampling, part);
    const Drawn sobol = draw_halves(sampling, part, std::max(1, settings.spp / 2), counts);
    const Drawn worth =
        draw_halves(sampling, part, settings.spp < 4 ? 1 : std::max(2, settings.spp / 4), counts);
    const Denoised smooth = without_noise(sampling, scene, worth.half, part);
    put(jittered.light, 0);
    put(sobol.light, 1);
    put(worth.light, 2);
    put(smooth.picture, 3);

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
    draw_counts(figure.part({640, 8, 56, 126}), counts, settings.spp);
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
    return app::run(
        argc, argv,
        {.name = "11_samples",
         .about = "a part of a scene in four strips: jittered samples, Sobol's points, as "
                  "many where they are worth it, and without noise",
         .defaults = defaults,
         .render = render,
         .study = app::program_study,
         .shows = shown_of_paths()});
}
