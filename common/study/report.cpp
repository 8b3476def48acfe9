#include <rt/real.hpp>
#include <stdexcept>
#include <study/csv.hpp>
#include <study/report.hpp>
#include <type_traits>

namespace study {
namespace {

constexpr const char* header = "study,variant,precision,x,x_name,error,error_name,cost,cost_name\n";

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

using Line = std::vector<std::string>;
constexpr std::size_t precision_column = 2;

Line to_line(const Row& row) {
    return {row.study,         row.variant,    precision(),      number(row.x), row.x_name,
            number(row.error), row.error_name, number(row.cost), row.cost_name};
}

std::string to_text(const Line& line) {
    std::string text;
    for (const std::string& field : line) text += csv_field(field) + ',';
    text.back() = '\n';
    return text;
}

}  // namespace

std::string precision() {
    return std::is_same_v<rt::Real, float> ? "float" : "double";
}

Report::Report(std::string chapter) : chapter_{std::move(chapter)} {}

void Report::add(Row row, Work work, double parts) {
    waiting_.push_back({rows_.size(), std::move(work), parts});
    rows_.push_back(std::move(row));
}

void Report::time_in_turns(const Turns& turns) {
    std::vector<Work> works;
    for (const Waiting& waiting : waiting_) works.push_back(waiting.work);
    const std::vector<double> ns = in_turns_ns(works, turns);
    for (std::size_t i = 0; i < ns.size(); ++i)
        rows_[waiting_[i].row].cost = ns[i] / waiting_[i].parts;
    waiting_.clear();
}

const std::vector<Row>& Report::rows() const {
    if (!waiting_.empty()) throw std::logic_error{"time_in_turns() should come before rows()"};
    return rows_;
}

std::string Report::csv(std::istream& earlier) const {
    std::string text = header;
    const std::string other = precision() == "float" ? "double" : "float";
    for (const Line& line : read_csv(earlier))
        if (line.size() > precision_column && line[precision_column] == other)
            text += to_text(line);
    for (const Row& row : rows()) text += to_text(to_line(row));
    return text;
}

void Report::print_table(std::FILE* out) const {
    std::string title;
    for (const Row& row : rows()) {
        if (row.study != title) {
            title = row.study;
            std::fprintf(out, "\n%s: %s (%s)\n%-24s %18s %24s %14s\n", chapter_.c_str(),
                         title.c_str(), precision().c_str(), "variant", row.x_name.c_str(),
                         row.error_name.c_str(), row.cost_name.c_str());
        }
        const auto measured = [](const std::string& name, double value) {
            char text[32] = "-";
            if (!name.empty()) std::snprintf(text, sizeof text, "%.4g", value);
            return std::string{text};
        };
        std::fprintf(out, "%-24s %18.6g %24s %14s\n", row.variant.c_str(), row.x,
                     measured(row.error_name, row.error).c_str(),
                     measured(row.cost_name, row.cost).c_str());
    }
}

}  // namespace study
