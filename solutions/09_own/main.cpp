// A path tracer in one file: spheres of matte, metal and glass under a sky, seen through a lens.
// own SCENE PICTURE.ppm [--threads N] [--seed N] [--list]

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), pi = 3.14159265358979323846;

// A point, a direction, or a color in linear light.
struct Vec3 {
    double x = 0, y = 0, z = 0;
    double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
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

// A stream of random numbers of its own for every sample of every pixel: the picture does not
// depend on which thread draws what.
struct Random {
    std::uint64_t state;
    Random(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample)
        : state{mix(mix(mix(seed) + pixel) + sample)} {}
    double uniform() {  // in [0, 1)
        state += 0x9e3779b97f4a7c15;
        return static_cast<double>(mix(state) >> 11) * 0x1p-53;
    }
    Vec3 direction() {  // of length 1, all alike
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
struct Camera {
    Vec3 from, at, up;
    double fov_deg, aperture, focus;
};
struct Scene {
    int width = 400, height = 225, samples = 16, depth = 50;
    Camera camera{{0, 0, 5}, {}, {0, 1, 0}, 40, 0, 1};
    Vec3 below{1, 1, 1}, above{0.5, 0.7, 1};
    std::vector<Sphere> spheres;
};

void expect(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("expected " + what);
}

// The words of a text, one after the other.
struct Words {
    std::istringstream text;
    std::string word() {
        std::string word;
        text >> word;
        return word;
    }
    double number(double least = -1e30, double most = 1e30) {
        double value = 0;
        text >> value;
        std::ostringstream range;
        range << "a number from " << least << " to " << most;
        expect(!text.fail() && least <= value && value <= most, range.str());
        return value;
    }
    int whole(int most) { return static_cast<int>(number(1, most)); }
    // Braces read from left to right.
    Vec3 point() { return {number(), number(), number()}; }
    Vec3 color() { return {number(0, 1), number(0, 1), number(0, 1)}; }
};

void read_line(Words& words, Scene& scene, Material& material) {
    const std::string word = words.word();
    if (word == "picture") {
        scene.width = words.whole(8192);
        scene.height = words.whole(8192);
        scene.samples = words.whole(1'000'000);
        scene.depth = words.whole(10'000);
    } else if (word == "camera") {
        const Camera camera{words.point(),           words.point(),   words.point(),
                            words.number(1e-6, 179), words.number(0), words.number(1e-30)};
        expect(length(cross(camera.at - camera.from, camera.up)) > 0, "an up beside the view");
        scene.camera = camera;
    } else if (word == "sky") {
        scene.below = words.color();
        scene.above = words.color();
    } else if (word == "matte") {
        material = {Kind::matte, words.color(), 0, 1};
    } else if (word == "metal") {
        material = {Kind::metal, words.color(), words.number(0, 1), 1};
    } else if (word == "glass") {
        material = {Kind::glass, {1, 1, 1}, 0, words.number(0.1, 10)};
    } else if (word == "sphere") {
        scene.spheres.push_back({words.point(), words.number(1e-30), material});
    } else {
        expect(word.empty(), "camera, glass, matte, metal, picture, sky or sphere, not " + word);
    }
    expect(words.word().empty(), "fewer words");
}

Scene read_scene(const std::string& path) {
    std::ifstream file{path};
    expect(file.is_open(), "a scene file, but cannot read " + path);
    Scene scene;
    Material material;
    int number = 1;
    try {
        for (std::string line; std::getline(file, line); ++number) {
            Words words{std::istringstream{line.substr(0, line.find('#'))}};
            read_line(words, scene, material);
        }
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(path + ":" + std::to_string(number) + ": " + error.what());
    }
    return scene;
}

// ---- One ray and one sphere

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
        // From the line to the center: this error does not grow with the distance.
        const Vec3 offset = to_center - middle * ray.direction;
        const double r = sphere.radius, under_root = r * r - dot(offset, offset);
        if (under_root < 0) return;
        const double distance = length(to_center);
        const double a = middle + std::copysign(std::sqrt(under_root), middle);
        const double b = (distance - r) * (distance + r) / a;
        t = std::min(a, b) > 0 ? std::min(a, b) : std::max(a, b);
    }
    // Of equally near ones the highest number, in whatever order they come.
    if (t > 0 && (t < nearest.t || (t == nearest.t && number > nearest.sphere)))
        nearest = {t, number};
}

// ---- A tree of boxes

struct Box {
    Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    void add(const Box& b) {
        low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
        high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
    }
    // Where the ray enters; infinity if it does not before `end`. fmax and fmin pass over the
    // not-a-number of a ray that runs in a side of the box.
    double enter(const Ray& ray, Vec3 inverse, double end) const {
        double first = 0, last = end;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (low[axis] - ray.origin[axis]) * inverse[axis];
            const double b = (high[axis] - ray.origin[axis]) * inverse[axis];
            first = std::fmax(first, std::fmin(a, b));
            last = std::fmin(last, std::fmax(a, b));
        }
        return first <= last * (1 + 1e-14) ? first : infinity;
    }
};

// Wider by what rounding may do, so that no sphere that touches its box is lost.
Box box_of(const Sphere& sphere) {
    const Vec3 c = sphere.center;
    const double r = sphere.radius * (1 + 1e-14) + 1e-15 * length(c);
    return {c - Vec3{r, r, r}, c + Vec3{r, r, r}};
}

class Tree {
  public:
    explicit Tree(const std::vector<Sphere>& spheres) : spheres_{spheres} {
        for (std::size_t i = 0; i < spheres.size(); ++i) order_.push_back(static_cast<int>(i));
        if (!order_.empty()) build(0, static_cast<int>(order_.size()));
    }
    void search(const Ray& ray, Hit& hit) const {
        const Vec3 d = ray.direction, inverse{1 / d.x, 1 / d.y, 1 / d.z};
        if (!nodes_.empty()) search(0, ray, inverse, hit);
    }

