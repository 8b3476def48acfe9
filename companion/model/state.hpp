#pragma once
// What the companion remembers between two calls, in .course/state.json.

#include <companion/model/course.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace companion {

// The verdict on the files with this hash; about others nothing is known.
struct Record {
    bool passed = false;    // its core
    std::string hash;       // empty: never checked
    int hints = 0;          // how many were shown
    std::string warning{};  // the compiler's; it comes only when it compiles these files
    int stars = 0;          // its hard test cases, if it passed
    int open_stars = 0;     // those of them that fail
    // When its core first passed, in seconds since 1970. 0: not yet.
    std::int64_t first_passed = 0;
};

// It has passed, but nobody knows when.
inline constexpr std::int64_t unknown_time = -1;

// How a question was last answered.
struct Answered {
    bool right = false;
    int tries = 0;  // since it was last asked anew
    std::string answer{};
    int turn = 0;  // greater than those of all questions that were answered before
};

// The questions of earlier chapters that are asked once more with a chapter's own: their keys, by
// the chapter's number. A question leaves the list when it is answered right.
using Reviews = std::map<std::string, std::vector<std::string>>;

// How the learner's own program of chapter 09 was last judged.
struct OwnRecord {
    std::string folder{}, hash{};   // of the sources in it, as they were judged
    int lines = 0, passed = 0;      // of the verdict; no lines: never judged
    std::int64_t first_passed = 0;  // when its core did, as in Record
    bool core = false;              // the lines of rungs 1 to 6 pass
};

// The last picture that `mine` drew, and with whose code.
struct DrawnRecord {
    std::string hash{};                // of the file
    std::vector<std::string> yours{};  // the exercises that ran the learner's code
};

// When the learner's own program first passed a chapter's graft, in seconds since 1970, by the
// chapter's number; 0 if the tracer begins from our answer to it or to a later one. The program
// goes on to change, so a graft that has passed stays passed.
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

// A missing file is an empty state. A file that is broken, or of another version, is set aside as
// .course/state.broken-N.json, with a message on stderr, and the state starts empty.
State read_state(const Course& course);

// Reads, changes and writes the state, completely or not at all. Only one process does so at a
// time.
void change_state(const Course& course, const std::function<void(State&)>& change);

}  // namespace companion
