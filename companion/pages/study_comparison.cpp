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

// What was measured of a variant in one precision, on both codes.
struct Both {
    double my_error = 0, error = 0;  // the worst
    std::vector<double> my_costs, costs;
    std::string error_name, cost_name;
};

using Key = std::tuple<std::string, std::string, std::string>;  // study, variant, precision

bool differs(double a, double b, double factor) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return false;
    return !(a <= factor * b && b <= factor * a);
}

std::string figures(const std::string& name, double mine, double solution) {
    char text[200];
    std::snprintf(text, sizeof text, "%s %.3g, the solution's %.3g", name.c_str(), mine, solution);
    return text;
}

}  // namespace

std::string study_comparison(const std::vector<Measurement>& mine,
                             const std::vector<Measurement>& solution) {
    std::map<std::pair<Key, double>, const Measurement*> known;
    const auto key_of = [](const Measurement& row) {
        return Key{row.study, row.variant, row.precision};
    };
    for (const Measurement& row : solution) known[{key_of(row), row.x}] = &row;
    std::map<Key, Both> all;
    for (const Measurement& row : mine) {
        const auto found = known.find({key_of(row), row.x});
        if (found == known.end()) continue;
        const Measurement& other = *found->second;
        Both& both = all[key_of(row)];
        both.my_error = std::max(both.my_error, row.error);
        both.error = std::max(both.error, other.error);
        both.my_costs.push_back(row.cost);
        both.costs.push_back(other.cost);
        both.error_name = row.error_name;
        both.cost_name = row.cost_name;
    }
    std::string text;
    for (const auto& [key, both] : all) {
        const double my_cost = study::median(both.my_costs), cost = study::median(both.costs);
        const bool error_differs =
            !both.error_name.empty() && differs(both.my_error, both.error, 1.1);
        if (!error_differs && !differs(my_cost, cost, 1.5)) continue;
        const auto& [study, variant, precision] = key;
        text += "  " + study + ", " + variant + ", " + precision + "\n";
        if (!both.error_name.empty())
            text += "    worst " + figures(both.error_name + ": yours", both.my_error, both.error) +
                    '\n';
        text += "    median " + figures(both.cost_name + ": yours", my_cost, cost) + '\n';
    }
    return text.empty() ? "Yours is as accurate and as fast as the solution's.\n"
                        : "Where yours differs from the solution's:\n" + text;
}

}  // namespace companion
