#include <array>
#include <cmath>
#include <companion/own/scenes.hpp>
#include <rt/rng.hpp>
#include <sstream>

namespace companion {
namespace {

// Writes a scene file line by line; `scale` multiplies all lengths.
class Writer {
  public:
    explicit Writer(double scale = 1) : scale_{scale} { text_.precision(12); }

    Writer& picture(int width = 64, int height = 36, int samples = 32, int depth = 50) {
        text_ << "picture " << width << ' ' << height << ' ' << samples << ' ' << depth << '\n';
        return *this;
    }
    Writer& camera(std::array<double, 3> from, std::array<double, 3> at, double fov_deg,
                   double aperture = 0, double focus = 1, std::array<double, 3> up = {0, 1, 0}) {
        text_ << "camera ";
        place(from);
        place(at);
        for (const double x : up) text_ << x << ' ';
        text_ << fov_deg << ' ' << aperture * scale_ << ' ' << focus * scale_ << '\n';
        return *this;
    }
    Writer& line(const std::string& text) {
        text_ << text << '\n';
        return *this;
    }
    Writer& word(const std::string& name, std::initializer_list<double> numbers) {
        text_ << name;
        for (const double number : numbers) text_ << ' ' << number;
        text_ << '\n';
        return *this;
    }
    Writer& sphere(std::array<double, 3> center, double radius) {
        text_ << "sphere ";
        place(center);
        text_ << radius * scale_ << '\n';
        return *this;
    }
    Writer& triangle(std::array<double, 3> a, std::array<double, 3> b, std::array<double, 3> c) {
        text_ << "triangle ";
        place(a);
        place(b);
        place(c);
        text_ << '\n';
        return *this;
    }
    std::string text() const { return text_.str(); }

  private:
    void place(const std::array<double, 3>& p) {
        for (const double x : p) text_ << x * scale_ << ' ';
    }
    double scale_;
    std::ostringstream text_;
};

// Random numbers for a scene, from anywhere in a range, so that they are never round.
class Any {
  public:
    Any(std::uint64_t seed, std::uint64_t scene) : random_{seed, scene} {}
    double operator()(double least, double most) {
        return least + (most - least) * static_cast<double>(random_.uniform());
    }
    std::array<double, 3> color(double least = 0.1, double most = 0.9) {
        return {(*this)(least, most), (*this)(least, most), (*this)(least, most)};
    }

