// The rules of CONTRIBUTING.md that concern the sources as a whole. What depends on the stubs as
// shipped is tagged [stubs]: a learner's own code is free of these rules.

#include <companion/dev/parts.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/model/source.hpp>
#include <map>
#include <regex>
#include <set>
#include <source_text.hpp>
#include <sstream>

#include "catch.hpp"

namespace fs = std::filesystem;
using namespace source_text;
using companion::code_of, companion::signatures;

namespace {

const fs::path root = companion::this_course().root;

std::string name(const fs::path& path) {
    return path.lexically_relative(root).generic_string();
}

std::vector<companion::Chapter> chapters() {
    return companion::chapters(companion::this_course());
}

// Folders of chapters compare as these do, the later the greater: the program with all options
// stands above chapters 08, 10 to 12 and 14, and chapter 13 uses it.
std::string rank(const std::string& folder) {
    if (folder == "13_cluster") return "14_zz";
    return folder == "renderer" ? "14_z" : folder;
}
std::string rank(const fs::path& folder) {
    return rank(folder.filename().string());
}

// The chapter that a header <rt/NAME.hpp> belongs to, "" for common; and where it is.
struct Header {
    std::string chapter;
    fs::path path;
};

std::multimap<std::string, Header> headers() {
    std::multimap<std::string, Header> all;
    for (const fs::path& path : files(root / "common/rt", {".hpp"}))
        all.insert({path.filename().string(), {"", path}});
    for (const char* const kind : {"chapters", "solutions"})
        for (const fs::path& chapter : folders(root / kind))
            for (const fs::path& path : files(chapter, {".hpp"}))
                if (path.parent_path().filename() == "rt")
                    all.insert({path.filename().string(), {chapter.filename().string(), path}});
    return all;
}

struct TestCase {
    std::string name, tags;
};

// The checkpoints of a chapter. The tests of its given code, in a folder of their own, are left
// out. A test case's name may be given as several literals, one after the other.
std::vector<TestCase> test_cases(const std::string& chapter) {
    std::vector<TestCase> all;
    const std::regex pattern{"TEST_CASE\\(((?:\\s*\"[^\"]*\")+)\\s*,\\s*\"([^\"]*)\"\\s*\\)"};
    for (const fs::path& path : files(root / "tests" / chapter, {".cpp"})) {
        if (path.parent_path().filename() == "given") continue;
        const std::string text = code_of(read(path), true);
        for (std::sregex_iterator it{text.begin(), text.end(), pattern}, end; it != end; ++it) {
            TestCase test{"", (*it)[2]};
            for (const std::string& part : matches((*it)[1], "\"([^\"]*)\"")) test.name += part;
            all.push_back(test);
        }
    }
    return all;
}

// The exercises of a chapter, as its test cases name them.
std::set<std::string> exercises(const std::string& chapter) {
    std::set<std::string> ids;
    for (const TestCase& test : test_cases(chapter))
        ids.insert(test.name.substr(0, test.name.find(' ')));
    return ids;
}

bool has_tag(const TestCase& test, const std::string& tag) {
    return test.tags.find('[' + tag + ']') != std::string::npos;
}

std::vector<fs::path> documents() {
    auto all = files(root / "docs", {".md"});
    all.push_back(root / "README.md");
    all.push_back(root / "CONTRIBUTING.md");
    return all;
}

// A text without what it quotes as code.
std::string without_code(const std::string& markdown) {
    return std::regex_replace(markdown, std::regex{"```[\\s\\S]*?```|`[^`\n]*`"}, "");
}

// The chapter that a header may be used from: its own and all later ones.
void check_includes(const std::string& where, const std::string& text, const std::string& chapter) {
    const auto all = headers();
    for (const std::string& included : matches(text, "#include <rt/([^>]*)>")) {
        const auto [first, last] = all.equal_range(included);
        INFO(where << " includes <rt/" << included << '>');
        CHECK(first != last);
        for (auto it = first; it != last; ++it) CHECK(rank(it->second.chapter) <= rank(chapter));
    }
}
void check_includes(const fs::path& path, const std::string& chapter) {
    check_includes(name(path), read(path), chapter);
}

void check_sections(const std::string& text, const std::vector<std::string>& sections) {
    std::size_t at = 0;
    for (const std::string& section : sections) {
        INFO("the text needs a section '" << section << "', in this order");
        const auto found = text.find("\n## " + section + '\n');
        CHECK(found != std::string::npos);
        CHECK((found == std::string::npos || found > at));
        if (found != std::string::npos) at = found;
    }
}

std::vector<companion::Mistake> mistakes(const companion::Chapter& chapter) {
    return companion::read_mistakes(companion::this_course(), chapter);
}

}  // namespace

