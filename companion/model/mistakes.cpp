#include <algorithm>
#include <app/errors.hpp>
#include <companion/model/mistakes.hpp>
#include <companion/system/files.hpp>
#include <regex>
#include <set>
#include <sstream>

namespace companion {
namespace {

// The optional lines of a mistake. The build reads them, too: see cmake/Mistakes.cmake.
const std::set<std::string> yes_only{"changes picture",
                                     "certificate fails"};  // a line of `course certify`
const std::set<std::string> with_value{
    "address sanitizer reports",  // a pattern of its report
    "compare says",               // a pattern of the words of `course compare`
    "only if the answer has",     // a pattern of its code; without it, the mistake is not suggested
    "unless the answer has",      // the same, with it: what the mistake says is missing
    "edits",                      // "plain answer", see mistakes.hpp
    "data race in",               // the test case in which the thread sanitizer reports one
    "also fails",                 // for programs of chapter 09: further lines of the verdict
    "main hands over"};           // for grafts: a pattern of the words that say what is wrong there

class Reader {
  public:
    explicit Reader(const fs::path& file) : file_{file} {
        std::istringstream in{read_text(file)};
        for (std::string line; std::getline(in, line);) lines_.push_back(line);
    }

    std::vector<Mistake> read() {
        const std::string exercise = file_.stem().string();
        skip_blank();
        expect("# Mistakes of " + exercise);
        std::vector<Mistake> mistakes;
        for (skip_blank(); !at_end(); skip_blank()) mistakes.push_back(mistake(exercise));
        return mistakes;
    }

  private:
    bool at_end() const { return at_ == lines_.size(); }
    std::string line() const { return at_end() ? "" : lines_[at_]; }
    bool starts_with(const std::string& start) const { return line().rfind(start, 0) == 0; }
    std::string place() const {
        return file_.generic_string() + ':' + std::to_string(std::min(at_ + 1, lines_.size()));
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw app::Failure(place() + ": " + what);
    }
    // The part of the line between this start and this end; empty if the line does not start and
    // end so.
    std::string between(const std::string& start, const std::string& end) const {
        const std::string text = line();
        const bool fits = text.size() >= start.size() + end.size() && starts_with(start) &&
                          text.compare(text.size() - end.size(), end.size(), end) == 0;
        return fits ? text.substr(start.size(), text.size() - start.size() - end.size()) : "";
    }
    void skip_blank() {
        while (!at_end() && line().empty()) ++at_;
    }
    void expect(const std::string& wanted) {
        if (line() != wanted)
            fail("expected the line '" + wanted +
                 "', actual: " + (at_end() ? "the end of the file" : '\'' + line() + '\''));
        ++at_;
    }

    Mistake mistake(const std::string& exercise) {
        Mistake mistake;
        mistake.name = between("## ", "");
        if (mistake.name.rfind(exercise + '_', 0) != 0 ||
            mistake.name.find(' ') != std::string::npos)
            fail("expected a heading '## " + exercise + "_name', actual: '" + line() + '\'');
        if (!names_.insert(mistake.name).second)
            fail("another mistake is called " + mistake.name + "; each needs a name of its own");
        ++at_;
        keys(mistake);
        mistake.explanation = paragraph();
        if (mistake.explanation.empty()) fail(mistake.name + " needs words for the learner here");
        for (skip_blank(); !at_end() && !starts_with("## "); skip_blank())
            read_edits(mistake.edits);
        if (mistake.edits.empty())
            fail(mistake.name + " needs an edit here: '```diff rt/file.hpp'");
        return mistake;
    }

    void keys(Mistake& mistake) {
        std::map<std::string, std::string> values;
        for (; !line().empty(); ++at_) {
            const auto colon = line().find(": ");
            const std::string key = line().substr(0, colon);
            if (colon == std::string::npos || line().size() == colon + 2)
                fail("expected 'key: value' or an empty line, actual: '" + line() + '\'');
            if (key != "title" && key != "caught by" && !yes_only.count(key) &&
                !with_value.count(key))
                fail("'" + key + "' is not a known key; see companion/model/mistakes.cpp");
            const std::string value = line().substr(colon + 2);
            if (yes_only.count(key) && value != "yes")
                fail("expected '" + key + ": yes' or no such line, actual: '" + line() + '\'');
            if (key == "edits" && value != "plain answer")
                fail("expected 'edits: plain answer' or no such line, actual: '" + line() + '\'');
            if (!values.insert({key, value}).second) fail("'" + key + "' appears twice");
        }
        for (const char* const key : {"title", "caught by"})
            if (!values.count(key)) fail(mistake.name + " needs a line '" + key + ": ...' here");
        mistake.title = values.extract("title").mapped();
        mistake.caught_by = values.extract("caught by").mapped();
        mistake.remarks = std::move(values);
    }

    // Everything up to the first edit or the next heading.
    std::string paragraph() {
        std::string text;
        for (; !at_end() && !starts_with("```") && !starts_with("## "); ++at_)
            if (!line().empty()) text += (text.empty() ? "" : " ") + line();
        return text;
    }

