#pragma once
#include <optional>
#include <rt/interval.hpp>
#include <rt/triangle.hpp>

namespace answer {

std::optional<rt::TriangleHit> hit_triangle(const rt::Triangle& triangle, const rt::Ray& ray,
                                            rt::Interval within);

}  // namespace answer

namespace rt {

using answer::hit_triangle;

}  // namespace rt
