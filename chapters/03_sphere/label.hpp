#pragma once
// Words in a picture: letters of 3 x 5 dots, as many as this chapter's labels need.

#include <string_view>

namespace label {

// The five rows of a letter from the top, three dots a row, the leftmost in the highest bit.
constexpr int dots(char letter) {
    switch (letter) {
        case '0':
            return 0b111'101'101'101'111;
        case '1':
            return 0b010'110'010'010'111;
        case '2':
            return 0b111'001'111'100'111;
        case '3':
            return 0b111'001'111'001'111;
        case '4':
            return 0b101'101'111'001'001;
        case '5':
            return 0b111'100'111'001'111;
        case '6':
            return 0b111'100'111'101'111;
        case '7':
            return 0b111'001'001'010'010;
        case '8':
            return 0b111'101'111'101'111;
        case '9':
            return 0b111'101'111'001'111;
        case 'A':
            return 0b111'101'111'101'101;
        case 'B':
            return 0b110'101'110'101'110;
        case 'E':
            return 0b111'100'110'100'111;
        case 'K':
            return 0b101'101'110'101'101;
        case 'L':
            return 0b100'100'100'100'111;
        case 'O':
            return 0b111'101'101'101'111;
        case 'S':
            return 0b111'100'111'001'111;
        case 'T':
            return 0b111'010'010'010'010;
        case 'X':
            return 0b101'101'010'101'101;
        default:
            return 0;
    }
}

// Whether the dot (x, y) belongs to the text, whose top left dot is (0, 0). Letters are 4 dots
// apart.
constexpr bool covers(std::string_view text, int x, int y) {
    if (x < 0 || y < 0 || y >= 5 || x >= 4 * static_cast<int>(text.size()) || x % 4 == 3)
        return false;
    return dots(text[static_cast<std::size_t>(x / 4)]) >> (14 - 3 * y - x % 4) & 1;
}

}  // namespace label
