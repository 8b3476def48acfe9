#pragma once
#include <cstdlib>
#include <cstring>
#include <rt/todo.hpp>

namespace course {

// Whether this exercise is to end as its stub does: see dead_ends.py.
inline bool is_stub(const char* exercise) {
    static const char* const stub = std::getenv("COURSE_STUB");
    return stub && std::strcmp(stub, exercise) == 0;
}

// Whether this exercise is to give a wrong answer.
inline bool is_wrong(const char* exercise) {
    static const char* const wrong = std::getenv("COURSE_WRONG");
    return wrong && std::strcmp(wrong, exercise) == 0;
}

}  // namespace course
