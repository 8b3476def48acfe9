#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/light_sample.hpp>
#include <rt/triangle.hpp>
#include <rt/vec2.hpp>

namespace rt {

// The plain answer: formulas as they stand in the text.
inline Vec2 even_weights(Vec2 place) {
    const Real share = std::sqrt(place.x);
    return {share * (1 - place.y), share * place.y};
}

inline Real light_density(const Triangle& light, Vec3 from, Vec3 point) {
    const Vec3 normal = cross(light.b - light.a, light.c - light.a);
    const Vec3 way = point - from;
    const Real area = length(normal) / 2;
    const Real cosine = std::abs(dot(normalize(normal), normalize(way)));
    return dot(way, way) / (area * cosine);
}

inline std::optional<LightSample> sample_light(const Triangle& light, Vec3 from, Vec2 place) {
    const Vec2 weight = even_weights(place);
    const Vec3 point = light.a + weight.x * (light.b - light.a) + weight.y * (light.c - light.a);
    const Vec3 way = point - from;
    return LightSample{normalize(way), length(way), light_density(light, from, point)};
}

}  // namespace rt
