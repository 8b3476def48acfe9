// The reader of scene files: what it makes of good ones, and what it says about bad ones.
#include <scene_file.hpp>

#include <sys/stat.h>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <cmath>
#include <placing.hpp>
#include <rt/image_file.hpp>
#include <rt/prepare.hpp>
#include <rt/sky.hpp>
#include <rt/transform.hpp>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;
using checkpoint::Real;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;
using rt::Color;
using rt::Vec3;

namespace {

const std::string camera = R"("camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0]})";
const std::string materials = R"("materials": {"gold": {"type": "metal", "color": "#ffcc66"}})";

// A scene with one more member than it needs.
std::string with(const std::string& member) {
    return "{" + camera + ", " + materials + ", " + member + "}";
}
std::string with_spheres(const std::string& spheres) {
    return with("\"spheres\": [" + spheres + "]");
}
std::string with_group(const std::string& members) {
    return with(R"("groups": [{"rule": "plane", "count": 5, "extent": 9, "radius": 0.1, )"
                R"("materials": ["gold"])" +
                members + "}]");
}
std::string with_material(const std::string& material) {
    return "{" + camera + R"(, "materials": {"m": )" + material + "}}";
}
std::string with_camera(const std::string& members) {
    return R"({"camera": {)" + members + "}, " + materials + "}";
}

// What is said about a text; nothing if it is taken. It must be one line that begins with the name.
std::string refusal(const std::string& text, const fs::path& folder = ".") {
    try {
        effects::parse_scene(text, "s.json", folder, {.spheres = 1000, .image_pixels = 64});
        return "";
    } catch (const app::UsageError& error) {
        const std::string said = error.what();
        INFO(said);
        CHECK(said.rfind("s.json", 0) == 0);
        CHECK(said.find('\n') == std::string::npos);
        CHECK(said.size() < 400);
        return said;
    }
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// Each of these is refused with words that tell the place and what is allowed.
#define REFUSED(text, place, allowed)           \
    do {                                        \
        const std::string said = refusal(text); \
        INFO("said: " << said);                 \
        CHECK(holds(said, place));              \
        CHECK(holds(said, allowed));            \
    } while (false)

}  // namespace

TEST_CASE("a scene file becomes the scene that it describes", "[scene_file]") {
    const auto scene = effects::parse_scene(R"({
        "camera": {"look_from": [1, 2, 3], "look_at": [1, 2, 0], "up": [1, 0, 0], "vfov_deg": 90,
                   "lens": {"aperture": 0.5}, "shutter": 2},
        "sky": {"below": "#000000", "above": [0.5, 1, 8]},
        "fog": {"center": [0, 1, 0], "radius": 5, "density": 0.25, "asymmetry": -0.5},
        "haze": {"density": 0.125, "color": [2, 1, 0.5]},
        "textures": {"board": {"type": "checker", "even": "#ffffff", "odd": "#000000", "size": 2}},
        "materials": {
            "unused": {"type": "matte", "color": "#000000"},
            "tiles": {"type": "matte", "texture": "board"},
            "glass": {"type": "glass"},
            "lamp": {"type": "light", "color": [1, 0.5, 0], "strength": 4},
            "mine": {"type": "own", "color": [1, 0, 0.5], "amount": 0.25},
            "plain": {"type": "own", "color": [1, 1, 1]}},
        "spheres": [
            {"center": [0, 0, 0], "radius": 2, "material": "tiles"},
            {"center": [4, 0, 0], "radius": 1, "material": "glass", "velocity": [0, 3, 0]},
            {"center": [8, 0, 0], "radius": 1, "material": "lamp"},
            {"center": [9, 9, 0], "radius": 1, "material": "glass"},
            {"center": [9, 0, 0], "radius": 1, "material": "mine"},
            {"center": [9, 4, 0], "radius": 1, "material": "plain"}],
        "render": {"width": 30, "height": 20, "spp": 7, "depth": 3, "seed": 9007199254740992}})",
                                            "s.json", ".");
    CHECK(scene.camera.view.from == Vec3{1, 2, 3});
    CHECK(scene.camera.view.up == Vec3{1, 0, 0});
    CHECK(scene.camera.view.vertical_fov == rt::radians(90));
    CHECK(scene.camera.lens.aperture == Real(0.5));
    CHECK(scene.camera.lens.focus_distance == 3);  // what the camera looks at is sharp
    CHECK(scene.camera.shutter == 2);
    CHECK(scene.sky.above == Color{Real(0.5), 1, 8});
    REQUIRE(scene.fog);
    CHECK(scene.fog->region.radius == 5);
    CHECK(scene.fog->density == Real(0.25));
    CHECK(scene.fog->asymmetry == Real(-0.5));
    REQUIRE(scene.haze);
    CHECK(scene.haze->density == Real(0.125));
    CHECK(scene.haze->color == Color{2, 1, Real(0.5)});
    // Only what spheres are made of, in their order.
    REQUIRE(scene.materials.size() == 5);
    CHECK(std::get<rt::CheckeredMatte>(scene.materials[0]).size == 2);
    CHECK(std::get<rt::Dielectric>(scene.materials[1]).index == Real(1.5));
    CHECK(std::get<rt::Emitter>(scene.materials[2]).radiance == Color{4, 2, 0});
    CHECK(std::get<rt::OwnMaterial>(scene.materials[3]).color == Color{1, 0, Real(0.5)});
    CHECK(std::get<rt::OwnMaterial>(scene.materials[3]).amount == Real(0.25));
    CHECK(std::get<rt::OwnMaterial>(scene.materials[4]).amount == Real(0.5));
    REQUIRE(scene.spheres.size() == 6);
    CHECK(scene.spheres[1].velocity == Vec3{0, 3, 0});
    CHECK(scene.spheres[3].material == 1);
    CHECK(scene.settings.width == 30);
    CHECK(scene.settings.samples_per_pixel == 7);
    CHECK(scene.settings.seed == std::uint64_t{1} << 53);
}

