#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <rt/box.hpp>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/polygons.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rt {

// Cuts the polygons that no fan can cut, such as the letter H, into triangles (given). The others
// stay as they are, for make_mesh. Source: Meisters, "Polygons have ears", The American
// Mathematical Monthly 82(6), 1975.

// Twice the area of a polygon, as a vector along its normal.
inline Vec3 area_vector(const std::vector<Vec3>& corners) {
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

// Whether all triangles of the fan from some corner face the same way as the polygon.
inline bool has_fan(const std::vector<Vec3>& corners, Vec3 area) {
    const std::size_t count = corners.size();
    const auto faces = [&](std::size_t start, std::size_t i) {
        const Vec3 at = corners[start];
        return dot(cross(corners[(start + i) % count] - at, corners[(start + i + 1) % count] - at),
                   area) > 0;
    };
    for (std::size_t start = 0; start < count; ++start) {
        std::size_t i = 1;
        while (i + 1 < count && faces(start, i)) ++i;
        if (i + 1 == count) return true;
    }
    return false;
}

// A polygon seen along its normal's largest component, so that it goes around counterclockwise.
class FlatPolygon {
  public:
    FlatPolygon(const std::vector<Vec3>& corners, Vec3 area) {
        const Vec3 size = abs(area);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const bool turned = along(area, axis) < 0;
        Vec2 low{infinity, infinity}, high{-infinity, -infinity};
        for (const Vec3& corner : corners) {
            const Real x = along(corner, (axis + 1) % 3), y = along(corner, (axis + 2) % 3);
            points_.push_back(turned ? Vec2{y, x} : Vec2{x, y});
            low = {std::min(low.x, points_.back().x), std::min(low.y, points_.back().y)};
            high = {std::max(high.x, points_.back().x), std::max(high.y, points_.back().y)};
        }
        // Twice the area that rounded coordinates can give to three corners in one line.
        const Real largest = std::max({-low.x, -low.y, high.x, high.y});
        rounding_ = rounding_bound(16) * largest * std::max(high.x - low.x, high.y - low.y);
    }

    // Twice the area of the triangle of these corners: greater than 0 if they go around
    // counterclockwise, and 0 if they are in one line as far as rounding lets one know.
    Real area(std::size_t a, std::size_t b, std::size_t c) const {
        const auto [x, y] = points_[a];
        const Real area = difference_of_products(points_[b].x - x, points_[c].y - y,
                                                 points_[b].y - y, points_[c].x - x);
        return std::abs(area) > rounding_ ? area : 0;
    }
    // Whether corner p lies in the triangle; on its rim only if `rim_too`, and never at a corner.
    bool is_inside(std::size_t p, std::size_t a, std::size_t b, std::size_t c, bool rim_too) const {
        for (const std::size_t corner : {a, b, c})
            if (points_[p].x == points_[corner].x && points_[p].y == points_[corner].y)
                return false;
        const Real least = std::min({area(a, b, p), area(b, c, p), area(c, a, p)});
        return rim_too ? least >= 0 : least > 0;
    }

  private:
    std::vector<Vec2> points_;
    Real rounding_ = 0;
};

// The triangles of a polygon, each as three indices of its corners: an ear, a triangle of three
// neighbors that no other corner reaches, is cut off again and again. All triangles go around the
// same way as the polygon. If its sides do not cross, the triangles therefore cover it once. Empty
// if there is no such way, because sides cross.
inline std::vector<std::array<std::size_t, 3>> ears_of(const std::vector<Vec3>& corners) {
    const FlatPolygon flat{corners, area_vector(corners)};
    std::vector<std::size_t> left(corners.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    std::vector<std::array<std::size_t, 3>> ears;
    // The neighbors around place i of what is left.
    const auto around = [&](std::size_t i) {
        const std::size_t count = left.size();
        return std::array{left[(i + count - 1) % count], left[i], left[(i + 1) % count]};
    };
    const auto is_ear = [&](std::size_t i, bool rim_too) {
        const auto [a, b, c] = around(i);
        if (!(flat.area(a, b, c) > 0)) return false;
        for (const std::size_t p : left)
            if (p != a && p != b && p != c && flat.is_inside(p, a, b, c, rim_too)) return false;
        return true;
    };
    const auto is_straight = [&](std::size_t i) {
        const auto [a, b, c] = around(i);
        return flat.area(a, b, c) == 0;
    };
    const auto first = [&](const auto& holds) {
        std::size_t i = 0;
        while (i < left.size() && !holds(i)) ++i;
        return i;
    };
    while (left.size() >= 3) {
        std::size_t i = first([&](std::size_t k) { return is_ear(k, true); });
        if (i == left.size()) i = first([&](std::size_t k) { return is_ear(k, false); });
        if (i < left.size())
            ears.push_back(around(i));
        else
            i = first(is_straight);  // this corner can go: it holds no area
        if (i == left.size()) return {};
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return ears;
}

// Replaces each polygon that no fan can cut with its triangles. Throws std::invalid_argument, which
// names the line, if a polygon's sides cross.
inline void cut_ears(Polygons& from) {
    Polygons cut;
    for (std::size_t i = 0; i < from.polygons.size(); ++i) {
        std::vector<Corner>& polygon = from.polygons[i];
        const auto add = [&](std::vector<Corner> corners) {
            cut.polygons.push_back(std::move(corners));
            if (!from.lines.empty()) cut.lines.push_back(from.lines[i]);
            if (!from.materials.empty()) cut.materials.push_back(from.materials[i]);
        };
        if (polygon.size() <= 3) {
            add(std::move(polygon));
            continue;
        }
        std::vector<Vec3> points;
        for (const Corner& corner : polygon)
            points.push_back(from.points.at(static_cast<std::size_t>(corner.point)));
        const Vec3 area = area_vector(points);
        const auto is_flat = [&](std::size_t k) {  // the fan's triangle k has no area
            return cross(points[k] - points[0], points[k + 1] - points[0]) == Vec3{};
        };
        bool has_area = false;
        for (std::size_t k = 1; k + 1 < points.size(); ++k) has_area = has_area || !is_flat(k);
        if (!has_area || (area != Vec3{} && has_fan(points, area))) {
            add(std::move(polygon));
            continue;
        }
        const auto ears = area == Vec3{} ? decltype(ears_of(points)){} : ears_of(points);
        if (ears.empty())
            throw std::invalid_argument((from.lines.empty()
                                             ? "polygon " + std::to_string(i + 1)
                                             : from.place + (' ' + std::to_string(from.lines[i]))) +
                                        " has a polygon whose sides cross: no triangles cover it");
        for (const auto& [a, b, c] : ears) add({polygon[a], polygon[b], polygon[c]});
    }
    from.polygons = std::move(cut.polygons);
    from.lines = std::move(cut.lines);
    from.materials = std::move(cut.materials);
}

}  // namespace rt
