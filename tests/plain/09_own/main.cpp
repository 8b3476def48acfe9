// The core of chapter 09: steps 1 to 6, plainly. own SCENE PICTURE.ppm [--threads N] [--seed N]
// [--list]

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

constexpr double pi = 3.14159265358979323846;

// A point, a direction, or a color in linear light.
struct Vec3 {
    double x = 0, y = 0, z = 0;
    friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend Vec3 operator*(double s, Vec3 v) { return {s * v.x, s * v.y, s * v.z}; }
    friend double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend double length(Vec3 v) { return std::sqrt(dot(v, v)); }
    friend Vec3 unit(Vec3 v) { return 1 / length(v) * v; }
    friend Vec3 cross(Vec3 a, Vec3 b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
};

// Each sample of each pixel has a stream of its own, whichever thread draws it.
struct Random {
    std::uint64_t state;
    Random(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample)
        : state{mix(mix(mix(seed) + pixel) + sample)} {}
    double uniform() {  // in [0, 1)
        state += 0x9e3779b97f4a7c15;
        return static_cast<double>(mix(state) >> 11) / (1ull << 53);
    }
    Vec3 direction() {  // of length 1, all equally likely
        const double z = 1 - 2 * uniform(), angle = 2 * pi * uniform();
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        return {r * std::cos(angle), r * std::sin(angle), z};
    }
    // The finalizer of SplitMix64 (Steele, Lea and Flood, 2014): each bit depends on every other.
    static std::uint64_t mix(std::uint64_t x) {
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
        x = (x ^ x >> 27) * 0x94d049bb133111eb;
        return x ^ x >> 31;
    }
};

// ---- The scene and its file

enum class Kind { matte, metal, glass };
struct Material {
    Kind kind = Kind::matte;
    Vec3 color{0.5, 0.5, 0.5};
    double fuzz = 0, index = 1;
};
struct Sphere {
    Vec3 center;
    double radius;
    Material material;
};
struct Scene {
    int width = 400, height = 225, samples = 16, depth = 50;
    Vec3 from{0, 0, 5}, at, up{0, 1, 0};  // the camera
    double fov_deg = 40, aperture = 0, focus = 1;
    Vec3 below{1, 1, 1}, above{0.5, 0.7, 1};  // the sky
    std::vector<Sphere> spheres;
};

void expect(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("expected " + what);
}

std::istream& operator>>(std::istream& in, Vec3& v) {
    return in >> v.x >> v.y >> v.z;
}

void read_line(const std::string& line, Scene& scene, Material& material) {
    std::istringstream in{line};
    std::string word, more;
    if (!(in >> word)) return;
    Sphere sphere{{}, 1, {}};
    if (word == "picture")
        in >> scene.width >> scene.height >> scene.samples >> scene.depth;
    else if (word == "camera")
        in >> scene.from >> scene.at >> scene.up >> scene.fov_deg >> scene.aperture >> scene.focus;
    else if (word == "sky")
        in >> scene.below >> scene.above;
    else if (word == "matte") {
        material = {Kind::matte};
        in >> material.color;
    } else if (word == "metal") {
        material = {Kind::metal};
        in >> material.color >> material.fuzz;
    } else if (word == "glass") {
        material = {Kind::glass, {1, 1, 1}};
        in >> material.index;
    } else if (word == "sphere")
        in >> sphere.center >> sphere.radius;
    else
        expect(false, "camera, glass, matte, metal, picture, sky or sphere, not " + word);
    expect(!in.fail() && !(in >> more), "the right numbers after " + word);
    if (word == "sphere") scene.spheres.push_back({sphere.center, sphere.radius, material});
}

Scene read_scene(const std::string& path) {
    std::ifstream file{path};
    expect(file.is_open(), "a scene file, but cannot read " + path);
    Scene scene;
    Material material;
    for (std::string line; std::getline(file, line);)
        read_line(line.substr(0, line.find('#')), scene, material);
    return scene;
}

struct Ray {
    Vec3 origin, direction;  // of length 1
};
struct Hit {
    double t = 1e300;
    int sphere = -1;
};

Hit nearest(const std::vector<Sphere>& spheres, const Ray& ray) {
    Hit hit;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const Vec3 f = ray.origin - spheres[i].center;
        const double b = dot(f, ray.direction);
        const double under_root = b * b - dot(f, f) + spheres[i].radius * spheres[i].radius;
        if (under_root < 0) continue;
        double t = -b - std::sqrt(under_root);
        if (t < 0.001) t = -b + std::sqrt(under_root);
        if (t > 0.001 && t <= hit.t) hit = {t, static_cast<int>(i)};
    }
    return hit;
}

// ---- Materials, paths, pixels

Vec3 reflect(Vec3 d, Vec3 normal) {
    return d - 2 * dot(d, normal) * normal;
}

