// libFuzzer's target: whatever bytes an OBJ or PLY file holds, they make a mesh that keeps its
// promises and can be drawn, or one line that says what is wrong.
#include <cmath>
#include <cstdint>
#include <rt/canvas.hpp>
#include <rt/cut_ears.hpp>
#include <rt/make_mesh.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/renderer.hpp>

#include "../../support/fuzzing.hpp"

namespace {

using fuzzing::must, fuzzing::is_index_of;

void check(const rt::Mesh& mesh) {
    for (const rt::Vec3& point : mesh.points) must(is_finite(point));
    for (const rt::Vec3& normal : mesh.normals) must(is_finite(normal));
    for (const rt::Vec2& uv : mesh.uvs) must(std::isfinite(uv.x) && std::isfinite(uv.y));
    for (const auto& triangle : mesh.triangles)
        for (const rt::Corner& corner : triangle) {
            must(is_index_of(mesh.points, corner.point));
            must(corner.normal == -1 || is_index_of(mesh.normals, corner.normal));
            must(corner.uv == -1 || is_index_of(mesh.uvs, corner.uv));
        }
}

// A few samples of the mesh, mirrored by its normals.
void draw(const std::shared_ptr<const rt::Mesh>& mesh) {
    constexpr rt::Effects effects{.mirror = true, .texture = true};
    constexpr int side = 4;
    rt::MeshedDescription scene;
    scene.camera.view = {.from = {0, 0, 5}, .at = {}, .up = {0, 1, 0}, .vertical_fov = 1};
    scene.images.push_back(rt::Canvas<rt::Color>{2, 2});
    scene.materials = {rt::Metal{{1, 1, 1}, 0}, rt::PictureMatte{0}};
    for (const int material : {0, 1})
        scene.meshes.push_back({mesh, rt::scaling({1, 1, 1}), material, {}, !mesh->colors.empty()});
    const rt::Renderer<effects, rt::MeshScene<effects>> renderer{
        scene, side, side, {2, 4, 1}, meshes_of(scene)};
    fuzzing::draw(renderer, side);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    try {
        rt::Polygons polygons = bytes.rfind("ply", 0) == 0 ? rt::read_ply(bytes, 100'000)
                                                           : rt::read_obj(bytes, 100'000);
        must(polygons.colors.empty() || polygons.colors.size() == polygons.points.size());
        must(polygons.lines.size() == polygons.polygons.size());
        cut_ears(polygons);
        must(polygons.lines.size() == polygons.polygons.size());
        must(polygons.materials.size() == polygons.polygons.size());
        for (const int material : polygons.materials)
            must(material == -1 || is_index_of(polygons.material_names, material));
        auto mesh = std::make_shared<rt::Mesh>(rt::make_mesh(polygons));
        mesh->colors = std::move(polygons.colors);
        // Chapter 08's reader of scenes refuses what is farther away.
        for (const rt::Vec3& point : mesh->points)
            if (!(rt::max_component(point) <= 1e9)) return 0;
        check(*mesh);
        if (mesh->triangles.size() > 50) return 0;
        draw(mesh);
        add_normals(*mesh);
        check(*mesh);
        draw(mesh);
        rt::read_mtl(bytes);
    } catch (const std::invalid_argument& error) {
        const std::string said = error.what();
        must(said.size() < 300 && said.find('\n') == said.npos);
    }
    return 0;
}
