#include <algorithm>
#include <atomic>
#include <ctime>
#include <functional>
#include <mutex>
#include <rt/parallel_jobs.hpp>
#include <rt/parallel_loops.hpp>
#include <rt/strategies.hpp>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "checkpoint.hpp"

namespace {

// What a loop did with its jobs.
struct Done {
    explicit Done(int jobs, int workers) : calls(jobs), busy(workers) {}

    std::vector<std::atomic<int>> calls;  // of each job
    std::vector<std::atomic<int>> busy;   // calls of each worker at this moment
    std::atomic<int> overlaps = 0, no_job = 0, no_worker = 0;

    // One call, which lasts until `wait` returns.
    template <class Wait>
    void operator()(int job, int worker, const Wait& wait) {
        if (job < 0 || job >= static_cast<int>(calls.size())) {
            ++no_job;
            return;
        }
        ++calls[static_cast<std::size_t>(job)];
        if (worker < 0 || worker >= static_cast<int>(busy.size())) {
            ++no_worker;
            return;
        }
        std::atomic<int>& mine = busy[static_cast<std::size_t>(worker)];
        if (++mine > 1) ++overlaps;
        wait();
        --mine;
    }

    void operator()(int job, int worker) {
        (*this)(job, worker, [] { std::this_thread::yield(); });
    }

    // "" or what is wrong with the jobs.
    std::string wrong_jobs() const {
        for (std::size_t job = 0; job < calls.size(); ++job)
            if (calls[job] != 1)
                return "job " + std::to_string(job) + " of " + std::to_string(calls.size()) +
                       ": expected 1 call, actual: " + std::to_string(calls[job]);
        return no_job == 0
                   ? ""
                   : std::to_string(no_job) + " calls got the number of a job that does not exist";
    }

    // "" or what is wrong with the jobs or with the workers' numbers. Whether two workers with one
    // number are seen depends on how long the calls last.
    std::string wrong() const {
        if (const std::string jobs = wrong_jobs(); !jobs.empty()) return jobs;
        if (no_worker > 0)
            return std::to_string(no_worker) +
                   " calls got the number of a worker that does not exist";
        if (overlaps > 0)
            return std::to_string(overlaps) + " times, two calls had the same worker at once";
        return "";
    }
};

// Waits until the condition holds; false after a second of processor time, however busy the
// machine is. (After three, the loop itself would be called endless.)
template <class Condition>
bool comes(const Condition& condition) {
    const std::clock_t start = std::clock();
    while (!condition()) {
        if (std::clock() - start > CLOCKS_PER_SEC) return false;
        std::this_thread::yield();
    }
    return true;
}

}  // namespace

TEST_CASE("06.5 each job is called once", "[06.5]") {
    const std::pair<const char*, rt::JobSpreader> loops[]{
        {"OpenMP", rt::spread_by_openmp()},
        {"std::execution::par", rt::spread_by_standard_algorithm()}};
    for (const auto& [name, spread] : loops) {
        if (!spread) {
            WARN("this build has no " << name << ": its loop is not tested");
            SUCCEED("there is no such loop");
            continue;
        }
        for (const int jobs : {0, 1, 2, 7, 100, 1000})
            for (const int workers : {1, 2, 3, 8}) {
                Done done{jobs, workers};
                spread(jobs, workers, std::ref(done));
                INFO(name << ", workers: " << workers);
                // The numbers that OpenMP gives its threads are tested below.
                CHECK((spread == loops[0].second ? done.wrong_jobs() : done.wrong()) == "");
            }
    }
}

TEST_CASE("06.5 the standard algorithm runs the jobs whose numbers are in its list", "[06.5]") {
#ifdef RT_HAS_TBB
    std::vector<int> many(1000);
    for (std::size_t i = 0; i < many.size(); ++i) many[i] = static_cast<int>(7919 * i % 1000) - 300;
    const std::vector<int> lists[]{{}, {7}, {3, 1, 2}, {5, 5, -2, 1'000'000, 5}, many};
    const auto sorted = [](std::vector<int> jobs) {
        std::sort(jobs.begin(), jobs.end());
        return jobs;
    };
    for (const std::vector<int>& list : lists)
        // All of the list, or a part of it.
        for (const std::size_t left_out : {std::size_t{0}, list.size() / 3}) {
            const auto jobs = std::span{list}.subspan(left_out);
            std::mutex mutex;
            std::vector<int> called;
            rt::loop_with_standard_algorithm(jobs, [&](int job) {
                const std::lock_guard lock{mutex};
                called.push_back(job);
            });
            const auto expected = sorted({jobs.begin(), jobs.end()}), actual = sorted(called);
            if (const bool is_right = expected == actual; is_right) {
                CHECK(is_right);
                continue;
            }
            const auto text = [](const std::vector<int>& numbers) {
                std::string all;
                for (std::size_t i = 0; i < numbers.size() && i < 6; ++i)
                    all += (i > 0 ? ", " : "") + std::to_string(numbers[i]);
                return '{' + all + (numbers.size() > 6 ? ", ... }" : "}");
            };
            INFO(jobs.size() << " jobs " << text({jobs.begin(), jobs.end()})
                             << ": " EXPECTED "one call for each, actual: calls for "
                             << text(called)
                             << ".\nHint: call work with the numbers in `jobs`, not with their "
                                "indices 0, 1, 2 ...");
            REQUIRE(text(actual) == text(expected));
            REQUIRE(actual.size() == expected.size());
        }
#else
    WARN("this build has no std::execution::par: its loop is not tested");
    SUCCEED("there is no such loop");
#endif
}

