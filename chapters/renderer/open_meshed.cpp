#include "open_meshed.hpp"

#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <app/limits.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <rt/close_cracks.hpp>
#include <rt/cut_ears.hpp>
#include <rt/make_mesh.hpp>
#include <rt/transform.hpp>
#include <stdexcept>
#include <utility>
#include <variant>

#include "final_scene.hpp"
#include "open_scene.hpp"
#include "scene_file.hpp"
#include "scene_value.hpp"

namespace full_renderer {
namespace {

namespace fs = std::filesystem;
using namespace rt;
using effects::Value;

// Of all mesh files of a scene together, and of all places of meshes.
constexpr std::size_t most_triangles = 10'000'000, most_placed = 2'000'000'000;

// A mesh as it stands in a file.
struct FileMesh {
    std::shared_ptr<const Mesh> mesh;
    Box box;
    const char* place = "";  // what `lines` counts
    // For each triangle the line of its polygon, and its material, an index into the names; -1:
    // none.
    std::vector<int> lines, materials;
    std::vector<std::string> material_names, material_files;
    TriangleMaterials in_scene =
        {};  // the materials as the scene numbers them, once they are known
};

bool is_ply(const std::string& bytes) {
    return bytes.rfind("ply\n", 0) == 0 || bytes.rfind("ply\r", 0) == 0;
}

// The mesh in the bytes of an OBJ or PLY file, with smooth normals (true), without them (false), or
// as the file has them (none). Throws std::invalid_argument, which says what is wrong with the
// file.
FileMesh parse_mesh(std::string bytes, std::optional<bool> smooth, const Reading& reading) {
    Polygons polygons = is_ply(bytes) ? read_ply(bytes, most_triangles, reading)
                                      : read_obj(bytes, most_triangles, reading);
    bytes = {};  // a large file needs the memory
    cut_ears(polygons);
    Mesh mesh = make_mesh(polygons);
    if (mesh.triangles.empty()) throw std::invalid_argument("it has no polygons");
    mesh.colors = std::move(polygons.colors);
    const bool has_normals = !mesh.normals.empty();
    if (!smooth.value_or(has_normals)) {
        for (auto& triangle : mesh.triangles)
            for (Corner& corner : triangle) corner.normal = -1;
        mesh.normals.clear();
    } else {
        add_normals(mesh);
    }
    FileMesh made;
    made.place = polygons.place;
    for (std::size_t i = 0; i < polygons.polygons.size(); ++i) {
        const std::size_t triangles = polygons.polygons[i].size() - 2;  // they are in order
        made.lines.insert(made.lines.end(), triangles, polygons.lines[i]);
        made.materials.insert(made.materials.end(), triangles, polygons.materials[i]);
    }
    if (made.lines.size() != mesh.triangles.size())
        throw std::invalid_argument(
            "its polygons should make " + std::to_string(made.lines.size()) +
            " triangles, and make_mesh made " + std::to_string(mesh.triangles.size()));
    close_cracks(mesh, made.materials);
    for (const Vec3& point : mesh.points) made.box = join(made.box, {point, point});
    made.mesh = std::make_shared<const Mesh>(std::move(mesh));
    made.material_names = std::move(polygons.material_names);
    made.material_files = std::move(polygons.material_files);
    return made;
}

// What a file's material is in the course, if it shows no image. Its image comes later.
MaterialDescription description_of(const FileMaterial& from) {
    if (from.ke != Color{}) return Emitter{from.ke};
    const bool is_glass = from.illum == 4 || from.illum == 6 || from.illum == 7 || from.illum == 9;
    const bool is_mirror = from.illum == 3 || from.illum == 5 || from.illum == 8;
    if (is_glass || from.d < 1) return Dielectric{from.ni > 1 ? from.ni : Real(1.5)};
    // The width of a highlight with this exponent.
    if (is_mirror) return Metal{from.ks, std::min(Real(1), std::sqrt(2 / (from.ns + 2)))};
    return Lambertian{from.kd};
}

// What of a file's material is not drawn, such as "Ks"; empty if all of it is.
std::string not_drawn(const FileMaterial& from, const MaterialDescription& drawn) {
    std::string all;
    const auto say = [&](const std::string& what) { all += (all.empty() ? "" : ", ") + what; };
    const bool is_matte = std::holds_alternative<Lambertian>(drawn),
               is_lamp = std::holds_alternative<Emitter>(drawn);
    if (is_lamp && from.kd != Color{}) say("Kd");
    if ((is_matte || is_lamp) && from.ks != Color{}) say("Ks");
    if (!is_matte && !from.map_kd.empty()) say("map_Kd");
    for (const std::string& map : from.others) say(map);
    return all;
}

class MeshReader {
  public:
    MeshReader(const effects::ReadNeighbor& read, const Say& say) : read_{read}, say_{say} {}

