#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <app/errors.hpp>
#include <cerrno>
#include <companion/system/file_lock.hpp>
#include <cstring>

namespace companion {

FileLock::FileLock(const std::filesystem::path& path)
    : file_{::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)} {
    if (file_ < 0)
        throw app::Failure("cannot write " + path.string() + ": " + std::strerror(errno));
    while (::flock(static_cast<int>(file_), LOCK_EX) != 0 && errno == EINTR) {
    }
}

FileLock::~FileLock() {
    ::close(static_cast<int>(file_));
}

}  // namespace companion
