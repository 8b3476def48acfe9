#include <atomic>
#include <cstdlib>
#include <functional>
#include <memory>
#include <new>
#include <rt/render_slices.hpp>
#include <rt/rng.hpp>
#include <rt/run_workers.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <typeinfo>

#include "checkpoint.hpp"
#include "gathering.hpp"
#include "own_process.hpp"

using namespace checkpoint;
using rt::run_workers, rt::render_slices, rt::Tile, rt::TileGrid;

// An allocator that is slow on request. With `together` it lets two threads go on at the same
// moment. If two threads make a container grow at the same time, without a lock, it is usually
// damaged only once in a thousand times; this way it happens soon. With `slowly` a thread that
// starts others is slower than those that it has started.
namespace {
enum class Memory { usual, together, slowly };
std::atomic<Memory> memory = Memory::usual;
std::atomic<unsigned> asking = 0;

void take_time() {
    if (memory == Memory::slowly) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    if (memory != Memory::together) return;
    const unsigned mine = asking++;
    if (mine % 2 == 1) return;
    const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds{100};
    while (asking == mine + 1 && std::chrono::steady_clock::now() < end) {
    }
}
}  // namespace
void* operator new(std::size_t size) {
    if (memory != Memory::usual) take_time();
    if (void* const block = std::malloc(size ? size : 1)) return block;
    throw std::bad_alloc{};
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return std::malloc(size ? size : 1);
}
void operator delete(void* block) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}

namespace {

// What workers throw: exceptions of several types, each with the worker's number.
struct OwnType {
    int worker;
};
struct Failure : std::runtime_error {
    explicit Failure(int number) : std::runtime_error("failure"), worker{number} {}
    int worker;
};
void throw_something(int worker) {
    switch (worker % 4) {
        case 0:
            throw Failure{worker};
        case 1:
            throw worker;
        case 2:
            throw OwnType{worker};
        default:
            throw std::runtime_error(std::to_string(worker));
    }
}
std::string name_of(int worker) {
    const char* const types[] = {"Failure", "int", "OwnType", "std::runtime_error"};
    return "the " + std::string{types[worker % 4]} + " of worker " + std::to_string(worker);
}

// What work() throws, in words; or that it throws nothing.
template <class Work>
std::string what_comes_out(Work work) {
    try {
        work();
    } catch (const std::runtime_error& error) {
        const auto* const failure = dynamic_cast<const Failure*>(&error);
        if (failure && typeid(error) == typeid(Failure)) return name_of(failure->worker);
        const int worker = std::atoi(error.what());
        if (typeid(error) == typeid(std::runtime_error) && std::to_string(worker) == error.what())
            return name_of(worker);
        return std::string{"another exception, a kind of std::runtime_error: "} + error.what();
    } catch (const OwnType& own) {
        return name_of(own.worker);
    } catch (int worker) {
        return name_of(worker);
    } catch (...) {
        return "an exception of another type";
    }
    return "no exception";
}

const char* const how_to_keep =
    "an exception that leaves a thread's function ends the program: catch it there with "
    "catch (...), whatever its type; keep std::current_exception() in the worker's own slot, and "
    "rethrow it after all threads have ended. Two threads must not push_back to one vector";

}  // namespace

TEST_CASE("06.2 each worker is called once with its own number", "[06.2]") {
    for (int round = 0; round < 20; ++round)
        for (const int workers : {1, 2, 3, 7, round == 0 ? 130 : 64}) {
            // One more slot, for numbers that belong to no worker.
            std::vector<std::atomic<int>> calls(static_cast<std::size_t>(workers) + 1);
            std::atomic<int> unknown = 0;
            run_workers(workers, [&](int worker) {
                const bool known = 0 <= worker && worker < workers;
                if (!known) unknown = worker;
                ++calls[static_cast<std::size_t>(known ? worker : workers)];
            });
            for (int worker = 0; worker < workers; ++worker) {
                INFO("round " << round << ": how often work is called for worker " << worker
                              << " of " << workers);
                if (calls.back() != 0) UNSCOPED_INFO("a call got the number " << unknown.load());
                INFO(
                    "Hint: the numbers are 0 ... workers - 1. A thread must have a copy of its "
                    "number; the loop has already changed its variable by the time the thread "
                    "reads it");
                REQUIRE(calls[static_cast<std::size_t>(worker)] == 1);
            }
            INFO("a call got the number " << unknown.load() << ", but the last of " << workers
                                          << " workers has the number " << workers - 1);
            REQUIRE(calls.back() == 0);
        }
}

