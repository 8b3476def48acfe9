#pragma once
#include <unistd.h>

#include <app/errors.hpp>
#include <cstdio>
#include <functional>
#include <string>

#include "temporary_folder.hpp"

// How a program ends that does this work, and what it says on stderr.
struct Outcome {
    int code;
    std::string said;
};

inline Outcome outcome_of(const std::function<int()>& work) {
    const checkpoint::TemporaryFolder folder;
    std::FILE* const file = std::fopen((folder / "said").string().c_str(), "wb");
    std::fflush(stderr);
    const int before = ::dup(STDERR_FILENO);
    ::dup2(::fileno(file), STDERR_FILENO);
    const int code = app::run_or_explain("program", work);
    std::fflush(stderr);
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    std::fclose(file);
    return {code, checkpoint::read_file(folder / "said")};
}
