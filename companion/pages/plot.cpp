#include <algorithm>
#include <cmath>
#include <companion/pages/axis.hpp>
#include <companion/pages/plot.hpp>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace companion {
namespace {

// Colors that people with any color vision tell apart. Source: Okabe and Ito, "Color universal
// design", 2008.
constexpr const char* colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                  "#e69f00", "#56b4e9", "#555555"};
constexpr const char* precisions[] = {"double", "float"};
constexpr double font_size = 14, letter_width = 7, line_height = 18;  // pixels

// A text in gnuplot's double quotes.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\' || c == '`') result += '\\';
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result + '"';
}

std::vector<std::string> variants(const std::vector<Measurement>& rows) {
    std::vector<std::string> names;
    for (const Measurement& row : rows)
        if (std::find(names.begin(), names.end(), row.variant) == names.end())
            names.push_back(row.variant);
    return names;
}

std::string color_of(std::size_t variant) {
    return colors[variant % std::size(colors)];
}

// How a line is drawn: dashed for float, its dashes as long for any width.
std::string line_style(double width, bool is_float, const std::string& color) {
    std::ostringstream style;
    style << " lw " << width << " dt ";
    if (is_float)
        style << '(' << 12 / width << ',' << 8 / width << ')';
    else
        style << '1';
    style << " lc rgb '" << color << "' ";
    return style.str();
}

bool has(const std::vector<Measurement>& rows, const std::string& precision) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Measurement& row) { return row.precision == precision; });
}

// Whether this row measured the quantity: an error without a name was not.
bool measured(const Measurement& row, double study::Row::*quantity) {
    return quantity != &study::Row::error || !row.error_name.empty();
}

Scale scale_of(const std::vector<Measurement>& rows, double study::Row::*quantity) {
    std::vector<double> values;
    for (const Measurement& row : rows)
        if (measured(row, quantity)) values.push_back(row.*quantity);
    return Scale{values};
}

// A picture of so many pixels; places in it are given to gnuplot as parts of it.
struct Canvas {
    double width, height;
    std::string x(double pixels) const { return "screen " + std::to_string(pixels / width); }
    std::string y(double pixels) const { return "screen " + std::to_string(1 - pixels / height); }
};

// A panel's frame, in pixels from the top left.
struct Frame {
    double left, top, right, bottom;
};

void begin(std::ostream& out, const Canvas& canvas, const std::string& svg_file,
           const std::string& title) {
    out << "set terminal svg size " << canvas.width << ',' << canvas.height
        << " enhanced font 'Helvetica,Arial,sans-serif," << font_size
        << "' background '#ffffff'\nset output " << quoted(svg_file)
        << "\nset datafile missing 'NaN'\nset multiplot\n"
        << "set style line 100 lc rgb '#9a9a9a' lw 1\nset style line 101 lc rgb '#e4e4e4' lw 1\n"
        << "set border 3 ls 100\nset grid back ls 101\nset tics nomirror scale 0.5 "
        << "textcolor rgb '#444444'\nset key off\n"
        << "set label 1 " << quoted(title) << " at " << canvas.x(20) << ',' << canvas.y(26)
        << " noenhanced font ',17' textcolor rgb '#111111'\n";
}

void set_axis(std::ostream& out, char axis, const Scale& scale) {
    out << "set " << axis << "range [" << scale.low() << ':' << scale.high() << "]\nset " << axis
        << "tics (";
    const char* comma = "";
    for (const auto& [at, text] : scale.marks()) {
        out << comma << quoted(text) << ' ' << at;
        comma = ", ";
    }
    out << ")\n";
}

