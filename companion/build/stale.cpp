#include <algorithm>
#include <app/files.hpp>
#include <companion/build/stale.hpp>
#include <companion/system/files.hpp>
#include <companion/system/platform.hpp>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

namespace companion {
namespace {

using nlohmann::json;
using Time = std::int64_t;  // as the file system stores it

Time written(const fs::path& file) {
    return last_written(file).value_or(std::numeric_limits<Time>::min());
}

struct Source {
    std::string hash;
    Time time = 0;

    bool operator==(const Source&) const = default;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Source, hash, time)

// The sources that a learner changes, and their copies in build/yours. They are grouped by chapter,
// such as "03_sphere", or as "yours", and within a group by path.
using Sources = std::map<std::string, std::map<std::string, Source>>;

Sources sources_of(const Course& course) {
    Sources all;
    const auto add = [&](const std::string& group, const fs::path& folder) {
        for (const fs::path& file : source_files(folder)) {
            all[group][file.lexically_relative(folder).generic_string()] = {
                hash_of(read_file(file)), written(file)};
        }
    };
    for (const Chapter& chapter : chapters(course)) {
        all[chapter.name];  // even if the chapter has no files
        add(chapter.name, course.root / "exercises" / chapter.name);
    }
    add("yours", course.build / "yours");
    return all;
}

// What is known of the files that were compiled. Each is either the version from which everything
// present was built, or newer than that version.
struct Known {
    bool finished = false;                           // the last build ran to its end
    Time latest = std::numeric_limits<Time>::min();  // no file of the build is newer
    Sources sources;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Known, finished, latest, sources)

fs::path file_of(const Course& course) {
    return course.build / "built-from.json";
}

Known read_known(const Course& course) {
    const fs::path file = file_of(course);
    if (!fs::exists(file)) return {};
    const json text = json::parse(read_file(file), nullptr, false);
    if (!text.is_object()) return {};
    Known known = text;
    // Everything that had been built already existed when this file was written, even if the clock
    // was wrong.
    known.latest = std::max(known.latest, written(file));
    return known;
}

void write_known(const Course& course, const Known& known) {
    app::replace_file(file_of(course),
                      json(known).dump(-1, ' ', false, json::error_handler_t::replace));
}

// Whether a group's files have changed in a way that the build would not notice by itself.
bool is_hidden(const Known& known, const std::string& group,
               const std::map<std::string, Source>& now) {
    const auto found = known.sources.find(group);
    if (found == known.sources.end()) return true;
    const auto& before = found->second;
    // A file that is added or removed changes which one an #include finds.
    if (!std::equal(before.begin(), before.end(), now.begin(), now.end(),
                    [](const auto& a, const auto& b) { return a.first == b.first; }))
        return true;
    return std::any_of(now.begin(), now.end(), [&](const auto& file) {
        const auto& [name, source] = file;
        return source != before.at(name) && (!known.finished || source.time <= known.latest);
    });
}

// Whether a target of the build compiles files of this group.
bool compiles(const std::string& target, const std::string& group) {
    if (group == "yours") return target.find("_mine") != target.npos;
    if (target.ends_with("_solution")) return false;
    const std::string number = group.substr(0, 2), certify = "certify.";
    // The certificate's programs also compile code of other chapters.
    if (target.rfind(certify, 0) == 0) return target.compare(certify.size(), 2, number) >= 0;
    return target.rfind("yours." + number + '.', 0) == 0;
}

// Removes what was compiled and linked from a group, so that it is built again.
void remove_built(const fs::path& build, const std::string& group) {
    std::vector<fs::path> stale;
    std::error_code none;
    for (const auto& chapter : fs::directory_iterator{build / "chapters", none})
        for (const auto& entry : fs::directory_iterator{chapter.path() / "CMakeFiles", none})
            if (const fs::path& folder = entry.path();
                folder.extension() == ".dir" && compiles(folder.stem().string(), group))
                for (const auto& object : fs::recursive_directory_iterator{folder, none})
                    if (const fs::path kind = object.path().extension();
                        kind == ".o" || kind == ".obj")
                        stale.push_back(object.path());
    // Programs and libraries are linked again when their objects are new.
    for (const fs::path& path : stale) fs::remove(path);
}

}  // namespace

void remove_stale(const Course& course) {
    Known known = read_known(course);
    const Sources now = sources_of(course);
    for (const auto& [group, files] : now)
        if (is_hidden(known, group, files)) remove_built(course.build, group);
    known.finished = false;
    known.sources = now;
    write_known(course, known);
}

void note_built(const Course& course) {
    Known known = read_known(course);
    // If a file is saved during the build, it is unknown whether the compiler read it before or
    // after that.
    Sources now = sources_of(course);
    for (auto& [group, files] : now)
        for (auto& [name, source] : files)
            if (const auto& before = known.sources[group];
                before.count(name) == 0 || before.at(name) != source)
                source.hash = "unknown";
    known.finished = true;
    known.sources = now;
    write_known(course, known);
}

}  // namespace companion
