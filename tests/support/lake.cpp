// lake --spp SAMPLES [--seed N] --out FILE.ppm: the final scene in nine slices, each as one step of
// the course draws it. It is docs/images/overview.png. A pixel takes so many samples.
#include <app/figure.hpp>
#include <app/files.hpp>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <rt/area_split.hpp>
#include <rt/canvas.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/image_file.hpp>
#include <rt/lit_path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/render_tiles.hpp>
#include <rt/sample_rng.hpp>
#include <thread>

#include "final_scene.hpp"

namespace {

using namespace rt;

constexpr int width = 800, height = 450, words_height = 54, depth = 16;
// Where the slices begin, at half the height, and how far each edge leans, in pixels.
constexpr std::array<int, 9> begins{0, 80, 160, 240, 302, 354, 408, 456, 506};
constexpr Real slant = 44, half_edge = 1;

constexpr std::array<std::uint32_t, 6> dusk{0x3f2f63, 0x8d6685, 0xf08a5d,
                                            0xf2d0a4, 0x7cc6b8, 0x2a8c9e};
Color dusk_color(std::size_t number) {
    return from_hex(dusk[number % dusk.size()]);
}

// The scene as chapter 05 sees it: through a pinhole, and nothing shines but the sky.
SceneDescription without_lens_and_lamps() {
    SceneDescription scene = effects::final_scene();
    scene.camera.lens = {};
    for (MaterialDescription& material : scene.materials)
        if (std::holds_alternative<Emitter>(material)) material = Lambertian{from_hex(0xffb454)};
    return scene;
}

// As chapter 04 sees it: all is matte. Each sphere has a material of its own, whose number says
// which sphere was hit.
SceneDescription all_matte() {
    SceneDescription scene = without_lens_and_lamps();
    std::vector<MaterialDescription> matte;
    for (SphereDescription& sphere : scene.spheres) {
        const auto& material = scene.materials[static_cast<std::size_t>(sphere.material)];
        Lambertian own{from_hex(0xd9dfe6)};
        if (const auto* given = std::get_if<Lambertian>(&material)) own = *given;
        if (const auto* metal = std::get_if<Metal>(&material)) own.albedo = metal->albedo;
        sphere.material = static_cast<int>(matte.size());
        matte.emplace_back(own);
    }
    scene.materials = std::move(matte);
    return scene;
}

SphereTree tree_of(const SceneDescription& scene) {
    std::vector<SceneSphere> spheres;
    for (const SphereDescription& sphere : scene.spheres)
        spheres.push_back({sphere.shape, sphere.material});
    return make_tree(spheres, AreaSplit{});
}

struct Lake {
    static constexpr Effects all{
        .fuzz = true, .glass = true, .lens = true, .lights = true, .instances = true};
    const SceneDescription matte_scene = all_matte(), dim_scene = without_lens_and_lamps(),
                           whole_scene = effects::final_scene();
    const ReadyScene<Effects{.instances = true}> matte{matte_scene, width, height};
    const ReadyScene<Effects{.fuzz = true, .glass = true, .instances = true}> dim{dim_scene, width,
                                                                                  height};
    const ReadyScene<all> whole{whole_scene, width, height};
    const SphereTree tree = tree_of(matte_scene);

    template <class Scene>
    Color path(const Scene& scene, const Ray& ray, Rng& random) const {
        return path_radiance(ray, scene.world, scene.materials, scene.sky, SkyEnding{}, depth,
                             random);
    }