// The frame, both axes, and what they mean: y above the panel, where it is easy to read.
void set_panel(std::ostream& out, const Canvas& canvas, const Frame& frame, const Scale& x,
               const std::string& x_name, const Scale& y, const std::string& y_name) {
    out << "set lmargin at " << canvas.x(frame.left) << "\nset rmargin at " << canvas.x(frame.right)
        << "\nset tmargin at " << canvas.y(frame.top) << "\nset bmargin at "
        << canvas.y(frame.bottom) << '\n';
    set_axis(out, 'x', x);
    set_axis(out, 'y', y);
    out << "set xlabel " << quoted(x_name) << " noenhanced offset 0,0.2 textcolor rgb '#444444'\n"
        << "set label 2 " << quoted(y_name) << " at " << canvas.x(frame.left - 50) << ','
        << canvas.y(frame.top - 16) << " noenhanced textcolor rgb '#444444'\n";
}

// A legend's entries, one after the other in rows below the panels.
class Legend {
  public:
    Legend(const std::vector<Measurement>& rows, double width) : width_{width} {
        const auto names = variants(rows);
        for (std::size_t i = 0; i < names.size(); ++i) add(names[i], color_of(i), false);
        if (!has(rows, "double") || !has(rows, "float")) return;
        if (x_ + 200 > width_) next_row();  // the two belong together
        for (const std::string precision : precisions)
            add(precision, "#555555", precision == "float");
    }

    double height() const { return line_height * (row_ + 1) + 8; }

    // Draws it with its top at y pixels.
    void draw(std::ostream& out, const Canvas& canvas, double y) const {
        int id = 100;
        for (const Entry& e : entries_) {
            const double middle = y + e.row * line_height + line_height / 2;
            // gnuplot draws no dashed arrows into SVG files, so each dash is one.
            const double dash = e.is_float ? 6 : 30;
            for (double x = e.x; x < e.x + 30; x += 2 * dash)
                out << "set arrow " << id++ << " from " << canvas.x(x) << ',' << canvas.y(middle)
                    << " to " << canvas.x(x + dash) << ',' << canvas.y(middle)
                    << " nohead lw 2 lc rgb '" << e.color << "'\n";
            out << "set label " << id++ << ' ' << quoted(e.text) << " at " << canvas.x(e.x + 37)
                << ',' << canvas.y(middle) << " noenhanced textcolor rgb '#222222'\n";
        }
    }

  private:
    struct Entry {
        std::string text, color;
        bool is_float;
        double x;
        int row;
    };

    void next_row() {
        x_ = left;
        ++row_;
    }

    void add(const std::string& text, const std::string& color, bool is_float) {
        const double width = 37 + letter_width * static_cast<double>(text.size()) + 22;
        if (x_ > left && x_ + width > width_) next_row();
        entries_.push_back({text, color, is_float, x_, row_});
        x_ += width;
    }

    static constexpr double left = 20;
    double width_, x_ = left;
    int row_ = 0;
    std::vector<Entry> entries_;
};

// Draws one curve a variant and precision: a quantity over x.
void plot_curves(std::ostream& out, const std::vector<Measurement>& rows, const Scale& x,
                 const Scale& y, double study::Row::*quantity) {
    const auto names = variants(rows);
    std::ostringstream plots;
    int block = 0;
    for (std::size_t i = 0; i < names.size(); ++i)
        for (const std::string precision : precisions) {
            std::vector<std::pair<double, double>> points;
            for (const Measurement& row : rows)
                if (row.variant == names[i] && row.precision == precision &&
                    measured(row, quantity))
                    points.emplace_back(x.place(row.x), y.place(row.*quantity));
            if (points.empty()) continue;
            std::sort(points.begin(), points.end());
            out << "$curve" << block << " << END\n";
            for (const auto& [px, py] : points) out << px << ' ' << py << '\n';
            out << "END\n";
            const bool is_float = precision == "float";
            // The first curves are the widest, so that none hides behind one that runs along it.
            const double width = 1.6 + 0.6 * static_cast<double>(names.size() - 1 - i);
            plots << (block ? ", " : "plot ") << "$curve" << block << " with linespoints"
                  << line_style(width, is_float, color_of(i)) << "pt " << (is_float ? 6 : 7)
                  << " ps 0.45";
            ++block;
        }
    out << plots.str() << '\n';
}

