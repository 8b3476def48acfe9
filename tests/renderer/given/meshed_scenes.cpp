// Scenes with meshes: what they need, and how their files are read.

#include <app/errors.hpp>
#include <lit_meshes.hpp>
#include <open_meshed.hpp>
#include <rt/choose_renderer.hpp>
#include <rt/image_file.hpp>
#include <tile_workers.hpp>

#include "../../08_effects/scenes.hpp"
#include "temporary_folder.hpp"

using namespace checkpoint;
using full_renderer::has_lamp_meshes;
using full_renderer::make_pixel_renderer;
using rt::Effects;

TEST_CASE("a mesh calls for the same effects as a sphere of its material") {
    for (const rt::NamedEffect& effect : rt::all_effects) {
        Effects one;
        one.*effect.member = true;
        rt::MeshedDescription scene{scene_with(one), {}};
        std::erase_if(scene.spheres, [&](const rt::SphereDescription& sphere) {
            const bool can_be_mesh = sphere.map < 0 && sphere.velocity == rt::Vec3{};
            if (can_be_mesh) scene.meshes.push_back({nullptr, {}, sphere.material});
            return can_be_mesh;
        });
        INFO(effect.name << ": found to be " << names(needed_effects(scene)));
        CHECK((needed_effects(scene) == one));
    }
}

TEST_CASE("a mesh file is read once, however often it is placed") {
    const TemporaryFolder folder;
    write_file(folder / "one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write_file(folder / "scene.json",
               R"({"camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0]},
                   "materials": {"m": {"type": "matte", "color": "#ffffff"}}, "meshes": [
            {"file": "one.obj", "material": "m"},
            {"file": "one.obj", "material": "m", "center": [1, 0, 0]},
            {"file": "one.obj", "material": "m", "smooth": true}]})");
    const auto scene = full_renderer::read_scene(folder / "scene.json");
    REQUIRE(scene.meshes.size() == 3);
    CHECK(scene.meshes[0].mesh == scene.meshes[1].mesh);
    CHECK(scene.meshes[0].mesh->normals.empty());
    CHECK(scene.meshes[1].object_to_world(0, 3) == 1);
    CHECK(scene.meshes[2].mesh->normals.size() == 3);
}

TEST_CASE("a mesh that a matrix mirrors keeps its outside") {
    const TemporaryFolder folder;
    write_file(folder / "one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    const auto normals_in = [&](const std::string& matrix) {
        write_file(folder / "scene.json",
                   R"({"camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0]},
                       "materials": {"m": {"type": "matte", "color": "#ffffff"}}, "meshes": [
                {"file": "one.obj", "material": "m", "matrix": )" +
                       matrix + "}]}");
        auto placed = meshes_of(full_renderer::read_scene(folder / "scene.json"));
        const rt::Vec3 normal = placed.mesh_of(0).normal(placed.mesh_of(0).corners(0)[1]);
        placed.make_copies();
        const rt::PlacedMesh& mesh = placed.mesh_of(0);
        CHECK(mesh.normal(mesh.corners(0)[1]) == normal);
        const auto [a, b, c] = mesh.triangle(0).shape;
        const auto [first, second, third] = mesh.triangles()[0].shape;  // of a copy
        CHECK((a == first && b == second && c == third));
        return std::pair{normalize(cross(b - a, c - a)), mesh.normal(mesh.corners(0)[1])};
    };
    const auto [flat, smooth] = normals_in("[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]");
    CHECK((flat == rt::Vec3{0, 0, 1} && smooth == rt::Vec3{0, 0, 1}));
    const auto [mirrored, its_smooth] = normals_in("[[-1, 0, 0, 7], [0, 1, 0, 0], [0, 0, 1, 0]]");
    CHECK((mirrored == rt::Vec3{0, 0, 1} && its_smooth == rt::Vec3{0, 0, 1}));
    const auto [below, its_normal] = normals_in("[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0]]");
    CHECK((below == rt::Vec3{0, 0, -1} && its_normal == rt::Vec3{0, 0, -1}));
}

namespace {

// A square in the plane of x and y; its texture coordinates are its corners.
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

// The scene of a mesh file, with these members beside "file" and these materials.
rt::MeshedDescription with_mesh(const TemporaryFolder& folder, const std::string& obj,
                                const std::string& members = "",
                                const std::string& materials = "") {
    write_file(folder / "one.obj", obj);
    write_file(folder / "scene.json", R"({"camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0]},
        "materials": {)" + materials + R"(}, "meshes": [{"file": "one.obj")" +
                                          members + "}]}");
    return full_renderer::read_scene(folder / "scene.json");
}

// What is said about such a scene, without the name of its file.
std::string refusal(const TemporaryFolder& folder, const std::string& obj,
                    const std::string& members = "", const std::string& materials = "") {
    try {
        with_mesh(folder, obj, members, materials);
    } catch (const app::UsageError& error) {
        const std::string words = error.what();
        return words.substr(words.find(": ") + 2);
    }
    return "";
}

