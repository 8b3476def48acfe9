#include <algorithm>
#include <cmath>
#include <companion/pages/axis.hpp>
#include <companion/pages/html.hpp>
#include <companion/pages/plot.hpp>
#include <companion/pages/row_plots.hpp>
#include <companion/pages/svg_parts.hpp>
#include <map>
#include <set>

namespace companion {
namespace {

// ---- What is drawn ---------------------------------------------------------------------------

// Whether a quantity changes with x: in any variant, by more than the usual fluctuation of times.
bool depends_on_x(const Measurements& rows, Quantity quantity) {
    std::map<std::pair<std::string, std::string>, std::pair<double, double>> spans;
    for (const Measurement& row : rows) {
        const double value = row.*quantity;
        auto& [least, most] =
            spans.try_emplace({row.variant, row.precision}, value, value).first->second;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    return std::any_of(spans.begin(), spans.end(), [](const auto& entry) {
        return !(entry.second.second <= 1.25 * entry.second.first);
    });
}

struct Panel {
    Quantity x, y;
};

bool any_measured(const Measurements& rows, Quantity quantity) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Measurement& row) { return measured(row, quantity); });
}

// Whether each variant has a single row in each precision.
bool is_single(const Measurements& rows) {
    std::set<std::pair<std::string, std::string>> seen;
    return std::all_of(rows.begin(), rows.end(), [&](const Measurement& row) {
        return seen.insert({row.variant, row.precision}).second;
    });
}

std::vector<Panel> all_panels(const Measurements& rows, bool over_x, const std::string& shows) {
    using study::Row;
    const Panel error{&Row::x, &Row::error}, cost{&Row::x, &Row::cost};
    if (shows == "cost" || !any_measured(rows, &Row::error)) return {cost};
    if (!any_measured(rows, &Row::cost)) return {error};
    if (shows == "error over cost" || !over_x) return {{&Row::cost, &Row::error}};
    // Horizontal lines tell no more than a table does. If the cost does not change with x, the
    // error gets all the room.
    if (!depends_on_x(rows, &Row::cost) && depends_on_x(rows, &Row::error)) return {error};
    return {error, cost};
}

std::string name_of(const Measurements& rows, Quantity quantity) {
    for (const Measurement& row : rows)
        if (measured(row, quantity))
            return quantity == &study::Row::x       ? row.x_name
                   : quantity == &study::Row::error ? row.error_name
                                                    : row.cost_name;
    return "";
}

// The precisions that occur, double first.
std::vector<std::string> precisions(const Measurements& rows) {
    std::vector<std::string> found;
    for (const std::string precision : {"double", "float"})
        if (std::any_of(rows.begin(), rows.end(),
                        [&](const Measurement& row) { return row.precision == precision; }))
            found.push_back(precision);
    return found;
}

// The name of a row's variant together with its x.
std::string with_x(const Measurement& row) {
    return row.variant + ", " + row.x_name + ' ' + shown(row.x);
}

// How each variant looks, or each x of a variant if x has no axis. The first line is the widest, so
// that a later line along it does not hide it. If there are more names than colors, those that
// begin with the same word have the same color, but different shapes.
class Looks {
  public:
    Looks(const Measurements& rows, bool is_with_x) : is_with_x_{is_with_x} {
        for (const Measurement& row : rows)
            if (std::find(names_.begin(), names_.end(), of(row)) == names_.end())
                names_.push_back(of(row));
        const bool are_many = names_.size() > color_count;
        std::vector<std::string> families;
        std::vector<std::size_t> shapes(color_count);
        for (const std::string& name : names_) {
            const std::string family = are_many ? name.substr(0, name.find_first_of(" ,")) : name;
            auto known = std::find(families.begin(), families.end(), family);
            if (known == families.end()) known = families.insert(known, family);
            const auto color = static_cast<std::size_t>(known - families.begin()) % color_count;
            const double later = static_cast<double>(color) / static_cast<double>(names_.size());
            looks_[name] = are_many ? Look{color, shapes[color]++, 0.8, 3}
                                    : Look{color, color, 3.6 - 2.2 * later, 4.2 - 1.2 * later};
        }
    }

