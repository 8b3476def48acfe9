#include <algorithm>
#include <cmath>
#include <companion/pages/axis.hpp>
#include <companion/pages/html.hpp>
#include <companion/pages/plot.hpp>
#include <map>
#include <set>

namespace companion {
namespace {

constexpr double width = 760;

// Colors that people can tell apart with any type of color vision; on a dark page the first and
// sixth are lighter. Source: Okabe and Ito, "Color universal design", 2008. A page that contains
// the picture may set other colors.
constexpr const char* style = R"(<style>
.plot{--paper:#fff;--ink:#1c2026;--muted:#57606a;--line:#dfe2e7;--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#cc79a7;--c4:#e69f00;--c5:#56b4e9;--c6:#666;font:12px system-ui,sans-serif}
@media(prefers-color-scheme:dark){.plot{--paper:#16181d;--ink:#dfe2e7;--muted:#a2abb6;--line:#353a43;--c0:#3d8fd9;--c5:#96d3f7;--c6:#aaa}}
.plot .paper{fill:var(--paper)}.plot text{fill:var(--muted)}.plot .name{fill:var(--ink);font-size:13px}.plot .head{fill:var(--ink);font-size:16px;font-weight:600}
.plot .grid{stroke:var(--line);stroke-width:1}.plot .apart{stroke:var(--muted);stroke-dasharray:1 4}.plot .line{fill:none}.plot .frontier{fill:none;stroke:var(--muted);stroke-width:9;stroke-linejoin:round;opacity:.25}
.plot .c0{stroke:var(--c0);fill:var(--c0)}.plot .c1{stroke:var(--c1);fill:var(--c1)}.plot .c2{stroke:var(--c2);fill:var(--c2)}.plot .c3{stroke:var(--c3);fill:var(--c3)}.plot .c4{stroke:var(--c4);fill:var(--c4)}.plot .c5{stroke:var(--c5);fill:var(--c5)}.plot .c6{stroke:var(--c6);fill:var(--c6)}
.plot .float{fill:var(--paper)}.plot .float .line{stroke-dasharray:6 4}.plot g{stroke-width:1.5}
</style>
)";
constexpr std::size_t color_count = 7;

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

std::vector<Panel> all_panels(const Measurements& rows, bool over_x) {
    using study::Row;
    const Panel error{&Row::x, &Row::error}, cost{&Row::x, &Row::cost};
    if (!any_measured(rows, &Row::error)) return {cost};
    if (!any_measured(rows, &Row::cost)) return {error};
    if (!over_x) return {{&Row::cost, &Row::error}};
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

struct Look {
    std::size_t color, shape;
    double line, dot;  // their sizes
};

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
                                    : Look{color, 0, 3.6 - 2.2 * later, 4.2 - 1.8 * later};
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

// ---- Parts of a picture ----------------------------------------------------------------------

std::string point(double x, double y) {
    return px(x) + ' ' + px(y);
}

std::string text(double x, double y, const std::string& words, const std::string& attributes = "") {
    return "<text x='" + px(x) + "' y='" + px(y) + '\'' + attributes + '>' + escape_html(words) +
           "</text>";
}
const std::string in_the_middle = " text-anchor='middle'", to_the_left = " text-anchor='end'";

// The text that appears when the pointer is on a part.
std::string title(const std::string& says) {
    return says.empty() ? "" : "<title>" + escape_html(says) + "</title>";
}

// A dot of one of five shapes.
std::string dot(const Look& look, double x, double y, const std::string& says = "") {
    using Corners = std::vector<std::pair<double, double>>;
    static const std::vector<Corners> shapes{{},
                                             {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}},
                                             {{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}},
                                             {{0, -1.2}, {1.2, 0.9}, {-1.2, 0.9}},
                                             {{0, 1.2}, {1.2, -0.9}, {-1.2, -0.9}}};
    std::string corners;
    for (const auto& [right, down] : shapes[look.shape % shapes.size()])
        corners += (corners.empty() ? "M" : " ") + point(x + look.dot * right, y + look.dot * down);
    if (!corners.empty()) return "<path d='" + corners + "z'>" + title(says) + "</path>";
    return "<circle cx='" + px(x) + "' cy='" + px(y) + "' r='" + px(look.dot) + "'>" + title(says) +
           "</circle>";
}

// A curve's line and dots.
std::string curve(const Look& look, const std::string& precision, const std::string& line,
                  const std::string& dots) {
    return "<g class='c" + std::to_string(look.color) + ' ' + precision +
           "'><path class='line' stroke-width='" + px(look.line) + "' d='" + line + "'/>" + dots +
           "</g>";
}

// A bar, with its value to the right of it.
std::string bar(double left, double right, double top, const Measurement& row, double value) {
    return "<rect class='bar c" + std::to_string(row.precision == "float") + "' x='" + px(left) +
           "' y='" + px(top) + "' width='" + px(right - left) + "' height='13'>" +
           title(row.variant + ", " + row.precision + ": " + shown(value)) + "</rect>" +
           text(right + 6, top + 11, shown(value));
}

// A value with its unit, if the quantity's name ends with a unit: "5.1 ns" for "time / ns".
std::string with_unit(double value, const std::string& name) {
    const auto slash = name.rfind(" / ");
    if (slash == std::string::npos || name.size() - slash > 6) return shown(value);
    return shown(value) + ' ' + name.substr(slash + 3);
}

// The lines, values and name of a horizontal axis at the bottom of a panel, whose lines go up to
// `top`.
std::string axis_below(const Axis& x, double bottom, double top, const std::string& name) {
    std::string lines[2], words;
    for (const Axis::Mark& mark : x.marks()) {
        lines[mark.is_apart] += 'M' + point(mark.at, bottom) + 'V' + px(top);
        words += text(mark.at, bottom + 18, mark.name, in_the_middle);
    }
    return "<path class='grid' d='" + lines[0] + "'/><path class='grid apart' d='" + lines[1] +
           "'/>\n" + words +
           text((x.from() + x.to()) / 2, bottom + 38, name, " class='name'" + in_the_middle) + '\n';
}

// The same for a vertical axis on the left. Its name stands above it, so that it can be read like
// any text.
std::string axis_beside(const Axis& y, double left, double right, const std::string& name) {
    std::string lines[2], words;
    for (const Axis::Mark& mark : y.marks()) {
        lines[mark.is_apart] += 'M' + point(left, mark.at) + 'H' + px(right);
        words += text(left - 8, mark.at + 4, mark.name, to_the_left);
    }
    return "<path class='grid' d='" + lines[0] + "'/><path class='grid apart' d='" + lines[1] +
           "'/>\n" + words + text(left - 50, y.to() - 14, name, " class='name'") + '\n';
}

std::string curves(const Measurements& rows, const Panel& panel, const Axis& x, const Axis& y,
                   const Looks& looks) {
    const std::string x_name = name_of(rows, panel.x), y_name = name_of(rows, panel.y);
    std::string result;
    for (const std::string& name : looks.names()) {
        for (const std::string& precision : precisions(rows)) {
            Measurements own;
            for (const Measurement& row : rows)
                if (looks.of(row) == name && row.precision == precision) own.push_back(row);
            std::stable_sort(own.begin(), own.end(), [&](const auto& a, const auto& b) {
                return x.at(a.*panel.x) < x.at(b.*panel.x);
            });
            std::string line, dots;
            for (const Measurement& row : own) {
                const double right = x.at(row.*panel.x), down = y.at(row.*panel.y);
                line += (line.empty() ? "M" : " ") + point(right, down);
                dots += dot(looks[name], right, down,
                            (panel.x == &study::Row::x ? name : with_x(row)) + ", " + precision +
                                ": " + with_unit(row.*panel.y, y_name) + " at " +
                                with_unit(row.*panel.x, x_name));
            }
            if (!own.empty()) result += curve(looks[name], precision, line, dots);
        }
        if (!result.empty() && result.back() != '\n') result += '\n';
    }
    return result;
}

// Adds the names below the panels, side by side as far as they fit. Moves `y` to the end of the
// names.
std::string key(const Looks& looks, const Measurements& rows, double& y) {
    struct Name {
        Look look;
        std::string precision, name;
        double length;
    };
    std::vector<Name> names;
    const auto add = [&](const Look& look, const std::string& precision, const std::string& name) {
        names.push_back({look, precision, name, 48 + 6.7 * static_cast<double>(letters(name))});
    };
    for (const std::string& name : looks.names()) add(looks[name], "double", name);
    if (precisions(rows).size() > 1)
        for (const std::string& precision : precisions(rows))
            add({color_count - 1, 0, 2, 3}, precision, precision);
    std::string result;
    double x = 8;
    for (const Name& name : names) {
        const bool is_pair = name.name == "double" && &name != &names.back();
        if (x > 8 && x + name.length + (is_pair ? names.back().length : 0) > width) {
            x = 8;
            y += 20;
        }
        result +=
            curve(name.look, name.precision, 'M' + point(x, y) + "h30", dot(name.look, x + 15, y)) +
            text(x + 37, y + 4, name.name) + '\n';
        x += name.length;
    }
    y += 16;
    return result;
}

std::string heading(double y, const std::string& words) {
    return text(8, y, words, " class='head'") + '\n';
}

std::string picture(const std::string& name, const std::string& parts, double height) {
    const std::string size = px(width) + "' height='" + px(height) + '\'';
    return "<svg xmlns='http://www.w3.org/2000/svg' class='plot' role='img' aria-label=\"" +
           escape_html(name) + "\" viewBox='0 0 " + point(width, height) + "' width='" + size +
           ">\n" + style + "<rect class='paper' width='" + size + "/>\n" + parts + "</svg>\n";
}

// The variants, sorted by their largest value, from the largest on.
std::vector<std::string> by_largest(const Measurements& rows, Quantity quantity) {
    std::map<std::string, double> largest;
    for (const Measurement& row : rows) {
        const double value = std::isfinite(row.*quantity) ? row.*quantity : INFINITY;
        double& so_far = largest.try_emplace(row.variant, value).first->second;
        so_far = std::max(so_far, value);
    }
    std::vector<std::string> order;
    for (const auto& [variant, value] : largest) order.push_back(variant);
    std::stable_sort(order.begin(), order.end(),
                     [&](const auto& a, const auto& b) { return largest.at(a) > largest.at(b); });
    return order;
}

// A single quantity as bars: the largest on top, double above float.
std::string bars(const Measurements& rows, Quantity quantity) {
    const std::vector<std::string> order = by_largest(rows, quantity), both = precisions(rows);
    std::size_t longest = 0;
    for (const std::string& variant : order) longest = std::max(longest, letters(variant));
    constexpr double top = 48, thick = 16, gap = 8;
    const double bottom =
        top + thick * static_cast<double>(rows.size()) + gap * static_cast<double>(order.size());
    const double left = std::min(0.5 * width, 24 + 6.6 * static_cast<double>(longest));
    const Axis axis{rows, quantity, left, width - 70};
    std::string parts = heading(22, rows.front().study) +
                        axis_below(axis, bottom, top - 8, name_of(rows, quantity));
    double y = top;
    for (const std::string& variant : order) {
        const double begin = y;
        for (const std::string& precision : both)
            for (const Measurement& row : rows)
                if (row.variant == variant && row.precision == precision) {
                    const double value = row.*quantity;
                    parts += bar(left, std::max(axis.at(value), left + 1), y, row, value);
                    y += thick;
                }
        parts += text(left - 8, (begin + y) / 2 + 3, variant, to_the_left) + '\n';
        y += gap;
    }
    double x = 8;
    for (const std::string& precision : both) {
        parts += "<rect class='c" + std::to_string(precision == "float") + "' x='" + px(x) +
                 "' y='" + px(bottom + 27) + "' width='12' height='12'/>" +
                 text(x + 18, bottom + 38, precision) + '\n';
        x += 80;
    }
    return picture(rows.front().study, parts, bottom + 54);
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
    return "<path class='frontier' d='" + line + "'>" + title(names) + "</path>\n";
}

}  // namespace

std::string plot_svg(const Measurements& rows) {
    const bool has_error = any_measured(rows, &study::Row::error);
    if (has_error != any_measured(rows, &study::Row::cost) && is_single(rows))
        return bars(rows, has_error ? &study::Row::error : &study::Row::cost);
    std::set<double> xs;
    for (const Measurement& row : rows) xs.insert(row.x);
    const std::vector<Panel> panels = all_panels(rows, xs.size() >= 3);
    const Looks looks{rows, xs.size() > 1 && panels.front().x != &study::Row::x};
    const double each = width / static_cast<double>(panels.size()), top = 66, bottom = 330;
    std::string parts = heading(22, rows.front().study);
    double left = 58;
    for (const Panel& panel : panels) {
        Measurements drawn;  // only the rows that were measured
        for (const Measurement& row : rows)
            if (measured(row, panel.y)) drawn.push_back(row);
        const Axis x{drawn, panel.x, left, left + each - 72}, y{drawn, panel.y, bottom, top};
        parts += axis_below(x, bottom, top, name_of(drawn, panel.x)) +
                 axis_beside(y, x.from(), x.to(), name_of(drawn, panel.y)) +
                 curves(drawn, panel, x, y, looks);
        left += each;
    }
    double end = bottom + 66;
    parts += key(looks, rows, end);
    return picture(rows.front().study, parts, end);
}

std::string trade_svg(const std::vector<Measurements>& studies) {
    using study::Row;
    Measurements all;
    for (const Measurements& rows : studies) all.insert(all.end(), rows.begin(), rows.end());
    const Looks looks{all, false};
    std::string parts;
    double top = 66;
    for (const Measurements& rows : studies) {
        // All panels have the same axes, so that they can be compared.
        const double bottom = top + 364;
        const Axis x{all, &Row::cost, 58, width - 14}, y{all, &Row::error, bottom, top};
        parts += heading(top - 44, rows.front().study) +
                 axis_below(x, bottom, top, rows.front().cost_name) +
                 axis_beside(y, x.from(), x.to(), rows.front().error_name) + frontier(rows, x, y) +
                 curves(rows, {&Row::cost, &Row::error}, x, y, looks);
        top += 500;
    }
    double end = top - 66;
    parts += key(looks, all, end);
    return picture("Error over time", parts, end);
}

std::string plot_file(const std::filesystem::path& table, const std::string& study) {
    return table.stem().string() + '-' + slug(study) + ".svg";
}

std::map<std::string, std::string> plots_of(const std::filesystem::path& table) {
    std::vector<Measurements> studies = by_study(read_measurements(table));
    if (table.filename() == "accuracy.csv") {
        // The other studies of this table repeat these pictures in more detail.
        std::erase_if(studies, [](const Measurements& rows) {
            return rows.front().error_name != "RMSE in a pixel" ||
                   rows.front().cost_name != "time / ms";
        });
        return {{"accuracy.svg", trade_svg(studies)}};
    }
    std::map<std::string, std::string> plots;
    for (const Measurements& rows : studies)
        plots[plot_file(table, rows.front().study)] = plot_svg(rows);
    return plots;
}

}  // namespace companion
