#include <app/files.hpp>
#include <companion/live/book_file.hpp>

namespace companion {
namespace {

fs::path folder_of_book(const Course& course) {
    return course.out() / "book";
}

std::string type_of(const fs::path& file) {
    static const std::map<std::string, std::string> types{{".html", "text/html; charset=utf-8"},
                                                          {".css", "text/css; charset=utf-8"},
                                                          {".js", "text/javascript; charset=utf-8"},
                                                          {".svg", "image/svg+xml"},
                                                          {".webp", "image/webp"},
                                                          {".png", "image/png"},
                                                          {".jpg", "image/jpeg"},
                                                          {".woff2", "font/woff2"},
                                                          {".csv", "text/csv; charset=utf-8"}};
    const auto known = types.find(file.extension().string());
    return known == types.end() ? "text/plain; charset=utf-8" : known->second;
}

// The text between these two, from a position on; empty if they are not there.
std::string between(const std::string& text, const std::string& before, const std::string& after,
                    std::size_t from = 0) {
    const auto start = text.find(before, from);
    if (start == std::string::npos) return {};
    const auto end = text.find(after, start + before.size());
    if (end == std::string::npos) return {};
    return text.substr(start + before.size(), end - start - before.size());
}

// The address of a chapter's first section whose heading begins so; `tag` is the heading's up to
// its id.
std::string section(const Course& course, const Chapter& chapter, const std::string& tag,
                    const std::string& heading) {
    const std::string page = chapter.text.stem().string() + ".html";
    const auto text = app::read_bytes(folder_of_book(course) / page);
    if (!text) return {};
    for (auto at = text->find(tag); at != std::string::npos; at = text->find(tag, at + 1)) {
        const std::string id = between(*text, tag, "\"", at);
        const std::string begin = "\">" + heading;
        if (text->compare(at + tag.size() + id.size(), begin.size(), begin) == 0)
            return "book/" + page + '#' + id;
    }
    return "book/" + page;
}

}  // namespace

std::optional<Content> book_file(const Course& course, const std::string& path) {
    std::error_code none;
    const fs::path folder = fs::canonical(folder_of_book(course), none);
    if (none) return {};
    const fs::path file = fs::canonical(folder / (path.empty() ? "index.html" : path), none);
    // A link that leads out of the folder is not followed.
    if (none || !fs::is_regular_file(file, none) ||
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first != folder.end())
        return {};
    const auto bytes = app::read_bytes(file);
    if (!bytes) return {};
    // The pages have scripts and styles in them, and figures that are compiled.
    Content content{type_of(file), *bytes, "'self' 'unsafe-inline' 'unsafe-eval' data: blob:"};
    if (const auto end = content.bytes.rfind("</body>");
        file.extension() == ".html" && file.parent_path() == folder && end != std::string::npos)
        content.bytes.insert(end, "<script src=\"../beside.js\"></script>\n");
    return content;
}

std::string book_section(const Course& course, const Exercise& exercise) {
    return section(course, exercise.chapter, "<h3 id=\"", exercise.id + ' ');
}

std::string book_section_of_graft(const Course& course, const Chapter& chapter) {
    return section(course, chapter, "<h2 id=\"", "Graft: ");
}

std::string book_title(const Course& course, const std::string& page) {
    const bool is_name = !page.empty() && page.find_first_not_of(
                                              "abcdefghijklmnopqrstuvwxyz_"
                                              "0123456789-.") == std::string::npos;
    if (!is_name || page.find("..") != std::string::npos) return {};
    const auto content = book_file(course, page);
    return content ? between(content->bytes, "<title>", " · ") : "";
}

}  // namespace companion
