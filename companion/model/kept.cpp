#include <chrono>
#include <companion/model/kept.hpp>
#include <companion/model/state.hpp>
#include <ctime>

namespace companion {

fs::path new_kept_folder(const Course& course, const std::string& name) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char time[32];
    std::strftime(time, sizeof time, "%Y%m%d-%H%M%S", std::localtime(&now));
    const fs::path kept = private_folder(course) / "kept";
    fs::create_directories(kept);
    const std::string timed = name + '-' + time;
    for (int i = 1;; ++i) {
        const fs::path folder = kept / (i == 1 ? timed : timed + '-' + std::to_string(i));
        if (fs::create_directory(folder)) return folder;  // false if it exists
    }
}

}  // namespace companion
