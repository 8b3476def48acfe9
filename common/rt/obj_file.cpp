#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <rt/counted.hpp>
#include <rt/polygons.hpp>
#include <rt/take_word.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace rt {
namespace {

// The number that a word stands for; none if it is none.
std::optional<double> number_of(std::string_view word) {
    const std::string copy{word};
    char* end = nullptr;
    const double number = std::strtod(copy.c_str(), &end);
    const bool is_nan = std::isnan(number) && !word.empty() && *end == '\0';  // "-nan(ind)"
    const bool is_plain = !word.empty() && word.find_first_not_of("0123456789+-.eE") == word.npos &&
                          std::isfinite(number) && *end == '\0';
    if (!is_nan && !is_plain) return {};
    return number;
}

// A corner's numbers as they stand in a file, of its point, texture coordinate and normal; 0: left
// out.
using CornerNumbers = std::array<int, 3>;

// What a word such as 7, 7/1, 7//3 or 7/1/3 stands for; a slash too many does no harm. None if it
// is no corner.
std::optional<CornerNumbers> corner_of(std::string_view word) {
    CornerNumbers numbers{};
    for (int& number : numbers) {
        const std::string_view text = word.substr(0, word.find('/'));
        const bool is_left_out = text.empty() && &number != &numbers[0];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (!is_left_out &&
            (error != std::errc{} || end != text.data() + text.size() || number == 0))
            return {};
        if (text.size() == word.size()) return numbers;
        word.remove_prefix(text.size() + 1);
    }
    return {};
}

// Reads a file line by line.
class ObjReader {
  public:
    ObjReader(std::string_view bytes, std::size_t most_triangles, const Reading& reading)
        : rest_{bytes}, room_{most_triangles} {
        if (rest_.substr(0, 3) == "\xef\xbb\xbf") rest_.remove_prefix(3);  // it only says: UTF-8
        if (rest_.substr(0, 2) == "\xff\xfe" || rest_.substr(0, 2) == "\xfe\xff")
            throw std::invalid_argument("it is UTF-16 text; save it as UTF-8");
        while (!rest_.empty()) {
            take_line();
            if (reading && number_ % 65'536 == 0)
                reading(1 - static_cast<double>(rest_.size()) / static_cast<double>(bytes.size()));
        }
        for (std::size_t list = 0; list < 3; ++list)
            if (largest_[list].number > counts_[list]) {
                number_ = largest_[list].line;
                refuse_number(list, largest_[list].number);
            }
    }

    Polygons all;

  private:
    struct Largest {
        int number = 0, line = 0;
    };
    static constexpr std::array<const char*, 3> kinds{"v", "vt", "vn"};

    [[noreturn]] void refuse(const std::string& what) const {
        throw std::invalid_argument("line " + std::to_string(number_) + ' ' + what);
    }
    [[noreturn]] void refuse_number(std::size_t list, int number) const {
        constexpr std::array<const char*, 3> names{"point", "texture coordinate", "normal"};
        refuse("names " + std::string{names[list]} + ' ' + std::to_string(number) +
               ", and there are " + std::to_string(counts_[list]) + " (lines that begin with " +
               kinds[list] + ')');
    }
    [[noreturn]] void refuse_word(std::string_view word, const std::string& wanted) const {
        refuse("has '" + std::string{word.substr(0, 20)} + "' where a " + wanted);
    }

    // Takes a line. One that ends with a backslash goes on in the next.
    void take_line() {
        number_ = next_number_;
        std::string joined;
        for (bool goes_on = true; goes_on && !rest_.empty();) {
            std::string_view line = rest_.substr(0, rest_.find_first_of("\n\r"));
            rest_.remove_prefix(line.size());
            rest_.remove_prefix(rest_.substr(0, 2) == "\r\n" ? 2 : rest_.empty() ? 0 : 1);
            ++next_number_;
            if (line.find('\0') != line.npos) refuse("has a byte 0: this is no text file");
            goes_on = !line.empty() && line.back() == '\\';
            if (goes_on) line.remove_suffix(1);
            (joined += line) += ' ';
        }
        std::string_view line = std::string_view{joined}.substr(0, joined.find('#'));
        const std::string_view kind = take_word(line);
        if (kind == "fo") refuse("begins with 'fo'; polygons begin with 'f'");
        const auto list = std::find(kinds.begin(), kinds.end(), kind);
        if (kind == "f")
            take_polygon(line);
        else if (list != kinds.end())
            take_numbers(static_cast<std::size_t>(list - kinds.begin()), line);
        else if (kind == "mtllib")
            all.material_files.push_back(rest_of(line));
        else if (kind == "usemtl")
            take_material(rest_of(line));
    }

    // A name, which may have blanks within it.
    static std::string rest_of(std::string_view line) {
        const std::string_view first = take_word(line);
        std::string name{first};
        for (std::string_view word; !(word = take_word(line)).empty();) (name += ' ') += word;
        return name;
    }

    void take_material(const std::string& name) {
        const auto [known, is_new] =
            material_numbers_.emplace(name, static_cast<int>(all.material_names.size()));
        if (is_new) all.material_names.push_back(name);
        material_ = known->second;
    }

    void take_numbers(std::size_t list, std::string_view line) {
        ++counts_[list];
        const std::size_t used = list == 1 ? 2 : 3;
        std::array<Real, 3> numbers{};
        std::size_t count = 0;
        for (std::string_view word; count < used && !(word = take_word(line)).empty(); ++count) {
            const auto number = number_of(word);
            if (!number)
                refuse_word(word, word.find(',') == word.npos
                                      ? "number belongs"
                                      : "number belongs; it needs a point, not a comma");
            // A normal that is not known is none.
            if (std::isnan(*number) && list != 2) refuse_word(word, "number belongs");
            numbers[count] = std::isnan(*number) ? 0 : static_cast<Real>(*number);
            if (!std::isfinite(numbers[count])) refuse("has a number that is too large");
        }
        if (count < (list == 1 ? 1 : 3)) refuse("has too few numbers");
        if (const std::string_view weight = take_word(line);
            list == 0 && !weight.empty() && take_word(line).empty() && number_of(weight) != 1.0)
            refuse("has a weight of " + std::string{weight.substr(0, 20)} +
                   " after the three coordinates; only 1 can be drawn");
        const auto [x, y, z] = numbers;
        if (list == 1)
            all.uvs.push_back({x, y});
        else
            (list == 0 ? all.points : all.normals).push_back({x, y, z});
    }

    void take_polygon(std::string_view line) {
        std::vector<Corner> polygon;
        for (std::string_view word; !(word = take_word(line)).empty();) {
            auto corner = corner_of(word);
            if (!corner) refuse_word(word, "corner belongs, such as 7, 7/1, 7//3 or 7/1/3");
            for (std::size_t list = 0; list < 3; ++list) {
                int& number = (*corner)[list];
                if (number < -counts_[list]) refuse_number(list, number);
                if (number < 0) number += counts_[list] + 1;
                if (number > largest_[list].number) largest_[list] = {number, number_};
            }
            const auto [point, uv, normal] = *corner;
            polygon.push_back({point - 1, normal - 1, uv - 1});
        }
        const std::size_t count = polygon.size();
        if (count < 3 || count > most_corners)
            refuse("has a polygon of " + counted(count, "corner") + ", not 3 to " +
                   std::to_string(most_corners));
        if (count - 2 > room_) refuse("is where the triangles become too many");
        room_ -= count - 2;
        polygon.shrink_to_fit();
        all.polygons.push_back(std::move(polygon));
        all.lines.push_back(number_);
        all.materials.push_back(material_);
    }

    std::string_view rest_;
    std::size_t room_;  // triangles that there may still be
    int number_ = 0, next_number_ = 1;
    std::array<int, 3> counts_{};  // of points, texture coordinates and normals so far
    std::array<Largest, 3> largest_{};
    std::map<std::string, int> material_numbers_;
    int material_ = -1;  // of the next polygons
};

// The first line of the library's message.
std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

}  // namespace

Polygons read_obj(const std::string& bytes, std::size_t most_triangles, const Reading& reading) {
    return std::move(ObjReader{bytes, most_triangles, reading}.all);
}

std::vector<FileMaterial> read_mtl(const std::string& bytes) {
    std::istringstream in{bytes};
    std::map<std::string, int> numbers;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    tinyobj::LoadMtl(&numbers, &materials, &in, &warning, &error);
    if (!error.empty()) throw std::invalid_argument(first_line(error));
    std::vector<FileMaterial> all;
    for (const tinyobj::material_t& from : materials) {
        if (from.name.empty()) continue;  // the library's own, if there is no other
        const auto number = [&](const char* name, tinyobj::real_t x, double most) {
            if (!(x >= 0 && x <= most))
                throw std::invalid_argument(std::string{name} + " of material '" + from.name +
                                            "' must be a number from 0 to " +
                                            std::to_string(static_cast<long>(most)));
            return static_cast<Real>(x);
        };
        const auto color = [&](const char* name, const tinyobj::real_t(&c)[3], double most) {
            return Color{number(name, c[0], most), number(name, c[1], most),
                         number(name, c[2], most)};
        };
        FileMaterial to{from.name,
                        color("Kd", from.diffuse, 1),
                        color("Ks", from.specular, 1),
                        color("Ke", from.emission, 1e6),
                        number("Ns", from.shininess, 1e6),
                        number("Ni", from.ior, 1000),
                        number("d", from.dissolve, 1),
                        from.illum,
                        from.diffuse_texname,
                        {}};
        for (const auto& [name, file] : {std::pair{"map_Ks", from.specular_texname},
                                         {"map_Ns", from.specular_highlight_texname},
                                         {"map_Bump", from.bump_texname},
                                         {"norm", from.normal_texname},
                                         {"disp", from.displacement_texname},
                                         {"map_d", from.alpha_texname},
                                         {"map_Ke", from.emissive_texname}})
            if (!file.empty()) to.others.push_back(name);
        all.push_back(std::move(to));
    }
    return all;
}

}  // namespace rt