TEST_CASE("06.2 the workers run at the same time", "[06.2]") {
    for (const int workers : {1, 2, 4, 64}) {
        Roll roll{workers};
        run_workers(workers, [&](int worker) { roll.sign(worker); });
        INFO("workers: "
             << workers
             << "\nHint: start a thread for each worker, also for the first one. Start all "
             << "threads before you wait for them (join)");
        REQUIRE(roll.complaint() == "");
    }
}

TEST_CASE("06.2 the work is done when run_workers returns", "[06.2]") {
    for (int slow = 0; slow < 3; ++slow) {
        // Shared with threads that may run on after the test.
        const auto done = std::make_shared<std::atomic<int>>(0);
        run_workers(3, [done, slow](int worker) {
            if (worker == slow) std::this_thread::sleep_for(std::chrono::milliseconds{20});
            ++*done;
        });
        const int done_by_then = *done;
        while (*done < 3) std::this_thread::yield();
        INFO("worker " << slow
                       << " is the last one to end.\nHint: join every thread; a detached one "
                       << "runs on, and writes to memory that no longer exists");
        CHECK(done_by_then == 3);
    }
}

TEST_CASE("06.2 run_workers does nothing with 0 workers", "[06.2]") {
    int calls = 0;
    run_workers(0, [&](int) { ++calls; });
    CHECK(calls == 0);
}

TEST_CASE("06.2 render_slices renders every pixel once", "[06.2]") {
    for (int workers = 1; workers <= 64; ++workers) {
        const TileGrid grid{5, 70};
        PixelCounts counts{grid, workers};
        render_slices(grid, workers, std::ref(counts));
        INFO("5x70 pixels, workers: " << workers);
        CHECK_RENDERED_ONCE(counts);
        CHECK(counts.tiles == workers);
    }
}

TEST_CASE("06.2 the slices go to the workers in order", "[06.2]") {
    for (const TileGrid grid :
         {TileGrid{40, 20}, TileGrid{7, 23}, TileGrid{1, 9}, TileGrid{300, 5}})
        for (const int workers : {1, 2, 3, 4, 5, 7}) {
            std::vector<std::vector<Tile>> tiles_of(static_cast<std::size_t>(workers));
            render_slices(grid, workers, [&](const Tile& tile, int worker) {
                if (0 <= worker && worker < workers)
                    tiles_of[static_cast<std::size_t>(worker)].push_back(tile);
            });
            for (int worker = 0; worker < workers; ++worker) {
                const auto& tiles = tiles_of[static_cast<std::size_t>(worker)];
                const rt::Rows rows = rt::slice_rows(grid.height, workers, worker);
                if (rows.begin >= rows.end) continue;
                INFO(grid.width << 'x' << grid.height << " pixels: worker " << worker << " of "
                                << workers << " has one tile, all columns of its rows");
                REQUIRE(tiles.size() == 1);
                const Tile &actual = tiles[0], expected{0, rows.begin, grid.width, rows.end};
                REQUIRE(text(actual) == text(expected));
            }
        }
}

TEST_CASE("06.2 the slices are rendered at the same time", "[06.2]") {
    for (const int workers : {1, 4}) {
        Roll roll{workers};
        render_slices({3, 10}, workers, [&](const Tile&, int worker) { roll.sign(worker); });
        INFO("workers: " << workers << "\nHint: render_slices calls run_workers");
        CHECK(roll.complaint() == "");
    }
}

