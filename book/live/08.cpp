// The live figures of chapter 08.
#include <array>
#include <rt/instance.hpp>
#include <rt/lit_path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/sample_rng.hpp>

#include "controls.hpp"
// The chapter's last scene, and how its spheres are placed.
#include "final_scene.cpp"
#include "found_by_chance.hpp"
#include "live.hpp"
#include "placing.cpp"
#include "plane.hpp"

namespace live {
namespace {

// ---- The last scene, through a lens and fog ----

constexpr rt::Effects effects{.mirror = false,
                              .fuzz = true,
                              .glass = true,
                              .texture = false,
                              .lens = true,
                              .motion = false,
                              .lights = true,
                              .fog = true,
                              .instances = true,
                              .own = false};

struct Evening {
    rt::SceneDescription scene = effects::final_scene();
    rt::ReadyScene<live::effects> ready{scene, 16, 9};
};

const Evening& evening() {
    static const Evening built;
    return built;
}

double evening_aspect(double width) {
    return width < 520 ? 1.4 : 1.9;
}

rt::Camera evening_camera(double width, int columns, int rows) {
    rt::View view = evening().scene.camera.view;
    if (width < 520) view.vertical_fov = rt::radians(34);
    return rt::make_camera(view, columns, rows);
}

}  // namespace

void draw(const LensControls& c, Drawing& out) {
    const double aspect = evening_aspect(out.width);
    out.height = out.width / aspect;
    const int columns = static_cast<int>(std::min(out.width * out.pixel_ratio, 440.0)),
              rows = static_cast<int>(columns / aspect);
    const auto& ready = evening().ready;
    const double focus = std::pow(10, c.focus);
    const rt::LensCamera eye{evening_camera(out.width, columns, rows), {c.aperture, focus}};
    rt::FogBall fog;
    fog.fog = {{{0, 0, 0}, 70}, c.fog, {1, 1, 1}, c.forward};
    out.refine({0, 0}, {out.width, out.height}, columns, rows, 256,
               [&ready, eye, fog](int column, int row, int sample) {
                   rt::Rng random = rt::sample_rng(1, column, row, sample);
                   const rt::Vec2 offset = rt::random_place(random);
                   const rt::Ray ray = make_ray(eye, column, row, offset, random);
                   return lit_path_radiance(ray, ready.world, ready.materials, ready.sky,
                                            ready.lights, fog, rt::SkyEnding{}, 10, random);
               });
    out.handle_everywhere();
    const double disk = c.aperture / focus / eye.camera.viewport.height * out.height;
    if (c.fog > 0)
        out.say(
            "Sharp at the distance {.1}; a light far away becomes a disk {.0} pixels wide. On "
            "average, light goes {.0} units before it meets a droplet.",
            focus, disk, 1 / c.fog);
    else
        out.say(
            "Sharp at the distance {.1}; a light far away becomes a disk {.0} pixels wide. There "
            "is no fog.",
            focus, disk);
}

// Focuses on what is under the pointer.
void drag(LensControls& c, const Drag& to) {
    const int columns = static_cast<int>(to.width),
              rows = static_cast<int>(to.width / evening_aspect(to.width));
    const rt::Camera camera = evening_camera(to.width, columns, rows);
    const int column = std::clamp(static_cast<int>(to.at.x), 0, columns - 1),
              row = std::clamp(static_cast<int>(to.at.y), 0, rows - 1);
    const rt::Ray ray = rt::primary_ray(camera, column, row, {0.5, 0.5});
    const auto hit = evening().ready.world.hit(ray, {0, rt::infinity});
    const double far = hit ? -dot(hit->point - camera.eye, camera.basis.w) : 1e4;
    c.focus = std::log10(std::max(1.0, far));
}

// ---- Lamps, found by chance and sampled ----

namespace {

struct Night {
    rt::WideTree world;
    rt::MaterialSet<rt::Lambertian, rt::Metal> materials;
    rt::SceneLights lights;
    rt::GradientSky sky{{0.004, 0.006, 0.016}, {0.002, 0.003, 0.01}};
};

// Three lamps of this radius over a floor with balls. Small lamps give as much light as large ones.
Night make_night(double lamp_radius) {
    Night night;
    std::vector<rt::SceneSphere> spheres;
    night.materials.materials = {rt::Lambertian{rt::from_hex(0xc9c4bd)},
                                 rt::Lambertian{rt::from_hex(0xf2ece2)},
                                 rt::Metal{rt::from_hex(0xe8dcc8), 0.15}, rt::Lambertian{}};
    constexpr int black = 3;  // lamps reflect nothing
    const auto add = [&](rt::Vec3 center, double radius, int material) {
        spheres.push_back({{center, radius}, material});
    };
    add({0, -600, 0}, 600, 0);
    add({0, 0.95, 0}, 0.95, 1);
    add({-2.2, 0.6, -1.6}, 0.6, 1);
    add({2.1, 0.7, -1.7}, 0.7, 1);
    for (int i = 0; i < 60; ++i) {  // small ones, on the spirals of a sunflower
        const double angle = 2.39996 * i, far = 0.52 * std::sqrt(i + 6.5);
        const rt::Vec3 center{far * std::cos(angle), 0.17, far * std::sin(angle)};
        const bool is_free = std::none_of(spheres.begin() + 1, spheres.end(), [&](const auto& s) {
            return rt::length(s.shape.center - center) < s.shape.radius + 0.2;
        });
        if (is_free) add(center, 0.17, i % 5 == 0 ? 2 : 1);
    }
    struct Lamp {
        rt::Vec3 center;
        rt::Color light;
    };
    const std::array lamps{Lamp{{-2.3, 1.7, 1.0}, {1.15, 0.48, 0.09}},
                           Lamp{{0.3, 2.7, -1.9}, {0.13, 0.47, 1.3}},
                           Lamp{{2.4, 1.5, 1.1}, {1.25, 0.12, 0.33}}};
    for (const Lamp& lamp : lamps) {
        const auto number = static_cast<int>(night.lights.all().size());
        const auto in_tree = static_cast<int>(spheres.size());
        const rt::Sphere shape{lamp.center, lamp_radius};
        spheres.push_back({shape, black, number});
        const double strength = 1.7 / (lamp_radius * lamp_radius);
        night.lights.add({shape, strength * lamp.light, number, in_tree});
    }
    night.world = rt::make_wide_tree(spheres);
    return night;
}

}  // namespace

void draw(const LampsControls& c, Drawing& out) {
    const bool narrow = out.is_narrow();
    const double gap = 12, title = 26;
    const double wide = narrow ? out.width : (out.width - gap) / 2, high = wide * 0.66;
    const int columns = static_cast<int>(std::min(wide * out.pixel_ratio, 360.0)),
              rows = static_cast<int>(columns * 0.66);
    out.height = narrow ? 2 * high : high + title;

    const double turn = rt::radians(c.turn);
    const rt::Camera camera = rt::make_camera({{10.5 * std::sin(turn), 4.4, 10.5 * std::cos(turn)},
                                               {0, 0.9, 0},
                                               {0, 1, 0},
                                               rt::radians(30)},
                                              columns, rows);
    const auto night = std::make_shared<Night>(make_night(c.radius));
    const FoundByChance by_chance{night->lights};
    // One picture holds both: side by side, or one above the other.
    const Point corner{0, narrow ? 0 : title};
    out.refine(corner, {out.width, out.height}, narrow ? columns : 2 * columns,
               narrow ? 2 * rows : rows, static_cast<int>(c.samples),
               [night, by_chance, camera, columns, rows](int column, int row, int sample) {
                   const bool is_first = column < columns && row < rows;
                   rt::Rng random = rt::sample_rng(1, column % columns, row % rows, sample);
                   const rt::Ray ray = rt::primary_ray(camera, column % columns, row % rows,
                                                       rt::random_place(random));
                   const auto light = [&](const auto& lights) {
                       return lit_path_radiance(ray, night->world, night->materials, night->sky,
                                                lights, rt::NoFog{}, rt::SkyEnding{}, 6, random);
                   };
                   return is_first ? light(by_chance) : light(night->lights);
               });
    // Paper between the two.
    const Point middle{out.width / 2, (corner.y + out.height) / 2};
    if (narrow)
        out.box(middle - Point{middle.x, 3}, middle + Point{middle.x, 3}, paper);
    else
        out.box({middle.x - gap / 2, corner.y}, {middle.x + gap / 2, out.height}, paper);
    out.bold = true;
    if (narrow) {
        out.on_picture = true;
        out.text({10, 16}, "Lamps found by chance", ink, Align::left);
        out.text({10, high + 16}, "Lamps sampled", ink, Align::left);
        out.on_picture = false;
    } else {
        out.text({0, 12}, "Lamps found by chance", ink, Align::left);
        out.text({wide + gap, 12}, "Lamps sampled, at each bounce", ink, Align::left);
    }
    out.bold = false;
    out.handle_everywhere();

    double directions = 0;  // the share of the hemisphere that leads to a lamp
    for (const rt::Light& lamp : night->lights.all())
        directions +=
            1 / (2 * rt::pi * rt::light_density(std::get<rt::Sphere>(lamp.shape), {0, 0, 1.6}));
    out.say(
        "From the floor in front of the large ball, one direction in {.0} leads to a lamp. The "
        "lamps "
        "give the same light, however small they are.",
        1 / directions);
}

void drag(LampsControls& c, const Drag& to) {
    c.turn -= 90 * to.moved().x / to.width;
}

// ---- An instance, in the world and in its own space ----

namespace {

struct InstanceLayout {
    Frame world, object;
    double panel, height;  // of each of the two panels
};

InstanceLayout instance_layout(double width) {
    const bool narrow = width < 520;
    const double panel = narrow ? width : width / 2 - 8, scale = panel / 7.6, high = 4.9 * scale;
    const Frame world{{panel / 2, high / 2 + 12}, {-0.4, 0}, scale};
    return {world,
            {world.at + (narrow ? Point{0, high + 24} : Point{panel + 16, 0}), {-1.4, 0}, scale},
            panel,
            high};
}

rt::Instance instance_of(const InstanceControls& c) {
    const double turn = rt::radians(c.turn), x = std::cos(turn), y = std::sin(turn);
    return rt::make_instance(
        rt::from_columns({c.stretch * x, c.stretch * y, 0}, {-y, x, 0}, {0, 0, 1}, {0.8, 0.2, 0}),
        0);
}

rt::Ray ray_of(const InstanceControls& c) {
    const bool has_direction = c.dx != 0 || c.dy != 0;  // else the shortest that there is
    return {{c.x, c.y, 0}, {has_direction ? c.dx : 0.05, c.dy, 0}};
}

// The part of the ray that its panel shows, with a mark at each whole t, the ellipse that the
// matrix makes of the unit circle, and what is met at t.
void draw_space(Drawing& out, const Frame& at, const InstanceLayout& layout, const rt::Mat4& m,
                const rt::Ray& ray, std::optional<double> t, rt::Vec3 normal,
                const std::array<std::string_view, 2>& names) {
    const auto page = [&](rt::Vec3 p) { return at.to_page(in_plane(p)); };
    const auto is_in = [&](Point p) {
        return std::abs(p.x - at.at.x) < layout.panel / 2 - 6 &&
               std::abs(p.y - at.at.y) < layout.height / 2 - 6;
    };
    std::vector<Point> rim, seen;
    for (int i = 0; i <= 90; ++i) {
        const double angle = rt::radians(4 * i);
        rim.push_back(page(rt::transform_point(m, {std::cos(angle), std::sin(angle), 0})));
    }
    out.polygon(rim, thin(sky, 0.3));
    out.path(rim, {sky, 2});
    for (double along = 0; along < 16; along += 0.02)
        if (const Point p = page(ray.at(along)); is_in(p)) seen.push_back(p);
    out.path(seen, {thin(accent, 0.7), 1.5});
    if (is_in(page(ray.origin))) {
        out.arrow(page(ray.origin), page(ray.at(1)), {accent, 3.5});
        const Point start = page(ray.origin), along = page(ray.at(1)) - start;
        out.text(start - (22 / std::hypot(along.x, along.y)) * along, names[0], ink);
        out.text(page(ray.at(0.5)) + Point{-8, 17}, names[1], accent, Align::right);
    }
    for (int whole = 1; whole < 16; ++whole)
        if (const Point p = page(ray.at(whole)); is_in(p)) {
            out.disc(p, 2.5, ink);
            out.text(p + Point{0, 13}, "{}", muted, Align::middle, double(whole));
        }
    if (t) {
        const Point hit = page(ray.at(*t));
        out.arrow(hit, page(ray.at(*t) + 0.8 * normal), {blue, 2.5});
        out.text(page(ray.at(*t) + 0.4 * normal) - Point{0, 14}, "n", blue);
        out.dot(hit, green, 5);
    }
}

}  // namespace

void draw(const InstanceControls& c, Drawing& out) {
    const InstanceLayout layout = instance_layout(out.width);
    out.height = layout.object.at.y + layout.height / 2 + 12;
    const rt::Instance instance = instance_of(c);
    const rt::Ray ray = ray_of(c);
    rt::Ray there = rt::object_ray(instance, ray);
    if (c.way == 1) there.direction = rt::normalize(there.direction);

    const auto t = rt::hit_instance(instance, ray, {0, rt::infinity});
    const auto t_there = rt::hit_sphere(rt::unit_sphere, there, {0, rt::infinity});
    draw_space(out, layout.world, layout, instance.object_to_world, ray, t,
               t ? surface_hit(instance, ray, *t).normal : rt::Vec3{}, {"O", "d"});
    draw_space(out, layout.object, layout, {}, there, t_there,
               t_there ? there.at(*t_there) : rt::Vec3{}, {"M⁻¹O", "M⁻¹d"});
    if (c.way == 1 && t_there) {
        const Point wrong = layout.world.to_page(in_plane(ray.at(*t_there)));
        out.dot(wrong, orange, 5);
        out.text(wrong - Point{0, 16}, "t = {.2}", orange, Align::middle, *t_there);
    }
    out.handle(layout.world.to_page({c.x, c.y}));
    out.handle(layout.world.to_page({c.x + c.dx, c.y + c.dy}));

    for (const auto& [frame, name] :
         {std::pair{layout.world, "the world"}, std::pair{layout.object, "the object’s space"}}) {
        const Point half{layout.panel / 2, layout.height / 2};
        out.frame(frame.at - half, frame.at + half, {faint, 1});
        out.bold = true;
        out.text(frame.at - half + Point{10, 16}, name, ink, Align::left);
        out.bold = false;
    }
    if (!t || !t_there)
        out.say("The ray misses the sphere in its own space, and so it misses the ellipsoid.");
    else
        out.say(
            "The hit is at t = {.2} in the world, and at t = {.2} in the object’s space, where the "
            "direction is {.2} long.",
            *t, *t_there, rt::length(there.direction));
}

void drag(InstanceControls& c, const Drag& to) {
    const Frame at = instance_layout(to.width).world;
    const Point start{c.x, c.y}, tip = start + Point{c.dx, c.dy};
    const Point moved = (1 / at.scale) * Point{to.moved().x, -to.moved().y};
    if (distance(at.to_page(start), to.down) < distance(at.to_page(tip), to.down))
        c.x += moved.x, c.y += moved.y;
    else
        c.dx += moved.x, c.dy += moved.y;
}

}  // namespace live