// Whether a quantity changes with x: whether it does for any variant by more than times wander.
bool depends_on_x(const std::vector<Measurement>& rows, double study::Row::*quantity) {
    struct Span {
        double smallest, largest;
    };
    std::map<std::pair<std::string, std::string>, Span> spans;
    for (const Measurement& row : rows) {
        const double value = row.*quantity;
        Span& span =
            spans.try_emplace({row.variant, row.precision}, Span{value, value}).first->second;
        span = {std::min(span.smallest, value), std::max(span.largest, value)};
    }
    return std::any_of(spans.begin(), spans.end(), [](const auto& entry) {
        return !(entry.second.largest <= 1.25 * entry.second.smallest);
    });
}

void draw_over_x(std::ostream& out, const std::vector<Measurement>& rows,
                 const std::string& svg_file) {
    const auto with_error = std::find_if(rows.begin(), rows.end(), [](const Measurement& row) {
        return measured(row, &study::Row::error);
    });
    const bool has_errors = with_error != rows.end();
    // Level lines say no more than a table does: then the error gets all of the room.
    const bool with_cost = !has_errors || depends_on_x(rows, &study::Row::cost) ||
                           !depends_on_x(rows, &study::Row::error);
    const Legend legend{rows, 940};
    const Canvas canvas{960, 412 + legend.height()};
    const double top = 84, bottom = 340;
    const Frame left{76, top, with_cost ? 464.0 : 940.0, bottom},
        right{has_errors ? 556.0 : 76, top, 940, bottom};
    const Measurement& any = rows.front();
    const Scale x = scale_of(rows, &study::Row::x), error = scale_of(rows, &study::Row::error),
                cost = scale_of(rows, &study::Row::cost);

    begin(out, canvas, svg_file, any.study);
    legend.draw(out, canvas, 410);
    if (has_errors) {
        set_panel(out, canvas, left, x, any.x_name, error, with_error->error_name);
        plot_curves(out, rows, x, error, &study::Row::error);
        if (!with_cost) return;
        out << "unset label\nunset arrow\n";
    }
    set_panel(out, canvas, right, x, any.x_name, cost, any.cost_name);
    plot_curves(out, rows, x, cost, &study::Row::cost);
}

struct Box {
    double left, top, right, bottom;
};

// The area that two boxes share.
double overlap(const Box& a, const Box& b) {
    return std::max(0.0, std::min(a.right, b.right) - std::max(a.left, b.left)) *
           std::max(0.0, std::min(a.bottom, b.bottom) - std::max(a.top, b.top));
}

// Places texts beside points so that they cover points and each other as little as can be.
class Labels {
  public:
    explicit Labels(const Frame& frame) : frame_{frame} {}

    void keep_free(double x, double y) { taken_.push_back({x - 7, y - 7, x + 7, y + 7}); }

    struct Place {
        double x, y;
        const char* alignment;
    };

    Place beside(double x, double y, const std::string& text) {
        const double w = letter_width * static_cast<double>(text.size()), h = line_height / 2;
        Place best{};
        Box best_box{};
        double least = std::numeric_limits<double>::infinity();
        const auto consider = [&](const Place& place, double left) {
            const Box box{left, place.y - h, left + w, place.y + h};
            double covered = 100 * (std::max(0.0, frame_.left - box.left) +
                                    std::max(0.0, box.right - frame_.right) +
                                    std::max(0.0, frame_.top - h - box.top) +
                                    std::max(0.0, box.bottom - frame_.bottom));
            for (const Box& other : taken_) covered += overlap(box, other);
            covered += std::abs(place.y - y) / 4;  // rather near than far
            if (covered >= least) return;
            least = covered;
            best = place;
            best_box = box;
        };
        for (int step = 0; step <= 8; ++step)
            for (const double dy : {-16.0 * step, 16.0 * step}) {
                consider({x + 11, y + dy, "left"}, x + 11);
                consider({x - 11, y + dy, "right"}, x - 11 - w);
                if (step != 0) consider({x, y + dy, "center"}, x - w / 2);
            }
        taken_.push_back(best_box);
        return best;
    }

