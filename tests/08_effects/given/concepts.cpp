// What the types of a path loop must be able to do: a type that lacks one member is refused.

#include <rt/fog.hpp>
#include <rt/path_end.hpp>
#include <rt/sphere_list.hpp>
#include <rt/world.hpp>

#include "checkpoint.hpp"

using checkpoint::Real;
using rt::Ray, rt::Rng;

namespace {

struct EmptyWorld {
    std::optional<rt::Hit> hit(const Ray&, rt::Interval) const { return {}; }
};
struct WorldOfDistances {
    std::optional<Real> hit(const Ray&, rt::Interval) const { return {}; }
};
struct ForgetfulFog : rt::FogBall {
    void gets_through() const {}  // hides the one with a ray and a distance
};
struct UndecidedEnding {
    bool operator()(rt::Color&, Rng&) const { return true; }
};

}  // namespace

TEST_CASE("a World has hit, which gives a Hit or none") {
    CHECK((rt::World<rt::SphereList> && rt::World<EmptyWorld>));
    CHECK_FALSE(rt::World<WorldOfDistances>);
    CHECK_FALSE(rt::World<rt::Sphere>);
}

TEST_CASE("a Medium has all that paths ask of fog") {
    CHECK((rt::Medium<rt::NoFog> && rt::Medium<rt::FogBall>));
    CHECK_FALSE(rt::Medium<ForgetfulFog>);
}

TEST_CASE("an Ending gives a PathEnd") {
    CHECK((rt::Ending<rt::SkyEnding> && rt::Ending<rt::BlackEnding>));
    CHECK_FALSE(rt::Ending<UndecidedEnding>);
}
