#include <algorithm>
#include <companion/model/course_file.hpp>
#include <companion/pages/certificate.hpp>
#include <companion/system/files.hpp>

#include "catch.hpp"

using companion::Held;

TEST_CASE("measurements are read line by line", "[certificate]") {
    const auto all = companion::read_measurements(
        "holds\t05.3\tSnell\t2 epsilon\tat most 16 epsilon\nsome words\n"
        "FAILS\t05.2\tfurnace\t4 %\tat most 0 %\nshows\t07.5\ta ray\t12 ns\t\nholds\tcut off");
    REQUIRE(all.size() == 3);
    CHECK(all[0].held == Held::holds);
    CHECK(all[1].held == Held::fails);
    CHECK(all[1].exercise == "05.2");
    CHECK(all[2].bound.empty());
    CHECK(companion::line_of(all[1]) == "FAILS  05.2  furnace: 4 % (at most 0 %)");
    const auto star = companion::read_measurements("FAILS\t01.4*\tlength\t9 epsilon\tat most 4\n");
    REQUIRE(star.size() == 1);
    CHECK(star[0].star);
    CHECK(star[0].exercise == "01.4");
    CHECK(companion::line_of(star[0]) == "open   01.4* length: 9 epsilon (at most 4)");
}

TEST_CASE("a certificate has two grades", "[certificate]") {
    companion::Certificate certificate;
    certificate.measurements = companion::read_measurements(
        "holds\t01.2\tdot\t1\tat most 2\nholds\t01.4*\tlength\t3\tat most 4\n");
    CHECK(certificate.passed_with_stars());
    CHECK(companion::certificate_html(certificate).find("Grade: core and stars.") !=
          std::string::npos);
    certificate.measurements.back().held = Held::fails;
    CHECK(certificate.passed());
    CHECK_FALSE(certificate.passed_with_stars());
    const std::string page = companion::certificate_html(certificate);
    CHECK(page.find("Grade: core.") != std::string::npos);
    CHECK(page.find("1 open line.") != std::string::npos);
    certificate.measurements.front().held = Held::fails;
    CHECK_FALSE(certificate.passed());
}

TEST_CASE("a certificate comes back from its file", "[certificate]") {
    companion::Certificate certificate{"2030-01-02", "a machine", "a compiler", {}, {}, {}};
    certificate.measurements = companion::read_measurements(
        "holds\t01.2\tdot\t1\tat most 2\nFAILS\t01.4*\tlength\t3\tat most 2\nshows\t07.5\ta "
        "ray\t12 ns\t\n");
    certificate.measurements.push_back({Held::fails, "", "stars of 01", "1 of 2", "all", true});
    certificate.measurements.push_back({Held::fails, "", "error:\n\tcode", "", "compiles"});
    const auto back = companion::read_certificate(companion::to_text(certificate));
    REQUIRE(back);
    CHECK(back->date == "2030-01-02");
    CHECK(back->machine == "a machine");
    CHECK(back->compiler == "a compiler");
    REQUIRE(back->measurements.size() == 5);
    for (std::size_t i = 0; i < 4; ++i) {
        INFO(i);
        CHECK(companion::line_of(back->measurements[i]) ==
              companion::line_of(certificate.measurements[i]));
        CHECK(back->measurements[i].star == certificate.measurements[i].star);
    }
    CHECK(back->measurements[4].what == "error:  code");
    CHECK_FALSE(companion::read_certificate(""));
    CHECK_FALSE(companion::read_certificate("<html>\n"));
}

TEST_CASE("eight questions are proved by exercises of the course", "[certificate]") {
    const auto questions = companion::self_assessment();
    CHECK(questions.size() == 8);
    const companion::Course here = companion::this_course();
    const auto all = companion::read_course_file(here).exercises;
    const std::string map = companion::read_file(here.root / "docs/README.md");
    for (const auto& question : questions) {
        std::string ids;
        for (const std::string& id : question.exercises) {
            INFO(question.words << ": " << id);
            CHECK(
                std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.id == id; }));
            ids += (ids.empty() ? "" : ", ") + id;
        }
        INFO(question.words);
        CHECK(map.find("| " + (question.words + (" | " + ids)) + " |") != std::string::npos);
    }
    companion::Certificate certificate;
    certificate.measurements = companion::read_measurements("holds\t04.5\tjitter\t1\tat most 2\n");
    certificate.proofs = {{"average <samples>", certificate.measurements}};
    const std::string page = companion::certificate_html(certificate);
    CHECK(page.find("<td>average &lt;samples&gt;<td>04.5 jitter: 1<td>holds") != std::string::npos);
}

TEST_CASE("a certificate is passed only when all that was measured holds", "[certificate]") {
    companion::Certificate certificate;
    CHECK_FALSE(certificate.passed());
    certificate.measurements = companion::read_measurements("holds\t01.1\tdot\t1\tat most 2\n");
    CHECK(certificate.passed());
    CHECK(companion::certificate_html(certificate).find("Not passed yet") == std::string::npos);
    certificate.measurements.push_back({Held::fails, "05.2", "loses <light>", "4 %", "0 %"});
    CHECK_FALSE(certificate.passed());
    const std::string page = companion::certificate_html(certificate);
    CHECK(page.find("Not passed yet: 1 line of this table fails.") != std::string::npos);
    CHECK(page.find("loses &lt;light&gt;") != std::string::npos);
}

TEST_CASE("the certificate shows the pictures, the final scene first and alone", "[certificate]") {
    companion::Certificate certificate;
    certificate.date = "2030-01-02";
    certificate.measurements = companion::read_measurements("holds\t01.1\tdot\t1\tat most 2\n");
    certificate.pictures = {"certificate/01_vectors.png", "certificate/08_effects.png"};
    const std::string page = companion::certificate_html(certificate);
    CHECK(page.find("2030-01-02") != std::string::npos);
    CHECK(page.find("08_effects.png") < page.find("01_vectors.png"));
}
