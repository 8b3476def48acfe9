#pragma once
// What a tracer's main() hands over to the course's functions, as text, in the file that the
// variable COURSE_RECORD names. If a graft fails, the companion compiles the learner's tracer and
// our answer with this folder before all others, so that its headers stand in front of those of the
// same names, and compares the two records.
//
// A line is a group, a name and a value, with tabs between: "the lens", "the aperture", "0.5".
// Colors and vectors are three numbers. Each sphere is a group.

#include <cstdlib>
#include <fstream>
#include <mutex>
#include <rt/camera.hpp>
#include <rt/color.hpp>
#include <rt/scene_sphere.hpp>
#include <set>
#include <string>

namespace rt::recorder {

class Record {
  public:
    Record() {
        file_.precision(12);
        if (const char* const name = std::getenv("COURSE_RECORD")) file_.open(name);
    }
    ~Record() {
        if (calls_ == 0) return;
        note("the pixels", "the number of calls of render_pixel", calls_);
        note("the pixels", "the last column", last_column_);
        note("the pixels", "the last row", last_row_);
    }

    // Only the first value of a name counts. It is written at once, because the tracer may crash.
    template <class Value>
    void note(const std::string& group, const std::string& name, const Value& value) {
        const std::lock_guard lock{noting_};
        if (!noted_.insert(group + '\t' + name).second) return;
        file_ << group << '\t' << name << '\t';
        write(value);
        file_ << '\n' << std::flush;
    }

    // True at the first call.
    bool counts_pixel(int column, int row) {
        const std::lock_guard lock{noting_};
        last_column_ = std::max(last_column_, column);
        last_row_ = std::max(last_row_, row);
        return calls_++ == 0;
    }

  private:
    template <class Value>
    void write(const Value& value) {
        file_ << value;
    }
    void write(const Vec3& v) { file_ << v.x << ' ' << v.y << ' ' << v.z; }
    void write(const Color& c) { file_ << c.r << ' ' << c.g << ' ' << c.b; }

    std::ofstream file_;
    std::mutex noting_;
    std::set<std::string> noted_;
    int calls_ = 0, last_column_ = 0, last_row_ = 0;
};

inline Record& record() {
    static Record one;
    return one;
}

// A material says its kind by its members.
template <class Material>
void note_material(const std::string& sphere, const Material& material) {
    const auto note = [&](const char* name, const auto& value) {
        record().note(sphere, name, value);
    };
    if constexpr (requires { material.index; }) {
        note("the material", "glass");
        note("the index", material.index);
    } else if constexpr (requires { material.albedo; }) {
        note(
            "the material", requires { material.fuzz; } ? "metal" : "matte");
        note("the color", material.albedo);
        if constexpr (requires { material.fuzz; }) note("the fuzz", material.fuzz);
    }
}

// The spheres of a list, each with what `tell` says of it in addition.
template <class Spheres, class Tell>
void note_spheres(const Spheres& spheres, const Tell& tell) {
    int number = 0;
    for (const SceneSphere& sphere : spheres) {
        const std::string group =
            "sphere " + std::to_string(++number) + " of " + std::to_string(spheres.size());
        record().note(group, "the center", sphere.shape.center);
        record().note(group, "the radius", sphere.shape.radius);
        tell(group, sphere);
    }
}

}  // namespace rt::recorder
