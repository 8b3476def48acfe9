#pragma once
// Spheres in Embree's tree: a world for the path loops of the course, for one ray and for many.

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <optional>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/ray.hpp>
#include <rt/scene_sphere.hpp>
#include <rt/surface_hit.hpp>
#include <vector>

namespace peers {

class EmbreeWorld {
  public:
    using Rays = std::vector<RTCRayHit>;

    // The spheres must outlive the world.
    explicit EmbreeWorld(const std::vector<rt::SceneSphere>& spheres,
                         RTCIntersectContextFlags flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT)
        : spheres_{spheres}, device_{rtcNewDevice("threads=1")}, scene_{rtcNewScene(device_)} {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* numbers = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                    4 * sizeof(float), spheres.size()));
        for (const auto& [shape, material, light] : spheres)
            for (const float number :
                 {shape.center.x, shape.center.y, shape.center.z, shape.radius})
                *numbers++ = number;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        rtcCommitScene(scene_);
        rtcInitIntersectContext(&context_);
        context_.flags = flags;
    }
    EmbreeWorld(const EmbreeWorld&) = delete;
    EmbreeWorld& operator=(const EmbreeWorld&) = delete;
    ~EmbreeWorld() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    // A ray for Embree. leave_surface leaves as much room as hit_sphere needs, which knows more
    // digits of t than Embree's spheres do: here a ray begins a bit later.
    static void put(const rt::Ray& ray, RTCRayHit& to) {
        constexpr float begin = 1e-3f;
        const auto& [o, d] = ray;
        to.ray = {o.x, o.y, o.z, begin, d.x, d.y, d.z, 0, rt::infinity, ~0u, 0, 0};
        to.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    }

    // What was found.
    std::optional<rt::Hit> hit_of(const rt::Ray& ray, const RTCRayHit& found) const {
        if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        const rt::SceneSphere& sphere = spheres_[found.hit.primID];
        rt::Hit hit = surface_hit(sphere.shape, ray, found.ray.tfar);
        hit.material = sphere.material;
        hit.light = sphere.light;
        return hit;
    }

    // One ray, as path_radiance asks.
    std::optional<rt::Hit> hit(const rt::Ray& ray, rt::Interval) const {
        RTCRayHit asked;
        put(ray, asked);
        rtcIntersect1(scene_, &context_, &asked);
        return hit_of(ray, asked);
    }

    // Many rays: one by one, as a stream, or in packets of eight.
    void single(Rays& rays) const {
        for (RTCRayHit& ray : rays) rtcIntersect1(scene_, &context_, &ray);
    }
    void stream(Rays& rays) const {
        rtcIntersect1M(scene_, &context_, rays.data(), static_cast<unsigned>(rays.size()),
                       sizeof(RTCRayHit));
    }
    void packets(Rays& rays) const {
        for (std::size_t first = 0; first < rays.size(); first += 8) {
            const std::size_t count = std::min<std::size_t>(8, rays.size() - first);
            alignas(32) std::array<int, 8> used{};
            RTCRayHit8 eight{};
            for (std::size_t i = 0; i < count; ++i) {
                used[i] = -1;
                set_ray(eight.ray, i, rays[first + i].ray);
                eight.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect8(used.data(), scene_, &context_, &eight);
            for (std::size_t i = 0; i < count; ++i) {
                rays[first + i].ray.tfar = eight.ray.tfar[i];
                rays[first + i].hit.geomID = eight.hit.geomID[i];
                rays[first + i].hit.primID = eight.hit.primID[i];
            }
        }
    }

  private:
    static void set_ray(RTCRay8& rays, std::size_t i, const RTCRay& ray) {
        rays.org_x[i] = ray.org_x, rays.org_y[i] = ray.org_y, rays.org_z[i] = ray.org_z;
        rays.dir_x[i] = ray.dir_x, rays.dir_y[i] = ray.dir_y, rays.dir_z[i] = ray.dir_z;
        rays.tnear[i] = ray.tnear, rays.tfar[i] = ray.tfar, rays.mask[i] = ray.mask;
    }

    const std::vector<rt::SceneSphere>& spheres_;
    RTCDevice device_;
    RTCScene scene_;
    mutable RTCIntersectContext context_{};
};

}  // namespace peers
