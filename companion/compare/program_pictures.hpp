#pragma once
// Pictures from the chapters' programs, for comparing them.

#include <app/errors.hpp>
#include <companion/compare/comparison.hpp>
#include <companion/system/process.hpp>
#include <filesystem>
#include <string>

namespace companion {

// A program that was to draw ended in another way. what() says how, and holds what it said.
struct DrawingFailed : app::Failure {
    DrawingFailed(const std::string& what, Result how)
        : app::Failure{what}, result{std::move(how)} {}
    Result result;
};

// The defaults of a program's options; 0 where it has no such option.
struct DrawingOptions {
    int width = 0, height = 0, spp = 0, depth = 0;
    bool has_seed = false;
};

// From what a program prints of itself when it is asked to --describe its options.
DrawingOptions options_from(const std::string& description);

// The size and the samples with which pictures of a program are compared. Programs without chance
// draw once, as they always do; others many times, so small and with few samples.
DrawingOptions for_comparison(DrawingOptions options);

// Runs a program and reads the picture that it writes.
Picture draw_with(const std::filesystem::path& program, const DrawingOptions& options,
                  std::uint64_t seed);

// Two programs as compare() wants them. Whether there is chance is asked of the solution.
TwoPrograms two_programs(const std::filesystem::path& mine, const std::filesystem::path& solution);

}  // namespace companion
