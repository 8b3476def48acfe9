#include <algorithm>
#include <cmath>
#include <companion/own/handed_over.hpp>
#include <cstdio>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>
#include <vector>

namespace companion {
namespace {

using Numbers = std::vector<double>;

struct Value {
    std::string name, text;
    Numbers numbers{};  // none if the text is a word
};

struct Group {
    std::string name, text{};  // the text holds all values
    std::vector<Value> values{};
    bool is_sphere() const { return name.rfind("sphere ", 0) == 0; }
};

std::vector<Group> groups_of(const std::string& record) {
    std::vector<Group> groups;
    std::map<std::string, std::size_t> places;
    std::istringstream lines{record};
    for (std::string name; std::getline(lines, name, '\t');) {
        Value value;
        std::getline(std::getline(lines, value.name, '\t'), value.text);
        std::istringstream numbers{value.text};
        for (double number = 0; numbers >> number;) value.numbers.push_back(number);
        const auto [known, is_new] = places.try_emplace(name, groups.size());
        if (is_new) groups.push_back({name});
        Group& group = groups[known->second];
        group.text += value.name + '\t' + value.text + '\n';
        group.values.push_back(value);
    }
    return groups;
}

// Whether two lists of numbers are the same, except for the last digits of what a tracer computes.
bool same(const Numbers& a, const Numbers& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        const double larger = std::max(std::abs(x), std::abs(y));
        return x == y || (std::isfinite(larger) && std::abs(x - y) <= 1e-5 * larger);
    });
}

bool same(const Value& a, const Value& b) {
    return a.numbers.empty() ? a.text == b.text : same(a.numbers, b.numbers);
}

const Value* find(const Group& group, const std::string& name) {
    const auto found = std::find_if(group.values.begin(), group.values.end(),
                                    [&](const Value& value) { return value.name == name; });
    return found == group.values.end() ? nullptr : &*found;
}

// "1.5", "(0, 1, 0)", "metal"
std::string shown(const Value& value) {
    if (value.numbers.empty()) return value.text;
    std::string text;
    for (const double number : value.numbers) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.4g", number);
        text += (text.empty() ? "" : ", ") + std::string{digits};
    }
    return value.numbers.size() == 1 ? text : '(' + text + ')';
}

double length(const Numbers& v) {
    return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
}

// How a wrong value comes from the right one: "1 / that"; empty if in none of the usual ways.
std::string relation(const Value& mine, const Value& ours, const Group& right) {
    if (ours.numbers.empty()) return "";
    for (const Value& other : right.values)
        if (other.name != ours.name && same(mine, other) && length(other.numbers) > 0)
            return other.name;
    const struct {
        const char* words;
        double (*of)(double);
    } ways[]{{"1 less", [](double x) { return x - 1; }},
             {"1 more", [](double x) { return x + 1; }},
             {"the opposite", [](double x) { return -x; }},
             {"twice that", [](double x) { return 2 * x; }},
             {"half of that", [](double x) { return x / 2; }},
             {"1 / that", [](double x) { return 1 / x; }},
             {"1 minus that", [](double x) { return 1 - x; }},
             {"in degrees, not in radians", [](double x) { return x * 180 / std::numbers::pi; }},
             {"in radians, not in degrees", [](double x) { return x * std::numbers::pi / 180; }}};
    for (const auto& way : ways) {
        Numbers made = ours.numbers;
        std::transform(made.begin(), made.end(), made.begin(), way.of);
        if (same(mine.numbers, made)) return way.words;
    }
    if (ours.numbers.size() != 3 || mine.numbers.size() != 3) return "";
    const char* const swaps[]{"with x and y swapped", "with y and z swapped",
                              "with z and x swapped"};
    for (std::size_t i = 0; i < 3; ++i) {
        Numbers made = ours.numbers;
        std::swap(made[i], made[(i + 1) % 3]);
        if (same(mine.numbers, made)) return swaps[i];
    }
    const double mine_length = length(mine.numbers), right_length = length(ours.numbers);
    Numbers made = mine.numbers;
    for (double& number : made) number *= right_length / mine_length;
    if (same(made, ours.numbers) && std::abs(right_length - 1) < 1e-6)
        return "of a length that is not 1";
    return "";
}

// One sentence for each value that differs.
std::string differences(const Group& mine, const Group& right) {
    std::string text;
    for (const Value& ours : right.values) {
        const Value* const value = find(mine, ours.name);
        if (!value || same(*value, ours)) continue;
        const std::string way = relation(*value, ours, right);
        text += (text.empty() ? "In your main(), " : " Also, ") + ours.name +
                (right.is_sphere() ? " of " + right.name : "") + " is " + shown(*value) +
                "; it should be " + shown(ours) + (way.empty() ? "" : " (yours is " + way + ")") +
                '.';
    }
    return text;
}

std::vector<Group> spheres_of(const std::vector<Group>& groups) {
    std::vector<Group> spheres;
    std::copy_if(groups.begin(), groups.end(), std::back_inserter(spheres),
                 [](const Group& group) { return group.is_sphere(); });
    return spheres;
}

// The spheres that the other list does not have.
std::vector<Group> others(std::vector<Group> spheres, const std::vector<Group>& list) {
    std::multiset<std::string> known;
    for (const Group& sphere : list) known.insert(sphere.text);
    std::erase_if(spheres, [&](const Group& sphere) {
        const auto found = known.find(sphere.text);
        if (found == known.end()) return false;
        known.erase(found);
        return true;
    });
    return spheres;
}

// How many values two spheres share, from the first, the center, to the first that differs.
long values_shared(const Group& a, const Group& b) {
    const auto is_same = [](const Value& one, const Value& other) { return same(one, other); };
    return std::mismatch(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                         is_same)
               .first -
           a.values.begin();
}

// Spheres that differ are compared with those that are most like them.
std::string differences(const std::vector<Group>& mine, const std::vector<Group>& ours) {
    if (mine.empty() || ours.empty()) return "";
    if (mine.size() != ours.size())
        return "In your main(), the number of spheres is " + std::to_string(mine.size()) +
               "; it should be " + std::to_string(ours.size()) + '.';
    const std::vector<Group> wrong = others(mine, ours);
    for (const Group& right : others(ours, mine)) {
        const auto twin =
            std::max_element(wrong.begin(), wrong.end(), [&](const Group& a, const Group& b) {
                return values_shared(a, right) < values_shared(b, right);
            });
        if (const std::string text = differences(*twin, right); !text.empty()) return text;
    }
    return "";
}

}  // namespace

std::string difference_in_words(const std::string& mine, const std::string& ours) {
    const std::vector<Group> my_groups = groups_of(mine), right = groups_of(ours);
    for (const Group& group : right) {
        if (group.is_sphere()) continue;
        for (const Group& other : my_groups)
            if (other.name == group.name)
                if (const std::string text = differences(other, group); !text.empty()) return text;
    }
    return differences(spheres_of(my_groups), spheres_of(right));
}

bool has_pixels(const std::string& record) {
    return record.find("the pixels\t") != std::string::npos;
}

}  // namespace companion
