#include <algorithm>
#include <cmath>
#include <companion/check/yours.hpp>
#include <companion/model/progress.hpp>
#include <companion/own/standing.hpp>
#include <companion/pages/html.hpp>
#include <companion/pages/shared_page.hpp>
#include <companion/system/date.hpp>
#include <companion/system/files.hpp>
#include <companion/system/platform.hpp>
#include <ctime>
#include <rt/counted.hpp>
#include <set>
#include <sstream>

namespace companion {
namespace {

constexpr const char* shared_head = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>A ray tracer, by hand</title>
<style>
  @page { margin: 15mm; }
  :root { --page: #f6f5f2; --card: #fff; --ink: #1d1f23; --soft: #5c6068; --line: #e2e0da;
          --bar: #2f7d4f; }
  @media screen and (prefers-color-scheme: dark) {
    :root { --page: #121316; --card: #1b1d21; --ink: #e8e6e1; --soft: #a0a4ab; --line: #2c2f35;
            --bar: #6cc08b; }
  }
  * { box-sizing: border-box; }
  body { margin: 0; background: var(--page); color: var(--ink);
         font: 17px/1.55 system-ui, -apple-system, "Segoe UI", sans-serif; }
  main, footer { max-width: 980px; margin: 0 auto; padding: 0 20px; }
  h1 { font-size: 2.3rem; line-height: 1.15; letter-spacing: -.02em; margin: 48px 0 .3em; }
  h2 { font-size: 1.25rem; line-height: 1.3; margin: 2.2em 0 .6em; }
  p { margin: 0 0 .8em; max-width: 44em; }
  code { font: .9em ui-monospace, "SF Mono", Menlo, Consolas, monospace; }
  figure { margin: 28px 0; break-inside: avoid; }
  img { display: block; width: 100%; height: auto; border-radius: 10px; background: #000; }
  figcaption, .made, footer { color: var(--soft); font-size: .9rem; }
  figcaption { margin-top: 10px; }
  dl { display: grid; grid-template-columns: repeat(auto-fit, minmax(160px, 1fr)); gap: 12px;
       margin: 28px 0; }
  dl > div { display: flex; flex-direction: column-reverse; justify-content: flex-end;
             padding: 14px 18px; background: var(--card); border: 1px solid var(--line);
             border-radius: 10px; break-inside: avoid; }
  dt { color: var(--soft); font-size: .9rem; line-height: 1.35; }
  dd { margin: 0; font-size: 1.55rem; line-height: 1.3; letter-spacing: -.01em; }
  .scroll { overflow-x: auto; }
  table { border-collapse: collapse; width: 100%; font-size: .92rem;
          font-variant-numeric: tabular-nums; }
  th, td { padding: 6px 14px 6px 0; text-align: left; vertical-align: top;
           border-bottom: 1px solid var(--line); }
  th { font-weight: normal; }
  tr:first-child th, .shows td, .open td { color: var(--soft); }
  .figure, .chapters td { white-space: nowrap; }
  tr { break-inside: avoid; }
  .bar { display: block; width: 100%; min-width: 70px; height: 4px; margin-top: 5px;
         border-radius: 2px; background: var(--line); print-color-adjust: exact; }
  .bar i { display: block; height: 100%; border-radius: 2px; background: var(--bar);
           print-color-adjust: exact; }
  footer { padding: 28px 20px 48px; }
  @media (max-width: 600px) { h1 { font-size: 1.8rem; margin-top: 28px; } }
  @media print { body { background: none; font-size: 11pt; } h1 { margin-top: 0; } }
</style>
)";

// "12 of 15"
std::string of(int some, int all) {
    return std::to_string(some) + " of " + std::to_string(all);
}

ChapterStanding sum_of(const std::vector<ChapterStanding>& chapters) {
    ChapterStanding sum;
    for (const ChapterStanding& one : chapters) {
        sum.done += one.done;
        sum.exercises += one.exercises;
        sum.stars += one.stars;
        sum.open_stars += one.open_stars;
    }
    return sum;
}

std::string fact(const std::string& what, const std::string& figure) {
    return "<div><dt>" + escape_html(what) + "</dt><dd>" + escape_html(figure) + "</dd></div>\n";
}

std::string facts(const SharedPage& page, const ChapterStanding& all) {
    std::string html = "<dl>\n" + fact("exercises pass", of(all.done, all.exercises));
    // Stars are counted only where the core passes.
    if (all.stars > 0) html += fact("stars: hard cases", of(all.stars - all.open_stars, all.stars));
    if (page.own.lines > 0)
        html += fact("lines of the verdict on a ray tracer from an empty folder",
                     of(page.own.passed, page.own.lines));
    if (page.time.first > 0 && page.time.unknown == 0)
        html += fact("from the first passed check to the last",
                     rt::counted(days_between(page.time.first, page.time.last), "day"));
    if (page.certificate && page.certificate->passed())
        html += fact("grade of the certificate",
                     page.certificate->passed_with_stars() ? "core and stars" : "core");
    return html + "</dl>\n";
}

std::string chapters_table(const std::vector<ChapterStanding>& chapters) {
    std::ostringstream out;
    out << "<h2>Chapter by chapter</h2>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
           "aria-label=\"The chapters\"><table class=\"chapters\">\n"
           "<tr><th scope=\"col\">chapter<th scope=\"col\">exercises<th scope=\"col\">stars"
           "<th scope=\"col\">finished</tr>\n";
    for (const ChapterStanding& one : chapters)
        out << "<tr><th scope=\"row\">" << one.chapter.number() << ' '
            << escape_html(one.chapter.title) << "<td>" << of(one.done, one.exercises)
            << "<span class=\"bar\"><i style=\"width:"
            << 100 * one.done / std::max(1, one.exercises) << "%\"></i></span><td>"
            << (one.stars > 0 ? of(one.stars - one.open_stars, one.stars) : "") << "<td>"
            << (one.finished > 0 ? date_of(one.finished) : "") << "</tr>\n";
    out << "</table></div>\n";
    return out.str();
}

std::string how_long(const TimeTaken& time, bool finished) {
    if (time.first == 0 && time.unknown == 0) return "";
    std::string text =
        std::string{"<h2>How long it "} + (finished ? "took" : "has taken so far") + "</h2>\n<p>";
    if (time.unknown > 0)
        return text + "This is not known: there is no record of when " +
               rt::counted(time.unknown, "answer") + " first passed.</p>\n";
    const std::string first = date_of(time.first), last = date_of(time.last);
    if (first == last) return text + "Everything passed on one day, " + first + ".</p>\n";
    return text + "The first check passed on " + first + ", the last on " + last + ": " +
           rt::counted(days_between(time.first, time.last), "day") + ". Something new passed on " +
           std::to_string(time.days) + " of them.</p>\n";
}

// The certificate's lines about exercises, with their figures. What passes is in the table of
// chapters.
std::string measured(const Certificate& certificate) {
    std::vector<CertifiedFigure> lines = certificate.measurements;
    std::erase_if(lines, [](const CertifiedFigure& one) { return one.exercise.empty(); });
    if (lines.empty()) return "";
    return "<h2>What the certificate measured</h2>\n<p class=\"made\">" +
           escape_html(certificate.date + ", " + certificate.machine + ", " +
                       certificate.compiler) +
           ", -O3</p>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"What was "
           "measured\">" +
           table_html(lines) + "</div>\n";
}

// The pictures of the final scene that `run` and `certify` draw: takes the newer one. What `run`
// drew counts only if it has not been drawn again since in another way, such as in false colors.
void take_picture(const Course& course, const State& state, SharedPage& page) {
    const Chapter last = core_chapters(course).back();
    const fs::path mine = course.out() / (last.name + "_mine.png"),
                   certified = course.out() / "certificate" / last.picture();
    std::error_code none;
    const bool has_mine =
                   fs::is_regular_file(mine, none) && state.drawn.hash == hash_of(read_file(mine)),
               has_certified = fs::is_regular_file(certified, none);
    if (!has_mine && !has_certified) return;
    page.scene = last.caption;
    if (!has_mine || (has_certified && last_written(certified) > last_written(mine))) {
        page.picture = read_file(certified);
        page.caption = Yours{{last.name}, {}, {}}.caption();  // all code that certify runs
        return;
    }
    page.picture = read_file(mine);
    Yours yours;
    for (const Exercise& exercise : exercises(course))
        if (exercise.chapter.name <= last.name)
            (std::count(state.drawn.yours.begin(), state.drawn.yours.end(), exercise.id) > 0
                 ? yours.passing
                 : yours.others)
                .push_back(exercise.id);
    page.caption = yours.caption();
}

}  // namespace

int days_between(std::int64_t first, std::int64_t last) {
    // Compares the days at noon, so that daylight saving time makes no difference.
    const auto noon = [](std::time_t time) {
        std::tm day = *std::localtime(&time);
        day.tm_hour = 12;
        day.tm_min = day.tm_sec = 0;
        day.tm_isdst = -1;
        return static_cast<double>(std::mktime(&day));
    };
    return 1 + static_cast<int>(std::lround((noon(last) - noon(first)) / 86400));
}

TimeTaken time_taken(const std::vector<std::int64_t>& first_passed) {
    TimeTaken taken;
    std::set<std::string> days;
    for (const std::int64_t time : first_passed) {
        if (time == unknown_time) ++taken.unknown;
        if (time <= 0) continue;
        taken.first = taken.first == 0 ? time : std::min(taken.first, time);
        taken.last = std::max(taken.last, time);
        days.insert(date_of(time));
    }
    taken.days = static_cast<int>(days.size());
    return taken;
}

SharedPage collect_shared_page(const Course& course) {
    const State state = read_state(course);
    SharedPage page;
    page.date = date_of(std::time(nullptr));
    std::vector<std::int64_t> times;
    for (const Chapter& chapter : core_chapters(course)) {
        ChapterStanding standing{chapter};
        std::vector<std::int64_t> of_chapter;
        for (const Exercise& exercise : exercises(course, chapter)) {
            ++standing.exercises;
            if (!passes(progress_of(course, state, exercise))) continue;
            const Record& record = state.exercises.at(exercise.id);
            ++standing.done;
            standing.stars += record.stars;
            standing.open_stars += record.open_stars;
            of_chapter.push_back(record.first_passed);
        }
        const TimeTaken time = time_taken(of_chapter);
        if (standing.done == standing.exercises && time.unknown == 0) standing.finished = time.last;
        times.insert(times.end(), of_chapter.begin(), of_chapter.end());
        page.chapters.push_back(standing);
    }
    if (own_passes(state.own)) times.push_back(state.own.first_passed);
    // A verdict on an older version of the program does not count.
    if (state.own.hash == hash_of_own(state.own.folder)) page.own = state.own;
    page.time = time_taken(times);
    if (fs::is_regular_file(certificate_file(course)))
        page.certificate = read_certificate(read_file(certificate_file(course)));
    take_picture(course, state, page);
    return page;
}

std::string shared_page_html(const SharedPage& page) {
    const ChapterStanding all = sum_of(page.chapters);
    const bool certified = page.certificate && page.certificate->passed();
    std::ostringstream out;
    out << shared_head << "<main>\n<h1>"
        << (certified ? "A ray tracer, by hand" : "A ray tracer, by hand, in the making")
        << "</h1>\n<p>";
    if (certified)
        out << grade_html(*page.certificate);
    else
        out << "Its author is writing it from first principles, in C++: so far, "
            << of(all.done, all.exercises) << " exercises pass."
            << (page.certificate ? " The final test has not been passed yet." : "");
    out << "</p>\n";
    if (page.picture.empty())
        out << "<p class=\"made\">There is no picture of the final scene yet.</p>\n";
    else
        out << "<figure><img alt=\"" << escape_html(page.scene) << "\" src=\"data:image/png;base64,"
            << base64(page.picture) << "\">"
            << (page.caption.empty() ? ""
                                     : "<figcaption>" + escape_html(page.caption) + "</figcaption>")
            << "</figure>\n";
    out << facts(page, all) << chapters_table(page.chapters);
    out << how_long(page.time, certified);
    if (certified) out << measured(*page.certificate);
    out << "</main>\n<footer>" << escape_html(page.date)
        << ", from the course <i>Ray tracing, by hand, in C++</i>.</footer>\n</html>\n";
    return out.str();
}

}  // namespace companion