TEST_CASE("every folder of a chapter belongs to a chapter that is built", "[structure]") {
    std::set<std::string> known{"tracer",     // the learner's own program
                                "renderer"};  // the program with all options
    for (const auto& chapter : companion::every_chapter(companion::this_course()))
        known.insert(chapter.name);
    for (const char* const kind : {"chapters", "exercises", "solutions", "tests/mistakes"})
        for (const fs::path& folder : folders(root / kind)) {
            INFO(name(folder));
            CHECK(known.count(folder.filename().string()) == 1);
        }
}

TEST_CASE("stubs and answers come in pairs", "[stubs]") {
    for (const char* const kind : {"exercises", "solutions"})
        for (const fs::path& file : files(root / kind, {".hpp", ".cpp"})) {
            const fs::path folder = file.parent_path().filename();
            if (folder == "09_own" || folder == "tracer") continue;  // programs of the learner's
            const fs::path name_in_both = file.lexically_relative(root / kind);
            INFO(name(file));
            CHECK(fs::exists(root / "exercises" / name_in_both));
            CHECK(fs::exists(root / "solutions" / name_in_both));
        }
}

// Libraries round these differently: see common/rt/portable.hpp.
TEST_CASE("what draws a picture uses no function that libraries round differently", "[structure]") {
    const std::map<std::string, std::string> others{
        {"chapters/04_normals_aa/any_precision.hpp", "a study's, in long double too"},
        {"chapters/11_samples/accuracy/measured.hpp",
         "a study's interval, which nothing is drawn by"},
        {"chapters/09_own/many.cpp", "prints three digits, which are the same for all libraries"},
        {"common/study/classic_materials.hpp", "a study's, as books have it"},
        {"solutions/09_own/main.cpp", "includes nothing of the course"},
        {"solutions/11_samples/rt/standard_error.hpp", "a probability, which nothing is drawn by"}};
    const char* const functions =
        "\\bstd::((?:a?(?:sin|cos|tan)h?|atan2|exp[2m1]*|log[12p0]*|pow|"
        "cbrt|hypot|erfc?|[lt]gamma)f?)\\(";
    for (const char* const folder : {"common", "solutions", "chapters"})
        for (const fs::path& path : files(root / folder, {".hpp", ".cpp"})) {
            if (path.stem() == "study" || others.count(name(path)) == 1) continue;
            INFO(name(path) << " should take them from rt::portable");
            CHECK(matches(code_of(read(path)), functions) == std::vector<std::string>{});
        }
}

TEST_CASE("a header's name is unique", "[structure]") {
    for (const auto& [header, where] : headers()) {
        INFO("<rt/" << header << ">: " << name(where.path));
        CHECK(headers().count(header) == 1);
    }
}

TEST_CASE("every exercise has all of its parts", "[stubs]") {
    const companion::Course here = companion::this_course();
    for (const auto& exercise : companion::exercises(here))
        CHECK(companion::wrong_parts(here, exercise) == std::vector<std::string>{});
}

TEST_CASE("a header whose functions are to be written in a .cpp is the solution's", "[stubs]") {
    const auto declarations = [](const fs::path& header) {  // comments may differ in length
        return std::regex_replace(code_of(read(header)), std::regex{"\\s+"}, " ");
    };
    for (const fs::path& stub : files(root / "exercises", {".hpp"})) {
        if (!fs::exists(fs::path{stub}.replace_extension(".cpp"))) continue;
        INFO(name(stub));
        CHECK(signatures(read(stub)).empty());  // declarations alone
        CHECK(declarations(stub) ==
              declarations(root / "solutions" / stub.lexically_relative(root / "exercises")));
    }
}

