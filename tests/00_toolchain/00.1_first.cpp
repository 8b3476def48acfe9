#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <rt/todo.hpp>

#include "catch.hpp"
#include "first_picture.hpp"
#include "own_process.hpp"

using first::Picture;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// What a pixel of the text's scene shows. The eye is at the origin, the picture is two units away
// and two units high; the ball, the ground and the light's direction are those of the text.
struct Place {
    enum Kind { sky, ball, ground } kind = sky;
    double normal[3]{};
    bool shadow = false;
};

struct Ray {
    double origin[3], direction[3];
};

double dot(const double (&a)[3], const double (&b)[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The t of the nearer point where a ray from outside meets a sphere around (0, y, -4), or infinity.
double distance(const Ray& ray, double y, double radius) {
    const double to_center[3]{-ray.origin[0], y - ray.origin[1], -4 - ray.origin[2]};
    const double a = dot(ray.direction, ray.direction), b = dot(ray.direction, to_center);
    const double rest = b * b - a * (dot(to_center, to_center) - radius * radius);
    const double t = rest < 0 ? -1 : (b - std::sqrt(rest)) / a;
    return t > 0 ? t : infinity;
}

Place place(int width, int height, int column, int row) {
    const double to_light[3]{-2, 2, 1};
    const Ray ray{{0, 0, 0},
                  {(2 * column + 1.0 - width) / height, 1 - (2 * row + 1.0) / height, -2}};
    const double ball = distance(ray, 0, 1), ground = distance(ray, -1001, 1000);
    Place place;
    const double t = std::min(ball, ground);
    if (t == infinity) return place;
    place.kind = t == ball ? Place::ball : Place::ground;
    const double radius = t == ball ? 1 : 1000, center[3]{0, t == ball ? 0.0 : -1001.0, -4};
    Ray to_the_light{{}, {-2, 2, 1}};
    for (int i = 0; i < 3; ++i) {
        to_the_light.origin[i] = t * ray.direction[i];
        place.normal[i] = (to_the_light.origin[i] - center[i]) / radius;
    }
    place.shadow = dot(place.normal, to_light) < 0 ||
                   (place.kind == Place::ground && distance(to_the_light, 0, 1) < infinity);
    return place;
}

// The learner's picture, with what belongs in each pixel.
struct Drawn {
    Picture picture;
    std::vector<Place> places;
    std::vector<char> inside;  // whether a pixel and those around it are alike

    explicit Drawn(Picture drawn) : picture{std::move(drawn)} {
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column)
                places.push_back(place(picture.width, picture.height, column, row));
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column)
                inside.push_back(is_inside(column, row));
    }

    const Place& at(int column, int row) const { return places[index(column, row)]; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
               static_cast<std::size_t>(column);
    }

    // All pixels within two of it show the same thing, and are all in the light or all in shadow.
    bool is_inside(int column, int row) const {
        const Place& here = at(column, row);
        for (int y = std::max(row - 2, 0); y <= std::min(row + 2, picture.height - 1); ++y)
            for (int x = std::max(column - 2, 0); x <= std::min(column + 2, picture.width - 1); ++x)
                if (at(x, y).kind != here.kind || at(x, y).shadow != here.shadow) return false;
        return true;
    }

    // Calls visit(column, row, place) for the pixels inside a thing of this kind.
    template <class Visit>
    void inside_of(Place::Kind kind, Visit visit) const {
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column)
                if (at(column, row).kind == kind && inside[index(column, row)])
                    visit(column, row, at(column, row));
    }

    // The first row that shows ground in this column.
    int horizon(int column) const {
        int row = 0;
        while (at(column, row).kind != Place::ground) ++row;
        return row;
    }
    // The last row that shows no ground and is not next to any; the ground rises toward the middle.
    int last_of_sky() const {
        int row = picture.height;
        for (int column = 0; column < picture.width; ++column) row = std::min(row, horizon(column));
        return row - 3;
    }

    // By how much two pixels differ, in the channel where they differ most.
    int difference(int column, int row, int other_column, int other_row) const {
        int most = 0;
        for (int i = 0; i < 3; ++i)
            most = std::max(most, std::abs(picture.at(column, row, i) -
                                           picture.at(other_column, other_row, i)));
        return most;
    }

    // Above the horizon: whether a pixel differs from the sky at the left edge of its row.
    bool differs_from_sky(int column, int row) const { return difference(column, row, 0, row) > 6; }

    double sum(int column, int row) const {
        return picture.at(column, row, 0) + picture.at(column, row, 1) + picture.at(column, row, 2);
    }
};

