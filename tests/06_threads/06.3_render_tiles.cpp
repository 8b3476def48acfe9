#include <atomic>
#include <limits>
#include <rt/render_tiles.hpp>
#include <set>
#include <stdexcept>
#include <string>

#include "checkpoint.hpp"
#include "gathering.hpp"

using namespace checkpoint;
using rt::Tile, rt::TileGrid, rt::tile_at, rt::tile_count, rt::take_tile;

namespace {

std::string text(const Tile& tile) {
    return "columns " + std::to_string(tile.left) + " to " + std::to_string(tile.right) +
           " of rows " + std::to_string(tile.top) + " to " + std::to_string(tile.bottom);
}

// A counter that counts as std::atomic<int> does, but whose every step is followed by another
// worker, who takes a tile of its own at once. What two threads do to each other once in a million
// times happens here every time.
class HauntedCounter {
  public:
    int fetch_add(int n) {
        return step([&] { return std::exchange(value_, value_ + n); });
    }
    int operator++(int) { return fetch_add(1); }
    int operator++() { return fetch_add(1) + 1; }
    int operator+=(int n) { return fetch_add(n) + n; }
    int load() const {
        return step([&] { return value_; });
    }
    operator int() const { return load(); }
    void store(int n) {
        step([&] { return value_ = n; });
    }
    int operator=(int n) {
        store(n);
        return n;
    }
    int exchange(int n) {
        return step([&] { return std::exchange(value_, n); });
    }
    bool compare_exchange_strong(int& expected, int desired) {
        const bool same = value_ == expected;
        expected = step([&] { return same ? std::exchange(value_, desired) : value_; });
        return same;
    }
    bool compare_exchange_weak(int& expected, int desired) {
        return compare_exchange_strong(expected, desired);
    }

    // How many tiles the other worker takes, and which it took.
    int guests_left = 0;
    mutable std::vector<int> taken;

  private:
    template <class Step>
    int step(Step work) const {
        const int result = work();
        if (guests_left > 0 && static_cast<int>(taken.size()) < guests_left)
            taken.push_back(value_++);
        return result;
    }

    mutable int value_ = 0;
};

}  // namespace

TEST_CASE("06.3 the tiles cover the picture", "[06.3]") {
    struct Case {
        TileGrid grid;
        int count;
    };
    for (const auto& [grid, count] :
         {Case{{64, 32, 16}, 8}, Case{{65, 33, 16}, 15}, Case{{63, 31, 16}, 8},
          Case{{960, 540, 16}, 2040}, Case{{10, 7, 1}, 70}, Case{{16, 16, 16}, 1}}) {
        INFO(grid.width << 'x' << grid.height << " pixels in tiles of " << grid.tile_size);
        {
            INFO("Hint: a tile that is only partly filled is a tile, too: round up");
            REQUIRE(tile_count(grid) == count);
        }
        PixelCounts counts{grid, 1};
        for (int i = 0; i < count; ++i) counts(tile_at(grid, i), 0);
        CHECK_RENDERED_ONCE(counts);
    }
}

TEST_CASE("06.3 the tiles are counted row by row", "[06.3]") {
    const TileGrid grid{50, 30, 20};  // 3 x 2 tiles
    const Tile expected[] = {{0, 0, 20, 20},  {20, 0, 40, 20},  {40, 0, 50, 20},
                             {0, 20, 20, 30}, {20, 20, 40, 30}, {40, 20, 50, 30}};
    for (int i = 0; i < 6; ++i) {
        const Tile tile = tile_at(grid, i);
        INFO("50x30 pixels in tiles of 20: tile " << i << " is expected at " << text(expected[i])
                                                  << ", but yours is at " << text(tile));
        CHECK(tile == expected[i]);
    }
}

TEST_CASE("06.3 every tile is taken once and then none", "[06.3]") {
    std::atomic<int> next = 0;
    for (int i = 0; i < 5; ++i) {
        const auto tile = take_tile(next, 5);
        INFO("call " << i + 1 << " for 5 tiles gives " << (tile ? std::to_string(*tile) : "none"));
        REQUIRE(tile.has_value());
        CHECK(*tile == i);
    }
    for (int i = 0; i < 3; ++i) {
        INFO("all 5 tiles are taken");
        CHECK_FALSE(take_tile(next, 5).has_value());
    }
}