TEST_CASE("the stubs of a chapter are those of its exercises", "[stubs]") {
    for (const auto& chapter : chapters()) {
        std::set<std::string> ids;
        for (const fs::path& stub : files(root / "exercises" / chapter.name, {".hpp", ".cpp"})) {
            check_includes(stub, chapter.name);
            const std::string text = read(stub);
            for (const std::string& id : matches(text, "todo\\(\\s*\"([^\"]*)\"")) {
                ids.insert(id);
            }
        }
        INFO(chapter.name);
        CHECK(ids == exercises(chapter.name));
    }
}

// A comment block of a stub; given code is not commented at such length, either.
static void check_comment(const fs::path& stub, const std::vector<std::string>& lines) {
    const auto begins = [](const std::string& line, const char* word) {
        return line.rfind(std::string{"// "} + word, 0) == 0;
    };
    std::string core, rest;
    int count = 0;
    for (const std::string& line : lines) {
        if (!rest.empty() || begins(line, "Star:") || begins(line, "Source:")) {
            rest += line + '\n';
            continue;
        }
        core += line + '\n';
        ++count;
    }
    INFO(name(stub) << " says\n" << core << rest);
    {
        INFO("the core's contract comes first, in at most five lines");
        CHECK(count <= 5);
    }
    INFO("lines that begin with // Star: or // Source: come after it, and bounds belong there");
    for (const char* const word : {"Star:", "Source:", "epsilon", "units in the last place"})
        CHECK(core.find(word) == core.npos);
    const auto star = rest.find("// Star:"), source = rest.find("// Source:");
    CHECK((star == rest.npos || source == rest.npos || star < source));
}

TEST_CASE("a stub gives the core's contract in at most five plain lines", "[stubs]") {
    int blocks = 0;
    for (const fs::path& stub : files(root / "exercises", {".hpp", ".cpp"})) {
        std::vector<std::string> block;
        std::istringstream text{read(stub) + '\n'};
        for (std::string line; std::getline(text, line);) {
            line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
            if (line.rfind("//", 0) == 0) {
                block.push_back(line);
                continue;
            }
            if (!block.empty()) check_comment(stub, block);
            blocks += !block.empty();
            block.clear();
        }
    }
    CHECK(blocks > 100);
}

TEST_CASE("no chapter uses what comes after it, and common uses no chapter", "[structure]") {
    for (const fs::path& path : files(root / "common", {".hpp", ".cpp"})) check_includes(path, "");
    for (const auto& chapter : chapters()) {
        for (const char* const kind : {"chapters", "solutions", "tests"})
            for (const fs::path& path : files(root / kind / chapter.name, {".hpp", ".cpp"}))
                check_includes(path, chapter.name);
        for (const auto& mistake : mistakes(chapter))
            for (const auto& edit : mistake.edits)
                check_includes(mistake.name, edit.after, chapter.name);
    }
    for (const char* const kind : {"chapters", "tests"})
        for (const fs::path& path : files(root / kind / "renderer", {".hpp", ".cpp"}))
            check_includes(path, "renderer");
}

// Neither do its build files, and #include "NAME" finds nothing there.
TEST_CASE("no chapter names what comes after it", "[structure]") {
    const std::vector<fs::path> all = folders(root / "chapters");
    for (const fs::path& folder : all)
        for (const fs::path& path : files(folder, {".hpp", ".cpp", ".txt"})) {
            const std::string text = read(path);
            const std::string code = path.extension() == ".txt" ? text : code_of(text, true);
            for (const fs::path& later : all) {
                if (rank(later) <= rank(folder)) continue;
                INFO(name(path) << " names " << name(later));
                const std::string words =
                    later.filename() == "renderer"
                        ? "(chapters/renderer|renderer_(?:solution|mine)|full_renderer)"
                        : '(' + later.filename().string() + ')';
                CHECK(matches(code, words.c_str()).empty());
            }
            for (const std::string& included : matches(text, "\n#include \"([^\"]*)\"")) {
                if (fs::exists(path.parent_path() / included)) continue;
                INFO(name(path) << " includes \"" << included
                                << "\", which only a later chapter has");
                CHECK(std::any_of(all.begin(), all.end(), [&](const fs::path& earlier) {
                    const auto kinds = folders(earlier);
                    const auto has = [&](const fs::path& place) {
                        return fs::exists(place / included);
                    };
                    return rank(earlier) <= rank(folder) &&
                           (has(earlier) || std::any_of(kinds.begin(), kinds.end(), has));
                }));
            }
        }
}

