#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <rt/color.hpp>
#include <rt/counted.hpp>
#include <rt/polygons.hpp>
#include <rt/take_word.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace rt {
namespace {

struct Type {
    std::array<const char*, 2> names;
    std::size_t bytes;
    double (*value)(const char* bytes);  // in this machine's order
};
template <class T>
double value_of(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}
template <class T>
constexpr Type type_of(const char* name, const char* other) {
    return {{name, other}, sizeof(T), &value_of<T>};
}
constexpr std::array<Type, 8> types{
    type_of<std::int8_t>("char", "int8"),    type_of<std::uint8_t>("uchar", "uint8"),
    type_of<std::int16_t>("short", "int16"), type_of<std::uint16_t>("ushort", "uint16"),
    type_of<std::int32_t>("int", "int32"),   type_of<std::uint32_t>("uint", "uint32"),
    type_of<float>("float", "float32"),      type_of<double>("double", "float64")};

struct Property {
    std::string name;
    const Type* type;
    const Type* count;  // of a list's entries; null if it is no list
};
struct Element {
    std::string name;
    std::uint64_t count;
    std::vector<Property> properties;
};

// What a vertex may have, by the names that files use.
enum Role { x, y, z, nx, ny, nz, u, v, red, green, blue, roles };
constexpr std::array<std::array<std::string_view, 3>, roles> names_of_roles{
    {{"x"},
     {"y"},
     {"z"},
     {"nx"},
     {"ny"},
     {"nz"},
     {"u", "s", "texture_u"},
     {"v", "t", "texture_v"},
     {"red", "diffuse_red"},
     {"green", "diffuse_green"},
     {"blue", "diffuse_blue"}}};

class PlyReader {
  public:
    PlyReader(std::string_view bytes, std::size_t most_triangles, const Reading& reading)
        : rest_{bytes}, size_{bytes.size()}, room_{most_triangles}, reading_{reading} {
        read_header();
        ++line_;
        all.place = is_text_ ? "line" : "face";
        for (const Element& element : elements_) {
            // A file that promises more than it holds must not take memory for it.
            if (element.count > 0 && least_bytes(element) > rest_.size() / element.count)
                throw std::invalid_argument("it ends before its " + std::to_string(element.count) +
                                            " entries of " + element.name);
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                for (std::uint64_t i = 0; i < element.count; ++i) skip(element, i);
        }
        if (all.polygons.empty())
            throw std::invalid_argument("it has no entries of face, and so no surface");
    }

    Polygons all;

  private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw std::invalid_argument("line " + std::to_string(line_) + ' ' + what);
    }
    // What is wrong with an entry, counted from 0.
    [[noreturn]] void refuse(const Element& element, std::uint64_t number,
                             const std::string& what) const {
        throw std::invalid_argument((is_text_ ? "line " + std::to_string(line_) + ", " : "") +
                                    element.name + ' ' + std::to_string(number) + ", " + what);
    }

    void tell(std::uint64_t entry) const {
        if (reading_ && entry % 65'536 == 65'535)
            reading_(1 - static_cast<double>(rest_.size()) / static_cast<double>(size_));
    }

    std::string_view take_line() {
        ++line_;
        const std::size_t end = rest_.find_first_of("\r\n");
        if (end == rest_.npos) refuse("is the last one, and no line says end_header");
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
        return line;
    }
    const Type* type_named(std::string_view name) const {
        for (const Type& type : types)
            if (name == type.names[0] || name == type.names[1]) return &type;
        refuse("has '" + std::string{name.substr(0, 20)} +
               "' where a type such as float or uchar belongs");
    }

