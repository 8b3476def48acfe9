#include <algorithm>
#include <companion/build/diagnostics.hpp>
#include <companion/build/missing_include.hpp>
#include <companion/model/source.hpp>
#include <companion/system/files.hpp>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

namespace companion {
namespace {

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

bool is_error(const Diagnostic& one) {
    return has(one.kind, "error");
}

// Whether a line says how the compiler got to what comes next.
bool is_origin(const std::string& line) {
    const auto start = std::min(line.find_first_not_of(' '), line.size());
    return start == 0 ? has(line, "from ") || has(line, ":   required ")
                      : line.compare(start, 5, "from ") == 0 ||
                            line.compare(start, 13, "inlined from ") == 0;
}

// Whether a line has the + or - of a diff. clang++ 14 shows source as it is, without a number.
bool is_marked(const std::string& line) {
    return line.rfind('+', 0) == 0 || line.rfind('-', 0) == 0;
}

// The message that begins in this line; without a kind if none does.
Diagnostic header_in(const std::string& line) {
    if (line.rfind(' ', 0) == 0) return {};  // source
    for (const char* const kind : {"fatal error", "error", "warning", "note"}) {
        const std::string mark = std::string{": "} + kind + ": ";
        const auto at = line.find(mark);
        if (at == std::string::npos) continue;
        Diagnostic found{line.substr(0, at), kind, line.substr(at + mark.size())};
        const auto option = found.what.rfind(" [-W");
        if (found.kind == "warning" && option != std::string::npos) {
            found.option = found.what.substr(option + 2, found.what.size() - option - 3);
            found.what.erase(option);
        }
        return found;
    }
    return {};
}

// The "file:line" of one of these files in a line; empty if it has none.
std::string place_in(const std::string& line, const std::vector<fs::path>& files) {
    for (const fs::path& file : files)
        if (const auto at = line.find(file.string() + ':'); at != std::string::npos) {
            const auto number = at + file.string().size() + 1;
            return line.substr(at, line.find_first_not_of("0123456789", number) - at);
        }
    return "";
}

// The "file:line" in these files that made the compiler compile what is wrong elsewhere; empty if
// there is none. g++ says so before the error. clang++ says so in notes; before the error, it names
// only the #include.
std::string came_from(const Diagnostic& error, const std::vector<fs::path>& files) {
    for (const Diagnostic& note : error.notes)
        if (note.is_in(files) && has(note.what, "in instantiation of")) return note.place();
    for (auto line = error.from.rbegin(); line != error.from.rend(); ++line)
        if (const std::string place = place_in(*line, files); !place.empty()) return place;
    return "";
}

// "\n  the } in line 7 ends a struct: write }; there", if the error is that the ; after a struct is
// missing; otherwise empty. g++ shows what follows the struct.
std::string missing_semicolon(const Course& course, const Diagnostic& error) {
    const std::string place = error.place();
    const auto colon = place.find(':');
    const fs::path file = course.root / place.substr(0, colon);
    if (!has(error.what, "expected initializer before") || !fs::is_regular_file(file)) return "";
    const std::string text = read_file(file);
    if (has(text, "/*")) return "";  // code_of() drops the lines of such a comment
    std::istringstream in{code_of(text)};
    std::vector<std::string> lines;
    const auto before = static_cast<std::size_t>(std::stoul(place.substr(colon + 1)) - 1);
    for (std::string line; lines.size() < before && std::getline(in, line);) lines.push_back(line);
    const auto is_blank = [](const std::string& line) {
        return line.find_first_not_of(" \t\r") == std::string::npos;
    };
    while (!lines.empty() && is_blank(lines.back())) lines.pop_back();
    if (lines.empty() || lines.back()[lines.back().find_last_not_of(" \t\r")] != '}') return "";
    // Goes back to the brace that the last one closes.
    int open = 0;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        for (auto at = line->rbegin(); at != line->rend(); ++at)
            if ((open += *at == '}' ? 1 : *at == '{' ? -1 : 0) == 0 && *at == '{') {
                const bool alone = std::next(line) != lines.rend() &&
                                   line->find_first_not_of(" \t") == line->find('{');
                const bool is_struct = std::regex_search(alone ? *std::next(line) : *line,
                                                         std::regex{"\\b(struct|class|enum)\\b"});
                return is_struct ? "\n  the } in line " + std::to_string(lines.size()) +
                                       " ends a struct: write }; there"
                                 : "";
            }
    }
    return "";
}

// What to look at, if the error is that the variable of a `for` is not known because the loop ended
// before; otherwise empty. The compiler warns about such a loop.
std::string ended_loop(const std::vector<Diagnostic>& all, const Diagnostic& error) {
    if (!has(error.what, "declared")) return "";
    std::smatch loop;
    for (const Diagnostic& one : all)
        if ((one.option == "-Wmisleading-indentation" || one.option == "-Wempty-body") &&
            !one.source.empty() &&
            std::regex_search(one.source.front(), loop, std::regex{"\\bfor \\(.*?(\\w+) [=:]"}) &&
            has(error.what, '\'' + loop[1].str() + '\''))
            return "\n  the `for` in line " + one.place().substr(one.place().find(':') + 1) +
                   " ends before this line: is there a ; after its ), or are braces missing?";
    return "";
}

// "\n  add #include <vector>, which declares std::vector", if a note of g++ names the header.
std::string named_header(const Diagnostic& error) {
    std::smatch header;
    for (const Diagnostic& note : error.notes)
        if (std::regex_search(note.what, header,
                              std::regex{"'(.+)' is defined in header '(<\\w+>)'"}))
            return "\n  add #include " + header[2].str() + ", which declares " + header[1].str();
    return "";
}

// The error, and what to do about it as far as that is known.
std::string with_remedy(const Course& course, const std::vector<Diagnostic>& all,
                        Diagnostic error) {
    std::string remedy = ended_loop(all, error);
    if (remedy.empty()) remedy = named_header(error);
    if (remedy.empty()) {
        remedy = missing_include(course, error.text());
        if (!remedy.empty()) remedy.insert(0, "\n  ");
    }
    // The compiler guesses at 'wcwidth' for 'width'.
    if (!remedy.empty())
        error.what.erase(std::min(error.what.find("; did you mean"), error.what.size()));
    return error.text() + missing_semicolon(course, error) + remedy;
}

// The error to show instead, if an error elsewhere comes from a parameter in these files that takes
// no const; otherwise empty.
std::string refused_const(const Diagnostic& error, const std::vector<fs::path>& files) {
    for (Diagnostic note : error.notes) {
        if (!note.is_in(files)) continue;
        if (has(note.what, "initializing argument") && has(error.what, "discards qualifiers"))
            note.what = error.what;
        else if (!has(note.what, "would lose const"))
            continue;
        note.kind = "error";
        return note.text(1);
    }
    return "";
}

// What the linker says, or a compiler without memory.
std::string error_without_place(const std::string& output) {
    std::istringstream in{output};
    for (std::string line; std::getline(in, line);) {
        if (has(line, "out of memory")) return line;
        for (const char* const start :
             {"undefined reference to ", "multiple definition of ", "Undefined symbol"})
            if (const auto at = line.find(start); at != std::string::npos)
                return "the linker says: " + line.substr(at);
    }
    return "";
}

}  // namespace

