#include <algorithm>
#include <cmath>
#include <companion/pages/row_plots.hpp>
#include <companion/pages/svg_parts.hpp>
#include <map>
#include <sstream>

namespace companion {
namespace {

constexpr double thick = 16, gap = 9;

std::string name_of_row(const Measurement& row, bool with_x) {
    return with_x ? row.variant + ", " + row.x_name + ' ' + shown(row.x) : row.variant;
}

// Each name once, in the order in which they first appear.
std::vector<std::string> each_once(const std::vector<std::string>& names) {
    std::vector<std::string> once;
    for (const std::string& name : names)
        if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
    return once;
}

// The names of rows, sorted by their largest value, from the largest on.
std::vector<std::string> by_largest(const Measurements& rows, Quantity quantity, bool with_x) {
    std::map<std::string, double> largest;
    for (const Measurement& row : rows) {
        const double value = std::isfinite(row.*quantity) ? row.*quantity : INFINITY;
        double& so_far = largest.try_emplace(name_of_row(row, with_x), value).first->second;
        so_far = std::max(so_far, value);
    }
    std::vector<std::string> order;
    for (const auto& [name, value] : largest) order.push_back(name);
    std::stable_sort(order.begin(), order.end(),
                     [&](const auto& a, const auto& b) { return largest.at(a) > largest.at(b); });
    return order;
}

// A bar, with its value to the right of it. On a logarithmic axis, which has no zero for a bar to
// begin at, it is a dot at the end of a thin line. A second bar has another shape of dots.
std::string bar(const Axis& axis, double top, double value, std::size_t which,
                const std::string& says) {
    const double left = axis.from(), right = std::max(axis.at(value), left + 1);
    const std::string look = " c" + std::to_string(which) + '\'';
    const std::string mark =
        axis.is_logarithmic()
            ? "<path class='grid' d='M" + point(left, top + 6.5) + 'H' + px(right) +
                  "'/><g class='value" + look + '>' +
                  svg_dot({which, 2 * which, 1, 4.5}, right, top + 6.5, says) + "</g>"
            : "<rect class='bar" + look + " x='" + px(left) + "' y='" + px(top) + "' width='" +
                  px(right - left) + "' height='" + (which == 0 ? "13" : "9") + "'>" +
                  svg_title(says) + "</rect>";
    return mark + svg_text(right + 9, top + 11, shown(value));
}

// The names of rows, to the left of `left`, around the middle of each row.
std::string row_name(double left, double middle, const std::vector<std::string>& lines) {
    std::string words;
    double y = middle + 5 - 8 * static_cast<double>(lines.size() - 1);
    for (const std::string& line : lines) {
        words += svg_text(left - 10, y, line, to_the_left + " class='name'");
        y += 16;
    }
    return words + '\n';
}

// Where the axis begins, so that these names have room.
double left_of(const std::vector<std::string>& names, std::size_t most) {
    std::size_t longest = 0;
    for (const std::string& name : names)
        for (const std::string& line : wrapped(name, most))
            longest = std::max(longest, letters(line));
    return 22 + 7.5 * static_cast<double>(longest);
}

// What bars of each kind mean.
std::string key_of_bars(double y, const std::vector<std::string>& kinds, bool are_dots) {
    std::string parts;
    double x = 14;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const std::string look = 'c' + std::to_string(i);
        parts += are_dots ? "<g class='" + look + "'>" + svg_dot({i, 2 * i, 1, 4.5}, x, y) + "</g>"
                          : "<rect class='" + look + "' x='" + px(x - 6) + "' y='" +
                                px(y - (i == 0 ? 7 : 5)) + "' width='12' height='" +
                                (i == 0 ? "13" : "9") + "'/>";
        parts += svg_text(x + 13, y + 4, kinds[i]) + '\n';
        x += 36 + 7.3 * static_cast<double>(letters(kinds[i]));
    }
    return parts;
}

// A part of a row.
struct Value {
    double value;
    std::size_t which;  // of the things that the key names
    std::string says;
};

// Rows of bars with their names, and a key.
std::string rows_of_bars(const std::vector<std::string>& names,
                         const std::map<std::string, std::vector<Value>>& values,
                         const std::vector<std::string>& kinds, const Measurements& rows,
                         Quantity quantity, Axis::From begins, const std::string& axis_name,
                         double& y) {
    constexpr std::size_t most = 28;
    const double left = left_of(names, most), top = y + 8;
    double bottom = top + gap;
    for (const std::string& name : names)
        bottom += thick * std::max<double>(static_cast<double>(values.at(name).size()),
                                           static_cast<double>(wrapped(name, most).size())) +
                  gap;
    const Axis axis{rows, quantity, left, plot_width - 76, begins};
    std::string parts = axis_below(axis, bottom, top, axis_name);
    y = top + gap;
    for (const std::string& name : names) {
        const std::vector<std::string> lines = wrapped(name, most);
        const double bars = thick * static_cast<double>(values.at(name).size()),
                     height = std::max(bars, thick * static_cast<double>(lines.size()));
        double at = y + (height - bars) / 2;
        for (const Value& value : values.at(name)) {
            parts += bar(axis, at, value.value, value.which, value.says);
            at += thick;
        }
        parts += row_name(left, y + height / 2 - 1, lines);
        y += height + gap;
    }
    y = bottom + 60;
    parts += key_of_bars(y, kinds, axis.is_logarithmic());
    y += 20;
    return parts;
}

// A row for each variant, with a dot for each name of x.
std::string rows_of_dots(const Measurements& rows, Quantity quantity,
                         const std::vector<std::string>& kinds, const std::string& axis_name,
                         double& y) {
    const std::vector<std::string> names = by_largest(rows, quantity, false);
    const double left = left_of(names, 28), top = y + 8,
                 bottom = top + 24 * static_cast<double>(names.size()) + gap;
    const Axis axis{rows, quantity, left, plot_width - 24, Axis::From::least};
    std::string parts = axis_below(axis, bottom, top, axis_name);
    const auto look = [](std::size_t which) { return Look{which, which, 1, which == 0 ? 6. : 5.}; };
    const auto mark = [&](std::size_t which, double right, double down, const std::string& says) {
        return "<g class='c" + std::to_string(which) + (which == 0 ? " float'>" : "'>") +
               svg_dot(look(which), right, down, says) + "</g>";
    };
    y = top + 18;
    for (const std::string& name : names) {
        double least = INFINITY, most = -INFINITY;
        std::string dots;
        for (const Measurement& row : rows)
            if (row.variant == name) {
                const double right = axis.at(row.*quantity);
                least = std::min(least, right);
                most = std::max(most, right);
                const auto which = static_cast<std::size_t>(row.x - rows.front().x);
                dots +=
                    mark(which, right, y, name + ", " + kinds[which] + ": " + shown(row.*quantity));
            }
        parts += "<path class='grid' d='M" + point(least, y) + 'H' + px(most) + "'/>" + dots +
                 row_name(left, y, {name});
        y += 24;
    }
    y = bottom + 60;
    double x = 14;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        parts += mark(i, x, y, "") + svg_text(x + 13, y + 4, kinds[i]) + '\n';
        x += 36 + 7.3 * static_cast<double>(letters(kinds[i]));
    }
    y += 20;
    return parts;
}

}  // namespace

