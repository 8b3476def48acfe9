#pragma once
// The verdict on a ray tracer of the learner's own, from the pictures that it draws
// and the time that it takes.

#include <companion/compare/comparison.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace companion {

namespace fs = std::filesystem;

// What a line looked at, so that a person can look at it, too.
struct Looked {
    std::string scene{}, mesh{};           // the file, and shape.obj beside it; empty: none
    std::vector<std::string> words{};      // what the program is called with, besides the files
    std::optional<Comparison> pictures{};  // its pictures and ours
};

// One line of a verdict: what was judged, what was found, and what was expected.
struct JudgedLine {
    bool passed = false;
    std::string what;           // "step 3: one matte ball on the ground"
    std::string actual;         // "the same within the noise", "0.8 times as fast"
    std::string expected;       // "our picture", "at least 10 times as fast"
    std::string suggestion;     // where to look if the line failed
    bool busy_machine = false;  // other programs ran, so that times say little
    Looked looked{};
};

// Our pictures, by the scene, its mesh and the seed.
using OurPictures = std::map<std::tuple<std::string, std::string, std::uint64_t>, Picture>;

struct JudgeRequest {
    fs::path folder, reference;  // the learner's folder, and the course's own program
    std::uint64_t seed = 1;      // of the scenes
    std::string part{};          // judge only this part; empty: all except the optional ones
    int cores = 2;               // physical cores
    double patience = 60;        // seconds for one picture
    int crowd = 10'000;          // spheres in the scenes on which all cores are measured
    double tree_gain = 10;       // how many times as fast as --list a tree must be
    std::string only_line{};     // judge only this line; empty: all lines
    // If not null, it keeps our pictures for the programs that are judged next.
    OurPictures* ours = nullptr;
    // Called when the judging of a line begins, because it may take long.
    std::function<void(const std::string& what)> begins = [](const std::string&) {};
};

// The parts of a verdict, in their order: "step1" to "step9", "hard", "list", "sanitizers",
// "broken", "accuracy". A line's name begins with its part: "step 1: ...", "hard: ...".
std::vector<std::string> judge_parts();

// Parts that are judged only on request: "step10", triangles and meshes.
std::vector<std::string> optional_parts();

// Judges a program, and reports each line as soon as it is known. If the program cannot be built,
// there is one line, which fails. If the program times out twice, a single line, which fails,
// stands for all that were not judged.
void judge(const JudgeRequest& request, const std::function<void(const JudgedLine&)>& report);

class OwnProgram;

// The same for a program that is built already, and only for these parts.
void judge_program(const OwnProgram& own, const JudgeRequest& request,
                   const std::vector<std::string>& parts,
                   const std::function<void(const JudgedLine&)>& report);

}  // namespace companion
