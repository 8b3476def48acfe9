#include <stb_image.h>
#include <stb_image_write.h>
#include <unistd.h>

#include <app/signals.hpp>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <rt/image_file.hpp>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace rt {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> to_bytes(const Image& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels().size() * 3);
    for (const Color& c : image.pixels()) {
        if (!is_finite(c)) throw std::logic_error("a pixel's color is not finite: this is a bug");
        for (const Real channel : {c.r, c.g, c.b}) bytes.push_back(to_byte(channel));
    }
    return bytes;
}

[[noreturn]] void fail(int error) {
    throw std::system_error(error ? error : EIO, std::generic_category());
}

// mode "w" writes to what is there, "wx" to a new file only.
void write_to(const fs::path& path, const std::string& bytes, const char* mode) {
    std::FILE* const file = std::fopen(path.c_str(), mode);
    if (!file) fail(errno);
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int write_error = errno;
    errno = 0;
    // The last bytes are written on closing, so a full disk may show only here.
    const bool closed = std::fclose(file) == 0;
    if (!written) fail(write_error);
    if (!closed) fail(errno);
}

// The file that a path means: through links the one that they point to, there or not.
fs::path behind_links(fs::path path) {
    for (int links = 0; fs::is_symlink(fs::symlink_status(path)); ++links) {
        if (links == 40) fail(ELOOP);
        path = path.parent_path() / fs::read_symlink(path);
    }
    return path;
}

// The file that Ctrl-C and the like must not leave behind, while there is one.
std::atomic<const char*> unfinished = nullptr;

bool remove_unfinished(int) {
    if (const char* const path = unfinished) ::unlink(path);
    return false;
}

// While it lives, an interruption of the program removes the file before it takes effect.
class RemovedOnInterrupt {
  public:
    explicit RemovedOnInterrupt(const fs::path& path) { unfinished = path.c_str(); }
    ~RemovedOnInterrupt() { unfinished = nullptr; }

  private:
    app::OnSignal on_signal_{app::ending_signals, remove_unfinished};
};

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
    // The library is compiled with a reader that the tests need, too.
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

void replace_file(const fs::path& path, const std::string& bytes) {
    const fs::file_status status = fs::status(path);
    if (fs::exists(status) && !fs::is_regular_file(status)) return write_to(path, bytes, "w");

    const fs::path target = behind_links(path);
    // A name of its own, so that two programs that write the same image do not meet.
    const fs::path temporary =
        target.parent_path() / ("." + std::to_string(std::random_device{}()) + ".part");
    const RemovedOnInterrupt guard{temporary};
    try {
        write_to(temporary, bytes, "wx");
        if (fs::exists(status)) fs::permissions(temporary, status.permissions());
        fs::rename(temporary, target);
    } catch (const std::system_error&) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

}  // namespace rt