std::vector<std::string> values_of_x(const std::string& x_name) {
    std::vector<std::string> names;
    std::istringstream in{x_name};
    for (std::string name; std::getline(in, name, ',');) {
        name.erase(0, name.find_first_not_of(" 0123456789"));
        names.push_back(name);
    }
    if (names.size() < 3) names.clear();
    return names;
}

std::string bars_svg(const Measurements& rows, Quantity quantity, bool with_x,
                     const Caption& caption) {
    std::map<std::string, std::vector<Value>> values;
    std::vector<std::string> precisions;
    for (const std::string precision : {"double", "float"})
        for (const Measurement& row : rows)
            if (row.precision == precision) {
                const std::string name = name_of_row(row, with_x);
                precisions.push_back(precision);
                values[name].push_back({row.*quantity, precision == "float",
                                        name + ", " + precision + ": " + shown(row.*quantity)});
            }
    double y = 24;
    const std::string title = caption.claim.empty() ? rows.front().study : caption.claim;
    const std::string name =
        quantity == &study::Row::error ? rows.front().error_name : rows.front().cost_name;
    std::string parts = heading(y, title);
    parts += rows_of_bars(by_largest(rows, quantity, with_x), values, each_once(precisions), rows,
                          quantity, Axis::From::values, in_words(caption, name), y);
    return picture(rows.front().study, title, parts, y);
}

std::string named_values_svg(const Measurements& rows, Quantity quantity, const Caption& caption) {
    const std::vector<std::string> kinds = values_of_x(rows.front().x_name);
    Measurements drawn;
    std::vector<std::string> variants;
    for (const Measurement& row : rows)
        if (row.precision == rows.front().precision) {
            drawn.push_back(row);
            variants.push_back(row.variant);
        }
    variants = each_once(variants);
    double y = 24;
    const std::string title = caption.claim.empty() ? rows.front().study : caption.claim;
    const std::string name =
        in_words(caption, quantity == &study::Row::error ? rows.front().error_name
                                                         : rows.front().cost_name) +
        " (" + rows.front().precision + ')';
    std::string parts = heading(y, title);
    if (variants.size() > kinds.size()) {
        parts += rows_of_dots(drawn, quantity, kinds, name, y);
        return picture(rows.front().study, title, parts, y);
    }
    std::map<std::string, std::vector<Value>> values;
    for (const Measurement& row : drawn) {
        const auto which = static_cast<std::size_t>(
            std::find(variants.begin(), variants.end(), row.variant) - variants.begin());
        const std::string& kind = kinds[static_cast<std::size_t>(row.x - drawn.front().x)];
        values[kind].push_back(
            {row.*quantity, which, kind + ", " + row.variant + ": " + shown(row.*quantity)});
    }
    parts += rows_of_bars(kinds, values, variants, drawn, quantity, Axis::From::zero, name, y);
    return picture(rows.front().study, title, parts, y);
}

}  // namespace companion
