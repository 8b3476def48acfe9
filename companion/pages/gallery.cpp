#include <companion/pages/gallery.hpp>
#include <companion/pages/html.hpp>
#include <companion/pages/studies.hpp>
#include <sstream>

namespace companion {
namespace {

constexpr const char* gallery_head = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>A ray tracer, chapter by chapter</title>
<style>
  :root { --page: #f6f5f2; --card: #fff; --ink: #1d1f23; --soft: #5c6068; --line: #e2e0da;
          --link: #0b5cad; }
  @media (prefers-color-scheme: dark) {
    :root { --page: #121316; --card: #1b1d21; --ink: #e8e6e1; --soft: #a0a4ab; --line: #2c2f35;
            --link: #7db7f0; }
  }
  * { box-sizing: border-box; }
  body { margin: 0; background: var(--page); color: var(--ink);
         font: 17px/1.55 system-ui, -apple-system, "Segoe UI", sans-serif; }
  header, main, footer { max-width: 1020px; margin: 0 auto; padding: 0 20px; }
  header { padding-top: 56px; }
  h1 { font-size: 2.1rem; line-height: 1.2; margin: 0 0 .3em; letter-spacing: -.015em; }
  h2 { font-size: 1.35rem; line-height: 1.25; margin: 0 0 .5em; }
  p { margin: 0 0 .8em; max-width: 44em; }
  a { color: var(--link); text-decoration-thickness: 1px; text-underline-offset: 3px; }
  code { font: .9em ui-monospace, "SF Mono", Menlo, Consolas, monospace; }
  nav { display: flex; flex-wrap: wrap; gap: 4px 18px; margin: 1em 0 0; font-size: .95rem; }
  article { background: var(--card); border: 1px solid var(--line); border-radius: 10px;
            margin: 36px 0; overflow: hidden; }
  article > a { display: block; background: #000; }
  article > a > img { display: block; max-width: 100%; height: auto; margin: 0 auto; }
  .text { padding: 22px 26px 14px; }
  .made { color: var(--soft); font-size: .88rem; }
  .missing { color: var(--soft); font-style: italic; }
  details { border-top: 1px solid var(--line); padding: 14px 26px; }
  summary { cursor: pointer; color: var(--soft); }
  figure { margin: 16px 0 4px; }
  figcaption { color: var(--soft); font-size: .88rem; text-align: center; }
  details img { display: block; width: 100%; max-width: 520px; height: auto; margin: 0 auto;
                border-radius: 6px; }
  footer { color: var(--soft); font-size: .88rem; padding-bottom: 48px; }
  @media (max-width: 600px) { .text, details { padding-left: 16px; padding-right: 16px; } }
</style>
)";

std::string title_of(const Chapter& chapter) {
    return "Chapter " + chapter.number() + (chapter.core ? ": " : ", an elective: ") +
           chapter.title;
}

std::string link(const std::string& target, const std::string& text) {
    return "<a href=\"" + escape_html(target) + "\">" + text + "</a>";
}

void add_exhibit(std::ostream& out, const Exhibit& exhibit, bool is_first) {
    const Chapter& chapter = exhibit.chapter;
    const std::string title = escape_html(title_of(chapter));
    out << "<article id=\"" << chapter.name << "\">\n";
    if (exhibit.has_picture)
        out << link(chapter.picture(), "<img src=\"" + chapter.picture() + "\" alt=\"" + title +
                                           '"' + (is_first ? "" : " loading=\"lazy\"") + '>')
            << '\n';
    out << "<div class=\"text\">\n<h2>" << title << "</h2>\n";
    if (!exhibit.has_picture) out << "<p class=\"missing\">No picture: the program failed.</p>\n";
    out << "<p>" << escape_html(chapter.caption) << "</p>\n";
    out << "<p class=\"made\">";
    const char* separator = "";
    const auto add = [&](const std::string& part) {
        out << separator << part;
        separator = " · ";
    };
    if (!exhibit.rendered.empty()) add(escape_html(exhibit.rendered));
    if (exhibit.has_text) add(link("../" + chapter.text.string(), "the chapter’s text"));
    if (exhibit.has_table) add(link("study/" + chapter.table(), "its measurements"));
    out << "</p>\n</div>\n";
    if (!exhibit.plots.empty()) {
        out << "<details open>\n<summary>What accuracy costs, measured "
            << (exhibit.has_table ? "here"
                                  : "by the authors (on your machine: "
                                    "<code>./course study</code>)")
            << "</summary>\n";
        for (const Plot& plot : exhibit.plots)
            out << "<figure><img src=\"" << plot.file << "\" alt=\"" << escape_html(plot.says)
                << "\" loading=\"lazy\"><figcaption>" << escape_html(plot.study)
                << "</figcaption></figure>\n";
        out << "</details>\n";
    }
    out << "</article>\n";
}

}  // namespace

Exhibit collect(const Course& course, const Chapter& chapter, const std::string& rendered) {
    Exhibit exhibit;
    exhibit.chapter = chapter;
    exhibit.rendered = rendered;
    exhibit.has_picture = fs::exists(course.out() / chapter.picture());
    exhibit.has_text = fs::is_regular_file(course.root / chapter.text);
    exhibit.has_table = fs::exists(study_folder(course) / chapter.table());
    exhibit.plots = plots(course, chapter);
    return exhibit;
}

std::string gallery_html(const std::vector<Exhibit>& exhibits, bool with_book) {
    std::ostringstream out;
    out << gallery_head
        << "<header>\n<h1>A ray tracer, chapter by chapter</h1>\n"
           "<p>Every picture was just drawn on this machine, by the code of its chapter and of the "
           "chapters before it.</p>\n<nav>";
    for (const Exhibit& exhibit : exhibits)
        out << link('#' + exhibit.chapter.name, escape_html(title_of(exhibit.chapter)));
    if (with_book) out << link("book/index.html", "The texts, as a book");
    out << "</nav>\n</header>\n<main>\n";
    for (const Exhibit& exhibit : exhibits)
        add_exhibit(out, exhibit, &exhibit == &exhibits.front());
    out << "</main>\n<footer><p>Made by <code>./course demo</code>.</p></footer>\n</html>\n";
    return out.str();
}

}  // namespace companion
