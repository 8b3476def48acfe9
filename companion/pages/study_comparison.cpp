#include <algorithm>
#include <cmath>
#include <companion/pages/study_comparison.hpp>
#include <cstdio>
#include <map>
#include <study/median.hpp>
#include <tuple>
#include <utility>

namespace companion {
namespace {

using Key = std::tuple<std::string, std::string, std::string>;  // study, variant, precision
using Rows = std::map<std::pair<Key, double>, const Measurement*>;

Rows by_key(const std::vector<Measurement>& all) {
    Rows rows;
    for (const Measurement& row : all)
        rows[{Key{row.study, row.variant, row.precision}, row.x}] = &row;
    return rows;
}

// What one run says about a variant in one precision.
struct Figures {
    double worst_error = 0;
    std::vector<double> costs;

    void add(const Measurement& row) {
        worst_error = std::max(worst_error, row.error);
        costs.push_back(row.cost);
    }
};

// The figures of the learner's run, and those of two runs of the solution.
struct Variant {
    Figures mine, solution, again;
    std::string error_name, cost_name;
};

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool differs(double a, double b, double factor) {
    return !same(a, b) && !(a <= factor * b && b <= factor * a);
}

// Whether `mine` differs from both solution runs by more than this factor, multiplied by the ratio
// of those two runs.
bool differs(double mine, double solution, double again, double factor) {
    const double wander =
        same(solution, again) ? 1 : std::max(solution, again) / std::min(solution, again);
    if (!(wander > 0 && std::isfinite(wander))) return false;  // the runs tell nothing
    return differs(mine, solution, factor * wander) && differs(mine, again, factor * wander);
}

// Whether an error fluctuates by itself. A time tells no more than the cost does, and fluctuates
// more; and the name of an error that is a matter of chance says so.
bool wanders(const std::string& error_name) {
    return error_name.find("time") != std::string::npos ||
           error_name.find("by chance") != std::string::npos;
}

std::string line(const std::string& name, double mine, double solution) {
    char text[200];
    std::snprintf(text, sizeof text, "    %-44s %12.3g %12.3g\n", name.c_str(), mine, solution);
    return text;
}

}  // namespace

std::string study_comparison(const std::vector<Measurement>& mine,
                             const std::vector<Measurement>& solution,
                             const std::vector<Measurement>& solution_again) {
    const Rows first = by_key(solution), second = by_key(solution_again);
    std::map<Key, Variant> variants;
    for (const auto& [key, row] : by_key(mine)) {
        const auto one = first.find(key), other = second.find(key);
        if (one == first.end() || other == second.end()) continue;
        Variant& variant = variants[key.first];
        variant.mine.add(*row);
        variant.solution.add(*one->second);
        variant.again.add(*other->second);
        variant.error_name = row->error_name;
        variant.cost_name = row->cost_name;
    }
    std::string text;
    for (const auto& [key, v] : variants) {
        const double my_cost = study::median(v.mine.costs), cost = study::median(v.solution.costs);
        const bool error_differs =
            !v.error_name.empty() && !wanders(v.error_name) &&
            differs(v.mine.worst_error, v.solution.worst_error, v.again.worst_error, 1.1);
        if (!error_differs && !differs(my_cost, cost, study::median(v.again.costs), 1.5)) continue;
        const auto& [study, variant, precision] = key;
        text += "  " + study + ", " + variant + ", " + precision + "\n";
        if (!v.error_name.empty())
            text += line("worst " + v.error_name, v.mine.worst_error, v.solution.worst_error);
        if (!v.cost_name.empty()) text += line("median " + v.cost_name, my_cost, cost);
    }
    if (text.empty()) return "Your code is as accurate and as fast as the solution's.\n";
    char heading[100];
    std::snprintf(heading, sizeof heading, "%-48s %12s %12s\n", "Where your code differs:", "yours",
                  "solution's");
    return heading + text;
}

}  // namespace companion
