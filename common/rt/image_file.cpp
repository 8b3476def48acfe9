#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <climits>
#include <cstdint>
#include <memory>
#include <rt/image_file.hpp>
#include <stdexcept>
#include <vector>

namespace rt {
namespace {

std::vector<std::uint8_t> to_bytes(const Image& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels().size() * 3);
    for (const Color& c : image.pixels()) {
        if (!is_finite(c)) throw std::logic_error("a pixel's color is not finite: this is a bug");
        for (const Real channel : {c.r, c.g, c.b}) bytes.push_back(to_byte(channel));
    }
    return bytes;
}

}  // namespace

std::string encode_png(const Image& image) {
    const auto bytes = to_bytes(image);
    std::string png;
    const auto append = [](void* out, void* data, int size) {
        static_cast<std::string*>(out)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
    };
    if (!stbi_write_png_to_func(append, &png, image.width(), image.height(), 3, bytes.data(),
                                image.width() * 3))
        throw std::runtime_error("the image could not be encoded as PNG");
    return png;
}

std::string encode_ppm(const Image& image) {
    const auto bytes = to_bytes(image);
    return "P6\n" + std::to_string(image.width()) + ' ' + std::to_string(image.height()) +
           "\n255\n" + std::string(bytes.begin(), bytes.end());
}

Image decode_image(const std::string& bytes, int most_pixels) {
    // The library can also read PNM files, which only the tests need. Here, only PNG is accepted.
    const bool is_png = bytes.rfind("\x89PNG\r\n\x1a\n", 0) == 0;
    const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const auto size = static_cast<int>(std::min<std::size_t>(bytes.size(), INT_MAX));
    int width = 0, height = 0, channels = 0;
    if (!is_png || !stbi_info_from_memory(data, size, &width, &height, &channels) || width < 1 ||
        height < 1)
        throw std::runtime_error("no PNG image");
    if (std::int64_t{width} * height > most_pixels)
        throw std::length_error("the image has too many pixels");
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels{
        stbi_load_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free};
    if (!pixels) throw std::runtime_error("the image file is broken");
    return make_image(width, height, [&](int x, int y) {
        const stbi_uc* const p = pixels.get() + 3 * (std::ptrdiff_t{y} * width + x);
        const auto channel = [](stbi_uc byte) {
            return srgb_decode(static_cast<Real>(byte) / 255);
        };
        return Color{channel(p[0]), channel(p[1]), channel(p[2])};
    });
}

}  // namespace rt
