#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace companion {

// A new folder for files that nobody needs later, in the system's folder for such files. It is
// removed with this object, and also if the program ends in any other way: a process waits for
// that, or the next program that makes such a folder does it.
class ScratchFolder {
  public:
    // Throws app::Failure if it cannot be made.
    explicit ScratchFolder(const std::string& name);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    std::intptr_t held_ = -1;     // what ends with this program, as the system names it
    std::intptr_t remover_ = -1;  // the process that waits for that, if the system needs one
};

}  // namespace companion
