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

}  // namespace course
