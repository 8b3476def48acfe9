#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>

namespace companion {

// Whether a lock is held by one process alone, or by all that want to share it.
enum class Hold { alone, shared };

// While a FileLock exists, no other process holds the lock of this file, unless they share it. The
// file is created if it is missing, and is never removed. Throws app::Failure if the file cannot be
// created.
class FileLock {
  public:
    // If the lock is not free, `waits` is called; if it returns false, the lock is not taken.
    explicit FileLock(
        const std::filesystem::path& path, Hold hold = Hold::alone,
        const std::function<bool()>& waits = [] { return true; });
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    bool is_held() const { return is_held_; }

  private:
    std::intptr_t file_;  // the system's handle for it
    bool is_held_ = true;
};

}  // namespace companion