// Where the headers of these folders are included: <app/errors.hpp> is one of app.
TEST_CASE("the rooms of common and of the companion do not include each other", "[structure]") {
    std::map<std::string, std::set<std::string>> uses;
    const auto note = [&](const fs::path& folder, const std::string& room) {
        for (const fs::path& path : files(folder, {".hpp", ".cpp", ".inc"}))
            for (const std::string& used :
                 matches(read(path), "#include <((?:companion/)?[a-z]+)/[^>]*>"))
                if (used != room) uses[room].insert(used);
    };
    for (const fs::path& folder : folders(root / "common"))
        note(folder, folder.filename().string());
    for (const fs::path& folder : folders(root / "companion"))
        note(folder, "companion/" + folder.filename().string());
    CHECK(uses.size() >= 10);
    // What a room needs, and what that needs, and so on.
    for (std::size_t i = 0; i < uses.size(); ++i)
        for (auto& [room, used] : uses)
            for (const std::string& other : std::set<std::string>{used})
                if (uses.count(other)) used.insert(uses[other].begin(), uses[other].end());
    for (const auto& [room, used] : uses) {
        INFO(room << " needs itself: which of the rooms that it includes, includes it?");
        CHECK(used.count(room) == 0);
    }
    for (const char* const kind : {"chapters", "exercises", "solutions"})
        for (const fs::path& path : files(root / kind, {".hpp", ".cpp"})) {
            INFO(name(path));
            CHECK(matches(read(path), "(#include <companion/)").empty());
        }
}

TEST_CASE("there is no absolute epsilon in the solutions and in common", "[structure]") {
    // Numbers this small that are no tolerances: file and literal.
    const std::set<std::pair<std::string, std::string>> allowed{
        {"common/rt/color.hpp", "0.0031308"},  // where the sRGB transfer function turns linear
        {"solutions/09_own/main.cpp", "0.0031308"},
        {"common/study/cover.hpp", "1e-6"},  // milliseconds in a nanosecond
        // The first ray tracer has the textbook's faults; chapter 04 says why they fail.
        {"solutions/00_toolchain/first.cpp", "0.001"},
        {"solutions/tracer/01.cpp", "0.001"},
        {"solutions/tracer/02.cpp", "0.001"},
        {"solutions/tracer/03.cpp", "0.001"},
        // The classic renderer that the studies compare with has its faults, too.
        {"common/study/classic.cpp", "0.001"},
        {"common/study/classic_materials.hpp", "1e-8"},
        {"common/study/classic_numbers.hpp", "1e-160"}};
    for (const char* const folder : {"solutions", "common"})
        for (const fs::path& path : files(root / folder, {".hpp", ".cpp"})) {
            if (name(path) == "common/rt/portable.hpp") continue;  // coefficients of series
            for (std::string literal :
                 matches(code_of(read(path)),
                         "(?:^|[^\\w.])((?:0[xX][0-9a-fA-F.']+[pP]-?\\d+)|"
                         "(?:\\d[\\d']*\\.?[\\d']*|\\.\\d[\\d']*)(?:[eE][-+]?\\d+)?)")) {
                literal.erase(std::remove(literal.begin(), literal.end(), '\''), literal.end());
                const double value = std::stod(literal);
                if (value == 0 || value > 0.01 || allowed.count({name(path), literal})) continue;
                FAIL_CHECK(name(path) << ": " << literal
                                      << " looks like an absolute tolerance; derive it from the "
                                         "precision and the magnitudes at hand");
            }
        }
}

