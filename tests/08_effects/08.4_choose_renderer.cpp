#include <checkpoint.hpp>
#include <rt/choose_renderer.hpp>
#include <vector>

using namespace checkpoint;
using rt::Effects;

namespace {

const Effects all{true, true, true, true, true, true, true, true};

void check(const Effects& needed, const std::vector<Effects>& renderers, std::size_t expected,
           const char* hint) {
    INFO("needed: " << names(needed));
    std::string list;
    for (std::size_t i = 0; i < renderers.size(); ++i)
        list += "\nrenderer " + std::to_string(i) + ": " + names(renderers[i]);
    INFO("among" << list);
    std::size_t chosen = 0;
    try {
        chosen = rt::narrowest(needed, renderers);
    } catch (const std::invalid_argument& error) {
        INFO("it threw \"" << error.what() << "\", but number " << expected
                           << " has all of them.\nHint: a renderer may have more than is needed");
        CHECK(false);
        return;
    }
    INFO("expected " << expected << " (" << names(renderers[expected]) << "), but yours chooses "
                     << chosen << ".\nHint: " << hint);
    CHECK(chosen == expected);
}

// The set of effects whose bits are those of a number, 0 ... 255.
Effects numbered(unsigned bits) {
    Effects effects;
    for (std::size_t i = 0; i < rt::all_effects.size(); ++i)
        effects.*rt::all_effects[i].member = (bits >> i & 1) != 0;
    return effects;
}

}  // namespace

TEST_CASE("08.4 the renderer that has what is needed and nothing else is chosen", "[08.4]") {
    const std::vector<Effects> renderers{all, {.glass = true}, {}, {.lens = true}};
    check({}, renderers, 2, "the scene needs nothing, and number 2 has nothing");
    check({.glass = true}, renderers, 1, "number 1 has glass alone");
    check({.lens = true}, renderers, 3, "number 3 has the lens alone");
}

TEST_CASE("08.4 a renderer that lacks an effect is not chosen", "[08.4]") {
    check({.fog = true}, {{}, {.glass = true}, all}, 2, "only the last one has fog");
    check({.glass = true, .lens = true}, {{.glass = true}, {.lens = true}, all}, 2,
          "the first two have one of the two effects each; both are needed");
    check({.mirror = true, .fuzz = true}, {{.glass = true, .lens = true}, all}, 1,
          "two effects are needed and number 0 has two, but others");
}

TEST_CASE("08.4 of those that have all the one with the fewest is chosen", "[08.4]") {
    const Effects three{.mirror = true, .fuzz = true, .glass = true};
    const Effects four{.mirror = true, .fuzz = true, .glass = true, .fog = true};
    check({.glass = true}, {all, four, three, {.fuzz = true}}, 2, "number 2 has three effects");
    check({.glass = true}, {three, four, all}, 0, "number 0 has three effects");
    check({.glass = true, .fog = true}, {three, all, four}, 2,
          "number 2 has fog, and four effects");
}

TEST_CASE("08.4 of equals the first is chosen", "[08.4][hard]") {
    check({.mirror = true}, {{.mirror = true, .lens = true}, {.mirror = true, .glass = true}, all},
          0, "numbers 0 and 1 have two effects each");
    check({}, {all, {.fog = true}, {.lens = true}, {.fog = true}}, 1,
          "numbers 1, 2 and 3 have one effect each");
}

TEST_CASE("08.4 when none has all that is said", "[08.4][hard]") {
    const auto refuses = [](const Effects& needed, const std::vector<Effects>& renderers) {
        INFO("none of the " << renderers.size() << " renderers has " << names(needed)
                            << ": std::invalid_argument is to be thrown, with a message");
        try {
            const std::size_t chosen = rt::narrowest(needed, renderers);
            INFO("but yours chooses number " << chosen);
            CHECK(false);
        } catch (const std::invalid_argument& error) {
            INFO("the message says what is missing, and yours is empty");
            CHECK(error.what() != std::string{});
        }
    };
    refuses({.fog = true}, {{}, {.glass = true}});
    refuses({.glass = true, .lens = true}, {{.glass = true}, {.lens = true}});
    refuses({}, {});
}

TEST_CASE("08.4 for every one of the 256 sets of effects", "[08.4][hard]") {
    // Every third set has a renderer, from the widest on.
    std::vector<Effects> renderers;
    for (int bits = 255; bits >= 0; bits -= 3)
        renderers.push_back(numbered(static_cast<unsigned>(bits)));
    for (unsigned bits = 0; bits < 256; ++bits) {
        const Effects needed = numbered(bits);
        const std::size_t chosen = rt::narrowest(needed, renderers);
        REQUIRE(chosen < renderers.size());
        INFO("needed: " << names(needed) << "; chosen: " << names(renderers[chosen]));
        REQUIRE(covers(renderers[chosen], needed));
        for (std::size_t i = 0; i < renderers.size(); ++i) {
            if (!covers(renderers[i], needed)) continue;
            INFO("renderer " << i << " would do: " << names(renderers[i]));
            REQUIRE(count(renderers[i]) >= count(renderers[chosen]));
        }
    }
}