  private:
    rt::Rng random_;
};

Writer& sky(Writer& scene, Any& any) {
    return scene.word(
        "sky", {any(0.6, 1), any(0.6, 1), any(0.6, 1), any(0.1, 0.6), any(0.2, 0.7), any(0.7, 1)});
}

Writer& matte(Writer& scene, Any& any) {
    const auto c = any.color();
    return scene.word("matte", {c[0], c[1], c[2]});
}

Writer& metal(Writer& scene, Any& any, double fuzz) {
    const auto c = any.color(0.6, 1);
    return scene.word("metal", {c[0], c[1], c[2], fuzz});
}

// Adds a ball that lies on the ground. The line before it in the file sets its material.
Writer& on_ground(Writer& scene, Any& any) {
    return scene.sphere({any(-0.4, 0.4), 1, any(-0.4, 0.4)}, 1);
}

Writer begin(Any& any, double scale = 1) {
    Writer scene{scale};
    scene.picture().camera({any(-4, 4), any(1, 3), any(4, 6)}, {any(-0.3, 0.3), 0.8, 0},
                           any(35, 55));
    sky(scene, any);
    matte(scene, any).sphere({0, -100, 0}, 100);
    return scene;
}

// A dark ground under a bright sky: there metal and glass differ most, so errors show most clearly.
Writer stage(Any& any, double scale = 1) {
    Writer scene{scale};
    scene.picture().camera({any(-1.5, 1.5), any(1, 1.8), any(3.4, 4)}, {0, 0.9, 0}, any(36, 44));
    scene.word("sky", {any(0.9, 1), any(0.9, 1), any(0.9, 1), any(0.6, 0.9), any(0.6, 0.9), 1});
    scene.word("matte", {0.03, 0.04, 0.03}).sphere({0, -100, 0}, 100);
    return scene;
}

std::string sky_only(Any& any) {
    Writer scene;
    scene.picture().camera({0, 0, 5}, {any(-1, 1), any(-1, 1), 0}, any(40, 100));
    return sky(scene, any).text();
}

// Black balls, which show where things are, but not how light is scattered.
std::string silhouettes(Any& any, bool tilted) {
    Writer scene;
    const std::array<double, 3> from{any(-9, 9), any(-5, 5), any(5, 9)},
        at{any(-1, 1), any(-1, 1), 0};
    if (tilted)  // a picture that is higher than wide, with a tilted camera
        scene.picture(54, 96).camera(from, at, any(25, 70), 0, 1, {any(0.5, 1), any(1, 2), 0.3});
    else
        scene.picture(96, 54).camera(from, at, any(25, 70));
    sky(scene, any).word("matte", {0, 0, 0});
    for (int i = 0; i < 5; ++i) scene.sphere({any(-3, 3), any(-2, 2), any(-3, 1)}, any(0.2, 0.9));
    return scene.text();
}

std::string one_matte(Any& any) {
    Writer scene = begin(any);
    matte(scene, any);
    return on_ground(scene, any).text();
}

// A ball on the ground; `ground` and `ball` are their radii.
std::string ball_on_ground(Any& any, std::array<double, 3> from, std::array<double, 3> at,
                           double ground, double ball) {
    Writer scene;
    scene.picture().camera(from, at, any(40, 50));
    sky(scene, any);
    matte(scene, any).sphere({0, -ground, 0}, ground);
    return matte(scene, any).sphere({0, ball, 0}, ball).text();
}

// A valley of bright balls: most light arrives only after several bounces.
std::string valley(Any& any, int depth) {
    Writer scene;
    scene.picture(64, 36, 32, depth).camera({0, 1.2, 5}, {0, 0.8, 0}, any(35, 50));
    sky(scene, any).word("matte", {0.9, 0.85, 0.8}).sphere({0, -100, 0}, 100);
    for (const double x : {-1.6, 0.0, 1.6}) scene.sphere({x, any(0.7, 0.8), any(-0.5, 0.5)}, 0.9);
    return scene.text();
}

// A file that leaves out all lines with a default, and has comments and empty lines.
std::string sparse(Any& any) {
    Writer scene;
    scene.line("# camera, sky and material are left out").picture().line("");
    scene.line("   # nothing but a comment").sphere({any(-0.5, 0.5), 0, 0}, any(0.8, 1.2));
    return scene.line("sphere 0 -101 0 100 # the ground").text();
}

// A file whose lines are each followed by another one of the same word.
std::string replaced(Any& any) {
    Writer scene;
    scene.picture(32, 64, 1, 1).camera({5, 5, 5}, {0, 0, 1}, 80, 0.5, 3, {1, 0, 0});
    sky(scene, any);
    scene.picture().camera({any(-2, 2), any(1, 2), 5}, {0, 0.5, 0}, any(35, 50));
    sky(scene, any);
    scene.word("matte", {0, 0, 0});
    matte(scene, any).sphere({0, -100, 0}, 100);
    return on_ground(scene, any).text();
}

std::string many_mattes(Any& any) {
    Writer scene = begin(any);
    for (int i = 0; i < 12; ++i) {
        const double radius = any(0.2, 0.7);
        matte(scene, any).sphere({any(-2, 2), radius, any(-3, 2)}, radius);
    }
    return scene.text();
}

std::string metals(Any& any, double least_fuzz, double most_fuzz) {
    Writer scene = stage(any);
    metal(scene, any, any(least_fuzz, most_fuzz));
    on_ground(scene, any);
    return matte(scene, any).sphere({any(-2.5, -1.5), 0.5, any(0.5, 1)}, 0.5).text();
}

std::string glass(Any& any, bool hollow, double least = 1.2, double most = 2.3, double scale = 1) {
    Writer scene = stage(any, scale);
    const double index = any(least, most), x = any(-0.4, 0.4);
    scene.word("glass", {index}).sphere({x, 1, 0}, 1);
    if (hollow) scene.word("glass", {1 / index}).sphere({x, 1, 0}, any(0.7, 0.95));
    return matte(scene, any).sphere({any(-2.5, -1.5), 0.5, any(-1, 1)}, 0.5).text();
}

std::string lens(Any& any) {
    Writer scene;
    const double focus = any(4, 6);
    scene.picture().camera({0, any(0.5, 2), 5}, {0, 0.6, 0}, any(35, 50), any(0.3, 0.9), focus);
    sky(scene, any);
    matte(scene, any).sphere({0, -100, 0}, 100);
    for (int i = 0; i < 8; ++i) matte(scene, any).sphere({any(-3, 3), 0.5, any(-6, 3)}, 0.5);
    return scene.text();
}

std::string crowd_of(std::uint64_t seed, int width, int height, int spheres, bool twins) {
    Any any{seed, 90};
    Writer scene;
    scene.picture(width, height, 1).camera({any(-20, 20), any(15, 25), 55}, {0, 0, 0}, any(35, 45));
    sky(scene, any);
    for (int i = 0; i < spheres; ++i) {
        const double kind = any(0, 1);
        const std::array<double, 3> center{any(-25, 25), any(-12, 12), any(-25, 25)};
        const double radius = any(0.05, 0.5);
        for (int again = 0; again < (twins && i % 2 == 0 ? 2 : 1); ++again) {
            if (kind < 0.7)
                matte(scene, any);
            else if (kind < 0.9)
                metal(scene, any, any(0, 0.5));
            else
                scene.word("glass", {any(1.3, 1.8)});
            scene.sphere(center, radius);
        }
    }
    return scene.text();
}

// Triangles of various shapes; every second one is seen from behind.
std::string black_triangles(Any& any) {
    Writer scene;
    scene.picture().camera({any(-2, 2), any(-2, 2), 7}, {0, 0, 0}, any(35, 50));
    sky(scene, any).word("matte", {0, 0, 0});
    for (int i = 0; i < 6; ++i) {
        const std::array<double, 3> a{any(-3, 0), any(-2, 0), any(-2, 2)},
            b{any(0, 3), any(-2, 0), any(-2, 2)}, c{any(-1, 1), any(0.2, 2), any(-2, 2)};
        i % 2 == 0 ? scene.triangle(a, b, c) : scene.triangle(a, c, b);
    }
    return scene.text();
}

// Two leaning sheets on the ground: the camera sees the front of one and the back of the other.
Writer sheets(Any& any) {
    Writer scene = begin(any);
    for (const bool back : {false, true}) {
        const double x = back ? 0.2 : -1.6;
        const std::array<double, 3> a{x, 0.02, any(0.3, 0.6)}, b{x + 1.4, 0.02, any(0.3, 0.6)},
            c{x + 0.7, any(1.3, 1.6), any(-0.4, -0.2)};
        matte(scene, any);
        back ? scene.triangle(a, c, b) : scene.triangle(a, b, c);
    }
    return scene;
}

// Triangles without area, of the kinds in which a program may divide 0 by 0.
std::string without_area(Any& any) {
    Writer scene = sheets(any);
    const std::array<double, 3> a{any(-1, 1), 1, any(0, 1)}, b{any(-1, 1), 0.5, any(0, 1)};
    const std::array<double, 3> on_line{2 * b[0] - a[0], 2 * b[1] - a[1], 2 * b[2] - a[2]};
    matte(scene, any).triangle(a, a, a).triangle(b, b, b);
    return scene.triangle(a, a, b).triangle(a, b, a).triangle(a, b, on_line).text();
}

// How a file names a point: by its index, by its index followed by slashes and other indices, or by
// its index counted from the end.
enum class Index { plain, slashes, from_the_end };

// A closed vase around the y axis, made of polygons whose corners run counterclockwise as seen from
// outside: quadrilaterals, and a lid and a bottom with as many corners as the vase has sides.
std::string vase(Any& any, int sides, int rings, Index index) {
    std::ostringstream text;
    text.precision(12);
    text << "# a vase\no vase\n";
    for (int ring = 0; ring < rings; ++ring) {
        const double radius = any(0.5, 0.9), y = 0.02 + 1.6 * ring / (rings - 1);
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * 3.14159265358979 * side / sides;
            text << "v " << radius * std::cos(angle) << ' ' << y << ' ' << radius * std::sin(angle)
                 << '\n';
        }
    }
    if (index == Index::slashes) text << "vt 0.5 0.5\nvn 0 1 0\ns off\n";
    int polygons = 0;
    const auto polygon = [&](const std::vector<int>& corners) {
        text << 'f';
        for (const int corner : corners) {
            text << ' ' << (index == Index::from_the_end ? corner - sides * rings : corner + 1);
            if (index == Index::slashes) text << (polygons % 2 == 0 ? "/1/1" : "//1");
        }
        text << '\n';
        ++polygons;
    };
    std::vector<int> bottom, lid;
    for (int side = 0; side < sides; ++side) {
        bottom.push_back(side);
        lid.insert(lid.begin(), (rings - 1) * sides + side);
    }
    polygon(bottom);
    polygon(lid);
    for (int ring = 0; ring + 1 < rings; ++ring)
        for (int side = 0; side < sides; ++side) {
            const int here = ring * sides + side, next = ring * sides + (side + 1) % sides;
            polygon({next, here, here + sides, next + sides});
        }
    return text.str();
}

OwnScene matte_mesh(Any& any) {
    Writer scene = begin(any);
    matte(scene, any).line("mesh shape.obj");
    return {"a mesh of polygons", scene.text(),
            "Is every polygon cut into all of its triangles? -1 names the last point so far.",
            vase(any, 7, 5, Index::from_the_end)};
}

OwnScene glass_mesh(Any& any) {
    Writer scene = stage(any);
    scene.word("glass", {any(1.3, 1.6)}).line("mesh shape.obj");
    matte(scene, any).sphere({any(-2.5, -1.8), 0.5, any(-1, 1)}, 0.5);
    return {"a mesh of glass", scene.text(),
            "A triangle's outside is where its corners run counterclockwise: "
            "cross(b - a, c - a) points there. Both sides are hit.",
            vase(any, 9, 4, Index::slashes)};
}

}  // namespace

