// The renderer for a scene: it has all effects that are needed, and as few others as possible.

#include <checkpoint.hpp>
#include <rt/choose_renderer.hpp>
#include <rt/rng.hpp>
#include <stdexcept>
#include <vector>

#include "../scenes.hpp"

using namespace checkpoint;
using rt::Effects;
using rt::every_effect;

TEST_CASE("the narrowest renderer that has all that is needed is chosen") {
    const Effects glass{.glass = true}, lens{.lens = true}, both{.glass = true, .lens = true};
    CHECK(rt::narrowest({}, std::vector{every_effect, glass, Effects{}, lens}) == 2);
    CHECK(rt::narrowest(glass, std::vector{every_effect, lens, both, glass}) == 3);
    CHECK(rt::narrowest(both, std::vector{glass, lens, every_effect}) == 2);
    // Of equals the first.
    CHECK(rt::narrowest({}, std::vector{every_effect, lens, glass, lens}) == 1);
}

TEST_CASE("if no renderer has all that is needed the error says what was needed") {
    CHECK_THROWS_AS(rt::narrowest({}, {}), std::invalid_argument);
    try {
        rt::narrowest({.fog = true}, std::vector{Effects{}, Effects{.glass = true}});
        FAIL(EXPECTED "an error");
    } catch (const std::invalid_argument& error) {
        CHECK(std::string{error.what()}.find("fog") != std::string::npos);
    }
}

TEST_CASE("for every set of effects the narrowest renderer is chosen") {
    rt::Rng rng{84, 1};
    for (unsigned needed_bits = 0; needed_bits < sets_of_effects; ++needed_bits) {
        const Effects needed = numbered_effects(needed_bits);
        // Up to 40 renderers, some of them twice, and one with everything.
        std::vector<Effects> renderers(1 + rng() % 40);
        for (Effects& renderer : renderers)
            renderer = rng() % 4 == 0
                           ? renderers[rng() % renderers.size()]
                           : numbered_effects((needed_bits | (rng() & rng())) % sets_of_effects);
        renderers.push_back(every_effect);
        std::size_t expected = renderers.size();
        for (int most = count(every_effect); most >= 0; --most)
            for (std::size_t k = renderers.size(); k-- > 0;)
                if (covers(renderers[k], needed) && count(renderers[k]) == most) expected = k;
        INFO("needed: " << names(needed));
        REQUIRE(rt::narrowest(needed, renderers) == expected);
    }
}
