#include <algorithm>
#include <companion/model/hints.hpp>
#include <companion/model/progress.hpp>
#include <companion/system/files.hpp>
#include <sstream>

namespace companion {
namespace {

// The ordered list below a heading whose first word is `heading`.
std::vector<std::string> list_below(const fs::path& file, const std::string& heading) {
    std::vector<std::string> found;
    if (!fs::exists(file)) return found;
    std::istringstream text{read_text(file)};
    bool in_section = false;
    for (std::string line; std::getline(text, line);) {
        if (line.rfind("## ", 0) == 0) {
            const auto end = line.find(' ', 3);
            in_section = line.substr(3, end == std::string::npos ? end : end - 3) == heading;
            continue;
        }
        if (!in_section) continue;
        const std::string number = std::to_string(found.size() + 1) + ". ";
        if (line.rfind(number, 0) == 0) {
            found.push_back(line.substr(number.size()));
        } else if (!found.empty()) {
            // Lines that continue an item are indented by three characters.
            const auto inner = line.find_first_not_of(' ');
            found.back() +=
                '\n' +
                (inner == std::string::npos ? "" : line.substr(std::min<std::size_t>(3, inner)));
        }
    }
    for (std::string& hint : found)
        while (!hint.empty() && hint.back() == '\n') hint.pop_back();
    return found;
}

}  // namespace

std::vector<std::string> hints(const Course& course, const Exercise& exercise) {
    return list_below(course.root / exercise.chapter.hints, exercise.id);
}

std::vector<std::string> hints_of_graft(const Course& course, const Chapter& chapter) {
    return list_below(course.root / chapter.hints, "graft");
}

HintParts parts_of(const std::string& hint) {
    if (hint.rfind("★", 0) == 0) return {"", hint};
    const auto star = hint.find("\n\n★");
    if (star == std::string::npos) return {hint, ""};
    return {hint.substr(0, star), hint.substr(star + 2)};
}

std::vector<std::string> hints_in_view(const Course& course, const Exercise& exercise) {
    std::vector<std::string> all = hints(course, exercise);
    if (!exercise.is_star() && !passes(progress_of(course, read_state(course), exercise)))
        for (std::string& hint : all) hint = parts_of(hint).core;
    return all;
}

int due_hint(const Course& course, const std::string& id, std::size_t most) {
    int number = 0;
    change_state(course, [&](State& state) {
        int& shown = state.exercises[id].hints;
        number = std::clamp(shown, 0, static_cast<int>(most));
        shown = std::min(number + 1, static_cast<int>(most));
    });
    return number;
}

std::string plain_hint(std::string hint) {
    std::erase(hint, '`');
    return hint;
}

}  // namespace companion
