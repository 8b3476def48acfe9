#include <checkpoint.hpp>
#include <rt/choose_renderer.hpp>
#include <rt/rng.hpp>
#include <rt/todo.hpp>
#include <vector>

using namespace checkpoint;
using rt::Effects;

namespace {

const Effects all{true, true, true, true, true, true, true, true, true, true};
const unsigned sets = 1u << rt::all_effects.size();  // of effects

// What narrowest answers: "number 2", or what it throws.
std::string chosen(const Effects& needed, const std::vector<Effects>& renderers) {
    try {
        return "number " + std::to_string(rt::narrowest(needed, renderers));
    } catch (const std::invalid_argument& error) {
        return *error.what() ? "std::invalid_argument" : "std::invalid_argument with no message";
    } catch (const rt::NotImplemented&) {
        throw;
    } catch (const std::exception& error) {
        return std::string{"another exception, which says: "} + error.what();
    }
}

void check(const Effects& needed, const std::vector<Effects>& renderers,
           const std::string& expected, const char* hint) {
    const std::string given = chosen(needed, renderers);
    INFO("needed: " << names(needed));
    std::string list;
    for (std::size_t i = 0; i < renderers.size(); ++i)
        list += "\nnumber " + std::to_string(i) + ": " + names(renderers[i]);
    INFO("among" << (renderers.empty() ? " none" : list) << "\nHint: " << hint);
    CHECK(given == expected);
}
void check(const Effects& needed, const std::vector<Effects>& renderers, std::size_t expected,
           const char* hint) {
    check(needed, renderers, "number " + std::to_string(expected), hint);
}

// The set of effects whose bits are those of a number below `sets`.
Effects numbered(unsigned bits) {
    Effects effects;
    for (std::size_t i = 0; i < rt::all_effects.size(); ++i)
        effects.*rt::all_effects[i].member = (bits >> i & 1) != 0;
    return effects;
}

}  // namespace

TEST_CASE("08.6 the renderer that has what is needed and nothing else is chosen", "[08.6]") {
    const std::vector<Effects> renderers{all, {.glass = true}, {}, {.lens = true}};
    check({}, renderers, 2, "the scene needs nothing, and number 2 has nothing");
    check({.glass = true}, renderers, 1, "number 1 has glass alone");
    check({.lens = true}, renderers, 3, "number 3 has the lens alone");
}

TEST_CASE("08.6 a renderer that lacks an effect is not chosen", "[08.6]") {
    check({.fog = true}, {{}, {.glass = true}, all}, 2, "only the last one has fog");
    check({.glass = true, .lens = true}, {{.glass = true}, {.lens = true}, all}, 2,
          "the first two have one of the two effects each; both are needed");
    check({.mirror = true, .fuzz = true}, {{.glass = true, .lens = true}, all}, 1,
          "two effects are needed and number 0 has two, but others");
}

TEST_CASE("08.6 the narrowest of those that have all is chosen", "[08.6]") {
    const Effects three{.mirror = true, .fuzz = true, .glass = true};
    const Effects four{.mirror = true, .fuzz = true, .glass = true, .fog = true};
    check({.glass = true}, {all, four, three, {.fuzz = true}}, 2, "number 2 has three effects");
    check({.glass = true}, {three, four, all}, 0, "number 0 has three effects");
    check({.glass = true, .fog = true}, {three, all, four}, 2,
          "number 2 has fog, and four effects");
}

TEST_CASE("08.6 of equals the first is chosen", "[08.6][hard]") {
    check({.mirror = true}, {{.mirror = true, .lens = true}, {.mirror = true, .glass = true}, all},
          0, "numbers 0 and 1 have two effects each");
    check({}, {all, {.fog = true}, {.lens = true}, {.fog = true}}, 1,
          "numbers 1, 2 and 3 have one effect each");
}

TEST_CASE("08.6 if none has all it throws and says so", "[08.6][hard]") {
    const auto refuses = [](const Effects& needed, const std::vector<Effects>& renderers) {
        check(needed, renderers, "std::invalid_argument",
              "none of these has all that is needed: throw std::invalid_argument, with a message "
              "that says what is missing");
    };
    refuses({.fog = true}, {{}, {.glass = true}});
    refuses({.glass = true, .lens = true}, {{.glass = true}, {.lens = true}});
    refuses({}, {});
}

TEST_CASE("08.6 for every set of effects", "[08.6][hard]") {
    rt::Rng rng{84, 1};
    unsigned right = 0;
    for (unsigned i = 0; i < sets * 3; ++i) {
        const Effects needed = numbered(i % sets);
        // Up to 40 renderers, some of them twice; most have more than is needed.
        std::vector<Effects> renderers(1 + rng() % (i % 2 ? 4 : 40));
        for (Effects& renderer : renderers)
            renderer = rng() % 4 == 0 ? renderers[rng() % renderers.size()]
                                      : numbered(((rng() % 3 ? i : 0) | (rng() & rng())) % sets);
        std::string expected = "std::invalid_argument";
        for (int most = count(all); most >= 0; --most)
            for (std::size_t k = renderers.size(); k-- > 0;)
                if (covers(renderers[k], needed) && count(renderers[k]) == most)
                    expected = "number " + std::to_string(k);
        if (chosen(needed, renderers) == expected) {
            ++right;
            continue;
        }
        check(needed, renderers, expected,
              "of the renderers that have all that is needed, choose the one with the fewest "
              "effects; of several such, the first in the list");
        return;
    }
    CHECK(right == sets * 3);
}
