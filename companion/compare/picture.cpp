#include <app/errors.hpp>
#include <array>
#include <cctype>
#include <charconv>
#include <companion/compare/picture.hpp>
#include <rt/counted.hpp>

namespace companion {
namespace {

// The numbers in the header of a .ppm file; a # starts a comment.
class PpmReader {
  public:
    explicit PpmReader(const std::string& text) : text_{text} {}

    long number(const char* what, long low, long high) {
        skip_space();
        long value = 0;
        const char* const end = text_.data() + text_.size();
        const auto [stop, error] = std::from_chars(text_.data() + place_, end, value);
        if (error != std::errc{} || value < low || value > high)
            throw app::Failure(std::string("the .ppm file has no ") + what + " from " +
                               std::to_string(low) + " to " + std::to_string(high) + " at byte " +
                               std::to_string(place_));
        place_ = static_cast<std::size_t>(stop - text_.data());
        return value;
    }
    std::size_t place() const { return place_; }

  private:
    void skip_space() {
        for (; place_ < text_.size(); ++place_) {
            if (text_[place_] == '#') place_ = std::min(text_.find('\n', place_), text_.size() - 1);
            if (!std::isspace(static_cast<unsigned char>(text_[place_]))) return;
        }
    }

    const std::string& text_;
    std::size_t place_ = 2;
};

}  // namespace

Picture parse_ppm(const std::string& text) {
    const std::string kind = text.substr(0, 2);
    if (kind != "P3" && kind != "P6") throw app::Failure("a .ppm file starts with P3 or P6");
    PpmReader reader{text};
    Picture picture;
    picture.width = static_cast<int>(reader.number("width", 1, 65'536));
    picture.height = static_cast<int>(reader.number("height", 1, 65'536));
    reader.number("largest value", 255, 255);
    const auto size = static_cast<std::size_t>(picture.pixels()) * 3;
    if (kind == "P6") {
        const std::size_t start = reader.place() + 1;  // after one white space
        if (text.size() != start + size)
            throw app::Failure("the .ppm file has " + rt::counted(text.size(), "byte") +
                               "; expected " + std::to_string(start + size));
        picture.bytes.assign(text.end() - static_cast<std::ptrdiff_t>(size), text.end());
    } else {
        // A number takes at least two characters. So a short file cannot claim to hold a large
        // picture and use up memory.
        if (text.size() < 2 * size) throw app::Failure("the .ppm file has too few pixels");
        for (std::size_t i = 0; i < size; ++i)
            picture.bytes.push_back(static_cast<std::uint8_t>(reader.number("color", 0, 255)));
    }
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
