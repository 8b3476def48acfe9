// brick_wall --out FILE.ppm: draws a wall of boxes with hit_box alone, along parallel rays through
// whole numbers, where many run in the plane between two boxes. For a picture of
// docs/hard-cases.md.
#include <app/files.hpp>
#include <rt/canvas.hpp>
#include <rt/color.hpp>
#include <rt/hit_box.hpp>
#include <rt/image.hpp>
#include <rt/image_file.hpp>

int main(int, char** argv) {
    using namespace rt;
    constexpr int width = 120, height = 80, brick_width = 16, brick_height = 8;
    constexpr std::uint32_t colors[] = {0xa8452f, 0xb5533c, 0xc96a4a, 0xd08862};
    Image image = Canvas<Color>{width, height, from_hex(0x20283a)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3 eye{10, static_cast<Real>(y) + Real(0.5), static_cast<Real>(x)};
            const SlabRay ray = {eye, {-1, infinity, infinity}, 0};  // along (-1, 0, 0)
            const int row = y / brick_height, shift = row % 2 * brick_width / 2;
            for (int column = -1; column <= width / brick_width; ++column) {
                const Real left = static_cast<Real>(column * brick_width + shift);
                const Real top = static_cast<Real>(row * brick_height);
                const Box brick{{-1, top, left}, {0, top + brick_height, left + brick_width}};
                const Interval part = hit_box(brick, ray, Interval{0, infinity});
                if (part.min <= part.max)
                    image.at(x, y) = from_hex(colors[(row * row + 5 * column + 10) / 2 % 4]);
            }
        }
    app::replace_file(argv[2], encode_ppm(image));
}
