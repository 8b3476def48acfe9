// Chapter 13: chapter 08's picture, drawn by many machines.
//
//     mpirun -n 4 build/bin/13_cluster_solution scene.json
//
// To read in five minutes: main() joins the group; rank 0 reads the options and the scene and tells
// the other ranks what to draw (job.hpp); all ranks share out the picture (share.hpp), and rank 0
// writes it. Started without mpirun, the program draws alone.

#include <app/errors.hpp>
#include <app/run.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <rt/counted.hpp>
#include <rt/show_paths.hpp>
#include <thread>

#include "group.hpp"
#include "open_meshed.hpp"
#include "share.hpp"
#include "tile_workers.hpp"
#include "tint.hpp"

namespace {

using namespace cluster;

int own_threads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// How far rank 0 has come.
struct State {
    bool job_is_sent = false, is_shared = false;
    fs::path folder = {};  // of finished tiles; empty if none are kept
};

// Sets the frame of a turntable, 0 ... frames - 1, and the side of the tiles, as the options ask
// for them.
void choose_frame(const app::Settings& settings, Job& job) {
    const auto number = [&](const char* name) {
        const auto found = settings.numbers.find(name);
        if (found == settings.numbers.end()) return 0;
        constexpr double most = std::numeric_limits<int>::max();
        if (found->second > most || found->second != std::floor(found->second))
            throw app::UsageError("--" + std::string{name} +
                                  ": must be a whole number up to 2147483647");
        return static_cast<int>(found->second);
    };
    const int frame = number("frame"), frames = number("frames"), side = number("tile");
    if ((frame > 0) != (frames > 0) || frame > frames)
        throw app::UsageError(
            "--frame and --frames go together: --frame 1 to --frame N of --frames N");
    if (frames > 0) job.frame = frame - 1, job.frames = frames;
    if (side > 0) job.tile_side = side;
}

bool is_given(const app::Settings& settings, const char* name) {
    return settings.given.count(name) > 0;
}

// The folder with the finished tiles of this very picture, drawn by this very program.
fs::path folder_of_tiles(Job job) {
    job.threads = 0;
    char name[32];
    std::snprintf(name, sizeof name, "%016llx",
                  static_cast<unsigned long long>(hash_of(packed(job)) ^ hash_of_program()));
    return fs::path{"cluster-tiles"} / name;
}

app::Picture draw_alone(const Job& job, const MeshedDescription& scene,
                        const app::Settings& settings, app::Progress& progress) {
    TileDrawer drawer{scene, settings.threads};
    const TileGrid grid = grid_of(job);
    Image image = Canvas<Color>{grid.width, grid.height};
    std::uint64_t rays = 0;
    progress.start(tile_count(grid));
    for (int index = 0; index < tile_count(grid); ++index) {
        const Tile tile = tile_at(grid, index);
        const std::vector<Color> pixels = drawer.draw(tile, rays);
        std::size_t next = 0;
        for_each_pixel(tile, [&](int x, int y) { image.at(x, y) = pixels[next++]; });
        progress.step();
    }
    return {std::move(image), rays};
}

app::Picture draw_in_group(Job job, const MeshedDescription& scene, const app::Settings& settings,
                           app::Progress& progress, State& state) {
    if (!settings.file.empty()) job.files = files_of(settings.file);
    rehearse();
    if (is_given(settings, "resume")) {
        state.folder = folder_of_tiles(job);
        app::make_folder(state.folder);
    }
    const int count = tile_count(grid_of(job));
    if (!job.in_slices && count - 1 > largest_tag())
        throw app::UsageError("--tile: tiles of " + std::to_string(job.tile_side) +
                              " pixels are too many: " + std::to_string(count) +
                              ", and MPI numbers messages only up to " +
                              std::to_string(largest_tag()) + "; choose larger ones");
    if (state.folder.empty())
        for (int tile = 0; tile < count; ++tile) job.tiles.push_back(tile);
    else
        job.tiles = missing_tiles(state.folder, count);

    Collector collector{job, state.folder, progress};
    for (int tile = 0, next = 0; tile < count; ++tile)
        if (next < static_cast<int>(job.tiles.size()) &&
            job.tiles[static_cast<std::size_t>(next)] == tile)
            ++next;
        else
            collector.add_old(tile);

    broadcast(packed(job));
    state.job_is_sent = true;
    TileDrawer drawer{scene, settings.threads};
    const std::uint64_t rays = job.in_slices ? share_slices(job, drawer, &collector.image())
                                             : share_tiles(job, drawer, &collector);
    state.is_shared = true;
    if (!collector.error().empty())
        throw app::Failure(collector.error() +
                           ". What is finished is kept: the same command goes on from there");
    if (is_given(settings, "tint"))
        tint_edge(collector.image(), grid_of(job), collector.drawn_by());
    return {std::move(collector.image()), rays, [ranks = rank_count(MPI_COMM_WORLD)] {
                return "Drawn by " + rt::counted(ranks, "rank") + '\n';
            }};
}

app::Picture render(const app::Settings& settings, app::Progress& progress, State& state) {
    MeshedDescription scene = full_renderer::open_scene(settings);
    if (!settings.show.empty()) return full_renderer::show_scene(scene, settings, progress);
    Job job;
    job.settings = scene.settings;
    job.in_slices = settings.choice("share") == "slices";
    choose_frame(settings, job);
    turn_to_frame(scene, job);
    if (is_given(settings, "threads")) job.threads = settings.threads;
    if (job.in_slices && (is_given(settings, "resume") || is_given(settings, "tint")))
        throw app::UsageError("--share slices has no tiles: leave out --resume and --tint");
    if (!has_group()) {
        for (const char* const option : {"resume", "tint"})
            if (is_given(settings, option))
                throw app::UsageError("--" + std::string{option} +
                                      " needs ranks: start the program with mpirun -n 2");
        return draw_alone(job, scene, settings, progress);
    }
    return draw_in_group(job, scene, settings, progress, state);
}

// What all ranks except rank 0 do. They print nothing unless they fail.
int help_rank_0() {
    const Job job = unpacked(broadcast({}));
    if (job.is_none) return app::done;
    const int result = app::run_or_explain("13_cluster", [&] {
        const MeshedDescription scene = scene_of(job);
        TileDrawer drawer{scene, job.threads > 0 ? job.threads : own_threads()};
        if (job.in_slices)
            share_slices(job, drawer, nullptr);
        else
            share_tiles(job, drawer, nullptr);
        return app::done;
    });
    if (result != app::done) MPI_Abort(MPI_COMM_WORLD, result);
    return result;
}

app::Program program(State& state) {
    const RenderSettings usual;  // what chapter 08 draws
    app::Settings defaults;
    defaults.width = usual.width;
    defaults.height = usual.height;
    defaults.spp = usual.samples_per_pixel;
    defaults.depth = usual.depth;
    defaults.threads = own_threads();
    defaults.seed = usual.seed;
    return {.name = "13_cluster",
            .about = "chapter 08's picture, drawn by all ranks that mpirun starts",
            .defaults = defaults,
            .render = [&](const app::Settings& settings,
                          app::Progress& progress) { return render(settings, progress, state); },
            .study = app::program_study,
            .choices = {{"share",
                         "What the ranks share out: tiles, or a slice of the rows for each",
                         {"tiles", "slices"}}},
            .flags = {{"resume",
                       "Keep finished tiles in the folder cluster-tiles, and draw only those that "
                       "an earlier run of the same command did not finish"},
                      {"tint", "Tint the tiles at the picture's edge by the rank that drew them"}},
            .numbers = {{"tile", "The side of a tile in pixels; 32 unless told otherwise"},
                        {"frame", "Which frame of a turntable to draw, from 1 to --frames"},
                        {"frames", "How many frames a full turn of the camera has"}},
            .shows = rt::shown_of_paths(),
            .reads = "The scene file, .json; without it the final scene is drawn"};
}

}  // namespace

int main(int argc, char** argv) {
    State state;
    app::Program first = program(state);
    if (!has_group()) return app::run(argc, argv, first);
    const Membership membership{argc, argv};
    bool is_alike = false;
    const int result = app::run_or_explain("13_cluster", [&] {
        is_alike = all_alike(argc, argv);
        return app::done;
    });
    if (!is_alike) return result;
    if (rank_of(MPI_COMM_WORLD) > 0) return help_rank_0();
    first.has_terminal = mpirun_has_terminal();
    const int code = app::run(argc, argv, first);
    if (!state.job_is_sent) {
        Job none;
        none.is_none = true;
        broadcast(packed(none));
    } else if (!state.is_shared) {  // rank 0 failed in the middle, and the others wait for it
        MPI_Abort(MPI_COMM_WORLD, code);
    }
    if (code == app::done && !state.folder.empty()) {
        std::error_code ignored;
        fs::remove_all(state.folder, ignored);
        fs::remove("cluster-tiles", ignored);  // if it is empty
    }
    return code;
}
