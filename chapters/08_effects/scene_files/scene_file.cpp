#include "scene_file.hpp"

#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <cmath>
#include <map>
#include <rt/image_file.hpp>
#include <rt/light_file.hpp>
#include <rt/portable.hpp>

#include "glass_in_fog.hpp"
#include "placing.hpp"
#include "scene_value.hpp"

namespace effects {
namespace {

namespace fs = std::filesystem;
using namespace rt;

constexpr Range angles{0.001, 179};
constexpr std::uint64_t max_seed = std::uint64_t{1} << 53;  // above it, a double skips integers

struct Texture {
    std::optional<CheckeredMatte> checker;
    PictureMatte picture;
};

// A named material. If its color is random, each sphere gets a material of its own.
struct Material {
    MaterialDescription description;
    std::optional<std::pair<Color, Color>> between = {};
    int index = -1;  // in the scene, once a sphere is made of it
};

class Reader : SceneMaterials {
  public:
    Reader(const std::string& name, const ReadNeighbor& read, const Limits& limits,
           const OtherShapes& others)
        : name_{name}, read_{read}, limits_{limits}, others_{others} {}

    SceneDescription read(const Value& whole) {
        if (const auto meshes = whole.find("meshes"); meshes && others_.key != "meshes")
            meshes->fail(
                "are not drawn by this program; ./course run 08 takes the one that draws them");
        std::vector<std::string> keys{"about",    "camera",    "sky",     "fog",    "haze",
                                      "textures", "materials", "spheres", "groups", "render"};
        if (!others_.key.empty()) keys.insert(keys.end() - 1, others_.key);
        whole.with_keys(keys);
        if (const auto about = whole.find("about")) about->text("a sentence");
        read_camera(whole.at("camera"));
        scene_.sky = {{1, 1, 1}, from_hex(0x7fb2ff)};
        if (const auto sky = whole.find("sky")) read_sky(*sky);
        if (const auto fog = whole.find("fog")) read_fog(*fog);
        if (const auto haze = whole.find("haze")) read_haze(*haze);
        if (const auto textures = whole.find("textures"))
            for (const std::string& key : textures->keys("textures by name"))
                textures_.emplace(key, read_texture(textures->at(key)));
        const Value materials = whole.at("materials");
        for (const std::string& key : materials.keys("materials by name"))
            materials_.emplace(key, read_material(materials.at(key)));
        if (const auto spheres = whole.find("spheres"))
            for (const Value& sphere : spheres->list("spheres")) read_sphere(sphere);
        ends_.push_back(static_cast<int>(scene_.spheres.size()));
        if (const auto groups = whole.find("groups"))
            for (const Value& group : groups->list("groups")) {
                read_group(group);
                ends_.push_back(static_cast<int>(scene_.spheres.size()));
            }
        if (!others_.key.empty())
            if (const auto others = whole.find(others_.key))
                for (const Value& shape : others->list(others_.key)) others_.read_one(shape, *this);
        if (const auto found = filled_glass_in_fog(scene_))
            throw app::UsageError(name_ + ": " + place_of(found->first) +
                                  " is glass in the fog, and " + place_of(found->second) +
                                  " overlaps it; in fog, nothing may lie in glass or cut into it");
        if (const auto render = whole.find("render")) read_render(*render);
        return std::move(scene_);
    }

  private:
    // The position in the file that a sphere comes from.
    std::string place_of(int sphere) const {
        const auto group = std::upper_bound(ends_.begin(), ends_.end(), sphere) - ends_.begin();
        return group == 0 ? app::path_of_item("spheres", static_cast<std::size_t>(sphere))
                          : app::path_of_item("groups", static_cast<std::size_t>(group - 1));
    }

