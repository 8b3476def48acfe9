// What the main() of two tracers hands over, compared in words.

#include <companion/own/handed_over.hpp>

#include "catch.hpp"

using namespace companion;

namespace {

// A record of one group; the values are "name: value" and separated by "; ".
std::string group(const std::string& name, const std::string& values) {
    std::string lines;
    for (std::size_t at = 0; at < values.size();) {
        const std::size_t end = std::min(values.find("; ", at), values.size()),
                          colon = values.find(": ", at);
        lines += name + '\t' + values.substr(at, colon - at) + '\t' +
                 values.substr(colon + 2, end - colon - 2) + '\n';
        at = end + 2;
    }
    return lines;
}

}  // namespace

TEST_CASE("a value says how it comes from the right one", "[handed_over]") {
    struct Case {
        const char *mine, *ours, *way;
    };
    for (const auto& [mine, ours, way] :
         std::initializer_list<Case>{{"0.666666666667", "1.5", "1 / that"},
                                     {"50", "51", "1 less"},
                                     {"52", "51", "1 more"},
                                     {"0.5", "0.25", "twice that"},
                                     {"0.15", "0.3", "half of that"},
                                     {"0.7", "0.3", "1 minus that"},
                                     {"-1 -2 3", "1 2 -3", "the opposite"},
                                     {"0.7 0.9 0.6", "0.3 0.1 0.4", "1 minus that"},
                                     {"2 1 3", "1 2 3", "with x and y swapped"},
                                     {"1 3 2", "1 2 3", "with y and z swapped"},
                                     {"0 3 4", "0 0.6 0.8", "of a length that is not 1"},
                                     {"40", "0.698131700798", "in degrees, not in radians"},
                                     {"0.698131700798", "40", "in radians, not in degrees"}}) {
        INFO(mine << ", " << ours);
        const std::string words =
            difference_in_words(group("the view", std::string{"it: "} + mine),
                                group("the view", std::string{"it: "} + ours));
        CHECK(words.find(std::string{" (yours is "} + way + ").") != std::string::npos);
    }
    CHECK(
        difference_in_words(group("the lens", "the focus: 5"), group("the lens", "the focus: 0")) ==
        "In your main(), the focus is 5; it should be 0.");
}

TEST_CASE("all values of the first group that differs are named", "[handed_over]") {
    const std::string ours = group("the lens", "the aperture: 0.2; the focus: 7") +
                             group("the sky", "the sky's color above: 1 1 1");
    CHECK(difference_in_words(ours, ours).empty());
    CHECK(
        difference_in_words(group("the lens", "the aperture: 7; the focus: 0.2") +
                                group("the sky", "the sky's color above: 0 0 0"),
                            ours) ==
        "In your main(), the aperture is 7; it should be 0.2 (yours is the focus). Also, the focus "
        "is 0.2; it should be 7 (yours is the aperture).");
    INFO("what only one of them records is no difference");
    CHECK(difference_in_words(group("the sky", "the sky's color above: 1 1 1"), ours).empty());
    CHECK(difference_in_words(ours + group("the grid", "the grid's width: 3"), ours).empty());
    INFO("nor is the rounding of what a tracer computes itself");
    CHECK(difference_in_words(group("the lens", "the aperture: 0.2000000001"), ours).empty());
}

TEST_CASE("spheres are compared with their materials, in any order", "[handed_over]") {
    const auto sphere = [](int number, int count, const std::string& values) {
        return group("sphere " + std::to_string(number) + " of " + std::to_string(count), values);
    };
    const std::string glass = "the radius: 1; the material: glass; the index: 1.5",
                      matte = "the radius: 2; the material: matte; the color: 0.5 0.5 0.5",
                      ours = sphere(1, 2, glass) + sphere(2, 2, matte);
    CHECK(difference_in_words(sphere(1, 2, matte) + sphere(2, 2, glass), ours).empty());
    CHECK(difference_in_words(sphere(1, 1, glass), ours) ==
          "In your main(), the number of spheres is 1; it should be 2.");
    CHECK(difference_in_words(
              sphere(1, 2, "the radius: 1; the material: metal; the color: 0.5 0.5 0.5") +
                  sphere(2, 2, matte),
              ours) ==
          "In your main(), the material of sphere 1 of 2 is metal; it should be glass.");
    INFO("glass in glass, with both indices inverted");
    CHECK(difference_in_words(
              sphere(1, 2, "the radius: 0.8; the material: glass; the index: 1.25") +
                  sphere(2, 2, "the radius: 1; the material: glass; the index: 0.8"),
              sphere(1, 2, "the radius: 1; the material: glass; the index: 1.25") +
                  sphere(2, 2, "the radius: 0.8; the material: glass; the index: 0.8")) ==
          "In your main(), the index of sphere 1 of 2 is 0.8; it should be 1.25 (yours is 1 / "
          "that).");
}
