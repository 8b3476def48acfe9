#pragma once
// What direct_light and lit_path_radiance are written over, as types that both sides know. A data
// member has another name than any function of the course's own types, so that no answer uses it.

#include <functional>
#include <optional>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/lights.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/path_end.hpp>
#include <rt/ray.hpp>
#include <rt/rng.hpp>
#include <rt/scatter.hpp>

namespace answer {

template <class AnyRay>
struct World {
    std::function<std::optional<rt::Hit>(const AnyRay&, rt::Interval)> find;

    std::optional<rt::Hit> hit(const AnyRay& ray, rt::Interval within) const {
        return find(ray, within);
    }
};

struct Materials {
    std::function<std::optional<rt::Scatter>(rt::Vec3, const rt::Hit&, rt::Rng&)> bounce;
    std::function<rt::Real(const rt::Hit&, rt::Vec3)> spread;
    std::function<rt::Real(rt::Vec3, const rt::Hit&, rt::Vec3)> spread_of_all;
    std::function<bool(const rt::Hit&)> is_inside_of_glass;

    std::optional<rt::Scatter> operator()(rt::Vec3 incoming, const rt::Hit& hit,
                                          rt::Rng& random) const {
        return bounce(incoming, hit, random);
    }
    friend rt::Real scatter_density(const Materials& set, const rt::Hit& hit, rt::Vec3 direction) {
        return set.spread(hit, direction);
    }
    friend rt::Real scatter_density(const Materials& set, rt::Vec3 incoming, const rt::Hit& hit,
                                    rt::Vec3 direction) {
        return set.spread_of_all(incoming, hit, direction);
    }
    friend bool came_through_glass(const Materials& set, const rt::Hit& hit) {
        return set.is_inside_of_glass(hit);
    }
};

struct Lights {
    std::function<bool()> are_none;
    std::function<const rt::Light*(const rt::Hit&)> which;
    std::function<rt::Real(const rt::Light&, rt::Vec3)> density_of;
    std::function<std::optional<rt::ChosenLight>(rt::Vec3, rt::Rng&)> draw;

    bool empty() const { return are_none(); }
    const rt::Light* find(const rt::Hit& hit) const { return which(hit); }
    rt::Real density(const rt::Light& light, rt::Vec3 from) const {
        return density_of(light, from);
    }
    std::optional<rt::ChosenLight> choose(rt::Vec3 from, rt::Rng& random) const {
        return draw(from, random);
    }
};

template <class AnyRay>
struct Medium {
    std::function<std::optional<rt::Real>(const AnyRay&, rt::Real, rt::Rng&)> collide;
    std::function<rt::Scatter(rt::Vec3, rt::Rng&)> turn;
    std::function<rt::Real(rt::Vec3, rt::Vec3)> density_of;
    std::function<rt::Real(const AnyRay&, rt::Real)> share;

    std::optional<rt::Real> meets(const AnyRay& ray, rt::Real most, rt::Rng& random) const {
        return collide(ray, most, random);
    }
    rt::Scatter scatter(rt::Vec3 incoming, rt::Rng& random) const { return turn(incoming, random); }
    rt::Real density(rt::Vec3 incoming, rt::Vec3 outgoing) const {
        return density_of(incoming, outgoing);
    }
    rt::Real gets_through(const AnyRay& ray, rt::Real far) const { return share(ray, far); }
};

using Sky = std::function<rt::Color(rt::Vec3)>;
using Ending = std::function<rt::PathEnd(rt::Color&, rt::Rng&)>;

}  // namespace answer