    void read_camera(const Value& camera) {
        camera.with_keys({"look_from", "look_at", "up", "vfov_deg", "lens", "shutter"});
        CameraDescription& to = scene_.camera;
        to.view.from = vec3(camera.at("look_from"));
        to.view.at = vec3(camera.at("look_at"));
        if (to.view.at == to.view.from)
            camera.at("look_at").fail("must be another point than look_from");
        to.view.up = vec3(camera, "up", {0, 1, 0});
        if (to.view.up == Vec3{}) camera.at("up").fail("must be a direction, not [0, 0, 0]");
        to.view.vertical_fov = radians(number(camera, "vfov_deg", angles, 40));
        to.shutter = number(camera, "shutter", {0, 1e6}, 0);
        if (const auto lens = camera.find("lens")) {
            lens->with_keys({"aperture", "focus_distance"});
            to.lens.aperture = number(lens->at("aperture"), {0, lengths.high});
            const Vec3 ahead = to.view.at - to.view.from;
            const Real distance =
                rt::portable::hypot(rt::portable::hypot(ahead.x, ahead.y), ahead.z);
            if (!lens->find("focus_distance") && distance < static_cast<Real>(lengths.low))
                lens->fail("needs \"focus_distance\", because look_at is nearer than " +
                           app::number_text(lengths.low) + " to look_from");
            to.lens.focus_distance = number(*lens, "focus_distance", lengths, distance);
        }
    }

    void read_sky(const Value& sky) {
        if (const auto image = sky.find("image")) return read_sky_image(sky, *image);
        sky.with_keys({"below", "above"});
        scene_.sky = {color(sky.at("below"), light), color(sky.at("above"), light)};
    }

    void read_sky_image(const Value& sky, const Value& image) {
        if (others_.key.empty())
            image.fail("is not drawn by this program; ./course run 08 takes the one that draws it");
        sky.with_keys({"image", "rotate_deg", "scale"});
        const Real turn = number(sky, "rotate_deg", {-360, 360}, 0) / 360;
        const Real within = turn - std::floor(turn);  // a tiny negative turn may give 1
        scene_.sky_image = SkyImage{static_cast<int>(scene_.images.size()), within < 1 ? within : 0,
                                    number(sky, "scale", light, 1)};
        const std::string& name = image.text("the name of a .hdr or .pfm file");
        const std::string bytes = read_(image, name, "a sky", std::size_t{1} << 27);
        scene_.images.push_back(decoded(image, name, [&](int most_pixels) {
            try {
                return decode_light(bytes, most_pixels);
            } catch (const std::runtime_error& wrong) {
                image.fail("is " + app::quoted(name) + ", which cannot be used: the file " +
                           wrong.what());
            }
        }));
    }

    void read_fog(const Value& value) {
        value.with_keys({"center", "radius", "density", "color", "asymmetry"});
        Fog fog;
        fog.region = {vec3(value.at("center")), number(value.at("radius"), lengths)};
        fog.density = number(value.at("density"), {0, 1e9});
        fog.albedo = color(value, "color", {1, 1, 1}, shares);
        fog.asymmetry = number(value, "asymmetry", {-0.99, 0.99}, 0);
        scene_.fog = fog;
    }

    void read_haze(const Value& haze) {
        haze.with_keys({"density", "color"});
        scene_.haze = Haze{number(haze.at("density"), {0, 1e9}), color(haze.at("color"), light)};
    }

    Texture read_texture(const Value& texture) {
        if (!texture.find("type")) texture.with_keys({"type", "even", "odd", "size", "file"});
        Texture result;
        if (texture.at("type").word({"checker", "image"}) == "image") {
            texture.with_keys({"type", "file"});
            result.picture.image = static_cast<int>(scene_.images.size());
            const Value file = texture.at("file");
            scene_.images.push_back(read_image(file, file.text("the name of an image file")));
        } else {
            texture.with_keys({"type", "even", "odd", "size"});
            result.checker = {color(texture.at("even"), shares), color(texture.at("odd"), shares),
                              number(texture, "size", lengths, 1)};
        }
        return result;
    }

