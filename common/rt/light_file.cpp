#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <rt/light_file.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace rt {
namespace {

// The channels of all pixels, row by row from the top, limited to [least, most].
std::vector<float> to_floats(const Image& image, double least, double most) {
    std::vector<float> floats;
    floats.reserve(image.pixels().size() * 3);
    for (const Color& c : image.pixels()) {
        if (!is_finite(c)) throw std::logic_error("a pixel's color is not finite: this is a bug");
        for (const Real channel : {c.r, c.g, c.b})
            floats.push_back(
                static_cast<float>(std::clamp(static_cast<double>(channel), least, most)));
    }
    return floats;
}

// Takes a file apart from its beginning. Whatever is missing is an error.
class Bytes {
  public:
    explicit Bytes(const std::string& all) : all_{all} {}

    int next() {
        if (at_ == all_.size()) throw std::runtime_error("ends too early");
        return static_cast<unsigned char>(all_[at_++]);
    }

    // Up to the end of the line, which is not part of it.
    std::string line() {
        return until([](int c) { return c == '\n'; });
    }
    // Up to the next white space, which is not part of it.
    std::string word() {
        return until([](int c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; });
    }

    std::size_t left() const { return all_.size() - at_; }
    void back_to(std::size_t left) { at_ = all_.size() - left; }

  private:
    template <class IsEnd>
    std::string until(IsEnd is_end) {
        std::string text;
        for (int c; !is_end(c = next());) text += static_cast<char>(c);
        return text;
    }

    const std::string& all_;
    std::size_t at_ = 0;
};

struct Size {
    int width, height;
};

// `rest` is what must follow the two numbers.
Size checked_size(std::istringstream text, int most_pixels) {
    std::int64_t width = 0, height = 0;
    text.imbue(std::locale::classic());
    text >> width >> height;
    constexpr std::int64_t most_side = std::numeric_limits<int>::max();
    if (!text || width < 1 || height < 1)
        throw std::runtime_error("does not say its width and height");
    if (width > most_side || height > most_side || width > most_pixels / height)
        throw std::length_error("the image has too many pixels");
    return {static_cast<int>(width), static_cast<int>(height)};
}

// A pixel of a .hdr file: three channels, and their common exponent.
using Shared = std::array<int, 4>;

Color color_of(const Shared& pixel) {
    // The exponent is stored with 128 added, and a channel is a whole number of 256ths.
    const auto channel = [&](int byte) {
        if (pixel[3] == 0) return Real(0);
        const double light = std::ldexp(byte, pixel[3] - 128 - 8);
        if (light > brightest)
            throw std::runtime_error("has a pixel brighter than 1e9, which is too bright");
        return static_cast<Real>(light);
    };
    return {channel(pixel[0]), channel(pixel[1]), channel(pixel[2])};
}

Shared next_pixel(Bytes& bytes) {
    Shared pixel{};
    for (int& byte : pixel) byte = bytes.next();
    return pixel;
}

// A row of a .hdr file, channel by channel: a byte above 128 says how often the next byte is
// repeated, and any other how many bytes follow as they are.
void read_runs(Bytes& bytes, std::vector<Shared>& row) {
    for (std::size_t channel = 0; channel < 4; ++channel)
        for (std::size_t x = 0; x < row.size();) {
            const int head = bytes.next();
            const bool repeats = head > 128;
            const auto count = static_cast<std::size_t>(repeats ? head - 128 : head);
            if (count == 0 || count > row.size() - x)
                throw std::runtime_error("has a row that is longer or shorter than the picture");
            const int repeated = repeats ? bytes.next() : 0;
            for (std::size_t i = 0; i < count; ++i)
                row[x++][channel] = repeats ? repeated : bytes.next();
        }
}

void read_row(Bytes& bytes, std::vector<Shared>& row) {
    const std::size_t start = bytes.left();
    Shared first = next_pixel(bytes);
    const auto marked_width = static_cast<std::size_t>(first[2] * 256 + first[3]);
    if (first[0] == 2 && first[1] == 2 && marked_width == row.size() && marked_width >= 8)
        return read_runs(bytes, row);
    bytes.back_to(start);
    for (Shared& pixel : row) {
        pixel = next_pixel(bytes);
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1 && pixel[3] > 0)
            throw std::runtime_error(
                "is compressed in the old way of Radiance; save it anew with another program");
    }
}

