#pragma once
// Writes what the light of one sample does, step by step. The companion compiles a program with
// this folder before all others, so that its headers stand in front of those of the same names, and
// runs it with COURSE_FOLLOW="COLUMN ROW SAMPLE" and the file COURSE_TRAIL. Nothing else is drawn:
// the program ends as soon as the pixel is done.
//
// A line is a step's name, then names and values of what belongs to it, with tabs between. Colors
// and vectors are three numbers.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <rt/color.hpp>
#include <rt/sphere.hpp>
#include <rt/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rt::follow {

class Trail {
  public:
    Trail() {
        const char* const wanted = std::getenv("COURSE_FOLLOW");
        const char* const file = std::getenv("COURSE_TRAIL");
        if (!wanted || !file) return;
        std::sscanf(wanted, "%d %d %d", &column_, &row_, &sample_);
        file_.precision(17);
        file_.open(file);
    }

    // The next pixels are counted from this pixel of the picture on.
    void begin_panel(int left, int top) { left_ = left, top_ = top; }
    int left() const { return left_; }
    int top() const { return top_; }
    bool is_wanted(int column, int row) const {
        return left_ + column == column_ && top_ + row == row_;
    }
    bool is_wanted(int sample) const { return sample == sample_; }

    // It is written at once, because the program may crash.
    template <class... Fields>
    void step(const char* name, const Fields&... fields) {
        file_ << name;
        (write(fields), ...);
        file_ << '\n' << std::flush;
    }

    [[noreturn]] void end() {
        step("end");
        file_.close();
        std::_Exit(0);  // other threads may still be drawing
    }

  private:
    template <class Value>
    void write(const Value& value) {
        file_ << '\t' << value;
    }
    void write(const Vec2& v) { file_ << '\t' << v.x << ' ' << v.y; }
    void write(const Vec3& v) { file_ << '\t' << v.x << ' ' << v.y << ' ' << v.z; }
    void write(const Color& c) { file_ << '\t' << c.r << ' ' << c.g << ' ' << c.b; }
    void write(const std::vector<Real>& numbers) {
        file_ << '\t';
        for (const Real number : numbers) file_ << number << ' ';
    }

    std::ofstream file_;
    int column_ = -1, row_ = -1, sample_ = 0, left_ = 0, top_ = 0;
};

inline Trail& trail() {
    static Trail one;
    return one;
}

// Where a thread is.
struct Place {
    bool in_pixel = false;   // the pixel that is followed
    int samples = 0;         // of this pixel so far
    bool in_sample = false;  // the sample that is followed
    bool in_path = false;    // the path loop tells what happens
    int segments = 0;
};
inline thread_local Place here;

// A camera has made the ray of the pixel's next sample.
template <class AnyCamera, class AnyRay>
void note_camera_ray(const AnyCamera& camera, Vec2 offset, const AnyRay& ray) {
    if (!here.in_pixel) return;
    if (here.in_sample) trail().end();  // the sample before this one is done
    here.in_sample = trail().is_wanted(here.samples++);
    if (!here.in_sample) return;
    trail().step("camera", "eye", camera.eye, "u", camera.basis.u, "v", camera.basis.v, "w",
                 camera.basis.w, "viewport", Vec2{camera.viewport.width, camera.viewport.height},
                 "columns", camera.width, "rows", camera.height, "left", trail().left(), "top",
                 trail().top(), "offset", offset);
    trail().step("ray", "origin", ray.origin, "direction", ray.direction);
}

}  // namespace rt::follow
