#pragma once
// Reads the picture that the learner's first ray tracer prints.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace first {

struct Picture {
    int width = 0, height = 0;
    std::vector<int> numbers;  // red, green, blue of each pixel, row by row from the top

    bool is_whole() const {
        return width > 0 && numbers.size() == 3 * static_cast<std::size_t>(width) *
                                                  static_cast<std::size_t>(height);
    }
    // Channel 0, 1 or 2, for red, green, blue.
    int at(int column, int row, int channel) const {
        const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(column);
        return numbers[3 * pixel + static_cast<std::size_t>(channel)];
    }
};

// The first words of a text, at most this many, without the comments after a #.
inline std::vector<std::string_view> words(std::string_view text, std::size_t most) {
    const auto is_space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    std::vector<std::string_view> all;
    for (std::size_t at = 0; at < text.size() && all.size() < most;) {
        if (text[at] == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else if (is_space(text[at])) {
            ++at;
        } else {
            std::size_t end = at;
            while (end < text.size() && text[end] != '#' && !is_space(text[end])) ++end;
            all.push_back(text.substr(at, end - at));
            at = end;
        }
    }
    return all;
}

// A whole number of at most nine digits; -1 if the word is something else.
inline int whole_number(std::string_view word) {
    if (word.empty() || word.size() > 9) return -1;
    int number = 0;
    for (const char c : word) {
        if (c < '0' || c > '9') return -1;
        number = 10 * number + (c - '0');
    }
    return number;
}

// Reads a P3 picture. If the text is not one, `trouble` says at which word, and what was expected.
inline Picture read_p3(const std::string& text, std::string& trouble) {
    constexpr int widest = 1920;
    constexpr std::size_t most = 3 * std::size_t{widest} * widest;
    const std::vector<std::string_view> all = words(text, most + 5);
    const auto word = [&](std::size_t i) {
        return i < all.size() ? '"' + std::string{all[i].substr(0, 20)} + '"' : "nothing";
    };
    const auto number = [&](std::size_t i) { return i < all.size() ? whole_number(all[i]) : -1; };
    Picture picture;
    if (all.empty() || all[0] != "P3") {
        trouble = "its first word is " + word(0) + " where P3 was expected";
    } else if (number(1) < 1 || number(2) < 1 || number(1) > widest || number(2) > widest) {
        trouble = "after P3 follow " + word(1) + " and " + word(2) +
                  " where a width and a height from 1 to 1920 were expected";
    } else if (number(3) != 255) {
        trouble = "after the width and the height follows " + word(3) +
                  " where 255 was expected, the value of full brightness";
    }
    if (!trouble.empty()) return picture;
    picture.width = number(1);
    picture.height = number(2);
    for (std::size_t i = 4; i < all.size(); ++i) {
        const int value = number(i);
        picture.numbers.push_back(value);
        if (value >= 0 && value <= 255) continue;
        const std::size_t pixel = (i - 4) / 3, width = static_cast<std::size_t>(picture.width);
        trouble = "row " + std::to_string(pixel / width) + ", column " +
                  std::to_string(pixel % width) + " has the color value " + word(i) +
                  " where a whole number from 0 to 255 was expected";
        return picture;
    }
    if (!picture.is_whole())
        trouble = "the header promises " + std::to_string(picture.width) + " x " +
                  std::to_string(picture.height) + " pixels of 3 numbers each, but " +
                  std::to_string(picture.numbers.size()) + " numbers follow";
    return picture;
}

}  // namespace first