    // `file` is the value to blame.
    Image read_image(const Value& file, const std::string& name) {
        const std::string bytes = read_(file, name, "an image", 64 << 20);
        return decoded(file, name, [&](int most_pixels) {
            try {
                return decode_image(bytes, most_pixels);
            } catch (const std::runtime_error&) {
                file.fail("is " + app::quoted(name) +
                          ", which is not a readable PNG image; only PNG is read");
            }
        });
    }

    // The image that decode(most_pixels) gives; fails if it has more pixels than are left.
    template <class Decode>
    Image decoded(const Value& file, const std::string& name, const Decode& decode) {
        try {
            Image image = decode(pixels_left_);
            pixels_left_ -= image.width() * image.height();
            return image;
        } catch (const std::length_error&) {
            file.fail("is " + app::quoted(name) +
                      ", which is too large; all images of a scene may have " +
                      std::to_string(limits_.image_pixels) + " pixels together");
        }
    }

    // The entry of this name, or an error that lists the names that exist.
    template <class Table>
    static auto& named(Table& table, const Value& name, const std::string& kind) {
        const std::string& wanted = name.text("the name of a " + kind);
        const auto found = table.find(wanted);
        if (found != table.end()) return found->second;
        std::vector<std::string> known;
        for (const auto& [key, value] : table) known.push_back(key);
        name.fail("is " + app::quoted(wanted) + ", and there is no such " + kind +
                  (known.empty() ? "; \"" + kind + "s\" holds none"
                                 : app::meant(wanted, known, "there are ")));
    }

    // A type of material: its name in a file, its keys beside "type", and how it is read.
    struct MaterialType {
        std::string name;
        std::vector<std::string> keys;
        MaterialDescription (Reader::*read)(const Value& value, Material& material) const;
    };
    static const std::vector<MaterialType>& material_types() {
        static const std::vector<MaterialType> types{
            {"matte", {"color", "texture"}, &Reader::read_matte},
            {"metal", {"color", "fuzz"}, &Reader::read_metal},
            {"glass", {"index"}, &Reader::read_glass},
            {"light", {"color", "strength"}, &Reader::read_light},
            {"own", {"color", "amount"}, &Reader::read_own},
            {"rough", {"color", "roughness"}, &Reader::read_rough}};
        return types;
    }

    MaterialDescription read_matte(const Value& value, Material& material) const {
        const auto texture = value.find("texture");
        if (texture && value.find("color"))
            value.fail("has both color and texture; it may have only one");
        if (texture) {
            const Texture& chosen = named(textures_, *texture, "texture");
            if (chosen.checker) return *chosen.checker;
            return chosen.picture;
        }
        if (!value.find("color")) value.fail("needs \"color\" or \"texture\"");
        return Lambertian{read_color(value, material)};
    }
    MaterialDescription read_metal(const Value& value, Material& material) const {
        return Metal{read_color(value, material), number(value, "fuzz", shares, 0)};
    }
    MaterialDescription read_glass(const Value& value, Material&) const {
        return Dielectric{number(value, "index", {0.1, 10}, Real(1.5))};
    }
    MaterialDescription read_light(const Value& value, Material&) const {
        const Real strength = number(value, "strength", light, 1);
        return Emitter{strength * color(value.at("color"), light)};
    }
    MaterialDescription read_own(const Value& value, Material& material) const {
        return OwnMaterial{read_color(value, material), number(value, "amount", shares, Real(0.5))};
    }

    MaterialDescription read_rough(const Value& value, Material& material) const {
        if (others_.key.empty())
            value.at("type").fail(
                "is \"rough\", which this program does not draw; ./course run 08 takes the one "
                "that draws it");
        return RoughDescription{read_color(value, material),
                                number(value, "roughness", {0.01, 1}, Real(0.3))};
    }

    // The color of a material, or the first of the two colors that it lies between.
    static Color read_color(const Value& value, Material& material) {
        const Value given = value.at("color");
        if (!given.is_object()) return color(given, shares);
        const Value between = given.with_keys({"between"}).at("between");
        const Value::List ends = between.list("two colors");
        if (ends.size() != 2)
            between.fail("must be a list of two colors, not of " + std::to_string(ends.size()));
        material.between = {color(ends[0], shares), color(ends[1], shares)};
        return material.between->first;
    }

