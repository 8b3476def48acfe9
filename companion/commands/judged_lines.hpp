#pragma once
// What a judge finds, line by line, as a person sees it.

#include <companion/commands/commands.hpp>
#include <companion/own/judge.hpp>

namespace companion {

// Prints each line when it is known, and on a terminal what is being looked at.
class JudgedLines {
  public:
    JudgedLines();
    std::function<void(const std::string& what)> begins = [](const std::string&) {};
    void operator()(const JudgedLine& line);

    int lines = 0, passed = 0;

  private:
    bool on_terminal_;
};

// Judges the learner's own ray tracer in a folder, or one part of it, and remembers a whole
// verdict. Returns whether the core passes.
bool judge_own(const Course& course, const fs::path& folder, std::uint64_t seed,
               const std::string& part, JudgedLines& lines);

// The seed that --seed asks for, or any.
std::uint64_t scenes_seed(const Given& given);

}  // namespace companion