    void read_header() {
        if (take_line() != "ply") refuse("must be ply");
        bool has_format = false;
        for (;;) {
            std::string_view line = take_line();
            const std::string_view kind = take_word(line);
            if (kind == "end_header") break;
            if (kind == "format") {
                const std::string_view format = take_word(line);
                is_text_ = format == "ascii";
                is_reversed_ = (std::endian::native == std::endian::little) !=
                               (format == "binary_little_endian");
                if (!is_text_ && format != "binary_little_endian" && format != "binary_big_endian")
                    refuse("has the format '" + std::string{format.substr(0, 30)} +
                           "'; known are ascii, binary_little_endian and binary_big_endian");
                has_format = true;
            } else if (kind == "element") {
                const std::string_view name = take_word(line), count = take_word(line);
                std::uint64_t number = 0;
                const auto [end, error] =
                    std::from_chars(count.data(), count.data() + count.size(), number);
                if (error != std::errc{} || end != count.data() + count.size() || number > 1u << 31)
                    refuse("has '" + std::string{count.substr(0, 20)} +
                           "' where a number of entries belongs");
                elements_.push_back({std::string{name}, number, {}});
            } else if (kind == "property") {
                if (elements_.empty()) refuse("comes before any element");
                Property property{{}, nullptr, nullptr};
                std::string_view type = take_word(line);
                if (type == "list") {
                    property.count = type_named(take_word(line));
                    type = take_word(line);
                }
                property.type = type_named(type);
                property.name = take_word(line);
                elements_.back().properties.push_back(std::move(property));
            } else if (kind != "comment" && kind != "obj_info" && !kind.empty()) {
                refuse(
                    "begins with '" + std::string{kind.substr(0, 20)} +
                    "'; a header has lines with format, comment, element, property and end_header");
            }
        }
        if (!has_format) throw std::invalid_argument("its header has no line with format");
    }

    // The fewest bytes that an entry can take.
    std::size_t least_bytes(const Element& element) const {
        std::size_t bytes = 0;
        for (const Property& property : element.properties)
            bytes += is_text_ ? 1 : (property.count ? property.count : property.type)->bytes;
        return std::max<std::size_t>(bytes, 1);
    }

    double take(const Element& element, std::uint64_t number, const Type& type) {
        if (is_text_) return take_number(element, number);
        if (rest_.size() < type.bytes) refuse(element, number, "is where the file ends");
        std::array<char, 8> bytes{};
        for (std::size_t i = 0; i < type.bytes; ++i)
            bytes[is_reversed_ ? type.bytes - 1 - i : i] = rest_[i];
        rest_.remove_prefix(type.bytes);
        return type.value(bytes.data());
    }
    double take_number(const Element& element, std::uint64_t number) {
        std::size_t start = 0;
        for (; start < rest_.size() && std::strchr(" \t\r\n", rest_[start]); ++start)
            line_ += rest_[start] == '\n' ||
                     (rest_[start] == '\r' && rest_.substr(start + 1, 1) != "\n");
        rest_.remove_prefix(start);
        const std::string word{rest_.substr(0, rest_.find_first_of(" \t\r\n"))};
        if (word.empty()) refuse(element, number, "is where the file ends");
        rest_.remove_prefix(word.size());
        char* end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (*end || word.find_first_of("xX") != word.npos)
            refuse(element, number, "has '" + word.substr(0, 20) + "' where a number belongs");
        return value;
    }
    // How many entries a list has.
    std::size_t take_count(const Element& element, std::uint64_t number, const Property& list) {
        const double count = take(element, number, *list.count);
        const std::size_t least = is_text_ ? 2 : list.type->bytes;
        // The last number of a text needs no blank after it.
        if (!(count >= 0 && count <= static_cast<double>((rest_.size() + 1) / least) &&
              count == std::floor(count)))
            refuse(element, number, "has a list that is longer than the file");
        return static_cast<std::size_t>(count);
    }
    void skip(const Element& element, std::uint64_t number, const Property& property) {
        std::size_t count = property.count ? take_count(element, number, property) : 1;
        for (; count > 0; --count) take(element, number, *property.type);
    }
    void skip(const Element& element, std::uint64_t number) {
        for (const Property& property : element.properties) skip(element, number, property);
    }