    Material read_material(const Value& value) const {
        std::vector<std::string> names, all_keys{"type"};
        for (const MaterialType& type : material_types()) {
            names.push_back(type.name);
            for (const std::string& key : type.keys)
                if (std::find(all_keys.begin(), all_keys.end(), key) == all_keys.end())
                    all_keys.push_back(key);
        }
        if (!value.find("type")) value.with_keys(all_keys);
        const std::string& name = value.at("type").word(names);
        const auto& type = *std::find_if(material_types().begin(), material_types().end(),
                                         [&](const auto& t) { return t.name == name; });
        std::vector<std::string> keys{"type"};
        keys.insert(keys.end(), type.keys.begin(), type.keys.end());
        value.with_keys(keys);
        Material material;
        material.description = (this->*type.read)(value, material);
        return material;
    }

    // The index of a material for the next shape. A random color depends only on the
    // number of spheres so far.
    int use(Material& material) {
        if (material.between || material.index < 0) {
            material.index = static_cast<int>(scene_.materials.size());
            scene_.materials.push_back(material.description);
        }
        if (material.between) {
            Rng random{scene_.spheres.size(), 80};
            const auto [a, b] = *material.between;
            const auto lot = [&](Real low, Real high) {
                return low + (high - low) * static_cast<Real>(placing::uniform(random));
            };
            const Color color{lot(a.r, b.r), lot(a.g, b.g), lot(a.b, b.b)};
            const auto set_color = [&](auto& material_of_its_own) {
                if constexpr (requires { material_of_its_own.albedo; })
                    material_of_its_own.albedo = color;
                else if constexpr (requires { material_of_its_own.color; })
                    material_of_its_own.color = color;
            };
            std::visit(set_color, scene_.materials.back());
        }
        return material.index;
    }

    int named(const Value& name) override { return use(named(materials_, name, "material")); }
    std::optional<int> find(const std::string& name) override {
        const auto found = materials_.find(name);
        if (found == materials_.end()) return {};
        return use(found->second);
    }
    int add(const MaterialDescription& material) override {
        scene_.materials.push_back(material);
        return static_cast<int>(scene_.materials.size()) - 1;
    }
    int add_image(const Value& where, const std::string& file) override {
        scene_.images.push_back(read_image(where, file));
        return static_cast<int>(scene_.images.size()) - 1;
    }
    bool shows_image(int material) const override {
        return std::holds_alternative<PictureMatte>(
            scene_.materials[static_cast<std::size_t>(material)]);
    }

    // How many more spheres there may be.
    int room() const { return limits_.spheres - static_cast<int>(scene_.spheres.size()); }

    void read_velocity(const Value& of, const Material& material, Vec3& velocity) const {
        const auto given = of.find("velocity");
        if (!given) return;
        velocity = vec3(*given);
        if (velocity != Vec3{} && std::holds_alternative<Emitter>(material.description))
            given->fail("must be [0, 0, 0] or absent: a light does not move");
    }

    // Makes `to` an instance with this map: adds the map to the scene, and puts a sphere around the
    // instance.
    void add_map(const Value& where, const Mat4& map, SphereDescription& to) {
        expect_not_flat(where, map, "sphere");
        Real squared = 0;
        for (int i = 0; i < 9; ++i) squared += map(i / 3, i % 3) * map(i / 3, i % 3);
        to.shape = {{map(0, 3), map(1, 3), map(2, 3)}, std::sqrt(squared)};
        to.map = static_cast<int>(scene_.maps.size());
        scene_.maps.push_back(map);
    }

