#include <algorithm>
#include <cmath>
#include <companion/pages/plot.hpp>
#include <map>
#include <set>
#include <sstream>

namespace companion {
namespace {

using Quantity = double study::Row::*;

// Colors that people with any color vision tell apart. Source: Okabe and Ito, "Color universal
// design", 2008.
constexpr const char* colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                  "#e69f00", "#56b4e9", "#555555"};

// A text in gnuplot's double quotes.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\' || c == '`') result += '\\';
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result + '"';
}

// Whether this row measured the quantity: an error or a cost without a name was not measured.
bool measured(const Measurement& row, Quantity quantity) {
    if (quantity == &study::Row::error) return !row.error_name.empty();
    return quantity != &study::Row::cost || !row.cost_name.empty();
}

// How gnuplot shows one quantity: by its logarithm if it spans more than a factor of 16. Values
// that do not fit such an axis get a row of their own at the edge: 0 on a logarithmic axis;
// infinity and NaN on any axis.
class Axis {
  public:
    Axis(const std::vector<Measurement>& rows, Quantity quantity) {
        std::vector<double> ordinary;
        for (const Measurement& row : rows) {
            if (!measured(row, quantity)) continue;
            const double value = row.*quantity;
            has_infinite_ |= !std::isfinite(value);
            has_zero_ |= value == 0;
            if (std::isfinite(value) && value != 0) ordinary.push_back(value);
        }
        if (ordinary.empty()) ordinary.push_back(1);
        const auto [least, most] = std::minmax_element(ordinary.begin(), ordinary.end());
        is_logarithmic_ = *least > 0 && *most / 16 > *least;
        if (is_logarithmic_)
            set_logarithmic(std::log10(*least), std::log10(*most));
        else
            set_linear(std::min(*least, 0.0), std::max(*most, 0.0));
    }

    double at(double value) const {
        return !std::isfinite(value) ? infinite_ : value == 0 ? zero_ : value;
    }

    double low() const { return low_; }

    // The settings of the axis "x" or "y".
    std::string settings(const std::string& name) const {
        std::ostringstream out;
        out.precision(9);
        out << (is_logarithmic_ ? "set logscale " : "unset logscale ") << name << "\nset format "
            << name << ' ' << quoted(format_) << "\nset " << name << "range [" << low_ << ':'
            << high_ << "]\nset " << name << "tics autofreq\n";
        const std::string add = "set " + name + "tics add (";
        if (is_logarithmic_ && has_zero_) out << add << "\"0\" " << zero_ << ")\n";
        if (has_infinite_) out << add << "\"∞\" " << infinite_ << ")\n";
        if (!more_marks_.empty()) out << add << more_marks_ << ")\n";
        return out.str();
    }

  private:
    // From the logarithms of the least and the largest value. The rows at the edges lie where
    // gnuplot has marks, so that their names replace numbers.
    void set_logarithmic(double least, double most) {
        const double span = most - least, margin = 0.06 * span,
                     step = span > 20  ? 10
                            : span > 8 ? 2
                                       : 1;
        const double zero = step * std::floor((least - margin) / step),
                     infinite = step * std::ceil((most + margin) / step);
        const auto power = [](double exponent) {
            return std::pow(10, std::clamp(exponent, -307.0, 307.0));
        };
        zero_ = power(zero);
        infinite_ = power(infinite);
        low_ = power((has_zero_ ? zero : least) - margin);
        high_ = power((has_infinite_ ? infinite : most) + margin);
        const bool is_short = -3 <= least && most <= 4;
        format_ = is_short ? "%g" : "10^{%T}";
        if (is_short && span < 2.5)
            more_marks_ = "0.002,0.005,0.02,0.05,0.2,0.5,2,5,20,50,200,500,2000,5000";
    }

    void set_linear(double least, double most) {
        const double step = std::pow(10, std::floor(std::log10((most - least) / 2)));
        infinite_ = step * (std::ceil(most / step) + 1);
        const double end = has_infinite_ ? infinite_ : most, margin = 0.06 * (end - least);
        low_ = least < 0 ? least - margin : 0;
        high_ = end + margin;
    }

    bool is_logarithmic_, has_zero_ = false, has_infinite_ = false;
    double zero_ = 0, infinite_ = 0, low_ = 0, high_ = 1;
    std::string format_ = "%g", more_marks_;
};

