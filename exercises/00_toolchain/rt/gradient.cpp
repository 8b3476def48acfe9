#include <rt/gradient.hpp>

namespace rt {

// Exercise 00.1. Write the definition of the function that gradient.hpp declares: the same line,
// with a body { ... } in place of the semicolon. Mix the two upper corners by `across`, the two
// lower corners by `across`, and both results by `down`. mix(a, b, t), which rt/color.hpp has, goes
// from colour a to colour b as t goes from 0 to 1.
//
// As long as there is no definition here, the linker takes another one, from a library. Its body is
// rt::todo("00.1"), which says that this exercise is still to be written. If it still says so when
// you have written yours, then the linker does not take yours for the function that was declared:
// compare name, namespace and parameters with gradient.hpp, down to each const and &.

}  // namespace rt