// What a step expects and what the picture shows instead; empty if the step is as expected.
struct Finding {
    std::string expected = {}, actual = {}, hint = {};
};

std::string number(double value) {
    return std::to_string(std::lround(value));
}

std::string pixel_name(int column, int row) {
    return "the pixel in column " + number(column) + " of row " + number(row);
}

std::string color(const Drawn& drawn, int column, int row) {
    return '(' + number(drawn.picture.at(column, row, 0)) + ", " +
           number(drawn.picture.at(column, row, 1)) + ", " +
           number(drawn.picture.at(column, row, 2)) + ')';
}

Finding sky(const Drawn& drawn) {
    const int last = drawn.last_of_sky(), side = drawn.picture.width / 5;
    if (drawn.difference(0, 0, 0, last) < 12)
        return {"a sky whose color changes from the top to the horizon",
                "row 0 has the color " + color(drawn, 0, 0) + ", and row " + number(last) +
                    " still has " + color(drawn, 0, last),
                "In C++ row / height is 0, since both are whole numbers; (row + 0.5) / height has "
                "a fraction. And calculate `up` from the row, not from the column"};
    Finding finding;
    drawn.inside_of(Place::sky, [&](int column, int row, const Place&) {
        // Not near the middle, where a wrong disk may be.
        if (column > side && column < drawn.picture.width - side) return;
        if (!finding.expected.empty() || !drawn.differs_from_sky(column, row)) return;
        finding = {
            "a sky with a single color in each row",
            "in row " + number(row) + " column 0 is " + color(drawn, 0, row) + " and column " +
                number(column) + " is " + color(drawn, column, row),
            2 * row > last
                ? "A sphere hides the sky there. Are all signs right? offset is origin - "
                  "sphere.center, and both solutions begin with -b"
                : "Calculate `up` from the row, not from the column. And does `if (hit(...))` take "
                  "a miss for a hit? In C++ every number but 0 is true, -1 as well: ask whether "
                  "the result is greater than 0"};
    });
    return finding;
}

// The disk in words: the row where it begins, and the columns that it covers just
// above the horizon.
std::string disc_in_words(int top, int left, int right) {
    if (right < left) return "no disk";
    return "a disk whose top is in row " + number(top) + ", and which goes from column " +
           number(left) + " to column " + number(right) + " just above the horizon";
}

Finding disk(const Drawn& drawn) {
    const Picture& picture = drawn.picture;
    const int row = drawn.last_of_sky();
    const auto extent = [&](auto&& is_disc) {
        int top = picture.height, left = picture.width, right = -1;
        for (int y = 0; y <= row; ++y)
            for (int x = 0; x < picture.width; ++x) {
                if (!is_disc(x, y)) continue;
                top = std::min(top, y);
                if (y < row) continue;
                left = std::min(left, x);
                right = std::max(right, x);
            }
        return std::array{top, left, right};
    };
    const auto expected = extent([&](int x, int y) { return drawn.at(x, y).kind == Place::ball; });
    const auto actual = extent([&](int x, int y) { return drawn.differs_from_sky(x, y); });
    bool as_expected = true;
    for (std::size_t i = 0; i < 3; ++i)
        as_expected = as_expected && std::abs(expected[i] - actual[i]) <= 2;
    if (as_expected) return {};
    return {disc_in_words(expected[0], expected[1], expected[2]),
            disc_in_words(actual[0], actual[1], actual[2]),
            actual[2] < 0
                ? "The discriminant is b * b - 4 * a * c, where a is dot(direction, direction), b "
                  "is 2 * dot(offset, direction) and c is dot(offset, offset) minus the radius "
                  "squared. The direction is (right, up, -2), and the center is (0, 0, -4)"
                : "Lower rows have a smaller up. Both right and up are divided by the height, or "
                  "the disk is not round. The ball's center is (0, 0, -4), its radius is 1, and "
                  "the direction's third number is -2"};
}

