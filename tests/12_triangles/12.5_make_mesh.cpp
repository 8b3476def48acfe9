#include <rt/make_mesh.hpp>
#include <stdexcept>

#include "shapes.hpp"

using namespace checkpoint;
using rt::Corner;
using rt::Mesh;
using rt::Polygons;

namespace {

std::vector<Corner> corners(std::initializer_list<int> points) {
    std::vector<Corner> all;
    for (const int point : points) all.push_back({point});
    return all;
}

// Twice the area of all triangles together, along their normals.
ExactVec3 area_of(const Mesh& mesh) {
    ExactVec3 sum;
    for (const Triangle& triangle : shapes_of(mesh)) sum = sum + exact_normal(triangle);
    return sum;
}

Vec3 normal_of(const Mesh& mesh, const Corner& corner) {
    return corner.normal < 0 ? Vec3{} : mesh.normals.at(static_cast<std::size_t>(corner.normal));
}

// Checks the normal of each corner; expected_at(point) is what belongs there.
template <class Expected>
void check_normals(const Mesh& mesh, const Expected& expected_at, const std::string& what,
                   const char* hint) {
    for (const auto& triangle : mesh.triangles)
        for (const Corner& corner : triangle) {
            const Vec3 expected = expected_at(corner.point), actual = normal_of(mesh, corner);
            INFO(what << "; the corner at point " << corner.point);
            HINT(expected, actual, hint);
            CHECK(rt::max_component(actual - expected) <= 4 * rt::epsilon);
        }
}

void check_first_normal(const Mesh& mesh, Vec3 expected, Real allowed, const char* hint) {
    const Vec3 actual = normal_of(mesh, mesh.triangles[0][0]);
    HINT(expected, actual, hint);
    CHECK(rt::max_component(actual - expected) <= allowed);
}

void check_refused(const Polygons& polygons, const std::string& words, const std::string& what) {
    INFO(what << " must be refused: throw a std::invalid_argument whose message contains '" << words
              << "'");
    std::string said = "nothing was thrown";
    try {
        rt::make_mesh(polygons);
    } catch (const std::invalid_argument& wrong) {
        said = wrong.what();
    }
    INFO("the message of your function: " << said);
    CHECK(said.find(words) != std::string::npos);
}

Polygons square() {
    Polygons all;
    all.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    all.polygons = {corners({0, 1, 2, 3})};
    return all;
}

// A cube of side 2 around the origin, whose sides are cut along other diagonals from seed to seed.
Mesh cube(rt::Rng& rng) {
    Polygons all;
    for (int i = 0; i < 8; ++i)
        all.points.push_back({real(i & 1 ? 1 : -1), real(i & 2 ? 1 : -1), real(i & 4 ? 1 : -1)});
    const std::initializer_list<int> sides[] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& side : sides) {
        auto around = corners(side);
        std::rotate(around.begin(), around.begin() + rng() % 4, around.end());
        all.polygons.push_back(around);
    }
    return rt::make_mesh(all);
}

}  // namespace

TEST_CASE("12.5 a square becomes two triangles", "[12.5]") {
    const Mesh mesh = rt::make_mesh(square());
    INFO("Hint: a polygon of n corners becomes n - 2 triangles, a fan from one of its corners");
    REQUIRE(mesh.triangles.size() == 2);
    CHECK(mesh.points.size() == 4);
    for (const Triangle& triangle : shapes_of(mesh)) {
        INFO(text(triangle) << ": " EXPECTED "(b - a) x (c - a) of length 1 along z, " ACTUAL
                            << text(exact_normal(triangle)));
        INFO("Hint: keep the order of the polygon's corners");
        CHECK(std::abs((exact_normal(triangle).z - Exact(1)).high) < 1e-6);
    }
}

TEST_CASE("12.5 polygons with any number of corners keep the order of their corners", "[12.5]") {
    for (const int n : {3, 4, 5, 6, 7, 8, 9, 300}) {
        Polygons all;
        double area = 0;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * 3.14159265358979 * i / n;
            all.points.push_back({real(std::cos(angle)), real(std::sin(angle)), 0});
            area += std::sin(2 * 3.14159265358979 / n);
        }
        std::vector<Corner> around;
        for (int i = 0; i < n; ++i) around.push_back({i});
        for (int i = 0; i < 3; ++i) all.points.push_back(all.points[static_cast<std::size_t>(i)]);
        all.polygons = {corners({n, n + 1, n + 2}), around};
        const Mesh mesh = rt::make_mesh(all);
        INFO("the polygons are a triangle, and then a polygon with " << n << " corners");
        REQUIRE(mesh.triangles.size() == static_cast<std::size_t>(n - 1));
        auto front = mesh.triangles[0];
        std::rotate(front.begin(), std::find(front.begin(), front.end(), Corner{n}), front.end());
        CHECK(front == std::array<Corner, 3>{Corner{n}, Corner{n + 1}, Corner{n + 2}});
        const double first = exact_normal(shapes_of(mesh)[0]).z.high;
        const double actual = area_of(mesh).z.high - first;
        INFO(EXPECTED "twice the area " << area << ", " ACTUAL << actual);
        CHECK(std::abs(actual - area) < 1e-5);
        for (const Triangle& triangle : shapes_of(mesh)) CHECK(exact_normal(triangle).z.high > 0);
    }
}

