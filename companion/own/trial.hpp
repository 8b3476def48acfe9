#pragma once
// What the parts of a verdict share.

#include <companion/own/judge.hpp>
#include <companion/own/own_program.hpp>
#include <optional>

namespace companion {

struct Trial {
    const JudgeRequest& request;
    const OwnProgram &own, &reference;
    // Judges a line: `look` fills in what was found, then the line is reported. If `look` throws,
    // the line has failed.
    std::function<void(JudgedLine line, const std::function<void(JudgedLine&)>& look)> line;
};

// The parts of steps 8 and 9 that are not about pictures, and the part "list".
void judge_cores(const Trial& trial);
void judge_tree(const Trial& trial);
void judge_list(const Trial& trial);
// The line of step 10 about the tree over triangles.
void judge_mesh_tree(const Trial& trial);
// The page accuracy.md.
void judge_accuracy(const Trial& trial);

// Two programs, or one program with two sets of options, whose times are measured in turns.
struct Timed {
    const OwnProgram& program;
    std::vector<std::string> options;
};
enum class Clock { wall, processor };
struct Turns {
    double first, second;  // medians, in seconds
    double ratio;          // the median over the turns of first / second
};
// Ends as soon as it is certain whether the median of this many ratios is at least what is asked.
Turns in_turns(const Timed& first, const Timed& second, const std::string& scene, Clock clock,
               int turns, std::optional<double> asked = {}, const std::string& mesh = {});

// A crowd in so large a picture that drawing takes the wanted time. Then the time for reading the
// scene does not matter.
std::string long_enough(const Timed& timed, std::uint64_t seed, Clock clock, double wanted,
                        int spheres = 10'000);

// "1.53"; with another format, such as "%.1f s", "1.5 s".
std::string number(double value, const char* format = "%.2f");

}  // namespace companion
