// A path tracer in one file: spheres of matte, metal and glass under a sky, seen through a lens.
//
//   own SCENE PICTURE.ppm [--threads N] [--seed N] [--list]
//
// From the scene file's words to the picture's bytes, in the order of this file: vectors, random
// numbers, the scene and its reader, one ray and one sphere, a tree of boxes, three materials, a
// path, a picture on all cores.

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

// ---- Vectors; colors are vectors too ----------------------------------------------------------

struct Vec3 {
    double x = 0, y = 0, z = 0;
    double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec3 operator*(Vec3 a, Vec3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
Vec3 operator*(double s, Vec3 v) {
    return {s * v.x, s * v.y, s * v.z};
}
double dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(Vec3 v) {
    return std::hypot(v.x, v.y, v.z);
}
Vec3 unit(Vec3 v) {
    return 1 / length(v) * v;
}

constexpr double infinity = std::numeric_limits<double>::infinity(), pi = 3.14159265358979323846;

// ---- Random numbers ---------------------------------------------------------------------------

// A stream of its own for every sample of every pixel: the picture does not depend on which thread
// draws what.
class Random {
  public:
    Random(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample)
        : state_{mix(mix(mix(seed) + pixel) + sample)} {}
    // In [0, 1).
    double uniform() {
        state_ += 0x9e3779b97f4a7c15;
        return static_cast<double>(mix(state_) >> 11) * 0x1p-53;
    }
    // Any direction of length 1, all alike.
    Vec3 direction() {
        const double z = 1 - 2 * uniform(), angle = 2 * pi * uniform();
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

  private:
    // The finalizer of SplitMix64 (Steele, Lea, Flood 2014): every bit depends on every other.
    static std::uint64_t mix(std::uint64_t x) {
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
        x = (x ^ x >> 27) * 0x94d049bb133111eb;
        return x ^ x >> 31;
    }
    std::uint64_t state_;
};

// ---- The scene, and its file ------------------------------------------------------------------

enum class Kind { matte, metal, glass };
struct Material {
    Kind kind = Kind::matte;
    Vec3 color{0.5, 0.5, 0.5};
    double fuzz = 0, index = 1;
};
struct Sphere {
    Vec3 center;
    double radius = 1;
    Material material;
};
struct Scene {
    int width = 400, height = 225, samples = 16, depth = 50;
    Vec3 from{0, 0, 5}, at, up{0, 1, 0};
    double fov_deg = 40, aperture = 0, focus = 1;
    Vec3 below{1, 1, 1}, above{0.5, 0.7, 1};
    std::vector<Sphere> spheres;
};

// What follows the first word of a line.
class Words {
  public:
    explicit Words(const std::string& text) : words_{text} {}
    std::string word() {
        std::string word;
        words_ >> word;
        return word;
    }
    double number(double least = -1e30, double most = 1e30) {
        double value = 0;
        if (!(words_ >> value)) throw std::invalid_argument("expected a number here");
        if (value < least || value > most)
            throw std::invalid_argument("expected a number from " + std::to_string(least) + " to " +
                                        std::to_string(most) +
                                        ", actual: " + std::to_string(value));
        return value;
    }
    int whole(int most) { return static_cast<int>(number(1, most)); }
    Vec3 vector(double least = -1e30, double most = 1e30) {
        const double x = number(least, most), y = number(least, most);
        return {x, y, number(least, most)};
    }

  private:
    std::istringstream words_;
};

void read_line(Words& words, Scene& scene, Material& material) {
    const std::string word = words.word();
    if (word == "picture") {
        scene.width = words.whole(8192);
        scene.height = words.whole(8192);
        scene.samples = words.whole(1'000'000);
        scene.depth = words.whole(10'000);
    } else if (word == "camera") {
        scene.from = words.vector();
        scene.at = words.vector();
        scene.up = words.vector();
        scene.fov_deg = words.number(0.001, 179);
        scene.aperture = words.number(0);
        scene.focus = words.number(0);
        if (!(length(cross(scene.at - scene.from, scene.up)) > 0 && scene.focus > 0))
            throw std::invalid_argument("expected a direction that is not up, and a focus above 0");
    } else if (word == "sky") {
        scene.below = words.vector(0, 1);
        scene.above = words.vector(0, 1);
    } else if (word == "matte") {
        material = {Kind::matte, words.vector(0, 1)};
    } else if (word == "metal") {
        material = {Kind::metal, words.vector(0, 1)};
        material.fuzz = words.number(0, 1);
    } else if (word == "glass") {
        material = {Kind::glass, {1, 1, 1}, 0, words.number(0.1, 10)};
    } else if (word == "sphere") {
        scene.spheres.push_back({words.vector(), words.number(0), material});
        if (scene.spheres.back().radius == 0)
            throw std::invalid_argument("expected a radius above 0");
    } else if (!word.empty()) {
        throw std::invalid_argument(
            "expected picture, camera, sky, matte, metal, glass or sphere, actual: " + word);
    }
    if (const std::string more = words.word(); !more.empty())
        throw std::invalid_argument("expected the end of the line, actual: " + more);
}

Scene read_scene(const std::string& path) {
    std::ifstream file{path};
    if (!file) throw std::invalid_argument(path + ": cannot be read");
    Scene scene;
    Material material;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) try {
            Words words{line.substr(0, line.find('#'))};
            read_line(words, scene, material);
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(path + ":" + std::to_string(number) + ": " + error.what());
        }
    return scene;
}

// ---- One ray and one sphere -------------------------------------------------------------------

// A ray that leaves a surface knows which: its own sphere it meets at t = 0, exactly, and in at
// most one other place. So no tolerance is needed to leave it, near or far, large or small.
struct Ray {
    Vec3 origin, direction;  // of length 1
    int leaves = -1;         // the number of the sphere that it starts on
};
struct Hit {
    double t = infinity;
    int sphere = -1;
};

void try_sphere(const std::vector<Sphere>& spheres, int number, const Ray& ray, Hit& nearest) {
    const Sphere& sphere = spheres[number];
    const Vec3 to_center = sphere.center - ray.origin;
    const double middle = dot(to_center, ray.direction);
    double t = 2 * middle;  // where it leaves the sphere that it starts on, if it goes inside
    if (number != ray.leaves) {
        // The distance from the line to the center first: its error does not grow with the
        // distance.
        const Vec3 offset = to_center - middle * ray.direction;
        const double r = sphere.radius, squared = dot(offset, offset);
        if (squared > r * r) return;
        const double distance = length(to_center);
        const double far_root = middle + std::copysign(std::sqrt(r * r - squared), middle);
        const double other = (distance - r) * (distance + r) / far_root;
        t = std::min(far_root, other) > 0 ? std::min(far_root, other) : std::max(far_root, other);
    }
    if (!(t > 0)) return;
    // Of equally near ones the highest number, in whatever order they come.
    if (t < nearest.t || (t == nearest.t && number > nearest.sphere)) nearest = {t, number};
}

// ---- A tree of boxes --------------------------------------------------------------------------

struct Box {
    Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    void add(const Box& box) {
        low = {std::min(low.x, box.low.x), std::min(low.y, box.low.y), std::min(low.z, box.low.z)};
        high = {std::max(high.x, box.high.x), std::max(high.y, box.high.y),
                std::max(high.z, box.high.z)};
    }
    // Where the ray enters; infinity if it does not, or only behind `end`. The bounds are widened
    // by what rounding may have done to them, so that a sphere that just touches its box is not
    // lost.
    double enter(Vec3 origin, const std::array<double, 3>& inverse, double end) const {
        double first = 0, last = end;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (low[axis] - origin[axis]) * inverse[axis];
            const double b = (high[axis] - origin[axis]) * inverse[axis];
            // fmax and fmin pass over the not-a-number of a ray that runs in the box's side.
            first = std::fmax(first, std::fmin(a, b));
            last = std::fmin(last, std::fmax(a, b));
        }
        return first <= last * (1 + 1e-14) ? first : infinity;
    }
};

Box box_of(const Sphere& sphere) {
    const Vec3 c = sphere.center;
    const double reach = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
    const double r = sphere.radius * (1 + 1e-14) + reach * 1e-15;
    return {c - Vec3{r, r, r}, c + Vec3{r, r, r}};
}

class Tree {
  public:
    explicit Tree(const std::vector<Sphere>& spheres) : spheres_{spheres} {
        for (int i = 0; i < static_cast<int>(spheres.size()); ++i) order_.push_back(i);
        if (!order_.empty()) build(0, order_.size());
    }

    Hit nearest(const Ray& ray) const {
        Hit hit;
        if (nodes_.empty()) return hit;
        const Vec3 d = ray.direction;
        const std::array<double, 3> inverse{1 / d.x, 1 / d.y, 1 / d.z};
        search(0, ray, inverse, hit);
        return hit;
    }

  private:
    struct Node {
        Box box;
        int first = 0, count = 0;  // of a leaf: places in order_
        int right = 0;             // of others: the left child is the next node
    };

    // Sorts along the longest axis of the middles, and cuts in half.
    int build(int first, int count) {
        const int index = nodes_.size();
        nodes_.push_back({{}, first, count, 0});
        Box box, middles;
        for (int i = first; i < first + count; ++i) {
            box.add(box_of(spheres_[order_[i]]));
            middles.add({spheres_[order_[i]].center, spheres_[order_[i]].center});
        }
        nodes_[index].box = box;
        if (count <= 2) return index;
        const Vec3 size = middles.high - middles.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto begin = order_.begin() + first;
        std::nth_element(begin, begin + count / 2, begin + count, [&](int a, int b) {
            return spheres_[a].center[axis] < spheres_[b].center[axis];
        });
        nodes_[index].count = 0;
        build(first, count / 2);
        nodes_[index].right = build(first + count / 2, count - count / 2);
        return index;
    }

    void search(int index, const Ray& ray, const std::array<double, 3>& inverse, Hit& hit) const {
        const Node& node = nodes_[index];
        for (int i = node.first; i < node.first + node.count; ++i)
            try_sphere(spheres_, order_[i], ray, hit);
        if (node.count > 0) return;
        const int children[]{index + 1, node.right};
        const double enters[]{enter(children[0], ray, inverse, hit.t),
                              enter(children[1], ray, inverse, hit.t)};
        const int near = enters[1] < enters[0] ? 1 : 0;
        if (enters[near] < infinity) search(children[near], ray, inverse, hit);
        if (enters[1 - near] <= hit.t && enters[1 - near] < infinity)
            search(children[1 - near], ray, inverse, hit);
    }
    double enter(int index, const Ray& ray, const std::array<double, 3>& inverse,
                 double end) const {
        return nodes_[index].box.enter(ray.origin, inverse, end);
    }

    const std::vector<Sphere>& spheres_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

Hit nearest_of_all(const std::vector<Sphere>& spheres, const Ray& ray) {
    Hit hit;
    for (std::size_t i = 0; i < spheres.size(); ++i)
        try_sphere(spheres, static_cast<int>(i), ray, hit);
    return hit;
}

// ---- Three materials --------------------------------------------------------------------------

Vec3 reflect(Vec3 d, Vec3 normal) {
    return d - 2 * dot(d, normal) * normal;
}

// The share of light that glass reflects (Fresnel, both polarizations), by the cosines on both
// sides; eta is the index on this side divided by that on the other.
double reflectance(double cosine, double inner_cosine, double eta) {
    const double s = (eta * cosine - inner_cosine) / (eta * cosine + inner_cosine);
    const double p = (eta * inner_cosine - cosine) / (eta * inner_cosine + cosine);
    return (s * s + p * p) / 2;
}

// Where light goes on that arrives along d; `outward` is the sphere's normal.
Vec3 scatter(const Material& material, Vec3 d, Vec3 outward, Random& random) {
    const bool outside = dot(d, outward) < 0;
    const Vec3 normal = outside ? outward : -1 * outward;
    if (material.kind == Kind::matte) {
        // The unit sphere that touches the surface: cosine-weighted. Nearly never, but sometimes,
        // both cancel.
        const Vec3 sum = normal + random.direction();
        return length(sum) > 1e-8 ? unit(sum) : normal;
    }
    if (material.kind == Kind::metal) {
        const Vec3 strayed = reflect(d, normal) + material.fuzz * random.direction();
        const double below = std::min(0.0, dot(strayed, normal));
        const Vec3 folded = strayed - 2 * below * normal;  // no light is lost below the surface
        return length(folded) > 1e-8 ? unit(folded) : normal;
    }
    const double eta = outside ? 1 / material.index : material.index;
    const double cosine = std::min(1.0, -dot(d, normal));
    const double squared = 1 - eta * eta * (1 - cosine * cosine);
    if (squared <= 0) return unit(reflect(d, normal));  // total reflection
    const double inner = std::sqrt(squared);
    if (random.uniform() < reflectance(cosine, inner, eta)) return unit(reflect(d, normal));
    return unit(eta * d + (eta * cosine - inner) * normal);
}

// ---- A path, a pixel, a picture ---------------------------------------------------------------

class Renderer {
  public:
    Renderer(const Scene& scene, std::uint64_t seed, bool list)
        : scene_{scene}, tree_{scene.spheres}, seed_{seed}, list_{list} {
        const Vec3 w = unit(scene.from - scene.at);
        u_ = unit(cross(scene.up, w));
        v_ = cross(w, u_);
        const double height = 2 * std::tan(scene.fov_deg * pi / 360) * scene.focus;
        pixel_ = height / scene.height;
        corner_ = -scene.focus * w - scene.width * pixel_ / 2 * u_ + height / 2 * v_;
    }

    Vec3 pixel(int x, int y) const {
        Vec3 sum;
        const auto number =
            static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(scene_.width) +
            static_cast<std::uint64_t>(x);
        for (int sample = 0; sample < scene_.samples; ++sample) {
            Random random{seed_, number, static_cast<std::uint64_t>(sample)};
            const double across = (x + random.uniform()) * pixel_;
            const double down = (y + random.uniform()) * pixel_;
            const double r = scene_.aperture / 2 * std::sqrt(random.uniform());
            const double angle = 2 * pi * random.uniform();
            const Vec3 lens = r * std::cos(angle) * u_ + r * std::sin(angle) * v_;
            const Vec3 target = corner_ + across * u_ - down * v_;
            sum = sum + light({scene_.from + lens, unit(target - lens)}, random);
        }
        return 1.0 / scene_.samples * sum;
    }

  private:
    // The light that comes back along a ray. A path that has bounced `depth` times brings none.
    Vec3 light(Ray ray, Random& random) const {
        Vec3 throughput{1, 1, 1};
        for (int bounce = 0; bounce <= scene_.depth; ++bounce) {
            const Hit hit = list_ ? nearest_of_all(scene_.spheres, ray) : tree_.nearest(ray);
            if (hit.sphere < 0) {
                const double up = (ray.direction.y + 1) / 2;
                return throughput * ((1 - up) * scene_.below + up * scene_.above);
            }
            const Sphere& sphere = scene_.spheres[hit.sphere];
            const Vec3 normal = unit(ray.origin + hit.t * ray.direction - sphere.center);
            const Vec3 direction = scatter(sphere.material, ray.direction, normal, random);
            throughput = throughput * sphere.material.color;
            ray = {sphere.center + sphere.radius * normal, direction, hit.sphere};
        }
        return {};
    }

    const Scene& scene_;
    Tree tree_;
    std::uint64_t seed_;
    bool list_;
    Vec3 u_, v_, corner_;
    double pixel_ = 0;
};

// All rows, by as many threads; whoever is free takes the next one.
std::vector<Vec3> render(const Scene& scene, const Renderer& renderer, int threads) {
    const auto width = scene.width;
    std::vector<Vec3> picture(width * scene.height);
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int y; (y = next++) < scene.height;)
            for (int x = 0; x < scene.width; ++x) picture[y * width + x] = renderer.pixel(x, y);
    };
    std::vector<std::jthread> workers;
    for (int i = 1; i < threads; ++i) workers.emplace_back(work);
    work();
    workers.clear();  // waits for them
    return picture;
}

unsigned char to_byte(double light) {
    const double c = std::clamp(light, 0.0, 1.0);
    const double srgb = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<unsigned char>(255 * srgb + 0.5);
}

void write_ppm(const std::string& path, const Scene& scene, const std::vector<Vec3>& picture) {
    std::ofstream file{path, std::ios::binary};
    file << "P6\n" << scene.width << ' ' << scene.height << "\n255\n";
    for (const Vec3& color : picture)
        for (int channel = 0; channel < 3; ++channel)
            file.put(static_cast<char>(to_byte(color[channel])));
    if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

void run(const std::vector<std::string>& words) {
    std::vector<std::string> files;
    int threads = std::max(1u, std::thread::hardware_concurrency()), seed = 1;
    bool list = false;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == "--list")
            list = true;
        else if (words[i] == "--threads" && i + 1 < words.size())
            threads = Words{words[++i]}.whole(1024);
        else if (words[i] == "--seed" && i + 1 < words.size())
            seed = Words{words[++i]}.whole(1'000'000'000);
        else
            files.push_back(words[i]);
    if (files.size() != 2 || files[0].starts_with("--") || files[1].starts_with("--"))
        throw std::invalid_argument(
            "usage: own SCENE PICTURE.ppm [--threads N] [--seed N] [--list]");
    const Scene scene = read_scene(files[0]);
    const Renderer renderer{scene, static_cast<std::uint64_t>(seed), list};
    write_ppm(files[1], scene, render(scene, renderer, threads));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return dynamic_cast<const std::invalid_argument*>(&error) ? 2 : 1;
    }
}
