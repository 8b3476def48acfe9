#include "placing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <rt/portable.hpp>

namespace placing {
namespace {

// A cell's three whole coordinates in one number. Cells that share a number are searched together:
// that takes longer, but the answer is just as right.
std::uint64_t key_of(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto bits = [](std::int64_t c) { return static_cast<std::uint64_t>(c); };
    return rt::mix_bits(rt::mix_bits(rt::mix_bits(bits(x)) ^ bits(y)) ^ bits(z));
}

std::int64_t cell_of(double coordinate, double cell) {
    return static_cast<std::int64_t>(std::floor(coordinate / cell));
}

// A ball at this distance from the middle of the space, in a random direction.
Ball around(const Ball& space, double distance, double radius, rt::Rng& random) {
    const double y = uniform(random, -1, 1), angle = uniform(random, 0, 2 * std::numbers::pi);
    const double flat = distance * std::sqrt((1 - y) * (1 + y));
    return {space.x + flat * rt::portable::cos(angle), space.y + distance * y,
            space.z + flat * rt::portable::sin(angle), radius};
}

// A random number from -1 to 1, most often near 0.
double around_zero(rt::Rng& random) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += uniform(random, -1, 1);
    return sum / 3;
}

}  // namespace

bool overlap(const Ball& a, const Ball& b) {
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    const double apart = a.radius + b.radius - std::min(a.radius, b.radius) / 1000;
    return x * x + y * y + z * z < apart * apart;
}

void Neighbors::add(const Ball& ball) {
    const double diameter = rt::portable::exp2(std::ceil(rt::portable::log2(2 * ball.radius)));
    auto size = std::find_if(sizes_.begin(), sizes_.end(),
                             [&](const Size& s) { return s.diameter == diameter; });
    if (size == sizes_.end()) size = sizes_.insert(sizes_.end(), {diameter, {}, {}});
    size->numbers.push_back(static_cast<int>(balls_.size()));
    balls_.push_back(ball);
}

// A grid of all balls of one size, with cells so large that only few cells are within reach.
const Neighbors::Grid& Neighbors::grid_of(Size& size, double reach) const {
    const double cell =
        std::max(size.diameter, rt::portable::exp2(std::ceil(rt::portable::log2(reach / 4))));
    auto grid = std::find_if(size.grids.begin(), size.grids.end(),
                             [&](const Grid& g) { return g.cell == cell; });
    if (grid == size.grids.end()) grid = size.grids.insert(size.grids.end(), {cell, 0, {}});
    for (; grid->entered < size.numbers.size(); ++grid->entered) {
        const int number = size.numbers[grid->entered];
        const Ball& b = balls_[static_cast<std::size_t>(number)];
        grid->balls[key_of(cell_of(b.x, cell), cell_of(b.y, cell), cell_of(b.z, cell))].push_back(
            number);
    }
    return *grid;
}

int Neighbors::find_near(const Ball& ball, const std::function<bool(int)>& test) {
    for (Size& size : sizes_) {
        // If a ball of this size overlaps `ball`, their middles are less than this far apart.
        const double reach = ball.radius + size.diameter / 2;
        const Grid& grid = grid_of(size, reach);
        const auto low = [&](double c) { return cell_of(c - reach, grid.cell); };
        const auto high = [&](double c) { return cell_of(c + reach, grid.cell); };
        for (std::int64_t x = low(ball.x); x <= high(ball.x); ++x)
            for (std::int64_t y = low(ball.y); y <= high(ball.y); ++y)
                for (std::int64_t z = low(ball.z); z <= high(ball.z); ++z) {
                    ++steps_;
                    const auto cell = grid.balls.find(key_of(x, y, z));
                    if (cell == grid.balls.end()) continue;
                    for (const int number : cell->second) {
                        ++steps_;
                        if (test(number)) return number;
                    }
                }
    }
    return -1;
}

bool Neighbors::has_room_for(const Ball& ball) {
    return find_near(ball,
                     [&](int i) { return overlap(ball, balls_[static_cast<std::size_t>(i)]); }) < 0;
}

Rule on_plane(Ball space) {
    return [=](double radius, rt::Rng& random) -> Ball {
        const double distance = space.radius * std::sqrt(uniform(random));
        const double angle = uniform(random, 0, 2 * std::numbers::pi);
        return {space.x + distance * rt::portable::cos(angle), space.y + radius,
                space.z + distance * rt::portable::sin(angle), radius};
    };
}

Rule on_sphere(Ball space) {
    return [=](double radius, rt::Rng& random) {
        return around(space, space.radius + radius, radius, random);
    };
}

Rule in_ball(Ball space) {
    return [=](double radius, rt::Rng& random) {
        const double most = std::max(0.0, space.radius - radius);
        return around(space, most * rt::portable::cbrt(uniform(random)), radius, random);
    };
}

Rule galaxy(Ball space, int arms, double turns, double width) {
    return [=](double radius, rt::Rng& random) -> Ball {
        const double way = std::sqrt(uniform(random));  // from the middle to the rim
        const auto arm = static_cast<double>(random() % static_cast<unsigned>(arms));
        const double angle = 2 * std::numbers::pi * (turns * way + arm / arms);
        const double x = way * rt::portable::cos(angle) + width * around_zero(random);
        const double z = way * rt::portable::sin(angle) + width * around_zero(random);
        const double y = width * (1 - 0.8 * way) * around_zero(random);  // thin at the rim
        return {space.x + space.radius * x, space.y + space.radius * y, space.z + space.radius * z,
                radius};
    };
}

std::vector<Ball> scatter(int count, double low, double high, const Rule& rule, Neighbors& there,
                          std::uint64_t seed) {
    constexpr std::int64_t tries = 30;  // for each ball, on average
    rt::Rng random{seed, 8};
    std::vector<double> radii(static_cast<std::size_t>(count));
    for (double& radius : radii) {
        const double size = uniform(random);
        radius = low + (high - low) * size * size;
    }
    // Large balls come first, because small balls find room between them.
    std::sort(radii.begin(), radii.end(), std::greater<>{});

    std::vector<Ball> placed;
    for (std::int64_t left = tries * count; left > 0 && placed.size() < radii.size(); --left) {
        if (there.is_tired()) break;
        const Ball ball = rule(radii[placed.size()], random);
        if (!there.has_room_for(ball)) continue;
        there.add(ball);
        placed.push_back(ball);
    }
    return placed;
}

std::vector<Ball> sunflower(int count, Ball space, double inner, double outer) {
    constexpr double golden_angle = 2 * std::numbers::pi * (2 - std::numbers::phi);
    std::vector<Ball> balls;
    for (int i = 0; i < count; ++i) {
        const double way = std::sqrt((i + 0.5) / count);
        const double radius = inner + (outer - inner) * way, angle = i * golden_angle;
        balls.push_back({space.x + space.radius * way * rt::portable::cos(angle), space.y + radius,
                         space.z + space.radius * way * rt::portable::sin(angle), radius});
    }
    return balls;
}

}  // namespace placing
