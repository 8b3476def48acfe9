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
    CHECK(all.points[1] == rt::Vec3{real(1.5), 0, real(-0.2)});
    REQUIRE(all.normals.size() == 1);
    CHECK(all.normals[0] == rt::Vec3{0, 0, 2});
    REQUIRE(all.uvs.size() == 1);
    CHECK((all.uvs[0].x == real(0.25) && all.uvs[0].y == real(0.75)));
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
             {"v 0 0x1 0\n", "'0x1'"},
             {"v 0 0 1e999\n", "line 1"},
             {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 0 2\n", "line 4"},
             {"f 1 2 99999999999\n", "'99999999999'"},
             {"v 0 0 0\nf 1/0 1/0 1/0\n", "line 2 has '1/0'"},
             {"v 0,0 0,0 1,0\n", "it needs a point, not a comma"},
             {"v 0 0 0\nf 1.0 1.0 1.0\n", "such as 7, 7/1, 7//3 or 7/1/3"},
             {"v 0 0 0\nfo 1 1 1\n", "line 2 begins with 'fo'; polygons begin with 'f'"},
             {"v 0 0 0\nv 2 0 0 2\n", "line 2 has a weight of 2"},
             {"v 0 0 nan\n", "line 1 has 'nan'"},
             {"v 0 0 0\n\nf 1 2 1\n", "line 3 names point 2, and there are 1"},
             {"v 0 0 0\nf -1 -2 -1\n", "line 2 names point -2, and there are 1"},
             {"v 0 0 0\nf 1//1 1//1 1//1\n", "line 2 names normal 1, and there are 0"},
             {"v 0 0 0\nf 1/1 1/1 1/1\n", "line 2 names texture coordinate 1, and there are 0"},
             {"v 0 0 \\\n0\nv 1 \\\n0\n", "line 3 has too few numbers"},
             {"\xff\xfev", "it is UTF-16"},
             {"f 1 2 3-\n", "'3-'"},
             {"\nf 1 2\n", "line 2 has a polygon of 2 corners"}}) {
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

TEST_CASE("what an OBJ file has besides points and polygons is left out") {
    const rt::Polygons all = rt::read_obj(
        "mtllib none.mtl\nt crease 999999999/-1/7\nvw 1 2\nl 1 2\np 1\nv 0 0 0 \r\nv 1 0 0\r\n"
        "v 0 1 0\r\ng\nf 1 2 3\r\n\n");
    CHECK(all.points.size() == 3);
    CHECK(all.polygons == std::vector<std::vector<Corner>>{{{0}, {1}, {2}}});
}

TEST_CASE("a polygon of an OBJ file has up to 255 corners, and no other number of them") {
    std::string points, polygon = "f";
    for (int i = 1; i <= 256; ++i) {
        points += "v " + std::to_string(i) + " 0 0\n";
        polygon += ' ' + std::to_string(i);
        if (i == 255) CHECK(rt::read_obj(points + polygon).polygons[0].size() == 255);
    }
    CHECK_THROWS_AS(rt::read_obj(points + polygon), std::invalid_argument);
}

TEST_CASE("an OBJ file may be written in several ways") {
    const std::vector<std::vector<Corner>> square{{{0}, {1}, {2}, {3}}};
    const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const std::vector<std::string> files{
        "\xef\xbb\xbf" + points + "f 1 2 3 4",
        points + "f 1 2 \\\n3 4\n",
        points + "f 1 2 3 4 # a square\n",
        points + "f 1/ 2/ 3// 4\n",
        points + "vw nan\nf 1 2 3 4\n",
        "v 0 0 \\\r\n0\r\nv 1 0 0\r\nv 1 1 0 1.0\r\nv 0 1 0 0.5 0.5 nan\r\nf -4 -3 -2 -1\r\n",
        "v 0 0 0 # one\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r"};
    for (const std::string& bytes : files) {
        INFO(bytes);
        const rt::Polygons all = rt::read_obj(bytes);
        REQUIRE(all.points.size() == 4);
        CHECK(all.points[0] == rt::Vec3{0, 0, 0});
        CHECK(all.points[2] == rt::Vec3{1, 1, 0});
        CHECK(all.polygons == square);
    }
    // A normal that is no number is none.
    const rt::Polygons all =
        rt::read_obj(points + "vn -nan(ind) nan 1\nvn 0 0 1\nf 1//1 2//2 3//2\n");
    CHECK(all.normals[0] == rt::Vec3{0, 0, 1});
    CHECK(all.lines == std::vector<int>{7});
}

TEST_CASE("triangles that are too many are refused before they take memory") {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    CHECK(rt::read_obj(points + "f 1 2 3 4\nf 1 2 3\n", 3).polygons.size() == 2);
    CHECK_THROWS_WITH(rt::read_obj(points + "f 1 2 3 4\nf 1 2 3 4\n", 3),
                      "line 6 is where the triangles become too many");
}
