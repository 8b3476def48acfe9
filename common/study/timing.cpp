#include <chrono>
#include <ctime>
#include <study/median.hpp>
#include <study/timing.hpp>

namespace study {
namespace {

double now_ns(Clock clock) {
    if (clock == Clock::processor) return 1e9 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::nano>(since_start).count();
}

double time_of(const Work& work, long calls, Clock clock) {
    const double start = now_ns(clock);
    for (long i = 0; i < calls; ++i) work();
    return now_ns(clock) - start;
}

}  // namespace

std::vector<std::vector<double>> rounds_ns(const std::vector<Work>& works, const Turns& turns) {
    std::vector<std::vector<double>> times(works.size());
    std::vector<long> calls(works.size(), 1);
    for (int round = 0; round < turns.rounds; ++round)
        for (std::size_t i = 0; i < works.size(); ++i) {
            if (round > 0 && times[i].front() >= turns.once_from_ms * 1e6) continue;
            double ns = time_of(works[i], calls[i], turns.clock);
            while (ns < turns.at_least_ms * 1e6) ns = time_of(works[i], calls[i] *= 2, turns.clock);
            times[i].push_back(ns / static_cast<double>(calls[i]));
        }
    return times;
}

std::vector<double> in_turns_ns(const std::vector<Work>& works, const Turns& turns) {
    std::vector<double> medians;
    for (auto& times : rounds_ns(works, turns)) medians.push_back(median(std::move(times)));
    return medians;
}

double time_ns(const Work& work, const Turns& turns) {
    return in_turns_ns({work}, turns).front();
}

}  // namespace study
