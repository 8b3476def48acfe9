#pragma once
// Shows a judge's lines on the terminal.

#include <companion/commands/commands.hpp>
#include <companion/own/judge.hpp>

namespace companion {

// Prints each line as soon as it is known. On a terminal, it also shows what is being judged at the
// moment. If a line fails, what it looked at is kept in out/judge, in a folder of its own, until
// the next verdict.
class JudgedLines {
  public:
    // `program` is the judged program's name on the command line.
    JudgedLines(const Course& course, std::string program);
    std::function<void(const std::string& what)> begins = [](const std::string&) {};
    void operator()(const JudgedLine& line);

    int lines = 0, passed = 0;

  private:
    void keep(const JudgedLine& line) const;

    Course course_;
    std::string program_;
    bool on_terminal_;
};

// Judges the learner's own ray tracer in a folder, or one part of it. Remembers the verdict if it
// covers the whole. Returns whether the core passes.
bool judge_own(const Course& course, const fs::path& folder, std::uint64_t seed,
               const std::string& part, JudgedLines& lines);

// The seed that --seed asks for, or a random one.
std::uint64_t scenes_seed(const Given& given);

}  // namespace companion
