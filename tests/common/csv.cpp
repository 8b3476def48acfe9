#include <sstream>
#include <study/csv.hpp>

#include "checkpoint.hpp"

using Lines = std::vector<std::vector<std::string>>;

namespace {

Lines read(const std::string& text) {
    std::istringstream in{text};
    return study::read_csv(in);
}

}  // namespace

TEST_CASE("CSV: fields are quoted only where they must be", "[csv]") {
    CHECK(study::csv_field("plain text") == "plain text");
    CHECK(study::csv_field("a,b") == "\"a,b\"");
    CHECK(study::csv_field("say \"yes\"") == "\"say \"\"yes\"\"\"");
    CHECK(study::csv_field("two\nlines") == "\"two\nlines\"");
    CHECK(study::csv_field("") == "");
}

TEST_CASE("CSV: what is written is read again", "[csv]") {
    const std::vector<std::string> fields{"plain", "",  "a,b",  "\"",    "\"\"",
                                          "x\ny",  " ", "1e-9", "a\"b,c"};
    std::string line;
    for (const std::string& field : fields) line += study::csv_field(field) + ',';
    line.back() = '\n';
    CHECK(read("head,ing\n" + line) == Lines{{"head", "ing"}, fields});
}

TEST_CASE("CSV: line ends of any system, a missing one at the end, empty lines", "[csv]") {
    CHECK(read("a,b\r\nc,d") == Lines{{"a", "b"}, {"c", "d"}});
    CHECK(read("a\n\nb\n") == Lines{{"a"}, {"b"}});
    CHECK(read(",\n") == Lines{{"", ""}});
    CHECK(read("\"\"\n") == Lines{{""}});
    CHECK(read("") == Lines{});
}