// Compares the ball's pixels in some rows with the colors of their normals,
// whatever the brightness.
Finding normals(const Drawn& drawn, int first, int last, const std::string& what,
                const std::string& hint) {
    double worst = 0.06;
    Finding finding;
    drawn.inside_of(Place::ball, [&](int column, int row, const Place& here) {
        if (row < first || row > last) return;
        double most = 0, expected[3], most_expected = 0;
        for (int i = 0; i < 3; ++i) {
            expected[i] = (here.normal[i] + 1) / 2;
            most_expected = std::max(most_expected, expected[i]);
            most = std::max<double>(most, drawn.picture.at(column, row, i));
        }
        double error = most < 8 ? 1 : 0;  // nearly black
        for (int i = 0; i < 3 && error < 1; ++i)
            error = std::max(error, std::abs(drawn.picture.at(column, row, i) / most -
                                             expected[i] / most_expected));
        if (error <= worst) return;
        worst = error;
        std::string color_of_normal;
        for (const double channel : expected)
            color_of_normal += (color_of_normal.empty() ? "(" : ", ") + number(255 * channel);
        finding = {what + ": " + pixel_name(column, row) + " is " + color_of_normal +
                       ") or a darker shade of it",
                   "it is " + color(drawn, column, row), hint};
    });
    return finding;
}

Finding normals_above(const Drawn& drawn) {
    return normals(
        drawn, 0, drawn.last_of_sky(), "the upper part of the ball in the colors of its normals",
        "Red grows to the right with the normal's x, green grows upward with y, and blue grows "
        "toward you with z. The normal goes from the center to the point, not the other way, "
        "and the point is eye + t * direction with the smaller t");
}

Finding ground(const Drawn& drawn) {
    const int horizon = drawn.horizon(0), above = horizon - 3, below = horizon + 2;
    if (drawn.difference(0, above, 0, below) <
        std::max(20, 3 * drawn.difference(0, above - (below - above), 0, above)))
        return {
            "at the left edge, the sky in row " + number(above) + " and the ground in row " +
                number(below),
            "their colors are nearly the same: " + color(drawn, 0, above) + " and " +
                color(drawn, 0, below),
            "The ground is a sphere of radius 1000 around (0, -1001, -4). Do you go through both "
            "spheres, and is the normal divided by the radius?"};
    return normals(drawn, drawn.last_of_sky(), drawn.picture.height,
                   "the ball in front of the ground",
                   "If a ray meets both spheres, you see the nearer one: the smaller t, in "
                   "whatever order they are listed");
}

// How many pixels of a thing should be dark or lit, how many of these are not, and the first that
// is not. A pixel is dark if it has less than 85 % of the thing's highest brightness.
struct Shadow {
    int dark = 0, wrong_dark = 0, lit = 0, wrong_lit = 0;
    int column = -1, row = -1;
    bool should_be_dark = false;
    double dark_column = 0, dark_row = 0;  // the middle of the dark part, on the ground
};

Shadow shadow_on(const Drawn& drawn, Place::Kind kind) {
    const auto brightness = [&](int column, int row, const Place& here) {
        return drawn.sum(column, row) / (3 + here.normal[0] + here.normal[1] + here.normal[2]);
    };
    std::vector<double> all;
    drawn.inside_of(kind, [&](int column, int row, const Place& here) {
        all.push_back(brightness(column, row, here));
    });
    // Not the very brightest: a few specks of another color should not decide.
    const auto high = all.end() - 1 - static_cast<std::ptrdiff_t>(all.size() / 50);
    std::nth_element(all.begin(), high, all.end());
    Shadow shadow;
    int found = 0;
    drawn.inside_of(kind, [&](int column, int row, const Place& here) {
        const bool is_dark = brightness(column, row, here) < 0.85 * *high;
        ++(here.shadow ? shadow.dark : shadow.lit);
        if (is_dark) {
            ++found;
            shadow.dark_column += column;
            shadow.dark_row += row;
        }
        if (is_dark == here.shadow) return;
        ++(here.shadow ? shadow.wrong_lit : shadow.wrong_dark);
        if (shadow.column >= 0) return;
        shadow.column = column;
        shadow.row = row;
        shadow.should_be_dark = here.shadow;
    });
    shadow.dark_column /= std::max(found, 1);
    shadow.dark_row /= std::max(found, 1);
    return shadow;
}