    void read_vertices(const Element& element) {
        std::vector<int> role_of;  // of each property; -1: none
        std::array<const Property*, roles> has{};
        for (const Property& property : element.properties) {
            role_of.push_back(-1);
            for (int role = 0; role < roles; ++role) {
                const auto& names = names_of_roles[static_cast<std::size_t>(role)];
                if (property.count || property.name.empty() ||
                    has[static_cast<std::size_t>(role)] ||
                    std::find(names.begin(), names.end(), property.name) == names.end())
                    continue;
                role_of.back() = role;
                has[static_cast<std::size_t>(role)] = &property;
            }
        }
        for (const Role role : {x, y, z})
            if (!has[role])
                throw std::invalid_argument("its vertices have no property " +
                                            std::string{names_of_roles[role][0]});
        has_normals_ = has[nx] && has[ny] && has[nz];
        has_uvs_ = has[u] && has[v];
        const bool has_colors = has[red] && has[green] && has[blue];
        // Whole numbers count from 0 to the largest of their type.
        const double white = has_colors && has[red]->type->bytes == 1   ? 255
                             : has_colors && has[red]->type->bytes == 2 ? 65535
                                                                        : 1;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            tell(i);
            std::array<Real, roles> at{};
            for (std::size_t k = 0; k < role_of.size(); ++k) {
                if (role_of[k] < 0) {
                    skip(element, i, element.properties[k]);
                    continue;
                }
                const auto number =
                    static_cast<Real>(take(element, i, *element.properties[k].type));
                at[static_cast<std::size_t>(role_of[k])] = number;
            }
            const auto expect_finite = [&](std::initializer_list<Role> some) {
                for (const Role role : some)
                    if (!std::isfinite(at[role]))
                        refuse(
                            element, i,
                            "has a " + std::string{names_of_roles[role][0]} + " that is no number");
            };
            expect_finite({x, y, z});
            all.points.push_back({at[x], at[y], at[z]});
            if (has_normals_) {
                const bool is_known =
                    std::isfinite(at[nx]) && std::isfinite(at[ny]) && std::isfinite(at[nz]);
                all.normals.push_back(is_known ? Vec3{at[nx], at[ny], at[nz]} : Vec3{});
            }
            if (has_uvs_) {
                expect_finite({u, v});
                all.uvs.push_back({at[u], at[v]});
            }
            if (has_colors) {
                const auto linear = [&](Role role) {
                    const double stored = static_cast<double>(at[role]) / white;
                    if (!(stored >= 0 && stored <= 1))
                        refuse(element, i,
                               "has a " + std::string{names_of_roles[role][0]} +
                                   " that is not from 0 to " +
                                   std::to_string(static_cast<int>(white)));
                    return srgb_decode(static_cast<Real>(stored));
                };
                all.colors.push_back({linear(red), linear(green), linear(blue)});
            }
        }
    }

    void read_faces(const Element& element) {
        const auto is_corners = [](const Property& property) {
            return property.count &&
                   (property.name == "vertex_indices" || property.name == "vertex_index");
        };
        if (std::none_of(element.properties.begin(), element.properties.end(), is_corners))
            throw std::invalid_argument("its faces have no list vertex_indices");
        for (std::uint64_t i = 0; i < element.count; ++i) {
            tell(i);
            for (const Property& property : element.properties)
                if (is_corners(property))
                    take_polygon(element, i, property);
                else
                    skip(element, i, property);
        }
    }
    void take_polygon(const Element& element, std::uint64_t number, const Property& list) {
        const std::size_t count = take_count(element, number, list);
        std::vector<Corner> polygon;
        polygon.reserve(count);
        for (std::size_t k = 0; k < count; ++k) {
            const double index = take(element, number, *list.type);
            if (!(index >= 0 && index < static_cast<double>(all.points.size())))
                refuse(element, number,
                       "names a vertex that is not there: they go from 0 to " +
                           std::to_string(static_cast<long>(all.points.size()) - 1));
            const int point = static_cast<int>(index);
            polygon.push_back({point, has_normals_ ? point : -1, has_uvs_ ? point : -1});
        }
        if (count < 3 || count > most_corners)
            refuse(
                element, number,
                "has " + counted(count, "corner") + ", not 3 to " + std::to_string(most_corners));
        if (count - 2 > room_) refuse(element, number, "is where the triangles become too many");
        room_ -= count - 2;
        all.polygons.push_back(std::move(polygon));
        all.lines.push_back(is_text_ ? line_ : static_cast<int>(number));
        all.materials.push_back(-1);
    }

    std::string_view rest_;
    std::size_t size_;  // of the file
    std::size_t room_;  // triangles that there may still be
    const Reading& reading_;
    int line_ = 0;
    bool is_text_ = false, is_reversed_ = false;
    std::vector<Element> elements_;
    bool has_normals_ = false, has_uvs_ = false;
};

}  // namespace

Polygons read_ply(const std::string& bytes, std::size_t most_triangles, const Reading& reading) {
    return std::move(PlyReader{bytes, most_triangles, reading}.all);
}

}  // namespace rt
