#pragma once
// What the companion remembers between two calls, in .course/state.json.

#include <companion/model/course.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace companion {

// The verdict on the files with this hash; on any others nothing is known.
struct Record {
    bool passed = false;    // its core
    std::string hash;       // empty: never checked
    int hints = 0;          // that were shown
    std::string warning{};  // the compiler's on these files; it comes only when it compiles them
    int stars = 0;          // its hard test cases, where it passed
    int open_stars = 0;     // those of them that fail
    // When its core passed first, in seconds since 1970. 0: not yet.
    std::int64_t first_passed = 0;
};

// It passed, and nobody noted when.
inline constexpr std::int64_t unknown_time = -1;

// How a question was answered last.
struct Answered {
    bool right = false;
    int tries = 0;
    std::string answer{};
};

// How the learner's own program of chapter 09 was judged last.
struct OwnRecord {
    std::string folder{}, hash{};   // of the sources in it, as they were judged
    int lines = 0, passed = 0;      // of the verdict; no lines: never judged
    std::int64_t first_passed = 0;  // all of it, as a record has it
};

// The last picture that `mine` drew, and with whose code.
struct DrawnRecord {
    std::string hash{};                // of the file
    std::vector<std::string> yours{};  // the exercises that ran the learner's code
};

struct State : std::map<std::string, Record> {  // by exercise
    std::map<std::string, Answered> answers{};  // by the question's key
    OwnRecord own{};
    DrawnRecord drawn{};
};

// The folder for what the companion keeps. It is made where it is missing.
fs::path private_folder(const Course& course);

// A missing file is an empty state. A file that is broken, or of another version, is set aside as
// .course/state.broken-N.json, which is said on stderr, and the state begins anew.
State read_state(const Course& course);

// Reads, changes and writes the state, whole or not at all. No two processes do it at once.
void change_state(const Course& course, const std::function<void(State&)>& change);

}  // namespace companion