TEST_CASE("12.5 each corner keeps its normal and its texture coordinates", "[12.5]") {
    Polygons all = square();
    all.normals = {{0, 0, 5}, {3, 0, 4}, {0, 4, 3}};  // no corner has the last one
    all.uvs = {{0, 0}, {1, 0}, {1, 1}};
    all.polygons = {{{0, 0, 0}, {1, 1, 1}, {2, -1, 2}, {3, 0, -1}}};
    const Mesh mesh = rt::make_mesh(all);
    REQUIRE(mesh.triangles.size() == 2);
    REQUIRE(mesh.uvs.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        INFO("Hint: the texture coordinates stay as they are; y grows upward in a mesh, too");
        CHECK((mesh.uvs[i].x == all.uvs[i].x && mesh.uvs[i].y == all.uvs[i].y));
    }
    for (const auto& triangle : mesh.triangles)
        for (const Corner& corner : triangle) {
            const Corner& given = all.polygons[0].at(static_cast<std::size_t>(corner.point));
            INFO("the corner at point " << corner.point);
            INFO("Hint: move whole corners, each with its three indices");
            CHECK(corner.normal == given.normal);
            CHECK(corner.uv == given.uv);
        }
    {
        INFO("Hint: normalize the normals");
        CHECK(rt::max_component(normal_of(mesh, {0, 1}) - Vec3{real(0.6), 0, real(0.8)}) <=
              4 * rt::epsilon);
        CHECK(rt::max_component(normal_of(mesh, {0, 0}) - Vec3{0, 0, 1}) <= 4 * rt::epsilon);
    }
    INFO("Hint: normalize all normals, also those that no corner has");
    REQUIRE(mesh.normals.size() >= 3);
    CHECK(rt::max_component(normal_of(mesh, {0, 2}) - Vec3{0, real(0.8), real(0.6)}) <=
          4 * rt::epsilon);
}

