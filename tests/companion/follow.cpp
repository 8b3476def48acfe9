// What --follow says and draws of a sample's light.

#include <algorithm>
#include <companion/follow/trail_drawing.hpp>
#include <regex>

#include "catch.hpp"

using namespace companion;

namespace {

// The steps of a trail, a line each: "hit: t 2.5; point 1 2 3".
Trail trail_of(const std::string& steps) {
    std::string text = std::regex_replace(steps, std::regex{"(: |; )([a-z]+) "}, "\t$2\t");
    return read_trail(text);
}

const std::string camera =
    "camera: eye 0 0 4; u 1 0 0; v 0 1 0; w 0 0 1; viewport 2 1; columns 200; rows 100; left 10; "
    "top 20; offset 0.25 0.5\n";
const std::string first_hit =
    "ray: origin 0 0 4; direction 0 0 -1\n"
    "hit: t 3; point 0 0 1; normal 0 0 1; front 1; lamp -1; number 7; center 0 0 0; radius 1\n";

std::string words_of(const std::string& steps) {
    return in_words(trail_of(steps));
}

bool says(const std::string& words, const std::string& part) {
    INFO(words << "\nshould say: " << part);
    CHECK(words.find(part) != std::string::npos);
    return words.find(part) != std::string::npos;
}

int count(const std::string& text, const std::string& pattern) {
    const std::regex all{pattern};
    return static_cast<int>(std::distance(std::sregex_iterator{text.begin(), text.end(), all}, {}));
}

}  // namespace

TEST_CASE("a path is told ray by ray", "[follow]") {
    CHECK(words_of(camera + "path: depth 5\n" + first_hit +
                   "material: name Lambertian\nof: albedo 0.5 0.25 1\n"
                   "random: numbers 0.25 0.75 \n"
                   "scatter: direction 0.6 0 0.8; attenuation 0.5 0.25 1\n"
                   "ray: origin 0 0 1.001; direction 0.6 0 0.8\n"
                   "miss\n"
                   "sky: direction 0.6 0 0.8; color 2 2 2\n"
                   "light: color 1 0.5 2\n") ==
          "The first ray goes through the pixel at (0.25, 0.5); its top left corner is (0, 0).\n"
          "   1 from (0, 0, 4) along (0, 0, -1)\n"
          "     meets sphere 7, of radius 1 around (0, 0, 0), at t = 3\n"
          "     from outside, at 0.0 degrees from the normal\n"
          "     point (0, 0, 1), normal (0, 0, 1)\n"
          "     Lambertian, albedo (0.5, 0.25, 1)\n"
          "     draws the random numbers 0.25 and 0.75\n"
          "     goes on along (0.6, 0, 0.8), at 36.9 degrees from the normal\n"
          "     attenuation (0.5, 0.25, 1); all of them so far multiply to (0.5, 0.25, 1)\n"
          "   2 from point 1, moved by 0.001 outward along (0.6, 0, 0.8)\n"
          "     meets nothing\n"
          "     the sky's light from (0.6, 0, 0.8) is (2, 2, 2)\n"
          "The light of this sample: (1, 0.5, 2)\n");
}

TEST_CASE("a ray that is only made is told", "[follow]") {
    const std::string ray = "ray: origin 0 0 4; direction 0 0 -1\n";
    says(words_of(ray + "end\n"), "along (0, 0, -1)\n     is tested against no sphere\n");
    CHECK(words_of(ray).find("tested") == std::string::npos);  // it may have crashed
    CHECK(words_of(first_hit + "end\n").find("tested") == std::string::npos);
}

TEST_CASE("where a ray starts, and the angle on its side of the surface, are told", "[follow]") {
    const std::string through = "scatter: direction 0.6 0 -0.8; attenuation 1 1 1\n";
    says(words_of(first_hit + through), "at 36.9 degrees from the normal, through the surface\n");
    says(words_of(first_hit + "ray: origin 0 0 0.999; direction 0.6 0 -0.8\n"),
         "from point 1, moved by 0.001 inward along");
    says(words_of(first_hit + "ray: origin 0 0 1; direction 0.6 0 -0.8\n"),
         "from point 1 itself along");
    const std::string from_inside =
        "ray: origin 0 0 0; direction 0.6 0 0.8\n"
        "hit: t 1; point 0.6 0 0.8; normal 0.6 0 0.8; front 0; lamp -1\n";
    says(words_of(from_inside),
         "meets a shape that is no plain sphere, at t = 1\n"
         "     from inside, at 0.0 degrees from the normal\n");
    says(words_of(from_inside + "scatter: direction -0.6 0 -0.8; attenuation 1 1 1\n"),
         "at 0.0 degrees from the normal\n");
}

TEST_CASE("what is not a number, and a direction whose length is not 1, is told", "[follow]") {
    const std::string words = words_of(
        "ray: origin 0 0 4; direction 0 0 -2\n"
        "hit: t nan; point nan 0 inf; normal 0 -nan 0; front 1; lamp -1\n"
        "scatter: direction 0 0 1; attenuation 1 1 1\n");
    says(words, "along (0, 0, -2), of length 2\n");
    says(words, "at t = not a number\n");
    says(words, "point (not a number, 0, infinity), normal (0, not a number, 0)");
    says(words, "at an unknown angle from the normal");
}

