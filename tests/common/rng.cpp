#include <rt/rng.hpp>

#include "checkpoint.hpp"

// The first outputs of the demo program that comes with the generator's publication, for state 42
// and stream 54.
TEST_CASE("pcg32 gives its author's check values", "[rng]") {
    rt::Rng rng{42, 54};
    for (const std::uint32_t expected :
         {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
        CHECK(rng() == expected);
}