OwnScene shared_corner(std::uint64_t seed) {
    Any any{seed, 110};
    const std::array<double, 3> corner{any(-1, 1), any(-1, 1), any(-1, 1)},
        from{corner[0] + any(-2, 2), corner[1] + any(-2, 2), corner[2] + any(4, 6)};
    Writer scene;  // the corner is the tip of a pyramid that points at the camera
    scene.picture(64, 36, 16, 1).camera(from, corner, 1e-12);
    scene.word("sky", {1, 1, 1, 1, 1, 1}).word("matte", {0, 0, 0});
    const int sides = 7;
    std::vector<std::array<double, 3>> base;
    for (int side = 0; side < sides; ++side) {
        const double angle = 2 * 3.14159265358979 * (side + any(0, 0.5)) / sides;
        base.push_back(
            {corner[0] + std::cos(angle), corner[1] + std::sin(angle), corner[2] - any(0.2, 0.5)});
    }
    for (int side = 0; side < sides; ++side) {
        const auto &here = base[side], &next = base[(side + 1) % sides];
        side % 2 == 0 ? scene.triangle(corner, here, next) : scene.triangle(here, corner, next);
    }
    return {"no ray between two triangles", scene.text(), ""};
}

OwnScene fine_mesh(std::uint64_t seed, int width) {
    Any any{seed, 111};
    Writer scene;
    scene.picture(width, width * 9 / 16, 1).camera({any(-1, 1), any(1, 2), 4}, {0, 0.8, 0}, 40);
    sky(scene, any);
    matte(scene, any).sphere({0, -100, 0}, 100);
    metal(scene, any, any(0.1, 0.5)).line("mesh shape.obj");
    return {"a mesh of 10,000 triangles", scene.text(), "", vase(any, 100, 50, Index::plain)};
}

