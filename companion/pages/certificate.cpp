#include <algorithm>
#include <companion/pages/certificate.hpp>
#include <companion/pages/html.hpp>
#include <rt/counted.hpp>
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
  .shows td, .open td { color: #5c6068; }
  h2 { font-size: 1.2rem; font-weight: normal; margin: 0 0 .6em; }
  figure { margin: 0 0 1.2em; break-inside: avoid; }
  img { display: block; max-width: 100%; height: auto; }
  .small { display: grid; grid-template-columns: 1fr 1fr; gap: 12px; }
</style>
)";

const char* word(const CertifiedFigure& one) {
    return one.held == Held::holds   ? "holds"
           : one.held == Held::shows ? ""
           : one.star                ? "open"
                                     : "fails";
}

std::string number_of(const CertifiedFigure& one) {
    return one.exercise + (one.star ? "*" : "");
}

// How many lines of this grade fail.
long failing(const Certificate& certificate, bool star) {
    return std::count_if(
        certificate.measurements.begin(), certificate.measurements.end(),
        [&](const CertifiedFigure& one) { return one.held == Held::fails && one.star == star; });
}

void add_proofs(std::ostream& out, const std::vector<Proof>& proofs) {
    if (proofs.empty()) return;
    out << "<h2>Eight questions, and what proves the answers</h2>\n<table>\n"
           "<tr><th>you can<th>because this was tested<th></tr>\n";
    for (const Proof& proof : proofs) {
        std::string question = escape_html(proof.question);
        for (const CertifiedFigure& one : proof.lines) {
            out << "<tr class=\"" << word(one) << "\"><td>" << question << "<td>"
                << escape_html(number_of(one) + ' ' + one.what +
                               (one.figure.empty() ? "" : ": " + one.figure))
                << "<td>" << word(one) << "</tr>\n";
            question.clear();
        }
    }
    out << "</table>\n";
}

std::string image(const std::string& file) {
    const std::string name = escape_html(file);
    return "<figure><img src=\"" + name + "\" alt=\"" + name + "\"></figure>\n";
}

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char c : line)
        if (c == '\t')
            fields.emplace_back();
        else
            fields.back() += c;
    return fields;
}

// Joins fields with tabs between them. A field may have several lines, like a compiler's error.
std::string line_of_fields(std::vector<std::string> fields) {
    std::string line;
    for (std::string& field : fields) {
        for (char& c : field)
            if (c == '\t' || c == '\n') c = ' ';
        line += (line.empty() ? "" : "\t") + field;
    }
    return line + '\n';
}

}  // namespace

bool Certificate::passed() const {
    return !measurements.empty() && failing(*this, false) == 0;
}

bool Certificate::passed_with_stars() const {
    return passed() && failing(*this, true) == 0;
}

std::vector<Ability> self_assessment() {
    return {
        {"place a camera, a light and a ray, and find the hit", {"02.4", "03.2", "04.2"}},
        {"derive the quadratic equation of a sphere and solve it", {"03.1", "03.2"}},
        {"build u, v and w from a direction", {"01.8", "02.3"}},
        {"reflect, refract, and split light by Schlick's formula", {"05.1", "05.3", "05.4"}},
        {"end a path at the depth limit", {"04.7"}},
        {"average the samples of a pixel", {"04.5"}},
        {"write a parallel loop without a race, and say how it scales", {"06.2", "06.3", "06.4"}},
        {"build a tree, and say how much time it saves", {"07.3", "07.4", "07.5"}}};
}

std::vector<CertifiedFigure> read_measurements(const std::string& text) {
    std::vector<CertifiedFigure> all;
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) {
        const std::vector<std::string> fields = fields_of(line);
        if (fields.size() != 5) continue;
        const std::string& held = fields[0];
        if (held != "holds" && held != "FAILS" && held != "shows") continue;
        all.push_back({held == "holds"   ? Held::holds
                       : held == "FAILS" ? Held::fails
                                         : Held::shows,
                       fields[1], fields[2], fields[3], fields[4]});
        CertifiedFigure& one = all.back();
        one.star = !one.exercise.empty() && one.exercise.back() == '*';
        if (one.star) one.exercise.pop_back();
    }
    return all;
}

std::string line_of(const CertifiedFigure& one) {
    const char* const symbol = one.held == Held::holds   ? "holds"
                               : one.held == Held::shows ? "     "
                               : one.star                ? "open "
                                                         : "FAILS";
    std::string number = number_of(one);
    number.resize(5, ' ');
    std::string text = std::string(symbol) + "  " + number + ' ' + one.what;
    if (!one.figure.empty()) text += ": " + one.figure;
    if (!one.bound.empty()) text += " (" + one.bound + ")";
    return text;
}

fs::path certificate_file(const Course& course) {
    return course.out() / "certificate.txt";
}

std::string to_text(const Certificate& certificate) {
    std::string text =
        line_of_fields({"made", certificate.date, certificate.machine, certificate.compiler});
    for (const CertifiedFigure& one : certificate.measurements)
        text += line_of_fields({one.held == Held::holds   ? "holds"
                                : one.held == Held::shows ? "shows"
                                                          : "FAILS",
                                number_of(one), one.what, one.figure, one.bound});
    return text;
}

std::optional<Certificate> read_certificate(const std::string& text) {
    const std::vector<std::string> made = fields_of(text.substr(0, text.find('\n')));
    if (made.size() != 4 || made[0] != "made") return {};
    return Certificate{made[1], made[2], made[3], read_measurements(text), {}, {}};
}

std::string grade_html(const Certificate& certificate) {
    std::ostringstream out;
    const long fails = failing(certificate, false), open = failing(certificate, true);
    if (certificate.passed())
        out << "Its author wrote every part of this ray tracer, and it meets every bound that was "
               "measured. <b>Grade: core"
            << (open == 0
                    ? " and stars.</b>"
                    : ".</b> The hard cases still have " + rt::counted(open, "open line") + '.');
    else
        out << "Not passed yet: " << rt::counted(fails, "line") << " of this table "
            << (fails == 1 ? "fails." : "fail.");
    return out.str();
}

std::string table_html(const std::vector<CertifiedFigure>& measurements) {
    std::ostringstream out;
    out << "<table>\n<tr><th>exercise<th>what was measured<th>figure<th>bound<th>result</tr>\n";
    for (const CertifiedFigure& one : measurements)
        out << "<tr class=\"" << (one.held == Held::shows ? "shows" : word(one)) << "\"><td>"
            << escape_html(number_of(one)) << "<td>" << escape_html(one.what)
            << "<td class=\"figure\">" << escape_html(one.figure) << "<td class=\"figure\">"
            << escape_html(one.bound) << "<td>" << word(one) << "</tr>\n";
    out << "</table>\n<p class=\"made\">* a hard case, for the grade core and stars</p>\n";
    return out.str();
}

std::string certificate_html(const Certificate& certificate) {
    std::ostringstream out;
    out << head << "<h1>A ray tracer, by hand</h1>\n<p class=\"verdict\">"
        << grade_html(certificate) << "</p>\n<p class=\"made\">" << escape_html(certificate.date)
        << ", " << escape_html(certificate.machine) << ", " << escape_html(certificate.compiler)
        << ", -O3</p>\n";
    if (certificate.passed() && !certificate.pictures.empty())
        out << image(certificate.pictures.back());
    add_proofs(out, certificate.proofs);
    out << table_html(certificate.measurements) << "<div class=\"small\">\n";
    for (const std::string& picture : certificate.pictures) out << image(picture);
    out << "</div>\n</html>\n";
    return out.str();
}

}  // namespace companion