  private:
    Frame frame_;
    std::vector<Box> taken_;
};

void draw_against(std::ostream& out, const std::vector<Measurement>& rows,
                  const std::string& svg_file) {
    const auto names = variants(rows);
    std::set<double> xs;
    for (const Measurement& row : rows) xs.insert(row.x);
    const bool two_precisions = has(rows, "double") && has(rows, "float");
    const Canvas canvas{760, two_precisions ? 480.0 : 440.0};
    const Frame frame{76, 84, 735, 380};
    const Measurement& any = rows.front();
    const Scale cost = scale_of(rows, &study::Row::cost),
                error = scale_of(rows, &study::Row::error);

    begin(out, canvas, svg_file, any.study);
    set_panel(out, canvas, frame, cost, any.cost_name, error, any.error_name);
    const auto at_x = [&](const Measurement& row) {
        return frame.left + cost.fraction(row.cost) * (frame.right - frame.left);
    };
    const auto at_y = [&](const Measurement& row) {
        return frame.bottom - error.fraction(row.error) * (frame.bottom - frame.top);
    };
    Labels labels{frame};
    for (const Measurement& row : rows) labels.keep_free(at_x(row), at_y(row));
    int id = 10;
    const auto point = [&](double x, double y, bool is_float, const std::string& color) {
        out << "set label " << id++ << " '' at " << canvas.x(x) << ',' << canvas.y(y)
            << " point pt " << (is_float ? 6 : 7) << " ps 1 lw 2 lc rgb '" << color << "'\n";
    };
    const auto text = [&](const Labels::Place& at, const std::string& words,
                          const std::string& color) {
        out << "set label " << id++ << ' ' << quoted(words) << " at " << canvas.x(at.x) << ','
            << canvas.y(at.y) << ' ' << at.alignment << " noenhanced textcolor rgb '" << color
            << "'\n";
    };
    for (const Measurement& row : rows) {
        const auto variant = static_cast<std::size_t>(
            std::find(names.begin(), names.end(), row.variant) - names.begin());
        std::ostringstream words;
        words << row.variant;
        if (xs.size() > 1) words << ", " << row.x_name << ' ' << row.x;
        const double x = at_x(row), y = at_y(row);
        const Labels::Place place = labels.beside(x, y, words.str());
        // A line leads to a text that had to move away.
        if (std::abs(place.y - y) > 20)
            out << "set arrow " << id++ << " from " << canvas.x(x) << ',' << canvas.y(y) << " to "
                << canvas.x(place.x) << ',' << canvas.y(place.y + (place.y < y ? 7 : -7))
                << " nohead lw 1 lc rgb '#9a9a9a'\n";
        point(x, y, row.precision == "float", color_of(variant));
        text(place, words.str(), color_of(variant));
    }
    if (two_precisions) {
        double x = frame.left;
        for (const std::string precision : precisions) {
            point(x, 456, precision == "float", "#555555");
            text({x + 12, 456, "left"}, precision, "#222222");
            x += 90;
        }
    }
    out << "plot NaN\n";
}

}  // namespace

std::string plot_script(const std::vector<Measurement>& rows, const std::string& svg_file) {
    std::set<double> xs;
    for (const Measurement& row : rows) xs.insert(row.x);
    std::ostringstream out;
    out.precision(9);
    if (xs.size() >= 3)
        draw_over_x(out, rows, svg_file);
    else
        draw_against(out, rows, svg_file);
    out << "unset multiplot\nset output\n";
    return out.str();
}

}  // namespace companion
