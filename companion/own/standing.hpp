#pragma once
// What is known of the learner's own ray tracer without judging it again.

#include <companion/model/state.hpp>
#include <companion/own/judge.hpp>
#include <string>
#include <vector>

namespace companion {

// The files in a folder that a person wrote, relative to the folder. Left out are the program,
// pictures, hidden files, folders named build, files of more than a megabyte, and files that
// contain a zero byte, such as object files. Throws app::Failure if the folder holds too much for a
// single program.
std::vector<fs::path> own_sources(const fs::path& folder);

// A hash over these files; empty if the folder is gone or holds too much.
std::string hash_of_own(const fs::path& folder);

// Whether a line of a verdict belongs to the core: steps 1 to 6.
bool is_core(const JudgedLine& line);

// Whether the core, or every line, passed in the last verdict, and nothing has changed since then.
bool own_passes(const OwnRecord& own);
bool own_stars_pass(const OwnRecord& own);

// "your own ray tracer passes", "core passes, 41 of 43 lines pass", "changed since it was judged",
// "not judged yet"
std::string standing_of(const OwnRecord& own);

}  // namespace companion