TEST_CASE("06.3 every pixel is rendered once in tiles", "[06.3]") {
    for (int workers = 1; workers <= 64; ++workers) {
        const TileGrid grid{35, 21, 4};
        PixelCounts counts{grid, workers};
        rt::render_tiles(grid, workers, std::ref(counts));
        INFO("35x21 pixels in tiles of 4, " << workers << " workers");
        CHECK_RENDERED_ONCE(counts);
        CHECK(counts.tiles == 54);
    }
}

TEST_CASE("06.3 a slow tile does not hold up the others", "[06.3]") {
    for (const int slow : {0, 3}) {
        const TileGrid grid{8, 8, 2};
        MeetingPlace end;
        std::atomic<bool> in_time = false;
        std::atomic<int> tile = 0;
        // The slow tile waits until the 15 others are done.
        rt::render_tiles(grid, 2, [&](const Tile&, int) {
            if (tile++ == slow)
                in_time = end.wait_for(16);
            else
                end.wait_for(1);
        });
        INFO("2 workers, 16 tiles: while one worker is busy with tile "
             << slow << ", the other shall render all the rest.\nHint: whoever is free takes "
             << "the next tile; nobody owns a tile beforehand");
        CHECK(in_time);
    }
}

TEST_CASE("06.3 no other worker comes between reading and adding", "[06.3][hard]") {
    constexpr int count = 100;
    HauntedCounter next;
    next.guests_left = count;  // it never runs out
    std::multiset<int> taken;
    for (int calls = 0; calls < 2 * count; ++calls)
        if (const auto tile = take_tile(next, count)) taken.insert(*tile);
    int outside = 0;
    for (const int tile : next.taken)
        if (tile < count) taken.insert(tile);
    for (const int tile : taken) outside += tile < 0 || tile >= count;
    INFO(
        "Hint: between two steps (reading the counter, then changing or comparing it again) "
        "another worker may take a tile. Read and add in one step, and decide by what that gave");
    CHECK(outside == 0);
    for (int tile = 0; tile < count; ++tile) {
        INFO("tile " << tile << " of " << count << " is taken " << taken.count(tile) << " times");
        REQUIRE(taken.count(tile) == 1);
    }
}

TEST_CASE("06.3 pictures of few pixels or none", "[06.3][hard]") {
    for (const TileGrid grid :
         {TileGrid{0, 0, 16}, TileGrid{0, 5, 16}, TileGrid{5, 0, 16}, TileGrid{1, 1, 16},
          TileGrid{1, 1, 1}, TileGrid{1, 1000, 64}, TileGrid{1000, 1, 64}})
        for (const int workers : {1, 2, 3, 7, 64}) {
            PixelCounts counts{grid, workers};
            rt::render_tiles(grid, workers, std::ref(counts));
            INFO(grid.width << 'x' << grid.height << " pixels in tiles of " << grid.tile_size
                            << ", " << workers << " workers");
            CHECK_RENDERED_ONCE(counts);
        }
}

TEST_CASE("06.3 a tile as large as a number can be", "[06.3][hard]") {
    constexpr int largest = std::numeric_limits<int>::max();
    struct Case {
        TileGrid grid;
        std::vector<Tile> tiles;
    };
    const int wide = largest - 10, half = largest / 2 + 30;
    const Case cases[] = {
        {{100, 50, largest}, {{0, 0, 100, 50}}},
        {{100, 50, half}, {{0, 0, 100, 50}}},
        {{wide, 50, half}, {{0, 0, half, 50}, {half, 0, wide, 50}}},
        {{50, wide, half}, {{0, 0, 50, half}, {0, half, 50, wide}}},
    };
    for (const auto& [grid, tiles] : cases) {
        INFO(grid.width << 'x' << grid.height << " pixels in tiles of " << grid.tile_size);
        {
            INFO("Hint: width + tile_size may be more than an int holds");
            REQUIRE(tile_count(grid) == static_cast<int>(tiles.size()));
        }
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const Tile tile = tile_at(grid, static_cast<int>(i));
            INFO("tile " << i << " is expected at " << text(tiles[i]) << ", but yours is at "
                         << text(tile) << "\nHint: left + tile_size may be more than an int holds");
            CHECK(tile == tiles[i]);
        }
    }
}

TEST_CASE("06.3 an exception in a tile reaches the caller", "[06.3][hard]") {
    const auto all_but_one = [](const Tile& tile, int) {
        if (tile.left == 4 && tile.top == 4) throw std::runtime_error("tile");
    };
    for (const int workers : {1, 3}) {
        INFO(workers << " workers; tile (4, 4) throws");
        CHECK_THROWS_AS(rt::render_tiles({16, 16, 4}, workers, all_but_one), std::runtime_error);
    }
}
