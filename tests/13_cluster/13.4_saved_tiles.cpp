#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <map>
#include <rt/rng.hpp>
#include <rt/saved_tiles.hpp>
#include <rt/todo.hpp>
#include <sstream>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

using namespace checkpoint;
using rt::Color, rt::TilePlaces;
namespace fs = std::filesystem;

namespace {

// Six tiles of 8 x 8 pixels or fewer: those at the right edge have 5 columns, and those at the
// lower edge 3 rows.
const TilePlaces places{{21, 11, 8}, 0x1357};
constexpr int count = 6;

std::size_t place_size() {
    return static_cast<std::size_t>(places.begin(1));
}

// The bytes that a tile takes in its place.
std::size_t size_of(int tile) {
    return sizeof(std::uint64_t) + places.pixels(tile) * sizeof(Color);
}

std::vector<Color> some_pixels(unsigned seed, std::size_t number) {
    rt::Rng random{seed, 13};
    std::vector<Color> pixels(number);
    for (Color& pixel : pixels) pixel = {random.uniform(), random.uniform(), random.uniform()};
    return pixels;
}
std::vector<Color> pixels_of(int tile, const TilePlaces& where = places) {
    return some_pixels(static_cast<unsigned>(tile), where.pixels(tile));
}

std::string bytes_of(const fs::path& name) {
    std::ifstream file{name, std::ios::binary};
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

void write_bytes(const fs::path& name, const std::string& bytes) {
    std::ofstream{name, std::ios::binary} << bytes;
}

// The bytes of a file into which these tiles are saved, in this order.
std::string file_with(const std::vector<int>& tiles, const TilePlaces& where = places) {
    const TemporaryFolder folder;
    const fs::path name = folder / "saved.tiles";
    write_bytes(name, "");
    std::ofstream file{name, std::ios::binary | std::ios::in};
    for (const int tile : tiles) rt::save_tile(file, where, tile, pixels_of(tile, where));
    return bytes_of(name);
}

// Checks which tiles a file holds, by both functions that read them.
void check_tiles(const std::string& bytes, const std::vector<int>& expected,
                 const std::string& hint) {
    std::istringstream file{bytes};
    std::vector<int> missing, found, not_loaded;
    for (int tile = 0; tile < count; ++tile)
        if (std::find(expected.begin(), expected.end(), tile) == expected.end())
            missing.push_back(tile);
    INFO("Hint: " << hint);
    const auto actual = rt::restore_tiles(file, places, [&](int tile, const auto& pixels) {
        found.push_back(tile);
        const bool same = pixels == pixels_of(tile);
        INFO("tile " << tile << ": " EXPECTED "the pixels that were saved, " ACTUAL << pixels.size()
                     << " other pixels");
        CHECK(same);
    });
    {
        INFO("the tiles for which restore_tiles calls put");
        CHECK(found == expected);
    }
    {
        INFO("the tiles that restore_tiles returns");
        CHECK(actual == missing);
    }
    INFO("the tiles for which load_tile returns none, from the last to the first");
    for (int tile = count; --tile >= 0;)
        if (!rt::load_tile(file, places, tile)) not_loaded.insert(not_loaded.begin(), tile);
    CHECK(not_loaded == missing);
}

// Saves a tile in another process, in which no file may get larger than `bytes`: there a program is
// ended (as a machine dies) in the middle of writing. Or it ends without closing the file. Returns
// the signal that ended it.
int save_and_die(const fs::path& name, int tile, rlim_t bytes) {
    const pid_t process = ::fork();
    if (process == 0) {
        const rlimit limit{bytes, bytes}, none{0, 0};
        ::setrlimit(RLIMIT_CORE, &none);
        ::setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_DFL);
        try {
            std::ofstream file{name, std::ios::binary | std::ios::in};
            rt::save_tile(file, places, tile, pixels_of(tile));
            ::_exit(0);
        } catch (...) {
        }
        ::_exit(1);
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

TEST_CASE("13.4 a tile is read as it was written", "[13.4]") {
    for (const int tile : {0, 2, 4, 5}) {
        const std::string bytes = file_with({tile});
        const std::vector<Color> pixels = pixels_of(tile);
        INFO("tile " << tile << ", with " << pixels.size() << " pixels");
        {
            INFO(
                "Hint: seekp goes to the place of the tile. There come the 8 bytes of the "
                "checksum, and sizeof(Color) bytes for each pixel");
            CHECK(bytes.size() == static_cast<std::size_t>(places.begin(tile)) + size_of(tile));
        }
        std::istringstream file{bytes};
        const auto loaded = rt::load_tile(file, places, tile);
        INFO(
            "Hint: read the checksum first, then the pixels, and compare the checksum with "
            "places.checksum(tile, pixels)");
        REQUIRE(loaded.has_value());
        CHECK((*loaded == pixels));
    }
}

TEST_CASE("13.4 each tile has a place of its own", "[13.4]") {
    check_tiles(file_with({3, 0, 5}), {0, 3, 5},
                "every tile is written at places.begin(tile), in whatever order they come");
    check_tiles(file_with({0, 1, 2, 3, 4, 5}), {0, 1, 2, 3, 4, 5},
                "every tile is written at places.begin(tile)");
    INFO("tiles 1 and 2 are saved, and tile 1 once more");
    check_tiles(file_with({1, 2, 1}), {1, 2}, "a tile that is saved again replaces the older one");
}

TEST_CASE("13.4 tiles that were never saved are missing", "[13.4]") {
    check_tiles("", {}, "where the file has ended, nothing can be read, and no checksum fits");
    check_tiles(file_with({5}), {5}, "a place that was never written holds zeros: no tile");
    check_tiles(file_with({0}), {0},
                "a stream stays false after it has come to its end: begin with clear()");
}

TEST_CASE("13.4 a damaged tile counts as missing", "[13.4]") {
    const std::string whole = file_with({0, 1, 2, 3, 4, 5});
    for (const std::size_t byte :
         {std::size_t{0}, std::size_t{7}, std::size_t{8}, std::size_t{100}, size_of(3) - 1}) {
        std::string flipped = whole;
        flipped[3 * place_size() + byte] ^= 1;
        INFO("byte " << byte << " of the place of tile 3 has another bit");
        check_tiles(flipped, {0, 1, 2, 4, 5},
                    "a tile counts only if its checksum is that of its pixels");
    }
    for (const std::size_t left : {std::size_t{1}, size_of(4) / 2, size_of(4) - 1}) {
        INFO("the file ends in the middle of tile 4");
        check_tiles(whole.substr(0, 4 * place_size() + left), {0, 1, 2, 3},
                    "a tile counts only if its checksum is that of its pixels");
    }
    check_tiles(whole + whole, {0, 1, 2, 3, 4, 5}, "what comes after the last place is not read");
    check_tiles(std::string(whole.size(), '\0'), {}, "zeros are no tile");
    std::string exchanged = whole;
    exchanged.replace(0, place_size(), whole, place_size(), place_size());
    INFO("tile 1 is in the place of tile 0, too");
    check_tiles(exchanged, {1, 2, 3, 4, 5}, "the checksum is also made from the tile's number");
}

TEST_CASE("13.4 tiles of another picture are missing", "[13.4]") {
    TilePlaces other = places;
    ++other.picture;
    check_tiles(file_with({0, 1, 2, 3, 4, 5}, other), {},
                "the checksum is also made from the picture: let places compute it");
    check_tiles(file_with({0, 1}, {{30, 30, 10}, 0x1357}), {}, "the tiles have another size");
}

TEST_CASE("13.4 a program that dies leaves a whole tile or none", "[13.4]") {
    const TemporaryFolder folder;
    const fs::path name = folder / "saved.tiles";
    // With a stub there is nothing to die in.
    write_bytes(name, file_with({0, 1}));
    for (const double part : {0.0, 0.1, 0.5, 0.9}) {
        write_bytes(name, file_with({0, 1}));
        const auto bytes =
            2 * place_size() + static_cast<rlim_t>(part * static_cast<double>(size_of(2)));
        INFO("the program dies in the middle of writing tile 2");
        REQUIRE(save_and_die(name, 2, bytes) == SIGXFSZ);
        check_tiles(bytes_of(name), {0, 1}, "compare the checksum");
    }
    REQUIRE(save_and_die(name, 2, 1'000'000) == 0);
    INFO("the program has saved tile 2, and dies");
    check_tiles(bytes_of(name), {0, 1, 2},
                "a stream keeps the last bytes to itself until you call flush()");
}

TEST_CASE("13.4 a full disk causes an exception", "[13.4][hard]") {
    const TemporaryFolder folder;
    const fs::path name = folder / "saved.tiles";
    for (const std::size_t room : {std::size_t{0}, std::size_t{20}, size_of(2) - 1}) {
        write_bytes(name, file_with({0, 1}));
        std::ofstream file{name, std::ios::binary | std::ios::in};
        rlimit usual{};
        ::getrlimit(RLIMIT_FSIZE, &usual);
        const rlimit limit{2 * place_size() + room, usual.rlim_max};
        const auto old = std::signal(SIGXFSZ, SIG_IGN);
        ::setrlimit(RLIMIT_FSIZE, &limit);
        std::string actual = "no exception";
        try {
            rt::save_tile(file, places, 2, pixels_of(2));
        } catch (const std::runtime_error&) {
            actual = "std::runtime_error";
        } catch (...) {
            actual = "another exception";
        }
        ::setrlimit(RLIMIT_FSIZE, &usual);
        std::signal(SIGXFSZ, old);
        INFO("room for " << room << " bytes of a tile");
        INFO(
            "Hint: a stream is false as soon as something could not be written. The last bytes "
            "are written by flush()");
        CHECK(actual == "std::runtime_error");
        check_tiles(bytes_of(name), {0, 1}, "the other tiles stay as they were");
    }
}
