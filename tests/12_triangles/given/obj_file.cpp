#include <rt/make_mesh.hpp>
#include <rt/polygons.hpp>

#include "../shapes.hpp"

using checkpoint::real;
using rt::Corner;

TEST_CASE("an OBJ file gives its polygons") {
    const rt::Polygons all = rt::read_obj(
        "# a comment\no thing\nv 0 0 0\nv 1.5 0 -2e-1\nv 1 1 0\nv 0 1 0\nvn 0 0 2\nvt 0.25 0.75\n"
        "usemtl gold\ns off\nf 1 2 3 4\nf 1/1/1 2/1/1 3/1/1\nf 1//1 2//1 -1//-1\nf -4 -3 -2\n");
    REQUIRE(all.points.size() == 4);
    CHECK(rt::max_component(all.points[1] - rt::Vec3{real(1.5), 0, real(-0.2)}) < 4 * rt::epsilon);
    REQUIRE(all.normals.size() == 1);
    CHECK(all.normals[0] == rt::Vec3{0, 0, 2});
    REQUIRE(all.places.size() == 1);
    // The library may round a number's last digit.
    CHECK(std::abs(all.places[0].x - real(0.25)) < 2 * rt::epsilon);
    CHECK(std::abs(all.places[0].y - real(0.75)) < 2 * rt::epsilon);
    REQUIRE(all.polygons.size() == 4);
    CHECK(all.polygons[0] == std::vector<Corner>{{0}, {1}, {2}, {3}});
    CHECK(all.polygons[1] == std::vector<Corner>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    CHECK(all.polygons[2] == std::vector<Corner>{{0, 0, -1}, {1, 0, -1}, {3, 0, -1}});
    CHECK(all.polygons[3] == std::vector<Corner>{{0}, {1}, {2}});
    CHECK(rt::make_mesh(all).triangles.size() == 5);
}

TEST_CASE("what cannot be read in an OBJ file is refused with its line") {
    for (const auto& [bytes, words] : std::vector<std::pair<const char*, const char*>>{
             {"v 0 0 0\nv 1 two 3\n", "line 2"},
             {"v 0 0\n", "line 1"},
             {"vn 0 inf 1\n", "line 1"},
             {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 0 2\n", "line 4"}}) {
        std::string said = "nothing was thrown";
        try {
            rt::read_obj(bytes);
        } catch (const std::invalid_argument& wrong) {
            said = wrong.what();
        }
        INFO(bytes << "\nsaid: " << said);
        CHECK(said.find(words) != std::string::npos);
        CHECK(said.find('\n') == std::string::npos);
    }
    CHECK(rt::read_obj("").polygons.empty());
}
