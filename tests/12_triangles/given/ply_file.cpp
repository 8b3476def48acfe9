#include <bit>
#include <cstring>
#include <rt/polygons.hpp>

#include "../shapes.hpp"

using checkpoint::real;
using rt::Corner;

namespace {

// The header of a file with these lines after the format.
std::string header(const std::string& format, const std::string& lines) {
    return "ply\nformat " + format + " 1.0\ncomment by hand\n" + lines + "end_header\n";
}

const std::string points =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
const std::string square = "0 0 0\n1.5 0 0\n1 1 0\n0 1 -2e-1\n4 0 1 2 3\n3 0 1 3\n";

// What is said of a file that cannot be read.
std::string refusal(const std::string& bytes, std::size_t most_triangles = 100) {
    try {
        rt::read_ply(bytes, most_triangles);
    } catch (const std::invalid_argument& wrong) {
        return wrong.what();
    }
    return "nothing was thrown";
}

// The bytes of numbers of these types, in either order.
template <class... Numbers>
std::string bytes_of(bool big, Numbers... numbers) {
    std::string all;
    const auto add = [&](auto number) {
        std::string one(sizeof number, '\0');
        std::memcpy(one.data(), &number, sizeof number);
        if (big == (std::endian::native == std::endian::little))
            std::reverse(one.begin(), one.end());
        all += one;
    };
    (add(numbers), ...);
    return all;
}

}  // namespace

TEST_CASE("a PLY file gives its polygons") {
    for (const std::string line_end : {"\n", "\r\n", "\r"}) {
        std::string bytes;
        for (const char c : header("ascii", points + faces) + square)
            bytes += c == '\n' ? line_end : std::string(1, c);
        const rt::Polygons all = rt::read_ply(bytes);
        REQUIRE(all.points.size() == 4);
        CHECK(all.points[1] == rt::Vec3{real(1.5), 0, 0});
        CHECK(all.points[3] == rt::Vec3{0, 1, real(-0.2)});
        CHECK(all.polygons ==
              std::vector<std::vector<Corner>>{{{0}, {1}, {2}, {3}}, {{0}, {1}, {3}}});
        CHECK(all.lines == std::vector<int>{15, 16});
        CHECK(all.materials == std::vector<int>{-1, -1});
        CHECK((all.normals.empty() && all.uvs.empty() && all.colors.empty()));
    }
    // The last line needs no end.
    CHECK(rt::read_ply(header("ascii", points + faces) + square.substr(0, square.size() - 1))
              .polygons.size() == 2);
}

TEST_CASE("a binary PLY file gives its polygons with normals, places and colors") {
    for (const bool big : {false, true}) {
        const std::string bytes =
            header(
                big ? "binary_big_endian" : "binary_little_endian",
                "obj_info scanned\nelement camera 1\nproperty list uint8 float32 views\n"
                "element vertex 3\nproperty double x\nproperty float y\nproperty short z\n"
                "property uchar quality\nproperty float nx\nproperty float ny\nproperty float nz\n"
                "property float s\nproperty float t\nproperty uchar red\nproperty uchar green\n"
                "property uchar blue\nproperty list uint8 uint16 neighbors\n"
                "element face 1\nproperty uchar flags\nproperty list int8 uint32 vertex_index\n") +
            bytes_of(big, std::uint8_t{2}, 1.0f, 2.0f) +
            bytes_of(big, 0.25, 1.0f, std::int16_t{-7}, std::uint8_t{9}, 0.0f, 0.0f, 2.0f, 0.5f,
                     0.75f, std::uint8_t{255}, std::uint8_t{0}, std::uint8_t{188},
                     std::uint8_t{0}) +
            bytes_of(big, 1.0, 0.0f, std::int16_t{0}, std::uint8_t{9}, std::nanf(""), 0.0f, 1.0f,
                     0.0f, 0.0f, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{1},
                     std::uint16_t{65535}) +
            bytes_of(big, 0.0, 1.0f, std::int16_t{0}, std::uint8_t{9}, 0.0f, 1.0f, 0.0f, 1.0f, 1.0f,
                     std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}) +
            bytes_of(big, std::uint8_t{1}, std::int8_t{3}, 0u, 2u, 1u);
        const rt::Polygons all = rt::read_ply(bytes);
        INFO(big);
        REQUIRE(all.points.size() == 3);
        CHECK(all.points[0] == rt::Vec3{real(0.25), 1, -7});
        CHECK(all.normals == std::vector<rt::Vec3>{{0, 0, 2}, {0, 0, 0}, {0, 1, 0}});
        CHECK(all.uvs[0] == rt::Vec2{real(0.5), real(0.75)});
        CHECK(all.colors[0] == rt::Color{1, 0, rt::srgb_decode(real(188) / 255)});
        CHECK(all.polygons == std::vector<std::vector<Corner>>{{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}}});
        CHECK(std::string{all.place} == "face");
        CHECK(all.lines == std::vector<int>{0});
        // However short it is cut, it is refused.
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            INFO(size);
            REQUIRE(refusal(bytes.substr(0, size)) != "nothing was thrown");
        }
    }
}

TEST_CASE("what cannot be read in a PLY file is refused with its place") {
    const std::string ascii = header("ascii", points + faces);
    const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    for (const auto& [bytes, words] : std::vector<std::pair<std::string, std::string>>{
             {"plyx\n", "line 1 must be ply"},
             {"ply\nformat ascii 1.0\n", "no line says end_header"},
             {"ply\nelement vertex 1\nend_header\n", "no line with format"},
             {header("utf8", points), "line 2 has the format 'utf8'; known are ascii"},
             {header("ascii", "property float x\n"), "line 4 comes before any element"},
             {header("ascii", "element vertex 1\nproperty real x\n"),
              "line 5 has 'real' where a type such as float or uchar belongs"},
             {header("ascii", "element vertex many\n"), "line 4 has 'many'"},
             {header("ascii", "elements 3\n"), "line 4 begins with 'elements'"},
             {header("ascii", "element vertex 1\nproperty float x\nproperty float z\n") + "0 0\n",
              "its vertices have no property y"},
             {header("ascii", points) + corners, "it has no entries of face"},
             {header("ascii", points + "element face 1\nproperty int x\n") + corners + "1\n",
              "its faces have no list vertex_indices"},
             {ascii + corners + "4 0 1 2 3\n3 0 1 4\n",
              "line 16, face 1, names a vertex that is not there: they go from 0 to 3"},
             {ascii + corners + "4 0 1 2 -1\n3 0 1 2\n", "line 15, face 0, names a vertex"},
             {ascii + corners + "2 0 1\n3 0 1 2\n", "line 15, face 0, has 2 corners"},
             {ascii + "0 0 0\n1 zero 0\n", "line 12, vertex 1, has 'zero' where a number belongs"},
             {ascii + "0 0 0\n1 nan 0\n", "line 12, vertex 1, has a y that is no number"},
             {ascii + corners + "4 0 1 2 3\n", "line 16, face 1, is where the file ends"},
             {ascii + corners + "999999 0 1 2 3\n", "line 15, face 0, has a list that is longer"},
             {header("binary_little_endian", "element vertex 2000000000\nproperty float x\n"),
              "it ends before its 2000000000 entries of vertex"}}) {
        const std::string said = refusal(bytes);
        INFO(bytes << "\nsaid: " << said);
        CHECK(said.find(words) != std::string::npos);
        CHECK(said.find('\n') == std::string::npos);
    }
    CHECK(refusal(ascii + square, 2) == "line 16, face 1, is where the triangles become too many");
    CHECK(refusal(ascii + square, 3) == "nothing was thrown");
}
