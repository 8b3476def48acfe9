#include <companion/pages/study_comparison.hpp>
#include <limits>

#include "catch.hpp"

using companion::Measurement;
using companion::study_comparison;

namespace {

Measurement row(const char* variant, double x, double error, double cost,
                const char* precision = "double") {
    return {{"Lengths", variant, x, "length", error, "error / ulp", cost, "time / ns"}, precision};
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
    CHECK(has(text, "Lengths, a, double\n    worst error / ulp: yours 1e+07, the solution's 2\n"));
    CHECK(has(text, "    median time / ns: yours 20, the solution's 20\n"));
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
              "yours inf, the solution's 1"));
}
