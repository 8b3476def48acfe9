#pragma once
// The chapter's picture in any number type, with the formulas of the course. Two pictures that use
// the same random numbers differ by rounding alone.

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <rt/rng.hpp>
#include <rt/view.hpp>
#include <vector>

#include "scene.hpp"

namespace normals_aa::any_precision {

template <class N>
struct Vector {  // or light in red, green and blue
    N x{}, y{}, z{};

    friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector operator*(Vector a, Vector b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend Vector operator*(N s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
    friend N dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend Vector cross(Vector a, Vector b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    friend Vector unit(Vector a) { return (1 / std::sqrt(dot(a, a))) * a; }
    friend Vector abs(Vector a) { return {std::abs(a.x), std::abs(a.y), std::abs(a.z)}; }
};

template <class N, class AnyVector>
Vector<N> as(const AnyVector& v) {
    return {static_cast<N>(v.x), static_cast<N>(v.y), static_cast<N>(v.z)};
}
template <class N>
Vector<N> as(const Color& c) {
    return {static_cast<N>(c.r), static_cast<N>(c.g), static_cast<N>(c.b)};
}

// Random numbers of 24 bits, which every number type can hold exactly.
class SharedRandom {
  public:
    SharedRandom(std::uint64_t seed, int x, int y) : bits_{pixel_rng(seed, x, y)} {}

    template <class N>
    N uniform() {
        return static_cast<N>(bits_() >> 8) / static_cast<N>(1 << 24);
    }

  private:
    Rng bits_;
};

template <class N>
struct Line {
    Vector<N> origin, direction;
};

template <class N>
struct Ball {
    Vector<N> center;
    N radius;
    Vector<N> albedo;
};

template <class N>
std::optional<N> nearest_ahead(N low, N high) {
    if (low > 0) return low;
    if (high > 0) return high;
    return {};
}

// The formula of rt::hit_sphere.
struct StableFormula {
    template <class N>
    std::optional<N> operator()(const Ball<N>& ball, const Line<N>& ray) const {
        const Vector<N> f = ray.origin - ball.center, d = ray.direction, moment = cross(f, d);
        const N a = dot(d, d), b = dot(f, d), r_squared = ball.radius * ball.radius;
        const N quarter = a * r_squared - dot(moment, moment);
        if (!(quarter >= 0)) return {};
        const N q = -(b + std::copysign(std::sqrt(quarter), b));
        const N one = (dot(f, f) - r_squared) / q, other = q / a;
        return nearest_ahead(std::min(one, other), std::max(one, other));
    }
};

// The formula that you know from school.
struct TextbookFormula {
    template <class N>
    std::optional<N> operator()(const Ball<N>& ball, const Line<N>& ray) const {
        const Vector<N> f = ray.origin - ball.center, d = ray.direction;
        const N a = dot(d, d), b = 2 * dot(f, d), c = dot(f, f) - ball.radius * ball.radius;
        const N discriminant = b * b - 4 * a * c;
        if (!(discriminant >= 0)) return {};
        const N root = std::sqrt(discriminant);
        return nearest_ahead((-b - root) / (2 * a), (-b + root) / (2 * a));
    }
};

template <class N>
class Picture {
  public:
    Picture(const View& view, int width, int height)
        : eye_{as<N>(view.from)},
          w_{unit(as<N>(view.from) - as<N>(view.at))},
          u_{unit(cross(as<N>(view.up), w_))},
          v_{cross(w_, u_)},
          pixel_{2 * std::tan(static_cast<N>(view.vertical_fov) / 2) / static_cast<N>(height)},
          width_{static_cast<N>(width)},
          height_{static_cast<N>(height)} {
        for (const SceneSphere& sphere : scene_.world.spheres)
            balls_.push_back(
                {as<N>(sphere.shape.center), static_cast<N>(sphere.shape.radius),
                 as<N>(scene_.materials.materials[static_cast<std::size_t>(sphere.material)]
                           .albedo)});
    }

    template <class Formula>
    Vector<N> pixel(int x, int y, int samples, int depth, const Formula& formula) const {
        SharedRandom random{1, x, y};
        Vector<N> sum;
        for (int i = 0; i < samples; ++i) {
            const N right = (static_cast<N>(x) - width_ / 2) + random.uniform<N>();
            const N down = (static_cast<N>(y) - height_ / 2) + random.uniform<N>();
            const Vector<N> direction = unit(pixel_ * (right * u_ - down * v_) - w_);
            sum = sum + radiance({eye_, direction}, depth, formula, random);
        }
        return (1 / static_cast<N>(samples)) * sum;
    }

  private:
    // Like path_radiance with SkyEnding.
    template <class Formula>
    Vector<N> radiance(Line<N> ray, int depth, const Formula& formula, SharedRandom& random) const {
        Vector<N> throughput{1, 1, 1};
        for (int bounces = 0; bounces < depth; ++bounces) {
            const Ball<N>* ball = nullptr;
            N nearest = std::numeric_limits<N>::infinity();
            for (const Ball<N>& candidate : balls_)
                if (const auto t = formula(candidate, ray); t && *t < nearest) {
                    nearest = *t;
                    ball = &candidate;
                }
            if (!ball) break;
            throughput = throughput * ball->albedo;
            ray = bounce(*ball, ray, nearest, random);
        }
        return throughput * sky(ray.direction);
    }

    // Like surface_hit, cosine_direction and leave_surface together.
    static Line<N> bounce(const Ball<N>& ball, const Line<N>& ray, N t, SharedRandom& random) {
        const N half_epsilon = std::numeric_limits<N>::epsilon() / 2;
        const Vector<N> outward = unit((ray.origin - ball.center) + t * ray.direction);
        const Vector<N> w = dot(ray.direction, outward) <= 0 ? outward : N{-1} * outward;
        const Vector<N> point = ball.center + ball.radius * outward;
        const N place = random.uniform<N>(),
                angle = 2 * std::numbers::pi_v<N> * random.uniform<N>();
        const N radius = std::sqrt(place), sign = std::copysign(N{1}, w.z);
        const N a = -1 / (sign + w.z), b = w.x * w.y * a;
        const Vector<N> u{1 + sign * w.x * w.x * a, sign * b, -sign * w.x};
        const Vector<N> v{b, sign + w.y * w.y * a, -w.y};
        const Vector<N> direction = unit(radius * std::cos(angle) * u +
                                         radius * std::sin(angle) * v + std::sqrt(1 - place) * w);
        const N off = half_epsilon * (2 * dot(abs(point), abs(w)) + 16 * ball.radius);
        return {point + off * w, direction};
    }

    Vector<N> sky(Vector<N> direction) const {
        const EveningSky& sky = scene_.sky;
        const N height = std::max(N{0}, direction.y);
        const N cosine = std::max(N{0}, dot(direction, as<N>(sky.to_sun)));
        const N blue = height / (height + N{1} / 4), squared = cosine * cosine;
        return (1 - blue) * as<N>(sky.horizon) + blue * as<N>(sky.above) +
               squared * squared * as<N>(sky.glow);
    }

    Scene scene_ = make_scene();
    Vector<N> eye_, w_, u_, v_;
    N pixel_, width_, height_;
    std::vector<Ball<N>> balls_;
};

}  // namespace normals_aa::any_precision
