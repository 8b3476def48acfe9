// triangle_peer [ROUNDS [TRIANGLES]]: the sea of chapter 12 in the tree of chapter 07 and in
// Embree's, both in float and in one thread: searches of the same single rays, the build, and the
// memory. Run by hand. Embree's scene is robust; its build quality is medium, its default, as this
// asks for.

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <rt/make_camera.hpp>
#include <rt/mesh_world.hpp>
#include <rt/render_pixel.hpp>
#include <study/median.hpp>
#include <study/timing.hpp>

#include "scene.hpp"

using namespace rt;

namespace {

std::atomic<long> embree_bytes = 0;

class EmbreeTriangles {
  public:
    explicit EmbreeTriangles(const Mesh& mesh)
        : device_{rtcNewDevice("threads=1")}, scene_{rtcNewScene(device_)} {
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void*, ssize_t bytes, bool) {
                embree_bytes += bytes;
                return true;
            },
            nullptr);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* points = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), mesh.points.size()));
        for (const Vec3& p : mesh.points)
            for (const float x : {p.x, p.y, p.z}) *points++ = x;
        auto* numbers = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(unsigned), mesh.triangles.size()));
        for (const auto& triangle : mesh.triangles)
            for (const Corner& corner : triangle) *numbers++ = static_cast<unsigned>(corner.point);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
        rtcCommitScene(scene_);
        rtcInitIntersectContext(&context_);
        context_.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    }
    EmbreeTriangles(const EmbreeTriangles&) = delete;
    EmbreeTriangles& operator=(const EmbreeTriangles&) = delete;
    ~EmbreeTriangles() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    RTCRayHit search(const Ray& ray) const {
        RTCRayHit found;
        const auto& [o, d] = ray;
        found.ray = {o.x, o.y, o.z, 0, d.x, d.y, d.z, 0, rt::infinity, ~0u, 0, 0};
        found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context_, &found);
        return found;
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
    mutable RTCIntersectContext context_{};
};

// Medians, and the median of the ratios in each round.
void print(const char* what, const std::vector<study::Work>& two, int rounds, double parts,
           const char* unit) {
    const auto ns = study::rounds_ns(two, {.rounds = rounds});
    std::vector<double> ratios;
    for (std::size_t k = 0; k < ns[0].size(); ++k) ratios.push_back(ns[1][k] / ns[0][k]);
    std::printf("%-14s chapter 07 %9.1f %s   Embree %9.1f %s   Embree's time / ours %.2f\n", what,
                study::median(ns[0]) / parts, unit, study::median(ns[1]) / parts, unit,
                study::median(ratios));
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
    const auto sea = triangles::make_sea(argc > 2 ? std::atoi(argv[2]) : 1'000'000);
    Mesh mesh = sea.water;
    mesh.triangles.insert(mesh.triangles.end(), sea.foam.triangles.begin(),
                          sea.foam.triangles.end());
    const auto all = triangles_of(mesh, 0, 0);
    const auto count = static_cast<double>(all.size());
    const TriangleTree tree = make_wide_tree(all);
    const EmbreeTriangles embree{mesh};
    const auto ours = static_cast<double>(tree.nodes.size() * sizeof(tree.nodes[0]) +
                                          tree.leaves.size() * sizeof(tree.leaves[0]) +
                                          tree.places.size() * sizeof(tree.places[0]));
    std::printf(
        "%.0f triangles; bytes a triangle: chapter 07 %.1f, Embree %.1f with its copy of "
        "the mesh\n",
        count, ours / count, static_cast<double>(embree_bytes.load()) / count);

    // The rays of the picture, and one bounce of each.
    const Camera camera = make_camera(triangles::scene_view(), 400, 225);
    std::vector<Ray> seen, bounced;
    Rng random{12, 9};
    for (int y = 0; y < 225; ++y)
        for (int x = 0; x < 400; ++x) {
            seen.push_back(make_ray(camera, x, y, random_place(random), random));
            if (const auto hit = tree.hit(seen.back(), {})) {
                const Vec3 to = cosine_direction(facing_normal(*hit), random_place(random));
                bounced.push_back({leave_surface(*hit, to), to});
            }
        }
    for (const auto* rays : {&seen, &bounced}) {
        int differ = 0;
        for (const Ray& ray : *rays) {
            const auto theirs = embree.search(ray);
            const auto mine = tree.search(ray, {}).nearest;
            differ += mine != (theirs.hit.geomID == RTC_INVALID_GEOMETRY_ID
                                   ? -1
                                   : static_cast<int>(theirs.hit.primID));
        }
        print(rays == &seen ? "camera rays" : "bounced rays",
              {[&] {
                   for (const Ray& ray : *rays) study::keep(tree.search(ray, {}));
               },
               [&] {
                   for (const Ray& ray : *rays) study::keep(embree.search(ray));
               }},
              rounds, static_cast<double>(rays->size()), "ns a ray");
        std::printf("  %d of %zu rays meet another triangle\n", differ, rays->size());
    }
    print("build",
          {[&] { study::keep(make_wide_tree(all)); }, [&] { study::keep(EmbreeTriangles{mesh}); }},
          std::min(rounds, 5), 1e6, "ms");
}
