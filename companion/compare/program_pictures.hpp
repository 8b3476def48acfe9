#pragma once
// Pictures from the chapters' programs, for comparing them.

#include <app/errors.hpp>
#include <companion/compare/comparison.hpp>
#include <companion/system/process.hpp>
#include <filesystem>
#include <string>

namespace companion {

// A program that should have drawn failed. what() says how it ended, and holds what it printed.
struct DrawingFailed : app::Failure {
    DrawingFailed(const std::string& what, Result how)
        : app::Failure{what}, result{std::move(how)} {}
    Result result;
};

// The defaults of a program's options; 0 if it has no such option.
struct DrawingOptions {
    int width = 0, height = 0, spp = 0, depth = 0;
    bool has_seed = false;
};

// Reads what a program prints about itself when asked to --describe its options.
DrawingOptions options_from(const std::string& description);

// The size and the samples with which pictures of a program are compared. Programs
// without randomness draw once, as they always do; the others draw many times, and
// therefore small and with few samples.
DrawingOptions for_comparison(DrawingOptions options);

// Runs a program and reads the picture that it writes.
Picture draw_with(const std::filesystem::path& program, const DrawingOptions& options,
                  std::uint64_t seed);

// Two programs as compare() needs them. The solution tells whether there is randomness.
TwoPrograms two_programs(const std::filesystem::path& mine, const std::filesystem::path& solution);

}  // namespace companion
