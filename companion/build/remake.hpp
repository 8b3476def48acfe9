#pragma once
// Compiling a target of the build once more, with other headers: for the known mistakes.

#include <companion/build/build.hpp>

namespace companion {

// How the build compiles and links a target. Reads compile_commands.json, and also link/TARGET.txt,
// which says what follows the objects. Throws app::Failure if the build does not know the target.
class Remake {
  public:
    Remake(const Course& course, const std::string& target);

    // Compiles and links the target into `result`. The headers in the folder `first` take
    // precedence over all others; if `first` has a source of the target, that source is compiled
    // instead of the target's. Files beside `result` are overwritten. Several threads may call this
    // at the same time if their results are in different folders.
    BuildResult operator()(const fs::path& first, const fs::path& result) const;

  private:
    struct Source {
        fs::path file;
        std::vector<std::string> words;  // the command that compiles it, without input and output
    };
    fs::path folder_;  // in which the commands run
    std::vector<Source> sources_;
    std::vector<std::string> linked_;  // the link command's words after the objects
};

}  // namespace companion