  private:
    struct Node {
        Box box;
        int first, count;  // of a leaf: places in order_
        int right;         // of others, where count is 0; the left child is the next node
    };

    // Cuts in half along the axis along which the centers lie farthest apart.
    int build(int first, int count) {
        const int index = static_cast<int>(nodes_.size());
        Box box, centers;
        for (int i = first; i < first + count; ++i) {
            const Sphere& sphere = spheres_[order_[i]];
            box.add(box_of(sphere));
            centers.add({sphere.center, sphere.center});
        }
        nodes_.push_back({box, first, count, 0});
        if (count <= 2) return index;
        const Vec3 size = centers.high - centers.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto begin = order_.begin() + first;
        std::nth_element(begin, begin + count / 2, begin + count, [&](int a, int b) {
            return spheres_[a].center[axis] < spheres_[b].center[axis];
        });
        build(first, count / 2);
        const int right = build(first + count / 2, count - count / 2);
        nodes_[index].count = 0;
        nodes_[index].right = right;
        return index;
    }

    void search(int index, const Ray& ray, Vec3 inverse, Hit& hit) const {
        const Node& node = nodes_[index];
        for (int i = node.first; i < node.first + node.count; ++i)
            try_sphere(spheres_, order_[i], ray, hit);
        if (node.count > 0) return;
        int near = index + 1, far = node.right;
        double to_near = nodes_[near].box.enter(ray, inverse, hit.t);
        double to_far = nodes_[far].box.enter(ray, inverse, hit.t);
        if (to_far < to_near) {
            std::swap(near, far);
            std::swap(to_near, to_far);
        }
        if (to_near < infinity) search(near, ray, inverse, hit);
        if (to_far < infinity && to_far <= hit.t) search(far, ray, inverse, hit);
    }

