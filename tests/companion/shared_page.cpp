#include <companion/pages/shared_page.hpp>
#include <companion/system/date.hpp>
#include <companion/system/files.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

constexpr std::int64_t day = 86400, some_noon = 1'900'000'000;

SharedPage page_of(int done) {
    SharedPage page;
    page.date = "2030-01-31";
    page.chapters = {{{.name = "01_vectors", .title = "Vectors & more"}, done, 8, 6, 2}};
    return page;
}

const Certificate passed{"2030-01-02", "a machine",
                         "g++",        read_measurements("holds\t01.2\tdot <a, b>\t1\tat most 2\n"),
                         {},           {}};

}  // namespace

TEST_CASE("the page to share says how far its author is", "[shared_page]") {
    const std::string html = shared_page_html(page_of(3));
    CHECK(holds(html, "<title>A ray tracer, by hand</title>"));
    CHECK(holds(html, "so far, 3 of 8 exercises pass."));
    CHECK(holds(html, "<th scope=\"row\">01 Vectors &amp; more<td>3 of 8"));
    CHECK(holds(html, "<td>4 of 6<td>"));
    CHECK(holds(html, "no picture of the final scene yet"));
    for (const char* const unknown : {"How long", "certificate", "final test", "verdict", "<img"}) {
        INFO(unknown);
        CHECK_FALSE(holds(html, unknown));
    }
}

TEST_CASE("the page to share is one file", "[shared_page]") {
    SharedPage page = page_of(8);
    page.certificate = passed;
    for (const auto& [bytes, text] :
         {std::pair{"M", "TQ=="}, {"Ma", "TWE="}, {"Man", "TWFu"}, {"\xff\xfe\xfd!", "//79IQ=="}}) {
        page.picture = bytes;
        CHECK(holds(shared_page_html(page),
                    "src=\"data:image/png;base64," + std::string{text} + '"'));
    }
    page.scene = "Glass \"balls\"";
    page.caption = "Drawn by <me>.";
    const std::string html = shared_page_html(page);
    CHECK(holds(html, "alt=\"Glass &quot;balls&quot;\""));
    CHECK(holds(html, "<figcaption>Drawn by &lt;me&gt;.</figcaption>"));
    for (const char* const other : {"http:", "https:", "href=", "<script", "url("})
        CHECK_FALSE(holds(html, other));
}

TEST_CASE("the page to share has the figures of a certificate that is passed", "[shared_page]") {
    SharedPage page = page_of(8);
    page.certificate = passed;
    page.certificate->measurements.push_back({Held::holds, "", "stars of 01", "6 of 6", "all"});
    const std::string html = shared_page_html(page);
    CHECK(holds(html, "<b>Grade: core and stars.</b>"));
    CHECK(holds(html, "grade of the certificate</dt><dd>core and stars"));
    CHECK(holds(html, "a machine, g++"));
    CHECK(holds(html, "<td>dot &lt;a, b&gt;"));
    CHECK_FALSE(holds(html, "stars of 01"));
    page.certificate->measurements[0].held = Held::fails;
    const std::string failed = shared_page_html(page);
    CHECK(holds(failed, "The final test has not been passed yet."));
    CHECK_FALSE(holds(failed, "Grade"));
    CHECK_FALSE(holds(failed, "a machine"));
}

TEST_CASE("the page to share says how long it took if that is known", "[shared_page]") {
    CHECK(days_between(some_noon, some_noon) == 1);
    CHECK(days_between(some_noon, some_noon + 200 * day) == 201);
    const TimeTaken time =
        time_taken({some_noon + 2 * day, 0, some_noon, some_noon + 60, some_noon + 49 * day});
    CHECK(time.first == some_noon);
    CHECK(time.last == some_noon + 49 * day);
    CHECK(time.days == 3);
    CHECK(time.unknown == 0);

    SharedPage page = page_of(4);
    page.time = time;
    std::string html = shared_page_html(page);
    CHECK(holds(html, "<h2>How long it has taken so far</h2>"));
    CHECK(holds(html, "The first check passed on " + date_of(some_noon) + ", the last on " +
                          date_of(some_noon + 49 * day) +
                          ": 50 days. Something new passed on 3 of them."));
    page.time = time_taken({some_noon});
    CHECK(holds(shared_page_html(page), "on one day, " + date_of(some_noon)));
    page.time = time_taken({some_noon, unknown_time});
    html = shared_page_html(page);
    CHECK(holds(html, "there is no record of when 1 answer first passed."));
    CHECK_FALSE(holds(html, date_of(some_noon)));
}

TEST_CASE("the page takes the newest picture, and says whose code drew it", "[shared_page]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder / "build"};
    write_file(folder / "course.json", R"({"chapters": [{"name": "01_tiny", "core": true,
        "uses_real": true, "title": "Tiny", "reading": 30, "text": "docs/01-tiny.md",
        "hints": "docs/hints/01-tiny.md", "caption": "A ball.", "exercises": [
        {"id": "01.1", "title": "One", "minutes": 10, "files": ["rt/one.hpp"]},
        {"id": "01.2", "title": "Two", "minutes": 10, "files": ["rt/two.hpp"]}]}]})");
    for (const char* const name : {"one", "two"})
        write_file(folder / (std::string{"exercises/01_tiny/rt/"} + name + ".hpp"), "right\n");

    CHECK(collect_shared_page(course).picture.empty());
    write_file(folder / "out/01_tiny_mine.png", "mine");
    CHECK(collect_shared_page(course).picture.empty());  // there is no record of it
    change_state(course, [](State& state) { state.drawn = {hash_of("mine"), {"01.1"}}; });
    SharedPage page = collect_shared_page(course);
    CHECK(page.picture == "mine");
    CHECK(page.scene == "A ball.");
    CHECK(page.caption == "Drawn by its author's code for 01.1, and by the course's for 01.2.");

    write_file(folder / "out/certificate/01_tiny.png", "certified");
    fs::last_write_time(
        folder / "out/certificate/01_tiny.png",
        fs::last_write_time(folder / "out/01_tiny_mine.png") + std::chrono::seconds{5});
    page = collect_shared_page(course);
    CHECK(page.picture == "certified");
    CHECK(page.caption == "Drawn by its author's code.");
    fs::last_write_time(
        folder / "out/01_tiny_mine.png",
        fs::last_write_time(folder / "out/01_tiny_mine.png") + std::chrono::seconds{9});
    CHECK(collect_shared_page(course).picture == "mine");
}
