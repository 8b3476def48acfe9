#pragma once
// What the light of one sample did, as a program that was compiled with recorder/ wrote it.

#include <map>
#include <rt/vec3_type.hpp>
#include <string>
#include <vector>

namespace companion {

struct TrailStep {
    std::string name;                           // such as "hit"
    std::map<std::string, std::string> fields;  // such as "t": "2.5"

    bool has(const std::string& field) const { return fields.count(field) > 0; }
    std::string text(const std::string& field) const;  // empty if it is missing
    // A field's number, or its three numbers; what is missing is NaN.
    double number(const std::string& field) const;
    rt::Vec3 vector(const std::string& field) const;
    std::vector<double> numbers(const std::string& field) const;
};
using Trail = std::vector<TrailStep>;

Trail read_trail(const std::string& text);

// Whether there is a step of this name.
bool has_step(const Trail& trail, const std::string& name);

// The same vectors that a tracer computes with, and none of its code.
double dot_of(rt::Vec3 a, rt::Vec3 b);
double length_of(rt::Vec3 v);
rt::Vec3 along(rt::Vec3 origin, double t, rt::Vec3 direction);

// The trail in words, in lines that are numbered as the points that the light meets.
std::string in_words(const Trail& trail);

}  // namespace companion
