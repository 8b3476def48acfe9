#pragma once
// The questions of a chapter, chapters/NN_topic/questions.json, and what an answer is worth.
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

    std::string key() const;  // under which its answer is remembered: changes with the question
};

// The questions of a chapter; none if it has no file of them. Throws app::UsageError, with the
// position in the file, if that is not as above.
std::vector<Question> questions(const Course& course, const Chapter& chapter);

enum class Reply { right, wrong, not_understood };

// To what a person writes: a number such as 0.75, .75, 3/4 or 75 %, where anything after the number
// is ignored; or a choice, by its letter or its text.
Reply reply_to(const Question& question, const std::string& answer);

// Remembers an answer, right or wrong.
void remember(State& state, const Question& question, const std::string& answer, bool right);

// Whether a wrong answer to this question would be the second in a row.
bool was_wrong(const State& state, const Question& question);

// Those of these questions to ask once more, two at most: first those that were answered wrongly,
// and of these, and then of the others, those that were answered longest ago. Questions that were
// never answered are not among them.
std::vector<std::string> to_review(const State& state, const std::vector<Question>& earlier);

}  // namespace companion
