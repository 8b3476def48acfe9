#include <atomic>
#include <limits>
#include <memory>
#include <rt/render_tiles.hpp>
#include <rt/rng.hpp>
#include <rt/todo.hpp>
#include <set>
#include <string>

#include "checkpoint.hpp"
#include "gathering.hpp"

using namespace checkpoint;
using answer::HauntedCounter;
using rt::Tile, rt::TileGrid, rt::tile_at, rt::tile_count, rt::take_tile;

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
            INFO((tile_count(grid) < count
                      ? "Hint: a tile that is only partly filled is a tile, too: round up"
                      : "Hint: (n + size - 1) / size is the number of tiles along one side: where "
                        "no pixels are left over, there is no further tile. Multiply the numbers "
                        "of the two sides"));
            REQUIRE(tile_count(grid) == count);
        }
        PixelCounts counts{grid, 1};
        for (int i = 0; i < count; ++i) counts(tile_at(grid, i), 0);
        CHECK_RENDERED_ONCE(counts);
    }
}

TEST_CASE("06.3 the tiles are numbered row by row", "[06.3]") {
    const TileGrid grid{50, 30, 20};  // 3 x 2 tiles
    const Tile expected[] = {{0, 0, 20, 20},  {20, 0, 40, 20},  {40, 0, 50, 20},
                             {0, 20, 20, 30}, {20, 20, 40, 30}, {40, 20, 50, 30}};
    for (int i = 0; i < 6; ++i) {
        const Tile tile = tile_at(grid, i);
        INFO("50x30 pixels in tiles of 20: tile " << i << " is " EXPECTED "at " << text(expected[i])
                                                  << ", " ACTUAL << text(tile));
        CHECK(tile == expected[i]);
    }
}

TEST_CASE("06.3 tiles of any size cover pictures of any size", "[06.3]") {
    rt::Rng rng{6, 3};
    const auto any_to = [&](int most) {
        return 1 + static_cast<int>(rng() % static_cast<unsigned>(most));
    };
    for (int round = 0; round < 2000; ++round) {
        const TileGrid grid{any_to(round % 2 ? 100 : 100'000), any_to(round % 2 ? 100 : 100'000),
                            any_to(any_to(round % 2 ? 60 : 3000))};
        const int columns = (grid.width - 1) / grid.tile_size + 1;
        const int rows = (grid.height - 1) / grid.tile_size + 1;
        INFO(grid.width << 'x' << grid.height << " pixels in tiles of " << grid.tile_size << ": "
                        << columns << " columns of tiles, " << rows << " rows");
        if (std::int64_t{columns} * rows > std::numeric_limits<int>::max()) continue;
        REQUIRE(tile_count(grid) == columns * rows);
        // Any column and row, or the last ones.
        const int column = round % 3 ? any_to(columns) - 1 : columns - 1;
        const int row = round % 5 ? any_to(rows) - 1 : rows - 1;
        const int left = column * grid.tile_size, top = row * grid.tile_size;
        const Tile expected_tile{left, top, std::min(left + grid.tile_size, grid.width),
                                 std::min(top + grid.tile_size, grid.height)};
        const std::string actual = text(tile_at(grid, row * columns + column));
        INFO("tile " << row * columns + column);
        REQUIRE(actual == text(expected_tile));
    }
}

TEST_CASE("06.3 take_tile gives every tile once and none after the last", "[06.3]") {
    // Two pictures at the same time, each with a counter of its own.
    std::atomic<int> next = 0, next_of_other = 0;
    const auto words = [](std::optional<int> tile) {
        return tile ? std::to_string(*tile) : "none";
    };
    for (int i = 0; i < 2000; ++i) {
        const auto tile = take_tile(next, 5), other = take_tile(next_of_other, 900);
        INFO("call " << i + 1 << " for 5 tiles.\nHint: "
                     << (i < 5
                             ? "return what fetch_add(1) returned, the counter's value before the "
                               "addition, if it is less than count"
                             : "when all tiles are taken, return {}")
                     << "; keep nothing between calls except in the counter");
        REQUIRE(words(tile) == (i < 5 ? std::to_string(i) : "none"));
        INFO("call " << i + 1 << " for the 900 tiles of another picture");
        REQUIRE(words(other) == (i < 900 ? std::to_string(i) : "none"));
    }
    std::atomic<int> of_none = 0;
    CHECK(words(take_tile(of_none, 0)) == "none");
}