    MeshDescription read(const Value& mesh, effects::SceneMaterials& materials) {
        using effects::lengths;
        mesh.with_keys({"file", "center", "size", "scale", "rotate_deg", "matrix", "material",
                        "emits", "smooth"});
        if (mesh.find("material") && mesh.find("emits"))
            mesh.fail("has both material and emits; a mesh that shines reflects nothing");
        MeshDescription to;
        if (const auto matrix = mesh.find("matrix")) {
            for (const char* other : {"center", "size", "scale", "rotate_deg"})
                if (mesh.find(other))
                    mesh.fail("has both matrix and " + std::string{other} +
                              "; the matrix alone says everything");
            to.object_to_world = effects::read_matrix(*matrix);
            effects::expect_not_flat(*matrix, to.object_to_world, "mesh");
        } else {
            to.object_to_world = effects::read_stretched(
                mesh,
                {effects::vec3(mesh, "center", {}), effects::number(mesh, "size", lengths, 1)});
        }
        std::optional<bool> smooth;
        if (const auto given = mesh.find("smooth")) smooth = given->yes();
        const Value file = mesh.at("file");
        FileMesh& from = mesh_of(file, smooth);
        to.mesh = from.mesh;
        expect_near(file, from, to.object_to_world);
        placed_ += to.mesh->triangles.size();
        if (placed_ > most_placed)
            file.fail("makes " + std::to_string(placed_) +
                      " triangles in all places; a scene may have " + std::to_string(most_placed));
        if (const auto emits = mesh.find("emits")) {
            to.material = materials.add(Emitter{effects::color(*emits, effects::light)});
        } else if (const auto material = mesh.find("material")) {
            to.material = materials.named(*material);
            if (materials.shows_image(to.material))
                for (std::size_t i = 0; i < from.lines.size(); ++i) expect_place(file, from, i);
        } else if (!from.mesh->colors.empty()) {
            if (!white_) white_ = materials.add(Lambertian{{1, 1, 1}});
            to.material = *white_;
            to.shows_colors = true;
        } else {
            if (!from.in_scene) from.in_scene = read_materials(mesh, from, materials);
            to.materials = from.in_scene;
        }
        return to;
    }

    std::vector<std::string> notes;  // what of the files is not drawn, a line each

  private:
    // The file is read once, however often the mesh is placed.
    FileMesh& mesh_of(const Value& file, std::optional<bool> smooth) {
        const std::string name = file.text("the name of a mesh file");
        FileMesh& mesh = meshes_[{name, smooth}];
        if (mesh.mesh) return mesh;
        std::string bytes = read_(file, name, "a mesh", std::size_t{1} << 31);
        const std::string kind = is_ply(bytes) ? "PLY" : "OBJ";
        try {
            mesh = parse_mesh(std::move(bytes), smooth, [&](double part) {
                if (say_)
                    say_("reading " + name + ": " + std::to_string(std::lround(100 * part)) + " %");
            });
        } catch (const std::invalid_argument& wrong) {
            file.fail("is " + app::quoted(name) + ", which is not a readable " + kind +
                      " file: " + wrong.what());
        }
        triangles_ += mesh.mesh->triangles.size();
        if (triangles_ > most_triangles)
            file.fail("makes " + std::to_string(triangles_) +
                      " triangles in all files; a scene may have " +
                      std::to_string(most_triangles));
        return mesh;
    }

    // Fails if a point is too far away, in the file or in its place.
    static void expect_near(const Value& file, const FileMesh& from, const Mat4& object_to_world) {
        const auto most = static_cast<Real>(effects::lengths.high);
        const auto is_near = [&](const Vec3& point) {
            return max_component(point) <= most &&
                   max_component(transform_point(object_to_world, point)) <= most;
        };
        bool all_are = true;
        for (const Real x : {from.box.low.x, from.box.high.x})
            for (const Real y : {from.box.low.y, from.box.high.y})
                for (const Real z : {from.box.low.z, from.box.high.z})
                    all_are = all_are && is_near({x, y, z});
        // A corner of the box need not be a point of the mesh.
        if (all_are || std::all_of(from.mesh->points.begin(), from.mesh->points.end(), is_near))
            return;
        file.fail("has a point that is more than " + app::number_text(effects::lengths.high) +
                  " from the origin, in the file or in its place");
    }

