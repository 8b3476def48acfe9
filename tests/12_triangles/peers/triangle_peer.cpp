// triangle_peer [ROUNDS [TRIANGLES [MESH...]]]: the sea of chapter 12, a knot with a rough skin,
// triangles strewn about (soup) and thin strands on a ball (hair), in the tree of chapter 07 and in
// Embree's, both in float and in one thread: searches of the same single rays, the build, and the
// memory. Run by hand. Embree's scene is robust; its build quality is medium, its default, as this
// asks for.

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <rt/make_camera.hpp>
#include <rt/mesh_world.hpp>
#include <rt/render_pixel.hpp>
#include <rt/uniform_direction.hpp>
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

// A number from 0 to 1 for each pair of whole numbers.
float lot(int i, int j) {
    Rng random{static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)};
    return static_cast<float>(random()) * 0x1p-32f;
}

Mesh sea_of(int count) {
    const triangles::Cut nothing_cut{{}, {}, {}};
    const auto sea = triangles::make_sea(count, nothing_cut);
    Mesh mesh = sea.water;
    mesh.triangles.insert(mesh.triangles.end(), sea.foam.triangles.begin(),
                          sea.foam.triangles.end());
    return mesh;
}

// A tube around a trefoil knot; each point is pushed in or out at random.
Mesh knot_of(int count) {
    const int around = std::max(8, static_cast<int>(std::sqrt(count / 2 / 16.0)));
    const int along = count / 2 / around;
    const auto curve = [](double t) {
        return Vec3{static_cast<Real>((2 + std::cos(3 * t)) * std::cos(2 * t)),
                    static_cast<Real>((2 + std::cos(3 * t)) * std::sin(2 * t)),
                    static_cast<Real>(std::sin(3 * t))};
    };
    Mesh mesh;
    for (int i = 0; i < along; ++i) {
        const double t = 2 * std::numbers::pi * i / along;
        const Vec3 at = curve(t), ahead = normalize(curve(t + 1e-3) - curve(t - 1e-3));
        const Vec3 side = normalize(cross(ahead, {0, 0, 1})), up = cross(side, ahead);
        for (int j = 0; j < around; ++j) {
            const double turn = 2 * std::numbers::pi * j / around;
            const Real radius = Real(0.4) + Real(0.04) * lot(i, j);
            mesh.points.push_back(at + radius * static_cast<Real>(std::cos(turn)) * side +
                                  radius * static_cast<Real>(std::sin(turn)) * up);
        }
    }
    const auto corner = [&](int i, int j) { return Corner{(i % along) * around + j % around}; };
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            mesh.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i, j + 1)});
            mesh.triangles.push_back({corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
    return mesh;
}

Mesh soup_of(int count) {
    const Real size = 2 / std::cbrt(static_cast<Real>(count));
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3 at{lot(i, 0), lot(i, 1), lot(i, 2)};
        for (int k = 1; k < 4; ++k)
            mesh.points.push_back(at +
                                  size * Vec3{lot(i, 3 * k), lot(i, 3 * k + 1), lot(i, 3 * k + 2)});
        mesh.triangles.push_back({Corner{3 * i}, {3 * i + 1}, {3 * i + 2}});
    }
    return mesh;
}

// Strands of 20 pieces, each of two long triangles, that stand on a ball and bend down.
Mesh hair_of(int count) {
    constexpr int pieces = 20;
    Mesh mesh;
    for (int strand = 0; strand < count / (2 * pieces); ++strand) {
        const Vec3 root = uniform_direction({lot(strand, 0), lot(strand, 1)});
        const Vec3 side = normalize(cross(root, {lot(strand, 2), lot(strand, 3), 1}));
        for (int k = 0; k <= pieces; ++k) {
            const Real t = static_cast<Real>(k) / pieces;
            const Vec3 at = (1 + t) * root + t * t * Vec3{0, -1, 0} + Real(0.1) * t * side;
            mesh.points.push_back(at);
            mesh.points.push_back(at + Real(0.002) * side);
        }
        for (int k = 0; k < pieces; ++k) {
            const int first = 2 * ((pieces + 1) * strand + k);
            mesh.triangles.push_back({Corner{first}, {first + 1}, {first + 2}});
            mesh.triangles.push_back({Corner{first + 1}, {first + 3}, {first + 2}});
        }
    }
    return mesh;
}

