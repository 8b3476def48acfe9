#include <companion/check/counts.hpp>
#include <rt/image_file.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;

namespace {

TestCase failing(const std::string& name, const std::string& counts) {
    TestCase test;
    test.name = name;
    test.ended = true;
    FailedAssertion failure;
    failure.messages = {{"expected 1", "1", ""}, {"", "", "", false, counts}};
    test.failures = {failure};
    return test;
}

}  // namespace

TEST_CASE("counts are rows of cells, counted and expected", "[counts]") {
    const auto counts = read_counts("2;3 5 0 1e3;4 4.5 1 1");
    REQUIRE(counts);
    CHECK(counts->columns == 2);
    CHECK(counts->seen == std::vector<double>{3, 5, 0, 1000});
    CHECK(counts->expected == std::vector<double>{4, 4.5, 1, 1});
    for (const char* const wrong : {"", "2", "2;1 2", "2;1 2;1", "2;1 2 3;1 2 3", "0;1;1", "-1;1;1",
                                    "x;1;1", "1e9;1;1", "nan;1;1", "1;;", "2;;1 2"}) {
        INFO(wrong);
        CHECK_FALSE(read_counts(wrong));
    }
    std::string many = "1;";
    for (int i = 0; i < 10'001; ++i) many += "1 ";
    CHECK_FALSE(read_counts(many + ';' + many.substr(2)));
}

TEST_CASE("a row of counts is drawn as bars and several rows as shades", "[counts]") {
    const Counts row{2, {4, 0}, {2, 4}};
    const rt::Image bars = picture_of(row, row.seen);
    const int width = bars.width(), bottom = bars.height() - 1;
    CHECK(bars.at(0, bottom) != bars.at(width - 1, bottom));
    // A bar of 4 out of 1.5 * 4.
    CHECK(bars.at(0, bars.height() * 2 / 5) == bars.at(0, bottom));
    CHECK(bars.at(0, bars.height() / 4) == bars.at(width - 1, bottom));

    const Counts table{2, {0, 1, 2, 30}, {1, 1, 1, 2}};
    const rt::Image shades = picture_of(table, table.seen);
    const int right = shades.width() - 1, low = shades.height() - 1;
    const auto shade = [&](int x, int y) { return shades.at(x, y).g; };
    CHECK(shades.width() == shades.height());
    CHECK(shade(0, 0) < shade(right, 0));
    CHECK(shade(right, 0) < shade(0, low));
    CHECK(shade(0, low) < shade(right, low));
    CHECK(shades.at(right, low) == rt::from_hex(0xffc857));  // no brighter than all others

    const Counts nothing{1, {0}, {0}};
    CHECK(picture_of(nothing, nothing.seen).at(0, 0) == rt::from_hex(0x262a33));
}

TEST_CASE("the counts of the test case that is told are kept until the next check", "[counts]") {
    const checkpoint::TemporaryFolder folder;
    Course course;
    course.root = folder.path();
    TestCase passed = failing("passed", "1;7;7"), star = failing("star", "1;7;7");
    passed.passed = true;
    star.hard = true;
    const std::vector<TestCase> tests{passed, star, failing("first", "1;3;4"),
                                      failing("told", "2;1 0;1 1")};
    const std::string words = keep_counts(course, tests, "told");
    CHECK(words.find("\"told\"") != std::string::npos);
    CHECK(words.find("out/counts_expected.png") != std::string::npos);
    const auto told = kept_counts(course);
    REQUIRE(told.size() == 2);
    CHECK(told.at("counts_yours") == rt::encode_png(picture_of({2, {1, 0}, {1, 1}}, {1, 0})));
    CHECK(told.at("counts_expected") != told.at("counts_yours"));

    CHECK(keep_counts(course, tests, "") != "");
    CHECK(kept_counts(course).at("counts_yours") == rt::encode_png(picture_of({1, {3}, {4}}, {3})));

    // A test case without counts may be the one that is told.
    CHECK(keep_counts(course, {failing("other", ""), failing("first", "1;3;4")}, "other")
              .find("\"first\"") != std::string::npos);
    CHECK(keep_counts(course, {passed, star, failing("no counts", "")}, "") == "");
    CHECK(kept_counts(course).empty());
}
