#include <companion/pages/study_comparison.hpp>
#include <limits>

#include "catch.hpp"

using companion::Measurement;

namespace {

Measurement row(const char* variant, double x, double error, double cost,
                const char* precision = "double") {
    return {{"Lengths", variant, x, "length", error, "error / ulp", cost, "time / ns"}, precision};
}

// Where the solution's second run is like its first.
std::string study_comparison(const std::vector<Measurement>& mine,
                             const std::vector<Measurement>& solution) {
    return companion::study_comparison(mine, solution, solution);
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a study tells where the learner's code differs", "[study_comparison]") {
    const std::vector<Measurement> solution{row("a", 1, 1, 10), row("a", 2, 2, 20),
                                            row("b", 1, 1, 10), row("c", 1, 1, 10, "float")};
    CHECK(has(study_comparison(solution, solution), "as accurate and as fast"));
    CHECK(has(study_comparison({}, solution), "as accurate and as fast"));

    auto mine = solution;
    mine[1].error = 1e7;
    std::string text = study_comparison(mine, solution);
    const std::string gap(27, ' ');
    CHECK(has(text,
              "Lengths, a, double\n    worst error / ulp " + gap + "       1e+07            2\n"));
    CHECK(has(text, "    median time / ns  " + gap + "          20           20\n"));
    CHECK_FALSE(has(text, "Lengths, b"));

    mine = solution;
    mine[2].cost = 14;  // another program had the machine
    CHECK(has(study_comparison(mine, solution), "as accurate and as fast"));
    mine[2].cost = 16;
    mine[3].error = 0.5;
    text = study_comparison(mine, solution);
    CHECK(has(text, "Lengths, b, double"));
    CHECK(has(text, "Lengths, c, float"));

    mine = solution;
    mine[0].x = 7;  // which was not measured on the solution
    CHECK(has(study_comparison(mine, solution), "as accurate and as fast"));
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(has(study_comparison({row("a", 1, infinity, 10)}, {row("a", 1, infinity, 10)}),
              "as accurate and as fast"));
    CHECK(has(study_comparison({row("a", 1, infinity, 10)}, {row("a", 1, 1, 10)}),
              "inf            1\n"));
}

TEST_CASE("what differs between two runs of the solution is no difference", "[study_comparison]") {
    const auto compared = [](const Measurement& mine, const Measurement& one,
                             const Measurement& again) {
        return companion::study_comparison({mine}, {one}, {again});
    };
    CHECK(has(compared(row("a", 1, 1, 30), row("a", 1, 1, 10), row("a", 1, 1, 25)), "as fast"));
    CHECK(has(compared(row("a", 1, 1, 100), row("a", 1, 1, 10), row("a", 1, 1, 25)), "differs"));
    CHECK(has(compared(row("a", 1, 50, 1), row("a", 1, 0, 1), row("a", 1, 39, 1)), "as fast"));
    auto mine = row("a", 1, 2, 10), solution = row("a", 1, 9, 10);
    for (const char* const name : {"cores' time lost / %", "numbers taken twice by chance / %"}) {
        mine.error_name = solution.error_name = name;
        CHECK(has(compared(mine, solution, solution), "as fast"));
    }
}
