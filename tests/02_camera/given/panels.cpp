#include <panels.hpp>

#include "checkpoint.hpp"

TEST_CASE("a pixel belongs to the part whose edges it lies between", "[panels]") {
    for (int pixels = 1; pixels <= 40; ++pixels)
        for (int i = 0; i < 4; ++i) {
            const panels::Span span = panels::part(pixels, i, 4);
            CAPTURE(pixels, i, span.begin, span.size);
            if (pixels < 4) continue;  // parts share pixels
            CHECK(panels::part_of(span.begin, pixels, 4) == i);
            CHECK(panels::part_of(span.begin + span.size - 1, pixels, 4) == i);
        }
    CHECK(panels::part_of(0, 10, 4) == 0);
    CHECK(panels::part_of(1, 10, 4) == 0);
    CHECK(panels::part_of(2, 10, 4) == 1);  // the edges are at 2, 5 and 7
    CHECK(panels::part_of(9, 10, 4) == 3);
    CHECK(panels::part_of(0, 1, 4) == 3);
}
