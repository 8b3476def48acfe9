#pragma once
// Rules that place many spheres: at random without overlaps, or in order like a sunflower's seeds.

#include <cstdint>
#include <functional>
#include <rt/rng.hpp>
#include <rt/sphere.hpp>
#include <unordered_map>
#include <vector>

namespace placing {

// A sphere in double, so that renderers in float and in double are given the same scene.
struct Ball {
    double x = 0, y = 0, z = 0;
    double radius = 0;
};

inline rt::Sphere sphere_of(const Ball& b) {
    using rt::Real;
    return {{static_cast<Real>(b.x), static_cast<Real>(b.y), static_cast<Real>(b.z)},
            static_cast<Real>(b.radius)};
}
inline Ball ball_of(const rt::Sphere& s) {
    const auto wide = [](rt::Real number) { return static_cast<double>(number); };
    return {wide(s.center.x), wide(s.center.y), wide(s.center.z), wide(s.radius)};
}

// A random number in [0, 1), the same in both precisions; and one in [low, high).
inline double uniform(rt::Rng& random) {
    return static_cast<double>(random()) * 0x1p-32;
}
inline double uniform(rt::Rng& random, double low, double high) {
    return low + (high - low) * uniform(random);
}

// True if two balls overlap. Balls that touch do not overlap: an overlap of up to a thousandth of
// the smaller radius counts as rounding.
bool overlap(const Ball& a, const Ball& b);

// Tells whether a new sphere would overlap any of those placed so far. It looks only at nearby
// spheres, which it finds with separate grids of cubes for each size of sphere. Spheres may touch.
class Neighbors {
  public:
    void add(const Ball& ball);
    bool has_room_for(const Ball& ball);
    // The number, in the order of add(), of a ball near `ball` that passes a test; -1 if none does.
    // All balls that overlap `ball` are near it.
    int find_near(const Ball& ball, const std::function<bool(int)>& test);
    // Whether the searches so far have taken more steps than anybody will wait for.
    bool is_tired() const { return steps_ > 100'000'000; }

  private:
    struct Grid {
        double cell = 1;
        std::size_t entered = 0;  // how many balls of its size are already in the grid
        std::unordered_map<std::uint64_t, std::vector<int>> balls;
    };
    // Spheres whose diameters lie between half of `diameter` and `diameter`. Their grids are made
    // on demand: a large ball looks for small ones in a grid of larger cells.
    struct Size {
        double diameter = 1;
        std::vector<int> numbers;
        std::vector<Grid> grids;
    };
    const Grid& grid_of(Size& size, double reach) const;

    std::vector<Size> sizes_;
    std::vector<Ball> balls_;
    std::int64_t steps_ = 0;
};

// A position for a ball of this radius, anywhere that the rule allows.
using Rule = std::function<Ball(double radius, rt::Rng& random)>;

// Four rules. on_plane: resting on a round floor with the middle and radius of `space`.
Rule on_plane(Ball space);
// on_sphere: resting on the surface of `space`.
Rule on_sphere(Ball space);
// in_ball: floating inside `space`.
Rule in_ball(Ball space);
// galaxy: along the arms of a galaxy that lies flat in `space`. Each arm makes this many turns from
// the middle to the rim. Balls lie up to `width` times the radius of `space` beside an arm and,
// near the middle, as far above and below it.
Rule galaxy(Ball space, int arms, double turns, double width);

// Places `count` balls according to a rule, the largest first. No new ball overlaps another new
// ball or a ball in `there`, to which all new balls are added. The radii lie between `low` and
// `high`, most of them near `low`. Returns fewer balls if there is no more room.
std::vector<Ball> scatter(int count, double low, double high, const Rule& rule, Neighbors& there,
                          std::uint64_t seed);

// Places balls on a floor like a sunflower's seeds: ball i stands at i times the golden angle, so
// that all have the same room. The radii grow from `inner` in the middle to `outer` at the rim.
std::vector<Ball> sunflower(int count, Ball space, double inner, double outer);

}  // namespace placing