TEST_CASE("a sphere with scale, rotate_deg or matrix gets a map", "[scene_file]") {
    const auto scene =
        effects::parse_scene(with_spheres(R"({"center": [0, 0, 0], "radius": 1, "material": "gold"},
            {"center": [1, 2, 3], "radius": 2, "scale": [1, 0.5, 3], "rotate_deg": [0, 0, 90],
             "material": "gold"},
            {"matrix": [[1, 0, 4, 5], [0, 2, 0, 6], [0, 0, 3, 7]], "material": "gold"},
            {"center": [0, 0, 0], "radius": 1, "rotate_deg": [90, 90, 0], "material": "gold"})"),
                             "s.json", ".");
    REQUIRE(scene.spheres.size() == 4);
    REQUIRE(scene.maps.size() == 3);
    CHECK(scene.spheres[0].map == -1);
    for (int i = 0; i < 3; ++i) CHECK(scene.spheres[static_cast<std::size_t>(i) + 1].map == i);
    const auto is_near = [](Vec3 a, Vec3 b) {
        return max_component(a - b) <= 32 * rt::epsilon * max_component(b);
    };
    // The x axis, twice as long, is turned to the y axis; y, as long as it was, to -x.
    CHECK(is_near(transform_point(scene.maps[0], {1, 0, 0}), {1, 4, 3}));
    CHECK(is_near(transform_point(scene.maps[0], {0, 1, 0}), {0, 2, 3}));
    CHECK(is_near(transform_point(scene.maps[0], {0, 0, 1}), {1, 2, 9}));
    CHECK(transform_point(scene.maps[1], {0, 0, 1}) == Vec3{9, 6, 10});
    // Around x first: y goes to z, and then, around y, to x.
    CHECK(is_near(transform_vector(scene.maps[2], {0, 1, 0}), {1, 0, 0}));
    // The sphere around it holds it.
    CHECK(scene.spheres[2].shape.radius >= 5);
    CHECK(scene.spheres[2].shape.center == Vec3{5, 6, 7});
}

TEST_CASE("bad maps are refused", "[scene_file]") {
    const auto placed = [](const std::string& members) {
        return with_spheres("{" + members + R"(, "material": "gold"})");
    };
    const std::string ball = R"("center": [0, 0, 0], "radius": 1, )";
    REFUSED(placed(R"("matrix": [[1, 0, 0, 0], [0, 0, 0, 0], [0, 0, 1, 0]])"), "spheres[0].matrix",
            "singular");
    REFUSED(placed(R"("matrix": [[1, 2, 3, 0], [4, 5, 6, 0], [7, 8, 9, 0]])"), "spheres[0].matrix",
            "singular");
    REFUSED(placed(R"("matrix": [[1, 0, 0, 0], [0, 1e-300, 0, 0], [0, 0, 1, 0]])"),
            "spheres[0].matrix", "singular");
    REFUSED(placed(R"("matrix": [[1, 0, 0, 0], [0, 1, 0, 0]])"), "spheres[0].matrix",
            "three rows, not of 2");
    REFUSED(placed(R"("matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1]])"), "spheres[0].matrix[2]",
            "four numbers, not of 3");
    REFUSED(placed(ball + R"("matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])"), "spheres[0]",
            "has both matrix and center");
    REFUSED(placed(ball + R"("scale": [1, 0, 1])"), "spheres[0].scale[1]", "0.001 to 1000");
    REFUSED(placed(ball + R"("rotate_deg": [1, 0, 999])"), "spheres[0].rotate_deg[2]",
            "-360 to 360");
    REFUSED(placed(ball + R"("scale": [1, 2, 1], "velocity": [1, 0, 0])"), "spheres[0].velocity",
            "does not move");
    REFUSED("{" + camera + R"(, "materials": {"lamp": {"type": "light", "color": [1, 1, 1]}},
        "spheres": [{"center": [0, 0, 0], "radius": 1, "scale": [1, 2, 1], "material": "lamp"}]})",
            "spheres[0].material", "a light is a plain sphere");
}