// Rays from a ball around the mesh to points of it.
std::vector<Ray> rays_from_outside(const Mesh& mesh) {
    Box box;
    for (const Vec3& point : mesh.points) box = join(box, {point, point});
    Rng random{12, 9};
    std::vector<Ray> rays;
    for (int i = 0; i < 90'000; ++i) {
        const Vec3 from =
            box.center() + length(box.size()) * uniform_direction(random_place(random));
        const auto& [a, b, c] = mesh.triangles[random() % mesh.triangles.size()];
        const auto point = [&](const Corner& corner) {
            return mesh.points[static_cast<std::size_t>(corner.point)];
        };
        const Vec3 to = Real(0.3) * point(a) + Real(0.25) * point(b) + Real(0.45) * point(c);
        rays.push_back({from, to - from});
    }
    return rays;
}

std::vector<Ray> rays_of_picture() {
    const Camera camera = make_camera(triangles::scene_view(), 400, 225);
    Rng random{12, 9};
    std::vector<Ray> rays;
    for (int y = 0; y < 225; ++y)
        for (int x = 0; x < 400; ++x)
            rays.push_back(make_ray(camera, x, y, random_place(random), random));
    return rays;
}

void compare(const Mesh& mesh, const std::vector<Ray>& seen, int rounds) {
    const auto all = triangles_of(mesh, 0, 0);
    const auto count = static_cast<double>(all.size());
    embree_bytes = 0;
    const TriangleTree tree = make_wide_tree(all);
    const EmbreeTriangles embree{mesh};
    const auto ours = static_cast<double>(tree.nodes.size() * sizeof(tree.nodes[0]) +
                                          tree.leaves.size() * sizeof(tree.leaves[0]) +
                                          tree.places.size() * sizeof(tree.places[0]));
    std::printf(
        "%.0f triangles; bytes a triangle: chapter 07 %.1f, Embree %.1f with its copy of "
        "the mesh\n",
        count, ours / count, static_cast<double>(embree_bytes.load()) / count);

    std::vector<Ray> bounced;
    Rng random{12, 10};
    for (const Ray& ray : seen)
        if (const auto hit = tree.hit(ray, {})) {
            const Vec3 to = cosine_direction(facing_normal(*hit), random_place(random));
            bounced.push_back({leave_surface(*hit, to), to});
        }
    for (const auto* rays : {&seen, const_cast<const std::vector<Ray>*>(&bounced)}) {
        int differ = 0;
        for (const Ray& ray : *rays) {
            const auto theirs = embree.search(ray);
            const auto mine = tree.search(ray, {}).nearest;
            differ += mine != (theirs.hit.geomID == RTC_INVALID_GEOMETRY_ID
                                   ? -1
                                   : static_cast<int>(theirs.hit.primID));
        }
        print(rays == &seen ? "first rays" : "bounced rays",
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
    const auto ns = study::in_turns_ns(
        {[&] { study::keep(make_wide_tree(all, 2)); }, [&] { study::keep(make_wide_tree(all)); }},
        {.rounds = std::min(rounds, 5), .clock = study::Clock::wall});
    std::printf("build          chapter 07 in two threads %.1f ms, in one %.1f ms: %.2f\n",
                ns[0] / 1e6, ns[1] / 1e6, ns[1] / ns[0]);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
    const int count = argc > 2 ? std::atoi(argv[2]) : 1'000'000;
    const std::vector<std::string> wanted(argv + std::min(argc, 3), argv + argc);
    for (const auto& [name, make] : std::vector<std::pair<std::string, Mesh (*)(int)>>{
             {"sea", sea_of}, {"knot", knot_of}, {"soup", soup_of}, {"hair", hair_of}}) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end())
            continue;
        std::printf("%s: ", name.c_str());
        const Mesh mesh = make(count);
        compare(mesh, name == "sea" ? rays_of_picture() : rays_from_outside(mesh), rounds);
    }
}
