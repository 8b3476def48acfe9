#include <rt/portable.hpp>
#include <study/classic.hpp>
#include <study/classic_tree.hpp>

namespace study::classic {
namespace {

Vec ray_color(const Ray& ray, int depth, const Hittable& world) {
    if (depth <= 0) return {};
    HitRecord hit;
    if (world.hit(ray, {0.001, std::numeric_limits<double>::infinity()}, hit)) {
        Ray out;
        Vec attenuation;
        if (!hit.material->scatter(ray, hit, attenuation, out)) return {};
        return attenuation * ray_color(out, depth - 1, world);
    }
    const double a = (unit(ray.direction).y() + 1) / 2;
    return (1 - a) * Vec{1, 1, 1} + a * Vec{0.5, 0.7, 1};
}

// The camera's rays go through the pixels of a window in the world; their directions are not
// normalized.
class Camera {
  public:
    Camera(int width, int height, double vertical_fov, const Vec& from, const Vec& at,
           const Vec& up)
        : from_{from} {
        const Vec back = from - at, w = unit(back), u = unit(cross(up, w)), v = cross(w, u);
        const double distance = std::sqrt(dot(back, back));
        const double window = 2 * rt::portable::tan(vertical_fov / 2) * distance;
        across_ = window / height * u;
        down_ = -(window / height) * v;
        first_ = from - back - width / 2.0 * across_ - height / 2.0 * down_;
    }
    Ray ray(int column, int row) const {
        const double x = column + random_double(), y = row + random_double();
        const Vec through = first_ + x * across_ + y * down_;
        return {from_, through - from_};
    }

  private:
    Vec from_, first_, across_, down_;
};

Vec in_double(rt::Vec3 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

std::shared_ptr<Material> make_material(const study::CoverSphere& sphere) {
    const Vec color = in_double({sphere.color.r, sphere.color.g, sphere.color.b});
    switch (sphere.material) {
        case study::CoverMaterial::matte:
            return std::make_shared<Matte>(color);
        case study::CoverMaterial::metal:
            return std::make_shared<Metal>(color, static_cast<double>(sphere.fuzz));
        case study::CoverMaterial::glass:
            break;
    }
    return std::make_shared<Glass>(static_cast<double>(study::cover_glass_index));
}

}  // namespace

std::shared_ptr<const Hittable> make_world(const study::Cover& cover) {
    Objects objects;
    for (const study::CoverSphere& sphere : cover.spheres)
        objects.push_back(std::make_shared<Ball>(
            in_double(sphere.center), static_cast<double>(sphere.radius), make_material(sphere)));
    const auto tree = std::make_shared<Node>(objects, 0, objects.size());
    return std::make_shared<List>(Objects{tree});
}

namespace {

// Returns a function that computes the color of the pixel in a column and a row.
auto make_shade(const study::Cover& cover, const Hittable& world) {
    const Camera camera{cover.width,
                        cover.height,
                        static_cast<double>(cover.view.vertical_fov),
                        in_double(cover.view.from),
                        in_double(cover.view.at),
                        in_double(cover.view.up)};
    return [camera, &cover, &world](int x, int y) {
        Vec sum;
        for (int i = 0; i < cover.samples_per_pixel; ++i)
            sum = sum + ray_color(camera.ray(x, y), cover.depth, world);
        const Vec mean = sum / cover.samples_per_pixel;
        return rt::Color{static_cast<rt::Real>(mean.x()), static_cast<rt::Real>(mean.y()),
                         static_cast<rt::Real>(mean.z())};
    };
}

}  // namespace

rt::Color mean_color(const study::Cover& cover, const Hittable& world) {
    return study::mean_color(cover, make_shade(cover, world));
}

rt::Image picture(const study::Cover& cover, const Hittable& world) {
    return rt::make_image(cover.width, cover.height, make_shade(cover, world));
}

}  // namespace study::classic
