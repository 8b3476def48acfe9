#pragma once
// The questions of a chapter, chapters/NN_topic/questions.json, and the judging of answers.
//
//   {"questions": [
//     {"kind": "predict",            or "find the fault"
//      "ask": "...",
//      "picture": "docs/images/...", optional
//      "choices": ["...", "..."],    optional: then the answer is one of them
//      "answer": 0.75,               a number, or the right choice
//      "tolerance": 0.01,            of a number: how far off still counts as right
//      "nudge": "...",               after a wrong answer, without giving it away
//      "because": "..."}]}           after a right one, or the second wrong one

#include <companion/model/course.hpp>
#include <companion/model/state.hpp>
#include <string>
#include <vector>

namespace companion {

struct Question {
    std::string kind, ask, nudge, because;
    fs::path picture{};                  // within the course; empty: none
    std::vector<std::string> choices{};  // empty: the answer is a number
    double number = 0, tolerance = 0;
    std::size_t right_choice = 0;

    std::string key() const;  // under which its answer is stored; changes if the question changes
};

// The questions of a chapter; none if it has no such file. Throws app::UsageError, with the
// position in the file, if the file is not in the format above.
std::vector<Question> questions(const Course& course, const Chapter& chapter);

enum class Reply { right, wrong, not_understood };

// The reply to what a person writes: a number such as 0.75, .75, 3/4 or 75 %, where everything
// after the number is ignored; or a choice, named by its letter or its text.
Reply reply_to(const Question& question, const std::string& answer);

// Remembers an answer, right or wrong.
void remember(State& state, const Question& question, const std::string& answer, bool right);

// Whether the last answer to this question was wrong, so that another wrong one would be the second
// in a row.
bool was_wrong(const State& state, const Question& question);

// Those of these questions to ask once more, two at most. Questions that were answered wrongly come
// before the others; among each kind, those that were answered longest ago come first. Questions
// that were never answered are left out.
std::vector<std::string> to_review(const State& state, const std::vector<Question>& earlier);

}  // namespace companion