    const std::vector<Sphere>& spheres_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

// ---- Three materials

Vec3 reflect(Vec3 d, Vec3 normal) {
    return d - 2 * dot(d, normal) * normal;
}

// The share of light that glass reflects (Fresnel, the mean of both polarizations). The cosines are
// those on both sides; eta is the index on this side divided by that on the other.
double reflectance(double cosine, double inner, double eta) {
    const double s = (eta * cosine - inner) / (eta * cosine + inner);
    const double p = (eta * inner - cosine) / (eta * inner + cosine);
    return (s * s + p * p) / 2;
}

// Where light goes on that arrives along d; `outward` is the sphere's normal.
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
    // What strays below the surface is folded up: no light is lost.
    next = next - 2 * std::min(0.0, dot(next, normal)) * normal;
    return length(next) > 1e-8 ? unit(next) : normal;
}

// ---- A path, a pixel, a picture

class Renderer {
  public:
    Renderer(const Scene& scene, int seed, bool list)
        : scene_{scene}, tree_{scene.spheres}, seed_{seed}, list_{list} {
        const Camera& camera = scene.camera;
        const Vec3 w = unit(camera.from - camera.at);
        u_ = unit(cross(camera.up, w));
        v_ = cross(w, u_);
        pixel_ = 2 * std::tan(camera.fov_deg * pi / 360) * camera.focus / scene.height;
        corner_ = pixel_ / 2 * (scene.height * v_ - scene.width * u_) - camera.focus * w;
    }

    Vec3 pixel(int x, int y) const {
        Vec3 sum;
        for (int sample = 0; sample < scene_.samples; ++sample) {
            Random random(seed_, y * std::uint64_t{8192} + x, sample);
            const double across = (x + random.uniform()) * pixel_;
            const double down = (y + random.uniform()) * pixel_;
            const double r = scene_.camera.aperture / 2 * std::sqrt(random.uniform());
            const double angle = 2 * pi * random.uniform();
            const Vec3 lens = r * std::cos(angle) * u_ + r * std::sin(angle) * v_;
            const Vec3 target = corner_ + across * u_ - down * v_;
            sum = sum + light({scene_.camera.from + lens, unit(target - lens)}, random);
        }
        return 1.0 / scene_.samples * sum;
    }

  private:
    // The light that comes back along a ray. A path that has bounced `depth` times brings none.
    Vec3 light(Ray ray, Random& random) const {
        Vec3 throughput{1, 1, 1};
        for (int bounce = 0; bounce <= scene_.depth; ++bounce) {
            Hit hit;
            if (!list_) tree_.search(ray, hit);
            for (std::size_t i = 0; list_ && i < scene_.spheres.size(); ++i)
                try_sphere(scene_.spheres, static_cast<int>(i), ray, hit);
            if (hit.sphere < 0) {
                const double up = (ray.direction.y + 1) / 2;
                return throughput * ((1 - up) * scene_.below + up * scene_.above);
            }
            const Sphere& sphere = scene_.spheres[hit.sphere];
            const Vec3 normal = unit(ray.origin + hit.t * ray.direction - sphere.center);
            const Vec3 next = scatter(sphere.material, ray.direction, normal, random);
            throughput = throughput * sphere.material.color;
            ray = {sphere.center + sphere.radius * normal, next, hit.sphere};
        }
        return {};
    }

    const Scene& scene_;
    Tree tree_;
    int seed_;
    bool list_;
    Vec3 u_, v_, corner_;
    double pixel_ = 0;
};

// All rows, on as many threads; whichever is free takes the next one.
std::vector<Vec3> render(const Scene& scene, const Renderer& renderer, int threads) {
    const int width = scene.width, height = scene.height;
    std::vector<Vec3> picture(static_cast<std::size_t>(width) * height);
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int y = next++; y < height; y = next++)
            for (int x = 0; x < width; ++x) picture[y * width + x] = renderer.pixel(x, y);
    };
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    others.clear();  // waits for them
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

void run(const std::vector<std::string>& words) {
    std::vector<std::string> files;
    int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency())), seed = 1;
    bool list = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto number = [&](int most) {
            expect(i + 1 < words.size(), "a number behind " + words[i]);
            return Words{std::istringstream{words[++i]}}.whole(most);
        };
        if (words[i] == "--list") list = true;
        if (words[i] == "--threads")
            threads = number(1024);
        else if (words[i] == "--seed")
            seed = number(1'000'000'000);
        else if (words[i] != "--list")
            files.push_back(words[i]);
    }
    expect(files.size() == 2, "SCENE PICTURE.ppm [--threads N] [--seed N] [--list]");
    const Scene scene = read_scene(files[0]);
    write_ppm(files[1], scene, render(scene, {scene, seed, list}, threads));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return dynamic_cast<const std::logic_error*>(&error) ? 2 : 1;
    }
}