TEST_CASE("12.5 indices out of range are refused", "[12.5]") {
    const auto with_third = [](const std::vector<Corner>& polygon) {
        Polygons all = square();
        all.normals = {{0, 0, 1}};
        all.uvs = {{0, 0}};
        all.polygons = {corners({0, 1, 2}), corners({0, 2, 3}), polygon, corners({0, 1, 2})};
        return all;
    };
    // As any of five corners.
    const auto check_corner = [&](const Corner& wrong, const std::string& what) {
        for (int place = 0; place < 5; ++place) {
            std::vector<Corner> polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
            polygon.insert(polygon.begin() + place, wrong);
            check_refused(with_third(polygon), "polygon 3",
                          what + " at corner " + std::to_string(place + 1) + " of 5");
        }
    };
    const std::string only = " (-1 stands for none, and no other index below 0 does)";
    check_corner({4, 0, 0}, "a point beyond the last");
    check_corner({65'536, 0, 0}, "the point 65536 of 4");
    check_corner({-1, 0, 0}, "a point before the first");
    check_corner({0, 1, 0}, "a normal beyond the last");
    check_corner({0, 65'536, 0}, "the normal 65536 of 1");
    check_corner({0, -2, 0}, "a normal with the index -2" + only);
    check_corner({0, -65'536, 0}, "a normal with the index -65536" + only);
    check_corner({0, 0, 1}, "texture coordinates beyond the last");
    check_corner({0, 0, 65'536}, "texture coordinates 65536 of 1");
    check_corner({0, 0, -2}, "texture coordinates with the index -2" + only);
    check_corner({0, 0, -65'536}, "texture coordinates with the index -65536" + only);
    INFO("the index -1 is allowed: it says that a corner has no normal or no texture coordinates");
    CHECK(rt::make_mesh(with_third({{1, -1, 0}, {0, 0, -1}, {3}})).triangles.size() == 4);
}

TEST_CASE("12.5 polygons with too few corners are refused", "[12.5]") {
    for (const auto& few : {corners({}), corners({0}), corners({0, 1})}) {
        Polygons all = square();
        all.polygons.resize(299, corners({0, 1, 2}));
        all.polygons.push_back(few);
        check_refused(all, "polygon 300", "a polygon with fewer than three corners");
    }
    CHECK(rt::make_mesh({}).triangles.empty());
}

TEST_CASE("12.5 the normals of a ball point outward", "[12.5]") {
    Mesh mesh = ball(2);
    const std::size_t points = mesh.points.size();
    rt::add_normals(mesh);
    CHECK(mesh.points.size() == points);
    {
        INFO("the ball has " << points << " points and " << mesh.triangles.size() << " triangles");
        INFO("Hint: all corners at one point share a normal, so there are no more than points");
        CHECK(mesh.normals.size() <= points);
    }
    for (const auto& triangle : mesh.triangles)
        for (const Corner& corner : triangle) {
            const Vec3 normal = normal_of(mesh, corner);
            const Vec3 expected = mesh.points[static_cast<std::size_t>(corner.point)];
            const Real cosine =
                static_cast<Real>(dot(exact_vector(normal), exact_vector(expected)).high);
            const double length = exact_length(exact_vector(normal)).high;
            if (cosine > real(0.99) && std::abs(length - 1) <= 8 * static_cast<double>(rt::epsilon))
                continue;
            HINT(expected, normal,
                 "add up the cross products of all triangles around the point, then normalize");
            REQUIRE(cosine > real(0.99));
            REQUIRE(std::abs(length - 1) <= 8 * static_cast<double>(rt::epsilon));
        }
    const auto& first = mesh.triangles.front();
    for (const auto& triangle : mesh.triangles)
        for (const Corner& corner : triangle)
            if (corner.point == first[0].point) {
                INFO(
                    "Hint: give all corners at one point the same normal, so that no edge can be "
                    "seen");
                CHECK(normal_of(mesh, corner) == normal_of(mesh, first[0]));
            }
}

TEST_CASE("12.5 normals given in the file are kept", "[12.5]") {
    Polygons all = square();
    all.normals = {{1, 0, 0}, {0, 1, 0}};
    all.uvs = {{0, 0}, {1, 1}};
    all.polygons = {{{0, 1, 0}, {1, -1, 1}, {2, 0, -1}, {3, -1, -1}}};
    Mesh mesh = rt::make_mesh(all);
    rt::add_normals(mesh);
    for (const auto& triangle : mesh.triangles)
        for (const Corner& corner : triangle) {
            INFO("the corner at point " << corner.point);
            INFO("Hint: a new normal changes nothing else in a corner");
            CHECK(corner.uv == all.polygons[0].at(static_cast<std::size_t>(corner.point)).uv);
        }
    const auto expected_at = [](int point) {
        return point == 0 ? Vec3{0, 1, 0} : point == 2 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    };
    check_normals(mesh, expected_at,
                  "a square whose first and third corner have normals of their own",
                  "only corners without a normal get one");
}

TEST_CASE("12.5 a triangle counts in proportion to its area", "[12.5]") {
    // Seen from their common edge, the first triangle has twice the area of the second, and twice
    // its angle: 90 degrees and 45.
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, real(0.5), real(0.5)}};
    mesh.triangles = {{Corner{0}, {1}, {2}}, {Corner{0}, {2}, {3}}};
    rt::add_normals(mesh);
    check_first_normal(
        mesh, Vec3{1, 0, 2} / std::sqrt(Real(5)), 4 * rt::epsilon,
        "add up the cross products as they are: each is as long as twice its triangle's area");
}

TEST_CASE("12.5 triangles that have normals count for their neighbors' normals", "[12.5]") {
    // Two triangles of the same area and with the same angles at their common edge.
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.normals = {{0, 1, 0}};
    mesh.triangles = {{Corner{0, 0}, {1, 0}, {2, 0}}, {Corner{0}, {2}, {3}}};
    rt::add_normals(mesh);
    for (const std::size_t k : {0, 1}) {
        const Vec3 expected = Vec3{1, 0, 1} / std::sqrt(Real(2));
        const Vec3 actual = normal_of(mesh, mesh.triangles[1][k]);
        HINT(expected, actual,
             "all triangles around the point count, even those whose own corners have normals");
        CHECK(rt::max_component(actual - expected) <= 4 * rt::epsilon);
    }
}

TEST_CASE("12.5 a mesh may have many points", "[12.5]") {
    constexpr int first = 70'000;  // of the points that are used
    Polygons all;
    all.points.resize(first);
    for (const Vec3& point : square().points) all.points.push_back(point);
    all.normals.assign(first, {0, 1, 0});
    all.normals.push_back({1, 0, 0});
    all.polygons = {{{first, first}, {first + 1}, {first + 2}, {first + 3}}};
    Mesh mesh = rt::make_mesh(all);
    rt::add_normals(mesh);
    REQUIRE(mesh.triangles.size() == 2);
    const char* const what = "a square after 70,000 points and normals that it does not use";
    const char* const hint = "the indices are numbers of type int; no smaller type will do";
    const auto expected_at = [&](int point) {
        INFO(what << "\nHint: " << hint);
        REQUIRE(point >= first);
        return point == first ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    };
    check_normals(mesh, expected_at, what, hint);
}

TEST_CASE("12.5 no triangle of a polygon with a notch lies outside the polygon", "[12.5][hard]") {
    Polygons all;
    // An arrowhead, whose third corner points inward.
    all.points = {{0, 0, 0}, {4, 4, 0}, {0, 2, 0}, {-4, 4, 0}};
    for (int start = 0; start < 4; ++start) {
        auto around = corners({0, 1, 2, 3});
        std::rotate(around.begin(), around.begin() + start, around.end());
        all.polygons = {around};
        const Mesh mesh = rt::make_mesh(all);
        for (const Triangle& triangle : shapes_of(mesh)) {
            INFO("the arrowhead, beginning at its corner " << start << " on: " << text(triangle));
            INFO("Hint: look for a corner from which all triangles of the fan face the same way");
            CHECK(exact_normal(triangle).z.high > 0);
        }
    }
    // Turned in space, and with more corners: a crown of two points.
    all.points = {{0, 0, 0}, {1, 0, 3}, {2, 0, 1}, {3, 0, 3}, {4, 0, 0}};
    for (int start = 0; start < 5; ++start) {
        auto around = corners({0, 1, 2, 3, 4});
        std::rotate(around.begin(), around.begin() + start, around.end());
        all.polygons = {around};
        const Mesh crown = rt::make_mesh(all);
        REQUIRE(crown.triangles.size() == 3);
        for (const Triangle& triangle : shapes_of(crown)) {
            INFO("the crown, beginning at its corner " << start << " on: " << text(triangle));
            CHECK(exact_normal(triangle).y.high > 0);
        }
    }
}

TEST_CASE("12.5 a fan may have to start at a corner that is no notch", "[12.5][hard]") {
    // From the origin to a zigzag around it: no other corner sees all of it.
    std::vector<Vec3> points{{0, 0, 0}};
    for (int i = 0; i < 9; ++i) {
        const double angle = 0.17 * i, far = i % 2 == 0 ? 4 : 2;
        points.push_back({real(far * std::cos(angle)), 0, real(-far * std::sin(angle))});
    }
    for (const int power : {-30, 0, 30})
        for (int start = 0; start < 10; ++start) {
            Polygons all;
            for (const Vec3 point : points)
                all.points.push_back(std::scalbn(Real(1), power) * point);
            auto around = corners({0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
            std::rotate(around.begin(), around.begin() + start, around.end());
            all.polygons = {around};
            for (const Triangle& triangle : shapes_of(rt::make_mesh(all))) {
                INFO("a zigzag around its first corner, scaled by 2^"
                     << power << ", beginning at its corner " << start
                     << " on: " << text(triangle));
                INFO(
                    "Hint: try all corners, and look at all triangles of each fan. Compare an area "
                    "with 0, as polygons may have any size");
                REQUIRE(exact_normal(triangle).y.high > 0);
            }
        }
    SUCCEED();
}

TEST_CASE("12.5 a polygon without a valid fan is still cut", "[12.5][hard]") {
    Polygons all;
    all.points = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}};  // on a line
    all.polygons = {corners({0, 1, 2, 3}), corners({2, 2, 2})};
    CHECK(rt::make_mesh(all).triangles.size() == 3);
}

TEST_CASE("12.5 a corner in the middle of a side makes no triangle of area 0", "[12.5][hard]") {
    Polygons all = square();
    all.points.push_back({real(0.5), 0, 0});
    for (int start = 0; start < 5; ++start) {
        auto around = corners({0, 4, 1, 2, 3});
        std::rotate(around.begin(), around.begin() + start, around.end());
        all.polygons = {around};
        for (const Triangle& triangle : shapes_of(rt::make_mesh(all))) {
            INFO("a square with a corner in the middle of a side: " << text(triangle));
            INFO("Hint: start the fan at that corner");
            CHECK(exact_normal(triangle).z.high > 0);
        }
    }
}

TEST_CASE("12.5 normals of length 0 count as missing", "[12.5][hard]") {
    Polygons all = square();
    all.normals = {{0, 0, 0}, {0, 0, 1}};
    all.polygons = {{{0, 0}, {1, 1}, {2, 0}, {3, 1}}};
    const Mesh mesh = rt::make_mesh(all);
    for (const auto& triangle : mesh.triangles)
        for (const Corner& corner : triangle)
            if (corner.point % 2 == 0)
                CHECK(corner.normal == -1);
            else
                CHECK(normal_of(mesh, corner) == Vec3{0, 0, 1});
}

TEST_CASE("12.5 tiny and huge normals are scaled to length 1", "[12.5][hard]") {
    for (const Real size : {for_this_precision(Real(1e-30), Real(1e-200)),
                            for_this_precision(Real(1e30), Real(1e200))}) {
        Polygons all = square();
        all.normals = {{0, 0, size}};
        all.polygons = {{{0, 0}, {1, 0}, {2, 0}, {3, 0}}};
        const Mesh mesh = rt::make_mesh(all);
        CHECK(normal_of(mesh, mesh.triangles[0][0]) == Vec3{0, 0, 1});
    }
}

TEST_CASE("12.5 a cube's normals do not depend on how its sides are cut", "[12.5][hard]") {
    rt::Rng rng{125, 1};
    for (int i = 0; i < 50; ++i) {
        Mesh mesh = cube(rng);
        const Mesh plain = mesh;
        // At any scale, and as a box whose sides have other areas, too.
        for (Vec3& point : mesh.points) {
            point *= std::scalbn(Real(1), 2 * (i - 25));
            if (i % 2 == 0) point = {point.x, 2 * point.y, 5 * point.z};
        }
        const auto turned = [&](Vec3 p) {
            return i % 4 < 2 ? p
                             : Vec3{real(0.6) * p.x - real(0.8) * p.z, p.y,
                                    real(0.8) * p.x + real(0.6) * p.z};
        };
        for (Vec3& point : mesh.points) point = turned(point);
        rt::add_normals(mesh);
        for (const auto& triangle : mesh.triangles)
            for (const Corner& corner : triangle) {
                const Vec3 point = plain.points[static_cast<std::size_t>(corner.point)];
                const Vec3 expected = turned(point / std::sqrt(Real(3)));
                const Vec3 actual = normal_of(mesh, corner);
                const bool right = rt::max_component(actual - expected) <= 16 * rt::epsilon;
                if (right) continue;
                HINT(expected, actual,
                     "weight each triangle's normal, of length 1, by its angle at the point");
                REQUIRE(right);
            }
    }
    SUCCEED();
}

TEST_CASE("12.5 an obtuse angle counts for more than a right angle", "[12.5][hard]") {
    // The angles at the first point are 135 and 45 degrees, and the areas are 1/2 and 8.
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, -1, 0}, {0, 1, 0}, {0, 4, 0}, {0, 4, 4}};
    mesh.triangles = {{Corner{0}, {1}, {2}}, {Corner{0}, {3}, {4}}};
    rt::add_normals(mesh);
    check_first_normal(
        mesh, Vec3{1, 0, 3} / std::sqrt(Real(10)), 16 * rt::epsilon,
        "the angle of atan2 is between 0 and pi; a sine is the same for 135 degrees as for 45");
}

TEST_CASE("12.5 a corner gets no normal where the normals cancel", "[12.5][hard]") {
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {9, 9, 9}};
    // Both sides of one triangle, and one without area.
    mesh.triangles = {{Corner{0}, {1}, {2}}, {Corner{1}, {0}, {2}}, {Corner{1}, {3}, {3}}};
    rt::add_normals(mesh);
    for (const auto& triangle : mesh.triangles)
        for (const Corner& corner : triangle) {
            INFO("the corner at point " << corner.point);
            CHECK(corner.normal == -1);
        }
}

TEST_CASE("12.5 a triangle without area leaves its neighbors' normals alone", "[12.5][hard]") {
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
    mesh.triangles = {{Corner{0}, {1}, {2}}, {Corner{0}, {1}, {3}}, {Corner{0}, {0}, {1}}};
    rt::add_normals(mesh);
    for (std::size_t k = 0; k < 3; ++k)
        CHECK(normal_of(mesh, mesh.triangles[0][k]) == Vec3{0, 0, 1});
    CHECK(mesh.triangles[1][2].normal == -1);
}
