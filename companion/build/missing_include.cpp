#include <algorithm>
#include <companion/build/missing_include.hpp>
#include <companion/system/files.hpp>
#include <regex>
#include <set>
#include <sstream>

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

// A line that declares this name in a namespace, where lines are not indented. A function is meant
// only where the name is called.
std::regex declaration_of(const std::string& name, bool is_called) {
    const std::string function = "|[A-Za-z_][^;={}()]*[ &*]" + name + "\\(.*";
    return std::regex{"(?:struct|class|enum|enum class|using|concept) " + name +
                      "\\b(?!;).*|(?:inline )?constexpr [\\w:<>]+ " + name + "\\b.*" +
                      (is_called ? function : "")};
}

// Whether what follows this part of a header is in the namespace rt itself, and in none within it.
bool is_in_rt(const std::string& part) {
    std::vector<std::string> open;
    std::istringstream lines{part};
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("namespace ", 0) == 0)
            open.push_back(line);
        else if (line.rfind("}  // namespace", 0) == 0 && !open.empty())
            open.pop_back();
    return open == std::vector<std::string>{"namespace rt {"};
}

bool declares(const std::string& header, const std::string& name, const std::regex& declaration) {
    for (auto at = header.find(name); at != std::string::npos; at = header.find(name, at + 1)) {
        const auto begin = header.rfind('\n', at) + 1;
        const std::string line = header.substr(begin, header.find('\n', at) - begin);
        if (std::regex_match(line, declaration) && is_in_rt(header.substr(0, begin))) return true;
    }
    return false;
}

bool is_tracer(const fs::path& file) {
    return file.parent_path().filename() == "tracer";
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

// The given headers that a file may include, and answers: a learner's own file may have lost its
// declaration.
std::vector<fs::path> folders_for(const Course& course, const fs::path& file) {
    std::vector<fs::path> folders{course.root / "common/rt"};
    const std::string own_chapter = file.parent_path().parent_path().filename().string();
    for (const Chapter& chapter : chapters(course))
        if (is_tracer(file) ? chapter.core : chapter.name <= own_chapter) {
            for (const fs::path& folder : given_folders(course, chapter))
                folders.push_back(course.root / folder / "rt");
            folders.push_back(course.root / "solutions" / chapter.name / "rt");
        }
    return folders;
}

// "camera.width" or "image.width()", if a parameter of a function in this text has such a member;
// otherwise empty.
std::string member_of_parameter(const std::string& text, const std::string& name,
                                const std::vector<fs::path>& folders) {
    std::string headers;
    for (const std::string& header : included_by(text, folders))
        for (const fs::path& folder : folders)
            if (fs::is_regular_file(folder / header)) headers += read_text(folder / header);
    static const std::regex parameter{"([A-Z]\\w*)& (\\w+)[,)]"};
    const std::regex variable{"    [^ (/][^(/]*[ ,]" + name + "\\b[^(]*;.*"},
        function{"    [^ (/][^(/]* " + name + "\\(\\) const.*"};
    for (std::sregex_iterator one{text.begin(), text.end(), parameter}, end; one != end; ++one)
        for (const char* const kind : {"\nstruct ", "\nclass "}) {
            const auto begin = headers.find(kind + (*one)[1].str() + " {\n");
            if (begin == std::string::npos) continue;
            std::istringstream body{headers.substr(begin + 1, headers.find("\n};", begin) - begin)};
            for (std::string line; std::getline(body, line);)
                if (std::regex_match(line, variable))
                    return (*one)[2].str() + '.' + name;
                else if (std::regex_match(line, function))
                    return (*one)[2].str() + '.' + name + "()";
        }
    return "";
}

}  // namespace

std::string missing_include(const Course& course, const std::string& error) {
    const std::string first_line = error.substr(0, error.find('\n')),
                      source = error.substr(first_line.size()), name = unknown_name(first_line);
    const fs::path file = error.substr(0, error.find(':')), whole = course.root / file;
    if (name.empty() || !fs::is_regular_file(whole)) return "";
    if (!is_tracer(file) && file.parent_path().filename() != "rt") return "";
    // <rt/pack.hpp> declares them, too, but a learner means the standard library's.
    if (std::regex_match(name, std::regex{"abs|copysign|fma|max|min|sqrt"})) return "";
    if (is_tracer(file) && (name == "count" || name == "words")) return "";  // main's parameters

    const std::vector<fs::path> folders = folders_for(course, file);
    const std::regex declaration =
        declaration_of(name, std::regex_search(source, std::regex{"\\b" + name + " *[(<]"}));
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
    const bool names_rt = text.find("using namespace rt;") != std::string::npos ||
                          std::regex_search(first_line, std::regex{"(of|namespace) 'rt'"});
    if (is_tracer(file) && !names_rt) {
        const std::set<std::string> included = included_by(text, folders);
        if (std::any_of(headers.begin(), headers.end(),
                        [&](const std::string& header) { return included.count(header) > 0; }))
            return "write `using namespace rt;` below the #includes, or `rt::" + name + '`';
    }
    if (headers.empty() && !std::regex_search(source, std::regex{"\\b" + name + " *(=[^=]|\\()"}))
        if (const std::string member = member_of_parameter(text, name, folders); !member.empty())
            return "write `" + member + '`';
    const auto named = std::find(headers.begin(), headers.end(), name + ".hpp");
    if (named == headers.end() && headers.size() != 1) return "";  // which overload is meant?
    const std::string header = named == headers.end() ? headers[0] : *named;
    const std::string include = "#include <rt/" + header + '>';
    if (file.filename() == header || text.find(include) != std::string::npos) return "";
    return "add " + include + ", which declares " + name;
}

}  // namespace companion
