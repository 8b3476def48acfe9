#include <algorithm>
#include <cmath>
#include <companion/follow/trail.hpp>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace companion {

std::string TrailStep::text(const std::string& field) const {
    const auto found = fields.find(field);
    return found == fields.end() ? "" : found->second;
}

std::vector<double> TrailStep::numbers(const std::string& field) const {
    std::istringstream words{text(field)};
    std::vector<double> all;
    // Not `words >> number`, which refuses "nan".
    for (std::string word; words >> word;) all.push_back(std::strtod(word.c_str(), nullptr));
    return all;
}

double TrailStep::number(const std::string& field) const {
    const std::vector<double> all = numbers(field);
    return all.empty() ? std::numeric_limits<double>::quiet_NaN() : all[0];
}

rt::Vec3 TrailStep::vector(const std::string& field) const {
    std::vector<double> all = numbers(field);
    all.resize(3, std::numeric_limits<double>::quiet_NaN());
    return {all[0], all[1], all[2]};
}

Trail read_trail(const std::string& text) {
    Trail trail;
    std::istringstream lines{text};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words{line};
        TrailStep step;
        std::getline(words, step.name, '\t');
        for (std::string field, value;
             std::getline(words, field, '\t') && std::getline(words, value, '\t');)
            step.fields[field] = value;
        trail.push_back(step);
    }
    return trail;
}

bool has_step(const Trail& trail, const std::string& name) {
    return std::any_of(trail.begin(), trail.end(),
                       [&](const TrailStep& step) { return step.name == name; });
}

double dot_of(rt::Vec3 a, rt::Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

double length_of(rt::Vec3 v) {
    return std::sqrt(dot_of(v, v));
}

rt::Vec3 along(rt::Vec3 origin, double t, rt::Vec3 direction) {
    return {origin.x + t * direction.x, origin.y + t * direction.y, origin.z + t * direction.z};
}

}  // namespace companion
