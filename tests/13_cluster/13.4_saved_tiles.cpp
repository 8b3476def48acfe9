#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <rt/rng.hpp>
#include <rt/saved_tiles.hpp>
#include <rt/todo.hpp>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

using namespace checkpoint;
using rt::Color;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> names_in(const TemporaryFolder& folder) {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator{folder.path()})
        all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<Color> some_pixels(unsigned seed, int count) {
    rt::Rng random{seed, 13};
    std::vector<Color> pixels(static_cast<std::size_t>(count));
    for (Color& pixel : pixels) pixel = {random.uniform(), random.uniform(), random.uniform()};
    return pixels;
}

// Checks what is read from the file of a tile, without printing all of its pixels.
void check_tile(const fs::path& folder, int tile, const std::vector<Color>& expected) {
    const std::vector<Color> actual = rt::load_tile(folder, tile);
    const bool same = actual == expected;
    INFO("tile " << tile << ": " EXPECTED << expected.size()
                 << " pixels as they were saved, " ACTUAL << actual.size()
                 << (actual.size() == expected.size() ? " other pixels" : ""));
    CHECK(same);
}

// Saves a tile in another process, in which no file may get larger than `bytes`: there a program
// is ended (as a machine dies) in the middle of writing. Returns the signal that ended it.
int save_and_die(const fs::path& folder, int tile, const std::vector<Color>& pixels, rlim_t bytes) {
    const pid_t process = ::fork();
    if (process == 0) {
        const rlimit limit{bytes, bytes}, none{0, 0};
        ::setrlimit(RLIMIT_CORE, &none);
        ::setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_DFL);
        try {
            rt::save_tile(folder, tile, pixels);
        } catch (...) {
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

TEST_CASE("13.4 a tile is read as it was written", "[13.4]") {
    const TemporaryFolder folder;
    for (const int count : {1, 7, 256, 4096}) {
        const std::vector<Color> pixels = some_pixels(1, count);
        rt::save_tile(folder.path(), count, pixels);
        INFO("tile " << count << ", with the same number of pixels, in the file "
                     << rt::tile_file(folder.path(), count).filename());
        REQUIRE(fs::exists(rt::tile_file(folder.path(), count)));
        {
            INFO("Hint: each pixel takes sizeof(Color) bytes");
            CHECK(fs::file_size(rt::tile_file(folder.path(), count)) ==
                  pixels.size() * sizeof(Color));
        }
        INFO("Hint: open the file with std::ios::binary");
        check_tile(folder.path(), count, pixels);
    }
}

TEST_CASE("13.4 a new version of a tile replaces the older one", "[13.4]") {
    const TemporaryFolder folder;
    for (const unsigned version : {1, 2, 3}) {
        const std::vector<Color> pixels = some_pixels(version, static_cast<int>(100 / version));
        rt::save_tile(folder.path(), 5, pixels);
        INFO("version " << version);
        check_tile(folder.path(), 5, pixels);
        INFO("Hint: rename the finished file; a copy would leave two files");
        CHECK(names_in(folder) == std::vector<std::string>{"5.tile"});
    }
    // A second name of the file, which would see if its content changed.
    const fs::path other = rt::tile_file(folder.path(), 6);
    fs::create_hard_link(rt::tile_file(folder.path(), 5), other);
    rt::save_tile(folder.path(), 5, some_pixels(4, 7));
    check_tile(folder.path(), 5, some_pixels(4, 7));
    INFO(
        "the older file of the tile was written over.\nHint: rename the finished file; a copy is "
        "not whole while it is being made");
    check_tile(folder.path(), 6, some_pixels(3, 33));
}

TEST_CASE("13.4 the folder may be on any disk", "[13.4]") {
    // Where there is one, a folder that is kept in memory, which counts as a disk of its own.
    const fs::path memory = "/dev/shm", usual = fs::temp_directory_path();
    const TemporaryFolder folder{::access(memory.c_str(), W_OK) == 0 ? memory : usual};
    std::string error = "none";
    try {
        rt::save_tile(folder.path(), 3, some_pixels(1, 7));
    } catch (const std::runtime_error& thrown) {
        error = thrown.what();
    }
    INFO("a tile is saved in " << folder.path() << ". Error: " << error);
    INFO("Hint: a file cannot be renamed from one disk to another: write it in the same folder");
    REQUIRE(fs::exists(rt::tile_file(folder.path(), 3)));
    check_tile(folder.path(), 3, some_pixels(1, 7));
}

TEST_CASE("13.4 tiles without a file are reported as missing", "[13.4]") {
    const TemporaryFolder folder;
    CHECK(rt::missing_tiles(folder.path(), 4) == std::vector{0, 1, 2, 3});
    for (const int tile : {0, 2, 3, 11}) rt::save_tile(folder.path(), tile, some_pixels(1, 4));
    INFO("The tiles 0, 2, 3 and 11 have files");
    CHECK(rt::missing_tiles(folder.path(), 5) == std::vector{1, 4});
    CHECK(rt::missing_tiles(folder.path(), 12) == std::vector{1, 4, 5, 6, 7, 8, 9, 10});
    CHECK(rt::missing_tiles(folder.path(), 1).empty());
    CHECK(rt::missing_tiles(folder.path(), 0).empty());
}

TEST_CASE("13.4 a program that dies leaves a whole file or none", "[13.4]") {
    // Of a small tile, nothing is written before the file is closed.
    for (int i = 0; i < 6; ++i) {
        const int count = i < 3 ? 4096 : 7;
        const double part = std::array{0.1, 0.5, 0.9}[static_cast<std::size_t>(i % 3)];
        const std::vector<Color> pixels = some_pixels(1, count), older = some_pixels(2, count);
        const TemporaryFolder folder;
        // With a stub there is nothing to die in.
        CHECK(rt::missing_tiles(folder.path(), 2).size() == 2);
        rt::save_tile(folder.path(), 1, older);
        const auto bytes =
            static_cast<rlim_t>(part * static_cast<double>(pixels.size() * sizeof(Color)));
        INFO("the program dies after writing " << bytes << " of " << pixels.size() * sizeof(Color)
                                               << " bytes");
        REQUIRE(save_and_die(folder.path(), 0, pixels, bytes) == SIGXFSZ);
        {
            INFO(
                "Hint: write to a file of another name first. Rename it only when it is whole: "
                "after close()");
            CHECK(rt::missing_tiles(folder.path(), 2) == std::vector{0});
        }
        REQUIRE(save_and_die(folder.path(), 1, pixels, bytes) == SIGXFSZ);
        INFO("an older file of the tile existed");
        check_tile(folder.path(), 1, older);
        // What a dead program left does not stand in the way.
        rt::save_tile(folder.path(), 0, pixels);
        check_tile(folder.path(), 0, pixels);
    }
}

TEST_CASE("13.4 a full disk causes an exception", "[13.4][hard]") {
    const std::vector<Color> older = some_pixels(2, 100);
    const TemporaryFolder folder;
    rt::save_tile(folder.path(), 1, older);
    // What a small tile writes may be refused only when the file is closed.
    for (const int count : {4096, 7})
        for (const int tile : {0, 1}) {
            const std::vector<Color> pixels = some_pixels(1, count);
            const std::size_t bytes = pixels.size() * sizeof(Color);
            for (const std::size_t room : {std::size_t{0}, bytes / 2, bytes - 1}) {
                rlimit usual{};
                ::getrlimit(RLIMIT_FSIZE, &usual);
                const rlimit limit{room, usual.rlim_max};
                const auto old = std::signal(SIGXFSZ, SIG_IGN);
                ::setrlimit(RLIMIT_FSIZE, &limit);
                std::string actual = "no exception";
                try {
                    rt::save_tile(folder.path(), tile, pixels);
                } catch (const std::runtime_error&) {
                    actual = "std::runtime_error";
                } catch (const rt::NotImplemented&) {
                    ::setrlimit(RLIMIT_FSIZE, &usual);
                    throw;
                } catch (...) {
                    actual = "another exception";
                }
                ::setrlimit(RLIMIT_FSIZE, &usual);
                std::signal(SIGXFSZ, old);
                INFO("room for " << room << " bytes of " << bytes);
                {
                    INFO(
                        "Hint: a stream is false as soon as something could not be written. The "
                        "last bytes are written by close()");
                    CHECK(actual == "std::runtime_error");
                }
                {
                    INFO("Hint: remove the unfinished file");
                    CHECK(names_in(folder) == std::vector<std::string>{"1.tile"});
                }
                check_tile(folder.path(), 1, older);
            }
        }
    {
        INFO("the folder does not exist");
        CHECK_THROWS_AS(rt::save_tile(folder.path() / "nowhere", 0, older), std::runtime_error);
    }
    INFO("a folder has the tile's name");
    fs::create_directories(rt::tile_file(folder.path(), 2) / "inner");
    CHECK_THROWS_AS(rt::save_tile(folder.path(), 2, older), std::runtime_error);
    CHECK(names_in(folder) == std::vector<std::string>{"1.tile", "2.tile"});
}
