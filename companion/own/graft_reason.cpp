#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/remake.hpp>
#include <companion/own/graft_reason.hpp>
#include <companion/own/handed_over.hpp>
#include <companion/own/own_program.hpp>
#include <companion/own/tracer.hpp>
#include <companion/system/files.hpp>
#include <companion/system/parallel.hpp>
#include <companion/system/platform.hpp>

namespace companion {
namespace {

// A line's words without the times and the like, which are different each time.
std::string without_digits(std::string words) {
    std::erase_if(words, [](char c) { return '0' <= c && c <= '9'; });
    return words;
}

}  // namespace

GraftReason::GraftReason(const Course& course, const GraftRequest& request,
                         const std::string& source)
    : course_{course}, request_{request}, source_{source} {}

std::string GraftReason::operator()(const JudgedLine& line) {
    if (line.passed) passed_.push_back(line.what);
    if (line.what.rfind("#include", 0) == 0) is_grafted_ = false;
    if (line.passed || !is_grafted_) return line.suggestion;
    request_.begins("looking for the reason");
    try {
        std::string words = what_is_handed_over(line);
        // What is handed over does not depend on how busy the machine is.
        if (words.empty() && !line.busy_machine) words = known_mistakes(line);
        if (words.empty() && !line.busy_machine) words = what_is_left(line);
        if (words.empty()) return line.suggestion;
        return said_.insert(words).second ? words : "";
    } catch (const std::exception&) {  // the verdict stands without a reason, too
        return line.suggestion;
    }
}

// Stays in the build folder, so that the next time takes less.
void GraftReason::make(const std::vector<Part>& parts) {
    const std::string number = request_.chapter.number(), target = "tracer." + number;
    const Remake remake{course_, target};
    std::vector<const Part*> missing;
    for (const Part& part : parts)
        if (programs_.try_emplace(part.name).second) missing.push_back(&part);
    in_parallel(missing.size(), [&](std::size_t i) {
        const Part& part = *missing[i];
        const fs::path folder = course_.build / "graft" / number / part.name,
                       program = folder / program_name("tracer"), version = folder / "version";
        const std::string wanted = hash_of(
            part.source + std::to_string(last_written(course_.program(target)).value_or(0)));
        if (!fs::exists(version) || read_file(version) != wanted) {
            fs::remove_all(folder);
            app::make_folder(folder);
            app::replace_file(folder / (number + ".cpp"), part.source);
            if (part.is_recorded)
                copy_folder(course_.root / "companion/own/recorder/rt", folder / "rt");
            remake(folder, program);
            app::replace_file(version, wanted);
        }
        if (fs::exists(program)) programs_.at(part.name) = program;
    });
}

// What a program hands over when it draws the scene of a line.
std::string GraftReason::record(const std::string& name, const JudgedLine& line,
                                bool with_list) const {
    OwnProgram program{OwnProgram::Existing{}, made(name)};
    program.before = {"env", "COURSE_RECORD=record.txt"};
    program.may_start_others = true;  // as env does
    program.patience = course_.patience;
    try {
        if (line.looked.scene.empty()) {
            program.call(line.looked.words);
        } else {
            std::vector<std::string> words{"--seed", "2", "--threads", "3"};
            words.insert(words.end(), line.looked.words.begin(), line.looked.words.end());
            if (with_list) words.push_back("--list");
            program.draw(line.looked.scene, words, line.looked.mesh);
        }
    } catch (const app::Failure&) {  // it wrote no picture, but perhaps a record
    }
    const fs::path file = program.folder() / "record.txt";
    return fs::exists(file) ? read_file(file) : "";
}

std::string GraftReason::what_is_handed_over(const JudgedLine& line) {
    is_right_ = false;
    if (request_.chapter.graft->reads == Graft::Reads::nothing) return "";
    make({{"yours_recorded", source_, true},
          {"ours_recorded", read_file(tracer_answer(course_, request_.chapter)), true}});
    if (made("yours_recorded").empty() || made("ours_recorded").empty()) return "";
    for (const bool with_list : {false, true}) {
        const std::string mine = record("yours_recorded", line, with_list),
                          ours = record("ours_recorded", line, with_list);
        const std::string words = difference_in_words(mine, ours);
        if (!words.empty()) return with_list ? "With --list: " + words : words;
        is_right_ = has_pixels(mine) && has_pixels(ours);
        if (!is_right_) return "";
    }
    return "";
}

// The known mistakes that do the same as the learner's program. Several may look alike.
std::string GraftReason::known_mistakes(const JudgedLine& line) {
    std::vector<Mistake> mistakes =
        read_mistakes(course_.root / "tests/mistakes/tracer" / (request_.chapter.number() + ".md"));
    std::erase_if(mistakes, [&](const Mistake& mistake) {
        return is_refuted(mistake, {}, passed_) ||
               (is_right_ && mistake.remarks.count("main hands over"));
    });
    std::vector<Part> parts;
    for (const Mistake& mistake : mistakes)
        parts.push_back({mistake.name,
                         edited_files(mistake, course_.root / "solutions/tracer").begin()->second});
    make(parts);
    std::vector<const Mistake*> alike;
    bool to_the_bit = false;  // whether they are
    for (const Mistake& mistake : mistakes) {
        const fs::path& program = made(mistake.name);
        if (program.empty()) continue;
        JudgedLine other;
        if (line.looked.pictures) {
            other = judged(request_.program, program, line);
            // In some lines, the mistake does not show.
            if (!other.passed || judged(program, request_.reference, line).passed) continue;
        } else {
            other = judged(program, request_.reference, line);
            if (other.passed || without_digits(other.actual) != without_digits(line.actual))
                continue;
        }
        const bool here = other.looked.pictures && other.looked.pictures->bit_for_bit;
        if (to_the_bit && !here) continue;
        if (here && !to_the_bit) alike.clear();
        to_the_bit = here;
        alike.push_back(&mistake);
    }
    std::string words;
    for (const Mistake* const mistake : alike)
        words += (words.empty() ? "This looks like: " : " Or like: ") + mistake->title + ". " +
                 mistake->explanation;
    return words;
}

// What can still be wrong if the scene is handed over as it should be.
std::string GraftReason::what_is_left(const JudgedLine& line) {
    if (!is_right_ || !line.looked.pictures) return "";
    make({{"yours", source_}});
    if (!made("yours").empty() && judged(made("yours"), request_.reference, line).passed)
        return "With the solution's headers, your tracer.cpp draws our picture. One of your "
               "headers passes its checkpoints and is still wrong.";
    return "Your main() hands over the right scene; what differs is what it does with the pixels.";
}

// How a program does in this line if the reference is taken for ours.
JudgedLine GraftReason::judged(const fs::path& program, const fs::path& reference,
                               const JudgedLine& line) const {
    GraftRequest request{request_.chapter, program, reference, request_.chapter.graft->headers,
                         request_.seed};
    request.only_line = line.what;
    JudgedLine found;
    judge_graft(course_, request, [&](const JudgedLine& other) { found = other; });
    return found;
}

}  // namespace companion
