#include <algorithm>
#include <cmath>
#include <companion/model/course.hpp>
#include <companion/pages/axis.hpp>
#include <companion/pages/plot.hpp>
#include <limits>
#include <regex>
#include <set>

#include "catch.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;
using checkpoint::read_file;
using companion::Axis;
using companion::Measurement;
using companion::Measurements;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Measurements rows(const std::vector<double>& xs, const std::vector<double>& errors) {
    Measurements all;
    for (const char* const precision : {"double", "float"})
        for (const std::string variant : {"a_b^{c}", "say \"$`x`\\\" & <y>"})
            for (std::size_t i = 0; i < xs.size(); ++i)
                all.push_back({{"Study 'quoted' \"twice\"", variant, xs[i], "x", errors[i],
                                "error_ulp", 2.0 + static_cast<double>(i), "time / ns"},
                               precision});
    return all;
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

std::vector<std::string> names(const std::vector<Axis::Mark>& marks) {
    std::vector<std::string> all;
    for (const Axis::Mark& mark : marks) all.push_back(mark.name);
    return all;
}

}  // namespace

TEST_CASE("a value is shown as a person writes it", "[plot]") {
    using companion::shown;
    CHECK(shown(0.0211323) == "0.0211");
    CHECK(shown(0.0002) == "0.0002");
    CHECK(shown(7.2577e-12) == "7.26·10⁻¹²");
    CHECK(shown(1e7) == "10⁷");
    CHECK(shown(19619.9) == "19,620");
    CHECK(shown(-0.5) == "−0.5");
    CHECK(shown(0) == "0");
    CHECK(shown(infinity) == "∞");
    CHECK(shown(std::nan("")) == "not a number");
}

TEST_CASE("an axis is logarithmic where values span much", "[plot]") {
    const auto middle = [](const std::vector<double>& errors) {  // between the least and the most
        const Axis axis{rows(std::vector<double>(errors.size(), 1), errors), &study::Row::error, 0,
                        100};
        return (axis.at(errors[1]) - axis.at(errors[0])) /
               (axis.at(errors.back()) - axis.at(errors[0]));
    };
    CHECK(middle({1, 4, 15}) == Approx(3.0 / 14));
    CHECK(middle({1, 4, 64}) == Approx(1.0 / 3));
    CHECK(middle({-1, 0, 64}) == Approx(1.0 / 65));
}

