#pragma once
// What the parts of a verdict share.

#include <companion/own/judge.hpp>
#include <companion/own/own_program.hpp>

namespace companion {

struct Trial {
    const JudgeRequest& request;
    const OwnProgram &own, &reference;
    // Fills in what was found, and reports the line. If the look throws, the line has failed.
    std::function<void(JudgedLine line, const std::function<void(JudgedLine&)>& look)> line;
};

// Rung 8 beyond its pictures, rung 9 likewise, and the part "list".
void judge_cores(const Trial& trial);
void judge_tree(const Trial& trial);
void judge_list(const Trial& trial);
// Rung 10's tree over triangles.
void judge_mesh_tree(const Trial& trial);
// The page accuracy.md.
void judge_accuracy(const Trial& trial);

// Two programs, or one with two sets of options, whose times are measured in turns.
struct Timed {
    const OwnProgram& program;
    std::vector<std::string> options;
};
enum class Clock { wall, processor };
struct Turns {
    double first, second;  // medians, in seconds
    double ratio;          // the median of first / second of each turn
};
Turns in_turns(const Timed& first, const Timed& second, const std::string& scene, Clock clock,
               int turns, const std::string& mesh = {});

// A crowd in a picture large enough that drawing it takes the wanted time, so that the time for
// reading the scene does not count.
std::string long_enough(const Timed& timed, std::uint64_t seed, Clock clock, double wanted,
                        int spheres = 10'000);

// "1.53", and with another format "1.5 s".
std::string number(double value, const char* format = "%.2f");

}  // namespace companion