TEST_CASE("06.2 an exception of a worker reaches the caller", "[06.2][hard]") {
    run_workers(0, [](int) {});
    for (const int thrower : {0, 1, 2, 3, 129}) {
        const int workers = thrower < 4 ? 4 : 130;
        const std::string actual = in_own_process([&] {
            return what_comes_out([&] {
                run_workers(workers, [&](int worker) {
                    if (worker == thrower) throw_something(worker);
                });
            });
        });
        INFO("worker " << thrower << " of " << workers << " throws.\nHint: " << how_to_keep);
        CHECK(actual == name_of(thrower));
    }
    const std::string actual = in_own_process([&] {
        return what_comes_out([&] {
            render_slices({5, 8}, 4, [](const Tile&, int worker) { throw worker * 4 + 1; });
        });
    });
    INFO(
        "render_slices with work that throws 1, 5, 9 and 13, by workers 0 to 3.\nHint: of several "
        "exceptions, run_workers rethrows that of the worker with the lowest number; render_slices "
        "only calls it");
    CHECK(actual == name_of(1));
}

TEST_CASE("06.2 no thread is left running after an exception", "[06.2][hard]") {
    run_workers(0, [](int) {});
    for (int thrower = 0; thrower < 3; ++thrower) {
        const std::string actual = in_own_process([&] {
            const auto ended = std::make_shared<std::atomic<int>>(0);
            memory = Memory::slowly;
            const std::string out = what_comes_out([&] {
                run_workers(4, [ended, thrower](int worker) {
                    if (worker == thrower) throw worker * 4 + 1;
                    std::this_thread::sleep_for(std::chrono::milliseconds{20});
                    ++*ended;
                });
            });
            return out + " after " + std::to_string(*ended) + " others have ended";
        });
        INFO("worker " << thrower
                       << " of 4 throws while the others are still at work.\nHint: let all "
                       << "workers end, then rethrow");
        CHECK(actual == name_of(thrower * 4 + 1) + " after 3 others have ended");
    }
}

TEST_CASE("06.2 of several exceptions the one of the lowest-numbered worker is rethrown",
          "[06.2][hard]") {
    run_workers(0, [](int) {});
    const std::string actual = in_own_process([] {
        rt::Rng rng{6, 2};
        for (int round = 0; round < 30; ++round) {
            // Any of the workers throw, one earlier and another later.
            const int workers = round % 3 ? 1 + static_cast<int>(rng() % 8) : 64;
            const auto any_bits = [&] { return std::uint64_t{rng()} << 32 | rng(); };
            const std::uint64_t throwers = any_bits() & any_bits() & any_bits(),
                                delays = any_bits();
            int first = 0;
            while (first < workers && (throwers >> first & 1) == 0) ++first;
            MeetingPlace place;
            const std::string out = what_comes_out([&] {
                run_workers(workers, [&](int worker) {
                    place.wait_for(workers);
                    const std::chrono::milliseconds delay{2 * (delays >> (worker % 32 * 2) & 3)};
                    std::this_thread::sleep_for(delay);
                    if (throwers >> worker & 1) throw_something(worker);
                });
            });
            const std::string expected = first < workers ? name_of(first) : "no exception";
            if (out != expected) return out + " instead of " + expected;
        }
        return std::string{"the first one's"};
    });
    INFO(
        "several workers throw, and the one with the lowest number throws sometimes before and "
        "sometimes after the others.\nHint: keep a slot for each worker, and look through the "
        "slots in order. "
        << how_to_keep);
    CHECK(actual == "the first one's");
}