    std::string of(const Measurement& row) const { return is_with_x_ ? with_x(row) : row.variant; }
    const std::vector<std::string>& names() const { return names_; }
    const Look& operator[](const std::string& name) const { return looks_.at(name); }

  private:
    bool is_with_x_;
    std::vector<std::string> names_;
    std::map<std::string, Look> looks_;
};

// ---- Lines and their names -------------------------------------------------------------------

// A curve's line and dots.
std::string curve(const Look& look, const std::string& precision, const std::string& line,
                  const std::string& dots) {
    return "<g class='c" + std::to_string(look.color) + ' ' + precision +
           "'><path class='line' stroke-width='" + px(look.line) + "' d='" + line + "'/>" + dots +
           "</g>";
}

// A value with its unit, if the quantity's name ends with a unit: "5.1 ns" for "time / ns".
std::string with_unit(double value, const std::string& name) {
    const auto slash = name.rfind(" / ");
    if (slash == std::string::npos || name.size() - slash > 6) return shown(value);
    return shown(value) + ' ' + name.substr(slash + 3);
}

constexpr std::size_t longest_line_of_name = 18;

// How much room names need at the right.
double room_for(const std::vector<std::string>& names) {
    std::size_t longest = 0;
    for (const std::string& name : names)
        for (const std::string& line : wrapped(name, longest_line_of_name))
            longest = std::max(longest, letters(line));
    return 36 + 8 * static_cast<double>(longest);
}

// A panel's rows in the order of its horizontal axis, by variant and precision.
Measurements in_order(const Measurements& rows, const Looks& looks, const std::string& name,
                      const std::string& precision, const Panel& panel, const Axis& x) {
    Measurements own;
    for (const Measurement& row : rows)
        if (looks.of(row) == name && row.precision == precision) own.push_back(row);
    std::stable_sort(own.begin(), own.end(), [&](const auto& a, const auto& b) {
        return x.at(a.*panel.x) < x.at(b.*panel.x);
    });
    return own;
}

std::string curves(const Measurements& rows, const Panel& panel, const Axis& x, const Axis& y,
                   const Looks& looks, const std::vector<std::string>& names) {
    const std::string x_name = name_of(rows, panel.x), y_name = name_of(rows, panel.y);
    std::string result;
    for (const std::string& name : names) {
        for (const std::string& precision : precisions(rows)) {
            const Measurements own = in_order(rows, looks, name, precision, panel, x);
            std::string line, dots;
            for (const Measurement& row : own) {
                const double right = x.at(row.*panel.x), down = y.at(row.*panel.y);
                line += (line.empty() ? "M" : " ") + point(right, down);
                dots += svg_dot(looks[name], right, down,
                                (panel.x == &study::Row::x ? name : with_x(row)) + ", " +
                                    precision + ": " + with_unit(row.*panel.y, y_name) + " at " +
                                    with_unit(row.*panel.x, x_name));
            }
            if (!own.empty()) result += curve(looks[name], precision, line, dots);
        }
        if (!result.empty() && result.back() != '\n') result += '\n';
    }
    return result;
}

// The names of lines, to the right of a panel, each as near to the end of its line as the others
// allow, with a thin line from there.
std::string names_at_lines(const Measurements& rows, const Panel& panel, const Axis& x,
                           const Axis& y, const Looks& looks,
                           const std::vector<std::string>& names) {
    struct Name {
        double from, end, height, at;
        std::string name;
        std::vector<std::string> lines;
    };
    std::vector<Name> all;
    for (const std::string& name : names)
        for (const std::string& precision : precisions(rows)) {
            const Measurements own = in_order(rows, looks, name, precision, panel, x);
            if (own.empty()) continue;
            const auto lines = wrapped(name, longest_line_of_name);
            const double end = y.at(own.back().*panel.y),
                         height = 15 * static_cast<double>(lines.size()) + 2;
            all.push_back({x.at(own.back().*panel.x), end, height, end, name, lines});
            break;  // the first precision's line is the one that is named
        }
    std::stable_sort(all.begin(), all.end(),
                     [](const Name& a, const Name& b) { return a.end < b.end; });
    // From the top on, each begins where the one above it ends; from the bottom on, they go up
    // again as far as they must.
    double free = y.to() - 12;
    for (Name& name : all) {
        name.at = std::max(name.at, free + name.height / 2);
        free = name.at + name.height / 2;
    }
    free = std::max(y.from() + 10, [&] {
        double sum = y.to() - 12;
        for (const Name& name : all) sum += name.height;
        return sum;
    }());
    for (auto name = all.rbegin(); name != all.rend(); ++name) {
        name->at = std::min(name->at, free - name->height / 2);
        free = name->at - name->height / 2;
    }
    std::string parts;
    const double left = x.to() + 22;
    for (const Name& name : all) {
        const Look look{looks[name.name].color, looks[name.name].shape, 1, 4};
        parts += "<g class='c" + std::to_string(look.color) + "'><path class='lead' d='M" +
                 point(name.from + 5, name.end) + ' ' + point(left - 6, name.at) + "'/>" +
                 svg_dot(look, left, name.at) + "</g>";
        double down = name.at + 4.5 - 7.5 * static_cast<double>(name.lines.size() - 1);
        for (const std::string& line : name.lines) {
            parts += svg_text(left + 9, down, line, " class='name'");
            down += 15;
        }
        parts += '\n';
    }
    return parts;
}

