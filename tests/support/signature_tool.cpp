// signature_tool --write|--check FOLDER CHAPTER...: runs the mistakes of these chapters, which
// were built into FOLDER, and writes down what fails in each; or checks that each is recognized by
// what was written down: as itself, or as one that looks the same from outside.

#include <algorithm>
#include <app/errors.hpp>
#include <companion/check/check.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/system/process.hpp>
#include <cstdio>
#include <rt/image_file.hpp>

using namespace companion;

namespace {

Signature run_mistake(const fs::path& folder, const std::string& name) {
    const Result result =
        run_process({.command = {(folder / ("mistake." + name)).string(), "-r", "events"},
                     .output = Output::errors_hidden,
                     .timeout = most_seconds});
    if (result.exit_code == 127) throw app::Failure("mistake." + name + " is not built");
    return signature_of(read_report(result.output));
}

std::vector<std::string> names_of_mistakes(const Course& course, const Chapter& chapter) {
    std::vector<std::string> names;
    const fs::path folder = course.root / "tests/mistakes" / chapter.name;
    if (!fs::exists(folder)) return names;
    for (const auto& entry : fs::directory_iterator{folder})
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

// Threads make some mistakes fail now here and now there: what fails every time counts.
Signature what_always_fails(const fs::path& folder, const std::string& name) {
    Signature always = run_mistake(folder, name);
    const Signature first = always;
    for (int again = 0; again < 2; ++again) {
        const Signature once_more = run_mistake(folder, name);
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
    for (const std::string& name : names_of_mistakes(course, chapter))
        signatures[name] = what_always_fails(folder, name);
    rt::replace_file(signatures_file(course, chapter), to_text(signatures));
    std::printf("%s: %zu signatures\n", chapter.name.c_str(), signatures.size());
}

int check(const Course& course, const fs::path& folder, const Chapter& chapter) {
    const Signatures known = read_signatures(course, chapter);
    int unknown = 0, alone = 0;
    const std::vector<std::string> names = names_of_mistakes(course, chapter);
    for (const std::string& name : names) {
        const std::string exercise = name.substr(0, name.find('_'));
        std::vector<std::vector<std::string>> found;
        const auto is_itself = [&] {
            return found.size() == 1 &&
                   std::find(found[0].begin(), found[0].end(), name) != found[0].end();
        };
        // Where threads meet, a mistake shows itself now here and now there: it has three tries.
        // One that never fails in the same way twice, such as undefined behavior, is in no list.
        const bool noted = known.count(name) == 1;
        bool by_luck = noted && known.at(name).what.empty();
        Signature first;
        for (int tries = 0; tries < 3 && !is_itself(); ++tries) {
            const Signature signature = run_mistake(folder, name);
            if (tries == 0) first = signature;
            by_luck |= noted && !(signature == first);
            found = recognize(known, exercise, signature);
        }
        if (is_itself()) {
            alone += found[0].size() == 1;
            continue;
        }
        unknown += !by_luck;
        std::printf("%s%s is taken for %s\n", name.c_str(), by_luck ? ", which fails by luck," : "",
                    found.empty() ? "no known mistake" : found[0][0].c_str());
    }
    for (const auto& [name, signature] : known)
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            ++unknown;
            std::printf("%s has a signature, and is gone\n", name.c_str());
        }
    std::printf("%s: %zu mistakes, %d not recognized, %d told from all others\n",
                chapter.name.c_str(), names.size(), unknown, alone);
    if (unknown) std::puts("cmake --build build --target mistake_signatures writes them anew");
    return unknown ? app::could_not : app::done;
}

int run(const std::vector<std::string>& words) {
    if (words.size() < 3 || (words[0] != "--write" && words[0] != "--check"))
        throw app::UsageError("usage: signature_tool --write|--check FOLDER CHAPTER...");
    const Course course = this_course();
    int worst = app::done;
    for (std::size_t i = 2; i < words.size(); ++i) {
        if (words[0] == "--write")
            write(course, words[1], {words[i]});
        else
            worst = std::max(worst, check(course, words[1], {words[i]}));
    }
    return worst;
}

}  // namespace

int main(int argc, char** argv) {
    return app::run_or_explain("signature_tool", [&] { return run({argv + 1, argv + argc}); });
}
