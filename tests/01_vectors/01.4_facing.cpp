#include <rt/facing.hpp>

#include "checkpoint.hpp"

using namespace checkpoint;

TEST_CASE("01.4 facing is the sign of the cosine", "[01.4]") {
    const Vec3 normal{0, 1, 0};
    INFO("Hint: the cosine of an angle is positive below 90 degrees and negative above");
    CHECK(rt::facing(normal, {real(0.5), 1, 0}) == 1);
    CHECK(rt::facing(normal, {5, real(-0.25), 3}) == -1);
    CHECK(rt::facing(normal, {1, 0, -2}) == 0);
}

TEST_CASE("01.4 the lengths of the vectors do not matter", "[01.4]") {
    INFO("Hint: compare the dot product with 0, not with 1");
    CHECK(rt::facing({0, 0, 20}, {0, 3, 100}) == 1);
    CHECK(rt::facing({0, 0, real(0.125)}, {0, 3, real(-0.5)}) == -1);
    CHECK(rt::facing({1, 2, 3}, {3, 0, -1}) == 0);
}

TEST_CASE("01.4 tiny and huge vectors have a side too", "[01.4][hard]") {
    const Real tiny = real(for_this_precision(1e-30, 1e-200));
    const Real huge = 1 / tiny;
    INFO(
        "Hint: the product of two tiny numbers underflows to 0, that of two huge ones is infinite; "
        "split_scale(v).v has the same direction as v and an ordinary size");
    CHECK(rt::facing({tiny, 0, 0}, {tiny, tiny, 0}) == 1);
    CHECK(rt::facing({tiny, 0, 0}, {-tiny, tiny, 0}) == -1);
    CHECK(rt::facing({huge, huge, 0}, {huge, -huge, 0}) == 0);
    CHECK(rt::facing({huge, huge, 0}, {huge, -huge / 2, 0}) == 1);
    CHECK(rt::facing({huge, 0, 0}, {-huge, tiny, 0}) == -1);
}

TEST_CASE("01.4 a zero vector faces nowhere", "[01.4][hard]") {
    CHECK(rt::facing({0, 0, 0}, {1, 2, 3}) == 0);
    CHECK(rt::facing({1, 2, 3}, {0, 0, 0}) == 0);
}
