// A path tracer in one file: spheres and triangles of matte, metal and glass under a sky, seen
// through a lens.
// own SCENE PICTURE.ppm [--threads N] [--seed N] [--list]

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

constexpr double infinity = std::numeric_limits<double>::infinity(), pi = 3.14159265358979323846;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

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
struct Triangle {
    Vec3 a, b, c;
    Material material;
};
struct Scene {
    int width = 400, height = 225, samples = 16, depth = 50;
    Vec3 from{0, 0, 5}, at, up{0, 1, 0};  // the camera
    double fov_deg = 40, aperture = 0, focus = 1;
    Vec3 below{1, 1, 1}, above{0.5, 0.7, 1};  // the sky
    std::vector<Sphere> spheres;
    std::vector<Triangle> triangles;
};

void expect(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("expected " + what);
}

std::istream& operator>>(std::istream& in, Vec3& v) {
    return in >> v.x >> v.y >> v.z;
}

// Twice the triangle's area, as a vector to the side from which a, b, c run counterclockwise.
Vec3 area(const Triangle& triangle) {
    return cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

void add_triangle(Scene& scene, const Triangle& triangle) {
    if (length(area(triangle)) > 0) scene.triangles.push_back(triangle);
}

// The polygons of an OBJ file, each cut into triangles from its first corner.
void read_mesh(const std::filesystem::path& path, const Material& material, Scene& scene) {
    std::ifstream file{path};
    expect(file.is_open(), "an OBJ file, but cannot read " + path.string());
    std::vector<Vec3> points;
    for (std::string line, word; std::getline(file, line);) {
        std::istringstream in{line.substr(0, line.find('#'))};
        if (!(in >> word) || (word != "v" && word != "f")) continue;
        if (word == "v") {
            in >> points.emplace_back();
            expect(!in.fail(), "three numbers in " + path.string() + ": " + line);
            continue;
        }
        std::vector<Vec3> corners;
        while (in >> word) {
            std::istringstream number{word.substr(0, word.find('/'))};
            const int count = static_cast<int>(points.size());
            int point = 0;
            number >> point;
            if (point < 0) point += count + 1;  // -1 is the last one so far
            expect(number.eof() && 0 < point && point <= count,
                   "the number of a point, not " + word);
            corners.push_back(points[point - 1]);
        }
        expect(corners.size() > 2, "three corners or more in " + path.string() + ": " + line);
        for (std::size_t i = 2; i < corners.size(); ++i)
            add_triangle(scene, {corners[0], corners[i - 1], corners[i], material});
    }
}

// `folder` is the folder that contains the files that the line names.
void read_line(const std::string& line, const std::filesystem::path& folder, Scene& scene,
               Material& material) {
    std::istringstream in{line};
    std::string word, mesh, more;
    if (!(in >> word)) return;
    // Some standard libraries also read inf, nan and hexadecimal numbers.
    const std::string numbers = line.substr(line.find(word) + word.size());
    expect(word == "mesh" || numbers.find_first_not_of("0123456789+-.eE \t\r") == numbers.npos,
           "decimal numbers after " + word);
    Sphere sphere{{}, 1, {}};
    Triangle triangle;
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
    else if (word == "triangle")
        in >> triangle.a >> triangle.b >> triangle.c;
    else if (word == "mesh")
        in >> mesh;
    else
        expect(false, "a word that the task has, not " + word);
    expect(!in.fail() && !(in >> more), "the right numbers after " + word);
    const auto [least, most] = std::minmax({scene.width, scene.height, scene.samples, scene.depth});
    expect(least > 0 && most <= 10'000, "picture numbers from 1 to 10000");
    expect(length(cross(scene.at - scene.from, scene.up)) > 0, "an up vector not along the view");
    expect(0 < scene.fov_deg && scene.fov_deg < 180, "a field of view between 0 and 180");
    expect(scene.aperture >= 0 && scene.focus > 0, "an aperture from 0, a focus above 0");
    for (const Vec3 c : {scene.below, scene.above, material.color})
        expect(std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1, "color in [0, 1]");
    expect(0 <= material.fuzz && material.fuzz <= 1, "a fuzz from 0 to 1");
    expect(material.index > 0 && sphere.radius > 0, "an index or radius greater than 0");
    if (word == "sphere") scene.spheres.push_back({sphere.center, sphere.radius, material});
    if (word == "triangle") add_triangle(scene, {triangle.a, triangle.b, triangle.c, material});
    if (word == "mesh") read_mesh(folder / mesh, material, scene);
}

Scene read_scene(const std::string& path) {
    std::ifstream file{path};
    expect(file.is_open(), "a scene file, but cannot read " + path);
    Scene scene;
    Material material;
    int number = 1;
    try {
        for (std::string line; std::getline(file, line); ++number)
            read_line(line.substr(0, line.find('#')), std::filesystem::path{path}.parent_path(),
                      scene, material);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(path + ":" + std::to_string(number) + ": " + error.what());
    }
    return scene;
}

// A ray that leaves a sphere knows which one. It meets that sphere exactly at t = 0, and at most at
// one other point. So it needs no tolerance to leave the sphere, near or far, large or small. A ray
// that leaves a triangle never meets that triangle again. Triangles are numbered after the spheres.
struct Ray {
    Vec3 origin, direction;  // of length 1
    int leaves = -1;         // the number of the surface that it starts on
};
struct Hit {
    double t = infinity;
    int surface = -1;
};

// Of equally near surfaces the one with the highest number counts, whatever their order.
void keep_nearest(Hit& nearest, double t, int number) {
    if (t > 0 && (t < nearest.t || (t == nearest.t && number > nearest.surface)))
        nearest = {t, number};
}

void try_sphere(const std::vector<Sphere>& spheres, int number, const Ray& ray, Hit& nearest) {
    const Sphere& sphere = spheres[number];
    const Vec3 to_center = sphere.center - ray.origin;
    const double middle = dot(to_center, ray.direction);
    double t = 2 * middle;  // where the ray leaves the sphere that it starts on, if it goes inside
    if (number != ray.leaves) {
        // From the line to the center: this error grows with the distance, not with its square.
        const Vec3 offset = to_center - middle * ray.direction;
        const double r = sphere.radius, under_root = r * r - dot(offset, offset);
        if (under_root < 0) return;
        const double distance = length(to_center);
        const double a = middle + std::copysign(std::sqrt(under_root), middle);
        const double b = (distance - r) * (distance + r) / a;
        t = std::min(a, b) > 0 ? std::min(a, b) : std::max(a, b);
    }
    keep_nearest(nearest, t, number);
}

// a b - c d with the right sign (Kahan): each product is rounded once, and its error is added.
double difference(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

// The watertight test of Woop, Benthin and Wald (2013). Space is sheared so that the ray runs along
// an axis. Then the sign of an area says on which side of an edge the ray is. The two triangles of
// an edge compute it from the same numbers, so no ray slips between them.
void try_triangle(const Triangle& triangle, int number, const Ray& ray, Hit& nearest) {
    if (number == ray.leaves) return;
    const Vec3 d = ray.direction, size{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    const int z = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    const auto seen = [&](Vec3 corner) {
        const Vec3 p = corner - ray.origin;
        return Vec3{p[x] - d[x] / d[z] * p[z], p[y] - d[y] / d[z] * p[z], p[z] / d[z]};
    };
    const Vec3 a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
    const double u = difference(b.x, c.y, b.y, c.x), v = difference(c.x, a.y, c.y, a.x),
                 w = difference(a.x, b.y, a.y, b.x);
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return;  // beside it
    if (u + v + w == 0) return;                                      // it is seen edge-on
    const double t = (u * a.z + v * b.z + w * c.z) / (u + v + w);
    keep_nearest(nearest, t, number);
}

struct Box {
    Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    void add(const Box& b) {
        low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
        high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
    }
    // True if the ray enters before `end`. If a ray runs within a side of the box, max and min
    // ignore the resulting NaN, because it is their second argument.
    bool meets(const Ray& ray, Vec3 inverse, double end) const {
        double first = 0, last = end;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (low[axis] - ray.origin[axis]) * inverse[axis];
            const double b = (high[axis] - ray.origin[axis]) * inverse[axis];
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
        }
        return first <= last * (1 + 4 * epsilon);
    }
};

// Wider than the sphere by more than any rounding error, so that no ray hits the sphere and misses
// its box.
Box box_of(const Sphere& sphere) {
    const Vec3 c = sphere.center;
    const double r = sphere.radius + 8 * epsilon * (sphere.radius + length(c));
    return {c - Vec3{r, r, r}, c + Vec3{r, r, r}};
}
Box box_of(const Triangle& triangle) {
    Box box;
    for (const Vec3 p : {triangle.a, triangle.b, triangle.c}) {
        const double r = 64 * epsilon * length(p);
        box.add({p - Vec3{r, r, r}, p + Vec3{r, r, r}});
    }
    return box;
}

class Tree {
  public:
    // A list is a tree with a single leaf.
    Tree(const Scene& scene, bool list)
        : spheres_{scene.spheres},
          triangles_{scene.triangles},
          order_(spheres_.size() + triangles_.size()) {
        const int count = static_cast<int>(order_.size());
        std::iota(order_.begin(), order_.end(), 0);
        build(0, count, list ? count : 2);
    }
    Hit nearest(const Ray& ray) const {
        const Vec3 d = ray.direction;
        Hit hit;
        search(0, ray, {1 / d.x, 1 / d.y, 1 / d.z}, hit);
        return hit;
    }

  private:
    struct Node {
        Box box;
        int first, count;  // its surfaces: indices into order_
        int axis, right;   // the left child is the next node; right is 0 in a leaf
    };

    // The triangle of this number; null if it is a sphere's number.
    const Triangle* triangle(int number) const {
        const int spheres = static_cast<int>(spheres_.size());
        return number < spheres ? nullptr : &triangles_[number - spheres];
    }
    Vec3 middle(int number) const {
        const Triangle* const t = triangle(number);
        return t ? 1.0 / 3 * (t->a + t->b + t->c) : spheres_[number].center;
    }

    // Cuts in half along the longest side of the box.
    void build(int first, int count, int in_leaf) {
        const std::size_t index = nodes_.size();
        Box box;
        for (int i = first; i < first + count; ++i) {
            const Triangle* const t = triangle(order_[i]);
            box.add(t ? box_of(*t) : box_of(spheres_[order_[i]]));
        }
        const Vec3 size = box.high - box.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        nodes_.push_back({box, first, count, axis, 0});
        if (count <= in_leaf) return;
        const auto begin = order_.begin() + first;
        std::nth_element(begin, begin + count / 2, begin + count,
                         [&](int a, int b) { return middle(a)[axis] < middle(b)[axis]; });
        build(first, count / 2, in_leaf);
        nodes_[index].right = static_cast<int>(nodes_.size());
        build(first + count / 2, count - count / 2, in_leaf);
    }

    void search(int index, const Ray& ray, Vec3 inverse, Hit& hit) const {
        const Node& node = nodes_[index];
        if (!node.box.meets(ray, inverse, hit.t)) return;
        if (node.right == 0) {
            for (int i = node.first; i < node.first + node.count; ++i)
                if (const Triangle* const t = triangle(order_[i]))
                    try_triangle(*t, order_[i], ray, hit);
                else
                    try_sphere(spheres_, order_[i], ray, hit);
            return;
        }
        const bool left_first = ray.direction[node.axis] > 0;
        search(left_first ? index + 1 : node.right, ray, inverse, hit);
        search(left_first ? node.right : index + 1, ray, inverse, hit);
    }

    const std::vector<Sphere>& spheres_;
    const std::vector<Triangle>& triangles_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

// ---- Materials, paths, pixels

Vec3 reflect(Vec3 d, Vec3 normal) {
    return d - 2 * dot(d, normal) * normal;
}

// The share of light that glass reflects (Fresnel, the mean of both polarizations). The cosines are
// those on the two sides; eta is the index on this side divided by the index on the other.
double reflectance(double cosine, double inner, double eta) {
#ifdef SCHLICK  // see accuracy.md
    const double r = (1 - eta) / (1 + eta), beside = 1 - (eta > 1 ? inner : cosine);
    return r * r + (1 - r * r) * std::pow(beside, 5);
#endif
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

// Where a path bounces; the normal points outward.
struct Surface {
    Vec3 point, normal;
    const Material& material;
};

class Renderer {
  public:
    Renderer(const Scene& scene, int seed, bool list)
        : scene_{scene},
          tree_{scene, list},
          seed_{seed},
          w_{unit(scene.from - scene.at)},
          u_{unit(cross(scene.up, w_))},
          v_{cross(w_, u_)},
          pixel_{2 * std::tan(scene.fov_deg * pi / 360) * scene.focus / scene.height} {}

    Vec3 pixel(int x, int y) const {
        Vec3 sum;
        for (int sample = 0; sample < scene_.samples; ++sample) {
            Random random(seed_, y * std::uint64_t{10'000} + x, sample);
            const double right = (x + random.uniform() - scene_.width / 2.0) * pixel_;
            const double up = (scene_.height / 2.0 - y - random.uniform()) * pixel_;
            const double r = scene_.aperture / 2 * std::sqrt(random.uniform());
            const double angle = 2 * pi * random.uniform();
            const Vec3 lens = r * std::cos(angle) * u_ + r * std::sin(angle) * v_;
            const Vec3 target = right * u_ + up * v_ - scene_.focus * w_;
            sum = sum + light({scene_.from + lens, unit(target - lens)}, random);
        }
        return 1.0 / scene_.samples * sum;
    }

  private:
    Surface surface_at(const Ray& ray, const Hit& hit) const {
        const Vec3 point = ray.origin + hit.t * ray.direction;
        const std::size_t number = hit.surface, spheres = scene_.spheres.size();
        if (number >= spheres) {
            const Triangle& triangle = scene_.triangles[number - spheres];
            return {point, unit(area(triangle)), triangle.material};
        }
        const Sphere& sphere = scene_.spheres[number];
        const Vec3 normal = unit(point - sphere.center);
        return {sphere.center + sphere.radius * normal, normal, sphere.material};
    }

    // The light along a ray. A path that has bounced `depth` times and hits something brings none.
    Vec3 light(Ray ray, Random& random) const {
        Vec3 throughput{1, 1, 1};
        for (int bounce = 0; bounce <= scene_.depth; ++bounce) {
            const Hit hit = tree_.nearest(ray);
            if (hit.surface < 0) {
                const double up = (ray.direction.y + 1) / 2;
                return throughput * ((1 - up) * scene_.below + up * scene_.above);
            }
            const Surface surface = surface_at(ray, hit);
            const Vec3 next = scatter(surface.material, ray.direction, surface.normal, random);
            throughput = throughput * surface.material.color;
            ray = {surface.point, next, hit.surface};
        }
        return {};
    }

    const Scene& scene_;
    Tree tree_;
    int seed_;
    Vec3 w_, u_, v_;  // back, to the right, up
    double pixel_;    // its side, at the focus distance
};

// Renders all rows on this many threads; whichever thread is free takes the next row.
std::vector<Vec3> render(const Scene& scene, const Renderer& renderer, int threads) {
    const int width = scene.width, height = scene.height;
    std::vector<Vec3> picture(static_cast<std::size_t>(width) * height);
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int y = next++; y < height; y = next++)
            for (int x = 0; x < width; ++x) picture[y * width + x] = renderer.pixel(x, y);
    };
    std::vector<std::thread> others;
    for (int i = 1; i < std::min(threads, height); ++i) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
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
    int threads = static_cast<int>(std::thread::hardware_concurrency()), seed = 1;
    bool list = false;
    for (auto word = words.begin(); word != words.end(); ++word) {
        if (*word == "--list") {
            list = true;
        } else if (*word == "--threads" || *word == "--seed") {
            int& option = *word == "--seed" ? seed : threads;
            expect(word + 1 != words.end(), "a number after " + *word);
            std::istringstream in{*++word};
            expect(in >> option && in.eof() && option > 0, "a whole number, not " + *word);
        } else {
            files.push_back(*word);
        }
    }
    expect(files.size() == 2, "SCENE PICTURE.ppm [--threads N] [--seed N] [--list]");
    const Scene scene = read_scene(files[0]);
    write_ppm(files[1], scene, render(scene, {scene, seed, list}, threads));
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
