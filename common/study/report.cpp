#include <fstream>
#include <rt/image_file.hpp>
#include <rt/real.hpp>
#include <sstream>
#include <study/report.hpp>
#include <type_traits>

namespace study {
namespace {

constexpr const char* header = "study,variant,precision,x,x_name,error,error_name,cost,cost_name\n";

// A field with commas or quotes goes between quotes, as RFC 4180 has it.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string to_line(const Row& row) {
    return field(row.study) + ',' + field(row.variant) + ',' + precision() + ',' + number(row.x) +
           ',' + field(row.x_name) + ',' + number(row.error) + ',' + field(row.error_name) + ',' +
           number(row.cost) + ',' + field(row.cost_name) + '\n';
}

// The rows of an earlier run of the program that was built with the other precision.
std::string rows_of_other_precision(const std::filesystem::path& path) {
    const std::string other = precision() == "float" ? ",double," : ",float,";
    std::ifstream in{path};
    std::string kept;
    for (std::string line; std::getline(in, line);)
        if (line.find(other) != std::string::npos) kept += line + '\n';
    return kept;
}

}  // namespace

std::string precision() {
    return std::is_same_v<rt::Real, float> ? "float" : "double";
}

Report::Report(std::string chapter) : chapter_{std::move(chapter)} {}

void Report::write_csv(const std::filesystem::path& folder) const {
    const auto path = folder / (chapter_ + ".csv");
    std::string text = header + rows_of_other_precision(path);
    for (const Row& row : rows_) text += to_line(row);
    rt::replace_file(path, text);
}

void Report::print_table(std::FILE* out) const {
    std::string title;
    for (const Row& row : rows_) {
        if (row.study != title) {
            title = row.study;
            std::fprintf(out, "\n%s: %s (%s)\n%-24s %18s %24s %14s\n", chapter_.c_str(),
                         title.c_str(), precision().c_str(), "variant", row.x_name.c_str(),
                         row.error_name.c_str(), row.cost_name.c_str());
        }
        std::fprintf(out, "%-24s %18.6g %24.4g %14.4g\n", row.variant.c_str(), row.x, row.error,
                     row.cost);
    }
}

}  // namespace study
