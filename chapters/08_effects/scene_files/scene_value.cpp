#include "scene_value.hpp"

#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <cmath>
#include <rt/inverse.hpp>
#include <rt/transform.hpp>
#include <stdexcept>
#include <system_error>

namespace effects {
namespace {

namespace fs = std::filesystem;
using namespace rt;

constexpr Range turns{-360, 360}, stretches{0.001, 1000};

}  // namespace

Mat4 read_stretched(const Value& sphere, const Sphere& plain) {
    Vec3 scale{1, 1, 1}, turn;
    if (const auto given = sphere.find("scale"))
        scale = vec3_within(*given, "three numbers [x, y, z]", stretches);
    if (const auto given = sphere.find("rotate_deg"))
        turn = vec3_within(*given, "three angles [x, y, z]", turns);
    const Mat4 turned =
        multiply(rotation_z(radians(turn.z)),
                 multiply(rotation_y(radians(turn.y)), rotation_x(radians(turn.x))));
    return multiply(translation(plain.center), multiply(turned, scaling(plain.radius * scale)));
}

Mat4 read_matrix(const Value& matrix) {
    const Value::List rows = matrix.list("three rows of four numbers");
    if (rows.size() != 3)
        matrix.fail("must be a list of three rows, not of " + std::to_string(rows.size()));
    Mat4 map;
    for (int row = 0; row < 3; ++row) {
        const Value given = rows[static_cast<std::size_t>(row)];
        const Value::List numbers = given.list("four numbers");
        if (numbers.size() != 4)
            given.fail("must be a list of four numbers, not of " + std::to_string(numbers.size()));
        for (int column = 0; column < 4; ++column)
            map(row, column) = number(numbers[static_cast<std::size_t>(column)], coordinates);
    }
    return map;
}

void expect_not_flat(const Value& where, const Mat4& map, const std::string& shape) {
    bool flat = false;
    try {
        const Mat4 back = inverse(map);
        for (int i = 0; i < 9; ++i)
            flat = flat || !(std::abs(back(i / 3, i % 3)) <= static_cast<Real>(lengths.high));
    } catch (const std::domain_error&) {
        flat = true;
    }
    if (flat)
        where.fail("is a singular matrix, or nearly so: it flattens the " + shape +
                   "; its first three columns must point in three directions of space");
}

std::string read_neighbor(const Value& file, const std::string& given, const fs::path& folder,
                          const std::string& kind, std::size_t most) {
    const fs::path path{given};
    const std::string shown = app::quoted(given);
    if (given.empty() || given.find('\0') != std::string::npos)
        file.fail("must name " + kind + " file in the scene's folder");
    const bool leaves =
        path.is_absolute() || std::find(path.begin(), path.end(), fs::path{".."}) != path.end();
    std::error_code error;
    const fs::path home = fs::canonical(folder, error);
    const fs::path found = error ? fs::path{} : fs::weakly_canonical(home / path, error);
    // A link in the folder may lead outside, too.
    const bool inside =
        !error &&
        std::mismatch(home.begin(), home.end(), found.begin(), found.end()).first == home.end();
    if (leaves || !inside)
        file.fail("is " + shown +
                  ", which leads out of the scene's folder; only files in that folder "
                  "are read");
    try {
        return app::read_input_file(found, shown + " in the scene's folder", most);
    } catch (const app::UsageError& wrong) {
        file.fail("names " + kind + ": " + wrong.what());
    }
}

}  // namespace effects
