#include <cmath>
#include <companion/pages/axis.hpp>
#include <companion/pages/plot.hpp>
#include <companion/system/process.hpp>
#include <limits>
#include <set>

#include "catch.hpp"
#include "temporary_folder.hpp"

using checkpoint::read_file;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;
using companion::Measurement;
using companion::Scale;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Measurement> rows(const std::vector<double>& xs, const std::vector<double>& errors) {
    std::vector<Measurement> all;
    for (const char* const precision : {"double", "float"})
        for (const std::string variant : {"a_b^{c}", "say \"$`x`\\\""})
            for (std::size_t i = 0; i < xs.size(); ++i)
                all.push_back({{"Study 'quoted' \"twice\"", variant, xs[i], "x", errors[i],
                                "error_ulp", 2.0 + static_cast<double>(i), "time / ns"},
                               precision});
    return all;
}

std::string text_of(const std::vector<std::pair<double, std::string>>& marks) {
    std::string all;
    for (const auto& [place, text] : marks) all += text + ' ';
    return all;
}

}  // namespace

TEST_CASE("a scale is logarithmic where values span much", "[plot]") {
    const Scale narrow{{1, 2, 10}}, wide{{1, 1000}};
    CHECK(narrow.place(5) == 5);
    CHECK(wide.place(100) == 2);
    CHECK(text_of(wide.marks()) == "1 2 5 10 20 50 100 200 500 1000 ");
    CHECK(text_of(narrow.marks()) == "0 2 4 6 8 10 ");
    CHECK(text_of(Scale{{1e-30, 1}}.marks()) ==
          "10^{-30} 10^{-25} 10^{-20} 10^{-15} 10^{-10} 10^{-5} 10^{0} ");
    CHECK(text_of(Scale{{1e3, 1e6}}.marks()) == "10^{3} 10^{4} 10^{5} 10^{6} ");
}

TEST_CASE("a scale holds every value, also 0, infinity and what is no number", "[plot]") {
    const double nan = std::nan("");
    for (const std::vector<double>& values : {std::vector<double>{0, 1e-300, 1e300, infinity, nan},
                                              {0, 0, 0},
                                              {1},
                                              {infinity},
                                              {-3, 5, nan},
                                              {-1e200, 1e200},
                                              {5e-324, 1},
                                              {0, 3, 5, infinity},
                                              {7, 7}}) {
        const Scale scale{values};
        REQUIRE(std::isfinite(scale.low()));
        REQUIRE(scale.low() < scale.high());
        for (const double value : values) {
            INFO(value << " lies at " << scale.place(value));
            CHECK(scale.fraction(value) >= 0);
            CHECK(scale.fraction(value) <= 1);
        }
        for (const auto& [place, text] : scale.marks()) {
            INFO("mark " << text << " at " << place);
            CHECK(place >= scale.low());
            CHECK(place <= scale.high());
        }
    }
}

TEST_CASE("an error that was not measured is not drawn", "[plot]") {
    const auto curves = [](const std::vector<Measurement>& all) {
        const std::string script = companion::plot_script(all, "plot.svg");
        int count = 0;
        for (auto at = script.find("<< END"); at != std::string::npos;
             at = script.find("<< END", at + 1))
            ++count;
        return count;
    };
    auto all = rows({1, 2, 3}, {4, 5, 6});  // 2 variants in 2 precisions
    CHECK(curves(all) == 8);
    for (Measurement& row : all)
        if (row.variant == all.front().variant) row.error_name = "";
    CHECK(curves(all) == 6);
    for (Measurement& row : all) row.error_name = "";
    CHECK(curves(all) == 4);
}

TEST_CASE("gnuplot draws every kind of study, whatever its names hold", "[plot]") {
    if (!companion::is_installed("gnuplot")) return;
    const std::vector<std::pair<std::vector<double>, std::vector<double>>> kinds{
        {{1, 10, 1000}, {0, 1e-3, infinity}},
        {{1, 2, 3}, {0, 0, 0}},
        {{0}, {0}},
        {{1, 1e6}, {1, 2}},
        {{-1, 0, 1e-200, 1e200}, {1, 2, 3, 1e300}},
        {{5}, {infinity}}};
    for (const auto& [xs, errors] : kinds) {
        const TemporaryFolder folder;
        write_file(folder / "script", companion::plot_script(rows(xs, errors), "plot.svg"));
        const auto result =
            companion::run_process({.command = {"gnuplot", "script"}, .folder = folder.path()});
        INFO(result.output);
        CHECK(result.ok());
        CHECK(result.output.empty());
        const std::string svg = read_file(folder / "plot.svg");
        CHECK(svg.find("</svg>") != std::string::npos);
        CHECK(svg.find("a_b^{c}") != std::string::npos);
        CHECK(folder.count() == 2);
    }
}

TEST_CASE("a plot leaves out times that do not depend on x", "[plot]") {
    const auto plot = [](const std::vector<double>& errors, const std::vector<double>& costs) {
        std::vector<Measurement> all;
        for (std::size_t i = 0; i < errors.size(); ++i)
            for (const std::string variant : {"level", "measured"})
                all.push_back({{"Study", variant, std::pow(10, i), "x", errors[i], "error / ulp",
                                variant == "level" ? 3 : costs[i], "time / ns"},
                               "double"});
        return companion::plot_script(all, "plot.svg");
    };
    const auto has_times = [](const std::string& script) {
        CHECK(script.find("error / ulp") != std::string::npos);
        return script.find("time / ns") != std::string::npos;
    };
    const std::vector<double> errors{1, 10, 100};
    CHECK_FALSE(has_times(plot(errors, {2, 2, 2})));
    CHECK_FALSE(has_times(plot(errors, {2, 2.4, 2})));  // times wander
    CHECK(has_times(plot(errors, {2, 2.6, 2})));        // one variant is enough
    CHECK(has_times(plot(errors, {2, 2, infinity})));
    CHECK(has_times(plot({1, 1, 1}, {2, 2, 2})));  // nothing depends on x: show all
    CHECK(has_times(plot({1, 10}, {2, 2})));       // error against time
    CHECK(plot(errors, {2, 2, 2}).find("rmargin at screen 0.979") != std::string::npos);
    CHECK(plot(errors, {2, 3, 2}).find("rmargin at screen 0.483") != std::string::npos);
}

TEST_CASE("texts of points that lie together do not lie on each other", "[plot]") {
    std::vector<Measurement> all;
    for (const std::string variant : {"one", "two", "three", "four", "five", "six", "seven"})
        all.push_back({{"Study", variant, 1, "x", 5, "error / ulp", 3, "time / ns"}, "double"});
    all.push_back({{"Study", "far away", 1, "x", 1, "error / ulp", 1, "time / ns"}, "double"});
    const std::string script = companion::plot_script(all, "plot.svg");
    std::set<std::string> places;
    for (const Measurement& row : all) {
        const std::string words = '"' + row.variant + "\" at ";
        const auto at = script.find(words);
        REQUIRE(at != std::string::npos);
        const auto begin = at + words.size();
        places.insert(script.substr(begin, script.find(" noenhanced", begin) - begin));
    }
    CHECK(places.size() == all.size());
    CHECK(script.find("set arrow") != std::string::npos);  // it leads to a text farther off
}