// The library may round a number's last digit.
void check_color(rt::Color actual, rt::Color expected) {
    INFO(actual << ", expected " << expected);
    CHECK((std::abs(actual.r - expected.r) < 4 * rt::epsilon &&
           std::abs(actual.g - expected.g) < 4 * rt::epsilon &&
           std::abs(actual.b - expected.b) < 4 * rt::epsilon));
}

const std::string white = R"("m": {"type": "matte", "color": "#ffffff"})";

}  // namespace

TEST_CASE("a mesh has the materials of its file") {
    const TemporaryFolder folder;
    write_file(folder / "place.png", rt::encode_png(rt::Image{2, 2, {1, 0, 0}}));
    write_file(folder / "all.mtl",
               "newmtl red\nKd 0.8 0.1 0.2\nKs 0.5 0.5 0.5\n"
               "newmtl clear\nNi 1.33\nillum 7\nnewmtl shiny\nKs 0.9 0.8 0.7\nNs 198\nillum 3\n"
               "newmtl picture\nKd 1 1 1\nmap_Kd place.png\nnewmtl unused\nKd 9 0 0\n");
    CHECK(refusal(folder, "mtllib all.mtl\n" + square + "usemtl red\nf 1 2 3\n") ==
          "meshes[0].file names \"all.mtl\", which is not a readable material file: Kd of material "
          "'unused' must be a number from 0 to 1");
    write_file(folder / "all.mtl",
               "newmtl red\nKd 0.8 0.1 0.2\nKs 0.5 0.5 0.5\n"
               "newmtl clear\nNi 1.33\nillum 7\nnewmtl shiny\nKs 0.9 0.8 0.7\nNs 198\nillum 3\n"
               "newmtl picture\nKd 1 1 1\nmap_Kd place.png\n"
               "newmtl neon\nKd 1 0 0\nKe 1 0 0.5\n");
    // The letter U has no fan: its triangles keep their polygon's material.
    const std::string letter =
        "v 0 0 1\nv 3 0 1\nv 3 3 1\nv 2 3 1\nv 2 1 1\nv 1 1 1\nv 1 3 1\nv 0 3 1\n";
    const auto scene = with_mesh(
        folder,
        "mtllib all.mtl\n" + square + letter +
            "usemtl red\nf 1 2 3 4\nusemtl clear\nf 5 6 7 8 9 10 11 12\n"
            "usemtl shiny\nf 1 2 3\nusemtl red\nf 1 2 4\n"
            "usemtl picture\nf 1/1 2/2 3/3\nusemtl mine\nf 1 3 4\nusemtl neon\nf 2 3 4\n",
        "",
        R"("mine": {"type": "metal", "color": [1, 1, 1]}, "clear": {"type": "glass", "index": 2})");
    REQUIRE(scene.meshes.size() == 1);
    const auto material = [&](std::size_t triangle) {
        const auto number = static_cast<std::size_t>(scene.meshes[0].materials->at(triangle));
        return scene.materials.at(number);
    };
    REQUIRE(scene.meshes[0].materials->size() == 2 + 6 + 1 + 1 + 1 + 1 + 1);
    for (const std::size_t i : {0, 1, 9})
        check_color(std::get<rt::Lambertian>(material(i)).albedo,
                    {real(0.8), real(0.1), real(0.2)});
    // What shines reflects nothing.
    check_color(std::get<rt::Emitter>(material(12)).radiance, {1, 0, real(0.5)});
    for (std::size_t i = 2; i < 8; ++i)  // the scene's own goes before the file's
        CHECK(std::get<rt::Dielectric>(material(i)).index == 2);
    check_color(std::get<rt::Metal>(material(8)).albedo, {real(0.9), real(0.8), real(0.7)});
    CHECK(std::abs(std::get<rt::Metal>(material(8)).fuzz - real(0.1)) < real(1e-6));
    CHECK(std::get<rt::PictureMatte>(material(10)).image == 0);
    CHECK(std::get<rt::Metal>(material(11)).fuzz == 0);
    CHECK(scene.notes == std::vector<std::string>{"all.mtl: \"red\" is drawn without Ks",
                                                  "all.mtl: \"neon\" is drawn without Kd"});
    // Each triangle that is placed has its material, and the effects are those of all.
    auto meshes = meshes_of(scene);
    meshes.make_copies();
    CHECK(meshes.mesh_of(0).triangles()[8].material == scene.meshes[0].materials->at(8));
    CHECK(meshes.mesh_of(0).material(8) == scene.meshes[0].materials->at(8));
    const Effects needed = needed_effects(scene);
    CHECK((needed.glass && needed.fuzz && needed.texture && needed.mirror && needed.lights));
    // The scene file may name one material for all.
    CHECK(!with_mesh(folder, "mtllib none.mtl\n" + square + "usemtl red\nf 1 2 3\n",
                     R"(, "material": "m")", white)
               .meshes[0]
               .materials);
}