    void read_shape(const Value& sphere, SphereDescription& to) {
        if (const auto matrix = sphere.find("matrix")) {
            for (const char* other : {"center", "radius", "scale", "rotate_deg"})
                if (sphere.find(other))
                    sphere.fail("has both matrix and " + std::string{other} +
                                "; the matrix alone says everything");
            add_map(*matrix, read_matrix(*matrix), to);
            return;
        }
        to.shape = {vec3(sphere.at("center")), number(sphere.at("radius"), lengths)};
        if (sphere.find("scale") || sphere.find("rotate_deg"))
            add_map(sphere, read_stretched(sphere, to.shape), to);
    }

    void read_sphere(const Value& sphere) {
        sphere.with_keys(
            {"center", "radius", "scale", "rotate_deg", "matrix", "material", "velocity"});
        if (room() < 1)
            sphere.fail("is one too many; a scene may have " + std::to_string(limits_.spheres) +
                        " spheres");
        SphereDescription to;
        read_shape(sphere, to);
        Material& material = named(materials_, sphere.at("material"), "material");
        read_velocity(sphere, material, to.velocity);
        if (to.map >= 0 && to.velocity != Vec3{})
            sphere.at("velocity")
                .fail(
                    "must be [0, 0, 0] or absent: a sphere that is stretched or "
                    "turned does not move");
        if (to.map >= 0 && std::holds_alternative<Emitter>(material.description))
            sphere.at("material")
                .fail(
                    "is a light, and a light is a plain sphere: leave out scale, "
                    "rotate_deg and matrix");
        if (const auto* const picture = std::get_if<PictureMatte>(&material.description);
            picture && to.map >= 0) {  // a material of its own, which moves with the sphere
            to.material = add(PictureMatte{picture->image, to.map});
        } else {
            to.material = use(material);
        }
        scene_.spheres.push_back(to);
        there_.add(placing::ball_of(to.shape));
    }

    void read_group(const Value& group) {
        std::vector<std::string> keys{"rule",   "count",     "center",  "extent",
                                      "radius", "materials", "velocity"};
        std::vector<std::string> all = keys;
        all.insert(all.end(), {"seed", "arms", "turns", "width"});
        if (!group.find("rule")) group.with_keys(all);
        const std::string& rule =
            group.at("rule").word({"plane", "sphere", "ball", "galaxy", "sunflower"});
        if (rule != "sunflower") keys.push_back("seed");
        if (rule == "galaxy") keys.insert(keys.end(), {"arms", "turns", "width"});
        group.with_keys(keys);

        const Value wanted = group.at("count");
        const auto count =
            static_cast<int>(wanted.whole(1, static_cast<std::uint64_t>(limits_.spheres)));
        if (count > room())
            wanted.fail("is " + std::to_string(count) + ", but a scene may have only " +
                        std::to_string(limits_.spheres) + " spheres, and " +
                        std::to_string(room()) + (room() == 1 ? " is left" : " are left"));
        const Vec3 center = vec3(group, "center", {});
        const placing::Ball space = placing::ball_of({center, number(group.at("extent"), lengths)});
        const auto [low, high] = radii(group.at("radius"));

        std::vector<placing::Ball> balls;
        if (rule == "sunflower") {
            balls = placing::sunflower(count, space, low, high);
            for (const placing::Ball& ball : balls) there_.add(ball);
        } else {
            const auto seed = group.find("seed");
            balls = placing::scatter(count, std::min(low, high), std::max(low, high),
                                     placing_rule(rule, group, space), there_,
                                     seed ? seed->whole(0, max_seed) : 1);
            if (static_cast<int>(balls.size()) < count && there_.is_tired())
                wanted.fail("is " + std::to_string(count) +
                            ", but it takes too long to find room for them between " +
                            "the others; ask for fewer spheres, or a larger extent");
            if (static_cast<int>(balls.size()) < count)
                wanted.fail("is " + std::to_string(count) + ", but only " +
                            std::to_string(balls.size()) + (balls.size() == 1 ? " fits" : " fit") +
                            " without overlapping; ask for fewer or smaller spheres, or "
                            "a larger extent");
        }
        add(balls, group);
    }

