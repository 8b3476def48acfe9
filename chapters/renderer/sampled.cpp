// What draws if --sampler, --filter, --target-error or --time-budget is given.

#include <app/errors.hpp>
#include <app/interrupt.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <rt/choose_renderer.hpp>
#include <rt/false_colors.hpp>
#include <span>
#include <utility>

#include "batch_workers.hpp"
#include "batched.hpp"
#include "few_effects.hpp"
#include "lit_meshes.hpp"
#include "sampled_meshes.hpp"
#include "tile_workers.hpp"

namespace full_renderer {
namespace {

using namespace rt;
using Clock = std::chrono::steady_clock;

constexpr int samples_of_pass = 4;
constexpr int pilot_passes = 2;  // of each half

// Draws passes path by path, with Sobol's points or with jittered samples.
template <Effects effects>
DrawPass make_draw_pass(const MeshedDescription& scene, int width, int height,
                        const Quality& quality, bool sobol) {
    return kept_passes(std::make_shared<const Renderer<effects>>(scene, width, height, quality),
                       quality.samples_per_pixel, sobol);
}

constexpr auto makers = for_few_effects([]<Effects effects> { return &make_draw_pass<effects>; });

using Batches = BatchRenderer<batch_effects, SobolPoints>;

// The side of tiles that are filtered with a tent. The larger the tiles are, the fewer pixels are
// sampled for more than one tile.
constexpr int tent_tile_side = 64;

template <Effects effects>
DrawTile make_draw_tent(const MeshedDescription& scene, int width, int height,
                        const Quality& quality) {
    return kept_tent(std::make_shared<const Renderer<effects>>(scene, width, height, quality),
                     quality);
}

constexpr auto tent_makers =
    for_few_effects([]<Effects effects> { return &make_draw_tent<effects>; });

// The renderer that is chosen for a scene, and the function that makes it.
template <class Make>
std::pair<Choice, Make> chosen(const MeshedDescription& scene,
                               const std::array<Make, few_effects.size()>& for_spheres,
                               Make for_meshes) {
    if (!scene.meshes.empty() || has_sky_or_rough(scene))
        return {effects::choice_of(std::span{few_effects}.last(1), 0), for_meshes};
    const std::size_t number = narrowest(needed_effects(scene), few_effects);
    return {effects::choice_of(few_effects, number), for_spheres[number]};
}

// Draws passes, as TileWorkers draw pictures.
struct PassWorkers {
    Choice choice;
    std::function<DrawPass()> make_worker;
    int tile_side = 16;
};

const Choice in_batches_choice{batch_effects, "in batches"};

PassWorkers make_batched_passes(const MeshedDescription& scene, int width, int height,
                                const Quality& quality, bool sobol) {
    const int count = quality.samples_per_pixel, side = batch_tile_side(count);
    if (sobol)
        return {in_batches_choice,
                batch_workers<SobolPoints>(
                    scene, width, height, quality,
                    [count](Batches& renderer, const Tile& tile, const Pass& pass, Image& image,
                            std::uint64_t& rays) {
                        renderer.draw({sobol_samples(pass, count)}, tile, image, rays);
                    }),
                side};
    const auto make_worker = [make = jittered_batches(scene, width, height, quality)] {
        return [draw = make()](const Tile& tile, const Pass& pass, Image& image,
                               std::uint64_t& rays) { draw(tile, seed_of(pass), image, rays); };
    };
    return {in_batches_choice, make_worker, side};
}

PassWorkers make_passes(const MeshedDescription& scene, int width, int height,
                        const Quality& quality, bool sobol, bool in_batches) {
    if (in_batches && can_be_batched(scene))
        return make_batched_passes(scene, width, height, quality, sobol);
    const auto [choice, make] = chosen(scene, makers, &make_meshed_passes);
    const DrawPass draw = make(scene, width, height, quality, sobol);
    return {choice, [draw] { return draw; }};
}

std::string text_of(const char* format, double number) {
    char text[64];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

// What the program prints about a refined picture: its error, and how many samples the pixels took.
std::string result(const Refinement& refinement, int width, int height) {
    int fewest = refinement.passes_at(0, 0), most = fewest;
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int passes = refinement.passes_at(x, y);
            fewest = std::min(fewest, passes);
            most = std::max(most, passes);
            sum += passes;
        }
    return "error:    " + text_of("%.3g", static_cast<double>(refinement.error())) +
           " of white, estimated (root mean square over all channels)\nsamples:  " +
           text_of("%.0f", samples_of_pass * sum / (double{1} * width * height)) +
           " a pixel on average, " + std::to_string(samples_of_pass * fewest) + " to " +
           std::to_string(samples_of_pass * most) + '\n';
}

// Draws in false colors how many samples each pixel took.
void show_samples(const Refinement& refinement, app::Picture& picture) {
    const int width = picture.image.width(), height = picture.image.height();
    std::vector<Shown> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels.push_back(static_cast<Real>(samples_of_pass * refinement.passes_at(x, y)));
    auto [image, words] = false_colors(width, height, pixels, "the samples that a pixel took");
    picture.image = std::move(image);
    picture.words = [before = picture.words, words = words] { return before() + words; };
}

void check_together(const app::Settings& settings) {
    const auto given = [&](const char* option) { return settings.given.count(option) > 0; };
    if (given("target-error") && given("time-budget"))
        throw app::UsageError("--target-error and --time-budget exclude each other; name one");
    for (const char* const aim : {"target-error", "time-budget"})
        if (given(aim) && given("spp"))
            throw app::UsageError("--spp and --" + std::string{aim} +
                                  " exclude each other: with the latter, the program finds out how "
                                  "many samples it needs");
}

// Refines until `end`, in rounds. Each round draws half of the passes for which there is still
// time, so that it is well known before the last round how many passes still fit.
void refine_within(Refinement& refinement, Clock::time_point start, Clock::time_point end) {
    for (Clock::time_point now; (now = Clock::now()) < end && app::Interruption::signal() == 0;) {
        const std::chrono::duration<double> spent = now - start, left = end - now;
        const auto passes = static_cast<double>(refinement.passes());
        const double more = passes * (left / spent);
        const bool is_last = left < spent / 8;
        refinement.refine_with(static_cast<std::int64_t>(passes + (is_last ? 2 : 0.5) * more) + 1);
    }
}

}  // namespace

// Draws all samples of a pixel in one pass.
TileWorkers make_sobol(const MeshedDescription& scene, int width, int height,
                       const Quality& quality, bool in_batches) {
    const PassWorkers passes = make_passes(scene, width, height, quality, true, in_batches);
    const auto make_worker = [make = passes.make_worker, seed = quality.seed] {
        return [draw = make(), seed](const Tile& tile, Image& image, std::uint64_t& rays) {
            draw(tile, {seed, 0}, image, rays);
            return pixel_count(tile);
        };
    };
    return {passes.choice, make_worker, passes.tile_side};
}

TileWorkers make_tent(const MeshedDescription& scene, int width, int height, const Quality& quality,
                      bool in_batches) {
    if (in_batches && can_be_batched(scene))
        return {in_batches_choice,
                batch_workers<SobolPoints>(
                    scene, width, height, quality,
                    [samples = SobolSamples{quality.seed, quality.samples_per_pixel}](
                        Batches& renderer, const Tile& tile, Image& image, std::uint64_t& rays) {
                        draw_with_tent(renderer, samples, tile, image, rays);
                        return pixel_count(tile);
                    }),
                tent_tile_side};
    const auto [choice, make] = chosen(scene, tent_makers, &make_meshed_tent);
    const DrawTile draw = make(scene, width, height, quality);
    return {choice, [draw] { return draw; }, tent_tile_side};
}

app::Picture refine(const MeshedDescription& scene, const app::Settings& settings,
                    const std::function<void(const Choice&)>& explain, app::Progress& progress) {
    const auto start = Clock::now();
    check_together(settings);
    const int width = scene.settings.width, height = scene.settings.height;
    const Quality quality{samples_of_pass, scene.settings.depth, scene.settings.seed};
    const bool in_batches = settings.given.count("batches") > 0;
    // Sobol's points, unless jittered samples are asked for.
    const bool sobol =
        settings.given.count("sampler") == 0 || settings.choice("sampler") == "sobol";
    const PassWorkers drawing = make_passes(scene, width, height, quality, sobol, in_batches);
    explain(drawing.choice);

    // Writing the file takes time, too.
    const auto file_time = std::chrono::nanoseconds{100} * width * height;
    auto end = Clock::time_point::max();
    if (const auto budget = settings.numbers.find("time-budget"); budget != settings.numbers.end())
        end = start - file_time +
              std::chrono::duration_cast<Clock::duration>(
                  std::chrono::duration<double>{std::min(budget->second, 1e9)});
    const app::Interruption interruption;
    Refinement refinement{
        {.grid = {width, height, drawing.tile_side},
         .threads = settings.threads,
         .seed = quality.seed,
         .make_worker =
             [&] {
                 return [&progress, draw = drawing.make_worker()](
                            const Tile& tile, const Pass& pass, Image& image, std::uint64_t& rays) {
                     draw(tile, pass, image, rays);
                     progress.step();
                 };
             },
         .is_over = [end] { return app::Interruption::signal() != 0 || Clock::now() >= end; },
         .on_round =
             [&](std::int64_t passes) {
                 progress.start(static_cast<int>(std::min<std::int64_t>(passes, 1 << 30)));
             }}};
    refinement.draw_pilot(pilot_passes);
    const auto target = settings.numbers.find("target-error");
    if (target != settings.numbers.end())
        refinement.refine_to(static_cast<Real>(target->second));
    else
        refine_within(refinement, start, end);

    Image unfinished = Canvas<Color>{width, height};
    app::draw_unfinished(unfinished);
    app::Picture picture{refinement.picture(std::move(unfinished)), refinement.rays()};
    picture.words = [words = result(refinement, width, height)] { return words; };
    if (settings.show == "samples") show_samples(refinement, picture);
    if (const int signal = interruption.signal()) picture.stopped = {signal, refinement.share()};
    return picture;
}

}  // namespace full_renderer
