#include <app/nearest_word.hpp>

#include "checkpoint.hpp"

TEST_CASE("the nearest word is the one with the fewest slips", "[nearest_word]") {
    const std::vector<std::string> words{"center", "radius", "material"};
    CHECK(app::nearest_word("centre", words) == "center");
    CHECK(app::nearest_word("raduis", words) == "radius");
    CHECK(app::nearest_word("materials", words) == "material");
    CHECK(app::nearest_word("mat", words) == "material");
    CHECK(app::nearest_word("fuzz", words).empty());
    CHECK(app::nearest_word("emitter", {"matte", "light"}).empty());
    CHECK(app::nearest_word("", words).empty());
    CHECK(app::nearest_word(std::string(1 << 20, 'r'), words).empty());
}
