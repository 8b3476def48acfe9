#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace companion {

// A new folder for files that are needed only for a while, in the system's folder for temporary
// files. It is removed when this object is destroyed. If the program ends in any other way, a
// process that waits for that removes it, or else the next program that makes such a folder.
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
    std::intptr_t held_ = -1;     // a handle that is closed when this program ends
    std::intptr_t remover_ = -1;  // the process that waits for that, if the system needs one
};

}  // namespace companion
