#pragma once
#include <companion/model/course.hpp>
#include <string>

namespace companion {

// "add #include <rt/dot.hpp>, which declares dot", where an error says that a name is not known,
// and one of the course's headers that this file may include, and does not, declares it; "write
// `using namespace rt;` ...", where a tracer includes it but must still say so; "write
// `camera.width`", where it is a member of a parameter. Else empty. The error begins with its file,
// relative to the course; the line of source below it says whether the name is called.
std::string missing_include(const Course& course, const std::string& error);

}  // namespace companion
