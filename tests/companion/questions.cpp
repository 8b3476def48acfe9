#include <app/errors.hpp>
#include <cmath>
#include <companion/model/questions.hpp>
#include <companion/model/state.hpp>
#include <set>
#include <source_text.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

namespace {

const std::string predict = R"({"kind": "predict", "ask": "How much?", "answer": 0.75,
    "tolerance": 0.01, "nudge": "Think.", "because": "It is."})";
const std::string fault = R"({"kind": "find the fault", "ask": "Which?", "picture": "a.png",
    "choices": ["one", "two"], "answer": "two", "nudge": "Look.", "because": "It is."})";

std::vector<Question> read(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "chapters/01_x/questions.json", "{\"questions\": [" + text + "]}");
    return questions({folder.path(), folder / "build"}, {"01_x"});
}

}  // namespace

TEST_CASE("questions are read, and a wrong file is refused with the place", "[questions]") {
    CHECK(questions({"/nowhere", "/nowhere"}, {"01_x"}).empty());
    const auto all = read(predict + "," + fault);
    REQUIRE(all.size() == 2);
    CHECK(all[0].number == 0.75);
    CHECK(all[0].picture.empty());
    CHECK(all[1].picture == "a.png");
    CHECK(all[1].right_choice == 1);
    CHECK(all[0].key() != all[1].key());
    const auto with = [](std::string text, const std::string& was, const std::string& is) {
        text.replace(text.find(was), was.size(), is);
        try {
            read(text);
        } catch (const app::UsageError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    const std::string question = "chapters/01_x/questions.json: questions[0]",
                      place = question + '.';
    CHECK(
        with(predict, "\"predict\"", "\"guess\"") ==
        place +
            "kind is \"guess\", which is not known; known are \"predict\" and \"find the fault\"");
    CHECK(with(predict, "\"tolerance\"", "\"about\"") == question + " needs \"tolerance\"");
    CHECK(with(predict, "0.75", "\"much\"") == place + "answer must be a number, not \"much\"");
    CHECK(with(fault, "\"two\",", "\"three\",") ==
          place + "answer is \"three\", which is not known; known are \"one\" and \"two\"");
    CHECK(with(fault, "\"nudge\"", "\"hint\"") == question + " needs \"nudge\"");
}

TEST_CASE("an answer is a number or a choice, however a person writes it", "[questions]") {
    const auto all = read(predict + "," + fault);
    for (const char* const right : {"0.75", ".75", " 3/4 ", "0.745 of it", "+75e-2"})
        CHECK(reply_to(all[0], right) == Reply::right);
    for (const char* const wrong : {"0.7", "-0.75", "75 %", "3/5", "1e9"})
        CHECK(reply_to(all[0], wrong) == Reply::wrong);
    for (const char* const nothing : {"", "x", "3/", "nan", "1/0", "inf"})
        CHECK(reply_to(all[0], nothing) == Reply::not_understood);
    for (const char* const right : {"b", "B", "two", " Two "})
        CHECK(reply_to(all[1], right) == Reply::right);
    for (const char* const wrong : {"a", "one"}) CHECK(reply_to(all[1], wrong) == Reply::wrong);
    for (const char* const nothing : {"", "c", "2", "three"})
        CHECK(reply_to(all[1], nothing) == Reply::not_understood);
}

TEST_CASE("what was wrong is asked again first and then what is longest ago", "[questions]") {
    std::vector<Question> all(5);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].ask = std::to_string(i);
    State state;
    CHECK(to_review(state, all).empty());
    remember(state, all[0], "1", true);
    CHECK(to_review(state, all) == std::vector{all[0].key()});
    for (const std::size_t i : {1, 2, 3}) remember(state, all[i], "1", true);
    CHECK(to_review(state, all) == std::vector{all[0].key(), all[1].key()});
    remember(state, all[0], "1", true);  // now it is the latest
    CHECK(to_review(state, all) == std::vector{all[1].key(), all[2].key()});
    CHECK_FALSE(was_wrong(state, all[3]));
    remember(state, all[3], "2", false);
    CHECK(was_wrong(state, all[3]));
    CHECK(to_review(state, all) == std::vector{all[3].key(), all[1].key()});
    remember(state, all[3], "1", true);  // not at once
    CHECK(to_review(state, all) == std::vector{all[3].key(), all[1].key()});
    remember(state, all[3], "1", true);
    CHECK(to_review(state, all) == std::vector{all[1].key(), all[2].key()});
}

TEST_CASE("a review is done when it is answered right", "[questions]") {
    std::vector<Question> all(2);
    all[1].ask = "other";
    State state;
    state.reviews["02"] = {all[0].key(), all[1].key()};
    remember(state, all[0], "1", false);
    CHECK(state.reviews["02"].size() == 2);
    remember(state, all[0], "2", true);
    CHECK(state.reviews["02"] == std::vector{all[1].key()});
}

TEST_CASE("answers are remembered beside the exercises", "[questions]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder / "build"};
    change_state(course, [](State& state) {
        state.exercises["01.1"].hints = 2;
        state.answers["abc"] = {true, 2, "3/4"};
    });
    const State state = read_state(course);
    CHECK(state.exercises.at("01.1").hints == 2);
    CHECK(state.answers.at("abc").right);
    CHECK(state.answers.at("abc").tries == 2);
    CHECK(state.answers.at("abc").answer == "3/4");
}

TEST_CASE("each chapter asks its questions, and its text says so at its end", "[questions]") {
    const Course here = this_course();
    std::set<std::string> keys;
    for (const Chapter& chapter : chapters(here)) {
        INFO(chapter.name);
        const std::vector<Question> all = questions(here, chapter);
        if (chapter.number() <= "08") CHECK(all.size() >= 2);
        for (const Question& question : all) {
            INFO(question.ask);
            CHECK(keys.insert(question.key()).second);
            CHECK(question.choices.size() != 1);
            CHECK(question.choices.size() <= 6);
            CHECK(question.tolerance >= 0);
            CHECK((question.choices.empty() ? std::abs(question.number) > question.tolerance
                                            : question.tolerance == 0));
            CHECK((question.picture.empty() || fs::exists(here.root / question.picture)));
            CHECK((question.kind != "find the fault" || !question.picture.empty()));
        }
        if (all.empty()) continue;
        const std::string text = source_text::read(here.root / chapter.text);
        const std::string command = "`./course ask " + chapter.number() + '`';
        const auto at = text.rfind(command);
        REQUIRE(at != std::string::npos);
        CHECK(at > text.rfind("\n## "));
    }
}
