// shared_page_samples FOLDER: writes the page of `./course book --mine` for somebody who has
// finished, mine.html, and for somebody who has begun, mine-begun.html. book/test.mjs tries them in
// a browser.

#include <app/files.hpp>
#include <companion/pages/shared_page.hpp>
#include <companion/system/files.hpp>

int main(int, char** argv) {
    using namespace companion;
    constexpr std::int64_t day = 86400;
    const Course course = this_course();
    SharedPage page;
    page.date = "2030-04-21";
    const std::vector<Chapter> chapters = core_chapters(course);
    for (std::size_t i = 0; i < chapters.size(); ++i)
        page.chapters.push_back({chapters[i], i < 2 ? 5 : 0, 5, i < 2 ? 9 : 0, i < 2 ? 1 : 0});
    app::replace_file(fs::path{argv[1]} / "mine-begun.html", shared_page_html(page));

    for (std::size_t i = 0; i < chapters.size(); ++i)
        page.chapters[i] = {chapters[i], 5, 5, 9, i == 6, (21'900 + 5 * static_cast<int>(i)) * day};
    page.picture = read_file(course.root / "docs/images/08-scene-cover.png");
    page.scene = chapters.back().caption;
    page.caption = "Drawn by its author's code.";
    page.own = {"", "", 43, 43, 22'000 * day};
    page.time = {21'900 * day, 22'000 * day, 31, 0};
    page.certificate =
        Certificate{"2030-04-20", "Some Processor 9000, 8 cores, Linux", "g++ 12.2.0", {}, {}, {}};
    page.certificate->measurements = read_measurements(
        "holds\t01.4\tlength, largest error\t1.5 epsilon\tat most 2 epsilon\n"
        "FAILS\t05.3*\trefraction at grazing angles, largest error\t40 epsilon\tat most 16 "
        "epsilon\n"
        "holds\t06.3\tspeed of 8 threads against 1\t7.6\tat least 5.6\n"
        "shows\t07.5\ta ray among 100,000 spheres\t612 ns\t\n"
        "holds\t09\ta ray tracer from an empty folder, judged\tyour own ray tracer passes\tevery "
        "line passes\n");
    app::replace_file(fs::path{argv[1]} / "mine.html", shared_page_html(page));
}
