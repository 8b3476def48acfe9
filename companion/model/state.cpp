#include <app/errors.hpp>
#include <app/files.hpp>
#include <app/json.hpp>
#include <companion/model/state.hpp>
#include <companion/system/file_lock.hpp>
#include <companion/system/files.hpp>
#include <cstdio>

namespace companion {
namespace {

using app::Json;

constexpr int version = 1;

fs::path folder_of(const Course& course) {
    return course.root / ".course";
}

// A member of an object. Throws app::Failure if it is missing or of another kind.
const Json& member(const Json& object, const std::string& key, Json::Kind kind) {
    if (const Json* const found = find(object, key, kind)) return *found;
    throw app::Failure("it does not hold the progress of the course");
}

// A number that older states do not have.
int count(const Json& record, const std::string& key) {
    const Json* const found = find(record, key, Json::Kind::number);
    return found ? static_cast<int>(found->number) : 0;
}

// Older states do not say when an exercise first passed.
std::int64_t time_of(const Json& record, bool passed) {
    const Json* const found = find(record, "first_passed", Json::Kind::number);
    return found ? static_cast<std::int64_t>(found->number) : passed ? unknown_time : 0;
}

State parse(const std::string& text) {
    const Json json = app::parse_json(text, "state.json");
    const double written_as = member(json, "version", Json::Kind::number).number;
    if (written_as != version)
        throw app::Failure("it has version " + app::to_text({Json::Kind::number, written_as}) +
                           ", not " + std::to_string(version));
    const Json& records = member(json, "exercises", Json::Kind::object);
    State state;
    for (std::size_t i = 0; i < records.keys.size(); ++i) {
        const Json& record = records.items[i];
        const Json* const warning = find(record, "warning", Json::Kind::text);
        const bool passed = member(record, "passed", Json::Kind::boolean).number != 0;
        state[records.keys[i]] = {
            passed,
            member(record, "hash", Json::Kind::text).text,
            static_cast<int>(member(record, "hints", Json::Kind::number).number),
            warning ? warning->text : "",
            count(record, "stars"),
            count(record, "open_stars"),
            time_of(record, passed)};
    }
    if (const Json* const answers = find(json, "answers", Json::Kind::object))
        for (std::size_t i = 0; i < answers->keys.size(); ++i) {
            const Json& answer = answers->items[i];
            state.answers[answers->keys[i]] = {
                member(answer, "right", Json::Kind::boolean).number != 0, count(answer, "tries"),
                member(answer, "answer", Json::Kind::text).text};
        }
    if (const Json* const own = find(json, "own", Json::Kind::object)) {
        const int lines = count(*own, "lines"), passed = count(*own, "passed");
        state.own = {member(*own, "folder", Json::Kind::text).text,
                     member(*own, "hash", Json::Kind::text).text, lines, passed,
                     time_of(*own, lines > 0 && passed == lines)};
    }
    if (const Json* const drawn = find(json, "drawn", Json::Kind::object)) {
        state.drawn.hash = member(*drawn, "hash", Json::Kind::text).text;
        for (const Json& id : member(*drawn, "yours", Json::Kind::list).items)
            state.drawn.yours.push_back(id.text);
    }
    return state;
}

std::string to_text(const State& state) {
    Json records{Json::Kind::object};
    for (const auto& [id, record] : state) {
        records.keys.push_back(id);
        records.items.push_back(
            {Json::Kind::object,
             0,
             {},
             {{Json::Kind::boolean, record.passed ? 1.0 : 0.0},
              {Json::Kind::text, 0, record.hash},
              {Json::Kind::number, static_cast<double>(record.hints)},
              {Json::Kind::text, 0, record.warning},
              {Json::Kind::number, static_cast<double>(record.stars)},
              {Json::Kind::number, static_cast<double>(record.open_stars)},
              {Json::Kind::number, static_cast<double>(record.first_passed)}},
             {"passed", "hash", "hints", "warning", "stars", "open_stars", "first_passed"}});
    }
    Json answers{Json::Kind::object};
    for (const auto& [key, answered] : state.answers) {
        answers.keys.push_back(key);
        answers.items.push_back({Json::Kind::object,
                                 0,
                                 {},
                                 {{Json::Kind::boolean, answered.right ? 1.0 : 0.0},
                                  {Json::Kind::number, static_cast<double>(answered.tries)},
                                  {Json::Kind::text, 0, answered.answer}},
                                 {"right", "tries", "answer"}});
    }
    const Json own{Json::Kind::object,
                   0,
                   {},
                   {{Json::Kind::text, 0, state.own.folder},
                    {Json::Kind::text, 0, state.own.hash},
                    {Json::Kind::number, static_cast<double>(state.own.lines)},
                    {Json::Kind::number, static_cast<double>(state.own.passed)},
                    {Json::Kind::number, static_cast<double>(state.own.first_passed)}},
                   {"folder", "hash", "lines", "passed", "first_passed"}};
    Json yours{Json::Kind::list};
    for (const std::string& id : state.drawn.yours)
        yours.items.push_back({Json::Kind::text, 0, id});
    const Json drawn{Json::Kind::object,
                     0,
                     {},
                     {{Json::Kind::text, 0, state.drawn.hash}, std::move(yours)},
                     {"hash", "yours"}};
    const Json all{
        Json::Kind::object,
        0,
        {},
        {{Json::Kind::number, version}, std::move(records), std::move(answers), own, drawn},
        {"version", "exercises", "answers", "own", "drawn"}};
    return app::to_text(all) + '\n';
}

void set_aside(const Course& course, const fs::path& file, const char* why) {
    for (int i = 1;; ++i) {
        const fs::path aside = folder_of(course) / ("state.broken-" + std::to_string(i) + ".json");
        if (fs::exists(aside)) continue;
        std::error_code error;
        fs::rename(file, aside, error);
        // Another ./course may have moved it first; a file that cannot be moved is overwritten.
        if (!error)
            std::fprintf(stderr,
                         "course: the saved progress cannot be read (%s); it is now in %s, and "
                         "./course check finds out again what is done\n",
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
