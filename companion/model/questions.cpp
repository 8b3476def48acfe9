#include <algorithm>
#include <app/value.hpp>
#include <cctype>
#include <cmath>
#include <companion/model/questions.hpp>
#include <companion/system/files.hpp>
#include <cstdlib>

namespace companion {
namespace {

using app::Value;

Question read_question(const Value& value) {
    Question question{.kind = value.at("kind").word({"predict", "find the fault"}),
                      .ask = value.at("ask").text(),
                      .nudge = value.at("nudge").text(),
                      .because = value.at("because").text()};
    if (const auto picture = value.find("picture")) question.picture = picture->text();
    const Value answer = value.at("answer");
    if (const auto choices = value.find("choices")) {
        for (const Value& choice : choices->list("choices", 2))
            question.choices.push_back(choice.text());
        const std::string& right = answer.word(question.choices);
        question.right_choice = static_cast<std::size_t>(
            std::find(question.choices.begin(), question.choices.end(), right) -
            question.choices.begin());
    } else {
        question.number = answer.number();
        question.tolerance = value.at("tolerance").number();
    }
    return question;
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

bool same_word(const std::string& a, const std::string& b) {
    const auto same = [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace

std::string Question::key() const {
    return hash_of(ask);
}

std::vector<Question> questions(const Course& course, const Chapter& chapter) {
    const fs::path file = fs::path{"chapters"} / chapter.name / "questions.json";
    if (!fs::exists(course.root / file)) return {};
    const Value whole = Value::parse(read_file(course.root / file), file.generic_string());
    std::vector<Question> all;
    for (const Value& value : whole.at("questions").list("questions", 1))
        all.push_back(read_question(value));
    return all;
}

Reply reply_to(const Question& question, const std::string& answer) {
    const std::string word = trimmed(answer);
    if (question.choices.empty()) {
        char* end = nullptr;
        double number = std::strtod(word.c_str(), &end);
        if (end == word.c_str()) return Reply::not_understood;
        if (*end == '/') {
            char* const below = end + 1;
            number /= std::strtod(below, &end);
            if (end == below) return Reply::not_understood;
        }
        if (!std::isfinite(number)) return Reply::not_understood;
        return std::abs(number - question.number) <= question.tolerance ? Reply::right
                                                                        : Reply::wrong;
    }
    for (std::size_t i = 0; i < question.choices.size(); ++i) {
        const std::string letter(1, static_cast<char>('a' + static_cast<int>(i)));
        if (same_word(word, letter) || same_word(word, question.choices[i]))
            return i == question.right_choice ? Reply::right : Reply::wrong;
    }
    return Reply::not_understood;
}

void remember(State& state, const Question& question, const std::string& answer, bool right) {
    int last = 0;
    for (const auto& [key, known] : state.answers) last = std::max(last, known.turn);
    Answered& answered = state.answers[question.key()];
    if (answered.right) answered.tries = 0;
    answered = {right, answered.tries + 1, answer, last + 1};
    if (right)
        for (auto& [chapter, keys] : state.reviews) std::erase(keys, question.key());
}

bool was_wrong(const State& state, const Question& question) {
    const auto known = state.answers.find(question.key());
    return known != state.answers.end() && !known->second.right && known->second.tries % 2 == 1;
}

std::vector<std::string> to_review(const State& state, const std::vector<Question>& earlier) {
    std::vector<std::string> keys;
    for (const Question& question : earlier)
        if (state.answers.count(question.key())) keys.push_back(question.key());
    const auto order = [&](const std::string& key) {
        const Answered& known = state.answers.at(key);
        const bool right_at_once = known.right && known.tries == 1;
        return std::pair{right_at_once, known.turn};
    };
    std::stable_sort(keys.begin(), keys.end(),
                     [&](const auto& a, const auto& b) { return order(a) < order(b); });
    keys.resize(std::min<std::size_t>(keys.size(), 2));
    return keys;
}

}  // namespace companion
