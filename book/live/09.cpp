// The live figure of chapter 09.
#include <array>
#include <map>
#include <rt/dielectric.hpp>
#include <rt/lambertian.hpp>
#include <rt/make_camera.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sky.hpp>
#include <rt/sphere_list.hpp>

#include "controls.hpp"
#include "live.hpp"

namespace live {
namespace {

// ---- How the judge tells noise from a mistake ----

enum Mistake { none, short_paths, darker_ball, darker_sky };
constexpr int side = 4, across = 16, down = 9;  // pixels of a tile, and tiles of a picture
constexpr int columns = side * across, rows = side * down, tiles = across * down;

struct Balls {
    rt::SphereList world;
    rt::MaterialSet<rt::Lambertian, rt::Metal, rt::Dielectric> set;

    void add(rt::Vec3 center, double radius, auto material) {
        world.spheres.push_back({{center, radius}, static_cast<int>(set.materials.size())});
        set.materials.emplace_back(material);
    }
    explicit Balls(Mistake mistake) {
        add({0, -1000, 0}, 1000, rt::Lambertian{{0.45, 0.4, 0.35}});
        const double share = mistake == darker_ball ? 0.9 : 1;
        add({-2.2, 1, -0.6}, 1, rt::Lambertian{share * rt::Color{0.2, 0.35, 0.7}});
        add({0, 1, 0}, 1, rt::Dielectric{1.5});
        add({0, 1, 0}, 0.85, rt::Dielectric{1 / 1.5});
        add({2.2, 1, 0.2}, 1, rt::Metal{{0.95, 0.75, 0.45}, 0.08});
    }
};

// What a program has drawn so far: its mean picture, and the light of each tile in each picture.
struct Drawn {
    std::vector<rt::Color> sum = std::vector<rt::Color>(columns * rows);
    std::array<std::vector<double>, tiles> light;

    void draw(Mistake mistake, unsigned seed) {
        static const rt::Camera camera = rt::make_camera(
            {{-1.5, 1.7, 7}, {0, 0.95, 0}, {0, 1, 0}, rt::radians(32)}, columns, rows);
        static const std::array<Balls, 4> all{Balls{none}, Balls{short_paths}, Balls{darker_ball},
                                              Balls{darker_sky}};
        const double share = mistake == darker_sky ? 0.99 : 1;
        const rt::GradientSky sky{share * rt::Color{1, 0.97, 0.9},
                                  share * rt::Color{0.35, 0.55, 1}};
        const int depth = mistake == short_paths ? 5 : 6;
        for (std::vector<double>& tile : light) tile.push_back(0);
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                const rt::Color color =
                    rt::render_pixel(camera, all[mistake].world, all[mistake].set, sky,
                                     rt::BlackEnding{}, {1, depth, seed}, x, y);
                sum[static_cast<std::size_t>(y * columns + x)] += color;
                light[static_cast<std::size_t>(y / side * across + x / side)].back() +=
                    (color.r + color.g + color.b) / (3 * side * side);
            }
    }
};

// So many pictures of a program. Yours and ours never have the same random numbers.
const Drawn& drawn(Mistake mistake, bool is_ours, std::size_t count) {
    static std::map<std::array<std::size_t, 3>, Drawn> all;
    Drawn& made = all[{static_cast<std::size_t>(mistake), is_ours, count}];
    while (made.light[0].size() < count)
        made.draw(mistake, static_cast<unsigned>(2 * made.light[0].size()) + is_ours);
    return made;
}

struct Estimate {
    double mean = 0, variance = 0;  // of a single picture
    explicit Estimate(const std::vector<double>& numbers) {
        const auto count = static_cast<double>(numbers.size());
        for (const double x : numbers) mean += x / count;
        for (const double x : numbers) variance += (x - mean) * (x - mean) / (count - 1);
    }
};

// How far the means of a tile's light are apart, in standard errors of their difference.
// Source: Welch, "The generalization of Student's problem", Biometrika 34, 1947.
double apart(const std::vector<double>& yours, const std::vector<double>& ours) {
    const Estimate a{yours}, b{ours};
    const double error = std::sqrt((a.variance + b.variance) / static_cast<double>(yours.size()));
    return error > 0 ? (a.mean - b.mean) / error : 0;
}

// With so many pictures of two right programs, one comparison in a thousand finds a tile that is
// farther apart than this: Student's t with 2 n - 2 degrees of freedom.
constexpr std::array<std::size_t, 4> counts{4, 8, 16, 32};
constexpr std::array limits{14.43, 6.93, 5.43, 4.91};

struct JudgeLayout {
    std::array<Point, 3> corners;  // of yours, ours and the map
    Point opposite;                // from a corner
    double dots, height;