// Whether a quantity changes with x: for any variant, by more than times fluctuate.
bool depends_on_x(const std::vector<Measurement>& rows, Quantity quantity) {
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

bool has(const std::vector<Measurement>& rows, const std::string& precision) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Measurement& row) { return row.precision == precision; });
}

// What is drawn in a color of its own: a variant, or each x of it if x has no axis.
std::string name_of(const Measurement& row, bool with_x) {
    std::ostringstream name;
    name << row.variant;
    if (with_x) name << ", " << row.x_name << ' ' << row.x;
    return name.str();
}

struct Panel {
    Quantity x, y;
    std::string x_name, y_name;
};

std::vector<Panel> all_panels(const std::vector<Measurement>& rows, bool over_x) {
    using study::Row;
    const auto with_error = std::find_if(rows.begin(), rows.end(), [](const Measurement& row) {
        return measured(row, &Row::error);
    });
    const Measurement& any = rows.front();
    const Panel cost{&Row::x, &Row::cost, any.x_name, any.cost_name};
    if (with_error == rows.end()) return {cost};
    if (!over_x) return {{&Row::cost, &Row::error, any.cost_name, with_error->error_name}};
    const Panel error{&Row::x, &Row::error, any.x_name, with_error->error_name};
    // Level lines tell no more than a table does. If the cost is level, the
    // error gets all the room.
    if (!depends_on_x(rows, &Row::cost) && depends_on_x(rows, &Row::error)) return {error};
    return {error, cost};
}

// Plots a panel's curves: double solid, float dashed. The first curves are the widest, so that no
// curve hides another that runs along it.
void plot(std::ostream& out, const std::vector<Measurement>& rows, const Panel& panel,
          const std::vector<std::string>& names, bool with_x) {
    const Axis x{rows, panel.x}, y{rows, panel.y};
    out << x.settings("x") << y.settings("y") << "set xlabel " << quoted(panel.x_name)
        << " noenhanced\nset label 1 " << quoted(panel.y_name)
        << " at graph 0, graph 1.06 offset -6,0 noenhanced\n";
    std::ostringstream curves;
    int count = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string title = quoted(names[i]);
        const double rank = static_cast<double>(names.size() - 1 - i), width = 1.6 + 0.6 * rank,
                     point = (panel.x == &study::Row::x ? 0.5 : 1.2) + 0.15 * rank;
        for (const std::string precision : {"double", "float"}) {
            const bool is_float = precision == "float";
            std::set<std::pair<double, double>> points;
            for (const Measurement& row : rows)
                if (name_of(row, with_x) == names[i] && row.precision == precision &&
                    measured(row, panel.y))
                    points.emplace(x.at(row.*panel.x), y.at(row.*panel.y));
            if (points.empty()) continue;
            out << "$curve" << count << " << END\n";
            for (const auto& [px, py] : points) out << px << ' ' << py << '\n';
            out << "END\n";
            curves << (count ? ", " : "plot ") << "$curve" << count << " with linespoints lw "
                   << width << " lc rgb '" << colors[i % std::size(colors)] << "' pt "
                   << (is_float ? 6 : 7) << " ps " << point << " dt " << (is_float ? 2 : 1)
                   << " title " << title;
            title = "\"\"";  // each name appears once
            ++count;
        }
    }
    if (has(rows, "double") && has(rows, "float"))
        for (const char* const words : {"pt 7 dt 1 title 'double'", "pt 6 dt 2 title 'float'"})
            curves << ", NaN with linespoints lw 2 ps 1 lc rgb '#555555' " << words;
    out << curves.str() << '\n';
}

void begin(std::ostream& out, const std::string& svg_file, double height) {
    out.precision(9);
    out << "set terminal svg size 960," << height
        << " enhanced font 'Helvetica,Arial,sans-serif,14' background '#ffffff'\nset output "
        << quoted(svg_file) << "\nset border 3 lc rgb '#9a9a9a'\nset grid lc rgb '#e4e4e4' lt 1\n"
        << "set tics nomirror scale 0.5 font ',11' textcolor rgb '#444444'\n";
}

