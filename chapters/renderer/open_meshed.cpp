#include "open_meshed.hpp"

#include <app/errors.hpp>
#include <map>
#include <memory>
#include <optional>
#include <rt/make_mesh.hpp>
#include <rt/transform.hpp>
#include <stdexcept>
#include <utility>

#include "final_scene.hpp"
#include "open_scene.hpp"
#include "scene_file.hpp"
#include "scene_value.hpp"

namespace full_renderer {
namespace {

namespace fs = std::filesystem;
using namespace rt;
using effects::Value;

constexpr std::size_t most_triangles = 4'000'000;  // of all meshes of a scene together

// The mesh in the bytes of an OBJ file, with smooth normals (true), without them (false), or as the
// file has them (none). Throws std::invalid_argument, which says what is wrong with the file.
Mesh parse_mesh(const std::string& bytes, std::optional<bool> smooth) {
    Mesh mesh = make_mesh(read_obj(bytes));
    if (mesh.triangles.empty()) throw std::invalid_argument("it has no polygons");
    const bool has_normals = !mesh.normals.empty();
    if (!smooth.value_or(has_normals)) {
        for (auto& triangle : mesh.triangles)
            for (Corner& corner : triangle) corner.normal = -1;
        mesh.normals.clear();
    } else {
        add_normals(mesh);
    }
    return mesh;
}

class MeshReader {
  public:
    explicit MeshReader(fs::path folder) : folder_{std::move(folder)} {}

    MeshDescription read(const Value& mesh, const effects::MaterialOf& material_of) {
        using effects::lengths;
        mesh.with_keys(
            {"file", "center", "size", "scale", "rotate_deg", "matrix", "material", "smooth"});
        MeshDescription to;
        to.material = material_of(mesh.at("material"));
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
        to.mesh = mesh_of(file, smooth);
        for (const Vec3& point : to.mesh->points)
            for (const Vec3& p : {point, transform_point(to.object_to_world, point)})
                if (!(max_component(p) <= static_cast<Real>(lengths.high)))
                    file.fail("has a point that is more than " + app::number_text(lengths.high) +
                              " from the origin, in the file or in its place");
        triangles_ += to.mesh->triangles.size();
        if (triangles_ > most_triangles)
            file.fail("makes " + std::to_string(triangles_) +
                      " triangles in all; a scene may have " + std::to_string(most_triangles));
        return to;
    }

  private:
    // The file is read once, however often the mesh is placed.
    std::shared_ptr<const Mesh> mesh_of(const Value& file, std::optional<bool> smooth) {
        std::shared_ptr<const Mesh>& mesh = meshes_[{file.text("the name of a mesh file"), smooth}];
        if (mesh) return mesh;
        const std::string bytes =
            effects::read_neighbor(file, folder_, "a mesh", std::size_t{1} << 28);
        try {
            mesh = std::make_shared<const Mesh>(parse_mesh(bytes, smooth));
        } catch (const std::invalid_argument& wrong) {
            file.fail("is " + app::quoted(file.text("a name")) +
                      ", which is not a readable OBJ file: " + wrong.what());
        }
        return mesh;
    }

    fs::path folder_;
    std::size_t triangles_ = 0;  // so far
    std::map<std::pair<std::string, std::optional<bool>>, std::shared_ptr<const Mesh>> meshes_;
};

}  // namespace

MeshedDescription read_scene(const fs::path& file) {
    MeshReader reader{file.has_parent_path() ? file.parent_path() : fs::path{"."}};
    std::vector<MeshDescription> meshes;
    const auto read_one = [&](const Value& mesh, const effects::MaterialOf& material_of) {
        meshes.push_back(reader.read(mesh, material_of));
    };
    return {effects::read_scene(file, {"meshes", read_one}), std::move(meshes)};
}

MeshedDescription open_scene(const app::Settings& settings) {
    MeshedDescription scene;
    if (settings.file.empty())
        scene = {effects::final_scene(), {}};
    else
        scene = read_scene(settings.file);
    effects::replace_by_given(scene.settings, settings);
    return scene;
}

}  // namespace full_renderer
