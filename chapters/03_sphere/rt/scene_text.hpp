#pragma once
#include <cmath>
#include <fstream>
#include <rt/color.hpp>
#include <rt/scene_sphere.hpp>
#include <rt/view.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt {

// A material as a scene file names it; chapters 04 and 05 say what it does to light.
struct TextMaterial {
    enum Kind { matte, metal, glass } kind = matte;
    Color color{Real(0.5), Real(0.5), Real(0.5)};
    Real fuzz = 0;   // of metal, from 0 to 1
    Real index = 1;  // of glass: the refractive index inside divided by the one outside
};

// A scene as its file describes it (given): chapters/09_own/start/TASK.md says what each line
// means, and what is used instead if a line is missing.
struct SceneText {
    int width = 400, height = 225, samples = 16, depth = 50;
    View view{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, radians(40)};
    Real aperture = 0, focus = 1;
    Color below{1, 1, 1}, above{Real(0.5), Real(0.7), 1};  // the sky
    std::vector<SceneSphere> spheres;
    std::vector<TextMaterial> materials;  // SceneSphere::material is an index into these
};

// Throws std::invalid_argument, which says what was expected, unless `holds` is true.
inline void expect(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("expected " + what);
}

inline std::istream& operator>>(std::istream& in, Vec3& v) {
    return in >> v.x >> v.y >> v.z;
}

inline std::istream& operator>>(std::istream& in, Color& c) {
    in >> c.r >> c.g >> c.b;
    const auto is_share = [](Real x) { return 0 <= x && x <= 1; };
    if (in) expect(is_share(c.r) && is_share(c.g) && is_share(c.b), "colors from 0 to 1");
    return in;
}

// Reads one line of a scene file, without its comment, into the scene.
inline void read_line(const std::string& line, SceneText& scene) {
    std::istringstream in{line};
    std::string word, more;
    if (!(in >> word)) return;
    const auto number_from = [&](Real least) {
        Real number = 0;
        if (in >> number) expect(least <= number, "numbers that make sense after " + word);
        return number;
    };
    constexpr Real above_0 = std::numeric_limits<Real>::denorm_min();
    SceneSphere sphere;
    TextMaterial material;
    View& view = scene.view;
    if (word == "picture") {
        in >> scene.width >> scene.height >> scene.samples >> scene.depth;
        const auto [least, most] =
            std::minmax({scene.width, scene.height, scene.samples, scene.depth});
        expect(least >= 1 && most <= 10'000, "picture numbers from 1 to 10000");
    } else if (word == "camera") {
        in >> view.from >> view.at >> view.up;
        const Real degrees = number_from(above_0);
        expect(degrees < 180, "a field of view between 0 and 180 degrees");
        view.vertical_fov = radians(degrees);
        scene.aperture = number_from(0);
        scene.focus = number_from(above_0);
    } else if (word == "sky") {
        in >> scene.below >> scene.above;
    } else if (word == "matte") {
        in >> material.color;
    } else if (word == "metal") {
        material.kind = TextMaterial::metal;
        in >> material.color;
        material.fuzz = number_from(0);
        expect(material.fuzz <= 1, "a fuzz from 0 to 1");
    } else if (word == "glass") {
        material.kind = TextMaterial::glass;
        material.index = number_from(above_0);
    } else if (word == "sphere") {
        in >> sphere.shape.center;
        sphere.shape.radius = number_from(above_0);
    } else {
        expect(false, "camera, glass, matte, metal, picture, sky or sphere, not " + word);
    }
    expect(!in.fail() && !(in >> more), "the right numbers after " + word);
    if (word == "sphere") {
        if (scene.materials.empty()) scene.materials.emplace_back();
        sphere.material = static_cast<int>(scene.materials.size()) - 1;
        scene.spheres.push_back(sphere);
    } else if (word == "matte" || word == "metal" || word == "glass") {
        scene.materials.push_back(material);
    }
}

// The scene in a file. Throws std::invalid_argument if there is no such file or if a line is wrong;
// in the second case, the message begins with "file:line:".
inline SceneText read_scene(const std::string& path) {
    std::ifstream file{path};
    expect(file.is_open(), "a scene file, but cannot read '" + path + "'");
    SceneText scene;
    int number = 1;
    try {
        for (std::string line; std::getline(file, line); ++number)
            read_line(line.substr(0, line.find('#')), scene);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(path + ":" + std::to_string(number) + ": " + error.what());
    }
    return scene;
}

}  // namespace rt