TEST_CASE("06.2 workers may throw at the same moment", "[06.2][hard]") {
    run_workers(0, [](int) {});
    const std::string actual = in_own_process([] {
        // In some rounds the containers of the workers grow at the same moment. In others, two
        // threads on two cores throw without a step in between.
        for (int round = 0; round < 400; ++round) {
            const int workers = round < 20 ? 8 : round < 26 ? 64 : 2;
            const bool grow_together = workers == 8 || round > 200;
            std::atomic<int> there = 0, calls = 0;
            const std::string out = what_comes_out([&] {
                run_workers(workers, [&](int worker) {
                    ++calls;
                    if (++there == workers && grow_together) memory = Memory::together;
                    for (int turns = 0; there < workers; ++turns)
                        if (turns > 10'000 || workers > 2) std::this_thread::yield();
                    throw_something(worker);
                });
            });
            memory = Memory::usual;
            if (out != name_of(0)) return out;
            if (calls != workers) return std::to_string(calls) + " of " + std::to_string(workers);
        }
        return name_of(0);
    });
    INFO("2, 8 or 64 workers all throw at once.\nHint: " << how_to_keep);
    CHECK(actual == name_of(0));
}

TEST_CASE("06.2 several calls at the same time do not affect each other", "[06.2][hard]") {
    run_workers(0, [](int) {});
    const std::string actual = in_own_process([] {
        // One type for the work of all calls.
        using AnyWork = std::function<void(int)>;
        MeetingPlace place;
        std::string of_five;
        std::thread other{[&] {
            const AnyWork long_work = [&](int) {
                place.wait_for(8);
                std::this_thread::sleep_for(std::chrono::milliseconds{20});
            };
            of_five = what_comes_out([&] { run_workers(5, long_work); });
        }};
        const AnyWork work = [&](int worker) {
            if (!place.wait_for(8)) throw std::runtime_error("they do not meet");
            if (worker == 1) throw worker;
        };
        const std::string of_three = what_comes_out([&] { run_workers(3, work); });
        other.join();
        // A worker may have workers of its own, and exceptions of earlier calls are forgotten.
        std::atomic<int> calls = 0;
        const AnyWork inner = [&](int) { ++calls; }, outer = [&](int) { run_workers(3, inner); };
        const std::string nested = what_comes_out([&] { run_workers(2, outer); });
        return of_three + "; " + of_five + "; " + nested + ", " + std::to_string(calls) + " calls";
    });
    INFO(
        "first, 3 workers, one of which throws, while 5 workers run in another call; then 2 "
        "workers that each call run_workers with 3 workers.\nHint: threads and exceptions must be "
        "local variables of the function, not static");
    CHECK(actual == name_of(1) + "; no exception; no exception, 6 calls");
}

TEST_CASE("06.2 if a thread cannot be started no other is left running", "[06.2][hard]") {
    run_workers(0, [](int) {});
    const std::string actual = in_own_process([]() -> std::string {
        const std::string right = "std::system_error, and no thread runs on";
        if (!leave_room_for_few_threads()) return right;  // cannot be tried here
        const auto ended = std::make_shared<std::atomic<int>>(0);
        try {
            run_workers(1000, [ended](int) {
                std::this_thread::sleep_for(std::chrono::milliseconds{20});
                ++*ended;
            });
        } catch (const std::system_error&) {
            const int ended_by_then = *ended;
            std::this_thread::sleep_for(std::chrono::milliseconds{60});
            return *ended == ended_by_then ? right : "std::system_error, but threads run on";
        }
        return "no exception";
    });
    INFO(
        "the system has no more threads, and the constructor of std::thread throws.\nHint: the "
        "threads that were started before must still be joined. JoinGuard does that");
    CHECK(actual == "std::system_error, and no thread runs on");
}

TEST_CASE("06.2 pictures with fewer rows than workers or no rows are rendered", "[06.2][hard]") {
    for (const TileGrid grid : {TileGrid{9, 3}, TileGrid{1, 1}, TileGrid{1, 1000}, TileGrid{0, 0},
                                TileGrid{0, 5}, TileGrid{5, 0}})
        for (const int workers : {1, 2, 3, 7, 64}) {
            PixelCounts counts{grid, workers};
            render_slices(grid, workers, std::ref(counts));
            INFO(grid.width << 'x' << grid.height << " pixels, workers: " << workers);
            CHECK_RENDERED_ONCE(counts);
        }
    MeetingPlace place;
    std::atomic<int> met = 0;
    render_slices({9, 3}, 7, [&](const Tile&, int) { met += place.wait_for(3); });
    INFO(
        "7 workers and only 3 rows: how many slices are rendered at the same time.\nHint: call "
        "run_workers even if there are fewer rows than workers");
    CHECK(met == 3);
}
