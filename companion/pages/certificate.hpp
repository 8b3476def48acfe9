#pragma once
// The certificate: what was measured of the learner's own code, as a page to print.

#include <companion/model/course.hpp>
#include <optional>
#include <string>
#include <vector>

namespace companion {

enum class Held { holds, fails, shows };

// One measurement, with the bound that it is held to. "shows" has no bound: it only informs.
struct CertifiedFigure {
    Held held = Held::holds;
    std::string exercise;  // "05.3"; empty if it is about the whole
    std::string what, figure, bound;
    bool star = false;  // required only for the second grade
};

// The lines that the programs of tests/certify print; others are ignored. An exercise with a star,
// "01.4*", belongs to the second grade.
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
    std::vector<std::string> pictures;  // relative to the page; the last is the final scene
    std::vector<Proof> proofs;          // of the self-assessment

    bool passed() const;             // the first grade: the core
    bool passed_with_stars() const;  // the second
};

std::string certificate_html(const Certificate& certificate);

// What the page says first, the grade or how many lines fail, and its table, both as HTML.
std::string grade_html(const Certificate& certificate);
std::string table_html(const std::vector<CertifiedFigure>& measurements);

// The certificate's figures as a file keeps them, and what such a file holds: all but the pictures
// and the proofs. None where the file is no certificate.
fs::path certificate_file(const Course& course);
std::string to_text(const Certificate& certificate);
std::optional<Certificate> read_certificate(const std::string& text);

}  // namespace companion
