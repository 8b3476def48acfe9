#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <app/errors.hpp>
#include <cerrno>
#include <companion/system/file_lock.hpp>
#include <cstring>

namespace companion {

FileLock::FileLock(const std::filesystem::path& path, Hold hold, const std::function<bool()>& waits)
    : file_{::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)} {
    if (file_ < 0)
        throw app::Failure("cannot write " + path.string() + ": " + std::strerror(errno));
    const int file = static_cast<int>(file_), kind = hold == Hold::alone ? LOCK_EX : LOCK_SH;
    if (::flock(file, kind | LOCK_NB) == 0) return;
    is_held_ = errno != EWOULDBLOCK || waits();
    while (is_held_ && ::flock(file, kind) != 0 && errno == EINTR) {
    }
}

FileLock::~FileLock() {
    ::close(static_cast<int>(file_));
}

}  // namespace companion