    // The light, or the false color, of one sample in a slice.
    Color look(int slice, int x, int y, Vec2 offset, Rng& random) const {
        const Ray ray = make_ray(matte.camera, x, y, offset, random);
        const Vec3 way = normalize(ray.direction);
        const Color sky = matte.sky(ray.direction);
        const auto meets = [&] { return matte.world.hit(ray, Interval{0, infinity}); };
        switch (slice) {
            case 0:
                return sky;
            case 1: {
                // Squares of three degrees, or so.
                const int square =
                    static_cast<int>(std::floor(way.x * 20) + std::floor(way.y * 20));
                const Color color =
                    mix(from_hex(0x3f2f63), from_hex(0xf08a5d), (way.y + Real(0.42)) * Real(1.7));
                return square % 2 == 0 ? color : Real(0.72) * color;
            }
            case 2: {
                const auto hit = meets();
                return hit ? dusk_color(mix_bits(static_cast<std::uint64_t>(hit->material)) >> 8)
                           : sky;
            }
            case 3: {
                const auto hit = meets();
                if (!hit) return sky;
                const Color sideways =
                    mix(from_hex(0x3f2f63), from_hex(0xf08a5d), (1 + hit->normal.x) / 2);
                return mix(sideways, from_hex(0xa9dccf), std::max(Real(0), hit->normal.y));
            }
            case 4:
                return path(matte, ray, random);
            case 5:
                return path(dim, ray, random);
            case 6: {
                const int tile = y / 25 * (width / 25) + x / 25;
                return mix(path(dim, ray, random),
                           dusk_color(mix_bits(static_cast<std::uint64_t>(tile)) >> 8), Real(0.4));
            }
            case 7: {
                const Search search = tree.search(ray, {});
                const Real tests = static_cast<Real>(search.box_tests) / 110;
                const Real place = std::min(tests, Real(0.999)) * 4;
                constexpr std::array<std::uint32_t, 5> heat{0x14213d, 0x3f2f63, 0x8d6685, 0xf08a5d,
                                                            0xf7e3c1};
                const auto step = static_cast<std::size_t>(place);
                return mix(from_hex(heat[step]), from_hex(heat[step + 1]),
                           place - static_cast<Real>(step));
            }
            default: {
                const auto through = make_ray(whole.camera, x, y, offset, random);
                return lit_path_radiance(through, whole.world, whole.materials, whole.sky,
                                         whole.lights, whole.fog, SkyEnding{}, depth, random);
            }
        }
    }
};

}  // namespace

int main(int count, char** argv) {
    const Lake lake;
    const int samples = std::atoi(argv[2]);
    const std::uint64_t seed = count > 5 ? std::strtoull(argv[4], nullptr, 10) : 1;
    const Color night = from_hex(0x14172a);
    Image image = Canvas<Color>{width, height + words_height, night};
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    render_tiles({width, height, 16}, threads, [&](const Tile& tile, int) {
        for_each_pixel(tile, [&](int x, int y) {
            Rng places = pixel_rng(seed, x, y);
            int sample = 0;
            image.at(x, y) = pixel_average(samples, places, [&](Vec2 offset) {
                Rng random = sample_rng(seed, x, y, sample++);
                const Real down = (static_cast<Real>(y) + offset.y) / height - Real(0.5);
                const Real across = static_cast<Real>(x) + offset.x + slant * down;
                int slice = 0;
                bool between = false;
                for (std::size_t i = 1; i < begins.size(); ++i) {
                    const Real from_edge = across - static_cast<Real>(begins[i]);
                    if (from_edge > 0) slice = static_cast<int>(i);
                    between |= std::abs(from_edge) < half_edge;
                }
                return between ? night : lake.look(slice, x, y, offset, random);
            });
        });
    });

    constexpr std::array<std::array<const char*, 3>, begins.size()> words{
        {{"00", "a sky", ""},
         {"02", "a ray for", "each pixel"},
         {"03", "ray meets", "sphere"},
         {"04", "normals", ""},
         {"04", "matte", "paths"},
         {"05", "metal,", "glass"},
         {"06", "tiles of", "workers"},
         {"07", "box", "tests"},
         {"08", "lens and lamps", ""}}};
    app::Figure figure{image};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Real left = std::max(Real(6), static_cast<Real>(begins[i]) - slant / 2 + 5);
        figure.words({left, height + 8}, words[i][0], {9, from_hex(0xffb454)});
        figure.words({left, height + 23}, words[i][1], {8, from_hex(0xf4ead5)});
        figure.words({left, height + 37}, words[i][2], {8, from_hex(0xf4ead5)});
    }
    app::replace_file(argv[count - 1], encode_ppm(image));
}