TEST_CASE("lamps, fog, limits and haze are told", "[follow]") {
    const std::string shadow = "shadow: origin 0 0 1; direction 0 1 0; distance 3; ";
    says(words_of("scatter: direction 0 1 0; attenuation 0.5 0.5 1\n" + shadow +
                  "blocked 0\nlamp: color 1 2 3\n"),
         "a lamp lies along (0, 1, 0), 3 away, and nothing is in the way\n"
         "     the lamp's share is (1, 2, 3), with the attenuations (0.5, 1, 3)\n");
    says(words_of(shadow + "blocked 1\n"), "and something is in the way\n");
    says(words_of(shadow + "meets inf\n"), "and nothing is in the way\n");
    says(words_of(shadow + "meets 2\n"), "and the way there meets something at t = 2\n");
    says(words_of(shadow + "blocked 1\nlamp: color 0 0 0\nlamp: color 0 0 0\n"),
         "no ray to a lamp; its share is (0, 0, 0), with the attenuations (0, 0, 0)\n");
    says(words_of(std::regex_replace(first_hit, std::regex{"-1; n"}, "2; n")), "which is lamp 2\n");
    says(words_of(first_hit + "fog: t 2; point 0 0 2\n"),
         "but a droplet of fog comes first, at t = 2, point (0, 0, 2)\n");
    says(words_of("path: depth 5\nlimit: ends black; throughput 1 1 1\n"),
         "the limit of 5 bounces is reached: the path ends in black, with the throughput (1, 1, "
         "1)\n");
    says(words_of("limit: ends none; throughput 2 2 2\n"),
         "the path goes on, with the throughput (2");
    says(words_of(first_hit + "absorbed\n"), "is absorbed\n");
    says(words_of("haze: color 1 1 1\n"), "Seen through the haze: (1, 1, 1)\n");
}

TEST_CASE("of an endless path, the first rays and the last one are told", "[follow]") {
    std::string steps;
    for (int i = 0; i < 200; ++i) steps += first_hit;
    const std::string words = words_of(steps + "endless: segments 200\n");
    says(words, "\n   6 from point 5");
    says(words, "\n   ...\n 200 from point 199");
    says(words, "\nMore than 200 segments: stopped here.\n");
    CHECK(std::count(words.begin(), words.end(), '\n') < 40);
    says(words_of(first_hit + first_hit), "\n   2 from");
}

TEST_CASE("a trail that a crash has cut off is told as far as it goes", "[follow]") {
    says(words_of("ray: origin 0 0 4; direction 0 0"), "from (0, 0, 4) along (0, 0, not a number)");
}

TEST_CASE("the path is drawn in three views, with the numbers of the words", "[follow]") {
    const Trail trail = trail_of(camera + first_hit +
                                 "ray: origin 0 0 1; direction 0 1 0\n"
                                 "hit: t 1; point 0 1 1; normal 0 -1 0; front 0; lamp -1\n"
                                 "ray: origin 0 1 1; direction 1 0 0\n"
                                 "miss\n");
    const std::string svg = drawn(trail, {"PNG", 400, 200});
    CHECK(svg.find("<image x=\"14.0\" y=\"14.0\" width=\"960.0\" height=\"480.0\" "
                   "href=\"data:image/png;base64,UE5H\"/>") != std::string::npos);
    CHECK(count(svg, ">1</text>") == 3);
    CHECK(count(svg, ">2</text>") == 3);
    CHECK(count(svg, ">3</text>") == 0);
    CHECK(count(svg, "marker-end") == 2);
    CHECK(count(svg, "r=\"4\"") == 1);  // from the side, the ray into the sky is a point
    CHECK(count(svg, "class=\"inside\"") == 3);
    CHECK(count(svg, "class=\"ball\"") == 2);
    // Point 1 is in the middle of the panel: (10 + 100, 20 + 50) of the picture, 2.4 times as
    // large.
    CHECK(svg.find("<circle class=\"point\" cx=\"278.0\" cy=\"182.0\"") != std::string::npos);
    // Point 2 is 1/3 above it, of a viewport that is 1 high.
    CHECK(svg.find("<circle class=\"point\" cx=\"278.0\" cy=\"102.0\"") != std::string::npos);
}

TEST_CASE("over the picture, a ray from the eye into the sky is a point", "[follow]") {
    const std::string svg =
        drawn(trail_of(camera + "ray: origin 0 0 4; direction 0 0 -1\nmiss\n"), {"PNG", 400, 200});
    CHECK(svg.find("cx=\"278.0\" cy=\"182.0\" r=\"4\"/>") != std::string::npos);
    CHECK(count(svg, "marker-end") == 2);
}

TEST_CASE("what cannot be drawn is left out", "[follow]") {
    const std::string svg =
        drawn(trail_of(camera + first_hit +
                       "ray: origin 0 0 1; direction 0 0 1\n"  // to behind the camera
                       "hit: t 9; point 1 0 10; normal 0 0 -1; front 0; lamp -1\n"
                       "ray: origin nan 0 10; direction 0 0 1\n"
                       "miss\n"),
              {});
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(svg.find("<image") == std::string::npos);
    CHECK(count(svg, ">2</text>") == 2);
    CHECK(drawn(trail_of(camera + "ray: origin 0 0 4; direction 0 0 -1\nmiss\n"), {}).find("nan") ==
          std::string::npos);
}
