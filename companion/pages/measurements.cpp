#include <algorithm>
#include <app/errors.hpp>
#include <cctype>
#include <companion/pages/measurements.hpp>
#include <cstdlib>
#include <fstream>
#include <rt/counted.hpp>
#include <study/csv.hpp>
#include <utility>

namespace companion {
namespace {

double to_number(const std::string& text, const std::filesystem::path& table) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end)
        throw app::Failure(table.string() + ": '" + text + "' should be a number");
    return value;
}

}  // namespace

Measurements read_measurements(const std::filesystem::path& table) {
    std::ifstream in{table};
    if (!in) throw app::Failure(table.string() + " cannot be read");
    Measurements rows;
    bool is_heading = true;
    for (const auto& line : study::read_csv(in)) {
        if (line.size() != 9)
            throw app::Failure(table.string() + ": a line has " +
                               rt::counted(line.size(), "field") + ", not 9");
        if (!std::exchange(is_heading, false))
            rows.push_back(
                {{line[0], line[1], to_number(line[3], table), line[4], to_number(line[5], table),
                  line[6], to_number(line[7], table), line[8]},
                 line[2]});
    }
    return rows;
}

std::vector<Measurements> by_study(const Measurements& rows) {
    std::vector<Measurements> studies;
    for (const Measurement& row : rows) {
        const auto same = [&](const auto& study) { return study.front().study == row.study; };
        const auto found = std::find_if(studies.begin(), studies.end(), same);
        if (found == studies.end())
            studies.push_back({row});
        else
            found->push_back(row);
    }
    return studies;
}

std::string slug(const std::string& study) {
    std::string result;
    for (const char c : study) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte))
            result += static_cast<char>(std::tolower(byte));
        else if (!result.empty() && result.back() != '-')
            result += '-';
    }
    while (!result.empty() && result.back() == '-') result.pop_back();
    return result.empty() ? "study" : result;
}

}  // namespace companion