std::string Diagnostic::place() const {
    const auto column = at.rfind(':');
    const bool has_column = column != at.npos && at.find(':') != column;
    return at.substr(0, has_column ? column : at.npos);
}

bool Diagnostic::is_in(const std::vector<fs::path>& files) const {
    return std::any_of(files.begin(), files.end(),
                       [&](const fs::path& file) { return at.rfind(file.string() + ':', 0) == 0; });
}

std::string Diagnostic::text(std::size_t lines) const {
    std::string text = at + ": " + kind + ": " + what;
    for (std::size_t i = 0; i < std::min(lines, source.size()); ++i) text += '\n' + source[i];
    return text;
}

std::vector<Diagnostic> read_diagnostics(const Course& course, const std::string& output) {
    std::vector<Diagnostic> all;
    std::vector<std::string> from;  // of the message that comes next
    Diagnostic* last = nullptr;     // which the lines of source belong to
    std::istringstream in{output};
    for (std::string line; std::getline(in, line);) {
        line = with_relative_paths(course, line);
        Diagnostic found = header_in(line);
        if (found.kind == "note") {
            if (all.empty()) continue;
            last = &all.back().notes.emplace_back(std::move(found));
        } else if (!found.kind.empty()) {
            found.from = std::exchange(from, {});
            last = &all.emplace_back(std::move(found));
        } else if (is_origin(line)) {
            from.push_back(line);
            last = nullptr;
        } else if (line.rfind(' ', 0) == 0 || is_marked(line)) {
            if (last) last->source.push_back(line);
        } else {
            last = nullptr;
        }
    }
    return all;
}