TEST_CASE("what a scene file leaves out has a good default", "[scene_file]") {
    const auto scene = effects::parse_scene("{" + camera + ", " + materials + "}", "s.json", ".");
    const rt::RenderSettings usual;
    CHECK(scene.settings.width == usual.width);
    CHECK(scene.spheres.empty());
    CHECK(scene.camera.lens.aperture == 0);
    CHECK_FALSE(scene.fog.has_value());
    CHECK_FALSE(scene.haze.has_value());
    CHECK(scene.sky.above != Color{});
}

TEST_CASE("the shipped scenes can be read", "[scene_file]") {
    const fs::path folder = fs::path{COURSE_ROOT} / "chapters/08_effects/scenes";
    int count = 0;
    for (const auto& entry : fs::directory_iterator{folder}) {
        if (entry.path().extension() != ".json") continue;
        INFO(entry.path());
        CHECK_FALSE(effects::read_scene(entry.path()).spheres.empty());
        ++count;
    }
    CHECK(count >= 8);
    CHECK(effects::read_scene(folder / "cover.json").spheres.size() == 486);
    CHECK(effects::read_scene(folder / "textures.json").images.size() == 1);
}

TEST_CASE("a file that cannot be read is refused", "[scene_file]") {
    const TemporaryFolder folder;
    const auto said = [&](const fs::path& path) -> std::string {
        try {
            effects::read_scene(path);
            return "";
        } catch (const app::UsageError& error) {
            CHECK(std::string{error.what()}.rfind(path.string(), 0) == 0);
            return error.what();
        }
    };
    CHECK(holds(said(folder / "missing.json"), "does not exist"));
    CHECK(holds(said(folder / "missing/missing.json"), "does not exist"));
    CHECK(holds(said(folder.path()), "is a folder"));
    CHECK(holds(said("/dev/null"), "name a regular file"));
    REQUIRE(::mkfifo((folder / "pipe.json").c_str(), 0600) == 0);
    CHECK(holds(said(folder / "pipe.json"), "name a regular file"));
    fs::create_symlink("loop.json", folder / "loop.json");
    CHECK(holds(said(folder / "loop.json"), "cannot be read"));
    write_file(folder / "empty.json", "");
    CHECK(holds(said(folder / "empty.json"), "is empty"));
    write_file(folder / "large.json", std::string(app::max_json_bytes + 1, ' '));
    CHECK(holds(said(folder / "large.json"), " 64 MiB are allowed"));
}

TEST_CASE("what is not JSON is refused with line and column", "[scene_file]") {
    REFUSED(" \n ", "s.json is empty", "{ ... }");
    REFUSED("hello", "s.json:1:1: ", "are allowed");
    REFUSED("{\n  \"camera\": ", "s.json:2:1", "expected");
    REFUSED("{\"a\": 1,\n}", "s.json:2:1: ", "one comma too many before }");
    REFUSED("{\"a\": 1} 2", "s.json:1:10: ", "expected end of input");
    REFUSED("{\"a\": NaN}", "s.json:1:7: ", "are allowed");
    REFUSED("{\"a\": Infinity}", "s.json:1:7: ", "are allowed");
    REFUSED("{\"a\": -Infinity}", "s.json:1:8: ", "expected a digit");
    REFUSED("{\"a\": 1e999}", "s.json:1:11: ", "1e308");
    REFUSED("{\"\xff\": 1}", "s.json:1:3: ", "UTF-8");
    REFUSED(std::string("{\"a\": \0}", 8), "s.json:1:7: ", "has none");
    REFUSED(std::string("{}\0", 3), "s.json:1:3: ", "has none");
    const std::string endless(10'000, 'x');
    REFUSED("{\"a\": \"" + endless, "s.json:1:", "closing quote");
    REFUSED("{\"a\": \"b\n\"}", "s.json:2:1: ", "\\n for a line break");
    REFUSED(R"({"a": "\x"})", "s.json:1:9: ", "four hexadecimal digits");
    REFUSED(R"({"a" 1})", "s.json:1:6: ", "expected a colon");
    REFUSED(R"({"a": [1}})", "s.json:1:9: ", "expected a comma or ]");
    REFUSED(R"({"a": tru})", "s.json:1:10: ", "are allowed");
}

TEST_CASE("common slips in JSON are called by their names", "[scene_file]") {
    REFUSED(R"({"a": 1 "b": 2})", "s.json:1:11: ", "a comma is missing before it");
    REFUSED(R"({"a": "x" "b": 2})", "s.json:1:13: ", "a comma is missing before it");
    REFUSED(R"({"a": [1 2]})", "s.json:1:10: ", "a comma is missing before it");
    REFUSED(R"({"a": [{} {}]})", "s.json:1:11: ", "a comma is missing before it");
    REFUSED(R"({"a": [[1] [2]]})", "s.json:1:12: ", "a comma is missing before it");
    REFUSED(R"({"a": [1, true false]})", "s.json:1:20: ", "a comma is missing before it");
    REFUSED(R"({"a": [1, 2, ]})", "s.json:1:14: ", "one comma too many before ]");
    REFUSED(R"({"a": 1, })", "s.json:1:10: ", "one comma too many before }");
    REFUSED(R"({"a": 1,5, "b": 2})", "s.json:1:9: ", "a decimal point, not a comma");
    REFUSED(R"({"a": 1, 5})", "s.json:1:10: ", "expected a key in double quotes");
    REFUSED(R"({"a": 01})", "s.json:1:8: ", "does not begin with 0");
    REFUSED(R"({"a": .5})", "s.json:1:7: ", "begins with a digit");
    REFUSED(R"({"a": +5})", "s.json:1:7: ", "begins with a digit");
    REFUSED(R"({"a": 1; "b": 2})", "s.json:1:8: ", "values are separated by commas");
    REFUSED("// a remark\n{}", "s.json:1:1: ", "JSON has no comments");
    REFUSED("{\"a\": 1 /* one */}", "s.json:1:9: ", "JSON has no comments");
    REFUSED("{\"a\": 1,\n# two\n\"b\": 2}", "s.json:2:1: ", "JSON has no comments");
    REFUSED("{\"a\": 'b'}", "s.json:1:7: ", "straight double quotes");
    REFUSED(
        "{\xe2\x80\x9c"
        "a\xe2\x80\x9d: 1}",
        "s.json:1:2: ", "straight double quotes");
    REFUSED("{a: 1}", "s.json:1:2: ", "keys need double quotes");
    // What came before is not part of the slip.
    CHECK_FALSE(holds(refusal("{\"a\": 8}\n// eight"), "last read"));
}

TEST_CASE("every text that ends too early is refused", "[scene_file]") {
    const std::string whole =
        with_spheres(R"({"center": [0, 0, 0], "radius": 1, "material": "gold"})");
    REQUIRE(refusal(whole).empty());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        INFO("the first " << length << " characters");
        CHECK_FALSE(refusal(whole.substr(0, length)).empty());
    }
}