TEST_CASE("06.3 render_tiles renders every pixel once", "[06.3]") {
    const auto check = [](const TileGrid& grid, int workers, int tiles) {
        PixelCounts counts{grid, workers};
        rt::render_tiles(grid, workers, std::ref(counts));
        INFO(grid.width << 'x' << grid.height << " pixels in tiles of " << grid.tile_size
                        << ", workers: " << workers);
        CHECK_RENDERED_ONCE(counts);
        CHECK(counts.tiles == tiles);
    };
    for (int workers = 1; workers <= 64; ++workers) check({35, 21, 4}, workers, 54);
    check({40, 30, 1}, 3, 1200);
    check({333, 200, 13}, 2, 416);
    // As fast as possible, so that workers come between each other's steps.
    const TileGrid many{400, 300, 1};
    std::vector<std::atomic<int>> counts(120'000);
    rt::render_tiles(many, 4, [&](const Tile& tile, int) {
        const auto pixel = static_cast<std::size_t>(tile.top * 400 + tile.left);
        if (pixel < counts.size()) ++counts[pixel];  // a wrong tile may be outside the picture
    });
    INFO(
        "400x300 tiles of one pixel, 4 workers: the values are the number of tiles that were "
        "rendered exactly once.\nHint: the counter that all workers share is a std::atomic<int>, "
        "and take_tile "
        "takes the tile's number from it");
    CHECK(std::count(counts.begin(), counts.end(), 1) == 120'000);
}

TEST_CASE("06.3 workers that reach for the last tile together take it once", "[06.3]") {
    // Two workers meet in the first two tiles, leave them at the same moment, one of them a little
    // later in each picture, and go for the third tile.
    for (int picture = 0; picture < 500; ++picture) {
        std::atomic<int> there = 0;
        std::atomic<int> counts[4] = {};  // of each tile, and of anything else
        rt::render_tiles({3, 1, 1}, 2, [&](const Tile& tile, int) {
            ++counts[0 <= tile.left && tile.left < 3 ? tile.left : 3];
            const int mine = there++;
            for (int turn = 0; there < 2 && turn < 30'000; ++turn) continue;
            for (std::atomic<int> wait = mine == 1 ? picture % 64 : 0; wait > 0;) --wait;
        });
        INFO(
            "3 tiles, 2 workers: how often each tile is rendered, and any other.\nHint: between "
            "asking whether a tile is left and taking it, another worker may take it. Call "
            "take_tile, and render what it returns");
        const std::string actual = std::to_string(counts[0]) + ' ' + std::to_string(counts[1]) +
                                   ' ' + std::to_string(counts[2]) +
                                   ", other: " + std::to_string(counts[3]);
        REQUIRE(actual == "1 1 1, other: 0");
    }
}

TEST_CASE("06.3 all workers are at work at the same time", "[06.3]") {
    for (const int workers : {1, 2, 7, 64}) {
        Roll roll{workers};  // each waits in its tile for all the others
        rt::render_tiles({workers * 3, 3, 3}, workers,
                         [&](const Tile&, int worker) { roll.sign(worker); });
        INFO("workers: "
             << workers
             << ", and as many tiles.\nHint: call run_workers, and let each worker pass its "
             << "own number to work");
        REQUIRE(roll.complaint() == "");
    }
    MeetingPlace place;
    std::atomic<int> met = 0;
    rt::render_tiles({9, 3, 3}, 7, [&](const Tile&, int) { met += place.wait_for(3); });
    INFO(
        "7 workers and only 3 tiles: how many tiles are rendered at the same time.\nHint: call "
        "run_workers even if there are fewer tiles than workers");
    CHECK(met == 3);
}

TEST_CASE("06.3 a slow tile does not hold up the others", "[06.3]") {
    for (const int slow : {0, 1, 3}) {
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
             << slow << ", the other must render all the rest.\nHint: a worker that is free takes "
             << "the next tile; no worker owns a tile beforehand");
        const std::string actual = in_time ? "in time" : "too late";
        CHECK(actual == "in time");
    }
}

TEST_CASE("06.3 take_tile reads the counter and adds 1 in one step", "[06.3]") {
    constexpr int count = 100;
    for (unsigned seed = 0; seed < 20; ++seed) {
        HauntedCounter next{seed};
        std::multiset<int> taken;
        INFO(
            "Hint: between two steps (reading the counter, then changing or comparing it again) "
            "another worker may take a tile. Read and add in one step, and decide by the value "
            "that it returned");
        for (int calls = 0; calls < 2 * count; ++calls) {
            if (const auto tile = take_tile(next, count)) {
                taken.insert(*tile);
            } else {
                INFO("take_tile returned no tile: " EXPECTED
                     "that the counter is past the last tile");
                REQUIRE(next.now() >= count);
            }
        }
        for (const int tile : next.taken)
            if (tile < count) taken.insert(tile);
        for (int tile = 0; tile < count; ++tile) {
            INFO("tile " << tile << " of " << count << ": the number of times that it is taken");
            REQUIRE(taken.count(tile) == 1);
        }
        INFO("the number of tiles that were taken, of " << count);
        REQUIRE(taken.size() == count);
    }
}

TEST_CASE("06.3 pictures with few pixels or none are rendered", "[06.3]") {
    for (const TileGrid grid :
         {TileGrid{0, 0, 16}, TileGrid{0, 5, 16}, TileGrid{5, 0, 16}, TileGrid{1, 1, 16},
          TileGrid{1, 1, 1}, TileGrid{1, 1000, 64}, TileGrid{1000, 1, 64}})
        for (const int workers : {1, 2, 3, 7, 64}) {
            PixelCounts counts{grid, workers};
            rt::render_tiles(grid, workers, std::ref(counts));
            INFO(grid.width << 'x' << grid.height << " pixels in tiles of " << grid.tile_size
                            << ", workers: " << workers);
            CHECK_RENDERED_ONCE(counts);
        }
}

TEST_CASE("06.3 tiles may have the largest size that fits into an int", "[06.3][hard]") {
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
    for (const TileGrid grid : {TileGrid{largest, 1, 1}, TileGrid{1, largest, 1}}) {
        INFO(grid.width << 'x' << grid.height << " pixels in tiles of 1");
        REQUIRE(tile_count(grid) == largest);
        const std::string last = text(tile_at(grid, largest - 1));
        REQUIRE(last == text(Tile{grid.width - 1, grid.height - 1, grid.width, grid.height}));
    }
    for (const auto& [grid, tiles] : cases) {
        INFO(grid.width << 'x' << grid.height << " pixels in tiles of " << grid.tile_size);
        {
            INFO("Hint: width + tile_size may not fit into an int");
            REQUIRE(tile_count(grid) == static_cast<int>(tiles.size()));
        }
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const Tile tile = tile_at(grid, static_cast<int>(i));
            INFO("tile " << i << " is " EXPECTED "at " << text(tiles[i]) << ", " ACTUAL
                         << text(tile) << "\nHint: left + tile_size may not fit into an int");
            CHECK(tile == tiles[i]);
        }
    }
}

TEST_CASE("06.3 an exception in a tile reaches the caller", "[06.3][hard]") {
    for (const int workers : {1, 2, 3, 7}) {
        std::atomic<int> running = 0;
        std::string actual = "no exception";
        try {
            rt::render_tiles({16, 16, 4}, workers, [&](const Tile& tile, int) {
                ++running;
                if (tile.left == 4 && tile.top == 4) {
                    --running;
                    throw 44;
                }
                std::this_thread::sleep_for(std::chrono::milliseconds{1});
                --running;
            });
        } catch (int number) {
            actual = std::to_string(number);
        } catch (const rt::NotImplemented&) {
            throw;
        } catch (...) {
            actual = "another exception";
        }
        INFO("workers: " << workers << "; tile (4, 4) throws 44");
        CHECK(actual == "44");
        INFO("the number of calls that had not ended by then");
        CHECK(running == 0);
    }
}

TEST_CASE("06.3 two pictures may be rendered at the same time", "[06.3]") {
    const TileGrid outer{12, 9, 3}, inner{23, 11, 4};
    PixelCounts outer_counts{outer, 3};
    std::vector<std::unique_ptr<PixelCounts>> inner_counts;
    for (int i = 0; i < 12; ++i) inner_counts.push_back(std::make_unique<PixelCounts>(inner, 2));
    std::atomic<std::size_t> tiles = 0;
    rt::render_tiles(outer, 3, [&](const Tile& tile, int worker) {
        outer_counts(tile, worker);
        const std::size_t tile_number = tiles++;
        if (tile_number < 12) rt::render_tiles(inner, 2, std::ref(*inner_counts[tile_number]));
    });
    INFO(
        "each tile of a picture renders another picture.\nHint: each call of render_tiles needs a "
        "counter of its own, so nothing may be static");
    CHECK_RENDERED_ONCE(outer_counts);
    for (const auto& counts : inner_counts) CHECK_RENDERED_ONCE(*counts);
}
