#pragma once
// The certificate: what was measured of the learner's own code, as a page to print.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

enum class Held { holds, fails, shows };

// One measurement, with the bound that it is held to. "shows" has no bound: it only informs.
struct CertifiedFigure {
    Held held = Held::holds;
    std::string exercise;  // "05.3"; empty where it is of the whole
    std::string what, figure, bound;
};

// The lines that the programs of tests/certify print; others are left out.
std::vector<CertifiedFigure> read_measurements(const std::string& text);

// "holds  05.3  what: figure (at most bound)"
std::string line_of(const CertifiedFigure& measurement);

struct Certificate {
    std::string date, machine, compiler;
    std::vector<CertifiedFigure> measurements;
    std::vector<std::string> pictures;  // relative to the page; the last is the final scene

    bool passed() const;
};

std::string certificate_html(const Certificate& certificate);

}  // namespace companion