TEST_CASE("deep nesting and keys that appear twice are refused", "[scene_file]") {
    REFUSED(std::string(1'000'000, '['), "[0][0]", "16 deep");
    REFUSED("{\"a\": [{\"b\": " + std::string(100, '['), "a[0].b[0]", "16 deep");
    REFUSED(with(materials), "s.json: materials appears twice", "once");
    REFUSED(with_spheres(R"({"center": [0, 0, 0], "radius": 1, "radius": 2, "material": "gold"})"),
            "spheres[0].radius appears twice", "once");
}

TEST_CASE("unknown keys are refused, and the nearest known one is named", "[scene_file]") {
    REFUSED(with("\"shperes\": []"), "s.json: shperes", "did you mean \"spheres\"?");
    REFUSED(with("\"Render\": {}"), "s.json: Render", "did you mean \"render\"?");
    REFUSED(with("\"quality\": {}"), "s.json: quality", "known are \"about\"");
    REFUSED(with("\"a b\": 1"), "s.json: [\"a b\"]", "known are");
    REFUSED(with_camera(R"("look_from": [0, 0, 5], "look_at": [0, 0, 0], "vfov": 20)"),
            "camera.vfov", "did you mean \"vfov_deg\"?");
    REFUSED(with_spheres(R"({"centre": [0, 0, 0], "radius": 1, "material": "gold"})"),
            "spheres[0].centre", "did you mean \"center\"?");
    REFUSED(with_group(R"(, "arms": 2)"), "groups[0].arms is not known", "known are");
    REFUSED(with_material(R"({"type": "glass", "fuzz": 1})"), "materials.m.fuzz", "\"index\"");
    // Only keys of this type are offered.
    REFUSED(with_material(R"({"type": "light", "intensity": 1})"), "materials.m.intensity",
            "known are \"type\", \"color\" and \"strength\"");
    REFUSED(with_material(R"({"type": "matte", "color": "#ffffff", "fuzz": 1})"),
            "materials.m.fuzz", "known are \"type\", \"color\" and \"texture\"");
    REFUSED(with_material(R"({"type": "own", "color": "#ffffff", "fuzz": 1})"), "materials.m.fuzz",
            "known are \"type\", \"color\" and \"amount\"");
    REFUSED(with_material(R"({"type": "matte", "color": "#ffffff", "texture": "t"})"),
            "materials.m has both", "color and texture");
    REFUSED(with_material(R"({"colour": "#ffffff"})"), "materials.m.colour", "\"color\"?");
    REFUSED(with_material(R"({"type": "emitter"})"), "materials.m.type",
            "known are \"matte\", \"metal\", \"glass\", \"light\"");  // and all others
    REFUSED(with(R"("textures": {"t": {"type": "image", "odd": 1}})"), "textures.t.odd",
            "known are \"type\" and \"file\"");
    REFUSED(with_material(R"({"type": "mat"})"), "materials.m.type", "did you mean \"matte\"?");
    REFUSED(with('"' + std::string(100'000, 'x') + "\": 1"), "xxx...", "known are");
}

TEST_CASE("what is missing is named", "[scene_file]") {
    REFUSED("{}", "the scene", "needs \"camera\"");
    REFUSED("{" + camera + "}", "the scene", "needs \"materials\"");
    REFUSED(with_camera(R"("look_from": [0, 0, 5])"), "camera", "needs \"look_at\"");
    REFUSED(with_spheres("{}"), "spheres[0]", "needs \"center\"");
    REFUSED(with_material("{}"), "materials.m", "needs \"type\"");
    REFUSED(with_material(R"({"type": "own"})"), "materials.m", "needs \"color\"");
    REFUSED(with_material(R"({"type": "matte"})"), "materials.m", "needs \"color\" or \"texture\"");
}

TEST_CASE("values of the wrong kind are refused", "[scene_file]") {
    REFUSED("[1, 2]", "the scene", "must be an object");
    REFUSED("null", "the scene", "must be an object");
    REFUSED(with("\"spheres\": {}"), "spheres must be a list", "not an object");
    REFUSED(with("\"about\": 7"), "about", "in quotes, not 7");
    REFUSED(with_spheres(R"({"center": [0, 0], "radius": 1, "material": "gold"})"),
            "spheres[0].center", "[x, y, z], not a list of 2");
    REFUSED(with_spheres(R"({"center": [0, null, 0], "radius": 1, "material": "gold"})"),
            "spheres[0].center[1]", "number from -1000000000 to 1000000000, not null");
    REFUSED(with_spheres(R"({"center": [0, 0, 0], "radius": "1", "material": "gold"})"),
            "spheres[0].radius", "must be a number");
    REFUSED(with_spheres(R"({"center": [0, 0, 0], "radius": true, "material": "gold"})"),
            "spheres[0].radius", "not true");
    REFUSED(with_spheres(R"({"center": [0, 0, 0], "radius": 1, "material": 0})"),
            "spheres[0].material", "in quotes");
    for (const char* const color : {"\"red\"", "\"#12345\"", "\"#12345g\"", "\"#1234567\"", "7"})
        REFUSED(with_material(std::string{R"({"type": "matte", "color": )"} + color + "}"),
                "materials.m.color", "\"#rrggbb\" or [r, g, b]");
}

TEST_CASE("numbers outside their range are refused", "[scene_file]") {
    for (const char* const radius : {"-1", "0", "1e-10", "1e10", "-0.0", "1e300"})
        REFUSED(
            with_spheres(std::string{R"({"center": [0, 0, 0], "material": "gold", "radius": )"} +
                         radius + "}"),
            "spheres[0].radius", "from 1e-09 to 1000000000");
    for (const char* const index : {"0", "-1.5", "11"})
        REFUSED(with_material(std::string{R"({"type": "glass", "index": )"} + index + "}"),
                "materials.m.index", "from 0.1 to 10");
    REFUSED(with_material(R"({"type": "matte", "color": [0.5, 1.5, 0]})"), "materials.m.color[1]",
            "from 0 to 1");
    REFUSED(with_material(R"({"type": "metal", "color": "#ffffff", "fuzz": 2})"),
            "materials.m.fuzz", "from 0 to 1");
    REFUSED(with_material(R"({"type": "own", "color": "#ffffff", "amount": -0.1})"),
            "materials.m.amount", "from 0 to 1");
    REFUSED(with_material(R"({"type": "light", "color": [-1, 0, 0]})"), "materials.m.color[0]",
            "from 0 to");
    REFUSED(with_camera(R"("look_from": [0, 0, 5], "look_at": [0, 0, 0], "vfov_deg": 180)"),
            "camera.vfov_deg", "to 179");
    REFUSED(with_camera(R"("look_from": [0, 0, 5], "look_at": [0, 0, 5])"), "camera.look_at",
            "another point");
    REFUSED(with_camera(R"("look_from": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 0, 0])"),
            "camera.up", "direction");
    REFUSED(with(R"("fog": {"center": [0, 0, 0], "radius": 1, "density": 1, "asymmetry": 1})"),
            "fog.asymmetry", "to 0.99");
    REFUSED(with(R"("haze": {"density": -1, "color": "#ffffff"})"), "haze.density", "from 0 to");
    REFUSED(with(R"("render": {"width": 0})"), "render.width", "whole number from 1 to 65536");
    REFUSED(with(R"("render": {"spp": 1.5})"), "render.spp", "whole number");
    REFUSED(with(R"("render": {"seed": -1})"), "render.seed", "whole number from 0");
    REFUSED(with(R"("render": {"width": 60000, "height": 60000})"), "render", "are allowed");
}

TEST_CASE("a material or a texture that does not exist is refused", "[scene_file]") {
    REFUSED(with_spheres(R"({"center": [0, 0, 0], "radius": 1, "material": "golt"})"),
            "spheres[0].material is \"golt\"", "did you mean \"gold\"?");
    REFUSED(with_spheres(R"({"center": [0, 0, 0], "radius": 1, "material": "velvet"})"),
            "spheres[0].material is \"velvet\"", "there are \"gold\"");
    REFUSED(with_material(R"({"type": "matte", "texture": "t"})"), "materials.m.texture",
            "\"textures\" holds none");
    REFUSED(with_group(R"(, "seed": 1}, {"rule": "ball", "count": 1, "extent": 1, "radius": 0.1,
                          "materials": ["gold", "nope"])"),
            "groups[1].materials[1]", "there are \"gold\"");
}

TEST_CASE("a light does not move", "[scene_file]") {
    REFUSED("{" + camera + R"(, "materials": {"lamp": {"type": "light", "color": [1, 1, 1]}},
        "spheres": [{"center": [0, 0, 0], "radius": 1, "material": "lamp", "velocity": [0, 1, 0]}]})",
            "spheres[0].velocity", "a light does not move");
}

TEST_CASE("more spheres than allowed are refused at once", "[scene_file]") {
    const auto group = [](const std::string& count) {
        return with(R"("groups": [{"rule": "plane", "count": )" + count +
                    R"(, "extent": 9, "radius": 0.01, "materials": ["gold"]}])");
    };
    CHECK(refusal(group("1000")).empty());
    for (const char* const count : {"1000000000", "1001", "1e300", "0", "-1", "2.5"})
        REFUSED(group(count), "groups[0].count", "whole number from 1 to 1000");
    REFUSED(with_group(R"(}, {"rule": "plane", "count": 996, "extent": 9, "radius": 0.01,
                          "materials": ["gold"])"),
            "groups[1].count", "and 995 are left");
    REFUSED(with_group(R"(, "seed": 2}, {"rule": "sunflower", "count": 1, "extent": 1e-5,
                          "radius": [1, 2, 3], "materials": ["gold"])"),
            "groups[1].radius", "a list of two");
}

TEST_CASE("spheres that find no room are refused", "[scene_file]") {
    REFUSED(with(R"("groups": [{"rule": "ball", "count": 900, "extent": 2, "radius": 1,
                                "materials": ["gold"]}])"),
            "groups[0].count", "without overlapping");
}

TEST_CASE("a sky never gives less than no light", "[scene_file]") {
    // A direction's y may lie beyond 1 by a rounding.
    const Real beyond = 1 + rt::epsilon;
    const rt::GradientSky up{{0, 0, 0}, {1000, 1000, 1000}}, down{{1000, 1000, 1000}, {0, 0, 0}};
    CHECK(up({0, -beyond, 0}) == Color{});
    CHECK(down({0, beyond, 0}) == Color{});
    CHECK(down({0, -beyond, 0}) == Color{1000, 1000, 1000});
}

TEST_CASE("there is room above a hundred thousand pebbles", "[scene_file]") {
    const std::string text = with(R"("groups": [
        {"rule": "plane", "count": 100000, "extent": 50, "radius": 0.01, "materials": ["gold"]},
        {"rule": "plane", "count": 1001, "center": [0, 50, 0], "extent": 200, "radius": 1,
         "materials": ["gold"]}])");
    CHECK(effects::parse_scene(text, "s.json", ".").spheres.size() == 101001);
}

TEST_CASE("a lens needs a distance", "[scene_file]") {
    const auto lens = [](const std::string& at, const std::string& members) {
        return with_camera("\"look_from\": [0, 0, 0], \"look_at\": [0, 0, " + at +
                           "], \"lens\": {\"aperture\": 1" + members + "}");
    };
    REFUSED(lens("1e-30", ""), "camera.lens", "needs \"focus_distance\"");
    CHECK(refusal(lens("1e-30", ", \"focus_distance\": 1")).empty());
    CHECK(refusal(lens("1e-8", "")).empty());
}

TEST_CASE("in fog nothing lies in glass or cuts into it", "[scene_file]") {
    const auto scene = [](const std::string& spheres, const std::string& shutter = "0",
                          const std::string& fog = "[0, 0, 0]") {
        return R"({"camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0], "shutter": )" +
               shutter + R"(}, "fog": {"center": )" + fog + R"(, "radius": 3, "density": 1},
            "materials": {"air": {"type": "glass", "index": 0.67}, "glass": {"type": "glass"},
                          "lamp": {"type": "light", "color": [1, 1, 1]},
                          "red": {"type": "matte", "color": [1, 0, 0]}},
            "spheres": [{"center": [0, 0, 0], "radius": 1, "material": "glass"}, )" +
               spheres + "]}";
    };
    const std::string hollow = R"({"center": [0, 0, 0], "radius": 0.9, "material": "air"})";
    const std::string stands = "spheres[0] is glass", allowed = "nothing may lie in glass";
    REFUSED(scene(hollow), stands, allowed);
    CHECK(refusal(scene(hollow, "0", "[9, 0, 0]")).empty());
    REFUSED(scene(R"({"center": [0.2, 0, 0], "radius": 0.3, "material": "lamp"})"), stands,
            allowed);
    REFUSED(scene(R"({"center": [1.2, 0, 0], "radius": 0.3, "material": "red"})"), stands, allowed);
    REFUSED(
        scene(R"({"center": [0, 1.2, 0], "radius": 1, "scale": [1, 0.5, 1], "rotate_deg": [0, 0, 5],
                      "material": "red"})"),
        stands, allowed);
    // A floor, a sky and a neighbor outside, which touch it.
    for (const char* const other :
         {R"({"center": [0, -1001, 0], "radius": 1000, "material": "red"})",
          R"({"center": [0, 0, 0], "radius": 100, "material": "lamp"})",
          R"({"center": [0, 9, 0], "radius": 10, "material": "red"})",
          R"({"center": [0, 1.5, 0], "radius": 1, "scale": [1, 0.5, 1], "material": "glass"})",
          R"({"center": [1.2, 1.2, 0], "radius": 1, "scale": [2, 0.1, 1], "rotate_deg": [0, 0, -45],
              "material": "glass"})"})
        CHECK(refusal(scene(other)) == "");
    // What flies into it while the shutter is open.
    const std::string flies =
        R"({"center": [0, 3, 0], "radius": 1, "material": "red", "velocity": [0, -9, 0]})";
    CHECK(refusal(scene(flies)) == "");
    REFUSED(scene(flies, "1"), stands, allowed);
    REFUSED(scene(R"({"center": [9, 9, 9], "radius": 1, "material": "red"}], "groups": [
        {"rule": "sunflower", "count": 50, "center": [0, 1.5, 0], "extent": 1, "radius": 0.3,
         "materials": ["air"]})"),
            "groups[0] is glass", "groups[0] overlaps it");
}

TEST_CASE("images outside the scene's folder are not read", "[scene_file]") {
    const TemporaryFolder place;
    const fs::path home = place / "home";
    const std::string png = rt::encode_png(rt::Image{8, 8, {1, 0, 0}});
    write_file(home / "in.png", png);
    write_file(home / "deep/er.png", png);
    write_file(home / "wide.png", rt::encode_png(rt::Image{65, 1}));
    write_file(home / "text.png", "no picture");
    write_file(home / "broken.png", png.substr(0, png.size() / 2));
    write_file(place / "out.png", png);
    write_file(place / "home2/out.png", png);
    fs::create_symlink("in.png", home / "link.png");
    fs::create_symlink(place / "out.png", home / "leads_out.png");
    fs::create_directory_symlink(place / "home2", home / "folder_out");
    fs::create_symlink("nowhere.png", home / "dangling.png");

    const auto said = [&](const std::string& file) {
        return refusal(with(R"("textures": {"t": {"type": "image", "file": ")" + file + "\"}}"),
                       home);
    };
    for (const char* const file : {"in.png", "./in.png", "deep/er.png", "link.png"})
        CHECK(said(file).empty());
    for (const std::string& file :
         {std::string{"../out.png"}, std::string{"deep/../../out.png"},
          std::string{"deep/../in.png"}, (place / "out.png").string(), std::string{"/etc/passwd"},
          std::string{"leads_out.png"}, std::string{"folder_out/out.png"}, std::string{".."}}) {
        INFO(file << ": " << said(file));
        CHECK(holds(said(file), "textures.t.file is \""));
        CHECK(holds(said(file), "only files in that folder are read"));
    }
    CHECK(holds(said("missing.png"), "\"missing.png\" in the scene's folder does not exist"));
    CHECK(holds(said("dangling.png"), "does not exist"));
    CHECK(holds(said("."), "is a folder"));
    CHECK(holds(said(""), "must name an image file"));
    CHECK(holds(said("in.png\\u0000.txt"), "must name an image file"));
    CHECK(holds(said("text.png"), "only PNG is"));
    CHECK(holds(said("broken.png"), "only PNG is"));
    CHECK(holds(said("wide.png"), "64 pixels together"));
}

TEST_CASE("an image's colors are linear light", "[scene_file]") {
    rt::Image drawn{3, 2};
    drawn.at(2, 0) = rt::from_hex(0x804020);
    const rt::Image read = rt::decode_image(rt::encode_png(drawn), 6);
    CHECK(read.width() == 3);
    CHECK(read.height() == 2);
    CHECK(read.at(2, 0) == rt::from_hex(0x804020));
    CHECK(read.at(0, 1) == Color{});
}

TEST_CASE("no two spheres of a group overlap, nor one that was there before", "[scene_file]") {
    const placing::Ball space{1, 2, 3, 6}, there{2, 2, 3, 1};
    const std::vector<std::pair<const char*, placing::Rule>> rules{
        {"plane", placing::on_plane(space)},
        {"sphere", placing::on_sphere(space)},
        {"ball", placing::in_ball(space)},
        {"galaxy", placing::galaxy(space, 3, 1.5, 0.3)}};
    for (const auto& [name, rule] : rules) {
        INFO(name);
        placing::Neighbors neighbors;
        neighbors.add(there);
        auto balls = placing::scatter(400, 0.05, 0.4, rule, neighbors, 1);
        CHECK(balls.size() == 400);
        balls.push_back(there);
        int overlaps = 0;
        for (std::size_t i = 0; i < balls.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const auto &a = balls[i], &b = balls[k];
                const double apart = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
                overlaps += apart < 0.998 * (a.radius + b.radius);
            }
        CHECK(overlaps == 0);
    }
}

TEST_CASE("each rule places its spheres where it says", "[scene_file]") {
    const placing::Ball space{1, 2, 3, 6};
    const auto scattered = [](const placing::Rule& rule) {
        placing::Neighbors none;
        return placing::scatter(200, 0.05, 0.2, rule, none, 1);
    };
    const auto from_center = [&](const placing::Ball& b) {
        return std::hypot(b.x - space.x, b.y - space.y, b.z - space.z);
    };
    for (const auto& b : scattered(placing::on_plane(space))) {
        CHECK(std::abs(b.y - (space.y + b.radius)) < 1e-12);
        CHECK(std::hypot(b.x - space.x, b.z - space.z) <= space.radius);
    }
    for (const auto& b : scattered(placing::on_sphere(space)))
        CHECK(std::abs(from_center(b) - (space.radius + b.radius)) < 1e-12);
    for (const auto& b : scattered(placing::in_ball(space)))
        CHECK(from_center(b) + b.radius < space.radius + 1e-12);
    const auto seeds = placing::sunflower(500, space, 0.1, 0.3);
    CHECK(seeds.size() == 500);
    for (const auto& b : seeds) CHECK(std::hypot(b.x - space.x, b.z - space.z) <= space.radius);
    CHECK(seeds.front().radius < seeds.back().radius);
}

TEST_CASE("the same seed places the same spheres, another seed places others", "[scene_file]") {
    const auto first = [](std::uint64_t seed) {
        placing::Neighbors none;
        return placing::scatter(9, 0.1, 0.2, placing::in_ball({0, 0, 0, 5}), none, seed).front().x;
    };
    CHECK(first(1) == first(1));
    CHECK(first(1) != first(2));
}

TEST_CASE("spheres of one material with a range of colors differ", "[scene_file]") {
    const auto scene = effects::parse_scene("{" + camera + R"(, "materials": {"m": {"type": "matte",
            "color": {"between": [[0, 0.5, 0.25], [0.1, 0.5, 0.75]]}}},
        "groups": [{"rule": "plane", "count": 20, "extent": 9, "radius": 0.1, "materials": ["m"]}]})",
                                            "s.json", ".");
    REQUIRE(scene.materials.size() == 20);
    const auto albedo = [&](std::size_t i) {
        return std::get<rt::Lambertian>(scene.materials[i]).albedo;
    };
    CHECK(albedo(0) != albedo(1));
    for (std::size_t i = 0; i < 20; ++i) {
        CHECK((0 <= albedo(i).r && albedo(i).r <= Real(0.1)));
        CHECK(albedo(i).g == Real(0.5));
    }
}