    // The edits of one file.
    void read_edits(std::vector<Edit>& edits) {
        const std::string file = between("```diff ", "");
        // The file is in rt/, or it is a program by itself in the chapter's folder.
        if (file.empty() || (file.rfind("rt/", 0) != 0 && file.find('/') != std::string::npos))
            fail("expected '```diff rt/file.hpp', actual: '" + line() + '\'');
        do {
            ++at_;
            edits.push_back(edit(file));
        } while (line() == "@@");
        expect("```");
    }

    Edit edit(const std::string& file) {
        Edit edit{file, "", "", place()};
        for (; !at_end() && line() != "```" && line() != "@@"; ++at_) {
            const char kind = line().empty() ? ' ' : line()[0];
            if (kind != ' ' && kind != '-' && kind != '+')
                fail("expected a line that begins with ' ', '-' or '+', actual: '" + line() + '\'');
            const std::string code = (line().empty() ? "" : line().substr(1)) + '\n';
            if (kind != '+') edit.before += code;
            if (kind != '-') edit.after += code;
        }
        if (edit.before.empty())
            throw app::Failure(edit.place + ": expected lines to replace, actual: none");
        if (edit.before == edit.after)
            throw app::Failure(edit.place + ": this edit changes nothing");
        return edit;
    }

    fs::path file_;
    std::vector<std::string> lines_;
    std::size_t at_ = 0;
    std::set<std::string> names_;
};

// The positions in a text at which these whole lines start.
std::vector<std::size_t> places(const std::string& text, const std::string& lines) {
    std::vector<std::size_t> found;
    for (auto at = text.find(lines); at != std::string::npos; at = text.find(lines, at + 1))
        if (at == 0 || text[at - 1] == '\n') found.push_back(at);
    return found;
}

}  // namespace

std::vector<Mistake> read_mistakes(const fs::path& file) {
    return Reader{file}.read();
}

std::vector<Mistake> read_mistakes(const Course& course, const Chapter& chapter) {
    std::set<fs::path> files;
    for (const auto& entry : fs::directory_iterator{course.root / "tests/mistakes" / chapter.name})
        if (entry.path().extension() == ".md") files.insert(entry.path());
    std::vector<Mistake> all;
    for (const fs::path& file : files)
        for (Mistake& mistake : read_mistakes(file)) all.push_back(std::move(mistake));
    return all;
}

Mistake read_mistake(const Course& course, const Chapter& chapter, const std::string& name) {
    const fs::path file =
        course.root / "tests/mistakes" / chapter.name / (name.substr(0, name.find('_')) + ".md");
    for (const Mistake& mistake : read_mistakes(file))
        if (mistake.name == name) return mistake;
    throw app::Failure(file.generic_string() + " does not describe " + name);
}

bool may_be(const Mistake& mistake, const std::string& code) {
    const auto has = [&](const char* remark, bool without) {
        const auto pattern = mistake.remarks.find(remark);
        return pattern == mistake.remarks.end()
                   ? without
                   : std::regex_search(code, std::regex{pattern->second});
    };
    return has("only if the answer has", true) && !has("unless the answer has", false);
}

bool is_refuted(const Mistake& mistake, const std::vector<std::string>& failed,
                const std::vector<std::string>& passed) {
    if (std::count(passed.begin(), passed.end(), mistake.caught_by)) return true;
    const auto is_step = [](const std::string& test) {
        return test.find(" step ") == test.find(' ') && test.find(' ') != std::string::npos;
    };
    const auto first = std::find_if(failed.begin(), failed.end(), is_step);
    return first != failed.end() && is_step(mistake.caught_by) && mistake.caught_by != *first;
}

std::map<std::string, std::string> edited_files(const Mistake& mistake, const fs::path& solution) {
    std::map<std::string, std::string> files;
    for (const Edit& edit : mistake.edits) {
        const fs::path path = solution / edit.file;
        if (!fs::exists(path))
            throw app::Failure(edit.place + ": there is no " + path.generic_string());
        std::string& text = files.try_emplace(edit.file, read_text(path)).first->second;
        const auto found = places(text, edit.before);
        if (found.empty())
            throw app::Failure(
                edit.place + ": these lines are not in " + path.generic_string() +
                "; copy whole lines from there exactly, as they are after the earlier edits");
        if (found.size() > 1)
            throw app::Failure(edit.place + ": these lines appear " + std::to_string(found.size()) +
                               " times in " + path.generic_string() +
                               "; add a line before or after that tells them apart");
        text.replace(found[0], edit.before.size(), edit.after);
    }
    return files;
}

std::map<std::string, std::string> edited_files(const Course& course, const std::string& chapter,
                                                const Mistake& mistake) {
    const bool is_plain = mistake.remarks.count("edits") > 0;
    return edited_files(mistake, course.root / (is_plain ? "tests/plain" : "solutions") / chapter);
}

}  // namespace companion