    Point place(std::size_t panel, double column, double row) const {
        return corners[panel] + Point{column / across * opposite.x, row / down * opposite.y};
    }
};

JudgeLayout judge_layout(double width) {
    constexpr double title = 22, below = 94;
    const bool narrow = width < 520;
    const double wide = narrow ? (width - 12) / 2 : (width - 24) / 3, high = wide * down / across;
    const double second = title + high + 12;
    const Point third = narrow ? Point{wide / 2, second + title} : Point{2 * (wide + 12), title};
    const double dots = (narrow ? third.y : title) + high + 20;
    return {{Point{0, title}, Point{wide + 12, title}, third}, {wide, high}, dots, dots + below};
}

}  // namespace

void draw(const JudgeControls& c, Drawing& out) {
    const JudgeLayout layout = judge_layout(out.width);
    out.height = layout.height;
    const auto choice = static_cast<std::size_t>(c.pictures);
    const std::size_t count = counts[choice];
    const double limit = limits[choice];
    const Drawn& yours = drawn(static_cast<Mistake>(c.mistake), false, count);
    const Drawn& ours = drawn(none, true, count);

    std::array<double, tiles> far{};
    Bytes& map = out.picture(across, down);
    int differing = 0;
    for (std::size_t i = 0; i < tiles; ++i) {
        far[i] = apart(yours.light[i], ours.light[i]);
        differing += std::abs(far[i]) > limit;
        const double share = std::min(1.0, std::abs(far[i]) / limit);
        map.set(
            static_cast<int>(i % across), static_cast<int>(i / across),
            mix({0.8, 0.8, 0.8}, rt::from_hex(far[i] < 0 ? 0x2f6aa8 : 0xc8452a), share * share));
    }
    const std::array<std::string_view, 3> titles{"yours", "ours", "how far apart"};
    for (std::size_t panel = 0; panel < 3; ++panel) {
        const Point corner = layout.corners[panel], opposite = corner + layout.opposite;
        Bytes& mean = out.picture(columns, rows);
        for (std::size_t i = 0; panel < 2 && i < columns * rows; ++i)
            mean.set(static_cast<int>(i % columns), static_cast<int>(i / columns),
                     (panel == 0 ? yours : ours).sum[i] / static_cast<double>(count));
        out.show(panel < 2 ? mean : map, corner, opposite, false);
        out.bold = true;
        out.text({corner.x, corner.y - 11}, titles[panel], ink, Align::left);
        out.bold = false;
        out.frame(layout.place(panel, c.column, c.row),
                  layout.place(panel, c.column + 1, c.row + 1), {accent, 2});
    }
    for (std::size_t i = 0; i < tiles; ++i)
        if (std::abs(far[i]) > limit)
            out.circle(layout.place(2, static_cast<double>(i % across) + 0.5,
                                    static_cast<double>(i / across) + 0.5),
                       0.3 * layout.opposite.x / across, {rgb(0xffffff), 2});

    // The tile's light in each picture, and the means.
    const auto tile = static_cast<std::size_t>(c.row * across + c.column);
    const std::array lights{&yours.light[tile], &ours.light[tile]};
    const std::array means{Estimate{*lights[0]}.mean, Estimate{*lights[1]}.mean};
    const double middle = (means[0] + means[1]) / 2;
    double most = 1e-6;
    for (const auto* light : lights)
        for (const double x : *light) most = std::max(most, std::abs(x - middle));
    const double left = 64, right = out.width - 12;
    const auto x_of = [&](double light) {
        return (left + right) / 2 + (right - left) / 2 * (light - middle) / most;
    };
    out.text({0, layout.dots + 4}, "The tile’s light in each picture, and its mean:", muted,
             Align::left);
    for (std::size_t i = 0; i < 2; ++i) {
        const double y = layout.dots + 36 + 36 * static_cast<double>(i);
        const Ink color = i == 0 ? orange : blue;
        out.text({0, y}, titles[i], color, Align::left);
        out.line({left, y}, {right, y}, {faint, 1});
        for (const double x : *lights[i]) out.disc({x_of(x), y}, 4, thin(color, 0.55));
        const double x = x_of(means[i]);
        out.line({x, y - 14}, {x, y + 14}, {color, 3});
    }
    for (std::size_t panel = 0; panel < 3; ++panel)
        out.handle(layout.place(panel, c.column + 0.5, c.row + 0.5), 22, false);
    out.say(differing > 0
                ? "In this tile, the means are {.1} standard errors apart; more than {.1} would be "
                  "beyond chance, as in {} of {} tiles: the line fails."
                : "In this tile, the means are {.1} standard errors apart; more than {.1} would be "
                  "beyond chance, as in {} of {} tiles: the line passes.",
            std::abs(far[tile]), limit, differing, tiles);
}

void drag(JudgeControls& c, const Drag& to) {
    const Point tile = judge_layout(to.width).opposite;
    c.column = std::clamp(std::round(c.column + across * to.moved().x / tile.x), 0.0, across - 1.0);
    c.row = std::clamp(std::round(c.row + down * to.moved().y / tile.y), 0.0, down - 1.0);
}

}  // namespace live
