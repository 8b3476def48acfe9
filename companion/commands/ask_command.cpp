#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <app/platform.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/questions.hpp>
#include <companion/model/state.hpp>
#include <companion/system/files.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>
#include <iostream>

namespace companion {
namespace {

// A question to ask, and its number in its chapter.
struct Open {
    Chapter chapter;
    Question question;
    std::size_t number = 0, of = 0;
    bool is_review = false;  // its chapter is an earlier one than the chapter asked about
};

std::vector<Open> all_questions(const Course& course, const std::vector<Chapter>& chapters) {
    std::vector<Open> all;
    for (const Chapter& chapter : chapters) {
        const std::vector<Question> here = questions(course, chapter);
        for (std::size_t i = 0; i < here.size(); ++i)
            all.push_back({chapter, here[i], i + 1, here.size()});
    }
    return all;
}

// The questions that are not answered yet.
std::vector<Open> open_questions(const Course& course, const std::vector<Chapter>& chapters) {
    std::vector<Open> open = all_questions(course, chapters);
    std::erase_if(open, [state = read_state(course)](const Open& one) {
        const auto known = state.answers.find(one.question.key());
        return known != state.answers.end() && known->second.right;
    });
    return open;
}

// The questions of earlier chapters that still have to be asked with this chapter's. They are
// chosen once: the first time that there are any.
std::vector<Open> reviews(const Course& course, const Chapter& chapter) {
    std::vector<Chapter> earlier = chapters(course);
    std::erase_if(earlier, [&](const Chapter& other) { return other.name >= chapter.name; });
    const std::vector<Open> all = all_questions(course, earlier);
    State state = read_state(course);
    if (state.reviews.count(chapter.number()) == 0) {
        std::vector<Question> candidates;
        for (const Open& one : all) candidates.push_back(one.question);
        const std::vector<std::string> keys = to_review(state, candidates);
        if (keys.empty()) return {};
        change_state(course, [&](State& now) { now.reviews[chapter.number()] = keys; });
        state.reviews[chapter.number()] = keys;
    }
    std::vector<Open> chosen;
    for (const std::string& key : state.reviews.at(chapter.number()))
        for (const Open& one : all)
            if (one.question.key() == key) {
                chosen.push_back(one);
                chosen.back().is_review = true;
            }
    return chosen;
}

// A chapter's own questions; each of the first ones is followed by a review.
std::vector<Open> mixed(std::vector<Open> own, const std::vector<Open>& reviews) {
    for (std::size_t i = 0; i < reviews.size(); ++i) {
        const auto place = static_cast<std::ptrdiff_t>(std::min(2 * i + 1, own.size()));
        own.insert(own.begin() + place, reviews[i]);
    }
    return own;
}

std::string letter(std::size_t choice) {
    return std::string(1, static_cast<char>('a' + static_cast<int>(choice))) + ") ";
}

// A copy of a question's picture under a name that does not give the answer away.
fs::path neutral_picture(const Course& course, const Open& open) {
    const fs::path copy = fs::path{"out"} / ("question-" + open.chapter.number() + ".png");
    fs::create_directories(course.root / "out");
    app::replace_file(course.root / copy, read_file(course.root / open.question.picture));
    return copy;
}

std::string right_answer(const Question& question) {
    if (!question.choices.empty())
        return letter(question.right_choice) + question.choices[question.right_choice];
    char text[32];
    std::snprintf(text, sizeof text, "%g", question.number);
    return text;
}

void print_question(const Course& course, const Open& open) {
    const Question& question = open.question;
    print('\n' +
          bold("Chapter " + open.chapter.number() + ", question " + std::to_string(open.number) +
               " of " + std::to_string(open.of)) +
          " (" + question.kind + (open.is_review ? ", review" : "") + ")\n" +
          wrapped(question.ask, "  "));
    if (!question.picture.empty())
        print("  Look at " + neutral_picture(course, open).generic_string() + '\n');
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        print("    " + letter(i) + question.choices[i] + '\n');
}

std::string what_fits(const Question& question) {
    return question.choices.empty() ? "a number, such as 0.75 or 3/4" : "one of the letters";
}

// Judges and remembers an answer, and prints the verdict: a hint after the first wrong answer, the
// reason after the second. A question that was answered wrongly is asked again another day.
Reply take(const Course& course, const Question& question, const std::string& answer, bool again) {
    const Reply reply = reply_to(question, answer);
    if (reply == Reply::not_understood) {
        print("  Answer with " + what_fits(question) + ".\n");
        return reply;
    }
    change_state(course,
                 [&](State& state) { remember(state, question, answer, reply == Reply::right); });
    if (reply == Reply::right)
        print("  " + green("Right.") + '\n' + wrapped(question.because, "  "));
    else if (!again)
        print("  " + yellow("Not yet.") + '\n' + wrapped(question.nudge, "  "));
    else
        print("  " + red("No.") + " The right answer is " + right_answer(question) + '\n' +
              wrapped(question.because, "  "));
    return reply;
}

// Judges the one answer given on the command line.
int answer_one(const Course& course, const Open& open, const std::string& answer) {
    if (reply_to(open.question, answer) == Reply::not_understood)
        throw app::UsageError("ask --answer: question " + std::to_string(open.number) +
                              " of chapter " + open.chapter.number() + " takes " +
                              what_fits(open.question) + ", not '" + answer + '\'');
    print_question(course, open);
    const bool again = was_wrong(read_state(course), open.question);
    return take(course, open.question, answer, again) == Reply::right ? app::done : app::could_not;
}

// False at the end of the input.
bool ask_until_told(const Course& course, const Open& open) {
    print_question(course, open);
    for (int wrong = 0; wrong < 2;) {
        print("> ");
        std::string line;
        if (!std::getline(std::cin, line)) return false;
        if (line.empty()) return true;  // go on to the next question
        const Reply reply = take(course, open.question, line, wrong == 1);
        if (reply == Reply::right) return true;
        wrong += reply == Reply::wrong;
    }
    return true;
}

}  // namespace

int ask(const Course& course, const Given& given) {
    std::vector<Chapter> chosen = every_chapter(course);
    if (given.named) chosen = {find_chapter(course, *given.named, true)};
    std::vector<Open> open = open_questions(course, chosen);
    if (given.named) open = mixed(std::move(open), reviews(course, chosen[0]));
    if (open.empty()) {
        print("All questions" + (given.named ? " of chapter " + chosen[0].number() : "") +
              " are answered.\n");
        return app::done;
    }
    if (given.has("--answer"))
        return answer_one(course, open.front(), given.options.at("--answer"));
    print(dim("Press Enter alone to skip a question, Ctrl-D to stop.\n"));
    for (const Open& one : open)
        if (!ask_until_told(course, one)) {
            print("\n");
            if (!app::is_terminal(stdin))
                print("To answer: ./course ask " +
                      (given.named ? chosen[0] : one.chapter).number() + " --answer ANSWER\n");
            return app::done;
        }
    return app::done;
}

}  // namespace companion
