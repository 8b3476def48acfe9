// Threads: the same picture as one thread draws, and faster. With --no-timing only the first.
#include <app/cores.hpp>
#include <chrono>
#include <cstring>
#include <rt/counted.hpp>
#include <rt/image.hpp>
#include <rt/render_slices.hpp>
#include <rt/render_tiles.hpp>
#include <rt/sample_rng.hpp>
#include <thread>

#include "certificate.hpp"

namespace {

using namespace certify;

// Work like a renderer's: random numbers and roots. Some pixels take longer than others.
rt::Color pixel(int x, int y) {
    const int samples = 20 + (x * 7 + y * 3) % 60;
    return rt::average_samples(7, x, y, samples, [](int, rt::Rng& random) {
        Real sum = 0;
        for (int i = 0; i < 30; ++i) sum += std::sqrt(random.uniform());
        return rt::Color{sum / 30, sum / 60, sum / 90};
    });
}

template <class Render>
rt::Image image_by(const Render& render, int workers) {
    const rt::TileGrid grid{203, 119, 16};
    rt::Image image{grid.width, grid.height, {-1, -1, -1}};
    render(grid, workers, [&](const rt::Tile& tile, int) {
        for (int y = tile.top; y < tile.bottom; ++y)
            for (int x = tile.left; x < tile.right; ++x) image.at(x, y) = pixel(x, y);
    });
    return image;
}

template <class Render>
long different_pixels(const Render& render) {
    const rt::Image expected = rt::make_image(203, 119, [](int x, int y) { return pixel(x, y); });
    long different = 0;
    for (const int workers : {1, 2, 3, 7}) {
        const rt::Image image = image_by(render, workers);
        for (std::size_t i = 0; i < image.pixels().size(); ++i)
            different += !(image.pixels()[i] == expected.pixels()[i]);
    }
    return different;
}

void same_picture(Certificate& certificate) {
    certificate.at_most("06.2", "slices by 1, 2, 3 and 7 threads: pixels not bit for bit the same",
                        static_cast<double>(different_pixels(rt::render_slices)), 0, "");
    certificate.at_most("06.3", "tiles by 1, 2, 3 and 7 threads: pixels not bit for bit the same",
                        static_cast<double>(different_pixels(rt::render_tiles)), 0, "");
}

// Generators of neighboring samples and pixels must have nothing to do with each other.
void streams(Certificate& certificate) {
    constexpr int count = 20'000;
    const auto draw = [](int x, int y, int sample) {
        return static_cast<double>(rt::sample_rng(1, x, y, sample).uniform()) - 0.5;
    };
    // A pixel, the ones beside and below it, and the next sample: each compared with each.
    constexpr int steps[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double worst = 0;
    for (const auto& a : steps)
        for (const auto& b : steps) {
            if (&a == &b) break;
            double products = 0;
            for (int i = 0; i < count; ++i) {
                const int x = i % 200, y = i / 200;
                products += draw(x + a[0], y + a[1], a[2]) * draw(x + b[0], y + b[1], b[2]);
            }
            worst = std::max(worst, std::abs(12 * products / count));
        }
    // Six standard deviations.
    certificate.at_most("06.4", "correlation of neighboring streams", worst,
                        6 / std::sqrt(double(count)), "");
}

void speed_up(Certificate& certificate) {
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const int cores = app::physical_cores();
    const auto seconds = [](int workers) {
        const auto start = std::chrono::steady_clock::now();
        image_by(rt::render_tiles, workers);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    // The best of several pairs: what else the machine does can only slow a run down.
    double best = 0;
    for (int i = 0; i < 9; ++i) {
        const double alone = seconds(1);
        best = std::max(best, alone / seconds(threads));
    }
    const std::string what =
        "speed-up of " + rt::counted(threads, "thread") + " on " + rt::counted(cores, "core");
    if (threads == 1)  // there is nothing to gain
        certificate.shows("06.3", what.c_str(), best, "");
    else
        certificate.at_least("06.3", what.c_str(), best, 0.8 * cores, "");
}

}  // namespace

int main(int argc, char** argv) {
    const bool timing = argc < 2 || std::strcmp(argv[1], "--no-timing") != 0;
    return certify::certify(same_picture, streams, [&](Certificate& certificate) {
        if (timing) speed_up(certificate);
    });
}