TEST_CASE("checkpoints are named and tagged by their exercise, some of them hard", "[structure]") {
    for (const auto& chapter : chapters()) {
        std::map<std::string, int> easy, hard;
        std::set<std::string> names;
        for (const TestCase& test : test_cases(chapter.name)) {
            INFO(chapter.name << ": " << test.name << ' ' << test.tags);
            const std::string id = test.name.substr(0, test.name.find(' '));
            CHECK(id.rfind(chapter.number() + '.', 0) == 0);
            CHECK(has_tag(test, id));
            INFO("Catch2 would take , [ ] * \" or a backslash for a filter");
            CHECK(test.name.find_first_of(",[]*\"\\") == std::string::npos);
            CHECK(names.insert(test.name).second);
            ++(has_tag(test, "hard") ? hard : easy)[id];
        }
        for (const std::string& id : exercises(chapter.name)) {
            INFO("exercise " << id);
            CHECK(easy[id] >= 1);
            CHECK(hard[id] >= 1);
        }
    }
}

TEST_CASE("every mistake explains itself and is caught by a test case", "[structure]") {
    for (const auto& chapter : chapters()) {
        const std::set<std::string> ids = exercises(chapter.name);
        std::map<std::string, int> count;
        std::set<std::string> cases;
        for (const TestCase& test : test_cases(chapter.name)) cases.insert(test.name);
        for (const auto& mistake : mistakes(chapter)) {
            INFO(mistake.name);
            const std::string id = mistake.name.substr(0, mistake.name.find('_'));
            ++count[id];
            CHECK(ids.count(id) == 1);
            CHECK(cases.count(mistake.caught_by) == 1);
            CHECK(mistake.explanation.size() > 40);
            const auto race = mistake.remarks.find("data race in");
            CHECK((race == mistake.remarks.end() || cases.count(race->second) == 1));
            CHECK_NOTHROW(edited_files(companion::this_course(), chapter.name, mistake));
        }
        for (const std::string& id : ids) {
            INFO("exercise " << id);
            CHECK(count[id] >= 3);
        }
    }
}

TEST_CASE("a chapter has all of its parts", "[structure]") {
    for (const auto& chapter : chapters()) {
        INFO(chapter.name);
        const std::string program = read(root / "chapters" / chapter.name / "main.cpp");
        const std::string text = read(root / chapter.text);
        CHECK(program.find("app::run(") != std::string::npos);
        CHECK(program.find(".study") != std::string::npos);
        CHECK(program.find(".name = \"" + chapter.name + '"') != std::string::npos);
        CHECK(fs::exists(root / "docs/images" / chapter.picture()));

        // Between the first two stand the ideas, each with its exercise.
        check_sections(text,
                       {"What you will see", "Hard cases", "What accuracy costs",
                        "Only what the scene calls for", "Common mistakes", "Where to read on"});
        CHECK(text.rfind("# ", 0) == 0);
        CHECK(text.find("](images/" + chapter.picture() + ')') != std::string::npos);
        CHECK(text.find("](plots/" + chapter.name + '-') != std::string::npos);
    }
}

TEST_CASE("the chapter with a task has all of its parts", "[structure]") {
    const auto chapter = companion::chapter_of_task(companion::this_course());
    REQUIRE(chapter);
    const fs::path start = root / "chapters" / chapter->name / "start";
    for (const char* const part : {"TASK.md", "accuracy.md", "build.sh", "main.cpp"})
        CHECK(fs::exists(start / part));
    CHECK(fs::file_size(start / "main.cpp") == 0);
    CHECK(fs::exists(root / "docs/images" / chapter->picture()));
    // Our answer is one file that includes nothing of the course.
    const std::string answer = read(root / "solutions" / chapter->name / "main.cpp");
    CHECK(std::count(answer.begin(), answer.end(), '\n') <= 540);
    CHECK(matches(answer, "#include <(rt|app|study|companion)/").empty());
    CHECK(matches(answer, "#include \"").empty());

    const std::string text = read(root / chapter->text);
    CHECK(text.find("](images/" + chapter->picture() + ')') != std::string::npos);
    check_sections(text, {"What you will see", "The task", "A plan", "When the picture is wrong",
                          "Hard cases", "What accuracy costs", "Only what the scene calls for",
                          "Common mistakes", "Where you go from here", "Where to read on"});
}