TEST_CASE("spheres of your own material get a range of colors too", "[scene_file]") {
    const auto scene = effects::parse_scene("{" + camera + R"(, "materials": {"m": {"type": "own",
            "color": {"between": [[0, 0, 0], [1, 1, 1]]}, "amount": 1}},
        "groups": [{"rule": "plane", "count": 2, "extent": 9, "radius": 0.1, "materials": ["m"]}]})",
                                            "s.json", ".");
    REQUIRE(scene.materials.size() == 2);
    const auto& first = std::get<rt::OwnMaterial>(scene.materials[0]);
    const auto& second = std::get<rt::OwnMaterial>(scene.materials[1]);
    CHECK(first.color != second.color);
    CHECK((first.amount == 1 && second.amount == 1));
}

TEST_CASE("an image moves with a sphere that is turned, stretched or mirrored", "[scene_file]") {
    const TemporaryFolder folder;
    rt::Image map{8, 4};
    for (int i = 0; i < 32; ++i)
        map.at(i % 8, i / 8) = Color{1, 1, 1} * (static_cast<Real>(i) / 32);
    write_file(folder / "planet.png", rt::encode_png(map));
    const std::string from = R"(, "textures": {"map": {"type": "image", "file": "planet.png"}},
        "materials": {"m": {"type": "matte", "texture": "map"}}, "spheres": [)";
    const auto scene = effects::parse_scene(
        "{" + camera + from + R"({"center": [0, 0, 0], "radius": 1, "material": "m"},
            {"center": [5, 0, 0], "radius": 2, "rotate_deg": [0, 90, 0], "material": "m"},
            {"center": [5, 0, 0], "radius": 2, "scale": [1, 0.25, 1], "material": "m"},
            {"matrix": [[-1, 0, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0]], "material": "m"}]})",
        "s.json", folder.path());
    const auto prepared =
        rt::prepare_materials<rt::MaterialSet<rt::Lambertian, rt::ImageMatte>>(scene).materials;
    // The image at the place of sphere i whose normal in the world is this one.
    const auto color = [&](std::size_t i, Vec3 normal) {
        rt::Hit hit;
        hit.normal = normalize(normal);
        const auto material = static_cast<std::size_t>(scene.spheres[i].material);
        return albedo_at(std::get<rt::ImageMatte>(prepared[material]), hit);
    };
    for (const Vec3 n : {Vec3{1, 2, 10}, {10, 3, 1}, {3, -7, 5}}) {
        // At 90 degrees about y, z goes to x, and x to -z.
        CHECK(color(1, {n.z, n.y, -n.x}) == color(0, n));
        CHECK(color(2, {n.x, 4 * n.y, n.z}) == color(0, n));
        CHECK(color(3, {-n.x, n.y, n.z}) == color(0, n));
    }
    CHECK(color(1, {1, 2, 10}) != color(0, {1, 2, 10}));
}