// Says which lines are of which precision, if there are two.
std::string key(const Measurements& rows, double& y) {
    std::string result;
    double x = 8;
    if (precisions(rows).size() > 1)
        for (const std::string& precision : precisions(rows)) {
            result += curve({color_count - 1, 0, 2, 3}, precision, 'M' + point(x, y) + "h30",
                            svg_dot({0, 0, 2, 3}, x + 15, y)) +
                      svg_text(x + 37, y + 4, precision) + '\n';
            x += 110;
        }
    y += result.empty() ? 0 : 18;
    return result;
}

// The rows that no other row beats in both error and cost. A gain of less than 3 % counts as
// chance.
std::string frontier(Measurements rows, const Axis& x, const Axis& y) {
    std::sort(rows.begin(), rows.end(), [](const Measurement& a, const Measurement& b) {
        return std::pair{a.cost, a.error} < std::pair{b.cost, b.error};
    });
    std::string line, names = "frontier:";
    double least = INFINITY;
    for (const Measurement& row : rows) {
        if (row.error >= 0.97 * least) continue;
        least = row.error;
        line += (line.empty() ? "M" : " ") + point(x.at(row.cost), y.at(row.error));
        names += '\n' + with_x(row) + ", " + row.precision;
    }
    return "<path class='frontier' d='" + line + "'>" + svg_title(names) + "</path>\n";
}

// Whether all rows have the value 0.
bool all_zero(const Measurements& rows, Quantity quantity) {
    return std::all_of(rows.begin(), rows.end(),
                       [&](const Measurement& row) { return row.*quantity == 0; });
}

constexpr double left_of_panels = 64;

}  // namespace

std::string plot_svg(const Measurements& rows, const Caption& caption) {
    std::set<double> xs;
    for (const Measurement& row : rows) xs.insert(row.x);
    const std::vector<Panel> panels = all_panels(rows, xs.size() >= 3, caption.shows);
    const Quantity first = panels.front().y;
    const bool over_x = panels.front().x == &study::Row::x;
    if (over_x && !values_of_x(rows.front().x_name).empty())
        return named_values_svg(rows, first, caption);
    const bool are_few = is_single(rows) || (caption.shows == "cost" && xs.size() < 3);
    if (over_x && panels.size() == 1 && are_few)
        return bars_svg(rows, first, !is_single(rows), caption);
    const Looks looks{rows, xs.size() > 1 && !over_x && xs.size() < 3};
    const std::string title = caption.claim.empty() ? rows.front().study : caption.claim;
    const double right = plot_width - room_for(looks.names());
    double y = 24;
    std::string parts = heading(y, title);
    bool has_lines = false;
    const std::vector<std::string> none;
    for (const Panel& panel : panels) {
        Measurements drawn;  // only the rows that were measured
        for (const Measurement& row : rows)
            if (measured(row, panel.y)) drawn.push_back(row);
        const std::string name = in_words(caption, name_of(drawn, panel.y));
        if (all_zero(drawn, panel.y)) {
            parts += svg_text(8, y + 4, name + ": 0 everywhere", " class='name'") + '\n';
            y += 26;
            for (const std::string& variant : panels.size() == 1 ? looks.names() : none) {
                parts += svg_text(20, y + 4, variant) + '\n';
                y += 20;
            }
            continue;
        }
        const double top = y + 32, bottom = top + (panels.size() > 1 ? 190 : 264);
        const Axis across{drawn, panel.x, left_of_panels, right}, up{drawn, panel.y, bottom, top};
        parts += axis_below(across, bottom, top, in_words(caption, name_of(drawn, panel.x))) +
                 axis_beside(up, across.from(), across.to(), name) +
                 curves(drawn, panel, across, up, looks, looks.names()) +
                 names_at_lines(drawn, panel, across, up, looks, looks.names());
        y = bottom + 58;
        has_lines = true;
    }
    if (has_lines) parts += key(rows, y);
    return picture(rows.front().study, title, parts, y);
}

