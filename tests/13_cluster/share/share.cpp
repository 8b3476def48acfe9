// What share.hpp lets a rank do, with colors that take no time to compute:
//
//     share_test threads               whatever the size of a tile, all 16 threads of a rank draw
//     share_test files                 a scene's files have a limit together
//     mpirun -n 2 share_test memory    what a rank allocates does not depend on the picture's size
//
// Prints what is wrong, and then ends with 1.

#include <malloc.h>

#include <cstdlib>
#include <fstream>
#include <new>
#include <rt/compiler.hpp>
#include <set>

#include "group.hpp"
#include "share.hpp"

namespace {

using namespace rt;
using namespace cluster;

std::atomic<std::size_t> allocated = 0, most_allocated = 0;  // bytes

int failures = 0;
void complain(const std::string& words) {
    std::printf("rank %d: %s\n", rank_of(MPI_COMM_WORLD), words.c_str());
    ++failures;
}

const PutTile nowhere = [](int, const std::vector<Color>&) {};

void share(const Job& job, const PixelColor& color, int threads) {
    app::Progress progress{false};
    std::optional<Collector> collector;
    if (rank_of(MPI_COMM_WORLD) == 0)
        collector.emplace(tile_count(grid_of(job)), nowhere, nullptr, progress);
    // The tiles that are not to be drawn.
    for (int tile = job.count; collector && tile < tile_count(grid_of(job)); ++tile)
        collector->add_old(tile, {});
    TileDrawer drawer{color, threads};
    share_tiles(job, drawer, collector ? &*collector : nullptr);
}

Job job_of(int picture_side, int tile_side) {
    Job job;
    job.settings.width = job.settings.height = picture_side;
    job.tile_side = tile_side;
    job.count = tile_count(grid_of(job));
    return job;
}

// Colors whose first pixel in each thread waits until so many threads are drawing, or until it is
// clear after 5 seconds that there are fewer.
class AllThreads {
  public:
    explicit AllThreads(std::size_t wanted) : wanted_{wanted} {}

    PixelColor color() {
        return [this](int, int, std::uint64_t&) {
            std::unique_lock lock{mutex_};
            if (are_fewer_) return Color{};
            if (threads_.insert(std::this_thread::get_id()).second) more_.notify_all();
            const auto are_here = [&] { return are_fewer_ || threads_.size() == wanted_; };
            if (!more_.wait_for(lock, std::chrono::seconds{5}, are_here)) are_fewer_ = true;
            return Color{};
        };
    }
    std::size_t count() const { return threads_.size(); }

  private:
    std::size_t wanted_;
    bool are_fewer_ = false;
    std::mutex mutex_;
    std::condition_variable more_;
    std::set<std::thread::id> threads_;
};

void all_threads_draw() {
    constexpr int threads = 16;
    for (const int side : {1, 4, 8, 16, 32, 64, 200}) {
        const Job job = job_of(5 * side, side);
        AllThreads in_group{threads}, alone{threads};
        share(job, in_group.color(), threads);
        app::Progress progress{false};
        draw_alone(job, alone.color(), threads, progress);
        for (const auto& [where, found] :
             {std::pair{"in a group", in_group.count()}, std::pair{"alone", alone.count()}})
            if (found != threads)
                complain("25 tiles of " + std::to_string(side) + ", " + where + ": " +
                         std::to_string(found) + " of 16 threads draw");
    }
}

// The most bytes that this rank had allocated while the ranks drew four tiles of a picture.
std::size_t memory_for(int picture_side) {
    Job job = job_of(picture_side, 32);
    job.count = 4;
    std::atomic<int> drawn = 0;
    const std::size_t before = most_allocated = allocated.load();
    share(
        job,
        [&](int x, int y, std::uint64_t&) {
            if (x % 32 == 0 && y % 32 == 0) {
                ++drawn;
                std::this_thread::sleep_for(std::chrono::milliseconds{100});
            }
            return Color{};
        },
        1);
    if (drawn == 0) complain("this rank has not drawn a tile");
    return most_allocated - before;
}

void memory_is_that_of_tiles() {
    const std::size_t small = memory_for(1000), large = memory_for(8000);
    // How many tiles a rank has at a time differs from run to run. Besides, rank 0 knows of each
    // tile which rank has drawn it.
    const std::size_t tiles = 4 * 32 * 32 * sizeof(Color),
                      allowed =
                          tiles + (rank_of(MPI_COMM_WORLD) == 0 ? 250 * 250 * sizeof(int) : 0);
    if (large > small + allowed)
        complain(std::to_string(small) + " bytes for 1000 x 1000 pixels, but " +
                 std::to_string(large) + " for 8000 x 8000");
}

// The scene's files are counted before they are sent, also those that its meshes name.
void scene_files_are_limited() {
    const fs::path folder = fs::temp_directory_path() / ("scene." + std::to_string(::getpid()));
    fs::create_directories(folder);
    const auto write = [&](const char* name, std::string text) {
        text.resize(std::max(text.size(), std::size_t{1000}), '\n');
        std::ofstream{folder / name} << text;
    };
    write("scene.json",
          R"({"camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0]}, "materials": {},
              "meshes": [{"file": "one.obj"}, {"file": "one.obj", "center": [1, 0, 0]}]})");
    write("one.obj", "mtllib all.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    write("all.mtl", "newmtl red\nKd 1 0 0\n");
    Job job;
    job.files = files_of(folder / "scene.json", 3000);
    if (job.files.size() != 3)
        complain("expected 3 files, actual " + std::to_string(job.files.size()));
    try {
        files_of(folder / "scene.json", 2999);
        complain("files that are too large together are accepted");
    } catch (const app::UsageError&) {
    }
    fs::remove_all(folder);
    // Another rank has nothing but the job.
    if (scene_of(job).meshes.size() != 2) complain("a mesh is lost");
}

}  // namespace

RT_NOT_INLINED void* operator new(std::size_t size) {
    void* const memory = std::malloc(size);
    if (!memory) throw std::bad_alloc{};
    const std::size_t now = allocated += ::malloc_usable_size(memory);
    for (std::size_t most = most_allocated; most < now;)
        if (most_allocated.compare_exchange_weak(most, now)) break;
    return memory;
}
RT_NOT_INLINED void operator delete(void* memory) noexcept {
    allocated -= ::malloc_usable_size(memory);
    std::free(memory);
}
RT_NOT_INLINED void operator delete(void* memory, std::size_t) noexcept {
    operator delete(memory);
}

int main(int argc, char** argv) {
    const Membership membership{argc, argv};
    if (argc > 1 && argv[1] == std::string{"threads"})
        all_threads_draw();
    else if (argc > 1 && argv[1] == std::string{"files"})
        scene_files_are_limited();
    else
        memory_is_that_of_tiles();
    return failures > 0;
}