TEST_CASE("06.5 the loops run in several threads", "[06.5]") {
    // Two jobs, each of which waits for the other to begin.
    for (const auto& spread : {rt::spread_by_openmp(), rt::spread_by_standard_algorithm()}) {
        if (!spread || std::thread::hardware_concurrency() < 2) {
            SUCCEED("there is no such loop, or only one core");
            continue;
        }
        std::atomic<int> begun = 0;
        std::atomic<bool> together = true;
        spread(2, 2, [&](int, int) {
            ++begun;
            if (!comes([&] { return begun == 2 || !together; })) together = false;
        });
        INFO((spread == rt::spread_by_openmp() ? "OpenMP" : "std::execution::par"));
        const std::string actual = together ? "both at once" : "one after the other";
        CHECK(actual == "both at once");
    }
}

TEST_CASE("06.5 OpenMP uses the requested number of threads", "[06.5]") {
    if (!rt::spread_by_openmp()) {
        SUCCEED("there is no such loop");
        return;
    }
    // More threads than there are cores, and fewer. Each job lasts until every worker has begun
    // one, so that two workers with one number are seen, too.
    for (const int workers : {1, 3, static_cast<int>(std::thread::hardware_concurrency()) + 2}) {
        std::atomic<int> begun = 0;
        std::atomic<bool> together = true;
        Done done{workers, workers};
        rt::spread_by_openmp()(workers, workers, [&](int job, int worker) {
            done(job, worker, [&] {
                ++begun;
                if (!comes([&] { return begun == workers || !together; })) together = false;
            });
        });
        INFO("Hint: write num_threads(workers)");
        const std::string expected = std::to_string(workers) + " threads at once";
        const std::string actual = together ? expected : "fewer";
        CHECK(actual == expected);
        CHECK(done.wrong() == "");
        if (!together) break;
    }
}

TEST_CASE("06.5 both loops draw the same picture as 06.3", "[06.5]") {
    const rt::TileGrid grid{37, 23, 4};
    const auto shade = [](int x, int y, int) {
        return rt::Color{static_cast<rt::Real>(x), static_cast<rt::Real>(y), 1};
    };
    const rt::Image expected = rt::render_image(rt::render_tiles, grid, 1, shade);
    for (const auto& [name, strategy] : rt::strategies()) {
        INFO(name);
        if (name == "slices" || name == "tiles") {
            SUCCEED("a strategy without these loops");
            continue;
        }
        const bool same = rt::render_image(strategy, grid, 3, shade) == expected;
        CHECK(std::string{same ? "the same picture" : "another picture"} == "the same picture");
    }
}

TEST_CASE("06.5 with OpenMP a free thread takes the next job", "[06.5]") {
    if (!rt::spread_by_openmp()) {
        SUCCEED("there is no such loop");
        return;
    }
    // One job lasts until all others are done: a thread that was given its share beforehand would
    // wait for jobs of its own.
    constexpr int jobs = 40;
    for (const int slow : {0, 17, jobs - 1}) {
        std::atomic<int> ended = 0;
        std::atomic<bool> free = true;
        Done done{jobs, 2};
        rt::spread_by_openmp()(jobs, 2, [&](int job, int worker) {
            done(job, worker, [&] {
                if (job == slow && !comes([&] { return ended == jobs - 1; })) free = false;
            });
            ++ended;
        });
        INFO("job " << slow << " is slow");
        const std::string actual =
            free ? "the other thread did the rest" : "jobs waited for the slow one";
        CHECK(actual == "the other thread did the rest");
        INFO("Hint: a worker is a thread, so its number is omp_get_thread_num(), whatever its job");
        CHECK(done.wrong() == "");
        if (!free) break;
    }
}

TEST_CASE("06.5 an exception reaches the caller from both loops", "[06.5][hard]") {
    for (const auto& spread : {rt::spread_by_openmp(), rt::spread_by_standard_algorithm()}) {
        if (!spread) {
            SUCCEED("there is no such loop");
            continue;
        }
        CHECK_THROWS_AS(spread(100, 3,
                               [](int job, int) {
                                   if (job == 41) throw std::length_error("job 41");
                               }),
                        std::length_error);
    }
}
