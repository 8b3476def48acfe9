#pragma once
// What the main() of two tracers hands over to the course's functions, compared in words. The files
// of recorder/ write the records.

#include <string>

namespace companion {

// In which way one main() differs from ours: the values of the first group that differs, one
// sentence each; empty if nothing differs. The order of the spheres does not matter, nor does what
// only one of the records has.
std::string difference_in_words(const std::string& mine, const std::string& ours);

// Whether a record goes to its end: the tracer called render_pixel.
bool has_pixels(const std::string& record);

}  // namespace companion
