#include <algorithm>
#include <companion/check/passing_chapters.hpp>

namespace companion {
bool CheckedChapter::passes() const {
    return !exercises.empty() &&
           std::all_of(exercises.begin(), exercises.end(),
                       [](const Checked& one) { return one.passed() || one.exercise.is_star(); });
}

std::string CheckedChapter::why() const {
    const auto count = std::to_string(exercises.size());
    if (exercises.empty()) return "it has no exercises";
    if (passes()) return "all of the core passes";
    const auto unwritten =
        std::count_if(exercises.begin(), exercises.end(),
                      [](const Checked& one) { return one.is<NotBegun>() || one.is<Begun>(); });
    if (unwritten == static_cast<long>(exercises.size())) return "still to be written";
    std::string text;
    for (const Checked& one : exercises)
        if (!one.passed() && !one.exercise.is_star())
            text += (text.empty() ? "" : ", ") + one.exercise.id + ' ' +
                    std::visit([](const auto& kind) { return kind.says; }, one.verdict);
    return text;
}

std::vector<CheckedChapter> check_all_chapters(const Course& course) {
    std::vector<CheckedChapter> all;
    for (const Chapter& chapter : core_chapters(course))
        all.push_back({chapter, check_exercises(course, exercises(course, chapter))});
    return all;
}

}  // namespace companion
