#pragma once
// Measuring what accuracy costs: rows of (error, cost), a table for the terminal, CSV for plots.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <rt/compiler.hpp>
#include <string>
#include <vector>

namespace study {

// One measurement. The names say what the numbers are and their units, such as "distance / radius",
// "largest error / ulp", "time / ns".
struct Row {
    std::string study;    // which question the row helps to answer
    std::string variant;  // which way of computing it measured
    double x = 0;
    std::string x_name;
    double error = 0;
    std::string error_name;  // empty where the error was not measured
    double cost = 0;
    std::string cost_name;
};

// The measurements of one run of a chapter's program, all in the precision it was built with.
class Report {
  public:
    explicit Report(std::string chapter);

    void add(Row row) { rows_.push_back(std::move(row)); }
    const std::vector<Row>& rows() const { return rows_; }

    // Writes folder/CHAPTER.csv. Rows of the other precision that are in it already stay, so that
    // running the double and the float program one after the other gives one file with both.
    // Throws std::system_error when it cannot.
    void write_csv(const std::filesystem::path& folder) const;

    void print_table(std::FILE* out) const;

  private:
    std::string chapter_;
    std::vector<Row> rows_;
};

// "float" or "double": what rt::Real is in this program.
std::string precision();

// Keeps the compiler from leaving out the computation of a value that nobody reads.
template <class T>
void keep(const T& value) {
    RT_KEEP(value);
}

// The time of one call in nanoseconds: of `runs` timings, each of which calls work() often enough
// to take at least a millisecond, the median.
template <class Work>
double time_ns(Work work, int runs = 9) {
    using Clock = std::chrono::steady_clock;
    const auto time_of = [&](long calls) {
        const auto start = Clock::now();
        for (long i = 0; i < calls; ++i) work();
        return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    };
    long calls = 1;
    while (time_of(calls) < 1e6) calls *= 2;
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) times.push_back(time_of(calls) / static_cast<double>(calls));
    std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
    return times[static_cast<std::size_t>(runs / 2)];
}

// The time of one call in nanoseconds, of work that takes a millisecond or more: the median of
// `runs` calls. It is the processor's time for this program, in which others that run at the same
// time count less.
template <class Work>
double once_ns(Work work, int runs = 3) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        const std::clock_t start = std::clock();
        work();
        times.push_back(1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

}  // namespace study