Image decode_hdr(const std::string& all, int most_pixels) {
    Bytes bytes{all};
    bytes.line();  // #?RADIANCE
    for (std::string line; !(line = bytes.line()).empty();)
        if (line.rfind("FORMAT=", 0) == 0 && line != "FORMAT=32-bit_rle_rgbe")
            throw std::runtime_error("has the " + line.substr(0, 40) +
                                     "; only 32-bit_rle_rgbe is read");
    std::istringstream words{bytes.line()};
    std::string height, down, width, right;
    words >> down >> height >> right >> width;
    if (down != "-Y" || right != "+X")
        throw std::runtime_error("does not have its rows from the top, left to right (-Y, +X)");
    const Size size = checked_size(std::istringstream{width + ' ' + height}, most_pixels);
    // Even a row of the fewest runs takes some bytes: so no short file claims much memory.
    if (bytes.left() < static_cast<std::size_t>(size.height) * 4)
        throw std::runtime_error("ends too early");
    Image image{size.width, size.height};
    std::vector<Shared> row(static_cast<std::size_t>(size.width));
    for (int y = 0; y < size.height; ++y) {
        read_row(bytes, row);
        for (int x = 0; x < size.width; ++x)
            image.at(x, y) = color_of(row[static_cast<std::size_t>(x)]);
    }
    return image;
}

Image decode_pfm(const std::string& all, int most_pixels) {
    Bytes bytes{all};
    const int channels = bytes.word() == "PF" ? 3 : 1;
    const std::string width = bytes.word(), height = bytes.word();
    const Size size = checked_size(std::istringstream{width + ' ' + height}, most_pixels);
    std::istringstream text{bytes.word()};
    text.imbue(std::locale::classic());
    double scale = 0;
    text >> scale;
    if (!text || !std::isfinite(scale) || scale == 0)
        throw std::runtime_error("must have a scale that is not 0, such as -1.0");
    const bool low_byte_first = scale < 0;
    if (bytes.left() < std::size_t{4} * static_cast<std::size_t>(channels) *
                           static_cast<std::size_t>(size.width) *
                           static_cast<std::size_t>(size.height))
        throw std::runtime_error("ends too early");
    const auto next_light = [&] {
        std::uint32_t bits = 0;
        for (int i = 0; i < 4; ++i)
            bits |= static_cast<std::uint32_t>(bytes.next()) << 8 * (low_byte_first ? i : 3 - i);
        const double light = std::abs(scale) * static_cast<double>(std::bit_cast<float>(bits));
        if (std::isnan(light)) throw std::runtime_error("has a NaN for a pixel");
        if (light < 0) throw std::runtime_error("has a pixel with less light than 0");
        if (std::isinf(light)) throw std::runtime_error("has an infinitely bright pixel");
        if (light > brightest)
            throw std::runtime_error("has a pixel brighter than 1e9, which is too bright");
        return static_cast<Real>(light);
    };
    Image image{size.width, size.height};
    for (int y = size.height - 1; y >= 0; --y)
        for (int x = 0; x < size.width; ++x) {
            const Real red = next_light();
            const Real green = channels == 3 ? next_light() : red;
            image.at(x, y) = {red, green, channels == 3 ? next_light() : red};
        }
    return image;
}

}  // namespace

std::string encode_hdr(const Image& image) {
    constexpr double most = 0x1.FEp126;  // 255 / 256 of 2^127
    const std::vector<float> floats = to_floats(image, 0, most);
    std::string file;
    const auto append = [](void* out, void* data, int size) {
        static_cast<std::string*>(out)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
    };
    if (!stbi_write_hdr_to_func(append, &file, image.width(), image.height(), 3, floats.data()))
        throw std::runtime_error("the image could not be encoded as .hdr");
    return file;
}

std::string encode_pfm(const Image& image) {
    constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
    const std::vector<float> floats = to_floats(image, -most, most);
    // The minus sign says that the lowest byte of a number comes first.
    std::string file =
        "PF\n" + std::to_string(image.width()) + ' ' + std::to_string(image.height()) + "\n-1.0\n";
    file.reserve(file.size() + 4 * floats.size());
    const auto row = static_cast<std::size_t>(image.width()) * 3;
    for (std::size_t end = floats.size(); end > 0; end -= row)
        for (std::size_t i = end - row; i < end; ++i) {
            const auto bits = std::bit_cast<std::uint32_t>(floats[i]);
            for (int shift = 0; shift < 32; shift += 8)
                file += static_cast<char>(bits >> shift & 255);
        }
    return file;
}

Image decode_light(const std::string& bytes, int most_pixels) {
    if (bytes.rfind("#?RADIANCE\n", 0) == 0 || bytes.rfind("#?RGBE\n", 0) == 0)
        return decode_hdr(bytes, most_pixels);
    if (bytes.rfind("PF\n", 0) == 0 || bytes.rfind("Pf\n", 0) == 0)
        return decode_pfm(bytes, most_pixels);
    throw std::runtime_error("is neither a .hdr nor a .pfm file");
}

}  // namespace rt