TEST_CASE("the texts and checkpoints have the exercises of course.json", "[structure]") {
    const companion::Course here = companion::this_course();
    for (const auto& chapter : chapters()) {
        const std::string text = read(root / chapter.text);
        std::set<std::string> ids;
        for (const auto& exercise : companion::exercises(here, chapter)) {
            ids.insert(exercise.id);
            INFO(chapter.text << " needs one section '### " << exercise.id
                              << " ...', with course.json's minutes of the core in its heading, "
                                 "and those of the star, if it has ★ folds, in their summaries");
            const std::string heading = "\n### " + exercise.id + " ([^\n]*)";
            const auto headings = matches(text, heading.c_str());
            REQUIRE(headings.size() == 1);
            const int shown = exercise.is_star() ? exercise.star_minutes : exercise.minutes;
            CHECK(matches(headings[0], "about ([0-9]+) minutes\\)$") ==
                  std::vector{std::to_string(shown)});
            if (!chapter.core) continue;
            const auto begin = text.find("\n### " + exercise.id + ' ');
            const std::string section = text.substr(
                begin, std::min(text.find("\n## ", begin), text.find("\n### ", begin + 1)) - begin);
            int of_folds = 0;
            const auto folds =
                matches(section, "<summary>★ [^<]*?([0-9]*)(?: minutes\\))?</summary>");
            for (const std::string& minutes : folds)
                of_folds += minutes.empty() ? 0 : std::stoi(minutes);
            CHECK((folds.empty() || of_folds == exercise.star_minutes));
        }
        INFO(chapter.name);
        CHECK(ids == exercises(chapter.name));
    }
}

TEST_CASE("the texts' formulas survive Markdown", "[structure]") {
    for (const fs::path& document : documents()) {
        for (const std::string& command : matches(without_code(read(document)),
                                                  "(\\\\[^A-Za-z\\s]|\\\\(?:operatorname|texttt))"))
            FAIL_CHECK(
                name(document)
                << ": GitHub shows " << command
                << " as something else: it removes the backslash before a punctuation mark, and "
                   "does not know all of TeX. Write \\thinspace, \\cr, \\lbrace, \\mathrm");
    }
}

TEST_CASE("every link and image of the texts leads somewhere", "[structure]") {
    // As GitHub makes anchors of headings: lower case, hyphens for spaces, punctuation left out.
    const auto anchors = [](const std::string& text) {
        std::set<std::string> all;
        for (const std::string& heading : matches(text, "(?:^|\n)#+ ([^\n]*)")) {
            std::string anchor;
            for (const char c : heading) {
                const auto byte = static_cast<unsigned char>(c);
                if (c == ' ' || c == '-') anchor += '-';
                if (std::isalnum(byte) || c == '_' || byte > 127)
                    anchor += static_cast<char>(std::tolower(byte));
            }
            all.insert(anchor);
        }
        return all;
    };
    for (const fs::path& document : documents()) {
        const std::string text = without_code(read(document));
        auto targets = matches(text, "\\]\\(([^)\\s]*)\\)");
        for (const std::string& source : matches(text, "(?:src|href)=\"([^\"]*)\""))
            targets.push_back(source);
        for (const std::string& target : targets) {
            if (std::regex_search(target, std::regex{"^[a-z]+:"})) continue;
            INFO(name(document) << " links to " << target);
            const auto hash = target.find('#');
            const fs::path file =
                hash == 0 ? document : document.parent_path() / target.substr(0, hash);
            CHECK(fs::exists(file));
            if (hash != std::string::npos && file.extension() == ".md")
                CHECK(anchors(read(file)).count(target.substr(hash + 1)) == 1);
        }
    }
}
