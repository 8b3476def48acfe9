#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/model/state.hpp>
#include <companion/system/file_lock.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace companion {

// A member that an older state does not have keeps its default.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Record, passed, hash, hints, warning, stars,
                                                open_stars, first_passed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Answered, right, tries, answer, turn)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(OwnRecord, folder, hash, lines, passed,
                                                first_passed, core)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(DrawnRecord, hash, yours)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(State, exercises, answers, reviews, own, drawn,
                                                grafts)

namespace {

using nlohmann::json;

constexpr int version = 1;

fs::path folder_of(const Course& course) {
    return course.root / ".course";
}

// Older states do not say when something first passed.
void add_time(json& record, bool passed) {
    if (!record.contains("first_passed")) record["first_passed"] = passed ? unknown_time : 0;
}

// Whether each number is one that the companion would write: a whole number, and a small one unless
// it is a time.
bool has_fitting_numbers(const json& value, bool is_time = false) {
    if (value.is_number()) {
        constexpr std::int64_t most = 1'000'000'000, latest = std::int64_t{1} << 40;
        return value.is_number_integer() && value >= -1 && value <= (is_time ? latest : most);
    }
    if (!value.is_structured()) return true;
    const auto items = value.items();
    return std::all_of(items.begin(), items.end(), [&](const auto& item) {
        return has_fitting_numbers(
            item.value(), is_time || item.key() == "first_passed" || item.key() == "grafts");
    });
}

State parse(const std::string& text) try {
    json all = json::parse(text);
    if (!has_fitting_numbers(all)) throw app::Failure("it holds a number that is out of range");
    if (const int written_as = all.at("version"); written_as != version)
        throw app::Failure("it has version " + std::to_string(written_as) + ", not " +
                           std::to_string(version));
    for (json& record : all.at("exercises")) add_time(record, record.at("passed"));
    if (all.contains("own")) {
        json& own = all["own"];
        const bool passed = own.at("lines") > 0 && own.at("passed") == own["lines"];
        add_time(own, passed);
        if (!own.contains("core")) own["core"] = passed;
    }
    return all;
} catch (const json::exception&) {
    throw app::Failure("it does not hold the progress of the course");
}

std::string to_text(const State& state) {
    json all = state;
    all["version"] = version;
    return all.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

void set_aside(const Course& course, const fs::path& file, const char* why) {
    for (int i = 1;; ++i) {
        const fs::path aside = folder_of(course) / ("state.broken-" + std::to_string(i) + ".json");
        if (fs::exists(aside)) continue;
        std::error_code error;
        fs::rename(file, aside, error);
        // Another ./course may have moved the file first. If the file cannot be moved, it is
        // overwritten later.
        if (!error)
            std::fprintf(stderr,
                         "course: the saved progress cannot be read (%s); it is now in %s, and "
                         "./course check finds out again what is done\n",
                         why, course.relative(aside).c_str());
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
                           (error ? ": " + error.message() : ": a file has that name"));
    return folder;
}

State read_state(const Course& course) {
    const fs::path file = folder_of(course) / "state.json";
    if (!fs::exists(fs::symlink_status(file))) return {};
    try {
        return parse(read_file(file));
    } catch (const std::runtime_error& error) {
        set_aside(course, file, error.what());
    }
    return {};
}

void change_state(const Course& course, const std::function<void(State&)>& change) {
    const fs::path folder = private_folder(course);
    const FileLock lock{folder / "state.lock"};
    State state = read_state(course);
    change(state);
    app::replace_file(folder / "state.json", to_text(state));
}

}  // namespace companion
