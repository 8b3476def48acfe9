#pragma once
// A text drawing of where things are in memory, with an arrow for each pointer.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace toolchain {

struct Thing {
    std::string place;         // "stack", "heap", "static", "code"
    const void* address = {};  // where it begins
    std::string name;
    const void* points_to = {};  // for a pointer: where the thing that it points to begins
};

inline std::uintptr_t number(const void* address) {
    return reinterpret_cast<std::uintptr_t>(address);
}

inline std::string hex(const void* address) {
    char text[32];
    std::snprintf(text, sizeof text, "0x%012llx", static_cast<unsigned long long>(number(address)));
    return text;
}

// Draws one line per thing, high addresses first. The arrows are on the right, each in a column of
// its own.
inline std::string draw_map(std::vector<Thing> things) {
    std::sort(things.begin(), things.end(),
              [](const Thing& a, const Thing& b) { return number(a.address) > number(b.address); });
    std::vector<std::string> lines;
    std::string place;
    for (const Thing& thing : things) {
        const std::string margin = thing.place == place ? "" : place = thing.place;
        lines.push_back(margin + std::string(8 - margin.size(), ' ') + hex(thing.address) + "  " +
                        thing.name + ' ');
    }
    std::size_t width = 0;
    for (const std::string& line : lines) width = std::max(width, line.size());
    std::size_t column = width + 3;
    for (std::size_t from = 0; from < things.size(); ++from)
        for (std::size_t to = 0; to < things.size(); ++to) {
            if (!things[from].points_to || things[from].points_to != things[to].address) continue;
            const auto top = std::min(from, to), bottom = std::max(from, to);
            for (std::size_t row = top; row <= bottom; ++row) {
                std::string& line = lines[row];
                line.resize(std::max(line.size(), column + 1), ' ');
                if (row == from || row == to) {
                    const std::size_t start = line.find_last_not_of(" -|+<o", width) + 2;
                    for (std::size_t i = start; i < column; ++i)
                        if (line[i] == ' ') line[i] = '-';
                    line[start] = row == from ? 'o' : '<';
                    line[column] = '+';
                } else {
                    line[column] = '|';
                }
            }
            column += 2;
        }
    std::string text = "high addresses\n";
    for (const std::string& line : lines) text += line + '\n';
    return text + "low addresses\n";
}

}  // namespace toolchain
