#include <cmath>
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

}  // namespace

TEST_CASE("an axis is logarithmic where values span much", "[plot]") {
    const auto has = [](const std::vector<double>& xs, const std::string& setting) {
        const std::vector<double> errors(xs.size(), 1);
        return companion::plot_script(rows(xs, errors), "plot.svg").find(setting) !=
               std::string::npos;
    };
    CHECK(has({1, 2, 10}, "unset logscale x"));
    CHECK(has({1, 2, 1000}, "\nset logscale x"));
    CHECK(has({1, 2, 20}, ",2,5,20,50,"));
    CHECK(has({1e-30, 1e-20, 1}, "\"10^{%T}\""));
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

TEST_CASE("a study that timed nothing is drawn as bars", "[plot]") {
    auto all = rows({1}, {1e-9});
    all.front().error = 0.5;
    for (Measurement& row : all) row.cost_name = "";
    const std::string script = companion::plot_script(all, "plot.svg");
    CHECK(script.find("with boxxyerror") != std::string::npos);
    CHECK(script.find("\nset logscale x") != std::string::npos);
    // The longest bar comes last, which is on top.
    CHECK(script.find("\"a_b^{c}\" 2") != std::string::npos);
}

TEST_CASE("gnuplot draws every kind of study, whatever its names hold", "[plot]") {
    if (!companion::is_installed("gnuplot")) return;
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
    const auto draw = [](const std::vector<Measurement>& all) {
        const TemporaryFolder folder;
        write_file(folder / "script", companion::plot_script(all, "plot.svg"));
        const auto result =
            companion::run_process({.command = {"gnuplot", "script"}, .folder = folder.path()});
        INFO(result.output);
        CHECK(result.ok());
        CHECK(result.output.empty());
        const std::string svg = read_file(folder / "plot.svg");
        CHECK(svg.find("</svg>") != std::string::npos);
        CHECK(svg.find("a_b^{c}") != std::string::npos);
        CHECK(folder.count() == 2);
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
    CHECK(plot(errors, {2, 2, 2}).find("layout 1,1 ") != std::string::npos);
    CHECK(plot(errors, {2, 3, 2}).find("layout 1,2 ") != std::string::npos);
}

TEST_CASE("points that lie together all have a name and a size of their own", "[plot]") {
    std::vector<Measurement> all;
    for (const std::string variant : {"one", "two", "three", "four", "five", "six", "seven"})
        all.push_back({{"Study", variant, 1, "x", 5, "error / ulp", 3, "time / ns"}, "double"});
    const std::string script = companion::plot_script(all, "plot.svg");
    std::set<std::string> sizes;
    for (const Measurement& row : all) {
        const auto title = script.find(" title \"" + row.variant + '"');
        REQUIRE(title != std::string::npos);
        const auto size = script.rfind(" ps ", title);
        sizes.insert(script.substr(size, script.find(" dt", size) - size));
    }
    CHECK(sizes.size() == all.size());
}
