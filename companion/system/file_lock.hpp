#pragma once
#include <filesystem>

namespace companion {

// While it lives, no other process holds the lock of this file, which is made where it is missing
// and stays. Throws app::Failure where the file cannot be made.
class FileLock {
  public:
    explicit FileLock(const std::filesystem::path& path);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    int descriptor_;
};

}  // namespace companion
