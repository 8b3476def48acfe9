#pragma once
#include <exception>
#include <optional>
#include <rt/compiler.hpp>
#include <stdexcept>
#include <string>

namespace rt {

// Thrown by an exercise that nobody has written yet. what() is one line for a person: which
// exercise, the file and line of its stub, and where the text explains it.
class NotImplemented : public std::logic_error {
  public:
    NotImplemented(std::string exercise, const std::string& file, int line);

    // Such as "03.1".
    const std::string& exercise() const { return exercise_; }

  private:
    std::string exercise_;
};

namespace detail {

struct ExerciseId {
    const char* id;
    const char* file;
    int line;
    // Not explicit, so that todo("03.1") converts the text where it is written, and records that
    // line.
    ExerciseId(const char* exercise, const char* f = RT_CALLER_FILE, int l = RT_CALLER_LINE)
        : id{exercise}, file{f}, line{l} {}
};

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

// Stands in for a return value of any type.
struct AnyValue {
    // std::optional is excluded: it already accepts whatever converts to its value.
    template <class T>
    requires(!is_optional<T>) operator T() const {
        std::terminate();  // never called: todo has thrown by then
    }
};

[[noreturn]] void throw_not_implemented(const ExerciseId& exercise);

}  // namespace detail

// The body of an exercise's stub: `return rt::todo("03.1", arguments...);`. Throws NotImplemented.
// The stub passes its arguments along only so that the compiler does not warn that they are unused.
template <class... Args>
[[noreturn]] detail::AnyValue todo(const detail::ExerciseId& exercise, const Args&...) {
    detail::throw_not_implemented(exercise);
}

}  // namespace rt
