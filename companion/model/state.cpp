#include <app/errors.hpp>
#include <companion/model/state.hpp>
#include <companion/system/file_lock.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <rt/image_file.hpp>

namespace companion {
namespace {

using Json = nlohmann::json;

constexpr int version = 1;

fs::path folder_of(const Course& course) {
    return course.root / ".course";
}

State parse(const std::string& text) {
    const Json json = Json::parse(text);
    if (json.at("version").get<int>() != version)
        throw app::Failure("it is of version " + json.at("version").dump() + ", not " +
                           std::to_string(version));
    State state;
    for (const auto& [id, record] : json.at("exercises").items())
        state[id] = {record.at("passed").get<bool>(), record.at("hash").get<std::string>(),
                     record.at("hints").get<int>(), record.value("warning", "")};
    return state;
}

std::string to_text(const State& state) {
    Json records = Json::object();
    for (const auto& [id, record] : state)
        records[id] = {{"passed", record.passed},
                       {"hash", record.hash},
                       {"hints", record.hints},
                       {"warning", record.warning}};
    return Json{{"version", version}, {"exercises", records}}.dump(1) + '\n';
}

void set_aside(const Course& course, const fs::path& file, const char* why) {
    for (int i = 1;; ++i) {
        const fs::path aside = folder_of(course) / ("state.broken-" + std::to_string(i) + ".json");
        if (fs::exists(aside)) continue;
        std::error_code error;
        fs::rename(file, aside, error);
        // Another course may have been quicker; what cannot be moved is written over.
        if (!error)
            std::fprintf(stderr,
                         "course: what was remembered cannot be read (%s); it is now in %s, and "
                         "./course check finds out anew what is done\n",
                         why, aside.lexically_relative(course.root).string().c_str());
        return;
    }
}

}  // namespace

fs::path private_folder(const Course& course) {
    const fs::path folder = folder_of(course);
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder))
        throw app::Failure("cannot make the folder " + folder.string() +
                           (error ? ": " + error.message() : ": there is a file of that name"));
    return folder;
}

State read_state(const Course& course) {
    const fs::path file = folder_of(course) / "state.json";
    if (!fs::exists(file)) return {};
    try {
        return parse(read_file(file));
    } catch (const app::Failure& error) {
        set_aside(course, file, error.what());
    } catch (const Json::exception&) {
        set_aside(course, file, "it is no state of the course");
    }
    return {};
}

void change_state(const Course& course, const std::function<void(State&)>& change) {
    const fs::path folder = private_folder(course);
    const FileLock lock{folder / "state.lock"};
    State state = read_state(course);
    change(state);
    rt::replace_file(folder / "state.json", to_text(state));
}

}  // namespace companion
