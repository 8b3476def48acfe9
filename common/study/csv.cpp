#include <study/csv.hpp>

namespace study {

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::vector<std::vector<std::string>> read_csv(std::istream& in) {
    std::vector<std::vector<std::string>> lines;
    std::vector<std::string> line;
    std::string field;
    bool quoted = false, line_has_started = false;
    const auto end_field = [&] {
        line.push_back(std::move(field));
        field.clear();
    };
    const auto end_line = [&] {
        if (!line_has_started) return;
        end_field();
        lines.push_back(std::move(line));
        line.clear();
        line_has_started = false;
    };
    for (char c; in.get(c);) {
        if (quoted && c == '"' && in.peek() == '"') {
            field += static_cast<char>(in.get());
        } else if (c == '"') {
            quoted = !quoted;
            line_has_started = true;
        } else if (!quoted && c == '\n') {
            end_line();
        } else if (!quoted && c == '\r') {
            continue;
        } else {
            line_has_started = true;
            if (!quoted && c == ',')
                end_field();
            else
                field += c;
        }
    }
    end_line();
    return lines;
}

}  // namespace study
