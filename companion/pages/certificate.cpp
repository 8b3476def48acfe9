#include <algorithm>
#include <companion/pages/certificate.hpp>
#include <companion/pages/html.hpp>
#include <sstream>

namespace companion {
namespace {

constexpr const char* head = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Certificate: a ray tracer, by hand</title>
<style>
  @page { margin: 18mm; }
  body { margin: 0 auto; max-width: 860px; padding: 56px 24px; color: #1d1f23; background: #fff;
         font: 16px/1.5 Georgia, "Times New Roman", serif; }
  h1 { font-size: 2.1rem; font-weight: normal; margin: 0 0 .2em; }
  .verdict { font-size: 1.2rem; margin: 0 0 2em; }
  .made { color: #5c6068; font-size: .88rem; margin: 0 0 2em; }
  table { border-collapse: collapse; width: 100%; font-size: .9rem; margin: 0 0 2.5em; }
  th { text-align: left; font-weight: normal; color: #5c6068; border-bottom: 1px solid #1d1f23; }
  th, td { padding: 5px 14px 5px 0; vertical-align: top; }
  td { border-bottom: 1px solid #e2e0da; }
  td.figure { white-space: nowrap; font-variant-numeric: tabular-nums; }
  tr { break-inside: avoid; }
  .fails td { font-weight: bold; }
  .shows td { color: #5c6068; }
  figure { margin: 0 0 1.2em; break-inside: avoid; }
  img { display: block; max-width: 100%; height: auto; }
  .small { display: grid; grid-template-columns: 1fr 1fr; gap: 12px; }
</style>
)";

const char* word(Held held) {
    return held == Held::holds ? "holds" : held == Held::fails ? "fails" : "";
}

std::string image(const std::string& file) {
    const std::string name = escape_html(file);
    return "<figure><img src=\"" + name + "\" alt=\"" + name + "\"></figure>\n";
}

}  // namespace

bool Certificate::passed() const {
    return !measurements.empty() &&
           std::none_of(measurements.begin(), measurements.end(),
                        [](const CertifiedFigure& one) { return one.held == Held::fails; });
}

std::vector<CertifiedFigure> read_measurements(const std::string& text) {
    std::vector<CertifiedFigure> all;
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> fields(1);
        for (const char c : line)
            if (c == '\t')
                fields.emplace_back();
            else
                fields.back() += c;
        if (fields.size() != 5) continue;
        const std::string& held = fields[0];
        if (held != "holds" && held != "FAILS" && held != "shows") continue;
        all.push_back({held == "holds"   ? Held::holds
                       : held == "FAILS" ? Held::fails
                                         : Held::shows,
                       fields[1], fields[2], fields[3], fields[4]});
    }
    return all;
}

std::string line_of(const CertifiedFigure& one) {
    const char* const symbol = one.held == Held::holds   ? "holds"
                               : one.held == Held::fails ? "FAILS"
                                                         : "     ";
    std::string text = std::string(symbol) + "  " + (one.exercise.empty() ? "    " : one.exercise) +
                       "  " + one.what;
    if (!one.figure.empty()) text += ": " + one.figure;
    if (!one.bound.empty()) text += " (" + one.bound + ")";
    return text;
}

std::string certificate_html(const Certificate& certificate) {
    std::ostringstream out;
    out << head << "<h1>A ray tracer, by hand</h1>\n<p class=\"verdict\">";
    const auto failing =
        std::count_if(certificate.measurements.begin(), certificate.measurements.end(),
                      [](const CertifiedFigure& one) { return one.held == Held::fails; });
    if (certificate.passed())
        out << "Every part of this ray tracer was written by its author, and holds what was "
               "measured.";
    else
        out << "Not there yet: " << failing << (failing == 1 ? " line" : " lines")
            << " of this table " << (failing == 1 ? "fails." : "fail.");
    out << "</p>\n<p class=\"made\">" << escape_html(certificate.date) << ", "
        << escape_html(certificate.machine) << ", " << escape_html(certificate.compiler)
        << ", -O3</p>\n";
    if (certificate.passed() && !certificate.pictures.empty())
        out << image(certificate.pictures.back());
    out << "<table>\n<tr><th>exercise<th>what was measured<th>figure<th>bound<th></tr>\n";
    for (const CertifiedFigure& one : certificate.measurements)
        out << "<tr class=\"" << (one.held == Held::shows ? "shows" : word(one.held)) << "\"><td>"
            << escape_html(one.exercise) << "<td>" << escape_html(one.what)
            << "<td class=\"figure\">" << escape_html(one.figure) << "<td class=\"figure\">"
            << escape_html(one.bound) << "<td>" << word(one.held) << "</tr>\n";
    out << "</table>\n<div class=\"small\">\n";
    for (const std::string& picture : certificate.pictures) out << image(picture);
    out << "</div>\n</html>\n";
    return out.str();
}

}  // namespace companion
