#include <atomic>
#include <memory>
#include <rt/render_slices.hpp>
#include <rt/run_workers.hpp>
#include <stdexcept>
#include <string>
#include <thread>

#include "checkpoint.hpp"
#include "gathering.hpp"

using namespace checkpoint;
using rt::run_workers, rt::render_slices, rt::Tile, rt::TileGrid;

TEST_CASE("06.2 each worker is called once with its own number", "[06.2]") {
    for (int round = 0; round < 20; ++round)
        for (const int workers : {1, 2, 3, 7, 64}) {
            // One place more, for numbers that are none of the workers'.
            std::vector<std::atomic<int>> calls(static_cast<std::size_t>(workers) + 1);
            run_workers(workers, [&](int worker) {
                const bool known = 0 <= worker && worker < workers;
                ++calls[static_cast<std::size_t>(known ? worker : workers)];
            });
            for (int worker = 0; worker < workers; ++worker) {
                INFO("round " << round << ": worker " << worker << " of " << workers
                              << "\nHint: a thread must have a copy of its number; the loop "
                                 "variable itself has moved on when the thread looks at it");
                REQUIRE(calls[static_cast<std::size_t>(worker)] == 1);
            }
            REQUIRE(calls.back() == 0);
        }
}

TEST_CASE("06.2 the workers run at the same time", "[06.2]") {
    for (const int workers : {2, 4}) {
        MeetingPlace place;
        std::atomic<int> met = 0;
        run_workers(workers, [&](int) { met += place.wait_for(workers); });
        INFO(met << " of " << workers << " workers met all the others.\nHint: start all threads "
                 << "first, and wait for them (join) after that");
        CHECK(met == workers);
    }
}

TEST_CASE("06.2 the work is done when run_workers returns", "[06.2]") {
    // Shared with threads that may run on after the test.
    const auto done = std::make_shared<std::atomic<int>>(0);
    run_workers(3, [done](int) {
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
        ++*done;
    });
    const int done_by_then = *done;
    while (*done < 3) std::this_thread::yield();
    INFO("Hint: join every thread; a detached one lives on, and writes to what is gone");
    CHECK(done_by_then == 3);
}

TEST_CASE("06.2 every pixel is rendered once in slices", "[06.2]") {
    for (int workers = 1; workers <= 64; ++workers) {
        const TileGrid grid{5, 70};
        PixelCounts counts{grid, workers};
        render_slices(grid, workers, std::ref(counts));
        INFO("5x70 pixels, " << workers << " workers");
        CHECK_RENDERED_ONCE(counts);
        CHECK(counts.tiles == workers);
    }
}

TEST_CASE("06.2 the slices go to the workers in order", "[06.2]") {
    std::vector<Tile> tile_of(4);
    render_slices({40, 20}, 4, [&](const Tile& tile, int worker) {
        if (0 <= worker && worker < 4) tile_of[static_cast<std::size_t>(worker)] = tile;
    });
    for (int worker = 0; worker < 4; ++worker) {
        const Tile& tile = tile_of[static_cast<std::size_t>(worker)];
        INFO("40x20 pixels: worker " << worker << " renders columns " << tile.left << " to "
                                     << tile.right << " of rows " << tile.top << " to "
                                     << tile.bottom);
        CHECK(tile == Tile{0, 5 * worker, 40, 5 * worker + 5});
    }
}

TEST_CASE("06.2 an exception of a worker reaches the caller", "[06.2][hard]") {
    run_workers(0, [](int) {});
    for (const int thrower : {0, 1, 3}) {
        const Ending ending = ending_of([&] {
            run_workers(4, [&](int worker) {
                if (worker == thrower) throw std::runtime_error("worker");
            });
        });
        INFO("worker " << thrower << " of 4 throws: expected " << text(Ending::threw)
                       << ", but there was " << text(ending)
                       << ".\nHint: an exception that leaves a thread's function ends the program: "
                          "catch (...) it there, keep std::current_exception(), and rethrow it "
                          "after all threads have ended");
        CHECK(static_cast<int>(ending) == static_cast<int>(Ending::threw));
    }
}

TEST_CASE("06.2 no thread is left running after an exception", "[06.2][hard]") {
    run_workers(0, [](int) {});
    const Ending ending = ending_of([] {
        const auto running = std::make_shared<std::atomic<int>>(0);
        try {
            run_workers(4, [running](int worker) {
                if (worker == 0) throw std::runtime_error("worker 0");
                ++*running;
                std::this_thread::sleep_for(std::chrono::milliseconds{30});
                --*running;
            });
        } catch (const std::runtime_error&) {
            if (*running == 0) throw;  // as it should be
        }
    });
    INFO("expected the exception after all workers have ended, but there was " << text(ending));
    CHECK(static_cast<int>(ending) == static_cast<int>(Ending::threw));
}

TEST_CASE("06.2 of several exceptions the first worker's is thrown", "[06.2][hard]") {
    run_workers(0, [](int) {});
    for (const bool first_in_time : {true, false}) {
        const Ending ending = ending_of([&] {
            MeetingPlace place;
            try {
                run_workers(4, [&](int worker) {
                    place.wait_for(4);
                    if ((worker == 1) != first_in_time)
                        std::this_thread::sleep_for(std::chrono::milliseconds{20});
                    if (worker >= 1) throw std::runtime_error(std::to_string(worker));
                });
            } catch (const std::runtime_error& error) {
                if (error.what() == std::string("1")) throw;
            }
        });
        INFO("workers 1, 2 and 3 throw, worker 1 "
             << (first_in_time ? "first" : "last")
             << " in time: expected the exception of worker 1. There was " << text(ending)
             << ", or it was another exception.\nHint: a slot for each worker; then look "
             << "through them in order");
        CHECK(static_cast<int>(ending) == static_cast<int>(Ending::threw));
    }
}

TEST_CASE("06.2 a thread that cannot be started leaves none behind", "[06.2][hard]") {
    run_workers(0, [](int) {});
    const Ending ending = ending_of([] {
        if (!leave_room_for_few_threads()) throw 0;  // cannot be tried here
        run_workers(1000, [](int) {});
    });
    INFO("the system has no more threads: expected "
         << text(Ending::threw) << ", but there was " << text(ending)
         << ".\nHint: the constructor of std::thread "
            "may throw; the threads before it must "
            "be joined all the same. JoinGuard does that");
    CHECK(static_cast<int>(ending) == static_cast<int>(Ending::threw));
}

TEST_CASE("06.2 a picture with less rows than workers or none", "[06.2][hard]") {
    for (const TileGrid grid : {TileGrid{9, 3}, TileGrid{1, 1}, TileGrid{1, 1000}, TileGrid{0, 0},
                                TileGrid{0, 5}, TileGrid{5, 0}})
        for (const int workers : {1, 2, 3, 7, 64}) {
            PixelCounts counts{grid, workers};
            render_slices(grid, workers, std::ref(counts));
            INFO(grid.width << 'x' << grid.height << " pixels, " << workers << " workers");
            CHECK_RENDERED_ONCE(counts);
        }
}
