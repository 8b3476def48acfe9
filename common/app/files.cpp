#include <app/errors.hpp>
#include <app/files.hpp>
#include <app/platform.hpp>
#include <app/signals.hpp>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>
#include <system_error>

namespace app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(int error) {
    throw std::system_error(error ? error : EIO, std::generic_category());
}

void write_to(const fs::path& path, const std::string& bytes, bool only_new) {
    std::FILE* const file = open_for_writing(path, only_new);
    if (!file) fail(errno);
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int write_error = errno;
    errno = 0;
    // The last bytes are written on closing, so a full disk may show only here.
    const bool closed = std::fclose(file) == 0;
    if (!written) fail(write_error);
    if (!closed) fail(errno);
}

// The path of the half-written file that Ctrl-C and other interruptions must remove; null if there
// is none.
std::atomic<const fs::path::value_type*> unfinished = nullptr;

bool remove_unfinished(int) {
    if (const auto* const path = unfinished.load()) remove_now(path);
    return false;
}

// While an object of this class exists, an interruption first removes the file and then takes
// effect.
class RemovedOnInterrupt {
  public:
    explicit RemovedOnInterrupt(const fs::path& path) { unfinished = path.c_str(); }
    ~RemovedOnInterrupt() { unfinished = nullptr; }

  private:
    OnSignal on_signal_{ending_signals, remove_unfinished};
};

}  // namespace

fs::path behind_links(fs::path path) {
    for (int links = 0; fs::is_symlink(fs::symlink_status(path)); ++links) {
        if (links == 40) fail(ELOOP);
        path = path.parent_path() / fs::read_symlink(path);
    }
    return path;
}

void replace_file(const fs::path& path, const std::string& bytes) try {
    const fs::file_status status = fs::status(path);
    if (fs::exists(status) && !fs::is_regular_file(status)) return write_to(path, bytes, false);

    const fs::path target = behind_links(path);
    // A unique name, so that two programs that write the same image do not collide.
    const fs::path temporary =
        target.parent_path() / ("." + std::to_string(std::random_device{}()) + ".part");
    const RemovedOnInterrupt guard{temporary};
    try {
        write_to(temporary, bytes, true);
        if (fs::exists(status)) fs::permissions(temporary, status.permissions());
        rename_over(temporary, target);
    } catch (const std::system_error&) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
} catch (const std::system_error& error) {
    throw std::system_error(error.code(), "cannot write " + path.string());
}

std::optional<std::string> read_bytes(const fs::path& path, std::size_t most) {
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    const std::unique_ptr<std::FILE, Close> file{open_for_reading(path)};
    if (!file) return {};
    std::string bytes;
    char buffer[1 << 14];
    for (std::size_t got;
         bytes.size() <= most && (got = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;)
        bytes.append(buffer, got);
    if (std::ferror(file.get())) return {};
    return bytes;
}

std::string read_input_file(const fs::path& path, const std::string& name, std::size_t most) {
    const auto refuse = [&](const std::string& why) { throw UsageError(name + ' ' + why); };
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        if (error && error != std::errc::no_such_file_or_directory)
            refuse("cannot be read (" + error.message() + "); name a readable file");
        refuse("does not exist; name an existing file");
    }
    if (fs::is_directory(status)) refuse("is a folder; name a file in it");
    if (!fs::is_regular_file(status)) refuse("is a device or a pipe; name a regular file");

    auto bytes = read_bytes(path, most);
    if (!bytes)
        refuse(std::string{"cannot be read ("} + std::strerror(errno) + "); name a readable file");
    if (bytes->size() > most)
        refuse("is too large; " + std::to_string(most >> 20) + " MiB are allowed");
    return std::move(*bytes);
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Failure(folder.string() + " cannot be created: " + error.message());
}

}  // namespace app