std::string with_relative_paths(const Course& course, std::string line) {
    for (const fs::path& folder : {course.root, fs::weakly_canonical(course.root)}) {
        const std::string prefix = folder.generic_string() + '/';
        for (auto at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
            line.erase(at, prefix.size());
    }
    // The build runs in its own folder, so compilers may name files relative to that folder.
    if (line.rfind("../", 0) == 0) line.erase(0, 3);
    return line;
}

std::string first_error(const Course& course, const std::string& output,
                        const std::vector<fs::path>& files) {
    const std::vector<Diagnostic> all = read_diagnostics(course, output);
    std::vector<const Diagnostic*> errors;
    for (const Diagnostic& one : all)
        if (is_error(one)) errors.push_back(&one);
    for (const Diagnostic* const error : errors)
        if (error->is_in(files)) return with_remedy(course, all, *error);
    // After a brace that is never closed, every error is misleading, and this is the last message.
    for (const Diagnostic* const error : errors)
        for (const Diagnostic& note : error->notes)
            if (note.is_in(files) && has(note.what, "to match this"))
                return note.at + ": error: the brace { here is never closed";
    for (const Diagnostic* const error : errors)
        if (const std::string meant = refused_const(*error, files); !meant.empty()) return meant;
    for (const Diagnostic* const error : errors)
        if (const std::string place = came_from(*error, files); !place.empty())
            return error->text() + "\n  which came from " + place;
    // Without a place, g++ says only that the linker failed.
    const bool has_place = !errors.empty() && has(errors.front()->at, ":");
    const std::string other = has_place ? "" : error_without_place(output);
    return other.empty() && !errors.empty() ? errors.front()->text() : other;
}

std::string first_warning(const Course& course, const std::string& output,
                          const std::vector<fs::path>& files) {
    const char* const grave[]{"-Wreturn-type",          "-Wreturn-local-addr",
                              "-Wreturn-stack-address", "-Wdangling",
                              "-Winfinite-recursion",   "-Wuninitialized",
                              "-Wmaybe-uninitialized",  "-Wsometimes-uninitialized"};
    std::string first;
    for (const Diagnostic& one : read_diagnostics(course, output)) {
        if (one.kind != "warning") continue;
        const bool is_grave =
            std::any_of(std::begin(grave), std::end(grave),
                        [&](const char* name) { return one.option.rfind(name, 0) == 0; });
        // g++ may warn about a variable at the place where it is used, in the test that calls the
        // learner's function, and only then note where the variable was declared.
        const Diagnostic* here = one.is_in(files) ? &one : nullptr;
        if (is_grave && !here)
            for (const Diagnostic& note : one.notes)
                if (!here && note.is_in(files)) here = &note;
        if (!here) continue;
        if (first.empty() || is_grave) first = here->place() + ": " + one.what;
        if (is_grave) break;
    }
    return first;
}

}  // namespace companion
