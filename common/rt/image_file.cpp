#include <stb_image_write.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
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
        if (!is_finite(c)) throw std::logic_error("a pixel's colour is not finite: this is a bug");
        for (const Real channel : {c.r, c.g, c.b}) bytes.push_back(to_byte(channel));
    }
    return bytes;
}

[[noreturn]] void fail(int error, const fs::path& path) {
    throw std::system_error(error, std::generic_category(), path.string());
}

void write_to(const fs::path& path, const std::string& bytes) {
    std::FILE* const file = std::fopen(path.string().c_str(), "wb");
    if (!file) fail(errno, path);
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int write_error = errno;
    // The last bytes are written on closing, so a full disk may show only here.
    const bool closed = std::fclose(file) == 0;
    if (!written) fail(write_error ? write_error : EIO, path);
    if (!closed) fail(errno, path);
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

void replace_file(const fs::path& path, const std::string& bytes) {
    const fs::file_status status = fs::status(path);
    if (fs::exists(status) && !fs::is_regular_file(status)) return write_to(path, bytes);

    // Through a link the file that it points to is replaced, not the link.
    const fs::path target = fs::exists(status) ? fs::canonical(path) : path;
    fs::path temporary = target;
    // A name of its own, so that two programs that write the same image do not meet.
    temporary += ".part" + std::to_string(std::random_device{}());
    try {
        write_to(temporary, bytes);
        fs::rename(temporary, target);
    } catch (const std::system_error&) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

}  // namespace rt
