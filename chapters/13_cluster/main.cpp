// Chapter 13: chapter 08's picture, drawn by many machines.
//
//     mpirun --bind-to none -n 4 build/bin/13_cluster_solution scene.json
//
// To read in five minutes: main() joins the group; rank 0 reads the options and the scene and tells
// the other ranks what to draw (job.hpp); all ranks share out the picture (share.hpp), and rank 0
// writes it. Started without mpirun, the program draws alone.

#include <app/errors.hpp>
#include <app/run.hpp>
#include <app/threads.hpp>
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
    std::optional<TileStore> store = {};  // if finished tiles are kept
    std::vector<int> lost = {};           // the ranks that no longer answer
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

const fs::path folder_of_tiles = "cluster-tiles";

// Opens the file with the finished tiles of this very picture, drawn by this very program.
void open_store(Job job, std::optional<TileStore>& store) {
    job.threads = 0;
    const std::uint64_t picture = hash_of(packed(job), hash_of_program());
    char name[32];
    std::snprintf(name, sizeof name, "%016llx.tiles", static_cast<unsigned long long>(picture));
    app::make_folder(folder_of_tiles);
    store.emplace(folder_of_tiles / name, TilePlaces{grid_of(job), picture});
}

void send(Job& job, State& state) {
    broadcast(packed(job));
    state.job_is_sent = true;
    job.files.clear();  // they take memory, and are no longer needed
}

void check_tags(const Job& job) {
    if (job.count - 1 > largest_tag())
        throw app::UsageError("--tile: tiles of " + std::to_string(job.tile_side) +
                              " pixels are too many: " + std::to_string(job.count) +
                              ", and MPI numbers messages only up to " +
                              std::to_string(largest_tag()) + "; choose larger ones");
}

// Adds the tiles that earlier runs have finished, so that the others are left to be drawn. Returns
// what to tell the user.
std::string restore(TileStore& store, Collector& collector, Job& job) {
    const int count = job.count;
    job.tiles = store.restore(
        [&](int tile, const std::vector<Color>& pixels) { collector.add_old(tile, pixels); });
    job.count = static_cast<int>(job.tiles.size());
    if (job.count == count) job.tiles.clear();
    std::string words = rt::counted(count - job.count, "tile") + " of " + std::to_string(count) +
                        " came from an earlier run";
    if (store.damaged() > 0)
        words += "; " + rt::counted(store.damaged(), "damaged tile") + " had to be drawn again";
    return words + '\n';
}

app::Picture draw_in_tiles(Job& job, const MeshedDescription& scene, const app::Settings& settings,
                           app::Progress& progress, State& state) {
    job.count = tile_count(grid_of(job));
    check_tags(job);
    if (is_given(settings, "resume")) open_store(job, state.store);
    Image image = Canvas<Color>{job.settings.width, job.settings.height};
    Collector collector{job.count,
                        [&, grid = grid_of(job)](int tile, const std::vector<Color>& pixels) {
                            put_tile(tile_at(grid, tile), pixels, image);
                        },
                        state.store ? &*state.store : nullptr, progress};
    const std::string restored = state.store ? restore(*state.store, collector, job) : "";
    send(job, state);
    TileDrawer drawer{colors_of(scene), settings.threads};
    const Shared shared = share_tiles(job, drawer, &collector);
    state.is_shared = true;
    state.lost = shared.lost;
    if (!collector.error().empty())
        throw app::Failure(collector.error() +
                           ". What is finished is kept: the same command goes on from there");
    if (is_given(settings, "tint")) tint_edge(image, grid_of(job), collector.drawn_by());
    return {std::move(image), shared.rays, [restored] { return restored; }};
}

app::Picture draw_in_group(Job job, const MeshedDescription& scene, const app::Settings& settings,
                           app::Progress& progress, State& state) {
    if (!settings.file.empty()) job.files = files_of(settings.file);
    rehearse();
    app::Picture picture;
    if (job.in_slices) {
        send(job, state);
        picture = share_slices(job, colors_of(scene), settings.threads);
        state.is_shared = true;
    } else {
        picture = draw_in_tiles(job, scene, settings, progress, state);
    }
    picture.words = [more = picture.words, ranks = rank_count(MPI_COMM_WORLD)] {
        return "Drawn by " + rt::counted(ranks, "rank") + '\n' + (more ? more() : "");
    };
    return picture;
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
        return draw_alone(job, colors_of(scene), settings.threads, progress);
    }
    return draw_in_group(job, scene, settings, progress, state);
}

// What all ranks except rank 0 do. They print nothing unless they fail.
int help_rank_0() {
    Job job = unpacked(broadcast({}));
    if (job.is_none) return app::done;
    const int result = app::run_or_explain("13_cluster", [&] {
        const MeshedDescription scene = scene_of(job);
        job.files.clear();  // they take memory, and are no longer needed
        const PixelColor color = colors_of(scene);
        const int threads = app::threads_that_start(job.threads > 0 ? job.threads : own_threads());
        if (job.in_slices) {
            share_slices(job, color, threads);
        } else {
            TileDrawer drawer{color, threads};
            share_tiles(job, drawer, nullptr);
        }
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
    defaults.exposure = 0;
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
    Ranks ranks;
    const int result = app::run_or_explain("13_cluster", [&] {
        ranks = meet_ranks(argc, argv);
        return app::done;
    });
    if (!ranks.are_alike) return result;
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
    if (code == app::done && state.store) {
        state.store->remove();
        state.store.reset();
        std::error_code ignored;
        fs::remove(folder_of_tiles, ignored);  // if it is empty
    }
    if (!state.lost.empty()) {
        for (const int rank : state.lost)
            std::fprintf(stderr, "13_cluster: %s no longer answers; the others drew its tiles\n",
                         ranks.names[static_cast<std::size_t>(rank)].c_str());
        MPI_Abort(MPI_COMM_WORLD, code);  // to end together, all ranks would have to answer
    }
    return code;
}