    static placing::Rule placing_rule(const std::string& rule, const Value& group,
                                      const placing::Ball& space) {
        if (rule == "plane") return placing::on_plane(space);
        if (rule == "sphere") return placing::on_sphere(space);
        if (rule == "ball") return placing::in_ball(space);
        const auto arms = group.find("arms");
        return placing::galaxy(space, arms ? static_cast<int>(arms->whole(1, 100)) : 2,
                               static_cast<double>(number(group, "turns", {-100, 100}, 1)),
                               static_cast<double>(number(group, "width", shares, Real(0.25))));
    }

    // One radius for all, or [smallest, largest].
    static std::pair<double, double> radii(const Value& value) {
        if (!value.is_list()) {
            const auto radius = static_cast<double>(number(value, lengths));
            return {radius, radius};
        }
        const Value::List ends = value.list("two radii");
        if (ends.size() != 2)
            value.fail("must be a radius or a list of two, not a list of " +
                       std::to_string(ends.size()));
        return {static_cast<double>(number(ends[0], lengths)),
                static_cast<double>(number(ends[1], lengths))};
    }

    void add(const std::vector<placing::Ball>& balls, const Value& group) {
        const Value::List names = group.at("materials").list("names of materials");
        if (names.empty()) group.at("materials").fail("must name one material or more");
        std::vector<Material*> choice;
        SphereDescription sphere;
        for (const Value& name : names) {
            choice.push_back(&named(materials_, name, "material"));
            read_velocity(group, *choice.back(), sphere.velocity);
        }
        for (const placing::Ball& ball : balls) {
            Rng random{scene_.spheres.size(), 81};
            sphere.shape = placing::sphere_of(ball);
            sphere.material = use(*choice[random() % choice.size()]);
            scene_.spheres.push_back(sphere);
        }
    }

    void read_render(const Value& render) {
        render.with_keys({"width", "height", "spp", "depth", "seed"});
        RenderSettings& to = scene_.settings;
        const auto read = [&](const char* key, int& setting, std::uint64_t most) {
            if (const auto value = render.find(key))
                setting = static_cast<int>(value->whole(1, most));
        };
        read("width", to.width, 65'536);
        read("height", to.height, 65'536);
        read("spp", to.samples_per_pixel, 1'000'000);
        read("depth", to.depth, 1'000'000);
        const std::int64_t most_pixels = limits_.pixels;
        if (std::int64_t{to.width} * to.height > most_pixels)
            render.fail("asks for " + std::to_string(to.width) + " times " +
                        std::to_string(to.height) + " pixels; " + std::to_string(most_pixels) +
                        " are allowed");
        if (const auto seed = render.find("seed")) to.seed = seed->whole(0, max_seed);
    }

    const std::string& name_;
    const ReadNeighbor& read_;
    const Limits& limits_;
    const OtherShapes& others_;
    int pixels_left_ = limits_.image_pixels;
    SceneDescription scene_;
    placing::Neighbors there_;  // all spheres so far
    std::vector<int> ends_;     // how many spheres there were after "spheres" and after each group
    std::map<std::string, Texture> textures_;
    std::map<std::string, Material> materials_;
};

}  // namespace

SceneDescription parse_scene(const std::string& text, const std::string& name,
                             const ReadNeighbor& read, const Limits& limits,
                             const OtherShapes& others) {
    return Reader{name, read, limits, others}.read(Value::parse(text, name, "the scene"));
}

SceneDescription parse_scene(const std::string& text, const std::string& name,
                             const fs::path& folder, const Limits& limits,
                             const OtherShapes& others) {
    const auto read = [&](const Value& where, const std::string& file, const std::string& kind,
                          std::size_t most_bytes) {
        return read_neighbor(where, file, folder, kind, most_bytes);
    };
    return parse_scene(text, name, ReadNeighbor{read}, limits, others);
}

SceneDescription read_scene(const fs::path& file, const OtherShapes& others) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
    return parse_scene(app::read_input_file(file, file.string(), app::max_json_bytes),
                       file.string(), folder, {}, others);
}

}  // namespace effects
