#pragma once
// Pictures from the chapters' programs, for comparing them.

#include <app/errors.hpp>
#include <companion/compare/comparison.hpp>
#include <companion/system/process.hpp>
#include <filesystem>
#include <string>

namespace companion {

// Thrown if a program that should draw has failed. what() says how it ended, and contains what it
// printed.
struct DrawingFailed : app::Failure {
    DrawingFailed(const std::string& what, Result how)
        : app::Failure{what}, result{std::move(how)} {}
    Result result;
};

// The defaults of a program's options; 0 if it has no such option.
struct DrawingOptions {
    int width = 0, height = 0, spp = 0, depth = 0;
    bool has_seed = false;
    std::string show = {};                // what to draw in false colors; empty: the picture
    std::vector<std::string> shows = {};  // what it can draw so
};

// Reads what a program prints about its options when it gets --describe.
DrawingOptions options_from(const std::string& description);

// The size and the number of samples for comparing a program's pictures. Programs without
// randomness draw once, as usual. The others draw many times, so their pictures are small and have
// few samples.
DrawingOptions for_comparison(DrawingOptions options);

// The words that ask a program for a picture with these options.
std::vector<std::string> words_for(const DrawingOptions& options, std::uint64_t seed);

// Runs a program and reads the picture that it writes. With `most_cpu`, it gets so many seconds of
// processor time, however busy the machine is. Adds to `cpu_seconds`, if there is one, how many it
// took.
Picture draw_with(const std::filesystem::path& program, const DrawingOptions& options,
                  std::uint64_t seed, double most_cpu = 0, double* cpu_seconds = nullptr);

// The options that a program has, as it says itself.
DrawingOptions options_of(const std::filesystem::path& program);

// The two programs in the form that compare() needs. The solution tells whether they use
// randomness.
TwoPrograms two_programs(const std::filesystem::path& mine, const std::filesystem::path& solution);

}  // namespace companion