Finding shadow(const Drawn& drawn) {
    for (const Place::Kind kind : {Place::ground, Place::ball}) {
        const Shadow shadow = shadow_on(drawn, kind);
        if (10 * shadow.wrong_lit < 3 * shadow.dark && 10 * shadow.wrong_dark < 6 * shadow.lit)
            continue;
        const char* const hint =
            "The light comes from the left, from above and from behind you: to_light is (-2, 2, "
            "1). A point is in shadow if a ray from the point in this direction meets any of the "
            "spheres: ask whether hit(...) is greater than 0, because a miss, -1, counts as true. "
            "For the point's own sphere, also look at the second t";
        if (kind == Place::ball)
            return {"the ball's lower right side, which is turned away from the light, is darker",
                    number(100.0 * shadow.wrong_lit / shadow.dark) + " % of it is as bright as " +
                        "the lit side, and " + number(100.0 * shadow.wrong_dark / shadow.lit) +
                        " % of the lit side is dark",
                    hint};
        double column = 0, row = 0;
        drawn.inside_of(kind, [&](int x, int y, const Place& here) {
            column += here.shadow ? x : 0;
            row += here.shadow ? y : 0;
        });
        const std::string actual = shadow.dark_column == 0
                                       ? "the ground has the same brightness everywhere"
                                       : "the dark part of the ground has its middle in column " +
                                             number(shadow.dark_column) + " of row " +
                                             number(shadow.dark_row);
        return {"the ball's shadow on the ground, with its middle in column " +
                    number(column / shadow.dark) + " of row " + number(row / shadow.dark),
                actual, hint};
    }
    return {};
}

struct Step {
    const char* name;
    Finding (*find)(const Drawn&);
};
constexpr Step steps[]{{"sky", sky},
                       {"disk", disk},
                       {"normals as colors", normals_above},
                       {"two spheres", ground},
                       {"shadow", shadow}};

// The program is in the folder that the environment names.
std::string program() {
    const char* const folder = std::getenv("COURSE_ANSWER");
    if (!folder) FAIL("the environment variable COURSE_ANSWER must name the folder of answer.00.1");
    return folder + std::string{"/answer.00.1"};
}

// The program runs once for all test cases. If it prints nothing, it is still to be written.
const checkpoint::Printed& printed() {
    static const checkpoint::Printed once = checkpoint::run_program(program());
    if (once.trouble.empty() && first::words(once.text, 1).empty()) {
        UNSCOPED_INFO("Hint: first.cpp prints nothing yet. Begin with step 1 of the text, the sky");
        rt::todo({"00.1", "exercises/00_toolchain/first.cpp", 1});
    }
    return once;
}

void expect(const Finding& finding) {
    if (finding.expected.empty())
        SUCCEED("as expected");
    else
        FAIL_CHECK("expected: " << finding.expected << "\nactual: " << finding.actual
                                << "\nHint: " << finding.hint);
}

// The picture is read once. `trouble` says what is wrong with it; empty if nothing is.
struct ReadPicture {
    std::string trouble = printed().trouble;
    Picture picture = trouble.empty() ? first::read_p3(printed().text, trouble) : Picture{};
};

const ReadPicture& read_picture() {
    static const ReadPicture once;
    return once;
}

