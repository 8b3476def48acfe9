#include <algorithm>
#include <app/files.hpp>
#include <companion/check/check.hpp>
#include <companion/check/yours.hpp>
#include <companion/model/progress.hpp>
#include <companion/system/files.hpp>
#include <map>

namespace companion {
namespace {

std::vector<Exercise> exercises_up_to(const Course& course, const Chapter& last) {
    std::vector<Exercise> all = exercises(course);
    std::erase_if(all, [&](const Exercise& one) { return one.chapter.name > last.name; });
    return all;
}

// The progress of each of these exercises, by its ID.
std::map<std::string, Progress> checked(const Course& course,
                                        const std::vector<Exercise>& exercises) {
    std::vector<Exercise> unchecked;
    for (const State state = read_state(course); const Exercise& exercise : exercises)
        if (progress_of(course, state, exercise) == Progress::unchecked)
            unchecked.push_back(exercise);
    if (!unchecked.empty()) check_exercises(course, unchecked);
    std::map<std::string, Progress> progress;
    for (const State state = read_state(course); const Exercise& exercise : exercises)
        progress[exercise.id] = progress_of(course, state, exercise);
    return progress;
}

// Writes exercises that follow each other as a range, "03.1 to 03.3", and a whole chapter as its
// number.
std::string ranges(const std::vector<std::string>& ids, const std::vector<std::string>& others) {
    const auto chapter_of = [](const std::string& id) { return id.substr(0, id.find('.')); };
    const auto number_of = [](const std::string& id) {
        return std::stoi(id.substr(id.find('.') + 1));
    };
    std::string text;
    for (std::size_t i = 0; i < ids.size();) {
        const std::string chapter = chapter_of(ids[i]);
        std::size_t end = i + 1;
        const bool whole = std::none_of(others.begin(), others.end(), [&](const std::string& id) {
            return chapter_of(id) == chapter;
        });
        while (end < ids.size() && chapter_of(ids[end]) == chapter &&
               (whole || number_of(ids[end]) == number_of(ids[end - 1]) + 1))
            ++end;
        if (!text.empty()) text += ", ";
        text += whole ? chapter : end == i + 1 ? ids[i] : ids[i] + " to " + ids[end - 1];
        i = end;
    }
    return text;
}

// Fills build/yours/rt. A file is the learner's if all of its exercises pass. With `failing_too`,
// it is also the learner's if one of its exercises is begun or fails; a file that is still as it
// was shipped would only stop the program.
Yours put_in_place(const Course& course, const Chapter& last, bool failing_too,
                   const std::set<std::string>& except = {}) {
    const std::vector<Exercise> all = exercises_up_to(course, last);
    std::map<std::string, Progress> progress = checked(course, all);
    for (const std::string& id : except) progress[id] = Progress::to_write;
    const auto wrong = [&](const Exercise& exercise) {
        const Progress here = progress.at(exercise.id);
        return here == Progress::begun || here == Progress::failing;
    };
    std::map<fs::path, bool> is_yours;
    for (const Exercise& exercise : all)
        for (const fs::path& file : exercise.files)
            is_yours[file] =
                passes(progress.at(exercise.id)) && (!is_yours.count(file) || is_yours[file]);
    for (const Exercise& exercise : all)
        if (failing_too && wrong(exercise))
            for (const fs::path& file : exercise.files) is_yours[file] = true;
    Yours yours;
    for (const Exercise& exercise : all) {
        const bool uses = std::any_of(exercise.files.begin(), exercise.files.end(),
                                      [&](const fs::path& file) { return is_yours[file]; });
        if (passes(progress.at(exercise.id))) {
            yours.passing.push_back(exercise.id);
            if (exercise.several_answers)
                yours.may_differ[exercise.id] = "has several right answers";
            else if (progress.at(exercise.id) == Progress::core)
                yours.may_differ[exercise.id] = "has open stars";
        } else if (failing_too && wrong(exercise))
            yours.failing.push_back(exercise.id);
        else if (uses && failing_too)
            yours.unwritten.push_back(exercise.id);
        else {
            yours.others.push_back(exercise.id);
            if (wrong(exercise)) yours.replaced.push_back(exercise.id);
        }
    }
    app::make_folder(course.build / "yours/rt");
    for (const auto& [file, mine] : is_yours) {
        if (mine) yours.files.push_back(file);
        const fs::path source =
            mine ? file : fs::path{"solutions"} / file.lexically_relative("exercises");
        const std::string text = text_with_origin(course, source);
        const fs::path target = course.build / "yours/rt" / file.filename();
        // An unchanged file is not written again, so that it is not compiled again.
        if (!fs::exists(target) || read_file(target) != text) app::replace_file(target, text);
    }
    return yours;
}

std::vector<std::string> joined(std::vector<std::string> ids,
                                const std::vector<std::string>& more) {
    ids.insert(ids.end(), more.begin(), more.end());
    return ids;
}

}  // namespace

std::string Yours::words() const {
    if (!failing.empty() || !unwritten.empty()) {
        const std::vector<std::string> rest = joined(passing, others);
        std::string text = "All of the code is yours.";
        if (!others.empty())
            text =
                "The solution's: " + ranges(others, joined(passing, joined(failing, unwritten))) +
                ". All else is yours.";
        if (!failing.empty())
            text += " These do not pass yet, but are used anyway: " +
                    ranges(failing, joined(rest, unwritten)) + '.';
        if (!unwritten.empty())
            text += " Still to be written: " + ranges(unwritten, joined(rest, failing)) + '.';
        return text;
    }
    if (others.empty()) return "All of the code is yours.";
    std::string text = passing.empty() ? "None of the code is yours yet: it is all the solution's."
                                       : "Yours: " + ranges(passing, others) +
                                             ". The solution's: " + ranges(others, passing) + '.';
    if (replaced.empty()) return text;
    std::vector<std::string> rest = joined(passing, others);
    std::erase_if(rest, [&](const std::string& id) {
        return std::count(replaced.begin(), replaced.end(), id) > 0;
    });
    return text + " It stands in for " + ranges(replaced, rest) + ", which " +
           (replaced.size() == 1 ? "does" : "do") + " not pass yet.";
}

std::string Yours::caption() const {
    if (passing.empty()) return "Drawn by the course's own code.";
    if (others.empty()) return "Drawn by its author's code.";
    return "Drawn by its author's code for " + ranges(passing, others) +
           ", and by the course's for " + ranges(others, passing) + '.';
}

std::string text_with_origin(const Course& course, const fs::path& file) {
    const fs::path origin = course.root / file;
    return "#line 1 \"" + origin.generic_string() + "\"\n" + read_file(origin);
}

void check_what_changed(const Course& course, const Chapter& last) {
    checked(course, exercises_up_to(course, last));
}

Yours put_yours_in_place(const Course& course, const Chapter& last) {
    return put_in_place(course, last, false);
}

Yours put_yours_in_place_except(const Course& course, const Chapter& last,
                                const std::set<std::string>& some) {
    return put_in_place(course, last, false, some);
}

Yours put_all_yours_in_place(const Course& course, const Chapter& last) {
    return put_in_place(course, last, true);
}

}  // namespace companion