TEST_CASE("zero and infinity have places of their own", "[plot]") {
    const Axis axis{rows({1, 2, 3, 4}, {0, 1e-9, 1, infinity}), &study::Row::error, 300, 0};
    CHECK(axis.at(0) < 300);
    CHECK(axis.at(0) > axis.at(1e-9) + 20);
    CHECK(axis.at(1) > axis.at(infinity) + 20);
    CHECK(axis.at(std::nan("")) == axis.at(infinity));
    CHECK(axis.at(infinity) > 0);
    const auto marks = axis.marks();
    CHECK(names(marks) == std::vector<std::string>{"10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "1", "0", "∞"});
    for (const Axis::Mark& mark : marks)
        CHECK(mark.is_apart == (mark.name == "0" || mark.name == "∞"));
}

TEST_CASE("an axis names the values that x takes, as far as there is room", "[plot]") {
    const auto marks = [](const std::vector<double>& xs, double length) {
        const std::vector<double> errors(xs.size(), 1);
        return names(Axis{rows(xs, errors), &study::Row::x, 0, length}.marks());
    };
    CHECK(marks({1, 4, 16, 64}, 300) == std::vector<std::string>{"1", "4", "16", "64"});
    CHECK(marks({1, 4, 16, 64}, 90) == std::vector<std::string>{"1", "10"});
    CHECK(marks({3, 5, 8, 9}, 90) == std::vector<std::string>{"4", "6", "8"});
}

TEST_CASE("an error that was not measured is not drawn", "[plot]") {
    const auto curves = [](const Measurements& all) {
        return count(companion::plot_svg(all), "<path class='line'") - 2;  // without the key
    };
    auto all = rows({1, 2, 3}, {4, 5, 6});  // 2 variants in 2 precisions, in 2 panels
    CHECK(curves(all) == 8);
    for (Measurement& row : all)
        if (row.variant == all.front().variant) row.error_name = "";
    CHECK(curves(all) == 6);
    for (Measurement& row : all) row.error_name = "";
    CHECK(curves(all) == 4);
}

TEST_CASE("double is solid, float is dashed, and a dot says its values", "[plot]") {
    const std::string svg = companion::plot_svg(rows({1, 2, 3}, {4, 0.5, 600}));
    CHECK(svg.find("<g class='c0 double'>") != std::string::npos);
    CHECK(svg.find("<g class='c1 float'>") != std::string::npos);
    CHECK(svg.find(".float .line{stroke-dasharray") != std::string::npos);
    CHECK(svg.find("<title>a_b^{c}, double: 600 at 3</title>") != std::string::npos);
    CHECK(svg.find("<title>a_b^{c}, float: 4 ns at 3</title>") != std::string::npos);
}

TEST_CASE("an axis says that it is logarithmic", "[plot]") {
    CHECK(count(companion::plot_svg(rows({1, 2, 3}, {4, 5, 6})), ", logarithmic<") == 0);
    CHECK(count(companion::plot_svg(rows({1, 2, 300}, {4, 5, 6})), ">x, logarithmic<") > 0);
    CHECK(count(companion::plot_svg(rows({1, 2, 3}, {4, 0.5, 600})), ">error_ulp, logarithmic<") ==
          1);
}

TEST_CASE("a viewer that knows no variables finds a plain color before each", "[plot]") {
    const std::string svg = companion::plot_svg(rows({1, 2, 3}, {4, 0.5, 600}));
    const std::regex both{"(fill|stroke):(#[0-9a-f]+);\\1:var\\((--[a-z0-9]+)\\)"};
    int colors = 0;
    for (std::sregex_iterator it{svg.begin(), svg.end(), both}, end; it != end; ++it, ++colors) {
        CAPTURE(it->str());
        CHECK(svg.find((*it)[3].str() + ':' + (*it)[2].str()) != std::string::npos);
    }
    CHECK(colors > 0);
    CHECK(colors == count(svg, "var("));
}

TEST_CASE(
    "a single error or time of each variant is drawn as a bar, or as a dot on a logarithmic axis, "
    "and more over x",
    "[plot]") {
    auto all = rows({1}, {1e-9});
    all.back().error = 0.5;
    for (Measurement& row : all) row.cost_name = "";
    const std::string svg =
        companion::plot_svg(all);           // the dots of double and float differ in shape
    CHECK(count(svg, "<circle") == 2 + 1);  // and in the key
    CHECK(count(svg, "class='value c0'") == 2);
    CHECK(count(svg, "class='value c1'") == 2);
    CHECK(count(svg, "class='bar ") == 0);
    CHECK(svg.find("10⁻⁸") != std::string::npos);
    // The largest value comes first, which is on top.
    CHECK(svg.find("say &quot;") < svg.find("a_b^{c}"));

    auto times = rows({1}, {0});
    for (Measurement& row : times) row.error_name = "";
    CHECK(count(companion::plot_svg(times), "class='bar ") == 4);

    auto many = rows({1, 10}, {1e-9, 0.5});
    for (Measurement& row : many) row.cost_name = "";
    const std::string lines = companion::plot_svg(many);
    CHECK(count(lines, "class='bar ") == 0);
    CHECK(count(lines, "class='line'") >= 4);
}

TEST_CASE("every kind of study is drawn, whatever its names hold", "[plot]") {
    const double nan = std::nan("");
    const std::vector<std::pair<std::vector<double>, std::vector<double>>> kinds{
        {{1, 10, 1000}, {0, 1e-3, infinity}},
        {{1, 2, 3}, {0, 0, 0}},
        {{0}, {0}},
        {{1, 1e6}, {1, 2}},
        {{-1, 0, 1e-200, 1e200}, {1, 2, 3, 1e300}},
        {{5}, {infinity}},
        {{1, 2, 3, 4, 5}, {0, 1e-300, 1e300, infinity, nan}},
        {{1, 2, 3}, {infinity, nan, infinity}},
        {{-3, 5, nan}, {-1e200, 0, 1e200}},
        {{5e-324, 1, 2}, {0, 5, infinity}},
        {{7, 7}, {7, 7}}};
    const auto draw = [](const Measurements& all) {
        const std::string svg = companion::plot_svg(all);
        CHECK(svg.find("say &quot;$`x`\\&quot; &amp; &lt;y&gt;") != std::string::npos);
        CHECK(svg.find("a_b^{c}") != std::string::npos);
        for (const std::string part : {"svg", "g", "text", "title", "style"})
            CHECK(count(svg, '<' + part + '>') + count(svg, '<' + part + ' ') ==
                  count(svg, "</" + part + '>'));
        const std::regex number{" (d|x|y|cx|cy|r|width|height)='([^']*)'"};
        for (std::sregex_iterator it{svg.begin(), svg.end(), number}, end; it != end; ++it) {
            INFO(it->str());
            CHECK(it->str(2).find_first_not_of("0123456789.- MVHhz") == std::string::npos);
        }
    };
    for (const auto& [xs, errors] : kinds) {
        auto all = rows(xs, errors);
        draw(all);
        for (Measurement& row : all) row.cost_name = "";
        draw(all);
    }
}

TEST_CASE("a plot leaves out times that do not depend on x", "[plot]") {
    const auto plot = [](const std::vector<double>& errors, const std::vector<double>& costs) {
        Measurements all;
        for (std::size_t i = 0; i < errors.size(); ++i)
            for (const std::string variant : {"level", "measured"})
                all.push_back({{"Study", variant, std::pow(10, i), "x", errors[i], "error / ulp",
                                variant == "level" ? 3 : costs[i], "time / ns"},
                               "double"});
        return companion::plot_svg(all);
    };
    const auto has_times = [](const std::string& svg) {
        CHECK(svg.find(">error, in ulp") != std::string::npos);
        return svg.find(">time, in ns<") != std::string::npos;
    };
    const std::vector<double> errors{1, 10, 100};
    CHECK_FALSE(has_times(plot(errors, {2, 2, 2})));
    CHECK_FALSE(has_times(plot(errors, {2, 2.4, 2})));  // times wander
    CHECK(has_times(plot(errors, {2, 2.6, 2})));        // one variant is enough
    CHECK(has_times(plot(errors, {2, 2, infinity})));
    CHECK(has_times(plot({1, 1, 1}, {2, 2, 2})));  // nothing depends on x: show all
    CHECK(has_times(plot({1, 10}, {2, 2})));       // error against time
}

TEST_CASE("points that lie together have a size or a look of their own", "[plot]") {
    const auto looks = [](const std::vector<std::string>& variants) {
        Measurements all;
        for (const std::string& variant : variants)
            all.push_back({{"Study", variant, 1, "x", 5, "error / ulp", 3, "time / ns"}, "double"});
        const std::string svg = companion::plot_svg(all);
        std::vector<std::string> found;
        for (const std::string& variant : variants) {
            const auto end = svg.find("<title>" + variant + ", x 1, double: 5 ulp at 3 ns");
            REQUIRE(end != std::string::npos);
            const auto begin = svg.rfind("<g ", end);
            found.push_back(svg.substr(begin, end - begin));
        }
        CHECK(std::set<std::string>(found.begin(), found.end()).size() == found.size());
        return found;
    };
    looks({"one", "two", "three", "four", "five", "six", "seven"});
    looks({"1", "2", "3 a", "3 b", "3 c", "3 d", "3 e", "4", "5", "6", "7", "8", "9", "10"});
    // If there are more names than colors, those that begin alike share one.
    const auto many = looks({"one", "two", "two, too", "two by two", "3", "4", "5", "6", "7", "8"});
    const auto color = [&](std::size_t i) { return many[i].substr(0, 12); };
    CHECK(color(1) == color(2));
    CHECK(color(1) == color(3));
    CHECK(color(0) != color(1));
}

TEST_CASE("the frontier leaves out what another row beats, and gains of less than 3 %", "[plot]") {
    const auto row = [](const std::string& variant, double error, double cost) {
        return Measurement{{"scene", variant, 4, "n", error, "error", cost, "time / ms"}, "float"};
    };
    const std::string svg = companion::trade_svg(
        {{row("best", 1, 9), row("cheap", 3, 1), row("beaten", 3, 2), row("by chance", 2.95, 3)}},
        {"best", "cheap"});
    CHECK(svg.find("<title>frontier:\ncheap, n 4, float\nbest, n 4, float</title>") !=
          std::string::npos);
    CHECK(svg.find("<title>beaten, n 4, float: 3 at 2 ms</title>") != std::string::npos);
    CHECK(count(svg, "class='frontier'") == 2);  // in the picture, and in the key
    CHECK(count(svg, ">best</text>") == 1);      // has a color and a name at its line
    CHECK(count(svg, ">beaten</text>") == 0);    // is one of the gray dots
}

TEST_CASE("a quantity that is 0 everywhere has a line of words, and no axes", "[plot]") {
    const std::string words = ">error_ulp: 0 everywhere<", axis = ">error_ulp<";
    const std::string none = companion::plot_svg(rows({1, 2, 3}, {0, 0, 0})),
                      one = companion::plot_svg(rows({1, 2, 3}, {0, 0, 1}));
    CHECK(count(none, words) == 1);
    CHECK(count(none, axis) == 0);
    CHECK(count(one, words) == 0);
    CHECK(count(one, axis) == 1);
}

TEST_CASE("a caption's claim is the title, and its words name the axes", "[plot]") {
    companion::Caption caption;
    const auto all = rows({1, 2, 3}, {4, 5, 6});
    const std::string plain = companion::plot_svg(all, caption);
    CHECK(count(plain, "class='head'>Study 'quoted' &quot;twice&quot;<") == 1);
    CHECK(count(plain, ">time, in ns<") == 1);  // by itself
    caption.claim =
        "Nothing & nobody is ever wrong, whatever else the learners of this course may say";
    caption.axes = {{"error_ulp", "error, in rounding steps"}, {"x", "size"}};
    const std::string svg = companion::plot_svg(all, caption);
    CHECK(count(svg, "aria-label=\"Nothing &amp; nobody is ever wrong") == 1);
    CHECK(count(svg, "data-study=\"Study 'quoted' &quot;twice&quot;\"") == 1);
    CHECK(count(svg, "class='head'>") == 2);  // too long for one line
    CHECK(count(svg, ">error, in rounding steps<") == 1);
    CHECK(count(svg, ">size<") == 2);
}

TEST_CASE("names have powers as in a book", "[plot]") {
    auto all = rows({1, 2, 3}, {4, 5, 6});
    for (Measurement& row : all)
        if (row.variant == "a_b^{c}") row.variant = "10^12 away, sin^2";
    CHECK(count(companion::plot_svg(all), ">10¹² away, sin²<") == 2);
}

TEST_CASE("a caption chooses what a plot shows", "[plot]") {
    companion::Caption caption;
    const auto has = [&](const Measurements& all, const std::string& words) {
        return count(companion::plot_svg(all, caption), '>' + words + '<');
    };
    const auto all = rows({1, 2, 3}, {4, 5, 6}), single = rows({1}, {4});
    CHECK(has(all, "error_ulp") + has(all, "time, in ns") + has(all, "x") == 4);
    caption.shows = "cost";
    CHECK(has(all, "error_ulp") == 0);
    CHECK(has(all, "time, in ns") == 1);
    CHECK(count(companion::plot_svg(single, caption), "class='bar ") == 4);
    caption.shows = "error over cost";
    CHECK(has(all, "error_ulp") == 1);
    CHECK(has(all, "time, in ns") == 1);
    CHECK(has(all, "x") == 0);
}

TEST_CASE("names stand at the ends of lines and do not lie on each other", "[plot]") {
    Measurements all;
    for (const std::string variant : {"one", "two", "three", "four of a name that takes two lines"})
        for (const double x : {1., 2., 3.})
            all.push_back({{"Study", variant, x, "x", 5 + x / 100, "error", 0, ""}, "double"});
    const std::string svg = companion::plot_svg(all);
    std::vector<double> places;
    const std::regex name{
        " y='([0-9.]+)' class='name'>(one|two|three|four of a name|that takes two|lines)<"};
    for (std::sregex_iterator it{svg.begin(), svg.end(), name}, end; it != end; ++it)
        places.push_back(std::stod(it->str(1)));
    std::sort(places.begin(), places.end());
    REQUIRE(places.size() >= 5);
    for (std::size_t i = 1; i < places.size(); ++i) CHECK(places[i] - places[i - 1] > 13);
}

TEST_CASE("what x stands for may have names: bars in pairs, or a row of dots", "[plot]") {
    Measurements few, many;
    for (const std::string variant : {"alone", "together"})
        for (int k = 1; k <= 4; ++k)
            few.push_back({{"Study", variant, double(k), "1 boxes, 2 leaves, 3 sort, 4 the rest", 0,
                            "", 10.0 * k, "time / ns"},
                           "double"});
    const std::string bars = companion::plot_svg(few);
    CHECK(count(bars, "class='bar ") == 8);
    CHECK(count(bars, "<title>leaves, together: 20</title>") == 1);
    CHECK(count(bars, "logarithmic") == 0);
    for (const std::string variant : {"glass", "fog", "lens", "haze"})
        for (int k = 0; k < 3; ++k)
            many.push_back({{"Study", variant, double(k), "absent, compiled in, present",
                             1 + 0.1 * k, "times", 0, ""},
                            "double"});
    const std::string dots = companion::plot_svg(many);
    CHECK(count(dots, "<title>fog, compiled in: 1.1</title>") == 1);
    CHECK(count(dots, ">absent<") == 1);
    CHECK(count(dots, ">0<") == 0);  // dots need no zero
}

TEST_CASE("each study in docs/studies has a claim, and each claim a study", "[plot]") {
    const fs::path docs = companion::this_course().root / "docs";
    const companion::Captions captions = companion::read_captions(docs / "studies/captions.json");
    std::set<std::string> claimed{"accuracy: Error over time"}, studied = claimed, axes, named;
    for (const auto& [table, studies] : captions.studies)
        for (const auto& [study, caption] : studies) {
            claimed.insert(table + ": " + study);
            CHECK(caption.claim.size() > 20);
            CHECK(caption.claim.back() != '.');
        }
    for (const auto& table : fs::directory_iterator(docs / "studies"))
        if (table.path().extension() == ".csv")
            for (const Measurement& row : companion::read_measurements(table.path())) {
                axes.insert({row.x_name, row.error_name, row.cost_name});
                if (table.path().stem() != "accuracy")
                    studied.insert(table.path().stem().string() + ": " + row.study);
            }
    CHECK(claimed == studied);
    for (const auto& [name, words] : captions.axes) {
        INFO(name);
        CHECK(axes.count(name) == 1);
    }
}

TEST_CASE("docs/plots show docs/studies: after a change, ./course study --docs", "[plot]") {
    const fs::path docs = companion::this_course().root / "docs";
    const companion::Captions captions = companion::read_captions(docs / "studies/captions.json");
    std::set<std::string> expected, actual;
    for (const auto& table : fs::directory_iterator(docs / "studies"))
        if (table.path().extension() == ".csv")
            for (const auto& [file, svg] : companion::plots_of(table.path(), captions)) {
                INFO(file);
                expected.insert(file);
                CHECK(
                    (fs::exists(docs / "plots" / file) && read_file(docs / "plots" / file) == svg));
            }
    for (const auto& plot : fs::directory_iterator(docs / "plots"))
        actual.insert(plot.path().filename().string());
    CHECK(actual == expected);
}
