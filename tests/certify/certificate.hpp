#pragma once
// The lines of the certificate: a measured figure, and the bound that it is held to. `course
// certify` reads what these programs print: one line per measurement, its fields separated by tabs.
//
//   holds or FAILS, exercise, what was measured, the figure, the bound
//
// The exercise of a line that is held to a hard case ends in a star, "01.4*".
// A line that only informs starts with "shows" and has an empty bound. Exit code 0 when all hold, 1
// when not, 3 when an exercise is still to be written.

#include <app/platform.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <rt/real.hpp>
#include <rt/rng.hpp>
#include <rt/todo.hpp>
#include <rt/vec3.hpp>
#include <statistics.hpp>
#include <string>

namespace certify {

using rt::Real;
using rt::Vec3;

inline std::string format(double figure, const char* unit) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3g%s%s", figure, *unit ? " " : "", unit);
    return text;
}

class Certificate {
  public:
    // The figure must be at most the bound; a NaN is not.
    void at_most(const char* exercise, const char* what, double figure, double bound,
                 const char* unit) {
        line(figure <= bound, exercise, what, figure, "at most " + format(bound, unit), unit);
    }
    void at_least(const char* exercise, const char* what, double figure, double bound,
                  const char* unit) {
        line(figure >= bound, exercise, what, figure, "at least " + format(bound, unit), unit);
    }
    void shows(const char* exercise, const char* what, double figure, const char* unit) {
        std::printf("shows\t%s\t%s\t%s\t\n", exercise, what, format(figure, unit).c_str());
        std::fflush(stdout);
    }
    int exit_code() const { return all_hold_ ? 0 : 1; }

  private:
    void line(bool holds, const char* exercise, const char* what, double figure,
              const std::string& bound, const char* unit) {
        all_hold_ = all_hold_ && holds;
        std::printf("%s\t%s\t%s\t%s\t%s\n", holds ? "holds" : "FAILS", exercise, what,
                    format(figure, unit).c_str(), bound.c_str());
        std::fflush(stdout);
    }
    bool all_hold_ = true;
};

// Runs the measurements of a chapter, each on its own, so if one throws, the others still run.
// Returns the exit code.
template <class... Measurements>
int certify(const Measurements&... measurements) {
    app::prepare_process();
    Certificate certificate;
    int code = 0;
    const auto attempt = [&](const auto& measure) {
        try {
            measure(certificate);
        } catch (const rt::NotImplemented& error) {
            std::printf("FAILS\t%s\tis still to be written\t\t\n", error.exercise().c_str());
            code = code ? code : 3;
        } catch (const std::exception& error) {
            std::printf("FAILS\t\t%s\t\t\n", error.what());
            code = 1;
        }
    };
    (attempt(measurements), ...);
    return certificate.exit_code() ? 1 : code;
}

inline constexpr double epsilon = static_cast<double>(rt::epsilon);

inline double largest_component(Vec3 v) {
    return static_cast<double>(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

}  // namespace certify
