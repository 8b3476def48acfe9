#include <windows.h>

#include <app/errors.hpp>
#include <app/windows/held.hpp>
#include <chrono>
#include <companion/system/scratch_folder.hpp>
#include <companion/system/windows/wide.hpp>
#include <random>

namespace companion {
namespace {

namespace fs = std::filesystem;

// A file that is held open while its folder is used. The system removes it when this program ends.
constexpr const char* held_file = ".held";

HANDLE hold(const fs::path& folder) {
    return ::CreateFileW((folder / held_file).c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW,
                         FILE_ATTRIBUTE_NORMAL | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
}

// Removes folders that killed programs of the same name left behind. Recent folders stay, because a
// program may just be making them.
void remove_abandoned(const fs::path& below, const std::string& start) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator{below, none}) {
        if (entry.path().filename().string().rfind(start, 0) != 0) continue;
        const auto age = fs::file_time_type::clock::now() - entry.last_write_time(none);
        if (!none && age > std::chrono::minutes(1) && !fs::exists(entry.path() / held_file, none))
            fs::remove_all(entry.path(), none);
    }
}

}  // namespace

ScratchFolder::ScratchFolder(const std::string& name) {
    const fs::path below = fs::temp_directory_path();
    remove_abandoned(below, name + '-');
    std::random_device random;
    do path_ = below / (name + '-' + std::to_string(random()));
    while (fs::exists(path_));
    std::error_code error;
    fs::create_directory(path_, error);
    const HANDLE held = hold(path_);
    if (error || held == INVALID_HANDLE_VALUE)
        throw app::Failure("cannot make a folder in " + below.string() + ": " + last_error());
    held_ = reinterpret_cast<std::intptr_t>(held);
}

ScratchFolder::~ScratchFolder() {
    ::CloseHandle(reinterpret_cast<HANDLE>(held_));
    std::error_code error;
    app::until_released([&] {  // a program that was just ended may hold a file, too
        fs::remove_all(path_, error);
        return !error;
    });
}

}  // namespace companion
