#include <algorithm>
#include <companion/check/passing_chapters.hpp>

namespace companion {
namespace {

const char* reason(Verdict verdict) {
    switch (verdict) {
        case Verdict::passed:
            return "passes";
        case Verdict::failing:
            return "fails";
        case Verdict::no_file:
            return "has a missing file";
        case Verdict::to_write:
            return "is still to be written";
        case Verdict::waiting:
            return "needs another exercise first";
        case Verdict::not_compiled:
            return "does not compile";
        case Verdict::crashed:
            return "crashes";
        case Verdict::endless:
            return "does not end";
    }
    return "";
}

}  // namespace

bool CheckedChapter::passes() const {
    return !exercises.empty() &&
           std::all_of(exercises.begin(), exercises.end(),
                       [](const Checked& one) { return one.verdict == Verdict::passed; });
}

std::string CheckedChapter::why() const {
    const auto count = std::to_string(exercises.size());
    if (exercises.empty()) return "it has no exercises";
    if (passes()) return "all " + count + " exercises pass";
    const auto unwritten =
        std::count_if(exercises.begin(), exercises.end(),
                      [](const Checked& one) { return one.verdict == Verdict::to_write; });
    if (unwritten == static_cast<long>(exercises.size())) return "still to be written";
    std::string text;
    for (const Checked& one : exercises)
        if (one.verdict != Verdict::passed)
            text += (text.empty() ? "" : ", ") + one.exercise.id + ' ' + reason(one.verdict);
    return text;
}

std::vector<CheckedChapter> check_all_chapters(const Course& course) {
    std::vector<CheckedChapter> all;
    for (const Chapter& chapter : core_chapters(course)) {
        all.push_back({chapter, check_exercises(course, exercises(course, chapter))});
        check_in_float(course, all.back().exercises);
    }
    return all;
}

}  // namespace companion