std::vector<OwnScene> broken_meshes() {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", scene = "mesh shape.obj\n";
    return {{"a mesh file that is not there", scene, ""},
            {"a corner that names no point", scene, "", corners + "f 1 2 4\n"},
            {"the corner 0", scene, "Points are counted from 1.", corners + "f 0 1 2\n"},
            {"a corner from before the first point", scene, "", corners + "f -1 -2 -4\n"},
            {"a polygon of two corners", scene, "", corners + "f 1 2\n"},
            {"a word for a coordinate", scene, "", corners + "v 0 zero 1\nf 1 2 3\n"},
            {"a triangle with a number too few", "triangle 0 0 0 1 0 0 0 1\n", ""}};
}

std::string crowd(std::uint64_t seed, int width, int height, int spheres) {
    return crowd_of(seed, width, height, spheres, false);
}

std::string crowd_with_twins(std::uint64_t seed, int width, int height) {
    return crowd_of(seed, width, height, 10'000, true);
}

std::string some_of_all(std::uint64_t seed) {
    Any any{seed, 92};
    Writer scene;
    scene.picture(32, 18, 4, 12).camera({any(-1, 1), 1.5, 5}, {0, 0.7, 0}, 40, 0.2, 5);
    sky(scene, any);
    matte(scene, any).sphere({0, -100, 0}, 100).sphere({-2.2, 0.8, any(-1, 1)}, 0.8);
    scene.word("glass", {1.5}).sphere({0, 1, 0}, 1).word("glass", {1 / 1.5});
    scene.sphere({0, 1, 0}, 0.8);
    return metal(scene, any, any(0.5, 1)).sphere({2.2, 0.9, 0}, 0.9).text();
}

std::string accuracy_scene(std::uint64_t seed) {
    Any any{seed, 91};
    return glass(any, true);
}

std::vector<TaskStep> task_steps(std::uint64_t seed) {
    std::vector<TaskStep> steps;
    std::uint64_t number = 0;
    // Makes a scene with its own random numbers.
    const auto scene = [&](const char* name, auto make, const char* suggestion, auto... more) {
        Any any{seed, ++number};
        return OwnScene{name, make(any, more...), suggestion};
    };
    const auto add = [&](const char* title, std::vector<OwnScene> scenes) {
        steps.push_back({static_cast<int>(steps.size()) + 1, title, std::move(scenes)});
    };
    add("a sky", {scene("a sky and nothing else", sky_only,
                        "Is the direction normalized before its y mixes the two colors? Is the "
                        "first row of the file the top row? Are the bytes sRGB, not linear? Is the "
                        "sky seen through the scene's camera and random points of each pixel?")});
    add("a camera, and spheres in black",
        {scene(
             "black balls before the sky", silhouettes,
             "Is the field of view the vertical one, in radians, and do you take the tangent of "
             "half of it? Do u, v and w make a right-handed basis? Does every sample lie somewhere "
             "in its pixel?",
             false),
         scene("black balls and a tilted camera", silhouettes,
               "Does the camera stand at `from`, look at `at`, and keep `up` upright?", true)});
    add("matte",
        {scene("one matte ball on the ground", one_matte,
               "Is the new direction cosine-weighted around the normal, on the side that the ray "
               "came from, and of length 1? Does each bounce multiply the light by the color? Does "
               "the ray not hit the surface that it leaves?"),
         scene("paths of one bounce", valley,
               "A path that has bounced once and hits something again brings no light: neither the "
               "sky nor a second bounce.",
               1),
         scene("paths of three bounces", valley,
               "How many times does the loop run? A path that never hits anything has bounced 0 "
               "times.",
               3)});
    add("the nearest of many",
        {scene(
             "a dozen matte balls", many_mattes,
             "Does the nearest hit count, whatever the order of the spheres in the file? Has each "
             "sphere the last material above it?"),
         scene("a file that leaves out most lines", sparse,
               "Do you use the defaults of TASK.md, skip comments, which begin with #, and ignore "
               "empty lines?"),
         scene("lines that replace earlier ones", replaced,
               "A second picture, camera or sky line takes the place of the first, with all of its "
               "numbers.")});
    add("metal",
        {scene("a mirror", metals,
               "Is its material metal, and not matte? Is the direction d - 2 (d . n) n?", 0.0, 0.0),
         scene("a fuzzy metal ball", metals,
               "Is the fuzz that of the scene? Is a direction below the surface mirrored "
               "back up, so that no light is lost? Is the random direction on the unit sphere, not "
               "inside it?",
               0.4, 0.8)});
    add("glass",
        {scene("a glass ball", glass,
               "Is its material glass, and not matte? On the way out, is the ratio of indices "
               "inverted, and the normal turned toward the ray? Is the reflectance exact, and "
               "does a random number choose between reflection and refraction?",
               false, 1.3, 1.7, 1.0),
         scene("a hollow glass ball", glass,
               "The inner ball is air in glass: its index is that of air divided by that of glass.",
               true, 1.3, 1.7, 1.0),
         scene("glass of an index near 1", glass,
               "Schlick's formula reflects far too much here. Use the Fresnel equations, and the "
               "mean of both polarizations.",
               false, 1.04, 1.1, 1.0)});
    add("a lens",
        {scene("balls in front of and behind the focus", lens,
               "Is the position on the lens uniform over the disk (the square root!), is the "
               "aperture its diameter, and do all rays of a sample point meet at `focus`?")});
    add("all cores", {});
    add("10,000 spheres",
        {{"10,000 spheres of all materials", crowd(seed, 48, 27),
          "Is the picture the same with --list? If so, the mistake is not in the tree."}});
    add("triangles",
        {scene("black triangles before the sky", black_triangles,
               "Does a triangle count from both sides? A hit lies ahead of the ray, and inside of "
               "all three edges."),
         scene(
             "two matte sheets", [](Any& any) { return sheets(any).text(); },
             "Does the normal point to the side that the ray came from?"),
         scene("triangles without area", without_area,
               "0 / 0 is not a number, and every comparison with it is false. Does your "
               "condition then report a miss, as it should?")});
    Any any{seed, ++number};
    steps.back().scenes.push_back(matte_mesh(any));
    steps.back().scenes.push_back(glass_mesh(any));
    return steps;
}

OwnScene lit_balls(std::uint64_t seed) {
    Any any{seed, 120};
    Writer scene = begin(any);
    // The light comes from (-2, 2, 1), so the smaller ball's shadow falls on the larger one.
    const double x = any(0.1, 0.4), radius = any(0.25, 0.35);
    matte(scene, any).sphere({x, 0.8, 0}, 0.8);
    matte(scene, any).sphere({x - 1.3, 2 - radius, 0.65}, radius);
    matte(scene, any).sphere({x + any(1.1, 1.3), 0.4, any(0.7, 0.9)}, 0.4);
    return {"colored balls in the light", scene.text(),
            "A sphere's own color is multiplied by (1 + dot(normal, to_light)) / 2, and in shadow "
            "by 0.4, too. Does the normal point away from the center? Does the ray to the light "
            "start at the point that is hit, with an interval from 0.001 on?"};
}

std::vector<OwnScene> hard_scenes(std::uint64_t seed) {
    std::vector<OwnScene> scenes;
    const auto add = [&](const char* name, const std::string& text, const char* suggestion) {
        scenes.push_back({name, text, suggestion});
    };
    {
        Any any{seed, 101};
        Writer scene;  // through a narrow lens
        scene.picture().camera({0, 0, 1e8}, {0, 0, 0}, 1.5e-6);
        sky(scene, any);
        matte(scene, any).sphere({0, 0, 0}, 1);
        add("a ball seen from a hundred million radii away", scene.text(),
            "b * b - 4ac suffers from cancellation: compute the distance of the center from the "
            "ray's line first.");
    }
    {
        Any any{seed, 108};
        Writer scene;
        matte(scene, any).sphere({any(-0.5, 0.5), 0, 0}, any(0.5, 0.8));
        add("a file without a picture line", scene.text(),
            "Without it, the picture has 400 x 225 pixels, 16 samples and depth 50.");
    }
    {
        Any any{seed, 102};
        add("a ground of radius a million", ball_on_ground(any, {0, 1.5, 4}, {0, 0.5, 0}, 1e6, 0.6),
            "A fixed tolerance is too small here: the ray hits the ground that it leaves.");
    }
    {
        Any any{seed, 103};
        add("a ball of radius 1/1000",
            ball_on_ground(any, {0, 0.002, 0.006}, {0, 0.0008, 0}, 0.1, 0.001),
            "A fixed tolerance is too large here: it skips hits nearer than the tolerance.");
    }
    for (const double scale : {1e-3, 1e3}) {
        Any any{seed, 104};
        add(scale < 1 ? "a hollow glass ball, scaled by 1/1000"
                      : "a hollow glass ball, scaled by 1000",
            glass(any, true, 1.2, 2.3, scale), "Do not compare a length with a fixed number.");
    }
    {
        Any any{seed, 105};
        Writer scene = begin(any);
        const double index = any(1.3, 1.7);
        for (int i = 0; i < 4; ++i)
            scene.word("glass", {i % 2 == 0 ? index : 1 / index}).sphere({0, 1, 0}, 1 - 0.2 * i);
        add("glass in air in glass in air", scene.text(),
            "At each ball, a ray is refracted with that ball's own ratio of indices.");
    }
    {
        Any any{seed, 106};
        Writer scene;
        scene.picture().camera({0, 1, 0.2}, {any(-0.5, 0.5), 1, -3}, any(60, 90));
        sky(scene, any).word("glass", {any(1.3, 1.7)}).sphere({0, 1, 0}, 0.8);
        matte(scene, any).sphere({0, -100, 0}, 100);
        matte(scene, any).sphere({0, 1, -4}, 1);
        add("seen from inside a glass ball", scene.text(),
            "Do you ignore the hit behind the camera, and take the farther one?");
    }
    {
        Any any{seed, 107};
        Writer scene;  // no light is absorbed, so any light lost or created shows
        scene.picture().camera({0, 0.5, 4}, {0, 0, 0}, any(35, 45));
        scene.word("sky", {0.7, 0.7, 0.7, 0.7, 0.7, 0.7});
        scene.word("matte", {1, 1, 1}).sphere({-1.1, 0, 0}, 0.6);
        scene.word("metal", {1, 1, 1, 1}).sphere({0, 0, 0}, 0.6);
        scene.word("glass", {any(1.3, 2)}).sphere({1.1, 0, 0}, 0.6);
        add("white balls under an even sky", scene.text(),
            "They should be invisible: wherever you see them, light was lost or created.");
    }
    return scenes;
}

std::vector<OwnScene> broken_scenes() {
    const std::string fine = "picture 8 8 1 5\ncamera 0 0 5 0 0 0 0 1 0 40 0 1\nsky 1 1 1 1 1 1\n";
    return {{"an unknown word", fine + "cube 0 0 0 1\n", ""},
            {"a word for a number", fine + "sphere 0 0 zero 1\n", ""},
            {"a number too few", fine + "sphere 0 0 1\n", ""},
            {"a number too many", fine + "sphere 0 0 0 1 7\n", ""},
            {"a radius below 0", fine + "sphere 0 0 0 -1\n", ""},
            {"a picture without pixels", "picture 0 8 1 5\n", ""},
            {"a camera that looks at itself", "camera 0 0 5 0 0 5 0 1 0 40 0 1\n", ""},
            {"a color above 1", fine + "matte 0.5 1.5 0.5\n", ""},
            {"a fuzz above 1", fine + "metal 1 1 1 2\n", ""},
            {"nan for a number", fine + "sphere 0 0 0 nan\n", ""}};
}

std::vector<Limits> broken_limits() {
    return {{"a picture outside its limits",
             {"picture 10001 1 1 1\n", "picture 8 8.5 1 1\n", "picture 8 8 0 1\n",
              "picture 8 8 1 0\n", "picture 8 8 1 -1\n"}},
            {"a camera outside its limits",
             {"camera 0 0 5 0 0 0 0 1 0 0 0 1\n", "camera 0 0 5 0 0 0 0 1 0 180 0 1\n",
              "camera 0 0 5 0 0 0 0 1 0 40 -1 1\n", "camera 0 0 5 0 0 0 0 1 0 40 0 0\n",
              "camera 0 0 5 0 0 0 0 0 2 40 0 1\n"}},
            {"a material outside its limits",
             {"glass 0\n", "glass -1.5\n", "metal 1 1 1 -0.5\n", "matte 0.5 -0.5 0.5\n",
              "sky 1 1 1 1 2 1\n"}},
            {"a number that is not decimal",
             {"sphere 0 0 0 inf\n", "sphere 0 0 0 0x10\n", "sphere 0 0 infinity 1\n"}}};
}

std::vector<BrokenCall> broken_calls() {
    return {{"no words at all", {}},
            {"a missing scene file", {"not-there.txt", "out.ppm"}},
            {"a missing folder for the picture", {"/dev/null", "not-there/out.ppm"}},
            {"a word for the number of threads", {"/dev/null", "out.ppm", "--threads", "many"}},
            {"no threads", {"/dev/null", "out.ppm", "--threads", "0"}},
            {"an option that there is not", {"/dev/null", "out.ppm", "--sed", "1"}},
            {"an option without its number", {"/dev/null", "out.ppm", "--seed"}},
            {"a third file", {"/dev/null", "out.ppm", "more.ppm"}}};
}

}  // namespace companion
