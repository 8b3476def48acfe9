// Runs the mistakes of a chapter, which were built into FOLDER.
//
//   signature_tool --write FOLDER CHAPTER        writes down what fails in each
//   signature_tool --check FOLDER CHAPTER NN.k   checks those of one exercise: the test case
//                                                that should catch a mistake fails, and what fails
//                                                is recognized by what was written down, as this
//                                                mistake or as one that looks the same from outside

#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/check/check.hpp>
#include <companion/check/recognition.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/system/process.hpp>
#include <cstdio>
#include <set>

using namespace companion;

namespace {

// What the checkpoints say about a mistake, all of them or one test case. One alone gets more time.
std::vector<TestCase> run_mistake(const fs::path& folder, const std::string& name,
                                  const std::string& test_case = "") {
    Run run{.command = {(folder / ("mistake." + name)).string(), "-r", "events"},
            .output = Output::errors_hidden,
            .timeout = most_seconds};
    if (!test_case.empty()) {
        run.command.push_back(test_case);
        run.timeout = 60;
    }
    const Result result = run_process(run);
    if (result.exit_code == 127) throw app::Failure("mistake." + name + " is not built");
    return read_report(result.output);
}

// Whether the test case that should catch a mistake failed by an assertion, and ran to its end.
bool is_caught(const Mistake& mistake, const std::vector<TestCase>& tests) {
    return std::any_of(tests.begin(), tests.end(), [&](const TestCase& test) {
        return test.name == mistake.caught_by && test.ended && test.crash.empty() &&
               !test.failures.empty();
    });
}

// With threads, some mistakes fail in different assertions from run to run: what fails
// every time counts.
Signature what_always_fails(const fs::path& folder, const std::string& name) {
    Signature always = signature_of(run_mistake(folder, name));
    const Signature first = always;
    for (int again = 0; again < 2; ++again) {
        const Signature once_more = signature_of(run_mistake(folder, name));
        const auto keep_common = [](std::set<std::string>& kept,
                                    const std::set<std::string>& other) {
            for (auto it = kept.begin(); it != kept.end();)
                it = other.count(*it) ? std::next(it) : kept.erase(it);
        };
        keep_common(always.where, once_more.where);
        keep_common(always.what, once_more.what);
    }
    // Values that changed once will do so again.
    if (!(always == first)) always.what.clear();
    return always;
}

void write(const Course& course, const fs::path& folder, const Chapter& chapter) {
    Signatures signatures;
    for (const Mistake& mistake : read_mistakes(course, chapter))
        signatures[mistake.name] = what_always_fails(folder, mistake.name);
    app::replace_file(signatures_file(course, chapter), to_text(signatures));
    std::printf("%s: %zu signatures\n", chapter.name.c_str(), signatures.size());
}

// What a mistake was recognized as, in a few words; and whether that is right.
struct Recognized {
    std::string words;
    bool right;
};

// With threads, a mistake may fail in different assertions from run to run: it has three tries. A
// mistake that never fails in the same way twice, such as undefined behavior, is in no list.
Recognized try_to_recognize(const Signatures& known, const fs::path& folder, const Mistake& mistake,
                            const Signature& first) {
    const std::string exercise = mistake.name.substr(0, mistake.name.find('_'));
    const auto noted = known.find(mistake.name);
    bool by_luck = noted != known.end() && noted->second.what.empty();
    std::vector<LookAlikes> found;
    for (int tries = 0; tries < 3; ++tries) {
        const Signature signature =
            tries == 0 ? first : signature_of(run_mistake(folder, mistake.name));
        by_luck |= noted != known.end() && !(signature == first);
        found = recognize(known, exercise, signature);
        if (found.size() == 1 &&
            std::find(found[0].begin(), found[0].end(), mistake.name) != found[0].end())
            return {found[0].size() == 1 ? "recognized" : "recognized, and others like it", true};
    }
    return {"taken for " + (found.empty() ? "no known mistake" : found[0][0]) +
                (by_luck ? ", as it fails by luck" : ""),
            by_luck};
}

int check(const Course& course, const fs::path& folder, const Chapter& chapter,
          const std::string& exercise) {
    const Signatures known = read_signatures(course, chapter);
    std::set<std::string> names;
    int caught = 0, recognized = 0;
    for (const Mistake& mistake : read_mistakes(course, chapter)) {
        if (mistake.name.rfind(exercise + '_', 0) != 0) continue;
        names.insert(mistake.name);
        const std::vector<TestCase> tests = run_mistake(folder, mistake.name);
        // A mistake may end the program before the test case that catches it had its turn.
        const bool is_seen =
            is_caught(mistake, tests) ||
            is_caught(mistake, run_mistake(folder, mistake.name, mistake.caught_by));
        const Recognized seen = try_to_recognize(known, folder, mistake, signature_of(tests));
        caught += is_seen;
        recognized += seen.right;
        std::printf("%s%s: %s, %s\n", is_seen && seen.right ? "" : "FAILS ", mistake.name.c_str(),
                    is_seen ? "caught" : ("NOT CAUGHT by '" + mistake.caught_by + '\'').c_str(),
                    seen.words.c_str());
    }
    int gone = 0;
    for (const auto& [name, signature] : known)
        if (name.rfind(exercise + '_', 0) == 0 && !names.count(name)) {
            ++gone;
            std::printf("FAILS %s has a signature, and is gone\n", name.c_str());
        }
    const int count = static_cast<int>(names.size());
    std::printf("%s: %d mistakes, %d caught, %d recognized\n", exercise.c_str(), count, caught,
                recognized);
    if (recognized < count || gone)
        std::puts("cmake --build build --target mistake_signatures writes the signatures anew");
    return count > 0 && caught == count && recognized == count && !gone ? app::done
                                                                        : app::could_not;
}

int run(const std::vector<std::string>& words) {
    const Course course = this_course();
    if (words.size() == 3 && words[0] == "--write") {
        write(course, words[1], {words[2]});
        return app::done;
    }
    if (words.size() == 4 && words[0] == "--check")
        return check(course, words[1], {words[2]}, words[3]);
    throw app::UsageError(
        "usage: signature_tool --write FOLDER CHAPTER, or --check FOLDER CHAPTER NN.k");
}

}  // namespace

int main(int argc, char** argv) {
    return app::run_or_explain("signature_tool", [&] { return run({argv + 1, argv + argc}); });
}
