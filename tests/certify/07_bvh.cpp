// The tree: the hits of the linear list among 10,000 spheres, and work that grows like a logarithm.
#include <chrono>
#include <rt/area_split.hpp>
#include <rt/shape_tree.hpp>
#include <rt/sphere_list.hpp>

#include "certificate.hpp"

namespace {

using namespace certify;

// This many in a cube from -1 to 1. For any number, about the same share of it is full.
std::vector<rt::SceneSphere> spheres(int count) {
    rt::Rng rng{1, 7};
    std::vector<rt::SceneSphere> all;
    const Real largest = Real(0.6) / std::cbrt(static_cast<Real>(count));
    for (int i = 0; i < count; ++i) {
        const Real x = rng.uniform(-1, 1), y = rng.uniform(-1, 1), z = rng.uniform(-1, 1);
        all.push_back({{{x, y, z}, largest * rng.uniform(Real(0.1), 1)}, i});
    }
    return all;
}

rt::Ray any_ray(rt::Rng& rng) {
    const Vec3 from = 3 * checkpoint::any_direction(rng);
    const Vec3 to = Real(0.7) * checkpoint::any_direction(rng);
    return {from, rt::normalize(to - from)};
}

// How often each sphere is in the leaves.
void count(const rt::SphereTree& tree, const rt::TreeNode& node, std::vector<int>& seen) {
    if (!node.is_leaf()) {
        if (node.left) count(tree, *node.left, seen);
        if (node.right) count(tree, *node.right, seen);
        return;
    }
    for (int i = node.first; i < node.first + node.count; ++i)
        ++seen.at(static_cast<std::size_t>(tree.order.at(static_cast<std::size_t>(i))));
}

void every_sphere_once(Certificate& certificate) {
    const rt::SphereTree tree = rt::make_tree(spheres(10'000), rt::split_in_half);
    std::vector<int> seen(tree.shapes.size());
    if (tree.root) count(tree, *tree.root, seen);
    const auto wrong = std::count_if(seen.begin(), seen.end(), [](int n) { return n != 1; });
    certificate.at_most("07.3", "10,000 spheres: those that are not in exactly one leaf",
                        static_cast<double>(wrong), 0, "");
}

void same_hits(Certificate& certificate) {
    const auto all = spheres(10'000);
    const rt::SphereTree sorted = rt::make_tree(all, rt::split_in_half);
    const rt::SphereTree by_area = rt::make_tree(all, rt::AreaSplit{});
    const rt::SphereList list{all};
    rt::Rng rng{1, 8};
    long different = 0, hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const rt::Ray ray = any_ray(rng);
        const auto expected = list.hit(ray, {});
        hits += expected.has_value();
        for (const rt::SphereTree* const tree : {&sorted, &by_area}) {
            const auto hit = tree->hit(ray, {});
            different += hit.has_value() != expected.has_value() ||
                         (hit && (hit->t != expected->t || hit->material != expected->material));
        }
    }
    certificate.at_most("07.4", "10,000 spheres: hits that are not the linear list's, of 3000 rays",
                        static_cast<double>(different), 0, "");
    certificate.shows("07.4", "rays among them that meet a sphere", static_cast<double>(hits), "");
}

// What the tree saves: the time of a ray in a list of all spheres.
void list(Certificate& certificate) {
    const rt::SphereList list{spheres(10'000)};
    rt::Rng rng{2, 8};
    constexpr int rays = 300;
    long hits = 0;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < rays; ++i) hits += list.hit(any_ray(rng), {}).has_value();
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    certificate.shows("07.5", "a ray among 10,000 spheres in a list, without a tree",
                      hits > 0 ? time.count() / rays : 0, "ns");
}

struct Work {
    double tests = 0, nanoseconds = 0;  // a ray
};

Work work(int count) {
    const rt::SphereTree tree = rt::make_tree(spheres(count), rt::AreaSplit{});
    rt::Rng rng{2, 8};
    std::vector<rt::Ray> rays;
    for (int i = 0; i < 5000; ++i) rays.push_back(any_ray(rng));
    Work least{0, rt::infinity};
    for (int round = 0; round < 3; ++round) {
        long tests = 0;
        const auto start = std::chrono::steady_clock::now();
        for (const rt::Ray& ray : rays) {
            const rt::Search search = tree.search(ray, {});
            tests += search.box_tests + search.shape_tests;
        }
        const std::chrono::duration<double, std::nano> time =
            std::chrono::steady_clock::now() - start;
        const auto n = static_cast<double>(rays.size());
        least = {static_cast<double>(tests) / n, std::min(least.nanoseconds, time.count() / n)};
    }
    return least;
}

void growth(Certificate& certificate) {
    const Work small = work(1000), middle = work(10'000), large = work(100'000);
    certificate.shows("07.5", "a ray among 1,000 spheres", small.nanoseconds, "ns");
    certificate.shows("07.5", "a ray among 10,000 spheres", middle.nanoseconds, "ns");
    certificate.shows("07.5", "a ray among 100,000 spheres", large.nanoseconds, "ns");
    certificate.at_most("07.5", "tests per ray among 10,000 spheres", middle.tests, 500, "");
    // A logarithm grows by 5/3 from 10^3 to 10^5; the number of spheres by 100. Boxes overlap, and
    // a ray meets more of them the smaller they are: six times is still far from linear.
    certificate.at_most("07.5", "tests per ray, 100,000 spheres against 1,000",
                        large.tests / small.tests, 6, "times");
}

}  // namespace

int main() {
    return certify::certify(every_sphere_once, same_hits, list, growth);
}
