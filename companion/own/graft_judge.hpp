#pragma once
// The verdict on a graft: the learner's tracer, seen from outside.

#include <companion/model/course.hpp>
#include <companion/own/judge.hpp>

namespace companion {

struct GraftRequest {
    Chapter chapter;                     // whose graft
    fs::path program, reference;         // the learner's program, and our answer's
    std::vector<std::string> headers{};  // with which the learner's program was compiled
    std::uint64_t seed = 1;
    std::function<void(const std::string& what)> begins = [](const std::string&) {};
    std::string only_line{};  // judge only this line; empty: all lines
};

// Judges a graft, and reports each line as soon as it is known.
void judge_graft(const Course& course, const GraftRequest& request,
                 const std::function<void(const JudgedLine&)>& report);

}  // namespace companion