TEST_CASE("a mesh without materials, or with some that nobody knows, is refused") {
    const TemporaryFolder folder;
    CHECK(
        refusal(folder, square + "f 1 2 3\nusemtl red\nf 1 3 4\n") ==
        "meshes[0] needs \"material\" or \"emits\", because the polygon in line 9 of its file has "
        "none (usemtl)");
    CHECK(
        refusal(folder, square + "usemtl red\nf 1 3 4\n") ==
        "meshes[0].file uses the material \"red\", which is not among \"materials\", and the file "
        "names no material file (mtllib)");
    write_file(folder / "all.mtl", "newmtl blue\n");
    CHECK(refusal(folder, "mtllib all.mtl\n" + square + "usemtl red\nf 1 3 4\n") ==
          "meshes[0].file uses the material \"red\", which is not among \"materials\", and "
          "\"all.mtl\" does not have it");
    CHECK(refusal(folder, "mtllib ../all.mtl\n" + square + "usemtl red\nf 1 3 4\n")
              .find("leads out of the scene's folder") != std::string::npos);
    CHECK(refusal(folder, "mtllib no.mtl\n" + square + "usemtl red\nf 1 3 4\n").find("no.mtl") !=
          std::string::npos);
}

TEST_CASE("an image on a mesh needs texture coordinates") {
    const TemporaryFolder folder;
    write_file(folder / "place.png", rt::encode_png(rt::Image{2, 2, {1, 0, 0}}));
    const std::string picture = R"("m": {"type": "matte", "texture": "t"}}, "textures": {
        "t": {"type": "image", "file": "place.png"})";
    CHECK(refusal(folder, square + "f 1/1 2/2 3/3\n\nf 1/1 3 4/4\n", R"(, "material": "m")",
                  picture) ==
          "meshes[0].file is \"one.obj\", and the polygon in line 11 has no texture coordinates "
          "that say where the image goes");
    CHECK(refusal(folder, square + "f 1/1 2/2 3/3\n", R"(, "material": "m")", picture) == "");
}

TEST_CASE("a mesh shines if it emits light, and lights a floor") {
    const TemporaryFolder folder;
    const std::string floor = R"("m": {"type": "matte", "color": [0.5, 0.5, 0.5]})";
    const auto lit = with_mesh(folder, square + "f 1 2 3 4\n", R"(, "emits": [3, 2, 1])", floor);
    CHECK(has_lamp_meshes(lit));
    CHECK(needed_effects(lit).lights);
    CHECK(!lit.meshes[0].materials);
    // The camera looks at the middle of the lamp.
    auto scene = lit;
    scene.camera.view.from = {real(0.5), real(0.5), 5};
    scene.camera.view.at = {real(0.5), real(0.5), 0};
    scene.camera.view.vertical_fov = real(0.01);
    std::uint64_t rays = 0;
    CHECK(make_pixel_renderer(scene, 1, 1, {1, 4, 1}).color(0, 0, rays) == rt::Color{3, 2, 1});
    // A floor far behind it that faces it gets light of the same color.
    scene.sky = {};
    scene.camera.view.from = {real(0.5), real(0.5), -2};
    scene.camera.view.at = {real(0.5), real(0.5), -12};
    scene.spheres.push_back({{{real(0.5), real(0.5), -1004}, 1000}, 0});
    scene.materials.insert(scene.materials.begin(),
                           rt::Lambertian{{real(0.5), real(0.5), real(0.5)}});
    ++scene.meshes[0].material;
    const rt::Color seen = make_pixel_renderer(scene, 1, 1, {256, 4, 1}).color(0, 0, rays);
    // 3 times the albedo, the solid angle at the distance 4 and both cosines, divided by pi.
    const double expected = 3 * 0.5 / 16 / 3.14159265358979;
    INFO(seen << ", expected about " << expected);
    CHECK(std::abs(seen.r - real(expected)) < real(0.04 * expected));
    CHECK(std::abs(seen.g / seen.r - Real(2) / 3) < 8 * rt::epsilon);

    const auto black = with_mesh(folder, square + "f 1 2 3 4\n", R"(, "emits": [0, 0, 0])", floor);
    CHECK_FALSE(has_lamp_meshes(black));
    CHECK_FALSE(needed_effects(black).lights);
    // A material of the scene file may be a light, too, and so may one of the mesh's file.
    CHECK(has_lamp_meshes(with_mesh(folder, square + "usemtl l\nf 1 2 3 4\n", "",
                                    R"("l": {"type": "light", "color": [1, 1, 1]})")));
}
