#include <algorithm>
#include <companion/pages/html.hpp>
#include <companion/pages/svg_parts.hpp>
#include <sstream>

namespace companion {
namespace {

// Colors that people can tell apart with any type of color vision; on a dark page the first and
// sixth are lighter. Source: Okabe and Ito, "Color universal design", 2008. A page that contains
// the picture may set other colors.
constexpr const char* style = R"(<style>
.plot{--paper:#fff;--ink:#1c2026;--muted:#57606a;--line:#dfe2e7;--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#cc79a7;--c4:#e69f00;--c5:#56b4e9;--c6:#666;font:13.5px system-ui,sans-serif}
@media(prefers-color-scheme:dark){.plot{--paper:#16181d;--ink:#dfe2e7;--muted:#a2abb6;--line:#353a43;--c0:#3d8fd9;--c5:#96d3f7;--c6:#aaa}}
.plot .paper{fill:var(--paper)}.plot text{fill:var(--muted)}.plot .name{fill:var(--ink)}.plot .head{fill:var(--ink);font-size:15px;font-weight:600}
.plot .grid{stroke:var(--line);stroke-width:1}.plot .apart{stroke:var(--muted);stroke-dasharray:1 4}.plot .line{fill:none}.plot .frontier{fill:none;stroke:var(--muted);stroke-width:9;stroke-linejoin:round;opacity:.25}
.plot .c0{stroke:var(--c0);fill:var(--c0)}.plot .c1{stroke:var(--c1);fill:var(--c1)}.plot .c2{stroke:var(--c2);fill:var(--c2)}.plot .c3{stroke:var(--c3);fill:var(--c3)}.plot .c4{stroke:var(--c4);fill:var(--c4)}.plot .c5{stroke:var(--c5);fill:var(--c5)}.plot .c6{stroke:var(--c6);fill:var(--c6)}
.plot .float{fill:var(--paper)}.plot .float .line{stroke-dasharray:6 4}.plot g{stroke-width:1.5}.plot .lead{fill:none;stroke-width:1;opacity:.6}.plot .others{opacity:.4}
</style>
)";

// The style, with a plain color before each variable, for viewers that know no variables.
std::string style_with_plain_colors() {
    const std::string text = style;
    std::string out;
    std::size_t done = 0;
    for (std::size_t at; (at = text.find(":var(", done)) != std::string::npos;) {
        const std::size_t property = text.find_last_of("{;", at) + 1, end = text.find(')', at);
        const std::string name = text.substr(at + 5, end - at - 5) + ':';
        const std::size_t color = text.find(name) + name.size();
        const std::string plain = text.substr(color, text.find_first_of(";}", color) - color);
        out += text.substr(done, at - done) + ':' + plain + ';' +
               text.substr(property, end + 1 - property);
        done = end + 1;
    }
    return out + text.substr(done);
}

// Words whose powers, such as 10^7, are written as in a book.
std::string with_powers(const std::string& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size();) {
        const std::size_t end =
            std::min(words.find_first_not_of("0123456789", i + 1), words.size());
        const bool is_power = words[i] == '^' && end > i + 1;
        text += is_power ? raised(words.substr(i + 1, end - i - 1)) : words.substr(i, 1);
        i = is_power ? end : i + 1;
    }
    return text;
}

std::string with_scale(const Axis& axis, const std::string& name) {
    return axis.is_logarithmic() ? name + ", logarithmic" : name;
}

}  // namespace

std::string point(double x, double y) {
    return px(x) + ' ' + px(y);
}

std::string svg_text(double x, double y, const std::string& words, const std::string& attributes) {
    return "<text x='" + px(x) + "' y='" + px(y) + '\'' + attributes + '>' +
           escape_html(with_powers(words)) + "</text>";
}

std::vector<std::string> wrapped(const std::string& words, std::size_t most) {
    std::vector<std::string> lines{""};
    std::istringstream in{words};
    for (std::string word; in >> word;) {
        std::string& line = lines.back();
        if (line.empty())
            line = word;
        else if (letters(line) + 1 + letters(word) <= most)
            line += ' ' + word;
        else
            lines.push_back(word);
    }
    return lines;
}

std::string svg_title(const std::string& says) {
    return says.empty() ? "" : "<title>" + escape_html(says) + "</title>";
}

std::string svg_dot(const Look& look, double x, double y, const std::string& says) {
    using Corners = std::vector<std::pair<double, double>>;
    static const std::vector<Corners> shapes{{},
                                             {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}},
                                             {{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}},
                                             {{0, -1.2}, {1.2, 0.9}, {-1.2, 0.9}},
                                             {{0, 1.2}, {1.2, -0.9}, {-1.2, -0.9}},
                                             {{-1, -1.1}, {1, -1.1}, {-1, 1.1}, {1, 1.1}}};
    std::string corners;
    for (const auto& [right, down] : shapes[look.shape % shapes.size()])
        corners += (corners.empty() ? "M" : " ") + point(x + look.dot * right, y + look.dot * down);
    if (!corners.empty()) return "<path d='" + corners + "z'>" + svg_title(says) + "</path>";
    return "<circle cx='" + px(x) + "' cy='" + px(y) + "' r='" + px(look.dot) + "'>" +
           svg_title(says) + "</circle>";
}

std::string heading(double& y, const std::string& words) {
    std::string lines;
    for (const std::string& line : wrapped(words, 52)) {
        lines += svg_text(8, y, line, " class='head'") + '\n';
        y += 20;
    }
    return lines;
}

std::string axis_below(const Axis& x, double bottom, double top, const std::string& name) {
    std::string lines[2], words;
    for (const Axis::Mark& mark : x.marks()) {
        lines[mark.is_apart] += 'M' + point(mark.at, bottom) + 'V' + px(top);
        words += svg_text(mark.at, bottom + 18, mark.name, in_the_middle);
    }
    const std::string all = with_scale(x, name);
    // The name may be longer than the axis; then it begins further to the left.
    const double half = 3.55 * static_cast<double>(letters(all));
    const double middle =
        std::max(half + 4, std::min((x.from() + x.to()) / 2, plot_width - half - 4));
    return "<path class='grid' d='" + lines[0] + "'/><path class='grid apart' d='" + lines[1] +
           "'/>\n" + words + svg_text(middle, bottom + 37, all, " class='name'" + in_the_middle) +
           '\n';
}

std::string axis_beside(const Axis& y, double left, double right, const std::string& name) {
    std::string lines[2], words;
    for (const Axis::Mark& mark : y.marks()) {
        lines[mark.is_apart] += 'M' + point(left, mark.at) + 'H' + px(right);
        words += svg_text(left - 8, mark.at + 4, mark.name, to_the_left);
    }
    return "<path class='grid' d='" + lines[0] + "'/><path class='grid apart' d='" + lines[1] +
           "'/>\n" + words + svg_text(8, y.to() - 13, with_scale(y, name), " class='name'") + '\n';
}

std::string picture(const std::string& study, const std::string& name, const std::string& parts,
                    double height) {
    const std::string size = px(plot_width) + "' height='" + px(height) + '\'';
    return "<svg xmlns='http://www.w3.org/2000/svg' class='plot' role='img' data-study=\"" +
           escape_html(study) + "\" aria-label=\"" + escape_html(name) + "\" viewBox='0 0 " +
           point(plot_width, height) + "' width='" + size + ">\n" + style_with_plain_colors() +
           "<rect class='paper' width='" + size + "/>\n" + parts + "</svg>\n";
}

}  // namespace companion
