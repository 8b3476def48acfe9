#pragma once
// A packet is a few rays that go down the tree together and share one stack. Packets are a middle
// way between single rays and batches; only the study uses them.

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <rt/wide_ray.hpp>
#include <rt/wide_tree.hpp>

namespace batches {

using namespace rt;

// The nearest hit of a ray.
struct NearestHit {
    Real t = infinity;
    std::int32_t number = -1;  // of the sphere that is hit there; -1 for none
};

template <std::size_t size>
class Packet {
  public:
    std::array<NearestHit, size> best;

    explicit Packet(const Ray* rays) : Packet{rays, std::make_index_sequence<size>{}} {}

    void find_nearest(const WideTree& tree) {
        if (tree.nodes.empty()) return;
        std::array<Waiting, lanes*(most_levels + 32)> stack;
        stack[0] = {WideChild::node(0), (std::uint32_t{1} << size) - 1};
        for (std::size_t waiting = 1; waiting > 0;) {
            const Waiting top = stack[--waiting];
            if (top.child.is_leaf())
                test(tree, top);
            else
                waiting = visit(tree.nodes[static_cast<std::size_t>(top.child.number())], top.rays,
                                stack.data(), waiting);
        }
    }

  private:
    struct Waiting {
        WideChild child;
        std::uint32_t rays;  // one bit for each ray that has met the child's box
    };

    template <std::size_t... i>
    Packet(const Ray* rays, std::index_sequence<i...>)
        : rays_{rays}, wide_{wide_ray<float>(rays[i])...} {
        max_.fill(std::numeric_limits<float>::infinity());
    }

    // Tests each of these rays against the boxes of the children. Children whose boxes any ray
    // meets go onto the stack, the nearest child last.
    std::size_t visit(const WideNode<float>& node, std::uint32_t rays, Waiting* stack,
                      std::size_t waiting) const {
        std::array<std::uint32_t, lanes> met{};
        Lanes<float> nearest;
        nearest.fill(std::numeric_limits<float>::infinity());
        for (; rays; rays &= rays - 1) {
            const auto ray = static_cast<std::size_t>(std::countr_zero(rays));
            const BoxesHit<float> hit = hit_boxes(node, wide_[ray], 0.0F, max_[ray]);
            for (unsigned bits = hit.met; bits; bits &= bits - 1) {
                const auto child = static_cast<std::size_t>(std::countr_zero(bits));
                met[child] |= 1U << ray;
                nearest[child] = std::min(nearest[child], hit.entry[child]);
            }
        }
        Lanes<std::size_t> order;
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return nearest[a] > nearest[b]; });
        for (const std::size_t child : order)
            if (met[child] != 0) stack[waiting++] = {node.child[child], met[child]};
        return waiting;
    }

    void test(const WideTree& tree, Waiting leaf) {
        for (std::uint32_t rays = leaf.rays; rays; rays &= rays - 1) {
            const auto ray = static_cast<std::size_t>(std::countr_zero(rays));
            auto& [t, number] = best[ray];
            const auto found = tree.search(rays_[ray], wide_[ray], {0, t}, leaf.child, number);
            if (found.nearest == number) continue;
            best[ray] = {found.within.max, found.nearest};
            max_[ray] = static_cast<float>(t * wide_[ray].scale);
        }
    }

    const Ray* rays_;
    std::array<WideRay<float>, size> wide_;
    std::array<float, size> max_;
};

}  // namespace batches