    // The material of each triangle, as the file says. A material of the scene file goes before one
    // of the same name in the mesh's material files.
    TriangleMaterials read_materials(const Value& mesh, const FileMesh& from,
                                     effects::SceneMaterials& materials) {
        const Value file = mesh.at("file");
        const auto none = std::find(from.materials.begin(), from.materials.end(), -1);
        if (none != from.materials.end())
            mesh.fail("needs \"material\" or \"emits\", because the polygon in " +
                      place_of(from, static_cast<std::size_t>(none - from.materials.begin())) +
                      " of its file has none (usemtl)");
        std::vector<int> of_name, of_triangle;
        for (const std::string& name : from.material_names) {
            const auto known = materials.find(name);
            of_name.push_back(known ? *known : file_material(file, name, from, materials));
        }
        for (const int number : from.materials) {
            if (materials.shows_image(of_name[static_cast<std::size_t>(number)]))
                expect_place(file, from, of_triangle.size());
            of_triangle.push_back(of_name[static_cast<std::size_t>(number)]);
        }
        return std::make_shared<const std::vector<int>>(std::move(of_triangle));
    }

    static std::string place_of(const FileMesh& from, std::size_t triangle) {
        return from.place + (' ' + std::to_string(from.lines[triangle]));
    }

    int file_material(const Value& file, const std::string& name, const FileMesh& from,
                      effects::SceneMaterials& materials) {
        const fs::path folder = fs::path{file.text("a name")}.parent_path();
        for (const std::string& library : from.material_files) {
            const std::string path = (folder / library).generic_string();
            if (const auto known = file_materials_.find({path, name});
                known != file_materials_.end())
                return known->second;
            for (const FileMaterial& one : library_of(file, path)) {
                if (one.name != name) continue;
                MaterialDescription description = description_of(one);
                const std::string lost = not_drawn(one, description);
                if (!lost.empty())
                    notes.push_back(path + ": \"" + name + "\" is drawn without " + lost);
                if (!one.map_kd.empty() && std::holds_alternative<Lambertian>(description))
                    description = PictureMatte{
                        materials.add_image(file, (folder / one.map_kd).generic_string())};
                return file_materials_[{path, name}] = materials.add(description);
            }
        }
        std::string where;
        for (const std::string& library : from.material_files)
            where += ", and " + app::quoted(library) + " does not have it";
        file.fail("uses the material " + app::quoted(name) + ", which is not among \"materials\"" +
                  (where.empty() ? ", and the file names no material file (mtllib)" : where));
    }

    const std::vector<FileMaterial>& library_of(const Value& file, const std::string& path) {
        const auto known = libraries_.find(path);
        if (known != libraries_.end()) return known->second;
        const std::string bytes = read_(file, path, "a material", 1 << 24);
        try {
            return libraries_[path] = read_mtl(bytes);
        } catch (const std::invalid_argument& wrong) {
            file.fail("names " + app::quoted(path) +
                      ", which is not a readable material file: " + wrong.what());
        }
    }

    // Fails if an image has no place on a triangle.
    static void expect_place(const Value& file, const FileMesh& from, std::size_t triangle) {
        for (const Corner& corner : from.mesh->triangles[triangle])
            if (corner.uv < 0)
                file.fail("is " + app::quoted(file.text("a name")) + ", and the polygon in " +
                          place_of(from, triangle) +
                          " has no texture coordinates that say where the image goes");
    }

    const effects::ReadNeighbor& read_;
    const Say& say_;
    std::size_t triangles_ = 0, placed_ = 0;  // so far, in files and in places
    std::optional<int> white_;                // the material of meshes that show colors
    std::map<std::pair<std::string, std::optional<bool>>, FileMesh> meshes_;
    std::map<std::string, std::vector<FileMaterial>> libraries_;
    std::map<std::pair<std::string, std::string>, int> file_materials_;
};

}  // namespace

MeshedDescription parse_scene(const std::string& text, const std::string& name,
                              const effects::ReadNeighbor& read, const Say& say) {
    MeshReader reader{read, say};
    std::vector<MeshDescription> meshes;
    const auto read_one = [&](const Value& mesh, effects::SceneMaterials& materials) {
        meshes.push_back(reader.read(mesh, materials));
    };
    SceneDescription scene = effects::parse_scene(text, name, read, {}, {"meshes", read_one});
    return {std::move(scene), std::move(meshes), std::move(reader.notes)};
}

MeshedDescription read_scene(const fs::path& file, const Say& say) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
    return parse_scene(
        app::read_input_file(file, file.string(), app::max_json_bytes), file.string(),
        [&](const Value& where, const std::string& named, const std::string& kind,
            std::size_t most_bytes) {
            return effects::read_neighbor(where, named, folder, kind, most_bytes);
        },
        say);
}

MeshedDescription open_scene(const app::Settings& settings, const Say& say) {
    MeshedDescription scene;
    if (settings.file.empty())
        scene = {effects::final_scene(), {}};
    else
        scene = read_scene(settings.file, say);
    effects::replace_by_given(scene.settings, settings);
    return scene;
}

}  // namespace full_renderer
