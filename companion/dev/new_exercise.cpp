#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/dev/new_exercise.hpp>
#include <companion/model/course_file.hpp>
#include <companion/system/files.hpp>
#include <map>
#include <regex>
#include <sstream>
#include <string_view>

namespace companion {
namespace {

void replace_all(std::string& text, const std::string& what, const std::string& with) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

// The text with `section` inserted after the section of an exercise: before the next heading that
// is not in a code block.
std::string with_section(const std::string& text, const std::string& last,
                         const std::string& section) {
    const std::regex its_heading{"#+ " + last + "\\b.*"};
    std::istringstream in{text};
    std::string result;
    bool is_after = false, is_code = false, is_added = false;
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("```", 0) == 0) is_code = !is_code;
        const bool is_heading = !is_code && line.rfind('#', 0) == 0;
        if (is_heading && is_after && !is_added) {
            result += section + '\n';
            is_added = true;
        }
        is_after = is_after || (is_heading && std::regex_match(line, its_heading));
        result += line + '\n';
    }
    if (!is_after) throw app::Failure("there is no heading '" + last + "' to come after");
    return is_added ? result : result + '\n' + section;
}

// course.json with `line` inserted after the line of an exercise, with the same indent.
std::string with_line(const std::string& text, const std::string& last, std::string line) {
    const auto start = text.find("{\"id\": \"" + last + '"');
    const auto end = std::min(text.find('\n', start), text.size());
    if (start == std::string::npos)
        throw app::Failure("course.json: no line begins with {\"id\": \"" + last + '"');
    const auto indent = start - (text.rfind('\n', start) + 1);
    line.pop_back();  // the line break
    const bool has_comma = text[end - 1] == ',';
    return text.substr(0, end) + (has_comma ? "" : ",") + '\n' + std::string(indent, ' ') + line +
           (has_comma ? "," : "") + text.substr(end);
}

// The route with a step inserted after the last step of its chapter; electives have no steps.
std::string with_step(std::string text, const std::string& id) {
    const auto end = text.find("\"chapters\"");
    const auto at = text.rfind('"' + id.substr(0, id.find('.') + 1), end);
    if (at != std::string::npos && at > text.find("\"route\""))
        text.insert(text.find('"', at + 1) + 1, ", \"" + id + '"');
    return text;
}

// C++20's keywords, each between spaces.
constexpr std::string_view keywords =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t "
    "char32_t char8_t class co_await co_return co_yield compl concept const const_cast "
    "consteval constexpr constinit continue decltype default delete do double dynamic_cast "
    "else enum explicit export extern false float for friend goto if inline int long mutable "
    "namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
    "register reinterpret_cast requires return short signed sizeof static static_assert "
    "static_cast struct switch template this thread_local throw true try typedef typeid "
    "typename union unsigned using virtual void volatile wchar_t while xor xor_eq ";

void expect_function_name(const std::string& name) {
    if (!std::regex_match(name, std::regex{"[a-z][a-z0-9_]*"}) ||
        name.find("__") != std::string::npos)
        throw app::UsageError(
            "--name: '" + name +
            "' is not the name of a function: small letters, digits and single _");
    if (keywords.find(' ' + name + ' ') != std::string_view::npos)
        throw app::UsageError("--name: '" + name + "' is a keyword of C++; choose another name");
}

// Throws app::UsageError if this is not the number of a chapter's next exercise. Returns the last
// exercise that the chapter has.
Exercise last_before(const CourseFile& file, const std::string& id) {
    Exercise last;
    for (const Exercise& exercise : file.exercises)
        if (exercise.chapter.number() == id.substr(0, id.find('.'))) last = exercise;
    if (last.id.empty())
        throw app::UsageError("'" + id +
                              "' names no chapter of exercises; write NN.k, such as 05.7");
    const int number = std::stoi(last.id.substr(last.id.find('.') + 1)) + 1;
    if (number > 9)
        throw app::UsageError("chapter " + last.chapter.number() + " has nine exercises, the most");
    const std::string next = last.chapter.number() + '.' + std::to_string(number);
    if (id != next) throw app::UsageError("the next exercise of this chapter is " + next);
    return last;
}

}  // namespace

std::vector<fs::path> begin_exercise(const Course& course, const std::string& id,
                                     const std::string& name) {
    expect_function_name(name);
    const Exercise last = last_before(read_course_file(course), id);
    for (const char* const kind : {"common", "chapters", "solutions"})
        for (const fs::path& file : source_files(course.root / kind))
            if (file.filename() == name + ".hpp")
                throw app::UsageError("--name: " + course.relative(file) +
                                      " has this name; each header needs one of its own");

    std::string all = read_text(course.root / "companion/dev/exercise.txt");
    replace_all(all, "NN.k", id);
    replace_all(all, "NN_topic", last.chapter.name);
    replace_all(all, "NAME", name);
    std::map<fs::path, std::string> files;
    for (auto at = all.find("\n== "); at != std::string::npos;) {
        const auto start = all.find('\n', at + 1) + 1, next = all.find("\n== ", start);
        const std::string where = all.substr(at + 4, start - at - 5);
        const std::string part =
            all.substr(start, next == std::string::npos ? next : next + 1 - start);
        at = next;
        if (where == "course.json, after the last exercise")
            files["course.json"] =
                with_step(with_line(read_text(course.root / "course.json"), last.id, part), id);
        else if (where == "the text, after the last exercise")
            files[last.chapter.text] =
                with_section(read_text(course.root / last.chapter.text), last.id, part);
        else if (where == "the hints, after the last exercise")
            files[last.chapter.hints] =
                with_section(read_text(course.root / last.chapter.hints), last.id, part);
        else if (fs::exists(course.root / where))
            throw app::UsageError(where + " exists; move it away");
        else
            files[where] = part;
    }
    std::vector<fs::path> made;
    for (const auto& [file, text] : files) {
        app::make_folder((course.root / file).parent_path());
        app::replace_file(course.root / file, text);
        made.push_back(file);
    }
    return made;
}

}  // namespace companion
