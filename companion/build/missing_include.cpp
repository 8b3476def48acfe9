#include <algorithm>
#include <companion/build/missing_include.hpp>
#include <companion/system/files.hpp>
#include <regex>
#include <set>

namespace companion {
namespace {

// The name that g++ or clang++ does not know; empty for other errors.
std::string unknown_name(const std::string& first_line) {
    static const std::regex patterns[]{
        std::regex{"'(?:rt::)?(\\w+)' (?:was not declared|has not been declared|does not name a|"
                   "is not a member of 'rt')"},
        std::regex{"(?:undeclared identifier|unknown type name|no arguments to|call to function) "
                   "'(\\w+)'"},
        std::regex{"no (?:member|type|template) named '(\\w+)' in namespace 'rt'"}};
    std::smatch found;
    for (const std::regex& pattern : patterns)
        if (std::regex_search(first_line, found, pattern)) return found[1];
    return "";
}

// A line that declares this name in the namespace rt, where lines are not indented.
std::regex declaration_of(const std::string& name) {
    return std::regex{"(?:struct|class|enum|enum class|using|concept) " + name +
                      "\\b(?!;).*|[A-Za-z_][^;={}()]*[ &*]" + name +
                      "\\(.*|(?:inline )?constexpr [\\w:<>]+ " + name + "\\b.*"};
}

bool declares(const std::string& header, const std::string& name, const std::regex& declaration) {
    for (auto at = header.find(name); at != std::string::npos; at = header.find(name, at + 1)) {
        const auto begin = header.rfind('\n', at) + 1;
        const std::string line = header.substr(begin, header.find('\n', at) - begin);
        if (std::regex_match(line, declaration)) return true;
    }
    return false;
}

// The headers <rt/...> that the text includes, and those that they include in their turn.
std::set<std::string> included_by(const std::string& text, const std::vector<fs::path>& folders,
                                  std::set<std::string> found = {}) {
    static const std::regex include{"#include <rt/(\\w+\\.hpp)>"};
    for (std::sregex_iterator one{text.begin(), text.end(), include}, end; one != end; ++one) {
        const std::string header = (*one)[1];
        if (!found.insert(header).second) continue;
        for (const fs::path& folder : folders)
            if (fs::is_regular_file(folder / header))
                found = included_by(read_text(folder / header), folders, std::move(found));
    }
    return found;
}

}  // namespace

std::string missing_include(const Course& course, const std::string& error) {
    const std::string name = unknown_name(error.substr(0, error.find('\n')));
    const fs::path file = error.substr(0, error.find(':')), whole = course.root / file;
    if (name.empty() || !fs::is_regular_file(whole)) return "";
    const bool is_tracer = file.parent_path().filename() == "tracer";
    if (!is_tracer && file.parent_path().filename() != "rt") return "";
    // <rt/pack.hpp> declares them, too, but a learner means the standard library's.
    if (std::regex_match(name, std::regex{"abs|copysign|fma|max|min|sqrt"})) return "";
    if (is_tracer && (name == "count" || name == "words")) return "";  // main's parameters

    // Given headers, and answers: a learner's own file may have lost its declaration.
    std::vector<fs::path> folders{course.root / "common/rt"};
    const std::string own_chapter = file.parent_path().parent_path().filename().string();
    for (const Chapter& chapter : chapters(course))
        if (is_tracer ? chapter.core : chapter.name <= own_chapter) {
            for (const fs::path& folder : given_folders(course, chapter))
                folders.push_back(course.root / folder / "rt");
            folders.push_back(course.root / "solutions" / chapter.name / "rt");
        }
    const std::regex declaration = declaration_of(name);
    std::vector<std::string> headers;
    for (const fs::path& folder : folders) {
        if (!fs::is_directory(folder)) continue;
        for (const auto& entry : fs::directory_iterator{folder})
            if (entry.path().extension() == ".hpp" &&
                declares(read_text(entry.path()), name, declaration))
                headers.push_back(entry.path().filename().string());
    }
    const std::string text = read_text(whole);
    // The tracer is not in the namespace rt, as the exercises' files are.
    const bool names_rt =
        text.find("using namespace rt;") != std::string::npos ||
        std::regex_search(error.substr(0, error.find('\n')), std::regex{"(of|namespace) 'rt'"});
    if (is_tracer && !names_rt) {
        const std::set<std::string> included = included_by(text, folders);
        if (std::any_of(headers.begin(), headers.end(),
                        [&](const std::string& header) { return included.count(header) > 0; }))
            return "write `using namespace rt;` below the #includes, or `rt::" + name + '`';
    }
    const auto named = std::find(headers.begin(), headers.end(), name + ".hpp");
    if (named == headers.end() && headers.size() != 1) return "";  // which overload is meant?
    const std::string header = named == headers.end() ? headers[0] : *named;
    const std::string include = "#include <rt/" + header + '>';
    if (file.filename() == header || text.find(include) != std::string::npos) return "";
    return "add " + include + ", which declares " + name;
}

}  // namespace companion
