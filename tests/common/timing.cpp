#include <study/median.hpp>
#include <study/timing.hpp>

#include "checkpoint.hpp"

TEST_CASE("time_ns measures the work, not its absence", "[timing]") {
    double x = 1.000001;
    const auto work = [&](int times) {
        return study::time_ns(
            [&] {
                double y = x;
                for (int i = 0; i < times; ++i) {
                    y *= x;
                    study::keep(y);
                }
            },
            {.rounds = 5, .at_least_ms = 1});
    };
    const double little = work(10), much = work(1000);
    INFO(little << " ns and " << much << " ns");
    CHECK(little > 0);
    CHECK(much > 10 * little);  // 100 times the work
}

TEST_CASE("works are timed in turns", "[timing]") {
    std::string order;
    const auto times =
        study::rounds_ns({[&] { order += 'a'; }, [&] { order += 'b'; }}, {.rounds = 3});
    CHECK(order == "ababab");
    REQUIRE(times.size() == 2);
    CHECK(times[0].size() == 3);
    CHECK(times[1].size() == 3);
}

TEST_CASE("work that takes long is timed once", "[timing]") {
    int calls = 0;
    const auto times = study::rounds_ns({[&] { ++calls; }}, {.rounds = 3, .once_from_ms = 0});
    CHECK(calls == 1);
    CHECK(times[0].size() == 1);
}

TEST_CASE("the median lies in the middle", "[timing]") {
    CHECK(study::median({3}) == 3);
    CHECK(study::median({9, 1, 4}) == 4);
    CHECK(study::median({9, 1, 4, 2}) == 4);
}
