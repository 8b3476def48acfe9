#include <app/errors.hpp>
#include <array>
#include <cctype>
#include <charconv>
#include <companion/compare/picture.hpp>
#include <companion/system/terminal.hpp>
#include <optional>
#include <rt/counted.hpp>

namespace companion {
namespace {

// The words of a .ppm file; a # starts a comment.
class PpmReader {
  public:
    explicit PpmReader(const std::string& text) : text_{text} {}

    // The next word; empty at the end.
    std::string word() {
        skip_space();
        const std::size_t start = place_;
        while (place_ < text_.size() && !is_space(text_[place_]) && text_[place_] != '#') ++place_;
        return text_.substr(start, place_ - start);
    }
    // The number in a word; none if it is no whole number in this range.
    static std::optional<long> number(const std::string& word, long low, long high) {
        long value = 0;
        const char* const end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        if (error != std::errc{} || stop != end || value < low || value > high) return {};
        return value;
    }
    int header(const char* what, long low, long high) {
        const std::string found = word();
        const std::optional<long> value = number(found, low, high);
        if (!value)
            throw app::Failure("the .ppm file has no " + std::string{what} + " from " +
                               std::to_string(low) + " to " + std::to_string(high) + ", but " +
                               quoted(found));
        return static_cast<int>(*value);
    }
    std::size_t place() const { return place_; }

    static std::string quoted(const std::string& word) {
        return word.empty() ? "ends there" : '\'' + printable(word, 40) + '\'';
    }

  private:
    static bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)); }

    void skip_space() {
        for (; place_ < text_.size(); ++place_) {
            if (text_[place_] == '#') place_ = std::min(text_.find('\n', place_), text_.size() - 1);
            if (!is_space(text_[place_])) return;
        }
    }

    const std::string& text_;
    std::size_t place_ = 2;
};

// The bytes of a P6 file, from the byte `start` on.
void read_bytes(const std::string& text, std::size_t start, std::size_t size, Picture& picture) {
    if (text.size() == start + size) {
        picture.bytes.assign(text.end() - static_cast<std::ptrdiff_t>(size), text.end());
        return;
    }
    // On Windows, a stream that is not binary writes 13 before each 10.
    std::size_t line_ends = 0;
    for (std::size_t at = text.find("\r\n"); at != text.npos; at = text.find("\r\n", at + 2))
        ++line_ends;
    throw app::Failure("the .ppm file has " + rt::counted(text.size(), "byte") + "; expected " +
                       std::to_string(start + size) +
                       (line_ends > 0 && text.size() > start + size
                            ? ". Has the stream added a byte 13 before each byte 10? Open the file "
                              "with std::ios::binary"
                            : ""));
}

// The numbers of a P3 file.
void read_numbers(PpmReader& reader, std::size_t size, Picture& picture) {
    for (std::size_t i = 0; i < size; ++i) {
        const std::string word = reader.word();
        const std::optional<long> value = PpmReader::number(word, 0, 255);
        if (!value) {
            const std::size_t pixel = i / 3, width = static_cast<std::size_t>(picture.width);
            const std::string where = "pixel (" + std::to_string(pixel % width) + ", " +
                                      std::to_string(pixel / width) + ") of the .ppm file: ";
            throw app::Failure(where + (word.empty() ? "the file ends before it"
                                                     : PpmReader::quoted(word) +
                                                           " is no whole number from 0 to 255: "
                                                           "NaN, or not clamped?"));
        }
        picture.bytes.push_back(static_cast<std::uint8_t>(*value));
    }
    if (const std::string more = reader.word(); !more.empty())
        throw app::Failure("the .ppm file goes on after its last pixel, with " +
                           PpmReader::quoted(more));
}

}  // namespace

Picture parse_ppm(const std::string& text) {
    const std::string kind = text.substr(0, 2);
    if (kind != "P3" && kind != "P6") throw app::Failure("a .ppm file starts with P3 or P6");
    PpmReader reader{text};
    Picture picture;
    picture.width = reader.header("width", 1, 65'536);
    picture.height = reader.header("height", 1, 65'536);
    reader.header("largest value", 255, 255);
    const auto size = static_cast<std::size_t>(picture.pixels()) * 3;
    // In P6, one white space follows.
    if (kind == "P6")
        read_bytes(text, reader.place() + 1, size, picture);
    else
        read_numbers(reader, size, picture);
    return picture;
}

double light_of(std::uint8_t byte) {
    static const auto table = [] {
        std::array<double, 256> light;
        for (int i = 0; i < 256; ++i)
            light[static_cast<std::size_t>(i)] =
                static_cast<double>(rt::srgb_decode(i / rt::Real(255)));
        return light;
    }();
    return table[byte];
}

rt::Image mean_of(const std::vector<Picture>& pictures) {
    const Picture& first = pictures.front();
    for (const Picture& picture : pictures)
        if (!same_size(picture, first)) throw app::Failure("a program's pictures differ in size");
    return rt::make_image(first.width, first.height, [&](int x, int y) {
        const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(first.width) +
                            static_cast<std::size_t>(x));
        rt::Color sum;
        for (const Picture& picture : pictures)
            sum += {static_cast<rt::Real>(light_of(picture.bytes[i])),
                    static_cast<rt::Real>(light_of(picture.bytes[i + 1])),
                    static_cast<rt::Real>(light_of(picture.bytes[i + 2]))};
        return sum / static_cast<rt::Real>(pictures.size());
    });
}

}  // namespace companion
