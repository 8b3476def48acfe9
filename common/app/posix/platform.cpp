#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <app/cores.hpp>
#include <app/platform.hpp>
#include <app/signals.hpp>
#include <fstream>
#include <set>
#include <string>
#include <thread>

namespace app {

namespace fs = std::filesystem;

const std::initializer_list<int> ending_signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};

void prepare_process() {
    std::signal(SIGXFSZ, SIG_IGN);
}

void end_by(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

SignalHandler handler_of(int signal) {
    struct sigaction now {};
    ::sigaction(signal, nullptr, &now);
    return now.sa_handler;
}

std::FILE* open_for_reading(const fs::path& path) {
    return std::fopen(path.c_str(), "rb");
}

std::FILE* open_for_writing(const fs::path& path, bool only_new) {
    // Opening a pipe must not wait for a reader, because none may ever come; writing to the pipe
    // may wait.
    const int descriptor = ::open(
        path.c_str(),
        O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NONBLOCK | (only_new ? O_EXCL : 0), 0666);
    if (descriptor < 0) return nullptr;
    ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
    return ::fdopen(descriptor, "w");
}

void rename_over(const fs::path& from, const fs::path& to) {
    fs::rename(from, to);
}

void remove_now(const char* path) {
    ::unlink(path);
}

bool is_writable(const fs::path& path) {
    return ::access(path.c_str(), W_OK) == 0;
}

bool is_terminal(std::FILE* file) {
    return ::isatty(::fileno(file)) != 0;
}

int physical_cores() {
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::set<std::string> cores;
    for (int i = 0;; ++i) {
        std::ifstream in{"/sys/devices/system/cpu/cpu" + std::to_string(i) +
                         "/topology/thread_siblings_list"};
        std::string siblings;
        if (!std::getline(in, siblings)) break;
        cores.insert(siblings);
    }
    return cores.empty() ? threads : std::min(threads, static_cast<int>(cores.size()));
}

}  // namespace app
