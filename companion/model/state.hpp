#pragma once
// What the companion remembers from one call to the next, in .course/state.json.

#include <companion/model/course.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace companion {

// The verdict on an exercise's files with this hash; if the files differ, nothing is known.
struct Record {
    bool passed = false;    // whether its core passes
    std::string hash;       // empty: never checked
    int hints = 0;          // how many were shown
    std::string warning{};  // the compiler's; it warns only when it compiles the files
    int stars = 0;          // how many hard test cases it has, if it passed
    int open_stars = 0;     // how many of them fail
    // When its core first passed, in seconds since 1970. 0: not yet.
    std::int64_t first_passed = 0;
};

// Stands for the time of a first pass that nobody recorded.
inline constexpr std::int64_t unknown_time = -1;

// How a question was last answered.
struct Answered {
    bool right = false;
    int tries = 0;  // since the question was last asked anew
    std::string answer{};
    int turn = 0;  // larger for a question that was answered later
};

// The questions of earlier chapters that are asked once more with a chapter's own questions: their
// keys, by the chapter's number. A question is removed when it is answered right.
using Reviews = std::map<std::string, std::vector<std::string>>;

// The last verdict on the learner's own program of chapter 09.
struct OwnRecord {
    std::string folder{}, hash{};   // of its sources when they were judged
    int lines = 0, passed = 0;      // lines of the verdict; 0 lines: never judged
    std::int64_t first_passed = 0;  // as in Record
    bool core = false;              // the lines of steps 1 to 6 pass
};

// The last picture of the final scene that `run` drew, and whose code drew it.
struct DrawnRecord {
    std::string hash{};                // of the picture's file
    std::vector<std::string> yours{};  // those for which the learner's code ran
};

// When the learner's own program first passed a chapter's graft, in seconds since 1970, by the
// chapter's number; 0 if the learner let the tracer begin from our answer to this graft or a later
// one. The program keeps changing, so a graft that has passed stays passed.
using GraftTimes = std::map<std::string, std::int64_t>;

struct State {
    std::map<std::string, Record> exercises{};
    std::map<std::string, Answered> answers{};  // by the question's key
    Reviews reviews{};
    OwnRecord own{};
    DrawnRecord drawn{};
    GraftTimes grafts{};
};

// The folder for what the companion keeps. It is created if it is missing.
fs::path private_folder(const Course& course);

// If the file is missing, the state is empty. A file that is broken, or has another version, is
// moved to .course/state.broken-N.json, with a message on stderr, and the state starts empty.
State read_state(const Course& course);

// Reads, changes and writes the state, completely or not at all. Only one process does so at a
// time.
void change_state(const Course& course, const std::function<void(State&)>& change);

}  // namespace companion
