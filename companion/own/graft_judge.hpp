#pragma once
// The verdict on a graft: the learner's tracer, seen from outside.

#include <companion/model/course.hpp>
#include <companion/own/judge.hpp>

namespace companion {

struct GraftRequest {
    Chapter chapter;                     // whose graft
    fs::path program, reference;         // the learner's, and that of the answer
    std::vector<std::string> headers{};  // that the learner's program was compiled with
    std::uint64_t seed = 1;
    std::function<void(const std::string& what)> begins = [](const std::string&) {};
    std::string only_line{};  // only this line; empty: all
};

// Reports each line as soon as it is known.
void judge_graft(const Course& course, const GraftRequest& request,
                 const std::function<void(const JudgedLine&)>& report);

}  // namespace companion