// The share of light that glass reflects (Fresnel, the mean of both polarizations). The cosines are
// those on the two sides; eta is the index on this side divided by the index on the other.
double reflectance(double cosine, double inner, double eta) {
    const double s = (eta * cosine - inner) / (eta * cosine + inner);
    const double p = (eta * inner - cosine) / (eta * inner + cosine);
    return (s * s + p * p) / 2;
}

// The direction in which light that arrives along d goes on; `outward` is the surface's normal.
Vec3 scatter(const Material& material, Vec3 d, Vec3 outward, Random& random) {
    const bool outside = dot(d, outward) < 0;
    const Vec3 normal = outside ? outward : -1 * outward;
    if (material.kind == Kind::glass) {
        const double eta = outside ? 1 / material.index : material.index;
        const double cosine = std::min(1.0, -dot(d, normal));
        const double under_root = 1 - eta * eta * (1 - cosine * cosine);
        const double inner = std::sqrt(std::max(0.0, under_root));
        if (under_root <= 0 || random.uniform() < reflectance(cosine, inner, eta))
            return unit(reflect(d, normal));
        return unit(eta * d + (eta * cosine - inner) * normal);
    }
    const bool matte = material.kind == Kind::matte;
    Vec3 next = matte ? normal + random.direction()
                      : reflect(d, normal) + material.fuzz * random.direction();
    // A direction that strays below the surface is folded up, so no light is lost.
    next = next - 2 * std::min(0.0, dot(next, normal)) * normal;
    return length(next) > 0 ? unit(next) : normal;
}

class Renderer {
  public:
    Renderer(const Scene& scene, int seed)
        : scene_{scene},
          seed_{seed},
          w_{unit(scene.from - scene.at)},
          u_{unit(cross(scene.up, w_))},
          v_{cross(w_, u_)},
          pixel_{2 * std::tan(scene.fov_deg * pi / 360) / scene.height} {}

    Vec3 pixel(int x, int y) const {
        Vec3 sum;
        for (int sample = 0; sample < scene_.samples; ++sample) {
            Random random(seed_, y * std::uint64_t{10'000} + x, sample);
            const double right = (x + random.uniform() - scene_.width / 2.0) * pixel_;
            const double up = (scene_.height / 2.0 - y - random.uniform()) * pixel_;
            const Vec3 direction = right * u_ + up * v_ - w_;
            sum = sum + light({scene_.from, unit(direction)}, random);
        }
        return 1.0 / scene_.samples * sum;
    }

  private:
    // The light along a ray. A path that has bounced `depth` times and hits something brings none.
    Vec3 light(Ray ray, Random& random) const {
        Vec3 throughput{1, 1, 1};
        for (int bounce = 0; bounce <= scene_.depth; ++bounce) {
            const Hit hit = nearest(scene_.spheres, ray);
            if (hit.sphere < 0) {
                const double up = (ray.direction.y + 1) / 2;
                return throughput * ((1 - up) * scene_.below + up * scene_.above);
            }
            const Sphere& sphere = scene_.spheres[hit.sphere];
            const Vec3 normal = unit(ray.origin + hit.t * ray.direction - sphere.center);
            const Vec3 next = scatter(sphere.material, ray.direction, normal, random);
            throughput = throughput * sphere.material.color;
            ray = {ray.origin + hit.t * ray.direction, next};
        }
        return {};
    }

    const Scene& scene_;
    int seed_;
    Vec3 w_, u_, v_;  // back, to the right, up
    double pixel_;    // its side
};

std::vector<Vec3> render(const Scene& scene, const Renderer& renderer) {
    std::vector<Vec3> picture;
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) picture.push_back(renderer.pixel(x, y));
    return picture;
}

char to_byte(double c) {
    const double srgb = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<char>(static_cast<unsigned char>(255 * std::min(1.0, srgb) + 0.5));
}

void write_ppm(const std::string& path, const Scene& scene, const std::vector<Vec3>& picture) {
    std::ofstream file{path, std::ios::binary};
    file << "P6\n" << scene.width << ' ' << scene.height << "\n255\n";
    for (const Vec3& color : picture)
        file.put(to_byte(color.x)).put(to_byte(color.y)).put(to_byte(color.z));
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

int main(int argc, char** argv) try {
    const std::vector<std::string> words{argv + 1, argv + argc};
    std::vector<std::string> files;
    int seed = 1;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == "--seed")
            seed = std::stoi(words[++i]);
        else if (words[i] == "--threads")
            ++i;
        else if (words[i] != "--list")
            files.push_back(words[i]);
    expect(files.size() == 2, "SCENE PICTURE.ppm [--threads N] [--seed N] [--list]");
    const Scene scene = read_scene(files[0]);
    write_ppm(files[1], scene, render(scene, {scene, seed}));
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