// The errors alone as bars, one per variant: the largest on top, double above float.
std::string bar_script(const std::vector<Measurement>& rows, const std::string& svg_file) {
    using study::Row;
    const Axis axis{rows, &Row::error};
    std::map<std::string, double> longest;
    std::size_t letters = 0;
    for (const Measurement& row : rows) {
        double& bar = longest.try_emplace(row.variant, axis.at(row.error)).first->second;
        bar = std::max(bar, axis.at(row.error));
        letters = std::max(letters, row.variant.size());
    }
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [variant, bar] : longest) order.emplace_back(bar, variant);
    std::sort(order.begin(), order.end());

    std::ostringstream out;
    const double count = static_cast<double>(order.size()), height = 120 + 30 * count;
    begin(out, svg_file, height);
    out << axis.settings("x") << "set title " << quoted(rows.front().study)
        << " font ',17' noenhanced\nset xlabel " << quoted(rows.front().error_name)
        << " noenhanced\nset grid noytics\nset lmargin at screen "
        << std::min(0.6, (8.0 * static_cast<double>(letters) + 20) / 960)
        << "\nset rmargin at screen 0.97\nset yrange [0.4:" << count + 0.6
        << "]\nset style fill solid 0.85 noborder\nset key bottom right Left reverse\n"
           "set ytics scale 0 font ',13' (";
    int place = 0;
    for (const auto& [bar, variant] : order) {
        out << (place ? ", " : "") << quoted(variant) << ' ' << place + 1;
        ++place;
    }
    out << ") noenhanced\n";
    std::ostringstream bars;
    for (const std::string precision : {"double", "float"}) {
        if (!has(rows, precision)) continue;
        const bool is_float = precision == "float";
        out << '$' << precision << " << END\n";
        for (std::size_t i = 0; i < order.size(); ++i)
            for (const Measurement& row : rows)
                if (row.variant == order[i].second && row.precision == precision)
                    out << axis.at(row.error) << ' ' << static_cast<double>(i + 1) << '\n';
        out << "END\n";
        bars << (bars.str().empty() ? "plot " : ", ") << '$' << precision << " using ("
             << axis.low() << "):2:(" << axis.low()
             << "):1:" << (is_float ? "($2-0.36):2" : "2:($2+0.36)") << " with boxxyerror lc rgb '"
             << colors[is_float] << "' title '" << precision << '\'';
    }
    out << bars.str() << "\nset output\n";
    return out.str();
}

}  // namespace

std::string plot_script(const std::vector<Measurement>& rows, const std::string& svg_file) {
    if (std::all_of(rows.begin(), rows.end(), [](const Measurement& row) {
            return measured(row, &study::Row::error) && !measured(row, &study::Row::cost);
        }))
        return bar_script(rows, svg_file);
    std::set<double> xs;
    for (const Measurement& row : rows) xs.insert(row.x);
    const std::vector<Panel> panels = all_panels(rows, xs.size() >= 3);
    const bool with_x = xs.size() > 1 && panels.front().x != &study::Row::x;
    std::vector<std::string> names;
    std::size_t longest = 6;
    for (const Measurement& row : rows) {
        const std::string name = name_of(row, with_x);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        longest = std::max(longest, name.size());
    }
    // The names are below, in columns.
    const std::size_t columns = std::max<std::size_t>(1, 900 / (9 * longest + 60)),
                      key_rows = (names.size() + 2 + columns - 1) / columns;
    const double key_height = 22 * static_cast<double>(key_rows) + 10, height = 420 + key_height;

    std::ostringstream out;
    begin(out, svg_file, height);
    out << "set multiplot layout 1," << panels.size() << " margins 0.09,0.98,"
        << (70 + key_height) / height << ',' << 1 - 60 / height << " spacing 0.11 title "
        << quoted(rows.front().study) << " font ',17' noenhanced\n";
    for (const Panel& panel : panels) {
        out << "set key " << (&panel == &panels.back() ? "on" : "off")
            << " at screen 0.5, screen 0.01 center bottom Left reverse samplen 2.5 spacing 1.1 "
               "noenhanced "
            << "maxrows " << key_rows << '\n';
        plot(out, rows, panel, names, with_x);
    }
    out << "unset multiplot\nset output\n";
    return out.str();
}

}  // namespace companion
