#pragma once
// The certificate: the measurements of the learner's own code, as a page to print.

#include <companion/model/course.hpp>
#include <optional>
#include <string>
#include <vector>

namespace companion {

enum class Held { holds, fails, shows };

// One measurement and its bound. A measurement that is "shows" has no bound: it only informs.
struct CertifiedFigure {
    Held held = Held::holds;
    std::string exercise;  // "05.3"; empty if it is about the whole course
    std::string what, figure, bound;
    bool star = false;  // required only for the second grade
};

// Reads the lines that the programs of tests/certify print, and ignores all other lines. An
// exercise with an asterisk, "01.4*", belongs to the second grade.
std::vector<CertifiedFigure> read_measurements(const std::string& text);

// "holds  05.3  what: figure (at most bound)"
std::string line_of(const CertifiedFigure& measurement);

// A question of the final self-assessment, and the exercises whose lines prove the answer.
struct Ability {
    const char* words;
    std::vector<std::string> exercises;
};
std::vector<Ability> self_assessment();

struct Proof {
    std::string question;
    std::vector<CertifiedFigure> lines;
};

struct Certificate {
    std::string date, machine, compiler;
    std::vector<CertifiedFigure> measurements;
    std::vector<std::string> pictures;  // relative to the page; the last one is the final scene
    std::vector<Proof> proofs;          // of the self-assessment

    bool passed() const;             // the first grade: the core
    bool passed_with_stars() const;  // the second
};

std::string certificate_html(const Certificate& certificate);

// HTML for the top of the page (the grade, or how many lines fail), and for its table.
std::string grade_html(const Certificate& certificate);
std::string table_html(const std::vector<CertifiedFigure>& measurements);

// The file in which the certificate's figures are stored; the text of that file, which holds
// everything but the pictures and the proofs; and the certificate in such a text, or none if it is
// not one.
fs::path certificate_file(const Course& course);
std::string to_text(const Certificate& certificate);
std::optional<Certificate> read_certificate(const std::string& text);

}  // namespace companion