Finding unreadable() {
    const Picture& picture = read_picture().picture;
    std::string trouble = read_picture().trouble;
    if (trouble.empty() && (picture.height < 60 || picture.width < picture.height ||
                            picture.width > 4 * picture.height))
        trouble = "it is " + number(picture.width) + " pixels wide and " + number(picture.height) +
                  " high";
    if (trouble.empty()) return {};
    return {
        "a P3 picture, 320 pixels wide and 180 high (or another size that is wider than high)",
        trouble,
        trouble.find("color value") == std::string::npos
            ? "The output starts with P3, the width, the height and 255; three whole numbers "
              "follow for each pixel, row by row"
            : "A color's components go from 0 to 1; int(255 * color.x) makes a whole number of a "
              "component. Write a space after each. A normal has length 1, so its components go "
              "from -1 to 1, and half of (normal + 1) goes from 0 to 1. Is t divided by (2 * a), "
              "in parentheses?"};
}

const Drawn& drawn() {
    static const Drawn once{unreadable().expected.empty() ? read_picture().picture : Picture{}};
    return once;
}

// A step counts only if all steps before it are done.
void check_picture(const std::function<Finding(const Drawn&)>& find) {
    if (const Finding finding = unreadable(); !finding.expected.empty()) return expect(finding);
    std::string reached;
    int count = 0;
    for (const Step& step : steps) {
        if (!step.find(drawn()).expected.empty()) break;
        reached += (reached.empty() ? " (" : ", ") + std::string(step.name);
        ++count;
    }
    INFO("The picture shows " << count << " of the 5 steps" << reached
                              << (reached.empty() ? "." : ")."));
    expect(find(drawn()));
}

}  // namespace

TEST_CASE("00.1 the program prints a P3 picture", "[00.1]") {
    expect(unreadable());
}

TEST_CASE("00.1 step 1 draws a sky whose color changes from the top to the horizon", "[00.1]") {
    check_picture(sky);
}

TEST_CASE("00.1 step 2 draws a round disk in the middle", "[00.1]") {
    check_picture(disk);
}

TEST_CASE("00.1 step 3 colors the ball by its normals", "[00.1]") {
    check_picture(normals_above);
}

TEST_CASE("00.1 step 4 draws the ball in front of the ground", "[00.1]") {
    check_picture(ground);
}

TEST_CASE("00.1 step 5 draws the ball's dark side and its shadow on the ground", "[00.1]") {
    check_picture(shadow);
}

TEST_CASE("00.1 the disk covers exactly the pixels whose middle lies in it", "[00.1][hard]") {
    check_picture([](const Drawn& drawn) -> Finding {
        int wrong = 0, edge = 0;
        for (int row = 0; row <= drawn.last_of_sky(); ++row)
            for (int column = 1; column < drawn.picture.width; ++column) {
                const bool is_ball = drawn.at(column, row).kind == Place::ball;
                edge += is_ball != (drawn.at(column - 1, row).kind == Place::ball);
                wrong += drawn.differs_from_sky(column, row) != is_ball;
            }
        // A color may by chance be close to the sky's.
        if (wrong <= edge / 10) return {};
        return {"a disk of exactly the pixels whose middle lies in it",
                number(wrong) + " pixels at the edge of the disk are wrong",
                "A ray goes through the middle of its pixel: (row + 0.5) and (column + 0.5), "
                "divided by the height"};
    });
}

TEST_CASE("00.1 light and shadow have correct edges and no specks", "[00.1][hard]") {
    check_picture([](const Drawn& drawn) -> Finding {
        for (const Place::Kind kind : {Place::ground, Place::ball}) {
            const Shadow shadow = shadow_on(drawn, kind);
            if (shadow.column < 0) continue;
            return {std::string("light and shadow without specks, with their edges in the right "
                                "place: ") +
                        pixel_name(shadow.column, shadow.row) +
                        (shadow.should_be_dark ? " is dark" : " is in the light"),
                    "it is not, and " + number(shadow.wrong_dark + shadow.wrong_lit - 1) +
                        " other pixels are wrong, too",
                    "Specks come from rays that meet the very sphere that they start from, at a t "
                    "of about 0: require t > 0.001. If the edges are wrong, check to_light"};
        }
        return {};
    });
}
