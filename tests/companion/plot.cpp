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
        return count(companion::plot_svg(all), "<g class=") - 4;  // without the key
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

TEST_CASE("a single error or time of each variant is drawn as a bar, and more over x", "[plot]") {
    auto all = rows({1}, {1e-9});
    all.back().error = 0.5;
    for (Measurement& row : all) row.cost_name = "";
    const std::string svg = companion::plot_svg(all);
    CHECK(count(svg, "class='bar c0'") == 2);
    CHECK(count(svg, "class='bar c1'") == 2);
    CHECK(svg.find("10⁻⁸") != std::string::npos);
    // The longest bar comes first, which is on top.
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
        CHECK(svg.find(">error / ulp<") != std::string::npos);
        return svg.find(">time / ns<") != std::string::npos;
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
        {{row("best", 1, 9), row("cheap", 3, 1), row("beaten", 3, 2), row("by chance", 2.95, 3)}});
    CHECK(svg.find("<title>frontier:\ncheap, n 4, float\nbest, n 4, float</title>") !=
          std::string::npos);
    CHECK(svg.find("<title>beaten, n 4, float: 3 at 2 ms</title>") != std::string::npos);
}

TEST_CASE("docs/plots show docs/studies: after a change, ./course study --docs", "[plot]") {
    const fs::path docs = companion::this_course().root / "docs";
    std::set<std::string> expected, actual;
    for (const auto& table : fs::directory_iterator(docs / "studies"))
        if (table.path().extension() == ".csv")
            for (const auto& [file, svg] : companion::plots_of(table.path())) {
                INFO(file);
                expected.insert(file);
                CHECK(
                    (fs::exists(docs / "plots" / file) && read_file(docs / "plots" / file) == svg));
            }
    for (const auto& plot : fs::directory_iterator(docs / "plots"))
        actual.insert(plot.path().filename().string());
    CHECK(actual == expected);
}
