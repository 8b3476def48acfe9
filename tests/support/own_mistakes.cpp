// own_mistakes REFERENCE START SOLUTION [--core | FILE.md [NAME]]: judges each mistake of our
// answer to chapter 09 in the file, or the one of this name, as `course own judge --part` does.
// Exactly the lines that the file names must fail: "caught by", and those of "also fails", with ";
// " between them, or "all the part". Without a file it judges the answer in SOLUTION, which must
// pass: with --core steps 1 to 6, without it all but the page on accuracy, whose figures are those
// of one machine. Lines that a busy machine cannot judge do not count.

#include <algorithm>
#include <app/cores.hpp>
#include <app/errors.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/own/judge.hpp>
#include <companion/own/own_program.hpp>
#include <companion/system/files.hpp>
#include <companion/system/process.hpp>
#include <cstdio>
#include <set>
#include <sstream>

#include "temporary_folder.hpp"

using namespace companion;

namespace {

// "step 3: one matte ball on the ground" belongs to "step3".
std::string part_of(const std::string& line) {
    std::string part = line.substr(0, line.find(':'));
    part.erase(std::remove(part.begin(), part.end(), ' '), part.end());
    return part;
}

// True for a line that compares times. The other lines need no fast program, and compiling a slow
// one takes half the time.
bool is_timed(const std::string& line) {
    return line.find(" against ") != std::string::npos;
}

// The headers that a source includes, compiled once for all programs. They take half of the time.
class PrecompiledLibrary {
  public:
    explicit PrecompiledLibrary(const fs::path& source) {
        std::istringstream lines{read_file(source)};
        std::string headers;
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("#include")) headers += line + "\n";
        checkpoint::write_file(file_, headers);
        if (!run_process(
                 {.command = {"sh", "-c",
                              compiler + "-x c++-header " + quoted() + " -o " + quoted(".gch")}})
                 .ok())
            throw app::Failure("the standard library does not compile");
    }
    // The text of a build.sh that uses it.
    std::string build() const {
        return compiler + "-include " + quoted() + " main.cpp -o own \"$@\"\n";
    }

  private:
    std::string quoted(const std::string& ending = "") const {
        return "'" + file_.string() + ending + "'";
    }

    static inline const std::string compiler = "g++ -std=c++20 -O1 -pthread ";
    checkpoint::TemporaryFolder folder_;
    fs::path file_ = folder_ / "library.hpp";
};

// Prints the result of a judged line, on one line.
void print(const JudgedLine& line) {
    std::printf("    %s %s: %s\n", line.passed ? "+" : "x", line.what.c_str(), line.actual.c_str());
    std::fflush(stdout);
}

bool passes_all(const fs::path& reference, const fs::path& start, const fs::path& solution,
                bool core) {
    const checkpoint::TemporaryFolder folder;
    fs::copy(start, folder.path(), fs::copy_options::recursive);
    fs::copy_file(solution / "main.cpp", folder / "main.cpp", fs::copy_options::overwrite_existing);
    bool passed = true;
    std::vector<std::string> parts = judge_parts();
    if (!core)
        for (const std::string& part : optional_parts()) parts.push_back(part);
    std::erase_if(parts, [core](const std::string& part) {
        return core ? part < "step1" || part > "step6" : part == "accuracy";
    });
    judge_program(OwnProgram{folder.path()},
                  {folder.path(), reference, 1, {}, app::physical_cores()}, parts,
                  [&](const JudgedLine& line) {
                      passed = passed && (line.passed || line.busy_machine);
                      print(line);
                  });
    return passed;
}

// True if exactly the right lines fail.
bool is_stopped(const Mistake& mistake, const fs::path& reference, const fs::path& start,
                const fs::path& solution) {
    const checkpoint::TemporaryFolder folder;
    fs::copy(start, folder.path(), fs::copy_options::recursive);
    for (const auto& [file, text] : edited_files(mistake, solution))
        checkpoint::write_file(folder / file, text);
    const std::string part = part_of(mistake.caught_by);
    if (!is_timed(mistake.caught_by)) {
        static const PrecompiledLibrary library{solution / "main.cpp"};
        checkpoint::write_file(folder / "build.sh", library.build());
    }

    std::set<std::string> wanted{mistake.caught_by}, failing, passing;
    struct Enough {};  // what comes after it takes half a minute to measure
    try {
        JudgeRequest request{folder.path(), reference, 1, part, app::physical_cores()};
        static OurPictures ours;  // the same for all mistakes
        request.ours = &ours;
        request.begins = [&](const std::string& line) {
            if (is_timed(line) && line != mistake.caught_by) throw Enough{};
        };
        const auto look = [&](const JudgedLine& line) {
            if (line.busy_machine)
                wanted.erase(line.what);
            else
                (line.passed ? passing : failing).insert(line.what);
            if (line.busy_machine || !line.passed) print(line);
        };
        if (part == "sanitizers")  // which builds programs of its own, and asks no other
            judge_program(OwnProgram{OwnProgram::Existing{}, reference}, request, {part}, look);
        else
            judge(request, look);
    } catch (const Enough&) {
    }
    const auto others = mistake.remarks.find("also fails");
    const bool all = others != mistake.remarks.end() && others->second == "all the part";
    if (others != mistake.remarks.end() && !all) {
        std::istringstream names{others->second};
        for (std::string name; std::getline(names >> std::ws, name, ';');) wanted.insert(name);
    }
    const bool stopped =
        all ? passing.empty() && failing.count(mistake.caught_by) == 1 : failing == wanted;
    std::printf("%s %s\n", stopped ? "stopped " : "WRONG   ", mistake.name.c_str());
    for (const std::string& line : wanted)
        if (!failing.count(line)) std::printf("    should fail, and passes: %s\n", line.c_str());
    std::fflush(stdout);
    return stopped;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 4)
        throw app::UsageError(
            "usage: own_mistakes REFERENCE START SOLUTION [--core | FILE.md [NAME]]");
    const bool core = argc == 5 && std::string{argv[4]} == "--core";
    if (argc == 4 || core)
        return passes_all(argv[1], argv[2], argv[3], core) ? app::done : app::could_not;
    bool all = true;
    for (const Mistake& mistake : read_mistakes(argv[4]))
        if (argc == 5 || mistake.name == argv[5])
            all = is_stopped(mistake, argv[1], argv[2], argv[3]) && all;
    return all ? app::done : app::could_not;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return app::could_not;
}