std::string trade_svg(const std::vector<Measurements>& studies,
                      const std::vector<std::string>& named, const Caption& caption) {
    using study::Row;
    Measurements all, colored;
    for (const Measurements& rows : studies)
        for (const Measurement& row : rows) all.push_back(row);
    for (const std::string& name : named)
        for (const Measurement& row : all)
            if (row.variant == name) colored.push_back(row);
    const Looks looks{colored, false};
    const double right = plot_width - room_for(named);
    const std::string title = caption.claim.empty() ? "Error over time" : caption.claim;
    double y = 24;
    std::string parts = heading(y, title);
    for (const Measurements& rows : studies) {
        // All panels have the same axes, so that they can be compared.
        const double top = y + 58, bottom = top + 270;
        const Axis x{all, &Row::cost, left_of_panels, right}, up{all, &Row::error, bottom, top};
        Measurements own;
        std::string others;
        for (const Measurement& row : rows)
            if (std::count(named.begin(), named.end(), row.variant) > 0)
                own.push_back(row);
            else
                others += svg_dot({0, 0, 1, 2.5}, x.at(row.cost), up.at(row.error),
                                  with_x(row) + ", " + row.precision + ": " + shown(row.error) +
                                      " at " + with_unit(row.cost, row.cost_name));
        const Panel panel{&Row::cost, &Row::error};
        parts += svg_text(8, y + 14, rows.front().study, " class='head'") + '\n' +
                 axis_below(x, bottom, top, in_words(caption, rows.front().cost_name)) +
                 axis_beside(up, x.from(), x.to(), in_words(caption, rows.front().error_name)) +
                 frontier(rows, x, up) + "<g class='c6 others'>" + others + "</g>\n" +
                 curves(own, panel, x, up, looks, looks.names()) +
                 names_at_lines(own, panel, x, up, looks, looks.names());
        y = bottom + 56;
    }
    parts += "<path class='frontier' d='M" + point(8, y) + "h30'/>" +
             svg_text(45, y + 4, "nothing measured is both faster and more accurate") +
             "\n<g class='c6 others'>" + svg_dot({0, 0, 1, 2.5}, 23, y + 20) + "</g>" +
             svg_text(45, y + 24, "the other settings: point at a dot, and it says which") + '\n';
    y += 42;
    parts += key(all, y);
    return picture(title, title, parts, y);
}

std::string plot_file(const std::filesystem::path& table, const std::string& study) {
    return table.stem().string() + '-' + slug(study) + ".svg";
}

std::map<std::string, std::string> plots_of(const std::filesystem::path& table,
                                            const Captions& captions) {
    std::vector<Measurements> studies = by_study(read_measurements(table));
    if (table.filename() == "accuracy.csv") {
        // The other studies of this table repeat these pictures in more detail.
        std::erase_if(studies, [](const Measurements& rows) {
            return rows.front().error_name != "RMSE in a pixel" ||
                   rows.front().cost_name != "time / ms";
        });
        const std::vector<std::string> named{"jittered", "Sobol", "Sobol, tent",
                                             "Sobol in batches, tent"};
        return {{"accuracy.svg", trade_svg(studies, named, captions.of(table, "Error over time"))}};
    }
    std::map<std::string, std::string> plots;
    for (const Measurements& rows : studies) {
        const std::string& study = rows.front().study;
        plots[plot_file(table, study)] = plot_svg(rows, captions.of(table, study));
    }
    return plots;
}

}  // namespace companion
